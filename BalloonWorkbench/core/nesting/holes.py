# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small pieces in the holes of large ones. It comes before all other laying out, which knows no holes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from BalloonWorkbench.core.geometry.areas import parts
from BalloonWorkbench.core.geometry.vectors import rotation
from BalloonWorkbench.core.nesting.layout import Piece, Place, Stock, Unit, outline_of
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.pattern.pattern import Role
from BalloonWorkbench.core.pattern.placement import turned
from BalloonWorkbench.core.types import Floats


@dataclass(frozen=True)
class Guest:
    """A piece in a hole, in the frame of its host: turned by an angle [rad], then moved by (2,) m."""

    unit: Unit
    angle: float
    shift: Floats


#: What each host of a kind takes into its holes, one host after another.
Guests = dict[Unit, list[list[Guest]]]


def into_holes(pieces: Sequence[Piece], stock: Stock, units: Sequence[Unit]) -> tuple[list[Unit], Guests]:
    """The units that are left to lay out, and the others in the holes of those.

    Large pieces come first. A guest takes no guests, and its grain lies right whichever way its host does.
    """
    areas = {unit: float(outline_of(pieces[unit[0]].panel(unit[1])).area) for unit in set(units)}
    left = sorted(range(len(units)), key=lambda k: (-areas[units[k]], units[k], k))
    hosts: list[int] = []
    guests: Guests = {}
    while left:
        host = left.pop(0)
        hosts.append(host)
        placed: list[Guest] = []
        for hole in pieces[units[host][0]].panel(units[host][1]).of(Role.CUT_INNER):
            room = _largest(shapely().Polygon(hole.points).buffer(-stock.spacing))
            while room is not None:
                guest = _fitting(pieces, stock, units[host], room, [units[k] for k in left], areas)
                if guest is None:
                    break
                placed.append(guest)
                left.remove(next(k for k in left if units[k] == guest.unit))
                room = _largest(room.difference(_laid(pieces, guest).buffer(stock.spacing)))
        guests.setdefault(units[host], []).append(placed)
    return [units[k] for k in sorted(hosts)], guests


def with_guests(places: Sequence[Place], guests: Guests) -> list[Place]:
    """The places of hosts and of what lies in their holes; hosts that are placed leave the guests' list."""
    placed = []
    for place in places:
        placed.append(place)
        for guest in guests[(place.piece, place.mirrored)].pop(0):
            shift = guest.shift @ rotation(place.angle) + place.shift
            placed.append(Place(*guest.unit, place.angle + guest.angle, shift))
    return placed


def _fitting(
    pieces: Sequence[Piece], stock: Stock, host: Unit, room: Any, units: list[Unit], areas: dict[Unit, float]
) -> Guest | None:
    """The first of some units that fits into a room of a host."""
    first = pieces[host[0]].angles(host[1], stock.grain)[0]
    middles = [_middle(room), np.asarray(room.centroid.coords[0])]
    turnable = len(pieces[host[0]].angles(host[1], stock.grain))
    for unit in dict.fromkeys(units):
        # a guest turns with its host, so it must bear all that the host may do
        if areas[unit] > room.area or len(pieces[unit[0]].angles(unit[1], stock.grain)) < turnable:
            continue
        for degrees in pieces[unit[0]].angles(unit[1], stock.grain):
            angle = float(np.radians(degrees - first))
            area = _laid(pieces, Guest(unit, angle, np.zeros(2)))
            for middle in middles:
                for own in (_middle(area), np.asarray(area.centroid.coords[0])):
                    guest = Guest(unit, angle, middle - own)
                    if room.contains(_laid(pieces, guest)):
                        return guest
    return None


def _laid(pieces: Sequence[Piece], guest: Guest) -> Any:
    """What a guest takes of the film of its host."""
    number, mirrored = guest.unit
    return outline_of(turned(pieces[number].panel(mirrored), guest.angle, guest.shift))


def _middle(area: Any) -> Floats:
    """The middle of the largest disc in an area."""
    return np.asarray(shapely().maximum_inscribed_circle(area).coords[0])


def _largest(area: Any) -> Any:
    """The largest polygon of an area, None where it has none."""
    polygons = parts(area)
    return polygons[0] if polygons else None

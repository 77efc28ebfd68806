# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a hot tool comes to a weld: it lands on waste film beside the pattern, where it does no harm."""

from __future__ import annotations

from typing import Any

import numpy as np

from BalloonWorkbench.core.arcs.curves import Curve
from BalloonWorkbench.core.geometry.vectors import direction
from BalloonWorkbench.core.machines.contour.start_point import CLEAR, NEAR, turning
from BalloonWorkbench.core.machines.tool import WELDS
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.pattern.pattern import Pattern, Role
from BalloonWorkbench.core.pattern.shapes import polygon
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import to_mm

#: How far past the cut the tool lands, and how near to its own weld it may pass another line [mm].
_PAST = 2.0
_NEAR = 0.05
#: From behind on either side of the weld [rad], and how many places of a closed weld are tried.
_SIDES = (-0.25 * np.pi, 0.25 * np.pi)
_AHEAD = (0.0,)
_PLACES = 32
#: Where it turns by more within a start's clear way there is a corner [rad].
_BENT = 0.5


class Waste:
    """The film between the pieces of a pattern, in millimetres, and the lines that no way there may cross."""

    def __init__(self, pattern: Pattern, longest: float, box: tuple[Floats, Floats]) -> None:
        """longest way to a weld, and the corners (2,) of where a tool may land [mm]."""
        package = shapely()
        cuts, holes = (_areas(pattern, role) for role in (Role.CUT, Role.CUT_INNER))
        self._film = package.union_all(cuts).difference(package.union_all(holes))
        kept = [each.line for each in pattern.contours if each.role in (*WELDS, Role.NOTCH)]
        self._lines = package.union_all([package.LineString(to_mm(line)) for line in kept if len(line) > 1])
        self._box = package.box(*box[0], *box[1])
        self._longest = longest

    def begun(self, curve: Curve) -> tuple[Curve, Floats | None]:
        """A closed weld [mm], begun as near to its start as there is a way from waste film, and where that
        way begins (2,); as it is, and None, where there is none. Corners are no such places."""
        places = np.arange(_PLACES) * curve.length / _PLACES
        (bent,) = turning(curve, np.empty((0, 2)), places, (CLEAR,))
        for place in places[bent < _BENT].tolist():
            begun, joint = curve.jointed(place, NEAR)
            begun = begun.begun_at(joint)
            way = self._way(begun, _SIDES)
            if way is not None:
                return begun, way
        return curve, None

    def ways(self, curve: Curve) -> tuple[Floats | None, Floats | None]:
        """Where ways from waste film straight on to both ends of an open weld [mm] begin, None without."""
        if not len(curve):
            return None, None
        return self._way(curve, _AHEAD), self._way(curve.reversed(), _AHEAD)

    def _way(self, curve: Curve, sides: tuple[float, ...]) -> Floats | None:
        """Where the shortest way to the curve's first joint begins, of those from behind on some sides."""
        start, back = curve.joints[0], float(curve.headings[0][0]) + np.pi
        landings = [self._landing(start, back + side) for side in sides]
        places = [place for place in landings if place is not None]
        return min(places, key=lambda place: float(np.hypot(*(place - start))), default=None)

    def _landing(self, start: Floats, angle: float) -> Floats | None:
        """The nearest place on waste film in a direction, from which nothing is in the way."""
        package, ahead = shapely(), direction(angle)
        ray = package.LineString([start, start + self._longest * ahead])
        inside = package.get_parts(self._film.intersection(ray))
        here = package.Point(start)
        reach = max(
            (here.hausdorff_distance(part) for part in inside if part.distance(here) < _NEAR), default=0.0
        )
        place = start + (reach + _PAST) * ahead
        way, past = (package.LineString([start + at * ahead, place]) for at in (_NEAR, reach + _NEAR))
        crosses = way.intersects(self._lines) or past.intersects(self._film)
        return None if crosses or reach + _PAST > self._longest or not self._box.contains(way) else place


def _areas(pattern: Pattern, role: Role) -> list[Any]:
    """What closed lines of a role go round [mm]."""
    return [polygon(to_mm(each.points)) for each in pattern.of(role) if each.closed]

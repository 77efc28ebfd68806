# SPDX-License-Identifier: LGPL-2.1-or-later
"""A film valve in its neck: where its strips lie, and whether a weld of the balloon closes their channel."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from BalloonWorkbench.core.geometry.vectors import direction, perpendicular
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.pattern.intake.kinds import RIM, intake_kind, placed
from BalloonWorkbench.core.pattern.pattern import Contour, Intake, Role
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import from_mm, length_text, place_text

#: Between two places at which the room beside the channel is measured [m].
_STEP = from_mm(0.5)
#: What a channel may lack of its room before it is told [m].
_SLACK = from_mm(0.05)


def strips(intake: Intake, seal_width: float) -> tuple[tuple[Contour, ...], ...]:
    """The lines of each piece in the intake's neck, from its mouth inward; none for other intakes."""
    kind = intake_kind(intake.kind)
    if kind.place != RIM:
        return ()
    sizes = {"L": intake.length, "W": intake.width, "S": seal_width}
    from_mouth = np.array([intake.length, 0.0])

    def laid(line: Contour) -> Contour:
        return placed(replace(line, points=from_mouth - line.points), intake.at, intake.angle)

    return tuple(tuple(laid(stroke.drawn(sizes)) for stroke in piece.strokes) for piece in kind.pieces)


def closed_channel(intake: Intake, free: Any, seal_width: float) -> str | None:
    """A sentence on the narrowest place where the balloon's welds reach the channel's own, or None.

    free  the film between the balloon's welds, neck included, as an area of shapely
    """
    pieces = strips(intake, seal_width)
    welds = (
        [line.points for line in pieces[0] if line.role is Role.SEAL and not line.closed] if pieces else []
    )
    if len(welds) < 2:
        return None
    axis = direction(intake.angle)
    side = perpendicular(axis)
    ends = np.concatenate(welds)
    along, aside = (ends - intake.at) @ axis, (ends - intake.at) @ side
    places = np.arange(float(along.max()), float(along.min()), -_STEP)
    order = np.argsort(along)
    need = 2.0 * np.interp(places, along[order], np.abs(aside)[order]) + seal_width
    room = np.array([_room(free, intake.at + place * axis, side, 4.0 * intake.width) for place in places])
    worst = int(np.argmin(room - need))
    if room[worst] > need[worst] - _SLACK:
        return None
    at = place_text(intake.at + places[worst] * axis)
    if room[worst] == 0.0:
        return (
            f"The valve reaches {length_text(-float(along.min()))} into the balloon, past the weld at {at}:"
            " put"
            " the intake where the balloon is longer, or take another one."
        )
    return (
        f"On the way of the valve the balloon narrows to {length_text(float(room[worst]))} at {at}; its"
        " channel"
        f" takes {length_text(float(need[worst]))} with its welds there. Make the neck wider or put it"
        " elsewhere,"
        " else the weld closes the valve."
    )


def _room(free: Any, at: Floats, side: Floats, reach: float) -> float:
    """Twice the way from a point to the nearer end of the film on a line across [m]; 0 outside the film."""
    package = shapely()
    reaches = [package.LineString([at, at + way * reach * side]).intersection(free) for way in (1.0, -1.0)]
    lengths = []
    for line in reaches:
        near = [part for part in package.get_parts(line) if part.distance(package.Point(at)) < 1e-9]
        lengths.append(max((part.length for part in near), default=0.0))
    return 2.0 * min(lengths)

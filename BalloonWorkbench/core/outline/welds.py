# SPDX-License-Identifier: LGPL-2.1-or-later
"""Welds that a user draws inside an outline: lines along which both films stay together."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from BalloonWorkbench.core.errors import OutlineError
from BalloonWorkbench.core.geometry.crossings import contains, first_crossing
from BalloonWorkbench.core.geometry.nearest import nearest_on_loops
from BalloonWorkbench.core.geometry.polyline import extent, length, part_of
from BalloonWorkbench.core.geometry.vectors import direction
from BalloonWorkbench.core.outline.budget import Budget
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import from_mm, place_text

#: Lines on a layer, or in a group, of this name are welds; upper or lower case.
LAYER = "weld"
#: Diameter of a spot weld that is drawn as a point [m].
SPOT = from_mm(5.0)
#: A weld that ends this near to the outline, relative to its size, begins there.
_AT_RIM = 2e-3


def spot(centre: Floats, diameter: float = SPOT) -> Floats:
    """A round closed weld (n, 2), clockwise."""
    return np.asarray(centre + 0.5 * diameter * direction(-np.arange(24) * np.pi / 12.0))


def valid_welds(
    lines: Sequence[Floats], loops: Sequence[Floats], tolerance: float, budget: Budget
) -> tuple[Floats, ...]:
    """Open welds (n, 2) without repeated points, an end on a loop drawn back from it by a hair.

    loops: the outer loop, then the holes. OutlineError where a weld has no length, leaves the film, or meets
    itself or another one; the text gives the place in millimetres.
    """
    hair = _AT_RIM * extent(loops[0])
    welds = []
    for drawn in lines:
        budget.check_time()
        points = np.asarray(drawn, dtype=np.float64).reshape(-1, 2)
        distinct = np.append(True, np.linalg.norm(np.diff(points, axis=0), axis=1) > tolerance)
        line = _drawn_back(_drawn_back(points[distinct], loops, hair)[::-1], loops, hair)[::-1]
        if len(line) < 2:
            raise OutlineError("A weld has no length; draw a line, or a circle for a spot.")
        for number, loop in enumerate(loops):
            astray = contains(loop, line) == bool(number)
            if astray.any():
                raise OutlineError(
                    f"A weld leaves the film at {place_text(line[np.argmax(astray)])}; keep it inside."
                )
        welds.append(np.ascontiguousarray(line))
    place = first_crossing(loops, welds, budget.check_time) if welds else None
    if place is not None:
        raise OutlineError(
            f"A weld meets the outline, itself or another weld at {place_text(place)};"
            " keep some film between them."
        )
    return tuple(welds)


def _drawn_back(line: Floats, loops: Sequence[Floats], hair: float) -> Floats:
    """The line without what lies within a hair of a loop at its first end."""
    if len(line) < 2 or nearest_on_loops(loops, line[:1]).distance[0] > hair:
        return line
    whole = length(line)
    return part_of(line, min(2.0 * hair, 0.5 * whole), whole)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Several patterns on one sheet: where the drawing has them if there is room, else in rows."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.pattern.pattern import Pattern, Role
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import from_mm

#: Least distance between the cuts of two patterns [m].
SPACING = from_mm(5.0)
#: Width of the rows, relative to the square root of the area that all patterns take.
_ROW = 1.4


def beside(patterns: Sequence[Pattern]) -> list[Floats]:
    """A shift (2,) for each pattern [m], so that no two come nearer to each other than SPACING.

    All 0 where the patterns have that room as they are, also inside each other's holes.
    """
    films = [_film(pattern) for pattern in patterns]
    tree = shapely().STRtree(films)
    near = tree.query(films, predicate="dwithin", distance=SPACING)
    if (near[0] == near[1]).all():
        return [np.zeros(2) for _ in patterns]
    return in_rows([pattern.bounds for pattern in patterns])


def on_one_sheet(patterns: Sequence[Pattern]) -> Pattern:
    """All patterns as one, beside each other; without an intake of its own unless there is only one."""
    if len(patterns) == 1:
        return patterns[0]
    moved = [pattern.moved(shift) for pattern, shift in zip(patterns, beside(patterns), strict=True)]
    return replace(
        moved[0],
        contours=tuple(contour for pattern in moved for contour in pattern.contours),
        intake=None,
        more_intakes=(),
        seam_length=sum(pattern.seam_length for pattern in moved),
        warnings=tuple(warning for pattern in moved for warning in pattern.warnings),
    )


def _film(pattern: Pattern) -> Any:
    """What is cut out of the film, as an area of shapely."""
    package = shapely()
    outer = package.union_all([package.Polygon(contour.points) for contour in pattern.of(Role.CUT)])
    inner = [package.Polygon(contour.points) for contour in pattern.of(Role.CUT_INNER)]
    return outer.difference(package.union_all(inner)) if inner else outer


def in_rows(boxes: Sequence[tuple[Floats, Floats]]) -> list[Floats]:
    """Shifts that lay boxes from left to right in rows, each row above the one before."""
    sizes = np.array([high - low for low, high in boxes]) + SPACING
    width = max(float(sizes[:, 0].max()), _ROW * float(np.sqrt(sizes.prod(axis=1).sum())))
    x, y, height = 0.0, 0.0, 0.0
    shifts = []
    for (low, _), size in zip(boxes, sizes, strict=True):
        if x > 0.0 and x + size[0] > width * (1.0 + 1e-9):
            x, y, height = 0.0, y + height, 0.0
        shifts.append(np.array([x, y]) - low)
        x, height = x + float(size[0]), max(height, float(size[1]))
    return shifts

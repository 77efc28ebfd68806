# SPDX-License-Identifier: LGPL-2.1-or-later
"""Laying out pieces row by row, by the boxes around them: for where there is no nesting library."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from BalloonWorkbench.core.nesting.layout import Piece, Place, Stock
from BalloonWorkbench.core.pattern.motion import turned
from BalloonWorkbench.core.types import Floats


def in_rows(pieces: Sequence[Piece], stock: Stock, units: Sequence[tuple[int, bool]]) -> list[list[Place]]:
    """Places on one roll or on several sheets: rows across the film, the longest pieces first.

    Pieces lie so that they are least long, or least high: whichever takes less film.
    """
    ways = [_laid(pieces, stock, units, axis) for axis in (0, 1)]
    return min(ways, key=lambda way: (len(way[0]), way[1]))[0]


def _laid(
    pieces: Sequence[Piece], stock: Stock, units: Sequence[tuple[int, bool]], axis: int
) -> tuple[list[list[Place]], float]:
    """The places, and the length of the last sheet [m]."""
    boxes = {unit: _box(pieces, stock, unit, axis) for unit in set(units)}
    order = sorted(units, key=lambda unit: (-boxes[unit][1][0], unit))
    sheets: list[list[Place]] = [[]]
    x, y, depth = stock.spacing, stock.spacing, 0.0
    for unit in order:
        angle, size, low = boxes[unit]
        if y > stock.spacing and y + size[1] > stock.width - stock.spacing + 1e-12:
            x, y, depth = x + depth + stock.spacing, stock.spacing, 0.0
        if stock.length is not None and x + size[0] > stock.length - stock.spacing + 1e-12:
            sheets.append([])
            x, y, depth = stock.spacing, stock.spacing, 0.0
        sheets[-1].append(Place(*unit, angle, np.array([x, y]) - low))
        y, depth = y + float(size[1]) + stock.spacing, max(depth, float(size[0]))
    return sheets, x + depth


def _box(
    pieces: Sequence[Piece], stock: Stock, unit: tuple[int, bool], axis: int
) -> tuple[float, Floats, Floats]:
    """Angle [rad], size (2,) and lower left corner (2,) [m] of a piece that is least along an axis."""
    number, mirrored = unit
    panel = pieces[number].panel(mirrored)
    found = []
    for degrees in pieces[number].angles(mirrored, stock.grain):
        angle = float(np.radians(degrees))
        low, high = turned(panel, angle, np.zeros(2)).bounds
        fits = high[1] - low[1] <= stock.room + 1e-12
        if stock.length is not None:
            fits &= high[0] - low[0] <= stock.length - 2.0 * stock.spacing + 1e-12
        if fits:
            found.append((round(float((high - low)[axis]), 9), abs(degrees), angle, high - low, low))
    _, _, angle, size, low = min(found, key=lambda each: each[:3])
    return angle, size, low

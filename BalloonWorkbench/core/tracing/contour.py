# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sub-pixel boundary loops of a coverage image: marching squares at one half."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.geometry.polyline import signed_area
from BalloonWorkbench.core.tracing.raster import Pixels
from BalloonWorkbench.core.types import Floats

# Edges of a cell between four pixel centres.
_TOP, _RIGHT, _BOTTOM, _LEFT = range(4)
# For each set of corners inside (upper left 1, upper right 2, lower right 4, lower left 8): the edges where
# the boundary enters and leaves the cell with the inside on its left, seen with y up. 5 and 10 are decided in
# the middle.
_STEPS = {
    1: ((_LEFT, _TOP),),
    2: ((_TOP, _RIGHT),),
    3: ((_LEFT, _RIGHT),),
    4: ((_RIGHT, _BOTTOM),),
    6: ((_TOP, _BOTTOM),),
    7: ((_LEFT, _BOTTOM),),
    8: ((_BOTTOM, _LEFT),),
    9: ((_BOTTOM, _TOP),),
    11: ((_BOTTOM, _RIGHT),),
    12: ((_RIGHT, _LEFT),),
    13: ((_RIGHT, _TOP),),
    14: ((_TOP, _LEFT),),
}
_JOINED = {5: ((_RIGHT, _TOP), (_LEFT, _BOTTOM)), 10: ((_TOP, _LEFT), (_BOTTOM, _RIGHT))}
_PARTED = {5: ((_LEFT, _TOP), (_RIGHT, _BOTTOM)), 10: ((_TOP, _RIGHT), (_BOTTOM, _LEFT))}


def contours(coverage: Pixels) -> list[tuple[Floats, float]]:
    """Loops (n, 2) in pixels, x right and y up from the picture's lower left corner, and their areas [px2].

    Outer boundaries run counter-clockwise (positive area), holes clockwise; none crosses itself or another.
    Each starts at its first point in a scan from the upper left. Beyond its border the picture is empty.
    """
    field = np.pad(coverage, 1).astype(np.float64)
    width = field.shape[1]
    inside = (field > 0.5).view(np.uint8)
    code = inside[:-1, :-1] + 2 * inside[:-1, 1:] + 4 * inside[1:, 1:] + 8 * inside[1:, :-1]
    rows, columns = np.divmod(np.flatnonzero((code > 0) & (code < 15)), width - 1)  # of the cells it crosses
    corner, codes = rows * width + columns, code[rows, columns]
    flat = field.ravel()
    middle = 0.25 * (flat[corner] + flat[corner + 1] + flat[corner + width + 1] + flat[corner + width]) > 0.5
    # Crossings are named by the pixel left of or above them, those on vertical edges offset by the picture's
    # size.
    shift = {_TOP: 0, _BOTTOM: width, _LEFT: field.size, _RIGHT: field.size + 1}
    leave, enter = [], []
    for table, where in ((_STEPS, np.ones_like(middle)), (_JOINED, middle), (_PARTED, ~middle)):
        for corners, steps in table.items():
            cells = corner[(codes == corners) & where]
            for start, stop in steps:
                leave.append(cells + shift[start])
                enter.append(cells + shift[stop])
    names = np.concatenate(leave)
    order = np.argsort(names)
    following = order[np.searchsorted(names, np.concatenate(enter), sorter=order)]
    points = _crossings(field, names)
    loops = [points[loop] for loop in _cycles(following)]
    return [(_from_upper_left(loop), signed_area(loop)) for loop in loops]


def _crossings(field: NDArray[np.float64], names: NDArray[np.intp]) -> Floats:
    """Where the field is one half on the named edges, in pixels of the picture, y up."""
    height, width = field.shape
    vertical = names >= field.size
    y, x = np.divmod(np.where(vertical, names - field.size, names), width)
    here, there = field[y, x], field[y + vertical, x + ~vertical]
    part = (0.5 - here) / (there - here)
    # The field is padded by one pixel, and a pixel's centre is half a pixel from its corner.
    return np.column_stack([x + part * ~vertical - 0.5, height - 1.5 - (y + part * vertical)])


def _cycles(following: NDArray[np.intp]) -> list[list[int]]:
    """The cycles of a permutation."""
    successor = following.tolist()
    seen = bytearray(len(successor))
    cycles = []
    for first in range(len(successor)):
        cycle = []
        k = first
        while not seen[k]:
            seen[k] = 1
            cycle.append(k)
            k = successor[k]
        if cycle:
            cycles.append(cycle)
    return cycles


def _from_upper_left(loop: Floats) -> Floats:
    """The loop beginning above the first pixel inside it in a scan by rows, from the upper left."""
    top_row = np.floor(loop[:, 1].max() - 0.5) + 0.5
    above = np.flatnonzero(loop[:, 1] > top_row)
    if len(above) == 0:
        above = np.flatnonzero(loop[:, 1] == top_row)
    return np.roll(loop, -above[np.argmin(loop[above, 0])], axis=0)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Loose lines joined end to end into closed loops, and the drawing that they make."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Sequence
from dataclasses import replace
from itertools import product

import numpy as np

from BalloonWorkbench.core.errors import OutlineError
from BalloonWorkbench.core.geometry.cleaning import clean
from BalloonWorkbench.core.geometry.crossings import contains
from BalloonWorkbench.core.geometry.polyline import length, ring, signed_area
from BalloonWorkbench.core.outline.budget import Budget
from BalloonWorkbench.core.outline.drawing import Drawing, arranged, with_welds
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import from_mm, length_text, place_text

#: Ends this close to each other are one point, as exactly as curves are flattened.
SAME_END = from_mm(0.02)
#: Ends this close were meant to meet; closing them is worth a remark.
NEAR_END = from_mm(0.5)
#: Loops are compared with those in the same cell of this size, of their boxes and areas [m].
_CELL = 64.0 * SAME_END


def drawing_from(
    pieces: Sequence[Floats],
    notes: Sequence[str] = (),
    filled: Sequence[Floats] = (),
    welds: Sequence[Floats] = (),
    open_are_welds: bool = False,
    budget: Budget | None = None,
) -> Drawing:
    """The shapes in the lines of a drawing, with the loops inside them as their holes.

    pieces  polylines (n, 2) m, joined where their ends meet
    filled  those of the pieces that enclose an area even where they stay open, by a straight line
    welds   lines along which the films are sealed together, and single points, see `with_welds`
    open_are_welds  so are lines inside a shape that stay open; else they are left out
    budget  of reading the drawing; one of its own without it
    OutlineError where the lines close around nothing. The result is not checked for crossings.
    """
    remarks = list(notes)
    budget = budget or Budget()
    loops, rest = join(pieces, SAME_END, budget)
    more, rest = join(rest, NEAR_END, budget)
    if more:
        remarks.append(f"Gaps of up to {length_text(NEAR_END)} between lines were closed.")
    areas = {piece.tobytes() for piece in filled}
    closable = [line.tobytes() in areas for line in rest]
    loops += more + [line for line, close in zip(rest, closable) if close]
    open_ones = [line for line, close in zip(rest, closable) if not close]
    # A line out and back is neither a loop nor open.
    rest = [line for line in open_ones if np.linalg.norm(line[-1] - line[0]) > SAME_END]
    loops = [loop for loop in loops if len(clean(loop, SAME_END)) > 2]
    if not loops:
        if rest:
            first, last = max(rest, key=_length)[[0, -1]]
            gap = float(np.linalg.norm(last - first))
            raise OutlineError(
                f"The drawing is open: a line starts at {place_text(first)} and ends {length_text(gap)} "
                f"away at {place_text(last)}. Close it."
            )
        raise OutlineError("The drawing has no closed line. Draw one, and turn texts and groups into paths.")
    drawing = arranged(_without_twins(loops, budget), remarks, budget)
    if open_are_welds:
        inside = [_lies_in(drawing, line, budget) for line in rest]
        welds = [*welds, *(line for line, inner in zip(rest, inside) if inner)]
        rest = [line for line, inner in zip(rest, inside) if not inner]
    if rest:
        note = f"{len(rest)} open line{'s were' if len(rest) > 1 else ' was'} left out."
        first = replace(drawing.largest, notes=(*drawing.largest.notes, note))
        drawing = Drawing((first, *drawing.parts[1:]))
    points = [line for line in welds if len(line) == 1]
    closed, lines = join([line for line in welds if len(line) > 1], SAME_END, budget)
    rings = [ring(loop) for loop in closed]
    return with_welds(drawing, [*lines, *rings, *points], budget)


def _lies_in(drawing: Drawing, line: Floats, budget: Budget) -> bool:
    """Whether a line lies in a shape, at least partly."""
    budget.check_time()
    return any(contains(part.outer, line).any() for part in drawing.parts)


def join(
    pieces: Sequence[Floats], tolerance: float, budget: Budget | None = None
) -> tuple[list[Floats], list[Floats]]:
    """Closed loops (n, 2), and open lines, of polylines whose ends meet within `tolerance`."""
    budget = budget or Budget()
    ends = _Ends(pieces, tolerance)
    loops: list[Floats] = []
    rest: list[Floats] = []
    for first in range(len(pieces)):
        if not ends.take(first):
            continue
        chain = _Chain(pieces[first])
        while not (closed := chain.closed(tolerance)):
            budget.check_time()
            if (end := ends.nearest(chain.last)) is not None:
                number, at_end = end
                chain.append(pieces[number][::-1] if at_end else pieces[number])
            elif (end := ends.nearest(chain.first)) is not None:
                number, at_end = end
                chain.prepend(pieces[number] if at_end else pieces[number][::-1])
            else:
                break
        line = np.concatenate(chain.pieces)
        (loops if closed else rest).append(line[:-1] if closed else line)
    return loops, rest


class _Chain:
    """Polylines end to end."""

    def __init__(self, piece: Floats) -> None:
        self.pieces = deque([piece])
        self.first, self.last = piece[[0, -1]].tolist()
        self._points, self._length = len(piece), _length(piece)

    def append(self, piece: Floats) -> None:
        """Go on with a polyline."""
        self.pieces.append(piece)
        self.last = piece[-1].tolist()
        self._add(piece)

    def prepend(self, piece: Floats) -> None:
        """Begin with a polyline."""
        self.pieces.appendleft(piece)
        self.first = piece[0].tolist()
        self._add(piece)

    def _add(self, piece: Floats) -> None:
        self._points += len(piece)
        self._length += _length(piece)

    def closed(self, tolerance: float) -> bool:
        """Whether the chain is a loop."""
        if self._points < 4:
            return False
        gap = math.dist(self.last, self.first)
        # A short line is not a loop merely because its ends are near each other.
        return gap <= tolerance and self._length > 4 * gap


class _Ends:
    """Ends of polylines, found by place."""

    def __init__(self, pieces: Sequence[Floats], tolerance: float) -> None:
        self.tolerance = tolerance
        self.free = [True] * len(pieces)
        self.points = [piece[[0, -1]].tolist() for piece in pieces]
        self.cells: dict[tuple[int, int], list[tuple[int, int]]] = {}
        for number, ends in enumerate(self.points):
            for end, point in enumerate(ends):
                self.cells.setdefault(self._cell(point), []).append((number, end))

    def _cell(self, point: Sequence[float]) -> tuple[int, int]:
        return int(point[0] // self.tolerance), int(point[1] // self.tolerance)

    def take(self, number: int) -> bool:
        """Claim a polyline; False where it is taken already."""
        free = self.free[number]
        self.free[number] = False
        return free

    def nearest(self, point: Sequence[float]) -> tuple[int, int] | None:
        """Claim the free polyline that ends nearest to the point: its number, and 1 if by its last end."""
        x, y = self._cell(point)
        near = [
            (math.dist(self.points[number][end], point), number, end)
            for column in (x - 1, x, x + 1)
            for row in (y - 1, y, y + 1)
            for number, end in self.cells.get((column, row), ())
            if self.free[number]
        ]
        away, number, end = min(near, default=(math.inf, 0, 0))
        if away > self.tolerance:
            return None
        self.free[number] = False
        return number, end


def _length(line: Floats) -> float:
    if len(line) == 2:
        return math.dist(*line.tolist())
    return length(line)


def _without_twins(loops: list[Floats], budget: Budget) -> list[Floats]:
    """The loops without those drawn twice, which is common where a shape has a fill and a line."""
    distinct: list[Floats] = []
    cells: dict[tuple[int, ...], list[Floats]] = {}
    for loop in loops:
        budget.check_time()
        mark = np.array([*loop.min(axis=0), *loop.max(axis=0), np.sqrt(abs(signed_area(loop)))])
        # mostly one cell; two where a number is as near to the next cell as twins may be apart
        near = product(
            *zip(*(np.stack([mark - SAME_END, mark + SAME_END]) // _CELL).astype(np.int64).tolist())
        )
        others = [other for cell in set(near) for other in cells.get(cell, ())]
        if not any(np.abs(mark - other).max() <= SAME_END for other in others):
            distinct.append(loop)
            cells.setdefault(tuple((mark // _CELL).astype(np.int64).tolist()), []).append(mark)
    return distinct

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nodes on the loops of a drawing: its corners, and between them as many as curves need to follow it."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.geometry.nearest import nearest_on_line
from BalloonWorkbench.core.geometry.normals import corners
from BalloonWorkbench.core.geometry.polyline import extent, line_lengths, perimeter, ring
from BalloonWorkbench.core.outline.drawing import Drawing
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.types import Floats

#: What a point of a loop is besides: no node, one through which the line runs smoothly, a corner.
PLAIN, SMOOTH, CORNER = 0, 1, 2
Kinds = NDArray[np.int8]

_CORNER = np.radians(40.0)
#: Along the loop a corner shows in this part of the drawing's size, and in this part of its own length.
_REACH, _OF_LENGTH = 0.008, 1.0 / 24.0
#: A curve between two nodes follows the loop as near as this part of the drawing's size.
_NEAR = 0.006
#: Fewest nodes of a loop, and as how many parts a loop without corners begins.
FEWEST, _QUARTERS = 3, 4


@dataclass(frozen=True)
class NodeLoop:
    """A closed loop: points (n, 2) m, and of each its kind (n,): PLAIN, SMOOTH or CORNER."""

    points: Floats
    kinds: Kinds

    @property
    def nodes(self) -> NDArray[np.intp]:
        """Indices of its nodes, in order."""
        return np.flatnonzero(self.kinds)

    def rolled(self, first: int) -> NodeLoop:
        """The same, beginning at another point."""
        return NodeLoop(np.roll(self.points, -first, axis=0), np.roll(self.kinds, -first))


@dataclass(frozen=True)
class NodeDrawing:
    """A drawing with nodes.

    drawing  with its loops as they are now
    loops    those of all its parts, in the order of their `loops`
    """

    drawing: Drawing
    loops: tuple[NodeLoop, ...]

    @property
    def size(self) -> float:
        """The larger side of the box round it [m]."""
        return extent(np.concatenate([loop.points for loop in self.loops]))

    def owner(self, number: int) -> tuple[int, int]:
        """The part of a loop, and the loop's number among those of the part; 0 is the outer one."""
        for part, outline in enumerate(self.drawing.parts):
            if number < len(outline.loops):
                return part, number
            number -= len(outline.loops)
        raise IndexError(number)

    def with_loop(self, number: int, loop: NodeLoop) -> NodeDrawing:
        """It with another loop in the place of one."""
        loops = (*self.loops[:number], loop, *self.loops[number + 1 :])
        part, own = self.owner(number)
        outline = self.drawing.parts[part]
        lines = [*outline.loops[:own], loop.points, *outline.loops[own + 1 :]]
        return self._with_part(
            part, replace(outline.with_loops(lines, outline.welds), notes=outline.notes), loops
        )

    def without_loop(self, number: int) -> NodeDrawing:
        """It without a hole or a closed weld."""
        part, own = self.owner(number)
        outline, last = self.drawing.parts[part], 1 + len(self.drawing.parts[part].holes)
        holes = tuple(hole for at, hole in enumerate(outline.holes, 1) if at != own)
        spots = tuple(spot for at, spot in enumerate(outline.spots, last) if at != own)
        loops = (*self.loops[:number], *self.loops[number + 1 :])
        return self._with_part(part, replace(outline, holes=holes, spots=spots), loops)

    def _with_part(self, part: int, outline: Outline, loops: tuple[NodeLoop, ...]) -> NodeDrawing:
        parts = self.drawing.parts
        drawing = replace(self.drawing, parts=(*parts[:part], outline, *parts[part + 1 :]))
        return NodeDrawing(drawing, loops)


def with_nodes(drawing: Drawing) -> NodeDrawing:
    """A drawing as it was traced or read, with nodes on its loops; no point is moved."""
    every = [loop for part in drawing.parts for loop in part.loops]
    size = extent(np.concatenate(every))
    marked = tuple(_marked(loop, size) for loop in every)
    lines = iter(loop.points for loop in marked)
    parts = [
        replace(part.with_loops([next(lines) for _ in part.loops], part.welds), notes=part.notes)
        for part in drawing.parts
    ]
    return NodeDrawing(replace(drawing, parts=tuple(parts)), marked)


def _reach(loop: Floats, size: float) -> float:
    return min(_REACH * size, _OF_LENGTH * perimeter(loop))


def _marked(loop: Floats, size: float) -> NodeLoop:
    """A loop (n, 2) with its nodes, of a drawing of a size [m]."""
    loop = _dense(loop)
    kinds: Kinds = np.zeros(len(loop), dtype=np.int8)
    sharp = corners(loop, _CORNER, _reach(loop, size))
    lengths = line_lengths(ring(loop))
    begins = sharp if len(sharp) else _parted(lengths, 0, len(loop), _QUARTERS)
    kinds[begins] = SMOOTH
    round_twice = np.concatenate([loop, loop, loop[:1]])
    for first, last in zip(begins.tolist(), [*begins[1:].tolist(), int(begins[0]) + len(loop)]):
        kinds[np.array(_splits(round_twice, first, last, _NEAR * size), dtype=np.intp) % len(loop)] = SMOOTH
    while np.count_nonzero(kinds) < FEWEST:
        at = np.flatnonzero(kinds)
        spans = np.diff([*at.tolist(), int(at[0]) + len(loop)])
        longest = int(np.argmax(spans))
        kinds[(at[longest] + max(1, int(spans[longest]) // 2)) % len(loop)] = SMOOTH
    kinds[sharp] = CORNER
    return NodeLoop(loop, kinds)


def _dense(loop: Floats) -> Floats:
    """A loop with a point between any two where it has so few that nodes find no place."""
    while len(loop) < 4 * FEWEST:
        between = 0.5 * (loop + np.roll(loop, -1, axis=0))
        loop = np.stack([loop, between], axis=1).reshape(-1, 2)
    return loop


def _parted(lengths: Floats, first: int, last: int, count: int) -> NDArray[np.intp]:
    """Indices of the points that begin so many stretches of about equal length."""
    steps = lengths[first] + (lengths[last] - lengths[first]) * np.arange(count) / count
    return np.unique(np.searchsorted(lengths, steps))


def _splits(points: Floats, first: int, last: int, near: float) -> list[int]:
    """Indices between two points of a line where one cubic ends and the next begins, so that all are near."""
    splits, stack = [], [(first, last)]
    while stack:
        one, two = stack.pop()
        line = points[one : two + 1]
        worst, away = _worst_of_cubic(line)
        if away > near and two - one > 5:
            middle = one + min(max(worst, 2), two - one - 2)
            splits.append(middle)
            stack += [(one, middle), (middle, two)]
    return splits


def _worst_of_cubic(line: Floats) -> tuple[int, float]:
    """The point of a line (n, 2) farthest from the cubic that fits it best from end to end, and how far."""
    lengths = line_lengths(line)
    if len(line) < 4 or lengths[-1] <= 0.0:
        return 0, 0.0
    at = lengths / lengths[-1]
    ends = (1 - at)[:, None] ** 3 * line[0] + at[:, None] ** 3 * line[-1]
    inner = np.column_stack([3 * (1 - at) ** 2 * at, 3 * (1 - at) * at**2])
    controls, *_ = np.linalg.lstsq(inner, line - ends, rcond=None)
    curve = bezier(np.stack([line[0], controls[0], controls[1], line[-1]]))
    away = nearest_on_line(curve, line).distance
    worst = int(np.argmax(away))
    return worst, float(away[worst])


def bezier(controls: Floats, count: int = 32) -> Floats:
    """Points (count + 1, 2) of the cubic with four control points (4, 2)."""
    at = np.linspace(0.0, 1.0, count + 1)
    shares = np.column_stack([(1 - at) ** 3, 3 * (1 - at) ** 2 * at, 3 * (1 - at) * at**2, at**3])
    return np.asarray(shares @ controls)

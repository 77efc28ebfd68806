# SPDX-License-Identifier: LGPL-2.1-or-later
"""The course of a design: the drawing and the pattern, point by point beside each other.

Both are finely sampled loops with the same number of points; point j of the pattern is the place of the seam
that shall appear at point j of the drawing. The pattern is moved by smooth fields, so that it keeps the
corners and the detail of the drawing however coarse the mesh is.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from BalloonWorkbench.core.design.correspondence import locate
from BalloonWorkbench.core.design.weld_lines import WeldLine, weld_lines
from BalloonWorkbench.core.mesh.panel import Panel
from BalloonWorkbench.core.outline.crossings import first_crossing
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.outline.sampling import arc_lengths, corners, point_at, resample
from BalloonWorkbench.core.types import Floats, Ints

_CORNER = np.radians(30.0)


@dataclass(frozen=True)
class Course:
    """drawing and pattern: loops (n, 2) m, one beside the other.

    The last `spots` of the loops are spot welds; lines: the welds inside.
    """

    drawing: tuple[Floats, ...]
    pattern: tuple[Floats, ...]
    spots: int = 0
    lines: tuple[WeldLine, ...] = ()

    @staticmethod
    def begun(target: Outline, grow: Callable[[Floats], Floats], spacing: float) -> Course:
        """The course whose pattern is the drawing grown, sampled `spacing` apart with its corners kept."""
        drawing = tuple(resample(loop, spacing) for loop in target.loops)
        lines = weld_lines(target, drawing, spacing)
        return Course(
            drawing,
            tuple(grow(loop) for loop in drawing),
            len(target.spots),
            tuple(replace(line, pattern=grow(line.pattern)) for line in lines),
        )

    @property
    def outline(self) -> Outline:
        """The pattern as an outline."""
        last = len(self.pattern) - self.spots
        return Outline(
            self.pattern[0],
            self.pattern[1:last],
            welds=tuple(line.pattern for line in self.lines),
            spots=self.pattern[last:],
        )

    def resized(self, pattern: Outline, scale: float) -> Course | None:
        """The course with the pattern of the same course at another size; None where that was sampled
        otherwise."""
        if [len(loop) for loop in pattern.loops] != [len(loop) for loop in self.pattern]:
            return None
        lines = [
            replace(line, pattern=scale * weld) for line, weld in zip(self.lines, pattern.welds, strict=True)
        ]
        return replace(self, pattern=tuple(scale * loop for loop in pattern.loops), lines=tuple(lines))

    def moved(self, fields: tuple[Floats, ...]) -> Course:
        """The course with its pattern moved by fields, one (n, 2) for each loop.

        Where the pattern would cross itself, or turn so far that its neighbourhood would, the field is
        weakened there until it does not.
        """
        strength = [np.ones(len(loop)) for loop in self.pattern]
        for attempt in range(40):
            loops = tuple(
                loop + share[:, None] * field
                for loop, share, field in zip(self.pattern, strength, fields, strict=True)
            )
            place = first_crossing(loops)
            if place is None:
                return replace(self, pattern=loops, lines=tuple(line.tied(loops) for line in self.lines))
            reach = 0.01 * (1.0 + attempt) * float(np.ptp(loops[0], axis=0).max())
            strength = [
                share * (1.0 - 0.5 * np.exp(-(np.linalg.norm(loop - place, axis=1) ** 2) / reach**2))
                for loop, share in zip(loops, strength, strict=True)
            ]
        return self

    def taken_back(self, earlier: Course, place: tuple[float, float] | None, reach: float) -> Course:
        """The course with its pattern half way back to an earlier one, around a place or everywhere.

        Where a part that went back would cross one that did not, more of it goes back.
        """
        for widening in range(8):
            loops = []
            for mine, its in zip(self.pattern, earlier.pattern, strict=True):
                share = np.full((len(mine), 1), 0.5)
                if place is not None:
                    away = np.linalg.norm(its - place, axis=1, keepdims=True)
                    share *= np.exp(-((away / (reach * 2.0**widening)) ** 2))
                loops.append(mine + share * (its - mine))
            if first_crossing(loops) is None:
                break
        else:
            return earlier
        lines = [
            mine.toward(its).tied(tuple(loops)) for mine, its in zip(self.lines, earlier.lines, strict=True)
        ]
        return replace(self, pattern=tuple(loops), lines=tuple(lines))


@dataclass(frozen=True)
class SeamNodes:
    """Where the seam vertices of a panel lie along one loop of the course.

    index         (k,) fractional index along the sampled loops
    lengths       (k,) arc length along the drawing
    corner_nodes  vertices that stand for corners of the drawing; corners: their arc lengths
    """

    index: Floats
    lengths: Floats
    corner_nodes: Ints
    corners: Floats

    def placed_on(self, loop: Floats) -> Floats:
        """The nodes' places (k, 2) on a sampled loop."""
        return point_at(loop, np.arange(len(loop) + 1, dtype=np.float64), self.index)

    def spread(self, values: Floats, count: int) -> Floats:
        """Node values (k, 2) interpolated at the `count` points of the sampled loop."""
        order = np.argsort(self.index, kind="stable")
        at, sorted_values = self.index[order], values[order]
        at = np.concatenate([at[-1:] - count, at, at[:1] + count])
        sorted_values = np.concatenate([sorted_values[-1:], sorted_values, sorted_values[:1]])
        points = np.arange(count, dtype=np.float64)
        return np.column_stack([np.interp(points, at, sorted_values[:, axis]) for axis in (0, 1)])

    def smoothed(self, values: Floats, around: float, width: float) -> Floats:
        """Node values (k, 2) averaged with a Gaussian of this width along the drawing.

        around is the length of the drawing's loop.
        """
        gap = np.mod(self.lengths[:, None] - self.lengths[None] + 0.5 * around, around) - 0.5 * around
        weight = np.exp(-0.5 * (gap / width) ** 2)
        share = np.empty(len(self.lengths))  # of the loop that belongs to each node
        order = np.argsort(self.lengths, kind="stable")
        along = self.lengths[order]
        steps = np.diff(np.append(along, along[0] + around))
        share[order] = 0.5 * (steps + np.roll(steps, 1))
        weight *= np.maximum(share, 1e-12 * around)
        return np.asarray(weight @ values / weight.sum(axis=1)[:, None])


def seam_nodes(course: Course, panel: Panel) -> tuple[SeamNodes, ...]:
    """The seam vertices of a panel that was meshed from the course's pattern, loop by loop."""
    found = []
    for drawing, pattern, seam in zip(course.drawing, course.pattern, panel.seams, strict=True):
        lengths = arc_lengths(pattern)
        counter = np.arange(len(pattern) + 1, dtype=np.float64)
        index = np.interp(locate(pattern, panel.rest_positions[seam]), lengths, counter)
        along = arc_lengths(drawing)
        reach = 0.5 * along[-1] / len(seam)
        sharp = corners(drawing, _CORNER, reach)
        nodes, places = [], []
        for corner in sharp:
            away = np.abs(np.mod(index - corner + 0.5 * len(pattern), len(pattern)) - 0.5 * len(pattern))
            nearest = int(np.argmin(away))
            if away[nearest] < 1.0:
                nodes.append(nearest)
                places.append(along[corner])
        found.append(
            SeamNodes(
                index,
                np.interp(index, counter, along),
                np.array(nodes, dtype=np.int32),
                np.array(places, dtype=np.float64),
            )
        )
    return tuple(found)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Welds inside a balloon, carried from the drawing to the pattern.

Like the rim, a weld of the pattern is moved until the inflated balloon has it where it was drawn. An end that
was drawn at the rim goes along with the rim.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from BalloonWorkbench.core.geometry.nearest import locate, nearest_on_line
from BalloonWorkbench.core.geometry.polyline import arc_lengths, extent, line_lengths, point_at, point_on
from BalloonWorkbench.core.mesh.boundary import AT_RIM
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.types import Floats

#: How far an end that is at a loop stays away from it, relative to the outline.
_HAIR = 4e-3


@dataclass(frozen=True)
class WeldLine:
    """A weld: points (n, 2) m of the drawing and of the pattern, one beside the other.

    ends  for its begin and its end the number of the loop to which it is tied, or None
    """

    drawing: Floats
    pattern: Floats
    ends: tuple[int | None, int | None] = (None, None)

    def along(self, places: Floats) -> Floats:
        """Indices (k,), with fractions, of the points of the pattern nearest to places (k, 2)."""
        nearest = nearest_on_line(self.pattern, places)
        return nearest.edge + nearest.share

    def mean_distance(self, inflated: Floats) -> float:
        """Of vertices (k, 2) of the balloon from the drawing [m]."""
        return float(nearest_on_line(self.drawing, inflated).distance.mean())

    def at(self, index: Floats) -> Floats:
        """Places (k, 2) on the pattern."""
        return point_on(self.pattern, np.arange(len(self.pattern), dtype=np.float64), index)

    def corrected(self, flat: Floats, inflated: Floats, width: float, most: float) -> WeldLine:
        """The line with its pattern moved by what is left between drawing and balloon at its vertices (k, 2).

        The differences are averaged over `width` along the line and are at most `most` [m].
        """
        index = self.along(flat)
        order = np.argsort(index, kind="stable")
        counter = np.arange(len(self.drawing), dtype=np.float64)
        missing = point_on(self.drawing, counter, index[order]) - inflated[order]
        at = np.interp(index[order], counter, line_lengths(self.drawing))
        weight = np.exp(-0.5 * ((at[:, None] - at) / width) ** 2)
        smooth = weight @ missing / weight.sum(axis=1)[:, None]
        step = point_on(smooth, index[order], counter)
        length = np.linalg.norm(step, axis=1, keepdims=True)
        return replace(self, pattern=self.pattern + step * np.minimum(1.0, most / np.maximum(length, 1e-300)))

    def tied(self, loops: tuple[Floats, ...]) -> WeldLine:
        """The line with its tied ends beside where the loops are now; what is between them moves in part."""
        pattern = self.pattern
        share = line_lengths(pattern)[:, None] / line_lengths(pattern)[-1]
        for end, weight in ((0, 1.0 - share), (-1, share)):
            tie = self.ends[end]
            if tie is None:
                continue
            loop = loops[tie]
            place = point_at(loop, arc_lengths(loop), locate(loop, pattern[end][None]))[0]
            inward = pattern[len(pattern) // 2] - place
            inward *= _HAIR * extent(loops[0]) / max(float(np.linalg.norm(inward)), 1e-300)
            pattern = pattern + weight * (place + inward - pattern[end])
        return replace(self, pattern=pattern)

    def toward(self, other: WeldLine) -> WeldLine:
        """The line with its pattern half way to that of another."""
        return replace(self, pattern=0.5 * (self.pattern + other.pattern))


def weld_lines(target: Outline, loops: tuple[Floats, ...], spacing: float) -> tuple[WeldLine, ...]:
    """The welds of a drawing, sampled `spacing` apart, tied to loops of it that are sampled too."""
    size = extent(loops[0])
    lines = []
    for weld in target.welds:
        lengths = line_lengths(weld)
        even = np.linspace(0.0, lengths[-1], max(3, int(np.ceil(lengths[-1] / spacing)) + 1))
        points = point_on(weld, lengths, np.union1d(even, lengths))
        lines.append(WeldLine(points, points, (_tie(points[0], loops, size), _tie(points[-1], loops, size))))
    return tuple(lines)


def _tie(end: Floats, loops: tuple[Floats, ...], size: float) -> int | None:
    for number, loop in enumerate(loops):
        place = point_at(loop, arc_lengths(loop), locate(loop, end[None]))[0]
        if np.linalg.norm(place - end) < AT_RIM * size:
            return number
    return None

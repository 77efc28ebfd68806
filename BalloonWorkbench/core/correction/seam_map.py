# SPDX-License-Identifier: LGPL-2.1-or-later
"""The seam map of a design: the drawing and the pattern, point by point beside each other.

Both are finely sampled loops with the same number of points; point j of the pattern is the place of the seam
that shall appear at point j of the drawing. The pattern is moved by smooth fields, so that it keeps the
corners and the detail of the drawing however coarse the mesh is.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from BalloonWorkbench.core.correction.clearance import enforce_clearance
from BalloonWorkbench.core.correction.weld_lines import WeldLine, weld_lines
from BalloonWorkbench.core.geometry.crossings import first_crossing
from BalloonWorkbench.core.geometry.nearest import locate
from BalloonWorkbench.core.geometry.normals import corners
from BalloonWorkbench.core.geometry.polyline import arc_lengths, extent, gaps, point_at
from BalloonWorkbench.core.geometry.sampling import resample
from BalloonWorkbench.core.geometry.vectors import cross
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.types import Floats, Ints

_CORNER = np.radians(30.0)


@dataclass(frozen=True)
class SeamMap:
    """drawing and pattern: loops (n, 2) m, one beside the other.

    The last `spots` of the loops are spot welds; lines: the welds inside.
    """

    drawing: tuple[Floats, ...]
    pattern: tuple[Floats, ...]
    spots: int = 0
    lines: tuple[WeldLine, ...] = ()

    @staticmethod
    def identity(target: Outline, spacing: float) -> SeamMap:
        """The map whose pattern is the drawing itself, sampled `spacing` apart with its corners kept."""
        drawing = tuple(resample(loop, spacing) for loop in target.loops)
        return SeamMap(drawing, drawing, len(target.spots), weld_lines(target, drawing, spacing))

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

    def resized(self, pattern: Outline, scale: float) -> SeamMap | None:
        """The map with the pattern of the same map at another size; None where that was sampled otherwise."""
        if [len(loop) for loop in pattern.loops] != [len(loop) for loop in self.pattern]:
            return None
        lines = [
            replace(line, pattern=scale * weld) for line, weld in zip(self.lines, pattern.welds, strict=True)
        ]
        return replace(self, pattern=tuple(scale * loop for loop in pattern.loops), lines=tuple(lines))

    def moved(self, fields: tuple[Floats, ...], zone: float, clearance: float) -> SeamMap:
        """The map with its pattern moved by fields, one (n, 2) for each loop.

        Within `zone` [m] of a tip the pattern is bridged, and facing parts are kept `clearance` [m] apart.
        Where the pattern would still cross itself, or turn so far that its neighbourhood would, the field is
        weakened until it does not.
        """
        strength = [np.ones(len(loop)) for loop in self.pattern]
        for trial in range(40):
            moved = tuple(
                _bridged(drawing, loop + share[:, None] * field, zone)
                for drawing, loop, share, field in zip(
                    self.drawing, self.pattern, strength, fields, strict=True
                )
            )
            loops = enforce_clearance(self.drawing, moved, clearance)
            place = first_crossing(loops)
            if place is None:
                return replace(self, pattern=loops, lines=tuple(line.tied(loops) for line in self.lines))
            reach = 0.01 * (1.0 + trial) * extent(loops[0])
            strength = [
                share * (1.0 - 0.5 * np.exp(-(np.linalg.norm(loop - place, axis=1) ** 2) / reach**2))
                for loop, share in zip(loops, strength, strict=True)
            ]
        return self

    def half_back(self, earlier: SeamMap, place: tuple[float, float] | None, reach: float) -> SeamMap:
        """The map with its pattern half way back to an earlier one, around a place or everywhere.

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


def _bridged(drawing: Floats, pattern: Floats, zone: float) -> Floats:
    """The pattern (n, 2) with its displacement from the drawing bridged."""
    shift = pattern - drawing
    even = bridged(drawing, shift, zone)
    return pattern if even is shift else drawing + even


def bridged(drawing: Floats, field: Floats, zone: float) -> Floats:
    """A field (n, d) along the drawing (n, 2), made linear between each tip and `zone` [m] beside it.

    In a tip the triangles are wider than the film can bulge: they stay flat, and what they show there is the
    mesh and not the film. Followed, it would draw the tip out to a needle. Without tips the field itself.
    """
    along = arc_lengths(drawing)
    tips = _tips(drawing, zone)
    if not len(tips):
        return field
    here, around = along[:-1], float(along[-1])
    sure = gaps(here[:, None], here[tips], around).min(axis=1) > zone
    sure[tips] = True
    return np.column_stack([np.interp(here, here[sure], column, period=around) for column in field[sure].T])


def _tips(drawing: Floats, reach: float) -> Ints:
    """Indices of the corners of a loop at which the film, on the left of the loop, ends in a point."""
    sharp = corners(drawing, _CORNER, 0.25 * reach)
    along = arc_lengths(drawing)
    here = along[sharp]
    before, after = (point_at(drawing, along, here + way) for way in (-0.25 * reach, 0.25 * reach))
    back, ahead = drawing[sharp] - before, after - drawing[sharp]
    return sharp[cross(back, ahead) > 0.0].astype(np.int32)


@dataclass(frozen=True)
class SeamNodes:
    """Where the seam vertices of a panel lie along one loop of the seam map.

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

    def field(self, values: Floats, drawing: Floats, width: float) -> Floats:
        """Node values (k, d) averaged with a Gaussian of this width, at all points of the drawing: (n, d)."""
        along = arc_lengths(drawing)
        here, around = along[:-1], float(along[-1])
        weight = np.exp(-0.5 * (gaps(here[:, None], self.lengths, around) / width) ** 2)
        share = np.empty(len(self.lengths))  # of the loop that belongs to each node
        order = np.argsort(self.lengths, kind="stable")
        steps = np.diff(np.append(self.lengths[order], self.lengths[order[0]] + around))
        share[order] = 0.5 * (steps + np.roll(steps, 1))
        weight *= np.maximum(share, 1e-12 * around)
        return np.asarray(weight @ values / weight.sum(axis=1)[:, None])


def seam_nodes(seam_map: SeamMap, panel: Panel) -> tuple[SeamNodes, ...]:
    """The seam vertices of a panel that was meshed from the map's pattern, loop by loop."""
    loops = []
    for drawing, pattern, seam in zip(seam_map.drawing, seam_map.pattern, panel.loops, strict=True):
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
        loops.append(
            SeamNodes(
                index,
                np.interp(index, counter, along),
                np.array(nodes, dtype=np.int32),
                np.array(places, dtype=np.float64),
            )
        )
    return tuple(loops)

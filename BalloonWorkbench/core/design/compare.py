# SPDX-License-Identifier: LGPL-2.1-or-later
"""Comparing curves: alignment and the two-way distance between outlines."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.design.design import Residual
from BalloonWorkbench.core.mesh.thickness import kd_tree
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.outline.sampling import arc_lengths, point_at
from BalloonWorkbench.core.types import Bools, Floats, Ints

_SAMPLES = 1000  # along the longest loop
_CANDIDATES = 4  # points of a curve beside which its nearest one may be


@dataclass(frozen=True)
class Misfit:
    """How far two outlines are apart, place by place, both ways.

    distances  (k,) from points of either outline to the other one [m]
    loop       (k,) loop of the drawing where that is
    share      (k,) how far round that loop, 0 to 1
    """

    distances: Floats
    loop: Ints
    share: Floats

    def over(self, used: Bools | None = None) -> Residual:
        """Mean, 95th percentile and maximum of all distances or of some (k,)."""
        found = self.distances if used is None or not used.any() else self.distances[used]
        return Residual(float(found.mean()), float(np.percentile(found, 95)), float(found.max()))


def residual(drawing: Outline, shown: Outline) -> Residual:
    """Distances from each outline to the other one, at points evenly spaced along both [m]."""
    return misfit(drawing, shown).over()


def misfit(drawing: Outline, shown: Outline) -> Misfit:
    """Distances from each outline to the other one, at points evenly spaced along both, place by place."""
    spacing = max(float(arc_lengths(loop)[-1]) for loop in drawing.loops) / _SAMPLES
    here = [evenly(loop, spacing) for loop in drawing.loops]
    there = np.concatenate([evenly(loop, spacing) for loop in shown.loops])
    forth = _nearest(shown.loops, np.concatenate(here), spacing)[0]
    back, nearest, share = _nearest(drawing.loops, there, spacing)
    return Misfit(
        np.concatenate([forth, back]),
        np.concatenate([np.repeat(np.arange(len(here)), [len(points) for points in here]), nearest]).astype(
            np.int32
        ),
        np.concatenate([*(np.arange(len(points)) / len(points) for points in here), share]),
    )


def _nearest(loops: Sequence[Floats], points: Floats, spacing: float) -> tuple[Floats, Ints, Floats]:
    """Distances (k,) m from points (k, 2) to closed loops, the nearest loop and how far round it, 0 to 1.

    Looked for among the segments beside the nearest points of the loops, `spacing` [m] apart or less.
    """
    starts, ahead, share, owner, before = [], [], [], [], []
    first = 0
    for number, loop in enumerate(loops):
        steps = np.linalg.norm(np.roll(loop, -1, axis=0) - loop, axis=1)
        pieces = np.maximum(np.ceil(steps / spacing), 1.0).astype(np.int64)
        part = np.concatenate([np.arange(count) / count for count in pieces])
        index = np.repeat(np.arange(len(loop)), pieces)
        dense = loop[index] + part[:, None] * (np.roll(loop, -1, axis=0) - loop)[index]
        starts.append(dense)
        ahead.append(np.roll(dense, -1, axis=0) - dense)
        lengths = arc_lengths(dense)
        share.append(np.column_stack([lengths[:-1], lengths[1:]]) / lengths[-1])
        owner.append(np.full(len(dense), number))
        before.append(first + np.roll(np.arange(len(dense)), 1))
        first += len(dense)
    start, way, ends, mine = (np.concatenate(parts) for parts in (starts, ahead, share, owner))
    near = kd_tree(start).query(points, k=_CANDIDATES)[1]
    segment = np.concatenate([near, np.concatenate(before)[near]], axis=1)
    offset = points[:, None] - start[segment]
    squared = np.maximum(np.einsum("ij,ij->i", way, way), 1e-300)
    along = np.clip(np.einsum("kij,kij->ki", offset, way[segment]) / squared[segment], 0.0, 1.0)
    away = np.linalg.norm(offset - along[:, :, None] * way[segment], axis=2)
    row, best = np.arange(len(points)), np.argmin(away, axis=1)
    chosen, part = segment[row, best], along[row, best]
    begin, end = ends[chosen].T
    return away[row, best], mine[chosen].astype(np.int32), np.asarray(begin + part * (end - begin))


def evenly(loop: Floats, spacing: float) -> Floats:
    """Points (k, 2) about `spacing` apart along a closed loop."""
    lengths = arc_lengths(loop)
    count = max(8, int(np.ceil(lengths[-1] / spacing)))
    return point_at(loop, lengths, lengths[-1] * np.arange(count) / count)


def alignment(points: Floats, goals: Floats, weights: Floats) -> tuple[Floats, Floats]:
    """Rotation (2, 2) and shift (2,) with which rotation point + shift is nearest to the goals (n, 2).

    Least squares (Kabsch), after the barycentres are brought together.
    """
    share = weights / weights.sum()
    centre, goal_centre = share @ points, share @ goals
    correlation = (points - centre).T @ ((goals - goal_centre) * share[:, None])
    angle = np.arctan2(correlation[0, 1] - correlation[1, 0], correlation[0, 0] + correlation[1, 1])
    rotation = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    return rotation, goal_centre - rotation @ centre


def loop_weights(loops: Sequence[Floats]) -> Floats:
    """Length of loop that belongs to each point, for all loops one after the other."""
    weights = []
    for loop in loops:
        steps = np.linalg.norm(np.roll(loop, -1, axis=0) - loop, axis=1)
        weights.append(0.5 * (steps + np.roll(steps, 1)))
    return np.concatenate(weights)

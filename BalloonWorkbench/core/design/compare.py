# SPDX-License-Identifier: LGPL-2.1-or-later
"""Comparing curves: alignment and the two-way distance between outlines."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.design.design import Residual
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.outline.sampling import arc_lengths, point_at
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.types import Bools, Floats, Ints

_SAMPLES = 1000  # along the longest loop


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
    package = shapely()
    spacing = max(float(arc_lengths(loop)[-1]) for loop in drawing.loops) / _SAMPLES
    here = [evenly(loop, spacing) for loop in drawing.loops]
    there = package.points(np.concatenate([evenly(loop, spacing) for loop in shown.loops]))
    rings = [package.LineString(np.vstack([loop, loop[:1]])) for loop in drawing.loops]
    other = package.MultiLineString([np.vstack([loop, loop[:1]]) for loop in shown.loops])
    for curve in (*rings, other):
        package.prepare(curve)
    away = np.array([package.distance(there, ring) for ring in rings])
    nearest = np.argmin(away, axis=0)
    share = np.empty(len(there))
    for number, ring in enumerate(rings):
        mine = nearest == number
        share[mine] = package.line_locate_point(ring, there[mine], normalized=True)
    return Misfit(
        np.concatenate([package.distance(package.points(np.concatenate(here)), other), away.min(axis=0)]),
        np.concatenate([np.repeat(np.arange(len(here)), [len(points) for points in here]), nearest]).astype(
            np.int32
        ),
        np.concatenate([*(np.arange(len(points)) / len(points) for points in here), share]),
    )


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

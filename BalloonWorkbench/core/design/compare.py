# SPDX-License-Identifier: LGPL-2.1-or-later
"""Comparing curves: alignment and the two-way distance between outlines."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from BalloonWorkbench.core.design.design import Residual
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.outline.sampling import arc_lengths, point_at
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.types import Floats

_SAMPLES = 1000  # along the longest loop


def residual(drawing: Outline, shown: Outline) -> Residual:
    """Distances from each outline to the other one, at points evenly spaced along both [m]."""
    spacing = max(float(arc_lengths(loop)[-1]) for loop in drawing.loops) / _SAMPLES
    distances = np.concatenate([_distances(drawing, shown, spacing), _distances(shown, drawing, spacing)])
    return Residual(float(distances.mean()), float(np.percentile(distances, 95)), float(distances.max()))


def _distances(one: Outline, other: Outline, spacing: float) -> Floats:
    package = shapely()
    curve = package.MultiLineString([np.vstack([loop, loop[:1]]) for loop in other.loops])
    package.prepare(curve)
    points = np.concatenate([evenly(loop, spacing) for loop in one.loops])
    return np.asarray(package.distance(package.points(points), curve))


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

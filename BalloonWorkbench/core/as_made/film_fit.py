# SPDX-License-Identifier: LGPL-2.1-or-later
"""How much a film stretched and how far its weld drew it in, from the difference of two silhouettes.

Stretch makes all of the balloon larger, as film that does not resist bending keeps its shape whatever its
size. A weld that draws film in moves the seam inward: the silhouette of a pattern whose seam lies further
inside tells by how much each place follows. Both are small, so the difference is linear in them.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np

from BalloonWorkbench.core.as_made.comparison import Comparison
from BalloonWorkbench.core.as_made.photo_scale import PhotoScale
from BalloonWorkbench.core.as_made.placement import weights_of
from BalloonWorkbench.core.geometry.nearest import nearest_places
from BalloonWorkbench.core.geometry.normals import left_normals
from BalloonWorkbench.core.geometry.polyline import centroid
from BalloonWorkbench.core.geometry.sampling import evenly
from BalloonWorkbench.core.geometry.vectors import perpendicular
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.types import Floats

_SAMPLES, _REWEIGHED = 800, 12
#: How well the edge of the balloon is known all round [px].
_EDGE = 0.1
#: From this correlation on, the shape does not tell the two apart.
_ALIKE = 0.97


@dataclass(frozen=True)
class FilmFit:
    """What fits best, with one standard deviation each.

    stretch    of the film, 0.01 for 1 %; shrinkage [m]: how far the weld draws the seam inward
    apart      the shape tells the two from each other; else each is what fits without the other
    left       mean difference that neither explains [m]
    """

    stretch: float
    stretch_error: float
    shrinkage: float
    shrinkage_error: float
    apart: bool
    left: float


def fit_film(
    comparison: Comparison, usual: Outline, narrower: Outline, step: float, scale: PhotoScale
) -> FilmFit:
    """Stretch and shrinkage from a comparison.

    usual, narrower  what is expected of the pattern, and of one with its seam `step` [m] further inside
    """
    expected, necks = comparison.expected.outline, comparison.expected.necks
    outlines = [expected, comparison.seen, usual, narrower]
    count = 1 + min(len(outline.holes) for outline in outlines)
    if count <= len(expected.holes):  # not all are seen
        count = 1
    loops, goals, before, after = ([outline.outer, *outline.holes][:count] for outline in outlines)
    along = [evenly(loop, expected.perimeter / _SAMPLES) for loop in loops]
    places, outward = np.concatenate(along), np.concatenate([-left_normals(each) for each in along])
    seen = _across(places, outward, goals)
    away = places - centroid(loops[:1])
    moves = np.column_stack([outward, np.einsum("ij,ij->i", perpendicular(away), outward)])
    stretch = np.einsum("ij,ij->i", away, outward)
    shrinkage = (_across(places, outward, after) - _across(places, outward, before)) / step
    solved = partial(_solved, goals=seen, weigh=lambda missing: weights_of(missing, places, necks))
    both = solved(np.column_stack([stretch, shrinkage, moves]), count=2)
    correlation = abs(both.covariance[0, 1]) / np.sqrt(both.covariance[0, 0] * both.covariance[1, 1])
    apart = bool(correlation < _ALIKE)
    if apart:
        values, errors, left = both.values, np.sqrt(np.diag(both.covariance)), both.left
    else:
        alone = [solved(np.column_stack([each, moves]), count=1) for each in (stretch, shrinkage)]
        values = np.array([each.values[0] for each in alone])
        errors = np.array([np.sqrt(each.covariance[0, 0]) for each in alone])
        left = min(each.left for each in alone)
    follows = max(float(np.abs(shrinkage).mean()), 1e-9)
    edge = _EDGE * scale.pixel / follows
    slip = 0.0 if apart else float(np.abs(stretch).mean()) * scale.uncertainty / follows
    return FilmFit(
        float(values[0]),
        float(np.hypot(errors[0], scale.uncertainty)),
        float(values[1]),
        float(np.sqrt(errors[1] ** 2 + edge**2 + slip**2)),
        apart,
        left,
    )


def _across(places: Floats, outward: Floats, loops: list[Floats]) -> Floats:
    """How far outside of places (k, 2) loops run, along their normals [m]."""
    return np.asarray(np.einsum("ij,ij->i", nearest_places(loops, places) - places, outward))


@dataclass(frozen=True)
class _Solution:
    """The first values of a least squares fit, their covariance, and the mean difference that is left."""

    values: Floats
    covariance: Floats
    left: float


def _solved(columns: Floats, goals: Floats, weigh: Callable[[Floats], Floats], count: int) -> _Solution:
    """Least squares, weighed by what they leave; neighbouring differences count as fewer than they are."""
    solution = np.zeros(columns.shape[1])
    weights = np.sign(weigh(goals))
    for _ in range(_REWEIGHED):
        rows = columns * weights[:, None]
        solution = np.linalg.lstsq(rows, goals * weights, rcond=1e-9)[0]
        residual = goals - columns @ solution
        weights = weigh(residual)
    counted = weights > 0.0
    free = max(int(counted.sum()) - columns.shape[1], 1)
    variance = float((weights * residual) @ (weights * residual)) / free
    inverse = np.linalg.pinv(rows.T @ rows, rcond=1e-15, hermitian=True)
    covariance = variance * _repeated(residual[counted]) * inverse
    left = float(np.abs(residual[counted]).mean())
    return _Solution(solution[:count], covariance[:count, :count], left)


def _repeated(residual: Floats) -> float:
    """How many neighbours on a loop say the same: 1 + 2 (sum of autocorrelations up to the first below 0)."""
    centred = residual - residual.mean()
    power = np.abs(np.fft.rfft(centred)) ** 2
    correlations = np.fft.irfft(power, len(centred))
    correlations = correlations[: len(centred) // 2] / max(correlations[0], 1e-300)
    below = np.flatnonzero(correlations <= 0.0)
    last = int(below[0]) if len(below) else len(correlations)
    return float(1.0 + 2.0 * correlations[1:last].sum())

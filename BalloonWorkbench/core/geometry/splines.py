# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cubic B-splines (de Boor 1972), over a stretch and along closed loops with corners."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.geometry.polyline import arc_lengths, point_weights
from BalloonWorkbench.core.types import Floats, Ints

_FEWEST = 4  # splines of a loop without corners
_FINE = 200  # places of a stretch at which the distance of knots is looked at


def open_splines(at: Floats, breaks: Floats) -> Floats:
    """Splines (k, m + 2) over 0 to 1 at places (k,), which sum to 1; at each end one of them is 1.

    breaks (m,) from 0 to 1, between which they are cubic
    """
    knots = np.concatenate([np.zeros(3), breaks, np.ones(3)])
    inside = np.clip(at, 0.0, 1.0 - 1e-12)[:, None]
    values = ((knots[:-1] <= inside) & (inside < knots[1:])).astype(np.float64)
    for degree in range(1, 4):
        spans = knots[degree:] - knots[:-degree]
        share = (inside - knots[:-degree]) / np.maximum(spans, 1e-300)
        share[:, spans <= 0.0] = 0.0
        left = share * 1.0
        right = np.where(spans > 0.0, 1.0 - share, 0.0)
        values = left[:, :-1] * values[:, :-1] + right[:, 1:] * values[:, 1:]
    return values


def closed_splines(at: Floats, count: int) -> Floats:
    """Splines (k, count) of period 1 at places (k,); they sum to 1. The first has its top at 0."""
    away = np.mod(count * at[:, None] - np.arange(count) + 0.5 * count, count) - 0.5 * count
    inner, outer = np.maximum(1.0 - np.abs(away), 0.0), np.maximum(2.0 - np.abs(away), 0.0)
    return np.asarray((outer**3 - 4.0 * inner**3) / 6.0)


def graded_breaks(span: float, spacing: float, at_ends: float) -> Floats:
    """Parts (m,) of a stretch, from 0 to 1, about `spacing` [m] apart, and so much [m] apart at its ends.

    Away from an end they grow by half of the distance from it.
    """
    at = np.linspace(0.0, span, _FINE + 1)
    own = np.minimum(spacing, at_ends + 0.5 * np.minimum(at, span - at))
    passed = np.append(0.0, np.cumsum(0.5 * np.diff(at) * (1.0 / own[1:] + 1.0 / own[:-1])))
    count = max(round(float(passed[-1])), 1)
    return np.asarray(np.interp(np.linspace(0.0, passed[-1], count + 1), passed, at / span))


def loop_splines(loop: Floats, corners: Ints, spacing: float, at_corners: float) -> Floats:
    """Splines (n, k) at the points of a closed loop (n, 2) m, on knots about `spacing` [m] apart.

    They sum to 1. What they make is smooth but at these corners, in rising order, where it may have a kink,
    and beside which knots are `at_corners` [m] apart.
    """
    along = arc_lengths(loop)
    here, around = along[:-1], float(along[-1])
    if not len(corners):
        return closed_splines(here / around, max(_FEWEST, round(around / spacing)))
    starts = here[corners]
    spans = np.diff(np.append(starts, starts[0] + around))
    breaks = [graded_breaks(float(span), spacing, at_corners) for span in spans]
    counts = [len(each) + 2 for each in breaks]
    first = np.append(0, np.cumsum([count - 1 for count in counts]))  # its last begins the next stretch
    splines = np.zeros((len(loop), first[-1]))
    for number, (start, span, count) in enumerate(zip(starts, spans, counts, strict=True)):
        ahead = np.mod(here - start, around)
        own = np.flatnonzero(ahead < span)
        columns = (first[number] + np.arange(count)) % first[-1]
        splines[np.ix_(own, columns)] = open_splines(ahead[own] / span, breaks[number])
    return splines


def nearest_spline(loop: Floats, splines: Floats, values: Floats) -> Floats:
    """What splines (n, k) make nearest to values (n, d) at the points of a closed loop (n, 2): (n, d)."""
    root = np.sqrt(point_weights(loop))[:, None]
    return np.asarray(splines @ np.linalg.lstsq(root * splines, root * values, rcond=None)[0])


def through(at: Floats) -> Floats:
    """Polynomials (k, 5) through five even places, at (k,) from 0 to 1."""
    knots = np.arange(5) / 4.0
    shapes = [
        np.prod([(at - knots[j]) / (knots[k] - knots[j]) for j in range(5) if j != k], axis=0)
        for k in range(5)
    ]
    return np.stack(shapes, axis=1)

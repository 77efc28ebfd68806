# SPDX-License-Identifier: LGPL-2.1-or-later
"""Smooth curves along the sides of seams, where lines along the edges of triangles are not smooth."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.geometry.polyline import line_lengths, point_on
from BalloonWorkbench.core.types import Floats

#: Samples of a line for each span of its curve.
_SAMPLES = 12


def smooth_line(line: Floats, spans: int, most: int, away: float) -> Floats:
    """A natural cubic spline near a line (n, d) from its first to its last point, at many places (k, d).

    spans  between even knots at first; up to `most`, as many as it takes to stay so far [m] away at most
    """
    lengths = line_lengths(line)
    while True:
        at = np.linspace(0.0, 1.0, _SAMPLES * spans + 1)
        points = point_on(line, lengths, at * lengths[-1])
        straight = points[0] + at[:, None] * (points[-1] - points[0])
        inner = knot_shapes(at, spans)[:, 1:-1]
        curve = straight + inner @ np.linalg.lstsq(inner, points - straight, rcond=None)[0]
        if spans >= most or float(np.linalg.norm(curve - points, axis=1).max()) <= away:
            return np.asarray(curve)
        spans = min(2 * spans, most)


def knot_shapes(at: Floats, count: int) -> Floats:
    """Natural cubic splines (k, count + 1) at places (k,), 0 to 1: each is 1 at one of the even knots."""
    knots = count + 1
    second = np.zeros((knots, knots))  # second derivatives of each, in spans
    if count > 1:
        matrix = 4.0 * np.eye(count - 1) + np.eye(count - 1, k=1) + np.eye(count - 1, k=-1)
        differences = np.diff(np.eye(knots), n=2, axis=0)
        second[1:-1] = np.linalg.solve(matrix, 6.0 * differences)
    span = np.minimum((at * count).astype(int), count - 1)
    b = (at * count - span)[:, None]
    a = 1.0 - b
    eye = np.eye(knots)
    curved = (a**3 - a) * second[span] + (b**3 - b) * second[span + 1]
    return np.asarray(a * eye[span] + b * eye[span + 1] + curved / 6.0)

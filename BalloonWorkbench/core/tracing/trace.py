# SPDX-License-Identifier: LGPL-2.1-or-later
"""The walk along the boundary with a circle of fixed radius, and the exact boundary between its steps.

The walk is that of the seed system: from the first boundary point P1 in a scan from the upper left, with
P0 = (P1x, P1y + n) (y down) inside the shape, clockwise on the circle of radius n around P_i to the next
crossing with the boundary, P_i+1, until |P_i - P1| < n. Where the circle meets other branches of the boundary
(thin arms, narrow notches), the crossing that is reached along the boundary is taken, so that no arm is cut
short.
"""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.geometry.normals import corners
from BalloonWorkbench.core.geometry.polyline import arc_lengths, perimeter, point_at, ring
from BalloonWorkbench.core.geometry.sampling import simplify, smooth, with_points_at
from BalloonWorkbench.core.types import Floats

#: Radius of the circle, relative to the longer side of the picture: 10 px of 1000.
STEP = 0.01
_OF_LENGTH = 1.0 / 24.0
_CORNER = np.radians(40.0)
_REACH = 4.0  # px along the boundary over which a corner shows, well above the steps of the pixels


def walk(boundary: Floats, radius: float) -> Floats:
    """Arc lengths (k,) along the closed boundary (n, 2) of the steps of the walk from its first point."""
    lengths = arc_lengths(boundary)
    total = float(lengths[-1])
    # A loop smaller than the circle is walked with a circle that goes round it in about a dozen steps.
    radius = min(radius, total / 12)
    round_twice = np.concatenate([boundary, ring(boundary)])
    at = np.concatenate([lengths[:-1], lengths + total])
    steps = [0.0]
    while True:
        here = point_at(boundary, lengths, np.array(steps[-1:]))[0]
        ahead = _leaves_circle(round_twice, at, steps[-1], here, radius)
        if ahead >= total - 0.5 * radius:
            return np.array(steps)
        steps.append(ahead)


def _leaves_circle(points: Floats, at: Floats, start: float, centre: Floats, radius: float) -> float:
    """Arc length after `start` where the chain first crosses the circle; inf if it stays inside."""
    k = int(np.searchsorted(at, start, side="right"))
    window = max(16, 4 * int(radius))
    while k < len(points):
        away = np.linalg.norm(points[k : k + window] - centre, axis=1)
        out = np.flatnonzero(away >= radius)
        if len(out):
            k += int(out[0])
            break
        k += window
    else:
        return np.inf
    low, high = points[k - 1], points[k]
    if at[k - 1] < start:
        low = centre
    along, offset = high - low, low - centre
    a, b, c = float(along @ along), float(along @ offset), float(offset @ offset) - radius**2
    t = (-b + np.sqrt(max(b * b - a * c, 0.0))) / a
    return float(at[k] - (1 - t) * np.sqrt(a))


def trace(boundary: Floats, radius: float, ripple: float = 1.0, tolerance: float = 0.2) -> Floats:
    """The closed boundary (n, 2) px as a loop with few points: those of the circle walk, and between them as
    many points of the boundary as keep the loop within `tolerance` of it.

    radius  of the circle [px]; 0 leaves the walk out, for a quick look
    ripple  width of the pixel noise that is smoothed away beforehand, away from corners [px]
    """
    # a small loop keeps its form
    ripple = min(ripple, max(1.0, _OF_LENGTH * perimeter(boundary)))
    if ripple > 0:
        boundary = smooth(boundary, ripple, corners(boundary, _CORNER, _REACH * max(1.0, ripple)))
    if radius <= 0:
        return simplify(boundary, tolerance)
    lengths = arc_lengths(boundary)
    steps = walk(boundary, radius)
    inserted, keep = with_points_at(boundary, lengths, steps)
    return simplify(inserted, tolerance, keep) if tolerance > 0 else boundary

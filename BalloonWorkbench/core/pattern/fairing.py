# SPDX-License-Identifier: LGPL-2.1-or-later
"""A seam without the scatter of its vertices: as even as it can be a few hundredths of a millimetre away.

Whittaker's smoothing with third differences (On a new method of graduation, Proc. Edinburgh Math. Soc. 41,
1922, 63-75) between corners, with weights raised where a point would move too far.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.types import Floats, Ints
from BalloonWorkbench.core.units import from_mm

#: How far a point may move: less than a cutter's blade is wide [m].
LIMIT = from_mm(0.05)
#: A corner turns by more between chords of this length, and keeps its place.
_REACH = from_mm(1.5)
_CORNER = np.radians(25.0)
_STIFFNESS = 1e4
_ROUNDS = 30
#: Share of the distance to its neighbours by which a point may move.
_SHARE = 0.25
#: Points that a loop without corners shares with itself at both ends.
_SHARED = 60
_THIRD = np.array([-1.0, 3.0, -3.0, 1.0])


def faired(loop: Floats) -> Floats:
    """The loop (n, 2) m with each point moved by at most LIMIT; corners stay where they are.

    Where two sides of a narrow tip would cross, less. Without scipy the loop itself.
    """
    for share in (1.0, 0.2):
        moved = _moved(loop, share * LIMIT)
        if shapely().Polygon(moved).is_valid:
            return moved
    return loop


def _moved(loop: Floats, limit: float) -> Floats:
    count = len(loop)
    if count < 8:
        return loop
    corners = _corners(loop)
    if not len(corners):
        shared = min(_SHARED, count)
        around = np.arange(-shared, count + shared) % count
        return _even(loop[around], limit)[shared : shared + count]
    closed = loop[(np.arange(count + 1) + corners[0]) % count]
    ends = np.append(corners - corners[0], count)
    moved = np.concatenate([_even(closed[low : high + 1], limit)[:-1] for low, high in pairwise(ends)])
    return np.roll(moved, corners[0], axis=0)


def _corners(loop: Floats) -> Ints:
    """Indices of the corners, none beside a sharper one."""
    steps = np.hypot(*(np.roll(loop, -1, axis=0) - loop).T)
    along = np.append(0.0, np.cumsum(steps))
    length = along[-1]
    around = np.concatenate([loop, loop, loop, loop[:1]])
    places = np.concatenate([along[:-1], along[:-1] + length, along + 2.0 * length])
    here = along[:-1] + length

    def at(where: Floats) -> Floats:
        return np.stack([np.interp(where, places, around[:, k]) for k in range(2)], axis=1)

    back, ahead = loop - at(here - _REACH), at(here + _REACH) - loop
    turn = np.abs(np.arctan2(back[:, 0] * ahead[:, 1] - back[:, 1] * ahead[:, 0], (back * ahead).sum(axis=1)))
    found: list[int] = []
    for index in np.argsort(-turn, kind="stable").tolist():
        if turn[index] < _CORNER:
            break
        away = np.abs(along[found] - along[index])
        if (np.minimum(away, length - away) > _REACH).all():
            found.append(index)
    return np.sort(np.array(found, dtype=np.int32))


def _even(points: Floats, limit: float) -> Floats:
    """Points (n, 2) between two corners, the first and the last in their places."""
    count = len(points)
    if count < 6:
        return points
    try:
        from scipy.linalg import solveh_banded
    except ImportError:
        return points
    steps = np.hypot(*np.diff(points, axis=0).T)
    limits = np.minimum(limit, _SHARE * np.minimum(np.append(steps, np.inf), np.append(np.inf, steps)))
    weights = np.ones(count)
    weights[[0, -1]] = 1e9
    bands = np.zeros((4, count))
    for apart in range(4):
        products = _STIFFNESS * _THIRD[: 4 - apart] * _THIRD[apart:]
        for k, product in enumerate(products):
            bands[3 - apart, apart + k : apart + k + count - 3] += product
    moved = points
    for _ in range(_ROUNDS):
        system = bands.copy()
        system[3] += weights
        moved = solveh_banded(system, weights[:, None] * points, check_finite=False)
        over = np.hypot(*(moved - points).T) / limits
        if over.max() <= 1.0:
            break
        weights *= np.maximum(over, 1.0) * np.where(over > 0.95, 1.15, 1.0)
    shift = moved - points
    shift[[0, -1]] = 0.0
    far = np.hypot(*shift.T)
    return points + shift * np.minimum(1.0, limits / np.maximum(far, 1e-12))[:, None]

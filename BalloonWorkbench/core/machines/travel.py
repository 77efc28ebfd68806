# SPDX-License-Identifier: LGPL-2.1-or-later
"""A short way of a tool from one piece of work to the next.

Nearest first, then 2-opt (Croes, A method for solving traveling-salesman problems, Operations Research 6,
1958, 791-812) and pieces of work moved to where they lie on the way, until neither makes it shorter.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.checkpoint import checkpoint
from BalloonWorkbench.core.types import Floats

Indices = NDArray[np.intp]

#: So many pieces of work stay nearest first: that many changes take too long to try.
_MOST = 400
#: The longest row of pieces of work that is moved as a whole.
_ROW = 3
#: A way is shorter when it is so by more than this part: rounding decides nothing.
_SHORTER = 1e-9
_DIGITS = 9


def shortest_order(begins: Floats, ends: Floats, start: Floats, finish: Floats | None = None) -> list[int]:
    """In which order to do what begins at (n, 2) and ends at (n, 2), from a start (2,) to a finish (2,).

    A way without a finish may end anywhere. Of what is equally near the first comes first.
    """
    far = _distances(begins, ends, start, finish)
    nearest = _nearest_first(far)
    if len(nearest) > _MOST:
        return nearest
    ways = [_improved(order, far) for order in (nearest, nearest[::-1], range(len(begins)))]
    return min(ways, key=lambda way: round(float(far[way[:-1], way[1:]].sum()), _DIGITS))[1:-1].tolist()


def travel(begins: Floats, ends: Floats) -> float:
    """The way between what is done in this order, from each end (n, 2) to the next begin (n, 2)."""
    return float(np.linalg.norm(begins[1:] - ends[:-1], axis=1).sum())


def _distances(begins: Floats, ends: Floats, start: Floats, finish: Floats | None) -> Floats:
    """How far it is (n + 2, n + 2) from the end of each to the begin of each; the last: start, finish."""
    count = len(begins)
    far = np.zeros((count + 2, count + 2))
    leaving = np.concatenate([ends, start[None]])
    far[: count + 1, :count] = np.linalg.norm(leaving[:, None] - begins, axis=2)
    if finish is not None:
        far[: count + 1, count + 1] = np.linalg.norm(leaving - finish, axis=1)
    return far


def _nearest_first(far: Floats) -> list[int]:
    count = len(far) - 2
    left, at, order = np.arange(count), count, []
    while len(left):
        which = int(np.argmin(far[at, left]))
        at = int(left[which])
        order.append(at)
        left = np.delete(left, which)
    return order


def _improved(order: Iterable[int], far: Floats) -> Indices:
    """The way from the start to the finish, as short as both changes make it."""
    count = len(far) - 2
    way = np.array([count, *order, count + 1])
    least = _SHORTER * float(far.max())
    while True:
        checkpoint()
        other = _turned(way, far, least)
        other = _moved(way, far, least) if other is None else other
        if other is None:
            return way
        way = other


def _turned(way: Indices, far: Floats, least: float) -> Indices | None:
    """The way with the part turned round that gains most; None where none does."""
    forward = np.append(0.0, np.cumsum(far[way[:-1], way[1:]]))
    backward = np.append(0.0, np.cumsum(far[way[1:], way[:-1]]))
    best, where = least, None
    for first in range(1, len(way) - 2):
        last = np.arange(first + 1, len(way) - 1)
        before, after = way[first - 1], way[last + 1]
        old = forward[last + 1] - forward[first - 1]
        new = far[before, way[last]] + backward[last] - backward[first] + far[way[first], after]
        gain = old - new
        most = int(np.argmax(gain))
        if gain[most] > best:
            best, where = float(gain[most]), (first, int(last[most]))
    if where is None:
        return None
    first, end = where
    return np.concatenate([way[:first], way[first : end + 1][::-1], way[end + 1 :]])


def _moved(way: Indices, far: Floats, least: float) -> Indices | None:
    """The way with a short row of it done elsewhere where that gains most; None where nothing does."""
    best, found = least, None
    for length in range(1, _ROW + 1):
        for first in range(1, len(way) - length):
            row, rest = way[first : first + length], np.delete(way, np.s_[first : first + length])
            saved = (
                far[way[first - 1], row[0]]
                + far[row[-1], way[first + length]]
                - far[way[first - 1], way[first + length]]
            )
            gain = saved - (far[rest[:-1], row[0]] + far[row[-1], rest[1:]] - far[rest[:-1], rest[1:]])
            most = int(np.argmax(gain))
            if gain[most] > best:
                best, found = float(gain[most]), np.insert(rest, most + 1, row)
    return found

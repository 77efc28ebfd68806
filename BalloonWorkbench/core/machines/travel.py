# SPDX-License-Identifier: LGPL-2.1-or-later
"""A short way of a tool from one piece of work to the next.

Nearest first, as they are, from left to right or upward; from each of these 2-opt (Croes, A method for
solving traveling-salesman problems, Operations Research 6, 1958, 791-812) and pieces of work moved to where
they lie on the way, until neither makes it shorter.
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
#: Of so few the search begins with each.
_FEW = 30
#: The longest row of pieces of work that is moved as a whole.
_ROW = 3
#: A way is shorter when it is so by more than this part: rounding decides nothing.
_SHORTER = 1e-9
_DIGITS = 6  # the same on each processor


def shortest_order(begins: Floats, ends: Floats, start: Floats, finish: Floats | None = None) -> list[int]:
    """In which order to do what begins at (n, 2) and ends at (n, 2), from a start (2,) to a finish (2,).

    A way without a finish may end anywhere. Of what is equally near the first comes first.
    """
    far = _distances(begins, ends, start, finish)
    nearest = _nearest_first(far)
    if len(nearest) > _MOST:
        return nearest
    places = np.round(begins, _DIGITS)
    right, up = (np.argsort(places[:, axis], kind="stable").tolist() for axis in (0, 1))
    orders = [each[::step] for each in (nearest, [*range(len(begins))], right, up) for step in (1, -1)]
    if len(nearest) <= _FEW:
        orders += [nearest[begin:] + nearest[:begin] for begin in range(1, len(nearest))]
    ways = [_improved(order, far) for order in orders]
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
    return np.round(far, _DIGITS)


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
    way, before = np.array([count, *order, count + 1]), np.inf
    least = _SHORTER * float(far.max())
    while (length := float(far[way[:-1], way[1:]].sum())) < before - least:
        checkpoint()
        before = length
        way = _moved(_turned(way, far, least), far, least)
    return way


def _turned(way: Indices, far: Floats, least: float) -> Indices:
    """The way with parts turned round: from each place the one that gains most."""
    for first in range(1, len(way) - 2):
        forward = np.append(0.0, np.cumsum(far[way[:-1], way[1:]]))
        backward = np.append(0.0, np.cumsum(far[way[1:], way[:-1]]))
        last = np.arange(first + 1, len(way) - 1)
        old = forward[last + 1] - forward[first - 1]
        new = (
            far[way[first - 1], way[last]] + backward[last] - backward[first] + far[way[first], way[last + 1]]
        )
        most = int(np.argmax(old - new))
        if old[most] - new[most] > least:
            end = int(last[most]) + 1
            way = np.concatenate([way[:first], way[first:end][::-1], way[end:]])
    return way


def _moved(way: Indices, far: Floats, least: float) -> Indices:
    """The way with short rows of it done elsewhere, each where that gains most."""
    for length in range(1, _ROW + 1):
        for first in range(1, len(way) - length):
            before, row, after = way[first - 1], way[first : first + length], way[first + length]
            rest = np.delete(way, np.s_[first : first + length])
            saved = far[before, row[0]] + far[row[-1], after] - far[before, after]
            gain = saved - (far[rest[:-1], row[0]] + far[row[-1], rest[1:]] - far[rest[:-1], rest[1:]])
            most = int(np.argmax(gain))
            if gain[most] > least:
                way = np.insert(rest, most + 1, row)
    return way

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where closed loops and open lines cross or touch themselves or each other."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.types import Floats

# Pairs of segments compared at once: keeps the memory of a loop of 20 000 points below 100 MB.
_CHUNK = 1_000_000


def first_crossing(loops: Sequence[Floats], lines: Sequence[Floats] = ()) -> Floats | None:
    """A point (2,) where two segments of closed loops or open lines (n, 2) meet that should not, or None.

    Segments may share an end with their neighbour in the same loop; any other contact counts, also touching.
    """
    start = np.concatenate([*loops, *(line[:-1] for line in lines)])
    end = np.concatenate([*(np.roll(loop, -1, axis=0) for loop in loops), *(line[1:] for line in lines)])
    following = np.concatenate(
        [
            *(
                offset + np.roll(np.arange(len(loop)), -1)
                for loop, offset in zip(loops, _offsets(loops), strict=True)
            ),
            *(
                offset + np.append(np.arange(1, len(line) - 1), -1 - offset)
                for line, offset in zip(lines, sum(map(len, loops)) + _offsets([n[1:] for n in lines]))
            ),
        ]
    )
    for near, other in _candidates(start, end):
        apart = (following[near] != other) & (following[other] != near)
        one, two = near[apart], other[apart]
        meet = _meet(start[one], end[one], start[two], end[two])
        if meet.any():
            k = int(np.argmax(meet))
            return _where(start[one[k]], end[one[k]], start[two[k]], end[two[k]])
    return None


def _offsets(loops: Sequence[Floats]) -> NDArray[np.intp]:
    return np.cumsum([0, *(len(loop) for loop in loops[:-1])], dtype=np.intp)


def _candidates(start: Floats, end: Floats) -> Iterator[tuple[NDArray[np.intp], NDArray[np.intp]]]:
    """Pairs of segments whose bounding boxes overlap, found in the order of their left ends."""
    low, high = np.minimum(start, end), np.maximum(start, end)
    order = np.argsort(low[:, 0], kind="stable")
    last = np.searchsorted(low[order, 0], high[order, 0], side="right")
    counts = last - np.arange(len(order)) - 1
    first = 0
    while first < len(order):
        total = np.cumsum(counts[first:])
        stop = first + max(1, int(np.searchsorted(total, _CHUNK)))
        repeats = counts[first:stop]
        left = np.repeat(np.arange(first, first + len(repeats)), repeats)
        ramp = np.arange(len(left)) - np.repeat(np.cumsum(repeats) - repeats, repeats)
        one, two = order[left], order[left + 1 + ramp]
        near = (low[one, 1] <= high[two, 1]) & (low[two, 1] <= high[one, 1])
        yield one[near], two[near]
        first = stop


def _side(a: Floats, b: Floats, c: Floats) -> NDArray[np.int8]:
    """Side of c seen from a towards b: 1 left, -1 right, 0 on the line within rounding."""
    ab, ac = b - a, c - a
    cross = ab[:, 0] * ac[:, 1] - ab[:, 1] * ac[:, 0]
    scale = np.abs(ab[:, 0] * ac[:, 1]) + np.abs(ab[:, 1] * ac[:, 0])
    return np.where(np.abs(cross) <= 1e-12 * scale, 0, np.sign(cross)).astype(np.int8)


def _meet(a: Floats, b: Floats, c: Floats, d: Floats) -> NDArray[np.bool_]:
    """Whether segments ab and cd have a point in common, given that their bounding boxes overlap."""
    return (_side(a, b, c) * _side(a, b, d) <= 0) & (_side(c, d, a) * _side(c, d, b) <= 0)


def _where(a: Floats, b: Floats, c: Floats, d: Floats) -> Floats:
    """The common point of two segments that meet; the middle of the overlap where they are parallel."""
    ab, cd = b - a, d - c
    cross = float(ab[0] * cd[1] - ab[1] * cd[0])
    if abs(cross) > 1e-12 * float(np.linalg.norm(ab) * np.linalg.norm(cd)):
        t = float((c - a)[0] * cd[1] - (c - a)[1] * cd[0]) / cross
        return np.asarray(a + t * ab)
    along = sorted((a, b, c, d), key=lambda point: float(point @ ab))
    return np.asarray(0.5 * (along[1] + along[2]))


def contains(loop: Floats, points: Floats) -> NDArray[np.bool_]:
    """Which points (k, 2) lie inside the closed loop (n, 2); even-odd rule."""
    inside = np.zeros(len(points), dtype=np.bool_)
    for (x1, y1), (x2, y2) in zip(loop, np.roll(loop, -1, axis=0), strict=True):
        if y1 == y2:
            continue
        spans = (y1 > points[:, 1]) != (y2 > points[:, 1])
        inside ^= spans & (points[:, 0] < (x2 - x1) * (points[:, 1] - y1) / (y2 - y1) + x1)
    return inside

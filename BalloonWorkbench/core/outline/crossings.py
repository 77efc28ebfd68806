# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where closed loops and open lines cross or touch themselves or each other."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.outline.budget import Budget
from BalloonWorkbench.core.types import Floats

# Pairs of segments compared at once: keeps the memory of a loop of 20 000 points below 100 MB.
_CHUNK = 1_000_000


def first_crossing(
    loops: Sequence[Floats], lines: Sequence[Floats] = (), budget: Budget | None = None
) -> Floats | None:
    """A point (2,) where two segments of closed loops or open lines (n, 2) meet that should not, or None.

    Segments may share an end with their neighbour in the same loop; any other contact counts, also touching.

    budget  of reading the drawing, whose time this takes
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
    for near, other in box_pairs(np.minimum(start, end), np.maximum(start, end), budget):
        apart = (following[near] != other) & (following[other] != near)
        one, two = near[apart], other[apart]
        meet = _meet(start[one], end[one], start[two], end[two])
        if meet.any():
            k = int(np.argmax(meet))
            return _where(start[one[k]], end[one[k]], start[two[k]], end[two[k]])
    return None


def _offsets(loops: Sequence[Floats]) -> NDArray[np.intp]:
    return np.cumsum([0, *(len(loop) for loop in loops[:-1])], dtype=np.intp)


def box_pairs(
    low: Floats, high: Floats, budget: Budget | None = None
) -> Iterator[tuple[NDArray[np.intp], NDArray[np.intp]]]:
    """Pairs of overlapping boxes, each once, from their corners (n, 2): in the order of their left sides.

    Where very many lie above each other, they are compared strip by strip.
    """
    own = np.arange(len(low))
    strip = np.zeros(len(low), dtype=np.intp)
    left, right = low[:, 0], high[:, 0]
    count = _strips(low, high)
    if count > 1:
        bottom, height = low[:, 1].min(), np.ptp(np.concatenate([low[:, 1], high[:, 1]])) / count
        first, last = (((side[:, 1] - bottom) / height).astype(np.intp) for side in (low, high))
        own = np.repeat(own, last - first + 1)
        strip = first[own] + _ramp(last - first + 1)
        # all of a strip before all of the next one
        width = 2.0 * float(np.ptp(np.concatenate([left, right]))) + 1e-300
        left, right = (strip * width + (side[own] - left.min()) for side in (left, right))
    order = np.argsort(left, kind="stable")
    counts = np.searchsorted(left[order], right[order], side="right") - np.arange(len(order)) - 1
    for begin, end in _chunks(counts):
        if budget is not None:
            budget.check_time()
        repeats = counts[begin:end]
        before = np.repeat(np.arange(begin, end), repeats)
        here, there = order[before], order[before + 1 + _ramp(repeats)]
        one, two = own[here], own[there]
        near = (low[one, 1] <= high[two, 1]) & (low[two, 1] <= high[one, 1])
        if count > 1:
            near &= (low[one, 0] <= high[two, 0]) & (low[two, 0] <= high[one, 0])
            # a pair that lies in several strips counts in the first of them
            near &= strip[here] == np.maximum(first[one], first[two])
        yield one[near], two[near]


def _strips(low: Floats, high: Floats) -> int:
    """Number of horizontal strips in which to compare boxes: one where that is soon done."""
    left = np.sort(low[:, 0])
    pairs = int((np.searchsorted(left, high[:, 0], side="right")).sum()) - len(low) * (len(low) + 1) // 2
    if pairs <= 4 * _CHUNK:
        return 1
    heights = high[:, 1] - low[:, 1]
    tall = float(heights.sum())
    total = float(high[:, 1].max() - low[:, 1].min())
    # as many as leave a box in four strips on average
    return 1 if total <= 0.0 else int(min(len(low), 3.0 * len(low) * total / max(tall, 1e-9 * total)))


def _chunks(counts: NDArray[np.intp]) -> Iterator[tuple[int, int]]:
    """Ranges of rows, one after the other, of about _CHUNK counts altogether, or of a single row."""
    total = np.concatenate([[0], np.cumsum(counts)])
    first = 0
    while first < len(counts):
        last = first + max(1, int(np.searchsorted(total[first + 1 :], total[first] + _CHUNK)))
        yield first, min(last, len(counts))
        first = last


def _ramp(counts: NDArray[np.intp]) -> NDArray[np.intp]:
    """0, 1, 2, ... for each of the counts."""
    return np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts)


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
    start, end = loop, np.roll(loop, -1, axis=0)
    order = np.argsort(points[:, 1], kind="stable")
    heights = points[order, 1]
    # each segment is compared with the points at its height only
    first = np.searchsorted(heights, np.minimum(start[:, 1], end[:, 1]))
    counts = np.searchsorted(heights, np.maximum(start[:, 1], end[:, 1])) - first
    crossed = np.zeros(len(points), dtype=np.intp)
    for begin, stop in _chunks(counts):
        repeats = counts[begin:stop]
        segment = np.repeat(np.arange(begin, stop), repeats)
        point = order[first[segment] + _ramp(repeats)]
        (x1, y1), (x2, y2) = start[segment].T, end[segment].T
        x, y = points[point].T
        crossed += np.bincount(point[x < (x2 - x1) * (y - y1) / (y2 - y1) + x1], minlength=len(points))
    return crossed % 2 == 1

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where closed loops and open lines cross or touch, which boxes overlap, what lies inside.

Ours, not shapely's: it must work where shapely is missing, give the first place, and ask on the way whether
to go on.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.geometry.polyline import ring
from BalloonWorkbench.core.geometry.vectors import cross
from BalloonWorkbench.core.types import Floats, Ints

# Pairs of edges compared at once: keeps the memory of a loop of 20 000 points below 100 MB.
_CHUNK = 1_000_000


def _go_on() -> None:
    """Never end the search."""


def first_crossing(
    loops: Sequence[Floats], lines: Sequence[Floats] = (), check: Callable[[], None] = _go_on
) -> Floats | None:
    """A point (2,) where two edges of closed loops or open lines (n, 2) meet that should not, or None.

    Edges may share an end with their neighbour in the same loop; any other contact counts, also touching.

    check  is called now and then; what it raises ends the search
    """
    chains = [*map(ring, loops), *(line for line in lines if len(line) > 1)]
    start, end = (np.concatenate([chain[part] for chain in chains]) for part in (slice(-1), slice(1, None)))
    stops = np.cumsum([len(chain) - 1 for chain in chains])
    following = np.arange(1, len(start) + 1)
    following[stops - 1] = -1
    for loop, stop in zip(loops, stops):
        following[stop - 1] = stop - len(loop)
    for near, other in box_pairs(np.minimum(start, end), np.maximum(start, end), check):
        apart = (following[near] != other) & (following[other] != near)
        one, two = near[apart], other[apart]
        meet = _meet(start[one], end[one], start[two], end[two])
        if meet.any():
            k = int(np.argmax(meet))
            return _where(start[one[k]], end[one[k]], start[two[k]], end[two[k]])
    return None


def box_pairs(
    low: Floats, high: Floats, check: Callable[[], None] = _go_on
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
        check()
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
    side = cross(ab, ac)
    scale = np.abs(ab[:, 0] * ac[:, 1]) + np.abs(ab[:, 1] * ac[:, 0])
    return np.where(np.abs(side) <= 1e-12 * scale, 0, np.sign(side)).astype(np.int8)


def _meet(a: Floats, b: Floats, c: Floats, d: Floats) -> NDArray[np.bool_]:
    """Whether edges ab and cd have a point in common, given that their bounding boxes overlap."""
    return (_side(a, b, c) * _side(a, b, d) <= 0) & (_side(c, d, a) * _side(c, d, b) <= 0)


def _where(a: Floats, b: Floats, c: Floats, d: Floats) -> Floats:
    """The common point of two edges that meet; the middle of the overlap where they are parallel."""
    ab, cd = b - a, d - c
    across = float(cross(ab, cd))
    if abs(across) > 1e-12 * float(np.linalg.norm(ab) * np.linalg.norm(cd)):
        return np.asarray(a + float(cross(c - a, cd)) / across * ab)
    along = sorted((a, b, c, d), key=lambda point: float(point @ ab))
    return np.asarray(0.5 * (along[1] + along[2]))


def contains(loop: Floats, points: Floats) -> NDArray[np.bool_]:
    """Which points (k, 2) lie inside the closed loop (n, 2); even-odd rule."""
    return inside([loop], points)


def inside(loops: Sequence[Floats], points: Floats) -> NDArray[np.bool_]:
    """Which points (k, 2) lie inside an odd number of closed loops (n, 2)."""
    start = np.concatenate(loops)
    end = np.concatenate([np.roll(loop, -1, axis=0) for loop in loops])
    order = np.argsort(points[:, 1], kind="stable")
    heights = points[order, 1]
    # each edge is compared with the points at its height only
    first = np.searchsorted(heights, np.minimum(start[:, 1], end[:, 1]))
    counts = np.searchsorted(heights, np.maximum(start[:, 1], end[:, 1])) - first
    crossed = np.zeros(len(points), dtype=np.intp)
    for begin, stop in _chunks(counts):
        repeats = counts[begin:stop]
        edge = np.repeat(np.arange(begin, stop), repeats)
        point = order[first[edge] + _ramp(repeats)]
        (x1, y1), (x2, y2) = start[edge].T, end[edge].T
        x, y = points[point].T
        crossed += np.bincount(point[x < (x2 - x1) * (y - y1) / (y2 - y1) + x1], minlength=len(points))
    return crossed % 2 == 1


def crossed_at(loop: Floats, height: float) -> Floats:
    """Where (k,) in x the closed loop (n, 2) crosses a height."""
    x0, y0 = loop.T
    x1, y1 = np.roll(loop, -1, axis=0).T
    over = (y0 > height) != (y1 > height)
    return np.asarray(x0[over] + (height - y0[over]) / (y1[over] - y0[over]) * (x1[over] - x0[over]))


def winding(starts: Floats, ends: Floats, points: Floats) -> Ints:
    """How often directed edges (k, 2), (k, 2) that make closed loops go round points (n, 2), each: (n,)."""
    y, (y1, y2) = points[:, 1, None], (starts[:, 1], ends[:, 1])
    rising, falling = (y1 <= y) & (y < y2), (y2 <= y) & (y < y1)
    left = cross(ends - starts, points[:, None] - starts)  # where the point is left of the edge's line
    turns = (rising & (left > 0.0)).astype(np.int32) - (falling & (left < 0.0)).astype(np.int32)
    return np.asarray(turns.sum(axis=1), dtype=np.int32)

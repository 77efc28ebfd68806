# SPDX-License-Identifier: LGPL-2.1-or-later
"""Loops without repeated points and without spikes."""

from __future__ import annotations

import math

import numpy as np

from BalloonWorkbench.core.geometry.polyline import edge_lengths, edge_vectors
from BalloonWorkbench.core.geometry.vectors import cross
from BalloonWorkbench.core.types import Floats


def clean(loop: Floats, tolerance: float) -> Floats:
    """The closed loop (n, 2) without repeated points and without spikes that run out and back on one line.

    tolerance  distance at which two points following each other are one [unit of the loop]
    """
    loop = _distinct(np.asarray(loop, dtype=np.float64).reshape(-1, 2), tolerance)
    if len(loop) < 3:
        return loop
    after = edge_vectors(loop)
    before = np.roll(after, 1, axis=0)
    lengths = np.linalg.norm(after, axis=1)
    aside = np.abs(cross(before, after))
    longer = np.maximum(lengths, np.roll(lengths, 1))
    spike = ((before * after).sum(axis=1) < 0) & (aside <= tolerance * longer)
    return _without_spikes(loop, tolerance, int(np.argmax(spike))) if spike.any() else loop


def _without_spikes(loop: Floats, tolerance: float, first: int) -> Floats:
    """The loop without its spikes, from the first one on.

    One at a time: without its tip, the feet of a spike may be the same point, or tips themselves. Only they
    are looked at again.
    """
    points = loop.tolist()
    count = len(points)
    before, after = [count - 1, *range(count - 1)], [*range(1, count), 0]
    here, unchanged = first, 0
    while count > 2 and unchanged < count:
        back, ahead = before[here], after[here]
        if math.dist(points[back], points[here]) <= tolerance:
            gone = max(back, here)
        elif _is_tip(points[back], points[here], points[ahead], tolerance):
            gone = here
        else:
            here, unchanged = ahead, unchanged + 1
            continue
        back, ahead = before[gone], after[gone]
        after[back], before[ahead] = ahead, back
        here, unchanged, count = back, 0, count - 1
    visited = {here}
    while (here := after[here]) not in visited:
        visited.add(here)
    return np.asarray(loop[sorted(visited)])


def _is_tip(back: list[float], tip: list[float], ahead: list[float], tolerance: float) -> bool:
    """Whether the way from `back` over `tip` to `ahead` goes out and back on one line."""
    x, y, u, v = tip[0] - back[0], tip[1] - back[1], ahead[0] - tip[0], ahead[1] - tip[1]
    return x * u + y * v < 0 and abs(x * v - y * u) <= tolerance * max(math.hypot(x, y), math.hypot(u, v))


def _distinct(loop: Floats, tolerance: float) -> Floats:
    if (edge_lengths(loop) > tolerance).all():
        return loop
    distinct, points = [0], loop.tolist()
    for k in range(1, len(loop)):
        if math.dist(points[k], points[distinct[-1]]) > tolerance:
            distinct.append(k)
    while len(distinct) > 1 and np.linalg.norm(loop[distinct[-1]] - loop[0]) <= tolerance:
        distinct.pop()
    return np.asarray(loop[distinct])

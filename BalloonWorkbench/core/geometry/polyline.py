# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lengths along loops and lines, places at a length, and what a loop encloses."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from BalloonWorkbench.core.geometry.vectors import cross
from BalloonWorkbench.core.types import Floats


def ring(loop: Floats, closed: bool = True) -> Floats:
    """The closed loop (n, d) as a line (n + 1, d) that ends at its first point; an open one as it is."""
    return np.concatenate([loop, loop[:1]]) if closed else loop


def edge_vectors(loop: Floats) -> Floats:
    """From each point of the closed loop (n, d) to the next one: (n, d)."""
    return np.asarray(np.roll(loop, -1, axis=0) - loop)


def edge_lengths(loop: Floats) -> Floats:
    """Distance from each point of the closed loop (n, d) to the next one: (n,)."""
    return np.asarray(np.linalg.norm(edge_vectors(loop), axis=1))


def perimeter(loop: Floats) -> float:
    """Length once round the closed loop (n, d)."""
    return float(edge_lengths(loop).sum())


def length(line: Floats) -> float:
    """Length of the open line (n, d)."""
    return float(np.linalg.norm(np.diff(line, axis=0), axis=1).sum())


def arc_lengths(loop: Floats) -> Floats:
    """Length along the closed loop (n, d) up to each point, and at last all the way round: (n + 1,)."""
    return np.concatenate([[0.0], np.cumsum(edge_lengths(loop))])


def line_lengths(line: Floats) -> Floats:
    """Length along the open line (n, d) up to each point: (n,)."""
    return np.append(0.0, np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1)))


def point_at(loop: Floats, lengths: Floats, at: Floats) -> Floats:
    """Points (k, d) of the closed loop at arc lengths `at` (k,), which may run past the start.

    lengths  what `arc_lengths(loop)` gives, or another measure that grows along the loop, as of another curve
    """
    return point_on(ring(loop), lengths, np.mod(at, lengths[-1]))


def point_on(line: Floats, lengths: Floats, at: Floats) -> Floats:
    """Points (k, d) of the open line at lengths `at` (k,); `lengths` is what `line_lengths(line)` gives."""
    return np.column_stack([np.interp(at, lengths, part) for part in line.T])


def gaps(one: Floats, other: Floats, around: Floats | float) -> Floats:
    """The shorter way (...) between arc lengths along closed loops that are so long."""
    gap = np.abs(one - other)
    return np.minimum(gap, around - gap)


def part_of(line: Floats, start: float, end: float) -> Floats:
    """The part (k, d) of an open line from one length along it to another."""
    lengths = line_lengths(line)
    first, last = point_on(line, lengths, np.array([start, end]))
    hair = 1e-9 * lengths[-1]
    inner = line[(lengths > start + hair) & (lengths < end - hair)]
    return np.concatenate([first[None], inner, last[None]])


def point_weights(loop: Floats) -> Floats:
    """Length of the closed loop (n, d) that belongs to each of its points, half of both edges: (n,)."""
    lengths = edge_lengths(loop)
    return 0.5 * (lengths + np.roll(lengths, 1))


def signed_area(loop: Floats) -> float:
    """Area inside a closed loop (n, 2), positive when it runs counter-clockwise."""
    x, y = loop.T
    return 0.5 * float(np.dot(x, np.roll(y, -1)) - np.dot(np.roll(x, -1), y))


def oriented(loop: Floats, counter_clockwise: bool = True) -> Floats:
    """The closed loop (n, 2) run through counter-clockwise, or clockwise."""
    return loop if (signed_area(loop) > 0.0) == counter_clockwise else np.ascontiguousarray(loop[::-1])


def centroid(loops: Sequence[Floats]) -> Floats:
    """Centre of area (2,) of closed loops (n, 2); those that run clockwise are holes."""
    moment = np.zeros(2)
    origin = loops[0].mean(axis=0)
    for loop in loops:
        here = loop - origin
        ahead = np.roll(here, -1, axis=0)
        moment += (cross(here, ahead)[:, None] * (here + ahead)).sum(axis=0) / 6.0
    return np.asarray(origin + moment / sum(signed_area(loop) for loop in loops))


def bounds(points: Floats) -> tuple[Floats, Floats]:
    """Lower and upper corner (d,) of the bounding box of points (n, d)."""
    return points.min(axis=0), points.max(axis=0)


def extent(points: Floats) -> float:
    """The largest side of the bounding box of points (n, d)."""
    return float(np.ptp(points, axis=0).max())

# SPDX-License-Identifier: LGPL-2.1-or-later
"""A polyline taken apart into what is meant to be straight, and the bent stretches between corners."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from BalloonWorkbench.core.geometry.normals import turns
from BalloonWorkbench.core.geometry.polyline import edge_vectors, line_lengths, point_on, ring
from BalloonWorkbench.core.geometry.vectors import cross, norm, turn
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.types import Bools, Floats

#: A vertex that turns by more is a corner [rad].
CORNER = np.radians(25.0)
#: An edge so many times as long as those beside it is meant to be straight, not a chord.
_LONGER = 10.0
#: The same when the arc that would follow from its ends rises by so many tolerances.
_RISE = 5.0
#: Points that are so near to the line between others say nothing [m].
_STRAIGHT = 1e-8


@dataclass(frozen=True)
class Stretch:
    """Points (n, 2) m without a corner between.

    first, last  heading [rad] at the ends, None where it is free because a corner is there
    straight     it is one straight edge
    """

    points: Floats
    first: float | None
    last: float | None
    straight: bool


def stretches(points: Floats, closed: bool, tolerance: float) -> tuple[Stretch, ...]:
    """The stretches of a polyline (n, 2) m in their order; a closed one begins at a corner if it has one."""
    points = _without_needless(points, closed)
    if len(points) < 3:
        return (Stretch(points, None, None, True),)
    corner, straight = _marks(points, closed, tolerance)
    edges = len(points) if closed else len(points) - 1
    knots = corner.copy()
    knots[:edges] |= straight
    knots |= np.roll(np.append(straight, np.zeros(len(points) - edges, dtype=bool)), 1)
    if closed and not knots.any():
        half = len(points) // 2
        heading = heading_at(np.roll(points, half, axis=0), half, tolerance)
        return (Stretch(ring(points), heading, heading, False),)
    if closed:
        begin = int(np.flatnonzero(corner if corner.any() else knots)[0])
        around = np.arange(begin, begin + len(points) + 1) % len(points)
        points, corner, knots = points[around], corner[around], knots[around]
        straight = straight[around[:-1]]
    chords = np.diff(points, axis=0)
    headings = np.arctan2(chords[:, 1], chords[:, 0])
    pieces = []
    for low, high in pairwise(np.flatnonzero(knots)):
        # where no corner is, a straight edge lies on the other side
        first = None if corner[low] else float(headings[low - 1])
        last = None if corner[high] else float(headings[high % len(headings)])
        pieces.append(Stretch(points[low : high + 1], first, last, bool(high == low + 1 and straight[low])))
    return tuple(pieces)


def _without_needless(points: Floats, closed: bool) -> Floats:
    """Without repeated points and without those amid a straight line."""
    steps = np.diff(ring(points, closed), axis=0)
    distinct = norm(steps) > 1e-9
    points = points[distinct if closed else np.append(True, distinct)]
    if len(points) < 3:
        return points
    points = np.asarray(shapely().LineString(ring(points, closed)).simplify(_STRAIGHT).coords)
    if not closed:
        return points
    points = points[:-1]
    back, ahead = points[0] - points[-1], points[1] - points[0]
    across = abs(cross(back, ahead))
    needed = across > _STRAIGHT * np.hypot(*(back + ahead)) or back @ ahead < 0.0
    return points if needed else points[1:]


def _marks(points: Floats, closed: bool, tolerance: float) -> tuple[Bools, Bools]:
    """Which vertices are corners, and which edges are straight."""
    ahead = edge_vectors(points)
    lengths = norm(ahead)
    bend = np.abs(turn(np.roll(ahead, 1, axis=0), ahead))
    corner = (bend > CORNER) & (np.abs(_wide_turn(points, closed, 10.0 * tolerance)) > CORNER)
    if not closed:
        corner[[0, -1]] = True
        ahead, lengths = ahead[:-1], lengths[:-1]
    edges = len(lengths)
    after = np.roll(np.arange(len(points)), -1)[:edges]
    before = np.where(corner[:edges], 0.0, np.roll(lengths, 1))
    beyond = np.where(corner[after], 0.0, np.roll(lengths, -1))
    rise = 0.125 * lengths * np.maximum((bend * ~corner)[:edges], (bend * ~corner)[after])
    longer = (lengths > _LONGER * np.maximum(before, beyond)) & (lengths > 20.0 * tolerance)
    straight = longer | (rise > _RISE * tolerance) | (corner[:edges] & corner[after])
    # an edge alone between corners and straight edges tells of no bend
    ends = corner | _either_side(straight, closed)
    straight |= ends[:edges] & ends[after]
    # a vertex between two straight edges is a corner that somebody meant
    around = straight if closed else np.append(straight, False)
    return corner | (around & np.roll(around, 1)), straight


def _either_side(edges: Bools, closed: bool) -> Bools:
    """Which vertices are ends of marked edges."""
    after = edges if closed else np.append(edges, False)
    return after | np.roll(after, 1)


def _wide_turn(points: Floats, closed: bool, reach: float) -> Floats:
    """Turning (n,) from the chord of some length that ends at each vertex to the one that begins there."""
    if closed:
        return turns(points, reach)
    along = line_lengths(points)
    before, after = (point_on(points, along, along + way) for way in (-reach, reach))
    return turn(points - before, after - points)


def heading_at(points: Floats, index: int, tolerance: float) -> float:
    """Heading [rad] at a point amid others (n, 2), by the widest circle through it that fits around it."""
    for reach in range(max(min(index, len(points) - 1 - index, len(points) // 6), 1), 0, -1):
        three = points[[index - reach, index, index + reach]]
        back, ahead = three[1] - three[0], three[2] - three[1]
        # the tangent of the circle through three points, at the middle one
        tangent = back / (back @ back) + ahead / (ahead @ ahead)
        tangent /= np.hypot(tangent[0], tangent[1])
        away = points[index - reach : index + reach + 1] - three[1]
        square = (away * away).sum(axis=1)
        beside = away[:, 1] * tangent[0] - away[:, 0] * tangent[1]
        bend = 2.0 * beside[-1] / square[-1]
        excess = bend * square - 2.0 * beside
        off = np.abs(excess) / (1.0 + np.sqrt(np.maximum(1.0 + bend * excess, 0.0)))
        if off.max() < 0.25 * tolerance:
            break
    return float(np.arctan2(tangent[1], tangent[0]))

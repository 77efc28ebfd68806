# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fewest arcs, smooth where they meet, that stay within a tolerance of a polyline.

Along the polyline let g be the integral of its heading, f that of the curve's heading. A curve of arcs
makes f a chain of parabolas with equal slopes where they meet; f - g is its distance from the polyline up
to terms that a later exact check covers. From one state (place, distance, heading) the curvatures of an arc
that stays inside the tolerance up to a place are an interval, the intersection of those for each sample.

The search runs from the start with the best states after one arc, two arcs and so on until the end is in
reach: the tolerance channel of Drysdale, Rote and Sturm, Approximation of an open polygonal curve with a
minimum number of circular arcs and biarcs, Computational Geometry 41 (2008) 31-47, with a beam of states.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.types import Bools, Floats

Indices = NDArray[np.int64]

#: No arc turns by more [rad].
_MOST_TURN = 2.0
#: States kept after each arc, and of those for one place; where arcs may end on the way that they can reach;
#: curvatures tried for each such place.
_BEAM = 20
_PER_PLACE = 4
_BREAKS = np.array([1.0, 0.96, 0.92, 0.86, 0.8, 0.7, 0.6, 0.4])
_CURVATURES = np.array([0.08, 0.5, 0.92])
#: Share of the tolerance by which an arc may rise between two samples.
_BETWEEN = 0.3
#: Samples looked ahead at first.
_WINDOW = 32
#: A single arc that meets the wanted heading so well ends the curve [rad].
_MEETS = 1e-5


@dataclass(frozen=True)
class Samples:
    """Samples along a polyline: points (k, 2), way along [m], integral of the heading [m rad]."""

    points: Floats
    along: Floats
    swept: Floats


@dataclass(frozen=True)
class Knots:
    """Where arcs meet: index of the sample, distance to its left [m], heading [rad]; each (arcs + 1,)."""

    places: Indices
    beside: Floats
    headings: Floats


@dataclass(frozen=True)
class _States:
    """Ends of the arcs found so far, with the index of the state each came from; fields as in Knots."""

    place: Indices
    beside: Floats
    heading: Floats
    parent: Indices


def sample(
    points: Floats, spacing: float, tolerance: float, first: float | None = None, last: float | None = None
) -> Samples:
    """Samples of a polyline (n, 2) within which arcs may begin and end.

    They are its vertices, at least the middles of its edges, none farther from the next than the spacing [m],
    and some so near to each vertex that an arc between them rounds it off within the tolerance [m]. first and
    last are the headings wanted at the ends [rad], where the polyline turns to them.
    """
    edges = np.diff(points, axis=0)
    lengths = np.hypot(edges[:, 0], edges[:, 1])
    heading = np.unwrap(np.arctan2(edges[:, 1], edges[:, 0]))
    counts = np.clip(2 * np.ceil(0.5 * lengths / spacing).astype(int), 2, 16)
    ends = np.append(0.0, np.cumsum(lengths))
    even = [np.linspace(a, b, n, endpoint=False) for a, b, n in zip(ends[:-1], ends[1:], counts)]
    turns = np.diff(np.concatenate([[_or(first, heading[0])], heading, [_or(last, heading[-1])]]))
    rounding = 3.0 * tolerance / np.maximum(np.abs(_wrapped(turns)), 1e-9)
    sides = (-1.0, -0.6, -0.3, 0.3, 0.6, 1.0)
    around = np.minimum(np.append(lengths, np.inf), np.append(np.inf, lengths))
    room = 0.5 * np.minimum(around, spacing)
    bent = rounding < 3.0 * room
    near = [(ends + side * np.minimum(rounding, room))[bent] for side in sides]
    along = np.concatenate([*even, ends[-1:], *near])
    along = np.unique(along[(along >= 0.0) & (along <= ends[-1])])
    along = along[np.append(True, np.diff(along) > 1e-9)]
    edge = np.clip(np.searchsorted(ends, along[:-1] + 1e-10, side="right") - 1, 0, len(edges) - 1)
    share = (along[:-1] - ends[edge]) / lengths[edge]
    swept = np.append(0.0, np.cumsum(heading[edge] * np.diff(along)))
    return Samples(np.concatenate([points[edge] + share[:, None] * edges[edge], points[-1:]]), along, swept)


def _or(heading: float | None, otherwise: float) -> float:
    return otherwise if heading is None else heading


def _wrapped(angles: Floats) -> Floats:
    """Angles between -pi and pi."""
    return (angles + np.pi) % (2.0 * np.pi) - np.pi


def fewest_arcs(samples: Samples, first: float | None, last: float | None, tolerance: float) -> Knots | None:
    """The knots of the arcs from the first sample to the last, both met exactly.

    first, last  headings there, or None where they are free [rad]; any turn of 2 pi may be left out
    None where the tolerance leaves no way.
    """
    levels = [_start(samples, first, tolerance)]
    ending = None if last is None else _unwound(samples, last, -1)
    while len(levels) <= len(samples.along):
        states = levels[-1]
        low, high, reach = _reach(samples, states, tolerance)
        tail = _last_arcs(samples, states, low, high, reach, ending, tolerance)
        if tail is not None:
            return _traced(levels, *tail)
        following = _next(samples, states, low, high, reach, tolerance)
        if following is None:
            return None
        levels.append(following)
    return None


def _unwound(samples: Samples, heading: float, edge: int) -> float:
    """A heading with the turns of the polyline beside it."""
    near = (np.diff(samples.swept) / np.diff(samples.along))[edge]
    return float(heading + 2.0 * np.pi * np.round((near - heading) / (2.0 * np.pi)))


def _start(samples: Samples, first: float | None, tolerance: float) -> _States:
    if first is not None:
        headings = np.array([_unwound(samples, first, 0)])
    else:
        near = np.diff(samples.swept)[:40] / np.diff(samples.along)[:40]
        ahead = np.concatenate([near, (samples.swept[1:41] - samples.swept[0]) / samples.along[1:41]])
        spread = min(np.arctan(4.0 * tolerance / samples.along[min(8, len(samples.along) - 1)]), 0.5)
        headings = np.linspace(ahead.min() - spread, ahead.max() + spread, 2 * _BEAM)
    zero = np.zeros(len(headings))
    return _States(zero.astype(np.int64), zero, headings, zero.astype(np.int64))


def _reach(samples: Samples, states: _States, tolerance: float) -> tuple[Floats, Floats, Floats]:
    """Bounds (states, window) of the curvatures up to each sample ahead, and how many are in reach."""
    window = _WINDOW
    while True:
        away, rise, inside = _ahead(samples, states, window)
        # between samples an arc rises by an eighth of its curvature times their distance squared
        gap = np.diff(away, axis=1, prepend=0.0)
        most = np.minimum(_MOST_TURN / away, _BETWEEN * 8.0 * tolerance / np.maximum(gap, 1e-9) ** 2)
        low = np.maximum.accumulate(np.maximum(2.0 * (rise - tolerance) / away**2, -most), axis=1)
        high = np.minimum.accumulate(np.minimum(2.0 * (rise + tolerance) / away**2, most), axis=1)
        reach = ((low <= high) & inside).sum(axis=1)
        if reach.max() < window or window > len(samples.along):
            return low, high, reach
        window *= 2


def _ahead(samples: Samples, states: _States, window: int) -> tuple[Floats, Floats, Bools]:
    """Way and wanted rise (states, window) over the state's tangent to the samples ahead, and which exist."""
    index = states.place[:, None] + np.arange(1, window + 1)
    inside = index < len(samples.along)
    index = np.minimum(index, len(samples.along) - 1)
    away = np.where(inside, samples.along[index] - samples.along[states.place][:, None], np.inf)
    away_or_one = np.where(inside, away, 1.0)
    rise = (
        samples.swept[index]
        - samples.swept[states.place][:, None]
        - states.beside[:, None]
        - states.heading[:, None] * away_or_one
    )
    return away_or_one, rise, inside


def _next(
    samples: Samples, states: _States, low: Floats, high: Floats, reach: Floats, tolerance: float
) -> _States | None:
    """The states after one more arc that reach farthest with the arc after it."""
    usable = np.flatnonzero(reach > 0)
    if not len(usable):
        return None
    steps = np.maximum(np.ceil(reach[usable, None] * _BREAKS).astype(int), 1)
    parent = np.repeat(usable, len(_BREAKS))
    step = steps.ravel()
    least, most = low[parent, step - 1], high[parent, step - 1]
    bends = least[:, None] + (most - least)[:, None] * _CURVATURES
    bends = np.concatenate([bends, np.clip(0.0, least, most)[:, None]], axis=1)  # straight on where it may
    parent, step = np.repeat(parent, bends.shape[1]), np.repeat(step, bends.shape[1])
    bend = bends.ravel()
    place = states.place[parent] + step
    away = samples.along[place] - samples.along[states.place[parent]]
    rise = states.beside[parent] + states.heading[parent] * away + 0.5 * bend * away**2
    beside = rise - (samples.swept[place] - samples.swept[states.place[parent]])
    found = _States(place, beside, states.heading[parent] + bend * away, parent)
    _, _, further = _reach(samples, found, tolerance)
    ends = np.where(place < len(samples.along) - 1, place + further, -1)
    order = np.lexsort((place, np.abs(beside), -ends))
    best = order[_rank_within(place[order]) < _PER_PLACE][:_BEAM]
    best = best[ends[best] > 0]
    if not len(best):
        return None
    return _States(place[best], beside[best], found.heading[best], parent[best])


def _rank_within(
    groups: Indices,
) -> Indices:
    """How many earlier entries belong to the same group, for each entry."""
    order = np.argsort(groups, kind="stable")
    ordered = groups[order]
    begins = np.append(True, np.diff(ordered) != 0)
    first = np.maximum.accumulate(np.where(begins, np.arange(len(groups)), 0))
    ranks = np.empty(len(groups), dtype=np.int64)
    ranks[order] = np.arange(len(groups)) - first
    return ranks


def _last_arcs(
    samples: Samples,
    states: _States,
    low: Floats,
    high: Floats,
    reach: Floats,
    ending: float | None,
    tolerance: float,
) -> tuple[int, list[tuple[int, float, float]]] | None:
    """The state from which one arc, or a pair where the end's heading is given, ends the curve; the knots."""
    end = len(samples.along) - 1
    ahead = end - states.place
    there = np.flatnonzero(reach >= ahead)
    if len(there):
        column = ahead[there] - 1
        away = samples.along[end] - samples.along[states.place[there]]
        rise = (
            samples.swept[end] - samples.swept[states.place[there]]
            - states.beside[there] - states.heading[there] * away
        )  # fmt: skip
        bend = 2.0 * rise / away**2
        heading = states.heading[there] + bend * away
        fits = (low[there, column] <= bend) & (bend <= high[there, column])
        if ending is not None:
            fits &= np.abs(heading - ending) < _MEETS
        if fits.any():
            which = int(np.flatnonzero(fits)[0])
            return int(there[which]), [(end, 0.0, float(heading[which]))]
    return None if ending is None else _last_pair(samples, states, reach, ending, tolerance)


def _last_pair(
    samples: Samples, states: _States, reach: Floats, ending: float, tolerance: float
) -> tuple[int, list[tuple[int, float, float]]] | None:
    """The pair of arcs that meets the end's heading and keeps the most distance from the tolerance's edge."""
    end = len(samples.along) - 1
    best: tuple[float, int, list[tuple[int, float, float]]] | None = None
    for state in range(len(states.place)):
        place, beside, heading = states.place[state], states.beside[state], states.heading[state]
        if place >= end - 1 or not reach[state]:
            continue
        away = samples.along[place + 1 :] - samples.along[place]
        target = samples.swept[place + 1 :] - samples.swept[place] - beside - heading * away
        middle = np.arange(min(int(reach[state]), len(away) - 1))
        middle = middle[np.unique(np.linspace(0, len(middle) - 1, 12).astype(int)).tolist()]
        a, b = away[middle], away[-1] - away[middle]
        # rise and heading at the end:  k1 (a^2/2 + a b) + k2 b^2/2 = target,  k1 a + k2 b = turn
        turn = ending - heading
        first = (2.0 * target[-1] - turn * b) / (a * (a + b))
        second = (turn - first * a) / b
        past = np.maximum(away[None] - a[:, None], 0.0)
        rise = 0.5 * first[:, None] * away**2 + 0.5 * (second - first)[:, None] * past**2
        off = np.abs(rise - target).max(axis=1)
        off[(np.abs(first * a) > _MOST_TURN) | (np.abs(second * b) > _MOST_TURN)] = np.inf
        least = int(np.argmin(off))
        if off[least] <= tolerance and (best is None or off[least] < best[0]):
            step = int(middle[least])
            joint = (
                int(place + 1 + step),
                float(rise[least, step] - target[step]),
                float(heading + first[least] * a[least]),
            )
            best = float(off[least]), state, [joint, (end, 0.0, ending)]
    return None if best is None else best[1:]


def _traced(levels: list[_States], state: int, tail: list[tuple[int, float, float]]) -> Knots:
    """The way from the start to a state of the last level, and on."""
    knots = list(reversed(tail))
    for level in reversed(levels):
        knots.append((int(level.place[state]), float(level.beside[state]), float(level.heading[state])))
        state = int(level.parent[state])
    places, beside, headings = zip(*reversed(knots))
    return Knots(np.array(places), np.array(beside), np.array(headings))

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

from BalloonWorkbench.core.arcs.samples import Samples
from BalloonWorkbench.core.checkpoint import checkpoint
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
#: Samples at which a pair of arcs is looked at first, and where its arcs may meet.
_COARSE = 48
_MEETINGS = 12
#: A single arc that meets the wanted heading so well ends the curve [rad].
_MEETS = 1e-5


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


def fewest_arcs(samples: Samples, first: float | None, last: float | None, tolerance: float) -> Knots | None:
    """The knots of the arcs from the first sample to the last, both met exactly.

    first, last  headings there, or None where they are free [rad]; any turn of 2 pi may be left out
    None where the tolerance leaves no way.
    """
    levels = [_start(samples, first, tolerance)]
    ending = None if last is None else _unwound(samples, last, -1)
    while len(levels) <= len(samples.along):
        checkpoint()
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


def _reach(
    samples: Samples, states: _States, tolerance: float, bounds: bool = True
) -> tuple[Floats, Floats, Indices]:
    """Bounds (states, k) of the curvatures up to each sample ahead, and how many samples are in reach.

    Bounds beyond the reach mean nothing; without them only the reach is found.
    """
    reach = np.zeros(len(states.place), dtype=np.int64)
    lows: list[Floats] = []
    highs: list[Floats] = []
    alive, begin, width = np.arange(len(reach)), 0, _WINDOW
    least, most = np.full(len(reach), -np.inf), np.full(len(reach), np.inf)
    before = np.zeros(len(reach))
    while len(alive):
        away, rise, inside = _ahead(samples, states, alive, begin, width)
        # between samples an arc rises by an eighth of its curvature times their distance squared
        gap = np.diff(away, axis=1, prepend=before[:, None])
        limit = np.minimum(_MOST_TURN / away, _BETWEEN * 8.0 * tolerance / np.maximum(gap, 1e-9) ** 2)
        square = 2.0 / away**2
        low, high = (
            np.maximum((rise - tolerance) * square, -limit),
            np.minimum((rise + tolerance) * square, limit),
        )
        low[:, 0], high[:, 0] = np.maximum(low[:, 0], least), np.minimum(high[:, 0], most)
        low, high = np.maximum.accumulate(low, axis=1), np.minimum.accumulate(high, axis=1)
        ahead = ((low <= high) & inside).sum(axis=1)
        reach[alive] += ahead
        if bounds:
            for columns, part in ((lows, low), (highs, high)):
                columns.append(np.zeros((len(reach), width)))
                columns[-1][alive] = part
        on = ahead == width
        alive, least, most, before = alive[on], low[on, -1], high[on, -1], away[on, -1]
        begin, width = begin + width, 2 * width
    if not bounds:
        return np.zeros((0, 0)), np.zeros((0, 0)), reach
    return np.concatenate(lows, axis=1), np.concatenate(highs, axis=1), reach


def _ahead(
    samples: Samples, states: _States, which: Indices, begin: int, width: int
) -> tuple[Floats, Floats, Bools]:
    """Way and wanted rise (k, width) over the tangents of k states to samples ahead, and which exist."""
    place = states.place[which]
    index = place[:, None] + np.arange(begin + 1, begin + width + 1)
    inside = index < len(samples.along)
    index = np.minimum(index, len(samples.along) - 1)
    away = np.where(inside, samples.along[index] - samples.along[place][:, None], 1.0)
    rise = (
        samples.swept[index]
        - (samples.swept[place] + states.beside[which])[:, None]
        - states.heading[which][:, None] * away
    )
    return away, rise, inside


def _next(
    samples: Samples, states: _States, low: Floats, high: Floats, reach: Indices, tolerance: float
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
    candidates = _States(place, beside, states.heading[parent] + bend * away, parent)
    _, _, further = _reach(samples, candidates, tolerance, bounds=False)
    ends = np.where(place < len(samples.along) - 1, place + further, -1)
    order = np.lexsort((place, np.abs(beside), -ends))
    best = order[_rank_within(place[order]) < _PER_PLACE][:_BEAM]
    best = best[ends[best] > 0]
    if not len(best):
        return None
    return _States(place[best], beside[best], candidates.heading[best], parent[best])


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
    reach: Indices,
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
    samples: Samples, states: _States, reach: Indices, ending: float, tolerance: float
) -> tuple[int, list[tuple[int, float, float]]] | None:
    """The pair of arcs that meets the end's heading and keeps the most distance from the tolerance's edge."""
    end = len(samples.along) - 1
    best: tuple[float, int, list[tuple[int, float, float]]] | None = None
    able = np.flatnonzero((states.place < end - 1) & (reach > 0))
    if not len(able):
        return None
    middles, firsts, seconds, fits = _pairs(samples, states, able, reach[able], ending, tolerance)
    for row in np.flatnonzero(fits.any(axis=1)).tolist():
        state = int(able[row])
        place, beside, heading = states.place[state], states.beside[state], states.heading[state]
        away = samples.along[place + 1 :] - samples.along[place]
        target = samples.swept[place + 1 :] - samples.swept[place] - beside - heading * away
        middle, first, second = (values[row, fits[row]] for values in (middles, firsts, seconds))
        a = away[middle]
        rise = _over_pair(first, second, a, away)
        off = np.abs(rise - target).max(axis=1)
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


def _pairs(
    samples: Samples, states: _States, able: Indices, reach: Indices, ending: float, tolerance: float
) -> tuple[Indices, Floats, Floats, Bools]:
    """For each state that is able (s,): where a pair of arcs to the end may meet, in samples after the next,
    their curvatures, and whether they stay within the tolerance at some samples; each (s, _MEETINGS).
    """
    place, beside, heading = states.place[able], states.beside[able], states.heading[able]
    count = len(samples.along) - 1 - place  # of samples ahead
    middle = np.linspace(0, np.minimum(reach, count - 1) - 1, _MEETINGS, axis=1).astype(int)

    def ahead(steps: Indices) -> tuple[Floats, Floats]:
        """Way and wanted rise (s, k) to samples after the next one."""
        index = place[:, None] + 1 + steps
        away = samples.along[index] - samples.along[place][:, None]
        rise = samples.swept[index] - samples.swept[place][:, None] - beside[:, None]
        return away, rise - heading[:, None] * away

    (a, _), (whole, target) = ahead(middle), ahead(count[:, None] - 1)
    b = whole - a
    # rise and heading at the end:  k1 (a^2/2 + a b) + k2 b^2/2 = target,  k1 a + k2 b = turn
    turn = (ending - heading)[:, None]
    first = (2.0 * target - turn * b) / (a * (a + b))
    second = (turn - first * a) / b
    bent = (np.abs(first * a) <= _MOST_TURN) & (np.abs(second * b) <= _MOST_TURN)
    stride = np.maximum(1, count // _COARSE)[:, None]  # most pairs are far off somewhere
    away, target = ahead(np.minimum(np.arange(2 * _COARSE) * stride, count[:, None] - 1))
    past = np.maximum(away[:, None] - a[..., None], 0.0)
    rise = 0.5 * first[..., None] * away[:, None] ** 2 + 0.5 * (second - first)[..., None] * past**2
    return middle, first, second, bent & (np.abs(rise - target[:, None]).max(axis=2) <= tolerance)


def _over_pair(first: Floats, second: Floats, middle: Floats, away: Floats) -> Floats:
    """Rise (k, n) of pairs of arcs over their first tangents, on the way (n,); they meet at middle (k,)."""
    past = np.maximum(away[None] - middle[:, None], 0.0)
    return np.asarray(0.5 * first[:, None] * away**2 + 0.5 * (second - first)[:, None] * past**2)


def _traced(levels: list[_States], state: int, tail: list[tuple[int, float, float]]) -> Knots:
    """The way from the start to a state of the last level, and on."""
    knots = list(reversed(tail))
    for level in reversed(levels):
        knots.append((int(level.place[state]), float(level.beside[state]), float(level.heading[state])))
        state = int(level.parent[state])
    places, beside, headings = zip(*reversed(knots))
    return Knots(np.array(places), np.array(beside), np.array(headings))

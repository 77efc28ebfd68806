# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a tool begins a closed line: on a straight, away from corners and from cuts such as notches.

A beam burns in where it begins, a swivel knife comes down turned anyhow and swings into the direction of the
cut on the first millimetre, and where a line closes it may not meet itself quite. That does no harm where it
goes on straight; a corner or the end of a notch would tear from there.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from BalloonWorkbench.core.arcs.curves import Curve
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.types import Floats

#: How far on either side of a start the line must go straight on, where there is such a place [mm].
CLEAR = 2.0
#: How far its turning counts besides: first near it, then farther away [mm].
_REACHES = (5.0, 10.0, 20.0, 40.0, 80.0)
#: Distance between places that are tried [mm], the fewest and the most of them.
_STEP, _FEWEST, _MOST = 0.5, 8, 20000
#: A line that ends so near to another begins at it, also where a kerf has moved that one [mm].
_TOUCHES = 2.0
#: A joint that is as near is the start: no piece without a length [mm].
NEAR = 0.01
#: Less turning is none [rad]: near the start, where a bend of 40 mm is a straight, and besides.
_STRAIGHT, _DIGITS = 0.1, 3
#: A bend of 20 mm is straight enough to stay where a line begins already [rad/mm].
_AS_STRAIGHT = 0.1
#: A joint of two lines that turns by less is none [rad].
_NO_JOINT = 1e-6


def begun_on_straight(curve: Curve, ends: Floats) -> Curve:
    """The closed curve [mm] begun where it turns least, far from its corners and from the ends (n, 2) of
    other lines; as it is where it begins on a straight."""
    places = np.append(0.0, places_along(curve))
    turned = turning(curve, ends, places, (CLEAR, *_REACHES))
    rows = [np.round(turned[0] / _STRAIGHT), *np.round(turned[1:], _DIGITS)]
    best = int(np.lexsort(rows[::-1])[0])
    if (turned[:2, 0] < _AS_STRAIGHT * np.array([CLEAR, _REACHES[0]])).all():
        return curve
    begun, joint = curve.jointed(float(places[best]), NEAR)
    if joint and len(curve) > 2 and not curve.bulges[[0, -1]].any() and abs(curve.joint_turns[0]) < _NO_JOINT:
        # amid a straight where the curve began before
        begun, joint = Curve(begun.joints[1:], begun.bulges[1:], True), joint - 1
    return begun.begun_at(joint)


def places_along(curve: Curve) -> Floats:
    """Places (n,) along a closed curve [mm] where something may be put, evenly."""
    count = int(np.clip(curve.length / _STEP, _FEWEST, _MOST))
    return (np.arange(count) + 0.5) * curve.length / count


def turning(curve: Curve, ends: Floats, places: Floats, reaches: Sequence[float]) -> Floats:
    """How much (k, n) a closed curve [mm] turns within each of k reaches [mm] on either side of places (n,)
    [rad]; the end of another line on it, of those at (m, 2) mm, counts as half a turn."""
    along = np.append(0.0, np.cumsum(curve.lengths))
    met = _met(curve, ends)
    each = [min(reach, along[-1] / 4.0) for reach in reaches]
    return np.array([_turning(curve, along, met, places - near, places + near) for near in each])


def _met(curve: Curve, ends: Floats) -> Floats:
    """Where along a closed curve [mm] other lines end."""
    package = shapely()
    ring = package.LinearRing(curve.flattened(NEAR))
    points = package.points(ends)
    return np.asarray(ring.project(points[package.dwithin(points, ring, _TOUCHES)]))


def _turning(curve: Curve, along: Floats, met: Floats, low: Floats, high: Floats) -> Floats:
    """Turning (n,) of a closed curve between places along it [rad]; half a turn for each line it meets."""
    bent = np.append(0.0, np.cumsum(np.abs(curve.turns)))
    jumps = np.concatenate([along[:-1], met])
    sizes = np.concatenate([np.abs(curve.joint_turns), np.full(len(met), np.pi)])
    order = np.argsort(jumps, kind="stable")
    sums = np.append(0.0, np.cumsum(sizes[order]))

    def until(places: Floats) -> Floats:
        rounds, rest = np.divmod(places, along[-1])
        smooth = np.interp(rest, along, bent)
        return (
            rounds * (bent[-1] + sums[-1]) + smooth + sums[np.searchsorted(jumps[order], rest, side="right")]
        )

    return until(high) - until(low)

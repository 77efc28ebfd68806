# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a knife begins a closed cut.

A swivel knife comes down turned anyhow and swings into the direction of the cut on the first millimetre. That
does no harm where the cut goes on straight, away from corners and from other cuts such as notches.
"""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.arcs.curves import Curve
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.types import Floats

#: How far on either side of the start the turning counts: first near it, then farther away [mm].
_REACHES = (5.0, 10.0, 20.0, 40.0, 80.0)
#: Least distance between places that are tried [mm], and how many there are at most.
_STEP, _MOST = 1.0, 500
#: A line that ends so near to the cut begins at it [mm].
_TOUCHES = 0.5
_CHORD = 0.01
#: Less turning is none [rad].
_DIGITS = 3


def begun_on_straight(curve: Curve, ends: Floats) -> Curve:
    """The closed curve [mm] begun where it turns least, far from its corners and from the ends (n, 2) of
    other lines."""
    along = np.append(0.0, np.cumsum(curve.lengths))
    whole = along[-1]
    count = int(np.clip(whole / _STEP, 8, _MOST))
    places = (np.arange(count) + 0.5) * whole / count
    turned = np.zeros((len(_REACHES), count))
    for reach, row in zip(_REACHES, turned):
        near = min(reach, whole / 4.0)
        row[:] = _turning(curve, along, _met(curve, ends), places - near, places + near)
    place = places[np.lexsort(np.round(turned, _DIGITS)[::-1])[0]]
    segment = int(np.searchsorted(along, place, side="right")) - 1
    before, after = place - along[segment], along[segment + 1] - place
    if min(before, after) < _CHORD:  # at a joint: no piece without a length
        return curve.begun_at((segment + int(after < before)) % len(curve))
    return curve.split(segment, float(before / (before + after))).begun_at(segment + 1)


def _met(curve: Curve, ends: Floats) -> Floats:
    """Where along a closed curve [mm] other lines end."""
    package = shapely()
    ring = package.LinearRing(curve.flattened(_CHORD))
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

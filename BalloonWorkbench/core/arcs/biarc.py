# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arcs and pairs of arcs between two points with given directions.

Bolton, Biarc curves, Computer-Aided Design 7 (1975) 89-92; Meek and Walton, Approximating smooth planar
curves by arc splines, J. Comput. Appl. Math. 59 (1995) 221-231.
"""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.geometry.vectors import direction, wrapped
from BalloonWorkbench.core.types import Floats


def tangent_bulge(start: Floats, heading: float, end: Floats) -> float:
    """The bulge of the arc that leaves start with a heading [rad] and passes through end."""
    chord = end - start
    half = np.arctan2(chord[1], chord[0]) - heading
    return float(np.tan(0.5 * wrapped(half)))


def heading_after(start: Floats, end: Floats, bulge: float) -> float:
    """The heading at the end of an arc [rad]."""
    chord = end - start
    return float(np.arctan2(chord[1], chord[0]) + 2.0 * np.arctan(bulge))


def biarc(
    start: Floats, heading: float, end: Floats, last: float, ratio: float
) -> tuple[Floats, float, float] | None:
    """Joint (2,) and the two bulges of a pair of arcs with one tangent where they meet.

    heading, last  directions at start and end [rad]
    ratio          how much longer the first arc's tangents are than the second's; it places the joint
    None where no such pair turns by less than half a circle.
    """
    first, second = direction(heading), direction(last)
    chord = end - start
    # |chord - d (ratio first + second)| = d (ratio + 1), solved for d; written so that d stays exact
    # where both directions are equal and the equation is linear
    square = 2.0 * ratio * (first @ second - 1.0)
    linear = -2.0 * chord @ (ratio * first + second)
    root = linear * linear - 4.0 * square * (chord @ chord)
    if root < 0.0 or np.sqrt(root) <= linear:
        return None
    reach = 2.0 * (chord @ chord) / (np.sqrt(root) - linear)
    before, after = start + ratio * reach * first, end - reach * second
    joint = (before + ratio * after) / (1.0 + ratio)
    bulges = tangent_bulge(start, heading, joint), -tangent_bulge(end, last + np.pi, joint)
    return (joint, *bulges) if max(map(abs, bulges)) < 1.0 else None


def off_arc(points: Floats, start: Floats, end: Floats, bulge: float) -> Floats:
    """Distance (n,) from points (n, 2) to the whole circle, or line, of an arc; positive on its left."""
    chord = end - start
    length = np.hypot(chord[0], chord[1])
    along = chord / length
    away = points - start
    u, v = away @ along, away[:, 1] * along[0] - away[:, 0] * along[1]
    half = 2.0 * np.arctan(bulge)
    bend = 2.0 * np.sin(half) / length
    sine, cosine = np.sin(half), np.cos(half)
    # the heading at start is turned by -half from the chord
    beside = u * sine + v * cosine
    excess = bend * (u * u + v * v) - 2.0 * beside
    return -excess / (1.0 + np.sqrt(np.maximum(1.0 + bend * excess, 0.0)))


def share_of(points: Floats, start: Floats, end: Floats, bulge: float) -> Floats:
    """How far along an arc (n,) points (n, 2) on or near it are: 0 at its start, 1 at its end."""
    chord = end - start
    length = np.hypot(chord[0], chord[1])
    along = chord / length
    away = points - 0.5 * (start + end)
    u = away @ along
    if bulge == 0.0:
        return 0.5 + u / length
    v = (away[:, 1] * along[0] - away[:, 0] * along[1]) * np.sign(bulge)
    half = 2.0 * np.arctan(abs(bulge))
    return 0.5 + np.arctan2(u, 0.5 * length / np.tan(half) - v) / (2.0 * half)


def away_from(points: Floats, start: Floats, end: Floats, bulge: float) -> Floats:
    """Distance (n,) of points (n, 2) from an arc; beyond its ends from those."""
    share = share_of(points, start, end, bulge)
    ends = np.minimum(*(np.hypot(points[:, 0] - at[0], points[:, 1] - at[1]) for at in (start, end)))
    return np.where((share >= 0.0) & (share <= 1.0), np.abs(off_arc(points, start, end, bulge)), ends)

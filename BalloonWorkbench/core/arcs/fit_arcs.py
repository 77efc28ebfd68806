# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contours as lines and arcs: corners and straight edges kept, smooth everywhere else."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.arcs.arc_spline import Knots, fewest_arcs
from BalloonWorkbench.core.arcs.biarc import (
    away_from,
    biarc,
    heading_after,
    off_arc,
    share_of,
    tangent_bulge,
)
from BalloonWorkbench.core.arcs.curves import STRAIGHT, Curve, Segment, polyline
from BalloonWorkbench.core.arcs.samples import Samples, sample
from BalloonWorkbench.core.arcs.stretches import Stretch, heading_at, stretches
from BalloonWorkbench.core.checkpoint import checkpoint
from BalloonWorkbench.core.geometry.nearest import nearest_on_line
from BalloonWorkbench.core.geometry.vectors import direction, norm, perpendicular
from BalloonWorkbench.core.memoize import memoized
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import from_mm

#: How far a curve may be from its polyline, and the polyline from the curve [m].
TOLERANCE = from_mm(0.02)
_SPACING = from_mm(0.5)
#: Digits after the metre at which two polylines have one shape.
_SAME_SHAPE = 10
#: A stretch of so many points is divided when no search leads through it.
_DIVISIBLE = 5
#: How near to an arc its chords are where distances are measured [m].
_FINE = 0.01 * TOLERANCE
#: Shares of the tolerance within which a curve is looked for whose sides cross in a tip.
_NEARER = (0.3, 0.1)
#: Share of the tolerance within which a curve is followed to see whether it crosses itself.
_BESIDE = 0.05
#: Shares of the tolerance with which the search is tried: what it neglects is small but not nothing.
_SHARES = (0.97, 0.85, 0.7, 0.5)


def fit_curve(points: Floats, closed: bool, tolerance: float = TOLERANCE) -> Curve:
    """The curve of lines and arcs within a tolerance [m] of a polyline (n, 2) m, both ways.

    Corners above 25 degrees, corners of polygons, straight edges and the ends of an open polyline are kept
    exactly; elsewhere the tangent goes through. A closed curve begins near the polyline's first point.
    Where a closed curve would cross itself between the sides of a sharp tip, it stays nearer to the polyline.
    It is that of the polyline's shape, moved to its place: copies have the same one.
    """
    shape = np.round(points - points[0], _SAME_SHAPE) + 0.0
    curve = _uncrossed(shape, closed, tolerance)
    exact = dict(zip(map(tuple, shape.tolist()), points.tolist(), strict=True))
    joints = [exact.get(tuple(joint), joint + points[0]) for joint in curve.joints]
    return Curve(np.array(joints), curve.bulges, curve.closed)


@memoized(most=1024)  # shape, check and file of a pattern ask for the same ones, of many panels hundreds
def _uncrossed(points: Floats, closed: bool, tolerance: float) -> Curve:
    """The curve, of a polyline that does not cross itself one that does not either."""
    curve = _fit(points, closed, tolerance)
    if not closed or _is_simple(curve, tolerance) or not _is_simple(polyline(points, True), tolerance):
        return curve
    for share in _NEARER:
        curve = _fit(points, closed, share * tolerance)
        if _is_simple(curve, share * tolerance):
            return curve
    return polyline(points, True)


def _is_simple(curve: Curve, tolerance: float) -> bool:
    return bool(shapely().LinearRing(curve.flattened(_BESIDE * tolerance)).is_simple)


def _fit(points: Floats, closed: bool, tolerance: float) -> Curve:
    joints: list[Floats] = []
    bulges: list[float] = []
    for stretch in stretches(points, closed, tolerance):
        knots, bends = _fitted(stretch, tolerance)
        joints += list(knots[:-1])
        bulges += bends
        end = knots[-1]
    if closed:
        return _begun_near(_merged(np.array(joints), np.array(bulges), True), points[0])
    return _merged(np.array([*joints, end]), np.array(bulges), False)


def _fitted(stretch: Stretch, tolerance: float) -> tuple[Floats, list[float]]:
    """Joints (n, 2) and bulges (n - 1) of a stretch."""
    points = stretch.points
    if stretch.first is None and stretch.last is None and _is_line(points, tolerance):
        return points[[0, -1]], [0.0]
    if not stretch.straight:
        samples = sample(points, _SPACING, tolerance, stretch.first, stretch.last)
        for share in _SHARES:
            knots = fewest_arcs(samples, stretch.first, stretch.last, share * tolerance)
            if knots is None:
                continue
            arcs = _drawn(samples, knots, stretch)
            if arcs is not None and _deviation(samples, knots, *arcs) <= tolerance:
                return arcs
        if len(points) >= _DIVISIBLE:
            return _in_halves(stretch, tolerance)
    return points, [0.0] * (len(points) - 1)


def _is_line(points: Floats, tolerance: float) -> bool:
    """Whether points (n, 2) are scattered along the line from the first to the last, and go its way."""
    chord = points[-1] - points[0]
    if not (np.diff(points @ chord) > 0.0).all():
        return False
    return bool((nearest_on_line(points[[0, -1]], points).distance <= tolerance).all())


def _in_halves(stretch: Stretch, tolerance: float) -> tuple[Floats, list[float]]:
    """Both halves of a stretch, with one tangent where they meet."""
    points = stretch.points
    middle = len(points) // 2
    heading = heading_at(points, middle, tolerance)
    first, first_bulges = _fitted(Stretch(points[: middle + 1], stretch.first, heading, False), tolerance)
    second, second_bulges = _fitted(Stretch(points[middle:], heading, stretch.last, False), tolerance)
    return np.concatenate([first, second[1:]]), first_bulges + second_bulges


def _drawn(samples: Samples, knots: Knots, stretch: Stretch) -> tuple[Floats, list[float]] | None:
    """Exact arcs through the knots: pairs of them between every second knot, the odd one at the end."""
    count = len(knots.places) - 1
    across = perpendicular(direction(knots.headings))
    at = samples.points[knots.places] + knots.beside[:, None] * across
    at[0], at[-1] = samples.points[0], samples.points[-1]
    away = np.diff(samples.along[knots.places])
    heading = float(knots.headings[0])
    joints, bulges = [at[0]], []
    done = 0
    # where the last heading is given, an odd arc comes first and pairs meet that heading
    if count % 2 and stretch.last is not None and count > 1:
        bulges.append(tangent_bulge(at[0], heading, at[1]))
        heading = heading_after(at[0], at[1], bulges[-1])
        joints.append(at[1])
        done = 1
    while done < count:
        if done + 1 == count:
            bulges.append(tangent_bulge(at[done], heading, at[-1]))
            joints.append(at[-1])
            break
        last = float(knots.headings[done + 2])
        # the tangents of an arc that turns by t reach  length tan(t / 2) / t
        turns = np.append(knots.headings[done + 1] - heading, last - knots.headings[done + 1])
        reach = away[done : done + 2] * np.sinc(turns / (2.0 * np.pi)) / np.cos(0.5 * turns)
        pair = biarc(at[done], heading, at[done + 2], last, float(reach[0] / reach[1]))
        if pair is None:
            return None
        joints += [pair[0], at[done + 2]]
        bulges += pair[1:]
        heading = last
        done += 2
    return np.array(joints), bulges


def _deviation(samples: Samples, knots: Knots, joints: Floats, bulges: list[float]) -> float:
    """The largest distance [m] of the samples from the curve, and of the curve from the polyline."""
    segments = Curve(joints, np.array(bulges), False).segments
    most = 0.0
    for k in range(len(bulges)):
        checkpoint()
        low, high = int(knots.places[k]), int(knots.places[k + 1])
        # the joint of a pair is not exactly at its sample, so the neighbours count too
        beside = segments[max(k - 1, 0) : k + 2]
        inside = samples.points[low : high + 1]
        to_curve = np.min([away_from(inside, *segment) for segment in beside], axis=0)
        drawn = Curve(joints[k : k + 2], np.array(bulges[k : k + 1]), False).flattened(_FINE)
        near = samples.points[max(low - 40, 0) : high + 41]
        most = max(most, float(to_curve.max()), float(nearest_on_line(near, drawn).distance.max()))
    return most + 2.0 * _FINE  # between the samples, too


def _merged(joints: Floats, bulges: Floats, closed: bool) -> Curve:
    """Arcs that hardly rise become lines, neighbours on one line or circle become one segment."""
    curve = Curve(joints, bulges, closed)
    rise = 0.5 * np.abs(bulges) * norm(curve.ends - curve.starts)
    curve = Curve(joints, np.where(rise < STRAIGHT, 0.0, bulges), closed)
    merged: list[Segment] = []
    for segment, corner in zip(curve.segments, curve.corners):
        one = None if corner or not merged else _as_one(merged[-1], segment)
        if one is not None:
            merged.pop()
        merged.append(one or segment)
    if closed and len(merged) > 2 and not curve.corners[0]:
        one = _as_one(merged[-1], merged[0])
        if one is not None:
            merged = [*merged[1:-1], one]
    points = [segment.start for segment in merged]
    if not closed:
        points.append(merged[-1].end)
    return Curve(np.array(points), np.array([segment.bulge for segment in merged]), closed)


def _as_one(first: Segment, second: Segment) -> Segment | None:
    """Both segments as one, where they lie on one line or one arc below half a circle."""
    if first.bulge * second.bulge < 0.0 or (first.bulge == 0.0) != (second.bulge == 0.0):
        return None
    half = np.arctan(first.bulge) + np.arctan(second.bulge)
    if abs(half) > 0.25 * np.pi + 1e-9:
        return None
    one = Segment(first.start, second.end, float(np.tan(half)))
    middle = np.stack([first.end, first.middle, second.middle])
    return one if np.abs(off_arc(middle, *one)).max() < STRAIGHT else None


def _begun_near(curve: Curve, point: Floats) -> Curve:
    """The closed curve begun near a point: at a smooth joint, or there where none is near."""
    away = norm(curve.joints - point)
    corners = curve.corners
    if away.min() < STRAIGHT:
        return curve.begun_at(int(np.argmin(away)))
    room = away[corners].min() if corners.any() else np.inf
    smooth = np.flatnonzero(~corners)
    if len(smooth):
        nearest = smooth[int(np.argmin(away[smooth]))]
        if away[nearest] <= 0.5 * room:
            return curve.begun_at(int(nearest))
    shares = np.array([float(share_of(point[None], *segment)[0]) for segment in curve.segments])
    off = np.array([abs(float(off_arc(point[None], *segment)[0])) for segment in curve.segments])
    off[(shares <= 0.0) | (shares >= 1.0)] = np.inf
    segment = int(np.argmin(off))
    if not np.isfinite(off[segment]):
        return curve
    return curve.split(segment, float(shares[segment])).begun_at((segment + 1) % (len(curve) + 1))

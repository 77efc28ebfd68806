# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves of lines and arcs, as machines take them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from BalloonWorkbench.core.geometry.polyline import bounds
from BalloonWorkbench.core.geometry.vectors import direction, norm, perpendicular, wrapped
from BalloonWorkbench.core.types import Bools, Floats
from BalloonWorkbench.core.units import from_mm

#: Tangents that differ by less meet smoothly [rad].
SMOOTH = np.radians(0.1)
#: An arc that rises less over its chord is a line [m].
STRAIGHT = from_mm(1e-4)


class Segment(NamedTuple):
    """A line (bulge 0) or an arc from start to end (2,) m.

    bulge is the tangent of a quarter of the arc's angle, positive when it turns to the left: as in DXF.
    """

    start: Floats
    end: Floats
    bulge: float

    @property
    def middle(self) -> Floats:
        """The point (2,) halfway along it."""
        return 0.5 * (self.start + self.end - self.bulge * perpendicular(self.end - self.start))


@dataclass(frozen=True)
class Curve:
    """Lines and arcs end to end.

    joints  (n, 2) m, each where two segments meet, the ends of an open curve too; the first is not repeated
    bulges  (n,) of the segment after each joint when closed, (n - 1,) when open
    """

    joints: Floats
    bulges: Floats
    closed: bool

    def __len__(self) -> int:
        return len(self.bulges)

    @property
    def starts(self) -> Floats:
        """First point (m, 2) of each segment."""
        return self.joints[: len(self.bulges)]

    @property
    def ends(self) -> Floats:
        """Last point (m, 2) of each segment: the very numbers with which the next one starts."""
        return np.roll(self.joints, -1, axis=0)[: len(self.bulges)]

    @property
    def segments(self) -> tuple[Segment, ...]:
        """The segments in their order."""
        return tuple(Segment(a, b, float(c)) for a, b, c in zip(self.starts, self.ends, self.bulges))

    @property
    def turns(self) -> Floats:
        """Angle (m,) by which each segment turns, positive to the left [rad]."""
        return 4.0 * np.arctan(self.bulges)

    @property
    def lengths(self) -> Floats:
        """Length (m,) of each segment [m]."""
        half = 2.0 * np.arctan(np.abs(self.bulges))
        return norm(self.ends - self.starts) / np.sinc(half / np.pi)

    @property
    def length(self) -> float:
        """m"""
        return float(self.lengths.sum())

    @property
    def radii(self) -> Floats:
        """Radius (m,) of each segment, infinite for lines [m]."""
        with np.errstate(divide="ignore"):
            turns: Floats = np.abs(self.turns)
            return np.where(turns > 0.0, self.lengths / turns, np.inf)

    @property
    def headings(self) -> tuple[Floats, Floats]:
        """Directions (m,) at the start and at the end of each segment [rad]."""
        chord = self.ends - self.starts
        along = np.arctan2(chord[:, 1], chord[:, 0])
        return along - 0.5 * self.turns, along + 0.5 * self.turns

    @property
    def joint_turns(self) -> Floats:
        """Angle (n,) by which the direction changes at each joint, 0 at the ends of an open curve [rad]."""
        first, last = self.headings
        turn = wrapped(first - np.roll(last, 1))
        return turn if self.closed else np.append(np.append(0.0, turn[1:]), 0.0)

    @property
    def corners(self) -> Bools:
        """Which joints (n,) are corners; the ends of an open curve are."""
        turn = np.abs(self.joint_turns) > SMOOTH
        if not self.closed:
            turn[[0, -1]] = True
        return turn

    @property
    def bounds(self) -> tuple[Floats, Floats]:
        """Lower left and upper right corner (2,) [m]."""
        points = [self.joints]
        first, _ = self.headings
        turns, radii = self.turns, self.radii
        for k in np.flatnonzero(turns):
            # an arc reaches farthest where it runs along an axis
            low, high = np.sort([first[k], first[k] + turns[k]]) / (0.5 * np.pi)
            quarters = np.arange(np.ceil(low), np.ceil(high))
            shares = (0.5 * np.pi * quarters - first[k]) / turns[k]
            points.append(_on_arc(self.starts[k], float(first[k]), float(turns[k]), float(radii[k]), shares))
        every = np.concatenate(points)
        return bounds(every)

    def flattened(self, tolerance: float) -> Floats:
        """Points (k, 2) m of a polyline that stays within the tolerance [m]; all joints are among them."""
        first, _ = self.headings
        points = []
        for k, (start, turn, radius) in enumerate(zip(self.starts, self.turns, self.radii)):
            points.append(start[None])
            if turn == 0.0:
                continue
            # 2 arccos(1 - tolerance / radius), which a very large radius would make 0
            step = 4.0 * np.arcsin(np.sqrt(min(0.5 * tolerance / float(radius), 0.25)))
            count = int(np.ceil(abs(turn) / step))
            shares = np.arange(1, count) / count
            points.append(_on_arc(start, float(first[k]), float(turn), float(radius), shares))
        if not self.closed:
            points.append(self.joints[-1:])
        return np.concatenate(points)

    def reversed(self) -> Curve:
        """The same curve, run through the other way."""
        bulges = -self.bulges[::-1]
        joints = self.joints[::-1]
        return Curve(np.roll(joints, 1, axis=0) if self.closed else joints, bulges, self.closed)

    def moved(self, shift: Floats, scale: float = 1.0) -> Curve:
        """The curve moved by shift (2,), then scaled about the origin."""
        return Curve((self.joints + shift) * scale, self.bulges, self.closed)

    def begun_at(self, joint: int) -> Curve:
        """The closed curve with another of its joints as the first."""
        return Curve(np.roll(self.joints, -joint, axis=0), np.roll(self.bulges, -joint), True)

    def split(self, segment: int, share: float) -> Curve:
        """The curve with one more joint, at a share of the length of a segment."""
        first, _ = self.headings
        turn = float(self.turns[segment])
        start, end = self.starts[segment], self.ends[segment]
        at = start + share * (end - start)
        if turn:
            radius = float(self.radii[segment])
            at = _on_arc(start, float(first[segment]), turn, radius, np.array([share]))[0]
        halves = [np.tan(0.25 * turn * share), np.tan(0.25 * turn * (1.0 - share))]
        bulges = np.concatenate([self.bulges[:segment], halves, self.bulges[segment + 1 :]])
        return Curve(np.insert(self.joints, segment + 1, at, axis=0), bulges, self.closed)

    def jointed(self, place: float, near: float) -> tuple[Curve, int]:
        """The curve with a joint at a place along it [m], and the joint's number; it may be as near."""
        along = np.append(0.0, np.cumsum(self.lengths))
        segment = int(np.clip(np.searchsorted(along, place, side="right") - 1, 0, len(self) - 1))
        before, after = float(place - along[segment]), float(along[segment + 1] - place)
        if min(before, after) <= near:
            return self, (segment + int(after < before)) % len(self.joints)
        return self.split(segment, before / (before + after)), segment + 1

    def stretch(self, first: int, last: int) -> Curve:
        """The open curve from one of its joints to a later one."""
        return Curve(self.joints[first : last + 1], self.bulges[first:last], False)


def polyline(points: Floats, closed: bool) -> Curve:
    """The curve of lines through points (n, 2) m."""
    return Curve(points, np.zeros(len(points) if closed else len(points) - 1), closed)


def _on_arc(start: Floats, heading: float, turn: float, radius: float, shares: Floats) -> Floats:
    """Points (k, 2) at shares of the way along an arc."""
    chord = 2.0 * radius * np.sin(0.5 * abs(turn) * shares)
    return start + chord[:, None] * direction(heading + 0.5 * turn * shares)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Outlines with flaws at known places: thin arms, necks, tips, notches, rings; and some without any."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
import shapely
from drawn_shapes import TURN, hole, oriented, polar

from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.types import Floats

KINDS = ("arms", "necks", "star", "notches", "ring", "blob", "tips", "mixed")
SIZE = 0.3


@dataclass
class Flawed:
    """An outline, and where it may have flaws: names of rules with a line or point (k, 2)."""

    outline: Outline
    sites: list[tuple[str, Floats]] = field(default_factory=list)


def flawed(seed: int) -> Flawed:
    """The kind follows from the seed; all have a size of about 0.3 m."""
    random = np.random.default_rng([seed, 7])
    return _MAKERS[KINDS[seed % len(KINDS)]](random)


def _arms(random: Any) -> Flawed:
    radius = random.uniform(0.04, 0.075)
    area = _blob(random, radius)
    sites = []
    count = int(random.integers(2, 5))
    first = random.uniform(0.0, 6.3)
    for k in range(count):
        angle = first + 2.0 * np.pi * k / count + random.uniform(-0.3, 0.3)
        area, line = _with_arm(random, area, radius, angle)
        sites.append(("thin_arm", line))
    return Flawed(_outline(_softened(area, random)), sites)


def _with_arm(random: Any, area: Any, radius: float, angle: float) -> tuple[Any, Floats]:
    """The area with an arm, and the free part of its middle line."""
    width = float(np.exp(random.uniform(np.log(0.006), np.log(0.06))))
    length = random.uniform(0.05, 0.11)
    bend = random.uniform(-6.0, 6.0)
    s = np.linspace(0.0, radius + length, 60)
    heading = angle + bend * np.maximum(s - radius, 0.0)
    steps = np.stack([np.cos(heading), np.sin(heading)], axis=1) * (s[1] - s[0])
    line = np.cumsum(steps, axis=0)
    arm = shapely.LineString(line).buffer(0.5 * width, quad_segs=24)
    outside = ~shapely.contains_xy(area.buffer(0.5 * width), *line.T)
    return area.union(arm), line[outside]


def _necks(random: Any) -> Flawed:
    count = int(random.integers(2, 4))
    x, area, sites = 0.0, shapely.Point(0.0, 0.0).buffer(0.0), []
    for k in range(count):
        radius = random.uniform(0.025, 0.06)
        x += radius
        area = area.union(shapely.affinity.translate(_blob(random, radius, 0.1), x, 0.0))
        x += radius
        if k + 1 < count:
            width = float(np.exp(random.uniform(np.log(0.003), np.log(0.05))))
            length = random.uniform(0.004, 0.05)
            start, end = x - 0.4 * radius, x + length + 0.01
            area = area.union(shapely.box(start, -0.5 * width, end, 0.5 * width))
            sites.append(("choked_neck", np.array([[x + 0.5 * length, 0.0]])))
            x += length
    return Flawed(_outline(area), sites)


def _star(random: Any) -> Flawed:
    points = int(random.integers(3, 10))
    inner = random.uniform(0.25, 0.8)
    k = np.arange(2 * points)
    loop = polar(0.15 * np.where(k % 2 == 0, 1.0, inner), np.pi * k / points)
    return Flawed(Outline(loop), [("flat_tip", loop[i : i + 1]) for i in range(0, 2 * points, 2)])


def _notches(random: Any) -> Flawed:
    area = _blob(random, 0.14)
    first = random.uniform(0.0, 6.3)
    for k in range(int(random.integers(1, 4))):
        area = _with_notch(random, area, first + 2.1 * k)
    return Flawed(_outline(area))


def _with_notch(random: Any, area: Any, angle: float) -> Any:
    half = np.radians(random.uniform(8.0, 70.0))
    away = 0.15 - random.uniform(0.01, 0.1)
    far = 0.4 * np.array([[np.cos(half), np.sin(half)], [np.cos(half), -np.sin(half)]])
    root = np.array([away, 0.0])
    wedge = shapely.Polygon([root, root + far[0], root + far[1]])
    radius = random.choice([0.0, random.uniform(0.002, 0.03)])
    wedge = wedge.buffer(-radius).buffer(radius, quad_segs=24)
    return area.difference(shapely.affinity.rotate(wedge, angle, origin=(0.0, 0.0), use_radians=True))


def _ring(random: Any) -> Flawed:
    stretch = np.array([1.0, random.uniform(0.6, 1.0)])
    share = random.uniform(0.03, 0.85)
    room = 0.15 * (1.0 - share) * 0.8
    x, y = random.uniform(-0.5, 0.5, 2) * room
    inner = hole(0.15 * share, x, y) * stretch
    return Flawed(Outline(polar(0.15) * stretch, (inner,)), [("warping_ring", inner)])


def _plain(random: Any) -> Flawed:
    return Flawed(_outline(_blob(random, 0.14, random.choice([0.05, 0.15, 0.3]))))


def _tips(random: Any) -> Flawed:
    radius = random.uniform(0.05, 0.09)
    area, sites = _blob(random, radius, 0.05), []
    first = random.uniform(0.0, 6.3)
    count = int(random.integers(1, 4))
    for k in range(count):
        area, apex = _with_tip(random, area, radius, first + 2.0 * np.pi * k / count)
        sites.append(("flat_tip", apex))
    return Flawed(_outline(area), sites)


def _with_tip(random: Any, area: Any, radius: float, angle: float) -> tuple[Any, Floats]:
    """The area with a pointed cap whose sides touch the disc of the radius."""
    half = np.radians(random.uniform(6.0, 50.0))
    touch = 0.93 * radius
    away = touch / np.sin(half)
    reach = min(away, radius + 0.13)
    apex = reach * np.array([np.cos(angle), np.sin(angle)])
    foot = reach - (reach - touch * np.sin(half)) if away <= reach else 0.3 * radius
    breadth = (reach - foot) * np.tan(half)
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    feet = np.array([[foot, breadth], [foot, -breadth]]) @ turn.T
    return area.union(shapely.Polygon([apex, *feet])), apex[None]


def _mixed(random: Any) -> Flawed:
    area, sites = _blob(random, 0.08), []
    area, line = _with_arm(random, area, 0.08, random.uniform(0.0, 1.0))
    sites.append(("thin_arm", line))
    area, apex = _with_tip(random, area, 0.08, random.uniform(2.0, 3.0))
    sites.append(("flat_tip", apex))
    half = random.uniform(0.004, 0.03)
    x = random.uniform(0.04, 0.07)
    slot = shapely.Polygon([(-half, -0.3), (half, -0.3), (0.0, -x)])
    return Flawed(_outline(area.difference(slot)), sites)


_MAKERS = dict(zip(KINDS, (_arms, _necks, _star, _notches, _ring, _plain, _tips, _mixed), strict=True))


def _blob(random: Any, radius: float, rough: float = 0.1) -> Any:
    r = np.ones_like(TURN)
    for k in range(2, 6):
        r += random.normal(0.0, rough / k) * np.cos(k * TURN + random.uniform(0.0, 6.3))
    return shapely.Polygon(polar(radius * np.maximum(r, 0.3)))


def _softened(area: Any, random: Any) -> Any:
    """Concave corners rounded, sometimes."""
    radius = random.choice([0.0, 0.0, 0.004, 0.012])
    return area.buffer(radius, quad_segs=16).buffer(-radius, quad_segs=16) if radius else area


def _outline(area: Any) -> Outline:
    largest = max(shapely.get_parts(area), key=lambda part: part.area)
    outer = oriented(np.array(largest.exterior.simplify(5e-5).coords)[:-1])
    return Outline(outer)

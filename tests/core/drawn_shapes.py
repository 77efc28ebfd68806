# SPDX-License-Identifier: LGPL-2.1-or-later
"""Outlines for the tests of meshes, patterns and files: named and generated ones."""

from __future__ import annotations

from typing import Any

import numpy as np

from BalloonWorkbench.core.geometry.polyline import signed_area
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.types import Floats

TURN = np.linspace(0.0, 2.0 * np.pi, 720, endpoint=False)


def oriented(loop: Floats, counter_clockwise: bool = True) -> Floats:
    return loop if (signed_area(loop) > 0.0) == counter_clockwise else np.ascontiguousarray(loop[::-1])


def polar(radius: Floats | float, turn: Floats = TURN) -> Floats:
    return np.stack([radius * np.cos(turn), radius * np.sin(turn)], axis=1)


def hole(radius: Floats | float, x: float, y: float) -> Floats:
    return oriented(polar(radius) + np.array([x, y]), counter_clockwise=False)


def star(points: int, outer: float, inner: float, start: float = np.pi / 2.0) -> Outline:
    k = np.arange(2 * points)
    return Outline(polar(np.where(k % 2 == 0, outer, inner), start + np.pi * k / points))


def strip(centre: Floats, half_width: Floats | float) -> Outline:
    tangent = np.gradient(centre, axis=0)
    normal = np.stack([-tangent[:, 1], tangent[:, 0]], axis=1)
    normal *= (half_width / np.linalg.norm(normal, axis=1))[:, None]
    return Outline(oriented(np.concatenate([centre + normal, (centre - normal)[::-1]])))


def heart() -> Outline:
    x = 16.0 * np.sin(TURN) ** 3
    y = 13.0 * np.cos(TURN) - 5.0 * np.cos(2.0 * TURN) - 2.0 * np.cos(3.0 * TURN) - np.cos(4.0 * TURN)
    return Outline(oriented(0.009 * np.stack([x, y], axis=1)))


def letter_s() -> Outline:
    s = np.linspace(-np.pi, np.pi, 300)
    return strip(np.stack([0.1 * np.sin(s), 0.08 * s], axis=1), 0.014 + 0.004 * np.cos(3.0 * s))


def corners_of(*points: tuple[float, float]) -> Outline:
    return Outline(oriented(np.array(points, dtype=float)))


def _arc(x: float, y: float, radius: float, first: float, last: float, up: float = 0.0) -> list[Any]:
    """Points of an arc between angles in degrees; of an ellipse with another radius upward."""
    turn = np.radians(np.linspace(first, last, 61))
    return np.column_stack([x + radius * np.cos(turn), y + (up or radius) * np.sin(turn)]).tolist()


def ring(share: float, radius: float = 0.15) -> Outline:
    """A round ring whose hole is such a share of its width."""
    return Outline(polar(radius), (hole(share * radius, 0.0, 0.0),) if share else ())


def doughnut() -> Outline:
    """A ring drawn by hand: neither rim is round, and the hole is off the middle."""
    outer = 0.15 * (1.0 + 0.02 * np.cos(2.0 * TURN + 0.4) + 0.012 * np.cos(3.0 * TURN + 2.0))
    inner = 0.05 * (1.0 + 0.05 * np.cos(2.0 * TURN + 1.9) + 0.03 * np.cos(5.0 * TURN))
    return Outline(polar(outer), (hole(inner, 0.006, 0.004),))


def snail() -> Outline:
    """A snail's shell on a long foot, with two feelers."""
    package = shapely()
    lines = [
        ([(0.02, 0.03), (0.26, 0.03), (0.285, 0.075)], 0.024),
        ([(0.285, 0.075), (0.275, 0.15)], 0.008),
        ([(0.285, 0.075), (0.315, 0.145)], 0.008),
    ]
    parts = [package.LineString(points).buffer(width, quad_segs=16) for points, width in lines]
    parts.append(package.Point(0.125, 0.115).buffer(0.085, quad_segs=64))
    area = package.union_all(parts).buffer(0.006).buffer(-0.006)
    return Outline(oriented(np.asarray(area.exterior.coords)[:-1]))


def spiral(turns: float = 1.5) -> Outline:
    """A strip wound up with as much room between its turns as it is wide."""
    angle = np.linspace(0.0, 2.0 * np.pi * turns, 400) + 1.5 * np.pi
    radius = 0.045 + 0.065 * (angle - angle[0]) / (2.0 * np.pi)
    return strip(np.stack([radius * np.cos(angle), radius * np.sin(angle)], axis=1), 0.0165)


#: Middle lines of letters 1.2 high.
_STROKES: dict[str, list[list[Any]]] = {
    "A": [[(0, 0), (0.45, 1.2), (0.9, 0)], [(0.18, 0.42), (0.72, 0.42)]],
    "B": [
        [(0, 0), (0, 1.2), (0.35, 1.2), *_arc(0.35, 0.9, 0.3, 90, -90), (0, 0.6)],
        [(0, 0.6), (0.4, 0.6), *_arc(0.4, 0.3, 0.3, 90, -90), (0, 0)],
    ],
    "O": [_arc(0.5, 0.6, 0.42, 0, 360, 0.6)],
    "P": [[(0, 0), (0, 1.2), (0.4, 1.2), *_arc(0.4, 0.88, 0.32, 90, -90), (0, 0.56)]],
    "8": [_arc(0.4, 0.92, 0.28, 0, 360), _arc(0.4, 0.32, 0.34, 0, 360)],
}
LETTERS = tuple(_STROKES)


def letter(name: str, height: float = 0.3) -> Outline:
    """A letter with holes, drawn with a round pen."""
    package = shapely()
    lines = [package.LineString(stroke) for stroke in _STROKES[name]]
    area = package.union_all([line.buffer(0.125, quad_segs=16) for line in lines]).simplify(5e-4)
    low_x, low_y, _, high_y = area.bounds

    def placed(ring: Any, counter_clockwise: bool) -> Floats:
        points = (np.asarray(ring.coords)[:-1] - (low_x, low_y)) * height / (high_y - low_y)
        return oriented(points, counter_clockwise)

    return Outline(placed(area.exterior, True), tuple(placed(ring, False) for ring in area.interiors))


NAMED: dict[str, Outline] = {
    "disc": Outline(polar(0.15)),
    "square": corners_of((0.0, 0.0), (0.3, 0.0), (0.3, 0.3), (0.0, 0.3)),
    "rectangle": corners_of((0.0, 0.0), (0.3, 0.0), (0.3, 0.1), (0.0, 0.1)),
    "ring": Outline(polar(0.15), (hole(0.075, 0.0, 0.0),)),
    "star": star(5, 0.15, 0.06),
    "spiky": star(12, 0.15, 0.07),
    "heart": heart(),
    "flower": Outline(polar(0.1 * (1.0 + 0.4 * np.cos(5.0 * TURN)))),
    "S": letter_s(),
    "wedge": corners_of((0.0, 0.0), (0.3, -0.04), (0.3, 0.04)),
    "holes": Outline(polar(0.15), (hole(0.03, 0.06, 0.0), hole(0.03, -0.06, 0.02), hole(0.03, 0.0, -0.09))),
    "L": corners_of((0.0, 0.0), (0.3, 0.0), (0.3, 0.05), (0.05, 0.05), (0.05, 0.3), (0.0, 0.3)),
    "neck": Outline(
        np.stack([0.15 * np.cos(TURN), (0.004 + 0.06 * np.cos(TURN) ** 2) * np.sin(TURN)], axis=1)
    ),
}


def generated(seed: int) -> Outline:
    """One of five kinds in turn: smooth, star, spiky, thin, with holes."""
    random = np.random.default_rng(seed)
    kind = seed % 5
    if kind == 0:
        radius = np.ones_like(TURN)
        for k in range(2, 7):
            radius += random.normal(0.0, 0.25 / k) * np.cos(k * TURN + random.uniform(0.0, 6.3))
        return Outline(polar(0.12 * np.maximum(radius, 0.25)))
    if kind == 1:
        return star(int(random.integers(4, 13)), 0.15, random.uniform(0.04, 0.11), random.uniform(0.0, 6.3))
    if kind == 2:
        count = int(random.integers(6, 20))
        angles = (np.arange(count) + random.uniform(-0.2, 0.2, count)) * 2.0 * np.pi / count
        return Outline(polar(random.uniform(0.05, 0.15, count), angles))
    if kind == 3:
        s = np.linspace(0.0, 1.0, 200)
        centre = np.stack([0.3 * s, 0.04 * np.sin(random.uniform(3.0, 9.0) * s)], axis=1)
        return strip(centre, random.uniform(0.008, 0.02) * (1.0 + 0.3 * np.cos(12.0 * s)))
    holes = []
    for k in range(int(random.integers(1, 5))):
        angle = 2.0 * np.pi * k / 5.0 + random.uniform(-0.2, 0.2)
        radius = random.uniform(0.006, 0.03) * (1.0 + 0.3 * np.cos(random.integers(2, 5) * TURN))
        holes.append(hole(radius, 0.085 * np.cos(angle), 0.085 * np.sin(angle)))
    return Outline(polar(0.15 + 0.01 * np.cos(7.0 * TURN)), tuple(holes))

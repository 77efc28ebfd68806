# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closed bodies by formulas, as triangles that are counter-clockwise seen from outside."""

from __future__ import annotations

from collections.abc import Callable
from itertools import product

import numpy as np

from BalloonWorkbench.core.targets.refine import refined
from BalloonWorkbench.core.targets.target import Target
from BalloonWorkbench.core.types import Floats, Ints

_RIGHT = [(0, 1, 3), (0, 3, 2)]


def cube_mesh(count: int) -> tuple[Floats, Ints]:
    """The cube from -1 to 1 with count x count squares on each face."""
    steps = np.linspace(-1.0, 1.0, count + 1)
    points, triangles = [], []
    for axis, side in product(range(3), (-1.0, 1.0)):
        for i, j in product(range(count), repeat=2):
            square = [(steps[i + a], steps[j + b]) for a, b in product((0, 1), repeat=2)]
            corners = [np.roll([side, u, v], axis) for u, v in square]
            order = _RIGHT if side < 0 else [(a, c, b) for a, b, c in _RIGHT]
            triangles += [[len(points) + k for k in each] for each in order]
            points += corners
    return welded(np.array(points), np.array(triangles, dtype=np.int32))


def welded(points: Floats, triangles: Ints) -> tuple[Floats, Ints]:
    _, first, number = np.unique(np.round(points, 9), axis=0, return_index=True, return_inverse=True)
    return points[first], number.ravel()[triangles].astype(np.int32)


def ball(scale: tuple[float, float, float] = (1.0, 1.0, 1.0), count: int = 16) -> Target:
    """An ellipsoid on the grid of a cube."""
    points, triangles = cube_mesh(count)
    bent = np.tan(0.25 * np.pi * points)
    return Target(bent / np.linalg.norm(bent, axis=1, keepdims=True) * scale, triangles, "ball")


def box(size: tuple[float, float, float] = (1.0, 1.0, 1.0), count: int = 6) -> Target:
    points, triangles = cube_mesh(count)
    return Target(0.5 * points * size, triangles, "box")


def rounded_box(radius: float = 0.3, count: int = 20) -> Target:
    """The cube from -1 to 1 with edges of a radius."""
    points, triangles = cube_mesh(count)
    core = np.clip(points, radius - 1.0, 1.0 - radius)
    away = points - core
    points = core + radius * away / np.linalg.norm(away, axis=1, keepdims=True)
    return Target(points, triangles, "rounded box")


def revolved(profile: Callable[[Floats], tuple[Floats, Floats]], along: int = 40, around: int = 48) -> Target:
    """A body of revolution about z; profile: radius and height (k,) at (k,) from 0 to 1, from the bottom."""
    radius, height = profile(np.linspace(0.0, 1.0, along + 1))
    angles = 2.0 * np.pi * np.arange(around) / around
    rings = [
        np.column_stack([r * np.cos(angles), r * np.sin(angles), np.full(around, z)])
        for r, z in zip(radius[1:-1], height[1:-1])
    ]
    points = np.concatenate([[[0.0, 0.0, height[0]]], *rings, [[0.0, 0.0, height[-1]]]])
    last = len(points) - 1
    triangles = []
    for i in range(around):
        j = (i + 1) % around
        triangles.append((0, 1 + j, 1 + i))
        for k in range(along - 2):
            a = 1 + k * around
            triangles += [(a + i, a + j, a + around + j), (a + i, a + around + j, a + around + i)]
        a = 1 + (along - 2) * around
        triangles.append((a + i, a + j, last))
    return Target(points, np.array(triangles, dtype=np.int32), "body of revolution")


def capsule() -> Target:
    """A cylinder of radius 1 and length 2 with half balls."""

    def profile(share: Floats) -> tuple[Floats, Floats]:
        length = share * (np.pi + 2.0)
        low, high = np.minimum(length, 0.5 * np.pi), np.maximum(length - 2.0 - 0.5 * np.pi, 0.0)
        middle = np.clip(length - 0.5 * np.pi, 0.0, 2.0)
        return np.sin(low) * np.cos(high), -np.cos(low) + middle + np.sin(high)

    return revolved(profile)


def egg() -> Target:
    return revolved(lambda t: (np.sin(np.pi * t) * (1.0 - 0.2 * t), -1.3 * np.cos(np.pi * t)))


def pear() -> Target:
    def profile(t: Floats) -> tuple[Floats, Floats]:
        angle = np.pi * t
        return np.sin(angle) * (0.7 + 0.3 * np.cos(angle) ** 3 + 0.1 * np.cos(angle)), -1.4 * np.cos(angle)

    return revolved(profile)


def torus(outer: float = 1.0, tube: float = 0.4, around: int = 64, across: int = 32) -> Target:
    u, v = (grid.ravel() for grid in np.meshgrid(np.arange(around), np.arange(across), indexing="ij"))
    a, b = 2.0 * np.pi * u / around, 2.0 * np.pi * v / across
    radius = outer + tube * np.cos(b)
    points = np.column_stack([radius * np.cos(a), radius * np.sin(a), tube * np.sin(b)])
    here, right = u * across + v, (u + 1) % around * across + v
    above, both = u * across + (v + 1) % across, (u + 1) % around * across + (v + 1) % across
    triangles = np.concatenate([np.column_stack([here, right, both]), np.column_stack([here, both, above])])
    return Target(points, triangles.astype(np.int32), "torus")


def finer(target: Target, size: float) -> Target:
    points, triangles, _ = refined(target.points, target.triangles, size)
    return Target(points, triangles, target.source)

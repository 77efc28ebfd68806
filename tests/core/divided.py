# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closed bodies by formulas, divided into panels by formulas."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from solids import ball, box, revolved, torus

from BalloonWorkbench.core.targets.target import Division, Target
from BalloonWorkbench.core.types import Floats, Ints

NO_CUTS = np.zeros((0, 2), dtype=np.int32)


def divided(target: Target, panel_of: Callable[[Floats], Ints], cuts: Ints = NO_CUTS) -> Division:
    """By a number for each triangle's centre (m, 3); numbers need not be without gaps."""
    numbers = panel_of(target.points[target.triangles].mean(axis=1))
    _, panels = np.unique(numbers, return_inverse=True)
    names = tuple(f"Panel {k + 1}" for k in range(int(panels.max()) + 1))
    return Division(target, panels.ravel().astype(np.int32), names, cuts)


def gored_ball(count: int = 6) -> Division:
    shape = revolved(lambda t: (np.sin(np.pi * t), -np.cos(np.pi * t)), along=32, around=8 * count)
    return divided(shape, lambda at: _sector(at, count))


def _sector(at: Floats, count: int) -> Ints:
    return (np.arctan2(at[:, 1], at[:, 0]) % (2.0 * np.pi) * count / (2.0 * np.pi)).astype(np.int32)


def octants(scale: tuple[float, float, float] = (1.0, 1.0, 1.0), count: int = 12) -> Division:
    return divided(ball(scale, count), lambda at: (at > 0.0) @ np.array([1, 2, 4]))


def box_faces(size: tuple[float, float, float] = (1.0, 1.0, 1.0)) -> Division:
    def face(at: Floats) -> Ints:
        share = at / size
        axis = np.abs(share).argmax(axis=1)
        return 2 * axis + (share[np.arange(len(at)), axis] > 0.0)

    return divided(box(size), face)


def torus_panels(around: int = 4, across: int = 2) -> Division:
    def panel(at: Floats) -> Ints:
        tube = np.arctan2(at[:, 2], np.hypot(at[:, 0], at[:, 1]) - 1.0) % (2.0 * np.pi)
        return _sector(at, around) * across + (tube * across / (2.0 * np.pi)).astype(np.int32)

    return divided(torus(), panel)


def drum(around: int = 40, steps: int = 6, height: float = 1.5, upper: float = 1.0) -> Division:
    """A cylinder of radius 1, or a cone's stump: its side, cut open along x, and two discs."""
    angles = 2.0 * np.pi * np.arange(around) / around
    share = np.linspace(0.0, 1.0, steps + 1)
    rings = [
        np.column_stack([r * np.cos(angles), r * np.sin(angles), np.full(around, height * part)])
        for part, r in zip(share, 1.0 + (upper - 1.0) * share)
    ]
    points = np.concatenate([*rings, [[0.0, 0.0, 0.0], [0.0, 0.0, height]]])
    side, lids = [], []
    for j in range(around):
        k = (j + 1) % around
        for i in range(steps):
            a = i * around
            side += [(a + j, a + k, a + around + k), (a + j, a + around + k, a + around + j)]
        top = steps * around
        lids += [(k, j, len(points) - 2), (top + j, top + k, len(points) - 1)]
    panels = np.concatenate([np.zeros(len(side)), 1 + np.arange(len(lids)) % 2]).astype(np.int32)
    below = np.arange(steps) * around
    target = Target(points, np.array(side + lids, dtype=np.int32), "drum")
    cuts = np.column_stack([below, below + around]).astype(np.int32)
    return Division(target, panels, ("side", "bottom", "top"), cuts)

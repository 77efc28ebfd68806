# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cylinders, cones and frustums of few triangles, whose faces are laid flat exactly."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from BalloonWorkbench.core.flattening.developable import CONE, CYLINDER, PLANE, Developable, face_flats
from BalloonWorkbench.core.targets.half_edges import half_edges
from BalloonWorkbench.core.targets.target import Division, Target
from BalloonWorkbench.core.types import Floats

#: Few triangles round the bodies: their areas are wrong by more than a percent.
AROUND = 24
Z = np.array([0.0, 0.0, 1.0])


def turned(points: Floats) -> Floats:
    """Somewhere else in space, so that nothing lies along an axis."""
    turn = np.linalg.qr(np.array([[1.0, 0.4, -0.3], [0.2, 1.0, 0.7], [-0.5, 0.1, 1.0]]))[0]
    turn *= np.sign(np.linalg.det(turn))
    return np.asarray(points @ turn + (0.3, -0.2, 0.5))


def frustum(lower: float, upper: float, height: float) -> Division:
    """A frustum, or a cone with its apex, or a cylinder: its side, its discs."""
    angles = 2.0 * np.pi * np.arange(AROUND) / AROUND

    def ring(radius: float, z: float, at: Floats = angles) -> Floats:
        return np.stack([radius * np.cos(at), radius * np.sin(at), np.full_like(at, z)], axis=-1)

    sharp = upper == 0.0
    points = [ring(lower, 0.0), [(0.0, 0.0, height)] if sharp else ring(upper, height), [(0.0, 0.0, 0.0)]]
    points += [] if sharp else [np.array([(0.0, 0.0, height)])]
    there = np.concatenate(points)
    down, up = AROUND + (1 if sharp else AROUND), len(there) - 1
    triangles, owners = [], []
    for i in range(AROUND):
        j = (i + 1) % AROUND
        side = [(i, j, AROUND)] if sharp else [(i, j, AROUND + j), (i, AROUND + j, AROUND + i)]
        caps = [(down, j, i)] if sharp else [(down, j, i), (up, AROUND + i, AROUND + j)]
        triangles += [*side, *caps]
        owners += [0] * len(side) + [1, 2][: len(caps)]
    target = Target(turned(there), np.array(triangles, dtype=np.int32), "frustum")
    names = ("side", "lower", "upper")[: max(owners) + 1]
    division = Division(
        target, np.array(owners, dtype=np.int32), names, np.array([(0, AROUND)], dtype=np.int32)
    )
    origin, tip = turned(np.zeros((1, 3)))[0], turned(Z[None])[0]
    axis = tip - origin
    if lower == upper:
        side_surface = Developable(CYLINDER, origin, axis, lower)
    else:
        apex = origin + axis * lower * height / (lower - upper)
        side_surface = Developable(CONE, apex, axis, float(np.arctan2(lower - upper, height)))
    surfaces = [side_surface, Developable(PLANE, origin, axis), Developable(PLANE, origin + axis, axis)]
    edges = half_edges(target.triangles)
    bent, between = [], []
    for number, (one, other) in enumerate(edges.tolist()):
        radius, z = (lower, 0.0) if one < AROUND else (upper, height)
        if max(one, other) < AROUND or (
            min(one, other) >= AROUND and max(one, other) < 2 * AROUND and not sharp
        ):
            step = (other - one + AROUND // 2) % AROUND - AROUND // 2
            at = 2.0 * np.pi / AROUND * (one % AROUND + step * np.array([0.25, 0.5, 0.75]))
            bent.append(number)
            between.append(turned(ring(radius, z, at)))
    flats = face_flats(division, surfaces[: len(names)], np.array(bent), np.array(between))
    return replace(division, flats=flats)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far inflated gores are from the body of revolution: all their film, middle lines and seams."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.bags.mesh_bag import MeshedBag
from BalloonWorkbench.core.bodies.gores import Gores, laid_along
from BalloonWorkbench.core.bodies.profile import POINT, Profile
from BalloonWorkbench.core.design.design import Residual
from BalloonWorkbench.core.design.film_residual import film_residual
from BalloonWorkbench.core.geometry.nearest import nearest_on_line
from BalloonWorkbench.core.geometry.polyline import line_lengths, point_on
from BalloonWorkbench.core.geometry.triangulation import Located
from BalloonWorkbench.core.geometry.vectors import perpendicular, unit
from BalloonWorkbench.core.panels.assembly import Assembly
from BalloonWorkbench.core.types import Floats

#: Places along a gore.
STATIONS = 60


def beside_axis(positions: Floats) -> Floats:
    """Positions (n, 3) as distance r from the z axis, and z: (n, 2)."""
    return np.column_stack([np.hypot(positions[:, 0], positions[:, 1]), positions[:, 2]])


def off_profile(profile: Profile, points: Floats) -> tuple[Floats, Floats]:
    """Distances (k,) of points (k, 2) r, z from a profile, positive outside, and its normals there (k, 2)."""
    line = profile.points
    edge, share, _ = nearest_on_line(line, points)
    ahead = np.diff(line, axis=0)
    normals = -perpendicular(unit(ahead))[edge]
    off = points - (line[edge] + share[:, None] * ahead[edge])
    return np.einsum("kd,kd->k", off, normals), normals


def profile_ends(profile: Profile) -> list[tuple[int, Floats, Floats]]:
    """For each end that is no point, lower first: its station, its place (2,) r, z [m], the way upwards."""
    line = profile.points
    kinds = ((0, profile.lower, line[1] - line[0]), (-1, profile.upper, line[-1] - line[-2]))
    return [(end, line[end], unit(ahead)) for end, kind, ahead in kinds if kind != POINT]


def moves_off(positions: Floats, normals: Floats, changes: Floats) -> Floats:
    """How distances (n,) follow changes (n, 3, k) of positions (n, 3): along normals (n, 2) r, z; (n, k)."""
    r = np.maximum(np.hypot(positions[:, 0], positions[:, 1]), 1e-9 * np.abs(positions).max())
    radial = np.einsum("ni,nik->nk", positions[:, :2] / r[:, None], changes[:, :2])
    return np.asarray(normals[:, :1] * radial + normals[:, 1:] * changes[:, 2])


def across_gores(meshed: MeshedBag, gores: Gores, count: int, field: Floats) -> Floats:
    """Means over all gores of a field (n, c), at STATIONS places along three lines of a gore: (3, m, c).

    The lines are its middle line, those half way between it and the edges, the edges.
    """
    at = np.linspace(0.0, 1.0, STATIONS)
    half = np.interp(at, gores.along / gores.along[-1], gores.half_widths)
    upwards = gores.stretch * gores.along[-1] * at
    upright = np.concatenate([np.column_stack([share * half, upwards]) for share in (0.0, 0.5, -0.5)])
    places = laid_along(upright)
    total = np.zeros((3, STATIONS, field.shape[1]))
    for number in range(count):
        panel, first = meshed.assembly.panels[number], meshed.assembly.offsets[number]
        own = field[first : meshed.assembly.offsets[number + 1]]
        inside = Located(panel.rest_positions, panel.triangles).values(own, places)
        middle, right, left = inside.reshape(3, STATIONS, -1)
        edge = meshed.assembly.seams[number].first.vertices  # of the right edge, from below
        lengths = line_lengths(panel.rest_positions[edge])
        total += [middle, 0.5 * (right + left), point_on(own[edge], lengths, at * lengths[-1])]
    return total / count


def gore_residual(profile: Profile, assembly: Assembly, positions: Floats, count: int) -> Residual:
    """How far the film of so many gores is from the body of revolution, each piece of it by its area [m]."""
    triangles = assembly.surface.triangles
    triangles = triangles[(triangles < assembly.offsets[count]).all(axis=1)]
    away, _ = off_profile(profile, beside_axis(positions))
    return film_residual(away, positions, triangles)

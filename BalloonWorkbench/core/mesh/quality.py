# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures of a flat triangulation."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.geometry.triangulation import corner_angles, side_lengths, signed_areas
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.types import Bools, Floats, Ints

#: A triangle is worn out when its longest edge exceeds this multiple of its inscribed radius
#: (the mesh reuse rule of the balloon design paper, 15 R < L; an equilateral one has 3.5).
WORN_RATIO = 15.0


def min_angles(panel: Panel) -> Floats:
    """Smallest angle (m,) of each triangle [rad]."""
    return corner_angles(panel.rest_positions, panel.triangles).min(axis=1)


def flipped(panel: Panel) -> Bools:
    """Which triangles (m,) have lost their counter-clockwise orientation."""
    return signed_areas(panel.rest_positions, panel.triangles) <= 0.0


def worn(panel: Panel) -> Bools:
    """Which triangles (m,) break the reuse rule: longest edge above 15 inscribed radii."""
    edges = side_lengths(panel.rest_positions, panel.triangles)
    areas = np.abs(signed_areas(panel.rest_positions, panel.triangles))
    inscribed = 2.0 * areas / edges.sum(axis=1)
    return WORN_RATIO * inscribed < edges.max(axis=1)


def locked(panel: Panel) -> Bools:
    """Which triangles (m,) have all three vertices on a seam or weld: pressure cannot lift them."""
    on_seam = np.zeros(len(panel.rest_positions), dtype=bool)
    on_seam[panel.sealed] = True
    return on_seam[panel.triangles].all(axis=1)


def interior_edges(triangles: Ints) -> tuple[Ints, Ints]:
    """Edges (k, 2) between two triangles and the two vertices (k, 2) opposite to each."""
    edges = np.concatenate([triangles[:, [1, 2]], triangles[:, [2, 0]], triangles[:, [0, 1]]])
    opposite = triangles.T.ravel()
    order = np.lexsort((edges.max(axis=1), edges.min(axis=1)))
    ends = np.sort(edges[order], axis=1)
    twin = np.flatnonzero((ends[1:] == ends[:-1]).all(axis=1))
    return ends[twin], np.stack([opposite[order[twin]], opposite[order[twin + 1]]], axis=1)


def delaunay_loss(panel: Panel) -> float:
    """Share of interior edges that are clearly not Delaunay (opposite angles above 180 + 20 degrees)."""
    edges, opposite = interior_edges(panel.triangles)
    if not len(edges):
        return 0.0
    p, q = panel.rest_positions[edges[:, 0]], panel.rest_positions[edges[:, 1]]
    total = np.zeros(len(edges))
    for side in range(2):
        u, v = p - panel.rest_positions[opposite[:, side]], q - panel.rest_positions[opposite[:, side]]
        cosine = (u * v).sum(axis=1) / (np.linalg.norm(u, axis=1) * np.linalg.norm(v, axis=1))
        total += np.arccos(np.clip(cosine, -1.0, 1.0))
    return float(np.mean(total > np.radians(200.0)))

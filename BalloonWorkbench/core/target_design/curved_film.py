# SPDX-License-Identifier: LGPL-2.1-or-later
"""The film between the vertices of its mesh: its directors tell how it is bent there."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.geometry.vectors import unit
from BalloonWorkbench.core.panels.surface import Surface
from BalloonWorkbench.core.types import Floats, Ints


def curved_film(positions: Floats, directors: Floats, surface: Surface) -> tuple[Floats, Ints]:
    """Closed triangles (4 m, 3) of points (k, 3) m: of those of the mesh, with the middles of their sides.

    positions, directors  (n, 3) of the vertices. The middle of a side e stands (d_j - d_i) e / 8 above it, as
    in the volume of the solver; at a seam that is the mean of both panels. Vertices that a seam makes one
    are one.
    """
    triangles = surface.triangles
    begin, end = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
    along = positions[end] - positions[begin]
    lift = np.einsum("ij,ij->i", directors[end] - directors[begin], along) / 8.0
    normals = unit(directors[begin] + directors[end])
    middles = 0.5 * (positions[begin] + positions[end]) + lift[:, None] * normals
    glued = surface.first[triangles]
    _, number = sides(surface)
    counts = np.bincount(number)
    places = np.column_stack([np.bincount(number, middles[:, k]) / counts for k in range(3)])
    a, b, c = glued.T
    p, q, r = (len(positions) + number.reshape(-1, 3)).T  # of the sides ab, bc, ca
    parts = [np.column_stack(each) for each in ((a, p, r), (p, b, q), (r, q, c), (p, q, r))]
    return np.concatenate([positions, places]), np.concatenate(parts).astype(np.int32)


def sides(surface: Surface) -> tuple[Ints, Ints]:
    """Ends (s, 2) of the sides of its triangles, in the order of their middles in curved_film, and the number
    (3 m,) of the side of each edge of a triangle."""
    begin, end = surface.triangles.ravel(), np.roll(surface.triangles, -1, axis=1).ravel()
    ends = np.sort(np.column_stack([surface.first[begin], surface.first[end]]), axis=1)
    different, number = np.unique(ends, axis=0, return_inverse=True)
    return different, number.ravel().astype(np.int32)

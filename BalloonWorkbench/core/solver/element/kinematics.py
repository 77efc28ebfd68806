# SPDX-License-Identifier: LGPL-2.1-or-later
"""Geometry of the deformed film: strains and the volume it encloses."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.types import Floats, Ints


def deformation_gradients(positions: Floats, triangles: Ints, shape_gradients: Floats) -> Floats:
    """F = dx/dX of each triangle: (m, 3, 2), from gradients of the area coordinates (m, 3, 2)."""
    return np.einsum("mai,mak->mik", positions[triangles], shape_gradients)


def green_strains(gradients: Floats) -> Floats:
    """Green strains E11, E22, 2 E12 (m, 3) of deformation gradients (m, 3, 2)."""
    f1, f2 = gradients[:, :, 0], gradients[:, :, 1]
    return np.column_stack(
        [
            0.5 * (np.einsum("ij,ij->i", f1, f1) - 1.0),
            0.5 * (np.einsum("ij,ij->i", f2, f2) - 1.0),
            np.einsum("ij,ij->i", f1, f2),
        ]
    )


def facet_volume(positions: Floats, triangles: Ints) -> float:
    """Volume between the facets and the plane z = 0 that holds their rim."""
    a, b, c = np.moveaxis(positions[triangles], 1, 0)
    return float(np.einsum("ij,ij->", a, np.cross(b, c))) / 6.0


def first_moment(positions: Floats, triangles: Ints) -> float:
    """The integral of z over the inside of closed facets."""
    a, b, c = np.moveaxis(positions[triangles], 1, 0)
    heights = a[:, 2] + b[:, 2] + c[:, 2]  # of each facet with the origin a tetrahedron
    return float(np.einsum("ij,ij,i->", a, np.cross(b, c), heights)) / 24.0


def sag_volume(positions: Floats, directors: Floats, triangles: Ints) -> float:
    """Volume between the facets and the curved film above them.

    The directors at the ends of an edge e differ by the curvature along it, so that the middle of the film
    stands (d_j - d_i) . e / 8 above the edge's; a quadratic triangle holds a third of its area times the sum
    of these.
    """
    corners, normals = positions[triangles], directors[triangles]
    edges = np.roll(corners, -1, axis=1) - corners
    areas = 0.5 * np.linalg.norm(np.cross(edges[:, 0], edges[:, 1]), axis=1)
    turns = np.roll(normals, -1, axis=1) - normals
    return float(areas @ np.einsum("mki,mki->m", turns, edges)) / 24.0


def film_volume(positions: Floats, directors: Floats, triangles: Ints) -> float:
    """Volume under the film, to a higher order than the facets'.

    A fibre that cannot stretch, replaced by chords of its own length with angles theta between them, encloses
    theta^2 / 12 too little; the sag above the chords is twice that. Half the sag volume restores the loss.
    """
    return facet_volume(positions, triangles) + 0.5 * sag_volume(positions, directors, triangles)

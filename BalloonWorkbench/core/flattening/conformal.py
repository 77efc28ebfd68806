# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles in space laid flat for a start: angles kept as well as can be, exactly where they unroll.

Points of the plane are complex numbers. A map that keeps angles has no derivative by the conjugate; its
least squares give a linear system (Levy, Petitjean, Ray and Maillot 2002). A panel that folds so is laid into
a circle instead, each inner point in the mean of those beside it, which never folds (Tutte 1963).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.flattening.factor import factored, sparse
from BalloonWorkbench.core.targets.half_edges import half_edges
from BalloonWorkbench.core.types import Floats, Ints

Complex = NDArray[np.complex128]


def own_planes(points: Floats, triangles: Ints) -> Complex:
    """Corners (m, 3) of triangles in space, each in its own plane: one at 0, the next on the x axis."""
    a, b, c = np.moveaxis(points[triangles], 1, 0)
    base = np.maximum(np.linalg.norm(b - a, axis=1), 1e-300)
    along = np.einsum("ij,ij->i", c - a, b - a) / base
    height = np.linalg.norm(np.cross(b - a, c - a), axis=1) / base
    return np.stack([np.zeros(len(a), dtype=np.complex128), base + 0j, along + 1j * height], axis=1)


def signed_areas_of(places: Complex, triangles: Ints) -> Floats:
    """Areas (m,) of triangles between places (n,), positive when counter-clockwise."""
    a, b, c = places[triangles].T
    return np.asarray(0.5 * np.imag(np.conj(b - a) * (c - a)))


def laid_flat(points: Floats, triangles: Ints, loops: Sequence[Ints], area: float) -> Complex:
    """Places (n,) of one panel's points (n, 3), as large as it is in space [m2].

    loops  vertices of its boundary loops, the longest first
    """
    places = _conformal(points, triangles, loops[0])
    if not (signed_areas_of(places, triangles) > 0.0).all():
        places = _in_circle(points, triangles, loops)
    flat = float(signed_areas_of(places, triangles).sum())
    return places * np.sqrt(area / max(flat, 1e-300))


def _conformal(points: Floats, triangles: Ints, rim: Ints) -> Complex:
    """Places (n,) of least squares; two points of the rim that are far apart are held."""
    package, count = sparse(), len(points)
    corners = own_planes(points, triangles)
    opposite = np.roll(corners, -2, axis=1) - np.roll(corners, -1, axis=1)
    double_area = np.maximum(np.imag(np.conj(corners[:, 1]) * corners[:, 2]), 1e-300)
    values = (opposite / np.sqrt(double_area)[:, None]).ravel()
    rows = np.repeat(np.arange(len(triangles)), 3)
    matrix = package.csc_matrix((values, (rows, triangles.ravel())), shape=(len(triangles), count))
    first = int(rim[np.argmax(np.linalg.norm(points[rim] - points[rim].mean(axis=0), axis=1))])
    distances = np.linalg.norm(points[rim] - points[first], axis=1)
    last = int(rim[np.argmax(distances)])
    free = np.setdiff1d(np.arange(count), [first, last])
    places = np.zeros(count, dtype=np.complex128)
    places[last] = max(float(distances.max()), 1e-300)
    adjoint = matrix[:, free].conj().T.tocsr()
    normal = (adjoint @ matrix[:, free]).tocsc()
    places[free] = factored(normal).solve(-(adjoint @ (matrix @ places)))
    return places


def _in_circle(points: Floats, triangles: Ints, loops: Sequence[Ints]) -> Complex:
    """Places (n,) in a circle, on whose rim the first loop lies; other loops are closed with a point each."""
    package, count = sparse(), len(points)
    rim = loops[0]
    steps = np.linalg.norm(points[np.roll(rim, -1)] - points[rim], axis=1)
    angles = 2.0 * np.pi * np.append(0.0, np.cumsum(steps)[:-1]) / steps.sum()
    spokes = [np.column_stack([hole, np.full(len(hole), count + k)]) for k, hole in enumerate(loops[1:])]
    edges = np.concatenate([half_edges(triangles), *spokes])
    whole = count + len(spokes)
    ends = np.concatenate([edges, edges[:, ::-1]])
    beside = package.csr_matrix((np.ones(len(ends)), (ends[:, 0], ends[:, 1])), shape=(whole, whole))
    beside.data[:] = 1.0
    laplacian = package.diags(np.asarray(beside.sum(axis=1)).ravel()) - beside
    free = np.setdiff1d(np.arange(whole), rim)
    places = np.zeros(whole, dtype=np.complex128)
    places[rim] = np.exp(1j * angles)
    if len(free):
        loads = -(laplacian[free] @ places)
        solve = factored(laplacian[free][:, free]).solve
        places[free] = solve(loads.real) + 1j * solve(loads.imag)
    return places[:count]

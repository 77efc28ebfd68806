# SPDX-License-Identifier: LGPL-2.1-or-later
"""Half-edges of triangles in space: half-edge 3 t + k runs from corner k of triangle t to the next one."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.packages import without_scipy
from BalloonWorkbench.core.panels.surface import first_of_each
from BalloonWorkbench.core.types import Bools, Floats, Ints

Indices = NDArray[np.intp]


def half_edges(triangles: Ints) -> Ints:
    """Vertices (3 m, 2) from and to which the half-edges of triangles (m, 3) run."""
    return np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2).reshape(-1, 2)


def twins(triangles: Ints) -> Indices:
    """For each half-edge (3 m,) the one that runs back between the same vertices; -1 where there is none.

    Of several that run the same way the first is taken.
    """
    edges = half_edges(triangles).astype(np.int64)
    count = int(edges.max()) + 1 if len(edges) else 1
    ahead, back = edges @ (count, 1), edges @ (1, count)
    order = np.argsort(ahead, kind="stable")
    place = np.searchsorted(ahead[order], back)
    partner = order[np.minimum(place, len(order) - 1)] if len(order) else order
    return np.where(ahead[partner] == back, partner, -1)


def ahead(edges: Indices) -> Indices:
    """The half-edges that follow in the same triangles: they start where these end."""
    return np.asarray(edges - edges % 3 + (edges + 1) % 3)


def first_corners(twin: Indices, inside: Bools) -> Ints:
    """For each corner (3 m,) of the triangles the first that is one with it.

    twin    (3 m,) of each half-edge
    inside  (3 m,) half-edges across which the surface hangs together; both of an edge, or none
    """
    edges = np.flatnonzero(inside)
    other = twin[edges]
    # the start of an edge is the end of its twin, and the other way round
    pairs = [np.column_stack([edges, ahead(other)]), np.column_stack([ahead(edges), other])]
    return first_of_each(len(twin), np.concatenate(pairs))


def euler_numbers(twin: Indices, labels: Ints) -> Ints:
    """Vertices - edges + triangles of each region (p,), by itself: 1 for a disc, 0 for a ring.

    twin    (3 m,) of each half-edge, -1 at the border of the surface
    labels  (m,) region of each triangle, from 0
    """
    own = np.repeat(labels, 3)
    inside = (twin >= 0) & (own == own[twin])
    count = int(labels.max()) + 1
    vertices = np.bincount(own[np.unique(first_corners(twin, inside))], minlength=count)
    edges = np.bincount(own, np.where(inside, 0.5, 1.0), count)
    return np.rint(vertices - edges + np.bincount(labels, minlength=count)).astype(np.int32)


def connected_parts(count: int, one: Indices, other: Indices) -> Ints:
    """The part (count,) of each of so many things, of which pairs (k,) hang together; from 0."""
    try:
        from scipy.sparse import coo_matrix, csgraph
    except ImportError as error:
        raise without_scipy("Dividing a body needs scipy: install it with pip install scipy.") from error
    graph = coo_matrix((np.ones(len(one)), (one, other)), shape=(count, count))
    return np.asarray(csgraph.connected_components(graph, directed=False)[1], dtype=np.int32)


def area_vectors(points: Floats, triangles: Ints) -> Floats:
    """Normals (m, 3) of triangles in space, as long as their areas [m2]."""
    a, b, c = np.moveaxis(points[triangles], 1, 0)
    return 0.5 * np.cross(b - a, c - a)


def enclosed_volume(points: Floats, triangles: Ints) -> float:
    """Volume [m3] inside triangles that are counter-clockwise seen from outside; negative if clockwise."""
    a, b, c = np.moveaxis(points[triangles] - points.mean(axis=0), 1, 0)
    return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6.0)

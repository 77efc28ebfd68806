# SPDX-License-Identifier: LGPL-2.1-or-later
"""Constrained Delaunay triangulation of points inside closed loops."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.errors import MeshError
from BalloonWorkbench.core.geometry.polyline import bounds
from BalloonWorkbench.core.geometry.triangulation import signed_areas
from BalloonWorkbench.core.mesh.recovery import CROSSING, recovered
from BalloonWorkbench.core.packages import without_scipy
from BalloonWorkbench.core.types import Bools, Floats, Ints

try:
    import pythoncdt
except ImportError:  # SciPy's, with its missing edges recovered, takes five times as long
    pythoncdt = None


def triangulate_points(points: Floats, loops: tuple[Ints, ...], lines: tuple[Ints, ...] = ()) -> Ints:
    """Triangles (m, 3), counter-clockwise, that fill the area between loops of vertex indices.

    Steps along open lines of vertex indices become edges too.
    points (n, 2); no vertex is added. Raises MeshError when loops cross or vertices coincide.
    """
    rims = np.concatenate([np.stack([loop, np.roll(loop, -1)], axis=1) for loop in loops])
    segments = np.concatenate([rims, *(np.stack([line[:-1], line[1:]], axis=1) for line in lines)])
    if pythoncdt is not None:
        return _by_pythoncdt(points, segments)
    framed, triangles, neighbours = _delaunay(points)
    count = len(framed)
    missing = ~np.isin(_names(segments, count), _sides(triangles, count))
    if missing.any():
        triangles, neighbours = recovered(framed, triangles, neighbours, segments, missing)
    return _enclosed(triangles, neighbours, np.isin(_sides(triangles, count), _names(rims, count)))


def _by_pythoncdt(points: Floats, segments: Ints) -> Ints:
    mesh = pythoncdt.Triangulation(
        pythoncdt.VertexInsertionOrder.AUTO, pythoncdt.IntersectingConstraintEdges.NOT_ALLOWED, 0.0
    )
    try:
        mesh.insert_vertices(np.ascontiguousarray(points, dtype=np.float64))
        mesh.insert_edges(np.ascontiguousarray(segments, dtype=np.uint32))
    except RuntimeError as error:
        raise MeshError(CROSSING) from error
    mesh.erase_outer_triangles_and_holes()
    return np.asarray(mesh.triangles_array()["vertices"].astype(np.int32))


def _delaunay(points: Floats) -> tuple[Floats, Ints, Ints]:
    """Points (n + 4, 2) of a size of 1 in a wide frame, triangles (m, 3) and their neighbours by corner.

    The frame keeps the boundary off the convex hull, where Qhull may drop collinear points.
    """
    try:
        from scipy.spatial import Delaunay
    except ImportError as error:
        raise without_scipy("Meshing needs scipy: install it with pip install scipy.") from error
    low, high = bounds(points)
    middle, reach = 0.5 * (low + high), 2.0 * float(np.max(high - low))
    frame = middle + reach * np.array([[-1.0, -1.1], [1.1, -1.0], [1.0, 1.1], [-1.1, 1.0]])
    plain = Delaunay((np.concatenate([points, frame]) - middle) / reach)
    if len(plain.coplanar):
        raise MeshError(CROSSING)
    clockwise = (signed_areas(plain.points, plain.simplices) < 0.0)[:, None]
    triangles, neighbours = (
        np.where(clockwise, rows[:, [0, 2, 1]], rows) for rows in (plain.simplices, plain.neighbors)
    )
    return plain.points, triangles, neighbours


def _enclosed(triangles: Ints, neighbours: Ints, walls: Bools) -> Ints:
    """Triangles inside: an odd number of walls, sides (m, 3) of theirs, away from the hull."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    count = len(triangles)
    one = np.repeat(np.arange(count), 3)
    beside, wall = neighbours.ravel(), walls.ravel()
    hull = beside < 0
    open_ = ~wall & ~hull
    joined = coo_array((np.ones(open_.sum(), dtype=np.int8), (one[open_], beside[open_])), (count, count))
    parts, part = connected_components(joined, directed=False)
    depth = np.full(parts, -1)
    depth[part[one[hull]]] = 0
    here, there = part[one[wall]], part[beside[wall]]
    for level in range(parts):
        next_in = there[(depth[here] == level) & (depth[there] < 0)]
        depth[next_in] = level + 1
    return np.asarray(triangles[depth[part] % 2 == 1], dtype=np.int32)


def _sides(triangles: Ints, count: int) -> Ints:
    """Names (m, 3) of the edges opposite to each corner."""
    return _names(np.stack([np.roll(triangles, -1, axis=1), np.roll(triangles, -2, axis=1)], axis=-1), count)


def _names(edges: Ints, count: int) -> Ints:
    """A number for each edge (..., 2) between `count` points, whichever way it runs."""
    return np.asarray(edges.min(axis=-1).astype(np.int64) * count + edges.max(axis=-1))

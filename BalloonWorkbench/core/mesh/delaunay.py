# SPDX-License-Identifier: LGPL-2.1-or-later
"""Constrained Delaunay triangulation of given points inside closed loops."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.errors import MeshError
from BalloonWorkbench.core.types import Floats, Ints

try:
    import pythoncdt
except ImportError:  # scipy with boundary recovery does the same, more slowly
    pythoncdt = None


def triangulate_points(points: Floats, loops: tuple[Ints, ...], lines: tuple[Ints, ...] = ()) -> Ints:
    """Triangles (m, 3), counter-clockwise, that fill the area between loops of vertex indices.

    Steps along open lines of vertex indices become edges too.
    points (n, 2); no vertex is added. Raises MeshError when loops cross or vertices coincide.
    """
    segments = np.concatenate(
        [np.stack([loop, np.roll(loop, -1)], axis=1) for loop in loops]
        + [np.stack([line[:-1], line[1:]], axis=1) for line in lines]
    )
    if pythoncdt is None:
        from BalloonWorkbench.core.mesh.recovery import recovered_delaunay

        return recovered_delaunay(points, segments)
    mesh = pythoncdt.Triangulation(
        pythoncdt.VertexInsertionOrder.AUTO, pythoncdt.IntersectingConstraintEdges.NOT_ALLOWED, 0.0
    )
    try:
        mesh.insert_vertices(np.ascontiguousarray(points, dtype=np.float64))
        mesh.insert_edges(np.ascontiguousarray(segments, dtype=np.uint32))
    except RuntimeError as error:
        raise MeshError(
            "The outline crosses or touches itself and cannot be meshed: separate the parts that meet."
        ) from error
    mesh.erase_outer_triangles_and_holes()
    return mesh.triangles_array()["vertices"].astype(np.int32)

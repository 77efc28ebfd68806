# SPDX-License-Identifier: LGPL-2.1-or-later
"""Start shapes: a flat film is singular under pressure, so the simulation begins from a dome."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.mesh.panel import Panel
from BalloonWorkbench.core.solver.dkt import gradients
from BalloonWorkbench.core.solver.linear import conjugate_gradients
from BalloonWorkbench.core.types import Floats

ACCURATE = 1e-3  # a start need not be better
# z = DOME sqrt(u) has the height of a long pillow, w/pi, over a strip of width w (u = w^2/8 at the middle)
DOME = 2.0 * np.sqrt(2.0) / np.pi


def dome(panel: Panel) -> Floats:
    """Positions (n, 3) over the flat panel: z = DOME sqrt(u), -Laplace(u) = 1, u = 0 on seams and welds."""
    count = len(panel.rest_positions)
    corners = np.ascontiguousarray(panel.triangles.T, dtype=np.intp)  # as bincount takes them
    after, before = [1, 2, 0], [2, 0, 1]
    shape, areas = gradients(panel.rest_positions[panel.triangles])
    # between each corner and the next; the rows of the stiffness sum to zero
    coupling = -areas * np.einsum("mai,mai->am", shape, shape[:, after])

    def at_vertices(corner_values: Floats) -> Floats:
        return np.bincount(corners.ravel(), corner_values.ravel(), count).astype(np.float64, copy=False)

    load = at_vertices(np.tile(areas / 3.0, 3))
    held = panel.sealed
    load[held] = 0.0

    def laplace(values: Floats) -> Floats:
        here = values[corners]
        flow = coupling * (here - here[after])
        result = at_vertices(flow - flow[before])
        result[held] = 0.0
        return result

    diagonal = at_vertices(coupling + coupling[before])
    height = conjugate_gradients(laplace, load, lambda residual: residual / diagonal, ACCURATE).solution
    return np.column_stack([panel.rest_positions, DOME * np.sqrt(np.maximum(height, 0.0))])


def vertex_normals(positions: Floats, panel: Panel) -> Floats:
    """Area-weighted unit normals (n, 3)."""
    a, b, c = np.moveaxis(positions[panel.triangles], 1, 0)
    area_vectors = np.cross(b - a, c - a)
    corners = panel.triangles.astype(np.intp).ravel()
    normals = np.column_stack(
        [np.bincount(corners, np.repeat(part, 3), len(positions)) for part in area_vectors.T]
    )
    return np.asarray(normals / np.linalg.norm(normals, axis=1)[:, None])

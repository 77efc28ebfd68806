# SPDX-License-Identifier: LGPL-2.1-or-later
"""Start shapes: a flat film is singular under pressure, so the simulation begins from a dome."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.mesh.panel import Panel
from BalloonWorkbench.core.solver.dkt import gradients
from BalloonWorkbench.core.solver.linear import conjugate_gradients
from BalloonWorkbench.core.types import Floats

# z = DOME sqrt(u) has the height of a long pillow, w/pi, over a strip of width w (u = w^2/8 at the middle)
DOME = 2.0 * np.sqrt(2.0) / np.pi


def dome(panel: Panel) -> Floats:
    """Positions (n, 3) over the flat panel: z = DOME sqrt(u), -Laplace(u) = 1, u = 0 on the seams."""
    count = len(panel.rest_positions)
    shape, areas = gradients(panel.rest_positions[panel.triangles])
    stiffness = np.einsum("mai,mbi->mab", shape, shape) * areas[:, None, None]

    def at_vertices(corner_values: Floats) -> Floats:
        return np.bincount(panel.triangles.ravel(), corner_values.ravel(), count).astype(np.float64)

    load = at_vertices(np.repeat(areas / 3.0, 3))
    held = np.concatenate(panel.seams)
    load[held] = 0.0

    def laplace(values: Floats) -> Floats:
        result = at_vertices(np.einsum("mab,mb->ma", stiffness, values[panel.triangles]))
        result[held] = 0.0
        return result

    diagonal = at_vertices(np.einsum("maa->ma", stiffness))
    height = conjugate_gradients(laplace, load, lambda residual: residual / diagonal, 1e-6).solution
    return np.column_stack([panel.rest_positions, DOME * np.sqrt(np.maximum(height, 0.0))])


def vertex_normals(positions: Floats, panel: Panel) -> Floats:
    """Area-weighted unit normals (n, 3)."""
    a, b, c = np.moveaxis(positions[panel.triangles], 1, 0)
    area_vectors = np.cross(b - a, c - a)
    normals = np.zeros_like(positions)
    for corner in range(3):
        np.add.at(normals, panel.triangles[:, corner], area_vectors)
    return np.asarray(normals / np.linalg.norm(normals, axis=1)[:, None])

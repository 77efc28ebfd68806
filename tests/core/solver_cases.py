# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panels, films and measures for the tests of the solver."""

from __future__ import annotations

import shutil
from functools import cache

import numpy as np
import pytest
from drawn_shapes import corners_of

from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.solver.backend import Backend
from BalloonWorkbench.core.solver.element.dkt import gradients
from BalloonWorkbench.core.solver.equilibrium import newton
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.native import c_interface, load
from BalloonWorkbench.core.solver.native.c_interface import CONSTANTS
from BalloonWorkbench.core.types import Bools, Floats, Ints

PRESSURE = 100.0  # Pa
#: For programs in C that use the native solver: the constants that Python declares.
WITH_CONSTANTS = f"-DCONSTANTS={','.join(map(repr, CONSTANTS.values()))}"
NATIVE = Backend("native", c_interface.solve, c_interface.energies, c_interface.tangent_solve)
NUMPY = Backend("numpy", newton.solve, newton.energies, newton.tangent_solve)

#: Where nothing can be compiled the native solver cannot be tested; anywhere else it has to be there.
needs_native = pytest.mark.skipif(
    load.problem_with_library() is not None and not (shutil.which("cmake") and shutil.which("c++")),
    reason="no compiler for the native solver",
)
both_backends = pytest.mark.parametrize("backend", [pytest.param("native", marks=needs_native), "numpy"])
both_solvers = pytest.mark.parametrize(
    "solver", [pytest.param(NATIVE, marks=needs_native), NUMPY], ids=lambda solver: solver.name
)


def film(k: float, *, seal_width: float = 0.0, poisson_ratio: float = 0.3) -> Film:
    """A film with E t = k p L at PRESSURE, L = 1 m."""
    thickness = 25e-6
    return Film("test", k * PRESSURE / thickness, poisson_ratio, thickness, 0.03, seal_width)


def circle(radius: float, points: int = 720) -> Floats:
    turn = np.linspace(0.0, 2.0 * np.pi, points, endpoint=False)
    return radius * np.column_stack([np.cos(turn), np.sin(turn)])


SHAPES = {
    "disc": Outline(circle(1.0)),
    "ring": Outline(circle(1.0), (circle(0.5)[::-1].copy(),)),
    "square": corners_of((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)),
    "rectangle": corners_of((-1.5, -0.5), (1.5, -0.5), (1.5, 0.5), (-1.5, 0.5)),
    "strip": corners_of((-0.5, -0.02), (0.5, -0.02), (0.5, 0.02), (-0.5, 0.02)),
}


@cache
def panel(shape: str, vertices: int = 1500) -> Panel:
    return triangulate(SHAPES[shape], size_for(SHAPES[shape], vertices))


def inflated(
    shape: str, k: float, backend: str, *, seal_width: float = 0.0, vertices: int = 1500
) -> Inflation:
    """The shape filled at PRESSURE, solved once and shared by the tests."""
    return _inflated(shape, k, backend, seal_width, vertices)


@cache
def _inflated(shape: str, k: float, backend: str, seal_width: float, vertices: int) -> Inflation:
    result = inflate(panel(shape, vertices), film(k, seal_width=seal_width), PRESSURE, backend=backend)
    assert result.report.backend == backend
    assert result.report.converged
    return result


def radii(inflation: Inflation, seam: int) -> Floats:
    """Distances of the vertices of a seam from their centre."""
    rim = inflation.positions[inflation.panel.loops[seam], :2]
    return np.linalg.norm(rim - rim.mean(axis=0), axis=1)


def silhouette_radii(inflation: Inflation, rays: int = 720) -> Floats:
    """How far the film reaches along rays from the axis, seen from above."""
    points, triangles = inflation.positions[:, :2], inflation.panel.triangles
    start, end = (points[triangles[:, columns].ravel()] for columns in ([0, 1, 2], [1, 2, 0]))
    along = end - start
    reach = np.empty(rays)
    for ray, angle in enumerate(np.linspace(0.0, 2.0 * np.pi, rays, endpoint=False)):
        cosine, sine = np.cos(angle), np.sin(angle)
        across = cosine * along[:, 1] - sine * along[:, 0]
        with np.errstate(divide="ignore", invalid="ignore"):
            share = (sine * start[:, 0] - cosine * start[:, 1]) / across
            far = (start + share[:, None] * along) @ (cosine, sine)
        reach[ray] = far[(share >= 0.0) & (share <= 1.0)].max()
    return reach


def crown(inflation: Inflation, sectors: int = 24) -> float:
    """Thickness of the balloon at the crown of a ring, averaged around the axis."""
    x, y, z = inflation.positions.T
    sector = np.floor((np.arctan2(y, x) / (2.0 * np.pi) + 0.5) * sectors).astype(int) % sectors
    return 2.0 * float(np.mean([z[sector == index].max() for index in range(sectors)]))


def flat_state(points: Floats) -> tuple[Floats, Floats]:
    """Positions and directors of a film at rest in z = 0."""
    return np.column_stack([points, np.zeros(len(points))]), np.tile([0.0, 0.0, 1.0], (len(points), 1))


def grid(columns: int, rows: int, length: float, width: float) -> tuple[Floats, Ints]:
    """A rectangle of columns x rows cells with alternating diagonals."""
    x, y = np.meshgrid(
        np.linspace(0.0, length, columns + 1), np.linspace(0.0, width, rows + 1), indexing="ij"
    )
    triangles = []
    for i in range(columns):
        for j in range(rows):
            a, b = i * (rows + 1) + j, (i + 1) * (rows + 1) + j
            if (i + j) % 2:
                triangles += [(a, b, b + 1), (a, b + 1, a + 1)]
            else:
                triangles += [(a, b, a + 1), (b, b + 1, a + 1)]
    return np.column_stack([x.ravel(), y.ravel()]), np.array(triangles, dtype=np.int32)


def quarter_grid(cells: int) -> tuple[Floats, Ints]:
    """The quarter [0, 1/2]^2 of a unit square with diagonals that radiate from the origin."""
    points, _ = grid(cells, cells, 0.5, 0.5)
    triangles = []
    for i in range(cells):
        for j in range(cells):
            a, b = i * (cells + 1) + j, (i + 1) * (cells + 1) + j
            triangles += [(a, b, b + 1), (a, b + 1, a + 1)]
    return points, np.array(triangles, dtype=np.int32)


def full_grid(cells: int) -> tuple[Floats, Ints]:
    """The unit square around the origin, four mirrored quarters of cells x cells."""
    quarter, corners = quarter_grid(cells)
    points, triangles = [], []
    for part, signs in enumerate(((1, 1), (-1, 1), (-1, -1), (1, -1))):
        points.append(quarter * signs)
        triangles.append((corners if signs[0] == signs[1] else corners[:, ::-1]) + part * len(quarter))
    merged, index = np.unique(np.round(np.concatenate(points), 12), axis=0, return_inverse=True)
    return merged, index.ravel()[np.concatenate(triangles)].astype(np.int32)


def vertex_areas(points: Floats, triangles: Ints) -> Floats:
    """A third of the area of its triangles for each vertex."""
    return np.bincount(triangles.ravel(), np.repeat(gradients(points[triangles])[1] / 3.0, 3), len(points))


def held(count: int, *, moves: str = "", turns: bool = False) -> Bools:
    """Supports (count, 5) with the same held directions everywhere."""
    fixed = np.zeros((count, 5), dtype=bool)
    for axis in moves:
        fixed[:, "xyz".index(axis)] = True
    fixed[:, 3:] = turns
    return fixed


def nearest(points: Floats, x: float, y: float) -> int:
    return int(np.argmin(np.hypot(points[:, 0] - x, points[:, 1] - y)))

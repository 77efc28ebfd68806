# SPDX-License-Identifier: LGPL-2.1-or-later
"""Balloons by formula, for the tests of files and pictures."""

from __future__ import annotations

import numpy as np
from drawn_shapes import Outline
from scipy.spatial import cKDTree

from BalloonWorkbench.core.design.design import Design, Residual
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.panels.assembly import Assembly
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.solver.inflation import Inflation, SolveReport
from BalloonWorkbench.core.solver.model import Model

REPORT = SolveReport("numpy", 12, 14, 0.5, True, 300.0, 1e-5, 0.0, 2000.0, Model())


def lifted(panel: Panel, shrink: float = 0.9) -> Inflation:
    """The panel shrunk in its plane and lifted as the square root of the distance to its seam."""
    flat = panel.rest_positions
    rim = np.concatenate([_finer(flat[seam]) for seam in panel.loops])
    away, _ = cKDTree(rim).query(flat)
    seam = np.concatenate(panel.loops)
    away[seam] = 0.0
    height = np.sqrt(away * float(np.ptp(flat, axis=0).max()) * 0.12)
    positions = np.column_stack([shrink * flat, height])
    a, b, c = (positions[panel.triangles[:, k]] for k in range(3))
    prisms = (a[:, 2] + b[:, 2] + c[:, 2]) / 6.0 * np.cross((b - a)[:, :2], (c - a)[:, :2])
    directors = np.tile([0.0, 0.0, 1.0], (len(flat), 1))
    tensions = np.ones((len(panel.triangles), 2))
    return Inflation(
        Assembly.mirrored(panel), positions, directors, tensions, 2.0 * float(prisms.sum()), REPORT
    )


def designed(outline: Outline, vertices: int = 1500) -> Design:
    """A design that has drawn the pattern 10 % larger than the drawing."""
    pattern = outline.map(lambda loop: loop / 0.9)
    inflation = lifted(triangulate(pattern, size_for(pattern, vertices)))
    silhouette = Outline(*_loops(inflation))
    return Design(
        outline, pattern, inflation, silhouette, Residual(0.0012, 0.0024, 0.0041), 5, 2, 2.0, True, ()
    )


def _loops(inflation: Inflation) -> tuple[np.ndarray, tuple[np.ndarray, ...]]:
    first, *others = (inflation.positions[seam, :2] for seam in inflation.panel.loops)
    return first, tuple(others)


def _finer(loop: np.ndarray) -> np.ndarray:
    share = np.linspace(0.0, 1.0, 8, endpoint=False)[None, :, None]
    return (loop[:, None] * (1.0 - share) + np.roll(loop, -1, axis=0)[:, None] * share).reshape(-1, 2)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Transferring a balloon to another mesh of nearly the same pattern: the start of the next simulation."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from BalloonWorkbench.core.mesh.thickness import kd_tree
from BalloonWorkbench.core.packages import without_scipy
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.start import vertex_normals
from BalloonWorkbench.core.types import Floats


def delaunay(points: Floats) -> Any:
    """scipy's triangulation of the convex hull of points (n, 2)."""
    try:
        from scipy.spatial import Delaunay
    except ImportError as error:
        raise without_scipy("Pattern correction needs scipy: install it with pip install scipy.") from error
    return Delaunay(points)


def transferred(inflation: Inflation, panel: Panel) -> Inflation:
    """The balloon on another panel, as a start only: linear between the vertices of its own."""
    rest, places = inflation.panel.rest_positions, panel.rest_positions
    moves = inflation.positions.copy()
    moves[:, :2] -= rest
    cells = delaunay(rest)
    cell = cells.find_simplex(places)
    maps = cells.transform[cell]
    share = np.einsum("kij,kj->ki", maps[:, :2], places - maps[:, 2])
    share = np.column_stack([share, 1.0 - share.sum(axis=1)])
    found = np.einsum("ki,kij->kj", share, moves[cells.simplices[cell]])
    outside = cell < 0
    if outside.any():
        found[outside] = moves[kd_tree(rest).query(places[outside])[1]]
    found[panel.sealed, 2] = 0.0
    found[:, :2] += panel.rest_positions
    return replace(
        inflation, panel=panel, positions=found, directors=vertex_normals(found, panel), lower=None
    )

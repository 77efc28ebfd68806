# SPDX-License-Identifier: LGPL-2.1-or-later
"""Transferring a balloon to another mesh of nearly the same pattern: the start of the next simulation."""

from __future__ import annotations

from dataclasses import replace

from BalloonWorkbench.core.geometry.triangulation import interpolated
from BalloonWorkbench.core.panels.assembly import Assembly
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.start import vertex_normals


def transferred(inflation: Inflation, panel: Panel) -> Inflation:
    """The balloon on another panel, as a start only: linear between the vertices of its own."""
    rest, places = inflation.panel.rest_positions, panel.rest_positions
    moves = inflation.positions.copy()
    moves[:, :2] -= rest
    positions = interpolated(rest, moves, places)
    positions[panel.sealed, 2] = 0.0
    positions[:, :2] += panel.rest_positions
    return replace(
        inflation,
        assembly=Assembly.mirrored(panel),
        positions=positions,
        directors=vertex_normals(positions, panel),
        lower=None,
    )

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first pattern: the drawing grown by what the film needs to bulge over it.

Over the drawing stands a dome like that of the inflated film. Film is taut down its slopes, so the pattern
must be as long there as the dome is: displacements d with e . grad(d) e = sqrt(1 + slope^2) - 1 down the
slopes e, by least squares. Across them film is as slack as it likes, but where it would have to stretch, as
round a hole, that counts as well. A disc grows by 1.31, an arm by 1.51 of its width (exact: pi / 2), the arms
of a star also lengthwise. Holes move as a whole.
"""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.geometry.vectors import perpendicular
from BalloonWorkbench.core.packages import without_scipy
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.solver.element.dkt import gradients
from BalloonWorkbench.core.solver.start import DOME, dome
from BalloonWorkbench.core.types import Floats

#: Height of the dome in sqrt(2 u), -Laplace(u) = 1: exact for a disc; 1 is exact for an arm, a half circle.
HEIGHT = 0.92
#: Weight of all other changes of shape, which decide where slopes do not.
STIFFNESS = 0.02
TRIALS = 5  # of finding where film would have to stretch


def initial_displacements(panel: Panel) -> Floats:
    """Displacements (n, 2) [m] of the vertices of a meshed drawing that make it a first pattern."""
    try:
        from scipy.sparse import coo_matrix
        from scipy.sparse.linalg import splu
    except ImportError as error:
        raise without_scipy("Pattern correction needs scipy: install it with pip install scipy.") from error
    triangles, count = panel.triangles, len(panel.rest_positions)
    height = HEIGHT * np.sqrt(2.0) / DOME * dome(panel)[:, 2]
    shape, areas = gradients(panel.rest_positions[triangles])
    slopes = np.einsum("ma,mai->mi", height[triangles], shape)
    steepness = np.linalg.norm(slopes, axis=1)
    down = slopes / np.maximum(steepness, 1e-12)[:, None]
    elongation = np.sqrt(1.0 + steepness**2) - 1.0
    across = perpendicular(down)
    unknowns = (2 * triangles[:, :, None] + np.arange(2)).reshape(-1, 6)
    # strains of a triangle for displacements of its corners: down the slope and across it
    taut, slack = (
        (np.einsum("mai,mi->ma", shape, e)[:, :, None] * e[:, None]).reshape(-1, 6) for e in (down, across)
    )
    other = STIFFNESS * np.einsum("mai,mbi->mab", shape, shape)
    blocks = taut[:, :, None] * taut[:, None] + np.einsum("mab,ij->maibj", other, np.eye(2)).reshape(-1, 6, 6)
    load = np.bincount(unknowns.ravel(), (taut * (elongation * areas)[:, None]).ravel(), 2 * count)
    where = (np.repeat(unknowns, 6, axis=1).ravel(), np.tile(unknowns, 6).ravel())
    short = np.zeros(len(triangles))
    solution = np.zeros(2 * count)
    for _ in range(TRIALS):
        values = (blocks + short[:, None, None] * slack[:, :, None] * slack[:, None]) * areas[:, None, None]
        matrix = coo_matrix((values.ravel(), where), shape=(2 * count, 2 * count)).tocsc()
        # a shift of the whole costs nothing: the first vertex stays
        solution[2:] = splu(matrix[2:, 2:]).solve(load[2:])
        strain = np.einsum("ma,ma->m", slack, solution[unknowns])
        stretched = np.where(strain < 0.0, 1.0, 0.0)
        if np.array_equal(stretched, short):
            break
        short = stretched
    moves = solution.reshape(-1, 2)
    for hole in panel.loops[1:]:  # film is taut round a hole: its rim neither grows nor shrinks
        moves[hole] = moves[hole].mean(axis=0)
    return moves

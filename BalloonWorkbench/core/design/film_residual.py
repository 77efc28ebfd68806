# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far film in space is from the surface that was wanted."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.design.design import Residual
from BalloonWorkbench.core.targets.half_edges import area_vectors
from BalloonWorkbench.core.types import Floats, Ints


def film_residual(away: Floats, positions: Floats, triangles: Ints) -> Residual:
    """That of film whose vertices (n, 3) m are away (n,) m from the surface, each piece by its area."""
    corners = away[triangles]
    distances = np.abs(0.5 * (corners + np.roll(corners, 1, axis=1))).ravel()  # in the middle of each side
    areas = np.repeat(np.linalg.norm(area_vectors(positions, triangles), axis=1), 3)
    order = np.argsort(distances, kind="stable")
    share = np.cumsum(areas[order]) / areas.sum()
    return Residual(
        float(distances @ areas / areas.sum()),
        float(np.interp(0.95, share, distances[order])),
        float(np.abs(corners).max()),
    )

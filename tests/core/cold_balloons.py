# SPDX-License-Identifier: LGPL-2.1-or-later
"""The balloon that a pattern really makes: as it is cut, meshed anew, blown up from the flat film, at rest.

Nothing of the correction is used but its yardstick, the two-way distance of outlines.
"""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.design.compare import residual
from BalloonWorkbench.core.design.design import Design, Residual
from BalloonWorkbench.core.design.fairing import faired_seam
from BalloonWorkbench.core.design.silhouette import silhouette
from BalloonWorkbench.core.design.visible_seam import trimmed
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.geometry.nearest import nearest_places
from BalloonWorkbench.core.geometry.normals import left_normals
from BalloonWorkbench.core.geometry.sampling import evenly
from BalloonWorkbench.core.geometry.vectors import perpendicular, rotation
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.solver.problem import NewtonSettings

#: Other meshes than those of the correction and its proof.
VERTICES = (1350, 2100)
_FITS = 10  # of one outline to the other; where the balloon lies is free
_STEP = 1e-3  # of the size, between the points that are laid on the drawing


def cold_balloon(
    drawing: Outline,
    pattern: Outline,
    film: Film,
    pressure: float,
    vertices: int,
    model: Model | None = None,
) -> tuple[Outline, Residual]:
    """The silhouette of a pattern's balloon, laid on the drawing, and how far it is from it."""
    cut = faired_seam(pattern)
    panel = triangulate(cut, size_for(cut, vertices))
    inflation = inflate(panel, film, pressure, model=model, settings=NewtonSettings(tolerance=1e-6))
    shown = laid_on(silhouette(trimmed(inflation)), drawing)
    return shown, residual(drawing, shown)


def worse_balloon(
    design: Design, film: Film, pressure: float, model: Model | None = None
) -> tuple[Outline, Residual]:
    """The worse of the balloons on the two meshes."""
    balloons = [
        cold_balloon(design.target, design.pattern, film, pressure, count, model) for count in VERTICES
    ]
    return max(balloons, key=lambda balloon: balloon[1].mean)


def laid_on(shown: Outline, drawing: Outline) -> Outline:
    """An outline moved and turned in its plane to where it is nearest to the drawing.

    Distances across the outline count, as it may slide along itself (Chen and Medioni 1992).
    """
    spacing = _STEP * max(drawing.size)
    for _ in range(_FITS):
        loops = [evenly(loop, spacing) for loop in shown.loops]
        points, across = np.concatenate(loops), np.concatenate([left_normals(loop) for loop in loops])
        missing = np.einsum("ij,ij->i", nearest_places(drawing.loops, points) - points, across)
        centre = points.mean(axis=0)
        lever = np.einsum("ij,ij->i", perpendicular(points - centre), across)
        x, y, angle = np.linalg.lstsq(np.column_stack([across, lever]), missing, rcond=None)[0]
        turn, shift = rotation(float(angle)), centre + np.array([x, y])
        shown = shown.map(lambda loop: (loop - centre) @ turn + shift)  # noqa: B023
    return shown

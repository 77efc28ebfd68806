# SPDX-License-Identifier: LGPL-2.1-or-later
"""A quick look at the balloon of a drawing, while it is still being drawn: coarse, and not corrected.

The drawing itself is inflated and then enlarged to its drawn width and height. A larger pattern makes an
almost similar balloon, so this is nearly what the correction will find, without its small folds.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from BalloonWorkbench.core.errors import MeshError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.outline.sampling import simplify
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.types import Floats, Progress, no_progress

VERTICES = 220
_ROUGHNESS = 0.06  # of the mesh size, that the drawing is simplified by
_WIDTH = 0.03  # least mean width of a shape, of its larger dimension: thinner ones are lines, not balloons


@dataclass(frozen=True)
class Draft:
    """The look of a balloon, in the drawing's frame.

    inflation  the balloon, enlarged; its panel is the drawing's, not enlarged
    pattern    the drawing, enlarged alike
    """

    inflation: Inflation
    pattern: Outline


def draft(
    outline: Outline, film: Film, pressure: float, vertices: int = VERTICES, progress: Progress = no_progress
) -> Draft:
    """The balloon of an outline with about so many vertices in a panel, at a pressure [Pa].

    Raises MeshError for an outline that is no more than a line, Cancelled when progress returns False, and
    what triangulate and inflate raise.
    """
    check_area(outline)
    edge = float(np.sqrt(outline.area / (0.87 * vertices)))
    rough = outline.with_loops([simplify(loop, _ROUGHNESS * edge) for loop in outline.loops], outline.welds)
    try:
        panel = triangulate(rough, edge, rough=True)
    except MeshError:  # a part is too thin for so coarse a mesh
        panel = triangulate(rough, 0.5 * edge, rough=True)
    inflation = inflate(panel, film, pressure, progress=progress)
    flat, seam = panel.rest_positions, panel.seams[0]
    drawn, shown = (_box(points[seam, :2]) for points in (flat, inflation.positions))
    stretch = drawn[1] / shown[1]
    scale = float(np.sqrt(np.prod(stretch)))
    positions = inflation.positions * np.append(stretch, scale)
    positions[:, :2] += drawn[0] - stretch * shown[0]

    def enlarged(loop: Floats) -> Floats:
        return np.asarray(drawn[0] + scale * (loop - drawn[0]))

    return Draft(
        replace(inflation, positions=positions, volume=scale**3 * inflation.volume), outline.map(enlarged)
    )


def check_area(outline: Outline) -> None:
    """Raise MeshError for an outline that is no more than a line."""
    loops = outline.loops
    around = sum(float(np.linalg.norm(np.roll(loop, -1, axis=0) - loop, axis=1).sum()) for loop in loops)
    if 2.0 * outline.area / around < _WIDTH * max(outline.size):
        raise MeshError("So far it is a line. Close it, or paint an area, and it becomes a balloon.")


def _box(points: Floats) -> tuple[Floats, Floats]:
    """Middle and size (2,) of the bounding box."""
    low, high = points.min(axis=0), points.max(axis=0)
    return 0.5 * (low + high), high - low

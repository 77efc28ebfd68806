# SPDX-License-Identifier: LGPL-2.1-or-later
"""A quick look at the balloon of a drawing, while it is still being drawn: coarse, and not corrected.

The first pattern of the correction (initial_pattern.py) is inflated and then enlarged to the drawn width and
height. How much its arms are still too narrow or too wide is seen in the area of the silhouette: thickness
and volume follow it, between the closed forms of a strip and of a disc.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from BalloonWorkbench.core.design.initial_pattern import initial_displacements
from BalloonWorkbench.core.errors import MeshError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.geometry.nearest import locate
from BalloonWorkbench.core.geometry.polyline import arc_lengths, bounds, signed_area
from BalloonWorkbench.core.geometry.sampling import simplify
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.panels.assembly import Assembly
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.types import Floats, Progress, no_progress

VERTICES = 220
_ROUGHNESS = 0.06  # of the mesh size, that the drawing is simplified by
_WIDTH = 0.03  # least mean width of a shape, of its larger dimension: thinner ones are lines, not balloons
# With the area at a given width and height: a strip (1, 2) becomes wider alone, a disc (1/2, 3/2) as a whole.
_THICKNESS, _VOLUME = 0.75, 1.75  # powers of the area
_FACETS = 1.03  # of the volume, that so coarse a mesh leaves out


@dataclass(frozen=True)
class Draft:
    """The look of a balloon, in the drawing's frame.

    inflation  the balloon, as large as drawn; its panel is the drawing's
    pattern    the seam of its first pattern
    """

    inflation: Inflation
    pattern: Outline


def draft(
    outline: Outline,
    film: Film,
    pressure: float,
    vertices: int = VERTICES,
    progress: Progress = no_progress,
    corrected: bool = True,
) -> Draft:
    """The balloon of an outline with about so many vertices in a panel, at a pressure [Pa].

    corrected  the pattern will be fitted to the drawing; else the drawing is the pattern
    Raises MeshError for an outline that is no more than a line, Cancelled when progress returns False, and
    what triangulate and inflate raise.
    """
    check_area(outline)
    return inflate_drawing(outline, rough_panel(outline, vertices), film, pressure, progress, corrected)


def inflate_drawing(
    outline: Outline,
    drawing: Panel,
    film: Film,
    pressure: float,
    progress: Progress = no_progress,
    corrected: bool = True,
) -> Draft:
    """The draft of an outline on a mesh of it; arguments and errors as for `draft`."""
    if not corrected:
        return Draft(inflate(drawing, film, pressure, progress=progress), outline)
    pattern = replace(drawing, rest_positions=drawing.rest_positions + initial_displacements(drawing))
    inflation = inflate(pattern, film, pressure, progress=progress)
    seam = drawing.loops[0]
    drawn, visible = (_box(points[seam, :2]) for points in (drawing.rest_positions, inflation.positions))
    stretch = drawn[1] / visible[1]
    scale = float(np.sqrt(np.prod(stretch)))
    flat = drawn[0] + stretch * (inflation.positions[:, :2] - visible[0])
    wider = _area(drawing, drawing.rest_positions) / _area(drawing, flat)
    height = scale * wider**_THICKNESS * inflation.positions[:, 2:]
    return Draft(
        replace(
            inflation,
            assembly=Assembly.mirrored(drawing),
            positions=np.hstack([flat, height]),
            volume=scale**3 * wider**_VOLUME * _FACETS * inflation.volume,
        ),
        _seam(outline, drawing, scale * (pattern.rest_positions - drawn[0]) + drawn[0]),
    )


def rough_panel(outline: Outline, vertices: int) -> Panel:
    """A mesh with about so many vertices, of the outline as roughly as these can follow it."""
    edge = float(np.sqrt(outline.area / (0.87 * vertices)))
    rough = outline.with_loops([simplify(loop, _ROUGHNESS * edge) for loop in outline.loops], outline.welds)
    try:
        return triangulate(rough, edge, rough=True)
    except MeshError:  # a part is too thin for so coarse a mesh
        return triangulate(rough, 0.5 * edge, rough=True)


def _area(panel: Panel, points: Floats) -> float:
    """Inside the seams of a panel whose vertices are at points (n, 2)."""
    return sum(float(signed_area(points[seam])) for seam in panel.loops)


def _seam(outline: Outline, drawing: Panel, moved: Floats) -> Outline:
    """The outline with its loops moved as the seams of its panel are, to points (n, 2)."""
    loops = []
    for loop, seam in zip(outline.loops, drawing.loops, strict=True):
        shift = moved[seam] - drawing.rest_positions[seam]
        along, around = locate(loop, drawing.rest_positions[seam]), arc_lengths(loop)
        moves = [np.interp(around[:-1], along, part, period=around[-1]) for part in shift.T]
        loops.append(loop + np.column_stack(moves))
    return outline.with_loops(loops, outline.welds)


def check_area(outline: Outline) -> None:
    """Raise MeshError for an outline that is no more than a line."""
    if 2.0 * outline.area / outline.perimeter < _WIDTH * max(outline.size):
        raise MeshError("So far it is a line. Close it, or paint an area, and it becomes a balloon.")


def _box(points: Floats) -> tuple[Floats, Floats]:
    """Middle and size (2,) of the bounding box."""
    low, high = bounds(points)
    return 0.5 * (low + high), high - low

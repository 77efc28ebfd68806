# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is seen of the seam: beside notches the film bulges over it, and flat facets show it too far out.

The drawing is to be met by the silhouette. Where the seam is its edge, that is the seam; beside a notch the
film of a lobe hangs over the seam by up to 1 % of the balloon, and its bulge is what has to move.

A seam of straight facets lies outside that of the film that they stand for: along a triangle's edge the film
is curved, and triangles cannot shrink along the rim as evenly as film crumples. Against meshes of sixteen
times as many vertices it is 0.02 to 0.04 of an edge for discs, hearts and stars, at any size of the mesh, and
less for straight arms. A disc's pattern is known exactly and needs 0.02 to 0.025.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from BalloonWorkbench.core.geometry.nearest import nearest_places
from BalloonWorkbench.core.geometry.normals import left_normals
from BalloonWorkbench.core.geometry.polyline import point_weights
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.types import Floats

FACETS = 0.025  # of an edge of the seam, by which it lies too far out


def trimmed(inflation: Inflation) -> Inflation:
    """The balloon with its outer seam moved in to where that of curved film would be.

    Round holes the film is taut, and the facets show no such error.
    """
    seam = inflation.panel.loops[0]
    flat, places = inflation.panel.rest_positions[seam], inflation.positions[seam, :2]
    inward = FACETS * point_weights(flat)[:, None] * left_normals(places)
    positions, lower = inflation.positions.copy(), inflation.lower
    positions[seam, :2] += inward
    if lower is not None:
        lower = lower.copy()
        lower[seam, :2] += inward
    return replace(inflation, positions=positions, lower=lower)


def visible_places(points: Floats, visible: Outline, reach: float) -> Floats:
    """Where points (k, 2) of the seam are seen: at the nearest place of the silhouette within `reach` [m].

    Farther ones are hidden, as deep in a slit that the film has closed, and stay where they are.
    """
    nearest = nearest_places(visible.loops, points)
    hidden = np.linalg.norm(nearest - points, axis=1) > reach
    return np.asarray(np.where(hidden[:, None], points, nearest))

# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is seen of the seam: beside notches the film bulges over it, and flat facets show it too far out.

The drawing is to be met by the silhouette. Where the seam is its edge, that is the seam; beside a notch the
film of a lobe hangs over the seam by up to 1 % of the balloon, and its bulge is what has to move.

A seam of straight facets lies outside that of the film that they stand for: along a triangle's edge the film
is curved, and triangles cannot shrink along the rim as evenly as film crumples. How far, in edges, was
measured for disc, heart, star, bear and strip in three films, against meshes of sixteen times as many
vertices, which still have about a quarter of it. Without a sealed band it is 0.009 to 0.032, in the middle
0.018. With one of 7 or 12 mm, which does not crumple at the scale of the mesh, it is in the middle 0.013 on
375 vertices and 0.010 on 1 500, in soft film up to 0.04 and in stiff film down to nothing. Against closed
forms a disc with a band needs 0.013 to 0.017 and a long strip at most 0.004.
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
FACETS_OF_BAND = 0.012  # the same where the seam carries the stiffness of a sealed band


def trimmed(inflation: Inflation) -> Inflation:
    """The balloon with its outer seam moved in to where that of curved film would be.

    Round holes the film is taut, and the facets show no such error.
    """
    seam = inflation.panel.loops[0]
    flat, places = inflation.panel.rest_positions[seam], inflation.positions[seam, :2]
    facets = FACETS_OF_BAND if inflation.report.banded else FACETS
    inward = facets * point_weights(flat)[:, None] * left_normals(places)
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

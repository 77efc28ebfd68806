# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is seen of the seam: beside notches the film bulges over it, and flat facets show it too far out.

The drawing is to be met by the silhouette. Where the seam is its edge, that is the seam; beside a notch the
film of a lobe hangs over the seam by up to 1 % of the balloon, and its bulge is what has to move.

A seam of straight facets lies outside that of the film that they stand for: along a triangle's edge the film
is curved, and triangles cannot shrink along the rim as evenly as film crumples. Where a sealed band keeps the
seam smooth, that goes with how much the seam is shortened: a disc, whose rim is by a quarter, needs 0.06 to
0.1 of an edge times that on 300 to 4 800 vertices, by its closed form; a long strip, whose sides are not,
nearly nothing, and holes, round which film is taut, nothing. Without a band the seam crumples at the scale of
the mesh, and 0.009 to 0.032 of an edge were found for disc, heart, star, bear and strip, against meshes of
sixteen times as many vertices.
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

FACETS = 0.025  # of an edge of the outer seam, by which it lies too far out
FACETS_OF_BAND = 0.09  # where it has a sealed band: of an edge, and of the share by which it is shortened
_NEAR = 4  # vertices to either side, over which that is averaged


def trimmed(inflation: Inflation) -> Inflation:
    """The balloon with its outer seam moved in to where that of curved film would be."""
    seam = inflation.panel.loops[0]
    flat, places = inflation.panel.rest_positions[seam], inflation.positions[seam, :2]
    facets = FACETS_OF_BAND * _shortening(flat, places) if inflation.report.banded else FACETS
    inward = (facets * point_weights(flat))[:, None] * left_normals(places)
    positions, lower = inflation.positions.copy(), inflation.lower
    positions[seam, :2] += inward
    if lower is not None:
        lower = lower.copy()
        lower[seam, :2] += inward
    return replace(inflation, positions=positions, lower=lower)


def _shortening(flat: Floats, inflated: Floats) -> Floats:
    """By which share of its length (k,) a closed seam (k, 2) m has become shorter; 0 where it has not."""
    before, after = (
        sum(np.roll(point_weights(loop), turn) for turn in range(-_NEAR, _NEAR + 1))
        for loop in (flat, inflated)
    )
    return np.maximum(1.0 - after / before, 0.0)


def visible_places(points: Floats, visible: Outline, reach: float) -> Floats:
    """Where points (k, 2) of the seam are seen: at the nearest place of the silhouette within `reach` [m].

    Farther ones are hidden, as deep in a slit that the film has closed, and stay where they are.
    """
    nearest = nearest_places(visible.loops, points)
    hidden = np.linalg.norm(nearest - points, axis=1) > reach
    return np.asarray(np.where(hidden[:, None], points, nearest))

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where each point of the inflated seam should lie on the drawing.

Curves are compared, not nodes with nodes: a point's goal is the nearest point of the drawing in its own
neighbourhood along the loop, so that nodes may slide along the seam as they like. Corners of the drawing are
exceptions: the vertex of the pattern that stands for a corner has the corner itself as its goal.
"""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.outline.sampling import arc_lengths, point_at
from BalloonWorkbench.core.types import Floats, Ints


def locate(loop: Floats, points: Floats) -> Floats:
    """Arc lengths (k,) along a closed loop (n, 2) of the places nearest to points (k, 2)."""
    return nearest_along(loop, points, np.zeros(len(points)), np.full(len(points), np.inf))[0]


def nearest_along(loop: Floats, points: Floats, around: Floats, reach: Floats) -> tuple[Floats, Floats]:
    """Nearest places of a closed loop among those within `reach` (k,) along it of arc lengths `around` (k,).

    Returns arc lengths (k,) and points (k, 2).
    """
    lengths = arc_lengths(loop)
    total = lengths[-1]
    ahead = np.roll(loop, -1, axis=0) - loop
    squared = np.einsum("ij,ij->i", ahead, ahead)
    offset = points[:, None, :] - loop[None]
    share = np.clip(np.einsum("kij,ij->ki", offset, ahead) / squared, 0.0, 1.0)
    along = lengths[:-1] + share * np.sqrt(squared)
    drift = np.mod(along - around[:, None] + 0.5 * total, total) - 0.5 * total
    distance = np.linalg.norm(points[:, None, :] - (loop + share[:, :, None] * ahead), axis=2)
    distance[np.abs(drift) > reach[:, None]] = np.inf
    row = np.arange(len(points))
    best = np.argmin(distance, axis=1)
    found = np.where(np.isfinite(distance[row, best]), along[row, best], around) % total
    return found, point_at(loop, lengths, found)


def goals(
    loop: Floats, points: Floats, around: Floats, corner_nodes: Ints, corners: Floats, reach: Floats
) -> Floats:
    """Goal of each seam point (k, 2) on the closed loop of the drawing.

    around        expected arc lengths (k,) along the drawing
    reach         how far from there a goal may be (k,)
    corner_nodes  indices of the points that stand for corners; corners: their arc lengths
    """
    _, nearest = nearest_along(loop, points, around, reach)
    nearest[corner_nodes] = point_at(loop, arc_lengths(loop), corners)
    return nearest

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where each point of the inflated seam should lie on the drawing.

Curves are compared, not nodes with nodes: a point's goal is the nearest point of the drawing in its own
neighbourhood along the loop, so that nodes may slide along the seam as they like. Corners of the drawing are
exceptions: the vertex of the pattern that stands for a corner has the corner itself as its goal.
"""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.outline.sampling import arc_lengths, point_at
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.types import Floats, Ints


def locate(loop: Floats, points: Floats) -> Floats:
    """Arc lengths (k,) along a closed loop (n, 2) of the places nearest to points (k, 2)."""
    package = shapely()
    ring = package.LineString(np.vstack([loop, loop[:1]]))
    return np.asarray(package.line_locate_point(ring, package.points(points)))


def nearest_along(loop: Floats, points: Floats, around: Floats, reach: Floats) -> Floats:
    """Nearest points (k, 2) of a closed loop, at most `reach` (k,) along it from lengths `around` (k,)."""
    count = len(loop)
    lengths = arc_lengths(loop)
    total = lengths[-1]
    ahead = np.roll(loop, -1, axis=0) - loop
    squared = np.einsum("ij,ij->i", ahead, ahead)
    # the segments that are near enough, as many for each point
    starts = np.concatenate([lengths[:-1] - total, lengths[:-1], lengths[:-1] + total])
    first = np.searchsorted(starts, around - reach, side="right") - 1
    width = int((np.searchsorted(starts, around + reach) - first).max())
    segment = (first[:, None] + np.arange(min(max(width, 1), count))) % count
    offset = points[:, None, :] - loop[segment]
    share = np.clip(np.einsum("kij,kij->ki", offset, ahead[segment]) / squared[segment], 0.0, 1.0)
    along = lengths[segment] + share * np.sqrt(squared[segment])
    drift = np.mod(along - around[:, None] + 0.5 * total, total) - 0.5 * total
    distance = np.linalg.norm(offset - share[:, :, None] * ahead[segment], axis=2)
    distance[np.abs(drift) > reach[:, None]] = np.inf
    row, best = np.arange(len(points)), np.argmin(distance, axis=1)
    found = np.where(np.isfinite(distance[row, best]), along[row, best], around)
    return point_at(loop, lengths, found)


def goals(
    loop: Floats, points: Floats, around: Floats, corner_nodes: Ints, corners: Floats, reach: Floats
) -> Floats:
    """Goal of each seam point (k, 2) on the closed loop of the drawing.

    around        expected arc lengths (k,) along the drawing
    reach         how far from there a goal may be (k,)
    corner_nodes  indices of the points that stand for corners; corners: their arc lengths
    """
    nearest = nearest_along(loop, points, around, reach)
    nearest[corner_nodes] = point_at(loop, arc_lengths(loop), corners)
    return nearest

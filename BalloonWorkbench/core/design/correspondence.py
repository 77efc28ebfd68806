# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where each point of the inflated seam should lie on the drawing.

Curves are compared, not nodes with nodes: a point's goal is the nearest point of the drawing in its own
neighbourhood along the loop, so that nodes may slide along the seam as they like. Corners of the drawing are
exceptions: the vertex of the pattern that stands for a corner has the corner itself as its goal.
"""

from __future__ import annotations

from BalloonWorkbench.core.geometry.nearest import nearest_along
from BalloonWorkbench.core.geometry.polyline import arc_lengths, point_at
from BalloonWorkbench.core.types import Floats, Ints


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

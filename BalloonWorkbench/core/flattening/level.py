# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a flat panel is turned to take little film."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.geometry.polyline import edge_vectors
from BalloonWorkbench.core.geometry.vectors import rotation
from BalloonWorkbench.core.types import Floats

#: Boxes whose areas differ by less are equally small.
_SAME_AREA = 1e-6


def level_turn(panel: Floats) -> Floats:
    """The matrix (2, 2) by which points (k, 2) are multiplied so that the smallest box round them is level.

    Its longer side lies along x.
    """
    from scipy.spatial import ConvexHull

    hull = panel[ConvexHull(panel).vertices]
    sides = edge_vectors(hull)
    angles = np.arctan2(sides[:, 1], sides[:, 0])
    boxes = np.array([np.ptp(hull @ rotation(-angle), axis=0) for angle in angles])
    areas = boxes.prod(axis=1)
    best = int(np.argmax(areas <= areas.min() * (1.0 + _SAME_AREA)))
    upright = boxes[best, 1] > boxes[best, 0] * (1.0 + _SAME_AREA)
    return rotation(-float(angles[best]) - (0.5 * np.pi if upright else 0.0))

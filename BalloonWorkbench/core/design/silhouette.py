# SPDX-License-Identifier: LGPL-2.1-or-later
"""The silhouette: what one sees of the balloon from above."""

from __future__ import annotations

from typing import Any

import numpy as np

from BalloonWorkbench.core.outline.outline import Outline, signed_area
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.types import Floats


def silhouette(inflation: Inflation) -> Outline:
    """Outline of all projected triangles, with as many holes as the panel has [m].

    Mirrored halves cast the same shadow, so the upper one is enough. Slivers between folds of the rim are no
    holes.
    """
    package = shapely()
    halves = [inflation.positions] if inflation.lower is None else [inflation.positions, inflation.lower]
    corners = np.concatenate([half[inflation.panel.triangles][:, [0, 1, 2, 0], :2] for half in halves])
    shadow = package.union_all(package.polygons(corners))
    body = max(package.get_parts(shadow), key=lambda part: float(part.area))
    holes = sorted((_loop(ring) for ring in body.interiors), key=signed_area, reverse=True)
    wanted = len(inflation.panel.seams) - 1
    return Outline(_loop(body.exterior), tuple(hole[::-1] for hole in holes[:wanted]))


def _loop(ring: Any) -> Floats:
    """Points of a ring, counter-clockwise, first point not repeated."""
    points = np.asarray(ring.coords, dtype=np.float64)[:-1]
    return points if signed_area(points) > 0.0 else np.ascontiguousarray(points[::-1])

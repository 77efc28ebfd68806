# SPDX-License-Identifier: LGPL-2.1-or-later
"""Areas of shapely: the polygons that one consists of, and rings as loops."""

from __future__ import annotations

from typing import Any

import numpy as np

from BalloonWorkbench.core.geometry.polyline import oriented
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.types import Floats


def parts(area: Any) -> list[Any]:
    """The polygons that an area consists of, the largest first."""
    pieces = [piece for piece in shapely().get_parts(area) if piece.geom_type == "Polygon"]
    return sorted((piece for piece in pieces if not piece.is_empty), key=lambda piece: -piece.area)


def loop_of(ring: Any, counter_clockwise: bool = True) -> Floats:
    """A ring of shapely as a closed loop (n, 2), counter-clockwise or clockwise."""
    return oriented(np.asarray(ring.coords, dtype=np.float64)[:-1], counter_clockwise)

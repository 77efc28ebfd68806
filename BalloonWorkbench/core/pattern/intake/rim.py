# SPDX-License-Identifier: LGPL-2.1-or-later
"""Places along the outer seam, by the way from its rightmost point."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.geometry.nearest import nearest_on_line
from BalloonWorkbench.core.geometry.polyline import arc_lengths, extent, oriented, point_at, ring
from BalloonWorkbench.core.types import Floats

#: Rightmost points within this share of the size count as equally far right; the lowest is taken.
_EQUAL = 1e-6


class Rim:
    """A closed loop (n, 2) m, counter-clockwise; its rightmost point is the beginning."""

    def __init__(self, loop: Floats) -> None:
        loop = oriented(loop)
        right = np.flatnonzero(loop[:, 0] > loop[:, 0].max() - _EQUAL * extent(loop))
        self.points: Floats = np.roll(loop, -int(right[np.argmin(loop[right, 1])]), axis=0)
        self.along: Floats = arc_lengths(self.points)

    @property
    def length(self) -> float:
        """Once round [m]."""
        return float(self.along[-1])

    def at(self, along: float) -> Floats:
        """The point (2,) at a place; places go on round and round."""
        return self.points_at(np.array([along]))[0]

    def points_at(self, along: Floats) -> Floats:
        """The points (k, 2) at places (k,)."""
        return point_at(self.points, self.along, along)

    def outward(self, along: float, reach: float) -> float:
        """The direction [rad] away from the film, square to the chord over `reach` [m] on both sides."""
        reach = min(reach, 0.2 * self.length)
        chord = self.at(along + reach) - self.at(along - reach)
        return float(np.arctan2(-chord[0], chord[1]))

    def nearest(self, point: Floats) -> float:
        """The place nearest to a point (2,) [m]."""
        (edge,), (share,), _ = nearest_on_line(ring(self.points), point[None])
        return float(self.along[edge] + share * (self.along[edge + 1] - self.along[edge])) % self.length

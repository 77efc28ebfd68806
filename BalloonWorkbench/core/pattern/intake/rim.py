# SPDX-License-Identifier: LGPL-2.1-or-later
"""Places along the outer seam, by the way from its rightmost point."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.geometry.polyline import signed_area
from BalloonWorkbench.core.types import Floats

#: Rightmost points within this share of the size count as equally far right; the lowest is taken.
_EQUAL = 1e-6


class Rim:
    """A closed loop (n, 2) m, counter-clockwise; its rightmost point is the beginning."""

    def __init__(self, loop: Floats) -> None:
        loop = loop if signed_area(loop) > 0.0 else loop[::-1]
        size = float(np.ptp(loop, axis=0).max())
        right = np.flatnonzero(loop[:, 0] > loop[:, 0].max() - _EQUAL * size)
        self.points: Floats = np.roll(loop, -int(right[np.argmin(loop[right, 1])]), axis=0)
        closed = np.concatenate([self.points, self.points[:1]])
        self.along: Floats = np.append(0.0, np.cumsum(np.hypot(*np.diff(closed, axis=0).T)))

    @property
    def length(self) -> float:
        """Once round [m]."""
        return float(self.along[-1])

    def at(self, along: float) -> Floats:
        """The point (2,) at a place; places go on round and round."""
        closed = np.concatenate([self.points, self.points[:1]])
        place = along % self.length
        return np.array([np.interp(place, self.along, closed[:, k]) for k in range(2)])

    def outward(self, along: float, reach: float) -> float:
        """The direction [rad] away from the film, square to the chord over `reach` [m] on both sides."""
        reach = min(reach, 0.2 * self.length)
        chord = self.at(along + reach) - self.at(along - reach)
        return float(np.arctan2(-chord[0], chord[1]))

    def nearest(self, point: Floats) -> float:
        """The place nearest to a point (2,) [m]."""
        ahead = np.roll(self.points, -1, axis=0) - self.points
        lengths = np.diff(self.along)
        share = ((point - self.points) * ahead).sum(axis=1) / np.maximum(lengths**2, 1e-300)
        share = np.clip(share, 0.0, 1.0)
        away = np.hypot(*(self.points + share[:, None] * ahead - point).T)
        edge = int(np.argmin(away))
        return float(self.along[edge] + share[edge] * lengths[edge]) % self.length

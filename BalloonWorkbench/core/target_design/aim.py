# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a correction brings down: the mean distance of the film from a surface."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from BalloonWorkbench.core.types import Bools, Floats

#: So much more film on the wrong side counts.
_HELD = 10.0


class Aim(NamedTuple):
    """The surface that is wanted, and how distances from it count.

    Where film bulges or cannot reach, it does so in any pattern: far places count by their distances, as the
    mean does, only near ones by the squares of these.

    margin  [m], so far outside of the target
    near    [m], up to about which distance squares count
    side    1 where the film shall lie outside of that surface, -1 inside, 0 on it: what is on the wrong side
            counts by the squares, however far away
    """

    margin: float
    near: float
    side: float = 0.0

    def cost(self, weights: Floats, distances: Floats) -> float:
        """The mean [m] of distances (n,) from the target; weights (n,): roots of the parts of the whole."""
        away = distances - self.margin
        counted = np.where(
            self._wrong(away), _HELD * away**2 / self.near, np.hypot(away, self.near) - self.near
        )
        return float(weights**2 @ counted)

    def shares(self, distances: Floats) -> Floats:
        """Weights (n,) of the squares with which least squares bring down this mean, too."""
        away = distances - self.margin
        return np.asarray(1.0 / np.where(self._wrong(away), self.near / _HELD, np.hypot(away, self.near)))

    def _wrong(self, away: Floats) -> Bools:
        return np.asarray(self.side * away < 0.0)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is corrected of gores: a smooth factor of their half width along them, and their length."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.bags.bag import Bag
from BalloonWorkbench.core.bodies.gores import Gores, gored_bag
from BalloonWorkbench.core.bodies.profile import POINT, Profile
from BalloonWorkbench.core.types import Floats

#: Factors along a gore, the knots of a cubic spline, and how far they are moved to see what follows.
KNOTS, _HAIR = 14, 1e-5


@dataclass(frozen=True)
class GoreUnknowns:
    """The gores of a profile by what changes them.

    plain   as wide as the body is around
    spline  (m, k) the half width is the plain one times 1 + spline @ the first k values; the last value is
            how much longer than the meridian the gore is, as a part of it
    """

    profile: Profile
    count: int
    plain: Gores
    spline: Floats

    @classmethod
    def of(cls, profile: Profile, count: int, plain: Gores) -> GoreUnknowns:
        """Those of a profile."""
        return cls(profile, count, plain, _splines(plain.along / plain.along[-1], KNOTS)[:, _free(profile)])

    @property
    def size(self) -> int:
        """How many they are."""
        return self.spline.shape[1] + 1

    @property
    def bends(self) -> Floats:
        """Matrix (r, size) of the second differences of the factors, which are 1 where none is free."""
        return np.column_stack(
            [np.diff(np.eye(KNOTS)[:, _free(self.profile)], n=2, axis=0), np.zeros(KNOTS - 2)]
        )

    def gores(self, values: Floats) -> Gores:
        """The gores for values (size,)."""
        return Gores(
            self.plain.along,
            self.plain.half_widths * (1.0 + self.spline @ values[:-1]),
            1.0 + float(values[-1]),
        )

    def bag(self, values: Floats) -> Bag:
        """The bag for values (size,)."""
        return gored_bag(self.profile, self.count, self.gores(values))

    def point_moves(self, values: Floats) -> list[Floats]:
        """For each panel how its points follow each of the values: (points, 2, size) m."""
        changes = []
        for number in range(self.size):
            step = np.zeros(self.size)
            step[number] = _HAIR
            ahead, behind = self.bag(values + step), self.bag(values - step)
            changes.append([(a.outer - b.outer) / (2.0 * _HAIR) for a, b in zip(ahead.panels, behind.panels)])
        return [np.stack(each, axis=-1) for each in zip(*changes)]


def _free(profile: Profile) -> slice:
    """Which factors may change: the tip of a gore keeps its angle, which too few triangles would tell."""
    return slice(int(profile.lower == POINT), KNOTS - int(profile.upper == POINT))


def _splines(at: Floats, count: int) -> Floats:
    """Cubic B-splines (k, count) over 0 to 1 at places (k,), on even knots; they sum to 1 (de Boor 1972)."""
    knots = np.concatenate([np.zeros(3), np.linspace(0.0, 1.0, count - 2), np.ones(3)])
    inside = np.clip(at, 0.0, 1.0 - 1e-12)[:, None]
    values = ((knots[:-1] <= inside) & (inside < knots[1:])).astype(np.float64)
    for degree in range(1, 4):
        spans = knots[degree:] - knots[:-degree]
        share = (inside - knots[:-degree]) / np.maximum(spans, 1e-300)
        share[:, spans <= 0.0] = 0.0
        left = share * 1.0
        right = np.where(spans > 0.0, 1.0 - share, 0.0)
        values = left[:, :-1] * values[:, :-1] + right[:, 1:] * values[:, 1:]
    return values

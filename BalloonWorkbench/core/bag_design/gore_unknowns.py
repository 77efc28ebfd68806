# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is corrected of gores: a smooth factor of their half width, flares beside discs, their length."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.bags.bag import Bag
from BalloonWorkbench.core.bodies.gores import Gores, flares, gored_bag
from BalloonWorkbench.core.bodies.profile import POINT, Profile
from BalloonWorkbench.core.geometry.splines import open_splines
from BalloonWorkbench.core.types import Floats

#: Factors along a gore, the knots of a cubic spline, and how far they are moved to see what follows.
KNOTS, _HAIR = 14, 1e-5
#: What a flare counts beside a bend of the factor.
_FLARED = 3.0


@dataclass(frozen=True)
class GoreUnknowns:
    """The gores of a profile by what changes them.

    plain   as wide as the body is around
    widths  (m, k) the half width is the plain one times 1 + widths @ the first k values: of a spline, then
            of a flare for each disc; the last value is how much longer than the meridian the gore is, as a
            part of it
    """

    profile: Profile
    count: int
    plain: Gores
    widths: Floats

    @classmethod
    def of(cls, profile: Profile, count: int, plain: Gores) -> GoreUnknowns:
        """Those of a profile."""
        knots = np.linspace(0.0, 1.0, KNOTS - 2)
        spline = open_splines(plain.along / plain.along[-1], knots)[:, _free(profile)]
        return cls(profile, count, plain, np.column_stack([spline, flares(profile, plain.along)]))

    @property
    def size(self) -> int:
        """How many they are."""
        return self.widths.shape[1] + 1

    @property
    def bends(self) -> Floats:
        """Matrix (r, size): second differences of the factors, which are 1 where none is free; flares."""
        bends = np.diff(np.eye(KNOTS)[:, _free(self.profile)], n=2, axis=0)
        flared = _FLARED * np.eye(self.size)[bends.shape[1] : -1]
        return np.concatenate([np.pad(bends, ((0, 0), (0, self.size - bends.shape[1]))), flared])

    def gores(self, values: Floats) -> Gores:
        """The gores for values (size,)."""
        return Gores(
            self.plain.along,
            self.plain.half_widths * (1.0 + self.widths @ values[:-1]),
            self.plain.slopes,
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

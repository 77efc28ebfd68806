# SPDX-License-Identifier: LGPL-2.1-or-later
"""The outline: one outer loop and its holes, in metres."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from BalloonWorkbench.core.types import Floats


def signed_area(loop: Floats) -> float:
    """Area inside a closed loop (n, 2), positive when it runs counter-clockwise [m2]."""
    x, y = loop.T
    return 0.5 * float(np.dot(x, np.roll(y, -1)) - np.dot(np.roll(x, -1), y))


@dataclass(frozen=True)
class Outline:
    """What the user wants to see inflated.

    outer  (n, 2) m, counter-clockwise, y up, first point not repeated
    holes  each (k, 2) m, clockwise
    notes  remarks for the user made while the outline was found (specks dropped, gaps closed, ...)
    """

    outer: Floats
    holes: tuple[Floats, ...] = ()
    notes: tuple[str, ...] = field(default=(), compare=False)

    @property
    def loops(self) -> tuple[Floats, ...]:
        """The outer loop, then the holes."""
        return (self.outer, *self.holes)

    @property
    def area(self) -> float:
        """Area between the outer loop and the holes [m2]."""
        return sum(signed_area(loop) for loop in self.loops)

    @property
    def size(self) -> tuple[float, float]:
        """Width and height of the bounding box [m]."""
        width, height = np.ptp(self.outer, axis=0)
        return float(width), float(height)

    def map(self, transform: Callable[[Floats], Floats]) -> Outline:
        """The outline with an orientation-keeping map of (n, 2) points applied to each loop."""
        return Outline(transform(self.outer), tuple(transform(hole) for hole in self.holes), self.notes)

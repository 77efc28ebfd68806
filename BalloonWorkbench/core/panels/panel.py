# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel: a flat, triangulated piece of film, cut once or several times."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.geometry.polyline import extent
from BalloonWorkbench.core.types import Floats, Ints


@dataclass(frozen=True)
class Panel:
    """A triangulated flat panel.

    rest_positions  (n, 2) m, the film before inflation
    triangles       (m, 3) vertex indices, counter-clockwise
    loops           vertex indices of each boundary loop in order: the outer loop first
                    (counter-clockwise), then the holes (clockwise)
    welds           vertex indices along each line inside at which it is sealed to another film
    """

    rest_positions: Floats
    triangles: Ints
    loops: tuple[Ints, ...]
    welds: tuple[Ints, ...] = ()

    @property
    def sealed(self) -> Ints:
        """The vertices at which films are sealed together, in ascending order."""
        return np.unique(np.concatenate([*self.loops, *self.welds]))

    @property
    def size(self) -> float:
        """The larger side of its bounding box [m]."""
        return extent(self.rest_positions)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rules for the next pattern. Anderson mixing, the default: a fixed-point iteration with a memory.

Anderson 1965, "Iterative procedures for nonlinear integral equations"; Walker and Ni 2011.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

import numpy as np

from BalloonWorkbench.core.correction.iterate import Iterate
from BalloonWorkbench.core.types import Floats

DEPTH = 4  # earlier iterates that are remembered
REGULARISATION = 1e-2  # of the largest remembered change: mesh-scale noise must not steer the mix


class UpdateRule(Protocol):
    """What leads from one iterate to the next; it may remember the iterates that it has seen."""

    def step(self, current: Iterate, correction: Floats) -> Floats:
        """What to add to all points (n, 2) of the pattern, given the correction (n, 2) that they ask for."""


#: Makes a rule without memories from its gain: the step for a correction of 1.
RuleOfGain = Callable[[float], UpdateRule]


class AndersonMixing:
    """Steps of the iteration x <- x + gain * correction(x), mixed with what the last ones taught.

    depth  earlier iterates that are remembered; 0 is the plain fixed point
    """

    def __init__(self, gain: float, depth: int = DEPTH) -> None:
        self._gain = gain
        self._depth = depth
        self._points: list[Floats] = []
        self._corrections: list[Floats] = []

    def step(self, current: Iterate, correction: Floats) -> Floats:
        """What to add to all points (n, 2) of the pattern, given the correction (n, 2) that they ask for."""
        point = np.concatenate(current.seam_map.pattern)
        return self.mixed(point.ravel(), correction.ravel()).reshape(-1, 2)

    def mixed(self, point: Floats, correction: Floats) -> Floats:
        """What to add to a point (n,), given the correction (n,) that it asks for."""
        self._points = [*self._points, point][-self._depth - 1 :]
        self._corrections = [*self._corrections, correction][-self._depth - 1 :]
        plain = self._gain * correction
        if len(self._points) < 2:
            return plain
        point_changes = np.diff(np.array(self._points), axis=0)
        correction_changes = np.diff(np.array(self._corrections), axis=0)
        normal = correction_changes @ correction_changes.T
        normal[np.diag_indices_from(normal)] += REGULARISATION**2 * float(normal.diagonal().max())
        share = np.linalg.solve(normal, correction_changes @ correction)
        return plain - share @ (point_changes + self._gain * correction_changes)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Anderson mixing: a fixed-point iteration that learns from its last passes.

Anderson 1965, "Iterative procedures for nonlinear integral equations"; Walker and Ni 2011.
"""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.types import Floats

DEPTH = 4  # earlier passes that are remembered; 0 is the plain fixed point
REGULARISATION = 1e-2  # of the largest remembered change: mesh-scale noise must not steer the mix


class AndersonMixing:
    """Steps of the iteration x <- x + gain * correction(x)."""

    def __init__(self, gain: float) -> None:
        self._gain = gain
        self._points: list[Floats] = []
        self._corrections: list[Floats] = []

    def step(self, point: Floats, correction: Floats) -> Floats:
        """What to add to the point (n,), given the correction (n,) found there."""
        self._points = [*self._points, point][-DEPTH - 1 :]
        self._corrections = [*self._corrections, correction][-DEPTH - 1 :]
        plain = self._gain * correction
        if len(self._points) < 2:
            return plain
        point_changes = np.diff(np.array(self._points), axis=0)
        correction_changes = np.diff(np.array(self._corrections), axis=0)
        normal = correction_changes @ correction_changes.T
        normal[np.diag_indices_from(normal)] += REGULARISATION**2 * float(normal.diagonal().max())
        share = np.linalg.solve(normal, correction_changes @ correction)
        return plain - share @ (point_changes + self._gain * correction_changes)

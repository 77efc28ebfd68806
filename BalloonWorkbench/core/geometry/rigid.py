# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a body in space is turned so that it lies over another one as well as it can."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.types import Floats


def turn_onto(places: Floats, goals: Floats) -> Floats:
    """The rotation (3, 3) to be multiplied from the right that brings places (n, 3), about their middle,
    nearest to goals (n, 3), about theirs, by least squares (Kabsch 1976).
    """
    left, _, right = np.linalg.svd((places - places.mean(axis=0)).T @ (goals - goals.mean(axis=0)))
    left[:, 2] *= np.linalg.det(left @ right)
    return np.asarray(left @ right)

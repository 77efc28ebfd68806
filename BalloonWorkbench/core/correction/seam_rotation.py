# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far the film around each seam vertex has turned in the plane of the drawing.

A curved arm curls up when it is inflated (Siefert et al. 2019, over-curvature of inflated curved tubes) and
carries its end round. What is missing at the end is seen in the drawing's directions; the pattern, which is
not curled, has to change in its own.
"""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.types import Floats


def seam_turns(flat: Floats, inflated: Floats) -> Floats:
    """Sines and cosines (k, 2) of the angles by which a closed seam, flat (k, 2) m, has turned: (k, 2) m."""
    before, after = (np.roll(seam, -1, axis=0) - np.roll(seam, 1, axis=0) for seam in (flat, inflated))
    sine = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]
    cosine = np.einsum("ij,ij->i", before, after)
    return np.column_stack([sine, cosine]) / np.maximum(np.hypot(sine, cosine), 1e-300)[:, None]


def turned_back(moves: Floats, turn: Floats) -> Floats:
    """Moves (n, 2) turned back by angles given as sines and cosines (n, 2) of any length."""
    sine, cosine = (turn / np.maximum(np.linalg.norm(turn, axis=1), 1e-300)[:, None]).T
    x, y = moves.T
    return np.column_stack([cosine * x + sine * y, cosine * y - sine * x])

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a balloon stays in its plane: one coarse simulation of both its panels, free in space.

No measure of the drawing alone tells: a small hole in the middle of a disc warps it, the same hole off the
middle or in a square does not.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from BalloonWorkbench.core.design.draft import rough_panel
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.model import Model

PRESSURE = 2000.0  # Pa; the shape hardly depends on it
_VERTICES = 200  # in a panel; the height is then within a factor 1.5 (validation study)
_TWIST = 0.3  # a start that is plainly out of plane: the flat balloon is at rest, too, though not stably


def seam_height(pattern: Outline, film: Film) -> float:
    """Height [m] by which the seam of a pattern leaves its plane."""
    panel = rough_panel(pattern, _VERTICES)
    plain = replace(film, young_modulus_across=None)  # two panels with a grain aslant are no mirror images
    both = inflate(panel, plain, PRESSURE, model=Model(two_panels=True, twist=_TWIST))
    return float(np.ptp(both.positions[np.concatenate(panel.loops), 2]))

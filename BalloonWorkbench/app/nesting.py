# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which of several loops is the outline and which are its holes."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.errors import OutlineError
from BalloonWorkbench.core.outline.crossings import contains
from BalloonWorkbench.core.outline.loops import check
from BalloonWorkbench.core.outline.outline import Outline, signed_area


def from_loops(loops: list[np.ndarray]) -> Outline:
    """The largest loop with those in it as holes; loops beside it or in a hole are left out with a note.

    loops  each (n, 2) m, in any order and direction
    """
    if not loops:
        raise OutlineError("There is no closed line: draw one.")
    outer, *others = sorted(loops, key=lambda loop: -abs(signed_area(loop)))
    holes: list[np.ndarray] = []
    beside = within = 0
    for loop in others:
        if not contains(outer, loop[:1])[0]:
            beside += 1
        elif any(contains(hole, loop[:1])[0] for hole in holes):
            within += 1
        else:
            holes.append(loop)
    notes = []
    if beside:
        notes.append(f"{beside} smaller shapes beside the largest were left out.")
    if within:
        notes.append(f"{within} shapes inside holes were left out.")
    return check(Outline(outer, tuple(holes), tuple(notes)))

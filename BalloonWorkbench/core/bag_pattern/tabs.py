# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tabs: cuts across the allowance of an edge that must turn to follow a rounder one.

Where one side of a seam bulges more than the other, the film outside the weld of the straighter side is too
short for the way round. Cut into tabs it opens like a fan; the weld itself stays whole.
"""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.bag_pattern.seams import bending_apart
from BalloonWorkbench.core.geometry.polyline import length
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import from_mm

#: A tab turns by so much [rad], and is no narrower and no wider than that [m].
_TURN = np.radians(12.0)
_NARROWEST, _WIDEST = from_mm(4.0), from_mm(25.0)
#: Film stretches or wrinkles by that share without being cut.
_STRETCH = 0.02


def tab_shares(one: Floats, other: Floats, width: float) -> tuple[Floats, Floats]:
    """Where each side of a seam is cut between two tabs: shares (k,) of its length, none on the rounder side.

    one, other  both sides (k, 2) m in the direction of the seam
    width       film outside the seam: weld and allowance [m]
    """
    apart = bending_apart(one, other)
    way = 0.5 * (length(one) + length(other))
    part = way / len(apart)
    shares = []
    for sense in (-1.0, 1.0):  # the first side turns where the second one is rounder
        turning = np.where(sense * apart * width > _STRETCH * part, np.abs(apart), 0.0)
        needed = np.clip(turning / _TURN, part / _WIDEST, part / _NARROWEST) * (turning > 0.0)
        passed = np.append(0.0, np.cumsum(needed))
        numbers = np.arange(1.0, np.floor(passed[-1] + 1e-9) + 1.0) - 0.5
        places = np.interp(numbers, passed, np.linspace(0.0, 1.0, len(passed)))
        shares.append(places)
    return shares[0], shares[1]

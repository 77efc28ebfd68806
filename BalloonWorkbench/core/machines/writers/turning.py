# SPDX-License-Identifier: LGPL-2.1-or-later
"""A wheel or knife that an axis of the machine turns along the path: how it points, and where it is lifted.

Degrees, counter-clockwise as seen from above, 0 along X. The angle goes on without a jump along a line; each
line begins within half a turn of 0, so that cables are wound up at most by the turns of one line.
"""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.arcs.curves import Curve
from BalloonWorkbench.core.geometry.vectors import wrapped
from BalloonWorkbench.core.types import Bools, Floats

#: A sharper corner is turned with the tool lifted: on the film it would scuff or tear it [rad].
_SHARP = float(np.radians(20.0))


def angles_along(curve: Curve) -> tuple[Floats, Floats, Bools]:
    """Angles (m,) at the start and (m,) at the end of each segment [degrees], and before which (m,) the tool
    is lifted and turned; never before the first."""
    first, last = curve.headings
    starts, ends = np.empty(len(curve)), np.empty(len(curve))
    lifted = np.zeros(len(curve), dtype=bool)
    at = float(wrapped(first[0]))
    for number, turn in enumerate(curve.turns):
        if number:
            swing = float(wrapped(first[number] - last[number - 1]))
            lifted[number] = abs(swing) > _SHARP
            at += swing
        starts[number] = at
        at += float(turn)
        ends[number] = at
    return np.degrees(starts), np.degrees(ends), lifted

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a hot tool goes more slowly: near corners, and in bends narrower than its reach."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.arcs.curves import Curve
from BalloonWorkbench.core.types import Bools, Floats

#: How far from a corner it does [mm], and what is a corner [rad].
REACH = 3.0
CORNER = np.radians(25.0)
#: A shorter piece is not divided [mm].
_SHORT = 0.01


def slowed(curve: Curve) -> tuple[Curve, Bools]:
    """The curve [mm] divided where slow stretches begin and end, and which segments (m,) are slow."""
    along = np.append(0.0, np.cumsum(curve.lengths))
    tight = _tight(curve, along)
    whole = along[-1]
    if curve.closed:
        tight = np.concatenate([tight - whole, tight, tight + whole])
    divided, added = curve, 0
    for segment in range(len(curve)):
        start, end = along[segment], along[segment + 1]
        cuts = np.unique(np.concatenate([tight - REACH, tight + REACH]))
        for cut in cuts[(cuts > start + _SHORT) & (cuts < end - _SHORT)]:
            share = (cut - start) / (end - start)
            divided = divided.split(segment + added, float(share))
            start, added = cut, added + 1
    lengths = divided.lengths
    middles = np.cumsum(lengths) - 0.5 * lengths
    near = np.abs(middles[:, None] - tight[None, :]).min(axis=1, initial=np.inf) < REACH
    return divided, near | (divided.radii < REACH)


def _tight(curve: Curve, along: Floats) -> Floats:
    """Where along the curve [mm] its joints are corners, or bends of a polyline that turn as narrowly."""
    turns, lengths = np.abs(curve.joint_turns), curve.lengths
    before = np.roll(lengths, 1) if curve.closed else np.append(lengths[:1], lengths)
    after = lengths if curve.closed else np.append(lengths, lengths[-1:])
    narrow = (0.5 * (before + after) < REACH * turns) & (turns > 0.0)
    return along[: len(turns)][(turns > CORNER) | narrow]

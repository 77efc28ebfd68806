# SPDX-License-Identifier: LGPL-2.1-or-later
"""A drawing that is drawn out or in keeps its form: the seam has no step where two sides meet."""

from __future__ import annotations

import numpy as np
import pytest
from drawn_letters import letter_outline
from drawn_shapes import corners_of

from BalloonWorkbench.core.bag_design.band_start import drawn_out
from BalloonWorkbench.core.geometry.crossings import first_crossing
from BalloonWorkbench.core.geometry.normals import turns
from BalloonWorkbench.core.geometry.polyline import arc_lengths, point_at
from BalloonWorkbench.core.geometry.sampling import resample
from BalloonWorkbench.core.types import Floats

STEP = 0.003
ONE_KINK = 2.0  # [rad]: a step has four turns of one or more
NOTCHED = corners_of((0.0, 0.0), (0.3, 0.0), (0.3, 0.25), (0.15, 0.15), (0.0, 0.25))


def whole_turn(loop: Floats) -> float:
    """How far a loop turns to either side in all, looked at in even steps [rad]."""
    along = arc_lengths(loop)
    count = int(along[-1] / STEP)
    return float(np.abs(turns(point_at(loop, along, along[-1] * np.arange(count) / count))).sum())


@pytest.mark.parametrize("sign", ["B", "8", "M", "notch"])
@pytest.mark.parametrize("by", [0.015, -0.008])
def test_no_steps_beside_notches_and_corners(sign: str, by: float) -> None:
    drawing = NOTCHED if sign == "notch" else letter_outline("sans bold", sign)
    loop = resample(drawing.outer, 0.0015)
    moved = loop + drawn_out(loop, np.full(len(loop), by))
    assert first_crossing([moved]) is None
    assert whole_turn(moved) < whole_turn(loop) + ONE_KINK


def test_the_corner_of_a_notch_is_where_both_moved_sides_meet() -> None:
    loop, by = resample(NOTCHED.outer, 0.0015), 0.01
    moved = loop + drawn_out(loop, np.full(len(loop), by))
    corner = int(np.argmin(np.linalg.norm(loop - (0.15, 0.15), axis=1)))
    slant = np.hypot(0.15, 0.1)
    assert moved[corner] == pytest.approx([0.15, 0.15 + by * slant / 0.15], abs=1e-5)
    assert moved[:, 0].max() == pytest.approx(0.3 + by, abs=1e-6)

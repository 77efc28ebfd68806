# SPDX-License-Identifier: LGPL-2.1-or-later
"""Repairs change what they are for, and nothing else."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from drawn_shapes import corners_of, hole, polar

from BalloonWorkbench.core.advice.findings import Repair, RepairKind
from BalloonWorkbench.core.advice.places import whole
from BalloonWorkbench.core.advice.repairs import repaired, scaled
from BalloonWorkbench.core.errors import OutlineError
from BalloonWorkbench.core.outline.outline import Outline

ARM = 0.01
#: A square of 60 mm with an arm of 10 mm to the right.
DRAWN = corners_of(
    (0.0, 0.0),
    (0.06, 0.0),
    (0.06, 0.025),
    (0.12, 0.025),
    (0.12, 0.035),
    (0.06, 0.035),
    (0.06, 0.06),
    (0.0, 0.06),
)
LINE = np.array([[0.115, 0.03], [0.062, 0.03]])
WIDEN = Repair(RepairKind.WIDEN, LINE, 0.02, ARM)
CORNER = Repair(RepairKind.ROUND, np.array([[0.0, 0.0]]), 0.01)
NOTCH = Repair(RepairKind.ROUND, np.array([[0.06, 0.025]]), 0.008)


def width_at(outline: Outline, x: float) -> float:
    return float(whole(outline).intersection(shapely.LineString([(x, -1.0), (x, 1.0)])).length)


def test_arm_is_widened() -> None:
    after = repaired(DRAWN, WIDEN)
    for x in (0.08, 0.09, 0.1, 0.11):
        assert width_at(after, x) == pytest.approx(0.02, rel=0.01)
    assert width_at(after, 0.03) == pytest.approx(0.06, rel=1e-9)


def test_wide_part_is_not_narrowed() -> None:
    assert whole(repaired(DRAWN, WIDEN)).buffer(1e-9).covers(whole(DRAWN))


def test_rest_of_the_outline_stays() -> None:
    for repair, reach in ((WIDEN, 0.02), (CORNER, 0.012), (NOTCH, 0.012)):
        changed = whole(repaired(DRAWN, repair)).symmetric_difference(whole(DRAWN))
        assert changed.area > 0.0
        place = (
            shapely.LineString(repair.points) if len(repair.points) > 1 else shapely.Point(repair.points[0])
        )
        assert place.buffer(reach).covers(changed.buffer(-2e-5))  # slivers of 40 um do not count


def test_corner_and_notch_become_arcs() -> None:
    """A square corner loses (1 - pi / 4) r^2, a notch gains it."""
    lost = DRAWN.area - repaired(DRAWN, CORNER).area
    assert lost == pytest.approx((1.0 - np.pi / 4.0) * 0.01**2, rel=0.02)
    gained = repaired(DRAWN, NOTCH).area - DRAWN.area
    assert gained == pytest.approx((1.0 - np.pi / 4.0) * 0.008**2, rel=0.02)


def test_holes_stay_in_their_order() -> None:
    holes = (hole(0.005, 0.045, 0.045), hole(0.004, 0.015, 0.045))
    after = repaired(Outline(DRAWN.outer, holes), WIDEN)
    assert [one.mean(axis=0) for one in after.holes] == [pytest.approx(one.mean(axis=0)) for one in holes]


def test_parts_that_would_grow_together_are_refused() -> None:
    finger = shapely.box(0.06, 0.04, 0.12, 0.05)
    two = Outline(np.array(whole(DRAWN).union(finger).exterior.coords)[:-1][::-1])
    with pytest.raises(OutlineError, match=r"grow together|hole"):
        repaired(two, Repair(RepairKind.WIDEN, LINE, 0.03, ARM))


@pytest.mark.parametrize("repair", [WIDEN, CORNER])
def test_repair_of_something_else_is_refused(repair: Repair) -> None:
    with pytest.raises(OutlineError, match="no longer fits"):
        repaired(Outline(polar(0.1) + 0.5), repair)


def test_repair_scales_with_the_drawing() -> None:
    large = DRAWN.map(lambda loop: 2.0 * loop)
    after = repaired(large, scaled(WIDEN, 2.0))
    assert after.area == pytest.approx(4.0 * repaired(DRAWN, WIDEN).area, rel=1e-9)


def test_moved_intake_leaves_the_outline() -> None:
    assert repaired(DRAWN, Repair(RepairKind.MOVE_INTAKE, np.zeros((1, 2)), 1.0)) is DRAWN

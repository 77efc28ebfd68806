# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies of many triangles made simpler: closed as before, and nearly where they were."""

from __future__ import annotations

import numpy as np
import pytest
from solids import ball, rounded_box, torus

from BalloonWorkbench.core.targets.nearest_surface import NearestSurface
from BalloonWorkbench.core.targets.simplify import simplified
from BalloonWorkbench.core.targets.target import Target


@pytest.mark.parametrize(
    ("target", "most", "away"),
    [
        (ball((1.0, 0.8, 0.6), 50), 3000, 2e-3),
        (torus(around=160, across=80), 3000, 2e-3),
        (rounded_box(count=40), 1500, 3e-3),
    ],
)
def test_fewer_triangles_on_the_same_surface(target: Target, most: int, away: float) -> None:
    points, triangles = simplified(target.points, target.triangles, most)
    made = Target(points, triangles)
    assert 0.9 * most < len(triangles) <= most
    assert (made.twins >= 0).all()
    assert len(points) - len(triangles) // 2 == len(target.points) - len(target.triangles) // 2, "its holes"
    assert made.volume == pytest.approx(target.volume, rel=2e-2)
    nearest = NearestSurface(points, triangles).query(target.points)
    assert np.abs(nearest.distances).max() < away * target.diagonal


def test_what_is_simple_enough_stays() -> None:
    target = ball(count=8)
    points, triangles = simplified(target.points, target.triangles, 5000)
    assert points.tobytes() == target.points.tobytes()
    assert triangles.tobytes() == target.triangles.tobytes()

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Crossings, what lies inside and how often a loop goes round, against shapely and brute force."""

import numpy as np
import pytest
from plane_shapes import circle

from BalloonWorkbench.core.geometry.crossings import contains, first_crossing


def test_crossings_agree_with_another_library_on_random_loops():
    shapely = pytest.importorskip("shapely")
    random = np.random.default_rng(3)
    crossed = 0
    for _ in range(300):
        count = int(random.integers(3, 9))
        angle = np.sort(random.uniform(0, 2 * np.pi, count)) + random.normal(0, 0.3, count)
        loop = np.column_stack([np.cos(angle), np.sin(angle)]) * random.uniform(0.2, 1, (count, 1))
        simple = shapely.LinearRing(loop).is_simple
        assert (first_crossing([loop]) is None) == simple
        crossed += not simple
    assert 50 < crossed < 250


def test_a_crossing_is_found_in_a_long_loop():
    loop = circle(0.1, 20_000)
    assert first_crossing([loop]) is None
    loop[[5000, 5001]] = loop[[5001, 5000]]
    assert np.linalg.norm(first_crossing([loop]) - loop[5000]) < 1e-3


def test_points_inside_a_loop():
    points = np.random.default_rng(1).uniform(-1.2, 1.2, (500, 2))
    assert (contains(circle(1.0, 720), points) == (np.linalg.norm(points, axis=1) < 1)).mean() > 0.99

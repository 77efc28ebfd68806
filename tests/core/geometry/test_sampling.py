# SPDX-License-Identifier: LGPL-2.1-or-later
"""Other points on the same line: even ones, few enough, smooth; corners stay."""

import numpy as np
import pytest
import shapely
from plane_shapes import circle, rectangle

from BalloonWorkbench.core.geometry.normals import corners
from BalloonWorkbench.core.geometry.polyline import arc_lengths, perimeter, signed_area
from BalloonWorkbench.core.geometry.sampling import evenly, resample, simplify, smooth, with_points_at


def test_resampling_keeps_corners_and_spaces_evenly():
    drawn = np.array([[0, 0], [0.1, 0], [0.3, 0], [0.3, 0.1], [0.1, 0.1], [0.1, 0.3], [0, 0.3]])
    loop = resample(drawn, 0.007)
    for corner in np.delete(drawn, 1, axis=0):
        assert np.abs(loop - corner).sum(axis=1).min() < 1e-12
    steps = np.linalg.norm(np.roll(loop, -1, axis=0) - loop, axis=1)
    assert 0.0065 < steps.min() < steps.max() < 0.0075
    assert signed_area(loop) == pytest.approx(signed_area(drawn))


def test_resampling_a_curve_loses_what_it_says():
    loop = resample(circle(0.1, 5000), 0.01)
    assert len(loop) == 63
    assert np.abs(np.linalg.norm(loop, axis=1) - 0.1).max() < 1e-6
    middle = 0.5 * (loop + np.roll(loop, -1, axis=0))
    assert 0.1 - np.linalg.norm(middle, axis=1).min() == pytest.approx(0.01**2 / 8 / 0.1, rel=0.02)


@pytest.mark.parametrize("spacing", [1.0, 1e3])
def test_coarse_resampling_still_gives_a_loop(spacing):
    assert len(resample(circle(0.1), spacing)) == 3
    assert len(resample(rectangle(0.2, 0.1), spacing)) >= 3


def test_corners_are_seen_through_cut_off_tips():
    cut = np.array([[1, 0], [9, 0], [10, 1], [10, 9], [9, 10], [1, 10], [0, 9], [0, 1]], dtype=float)
    assert len(corners(cut)) == 8
    assert len(corners(resample(cut, 0.2), reach=2.0)) == 4
    assert len(corners(circle(5.0))) == 0


def test_simplifying_stays_within_its_tolerance():
    drawn = circle(1.0, 2000)
    loop = simplify(drawn, 0.001)
    assert 60 < len(loop) < 150  # chords of 0.001 sagitta: at least 71
    assert shapely.hausdorff_distance(shapely.LinearRing(loop), shapely.LinearRing(drawn)) < 0.0011
    assert len(simplify(resample(rectangle(3, 2), 0.1), 1e-6)) == 4


def test_smoothing_removes_ripples_and_keeps_corners_and_size():
    random = np.random.default_rng(5)
    drawn = resample(rectangle(100.0, 60.0), 0.5)
    kept = corners(drawn)
    rough = drawn + random.normal(0, 0.2, drawn.shape)
    rough[kept] = drawn[kept]
    smoothed = smooth(rough, 2.0, kept)
    away = np.minimum.reduce(
        [
            np.abs(smoothed[:, 0]),
            np.abs(smoothed[:, 0] - 100),
            np.abs(smoothed[:, 1]),
            np.abs(smoothed[:, 1] - 60),
        ]
    )
    assert away.max() < 0.25
    assert away.std() < 0.06
    for corner in drawn[kept]:
        assert np.abs(smoothed - corner).sum(axis=1).min() < 1e-9
    ring = smooth(circle(50.0, 1000), 2.0, np.zeros(0, dtype=int))
    assert np.linalg.norm(ring, axis=1) == pytest.approx(50 - 2.0**2 / (2 * 50), abs=2e-3)


@pytest.mark.parametrize("spacing", [0.013, 0.1, 99.0])
def test_even_points_are_no_farther_apart_than_asked_for(spacing: float) -> None:
    """Twelve at least. Three copies differed: one rounded the number of points down."""
    for loop in (circle(1.0, 333), rectangle(3.0, 2.0)):
        even = evenly(loop, spacing)
        around = perimeter(loop)
        assert len(even) == max(12, np.ceil(around / spacing))
        assert np.array_equal(even[0], loop[0])
        there = shapely.LinearRing(loop)
        places = there.project(shapely.points(even))
        assert np.diff(np.append(places, around)) == pytest.approx(around / len(even), abs=1e-9)


def test_points_are_added_without_changing_the_loop() -> None:
    drawn = rectangle(3.0, 2.0)
    lengths = arc_lengths(drawn)
    more, numbers = with_points_at(drawn, lengths, np.array([0.5, 3.0, 9.9]))
    assert more[numbers] == pytest.approx(np.array([[0.5, 0.0], [3.0, 0.0], [0.0, 0.1]]))
    assert len(more) == 6
    assert signed_area(more) == pytest.approx(6.0)

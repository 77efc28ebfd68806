# SPDX-License-Identifier: LGPL-2.1-or-later
"""Loops: validity with the place of the fault, size limits, sampling that keeps corners."""

import math

import numpy as np
import pytest

from BalloonWorkbench.core.errors import InputError, OutlineError
from BalloonWorkbench.core.outline import validity
from BalloonWorkbench.core.outline.crossings import contains, first_crossing
from BalloonWorkbench.core.outline.outline import Outline, signed_area


def rectangle(width, height, x=0.0, y=0.0):
    return np.array([[x, y], [x + width, y], [x + width, y + height], [x, y + height]])


def circle(radius, count=400, x=0.0, y=0.0):
    angle = 2 * np.pi * np.arange(count) / count
    return np.column_stack([x + radius * np.cos(angle), y + radius * np.sin(angle)])


def test_loops_are_oriented_and_keep_their_area():
    checked = validity.check(Outline(rectangle(0.3, 0.2)[::-1], (rectangle(0.1, 0.1, 0.05, 0.05),)))
    assert signed_area(checked.outer) == pytest.approx(0.06)
    assert signed_area(checked.holes[0]) == pytest.approx(-0.01)
    assert checked.area == pytest.approx(0.05)


def test_repeated_points_and_spikes_go_and_the_corners_stay():
    square = rectangle(0.1, 0.1)
    spike = [[0.1, 0.05], [0.15, 0.05], [0.1, 0.05]]
    drawn = np.vstack([square[:1], square[:2], square[1:2], spike, square[2:], square[:1]])
    checked = validity.check(Outline(drawn)).outer
    assert {tuple(p) for p in square.round(9)} <= {tuple(p) for p in checked.round(9)}
    assert len(checked) == 5  # the foot of the spike stays on the edge
    assert signed_area(checked) == pytest.approx(0.01)


@pytest.mark.parametrize(
    ("outer", "message"),
    [
        ([[0, 0], [0.01, 0.01], [0.01, 0], [0, 0.01]], r"crosses .* \(5, 5\) mm"),
        ([[0, 0], [0.02, 0], [0.02, 0.02], [0.01, 0], [0, 0.02]], r"touches itself at \(10, 0\) mm"),
        ([[0, 0], [0.01, 0], [0.02, 0]], "no area"),
        ([[0, 0], [0.01, 0]], "no area"),
        ([[0.5, 0.5]] * 6, "no area"),
        (np.zeros((0, 2)), "no area"),
        ([[0, 0], [0.01, math.nan], [0.01, 0.01]], "not a number"),
        ([[0, 0], [math.inf, 0], [0.01, 0.01]], "not a number"),
    ],
)
def test_a_bad_outline_says_what_and_where(outer, message):
    with pytest.raises(OutlineError, match=message):
        validity.check(Outline(np.array(outer, dtype=float)))


@pytest.mark.parametrize(
    ("hole", "message"),
    [
        (rectangle(0.05, 0.05, 0.08, 0.02), r"meets the outline .* \(100, "),
        (rectangle(0.05, 0.05, 0.05, 0.05), "meets the outline"),  # shares edges
        (rectangle(0.01, 0.01, 0.5, 0.5), "outside the outline"),
        (rectangle(0.02, 0.02, 0.035, 0.035), "in another hole"),
    ],
)
def test_a_bad_hole_says_what(hole, message):
    with pytest.raises(OutlineError, match=message):
        validity.check(Outline(rectangle(0.1, 0.1), (rectangle(0.04, 0.04, 0.03, 0.03), hole)))


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


def test_an_outline_is_scaled_to_fit():
    outline = Outline(rectangle(2.0, 1.0))
    assert validity.scale_to(outline, 0.3, None).size == pytest.approx((0.3, 0.15))
    assert validity.scale_to(outline, None, 0.3).size == pytest.approx((0.6, 0.3))
    assert validity.scale_to(outline, 0.3, 0.3).size == pytest.approx((0.3, 0.15))
    assert validity.scale_to(outline, 0.3, 0.1).size == pytest.approx((0.2, 0.1))
    assert validity.scale_to(outline, None, None) is outline


@pytest.mark.parametrize("width", [0.0, -0.3, 1e5, 9e-4, math.nan, math.inf])
def test_impossible_sizes_are_refused(width):
    for size in ((width, None), (None, width), (0.3, width)):
        with pytest.raises(InputError, match="between 1 mm and 100 m"):
            validity.scale_to(Outline(rectangle(2.0, 1.0)), *size)


def test_an_outline_of_impossible_own_size_is_refused():
    with pytest.raises(InputError, match="width of 300 m "):
        validity.scale_to(Outline(rectangle(300.0, 150.0)), None, None)
    with pytest.raises(InputError, match="height"):
        validity.scale_to(Outline(rectangle(1.0, 0.001)), 0.3, None)
    assert validity.scale_to(Outline(rectangle(300.0, 150.0)), 0.3, None).size == pytest.approx((0.3, 0.15))


def test_resampling_keeps_corners_and_spaces_evenly():
    drawn = np.array([[0, 0], [0.1, 0], [0.3, 0], [0.3, 0.1], [0.1, 0.1], [0.1, 0.3], [0, 0.3]])
    loop = validity.resample(drawn, 0.007)
    for corner in np.delete(drawn, 1, axis=0):
        assert np.abs(loop - corner).sum(axis=1).min() < 1e-12
    steps = np.linalg.norm(np.roll(loop, -1, axis=0) - loop, axis=1)
    assert 0.0065 < steps.min() < steps.max() < 0.0075
    assert signed_area(loop) == pytest.approx(signed_area(drawn))


def test_resampling_a_curve_loses_what_it_says():
    loop = validity.resample(circle(0.1, 5000), 0.01)
    assert len(loop) == 63
    assert np.abs(np.linalg.norm(loop, axis=1) - 0.1).max() < 1e-6
    middle = 0.5 * (loop + np.roll(loop, -1, axis=0))
    assert 0.1 - np.linalg.norm(middle, axis=1).min() == pytest.approx(0.01**2 / 8 / 0.1, rel=0.02)


@pytest.mark.parametrize("spacing", [1.0, 1e3])
def test_coarse_resampling_still_gives_a_loop(spacing):
    assert len(validity.resample(circle(0.1), spacing)) == 3
    assert len(validity.resample(rectangle(0.2, 0.1), spacing)) >= 3


def test_corners_are_seen_through_cut_off_tips():
    cut = np.array([[1, 0], [9, 0], [10, 1], [10, 9], [9, 10], [1, 10], [0, 9], [0, 1]], dtype=float)
    assert len(validity.corners(cut)) == 8
    assert len(validity.corners(validity.resample(cut, 0.2), reach=2.0)) == 4
    assert len(validity.corners(circle(5.0))) == 0


def test_simplifying_stays_within_its_tolerance():
    shapely = pytest.importorskip("shapely")
    drawn = circle(1.0, 2000)
    loop = validity.simplify(drawn, 0.001)
    assert 60 < len(loop) < 150  # chords of 0.001 sagitta: at least 71
    assert shapely.hausdorff_distance(shapely.LinearRing(loop), shapely.LinearRing(drawn)) < 0.0011
    assert len(validity.simplify(validity.resample(rectangle(3, 2), 0.1), 1e-6)) == 4


def test_smoothing_removes_ripples_and_keeps_corners_and_size():
    random = np.random.default_rng(5)
    drawn = validity.resample(rectangle(100.0, 60.0), 0.5)
    corners = validity.corners(drawn)
    rough = drawn + random.normal(0, 0.2, drawn.shape)
    rough[corners] = drawn[corners]
    smoothed = validity.smooth(rough, 2.0, corners)
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
    for corner in drawn[corners]:
        assert np.abs(smoothed - corner).sum(axis=1).min() < 1e-9
    ring = validity.smooth(circle(50.0, 1000), 2.0, np.zeros(0, dtype=int))
    assert np.linalg.norm(ring, axis=1) == pytest.approx(50 - 2.0**2 / (2 * 50), abs=2e-3)

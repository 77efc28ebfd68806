# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lengths, places and areas of loops and lines against closed forms and shapely; flat and empty loops too."""

from itertools import pairwise

import numpy as np
import pytest
import shapely
from plane_shapes import circle, rectangle

from BalloonWorkbench.core.geometry import polyline as lines
from BalloonWorkbench.core.geometry.cleaning import clean
from BalloonWorkbench.core.geometry.normals import corners, left_normals, turns, turns_at

RANDOM = np.random.default_rng(8)
#: A point, twice the same, out and back, on one line.
DEGENERATE = [
    np.zeros((1, 2)),
    np.ones((2, 2)),
    np.array([[0.0, 0.0], [1.0, 0.0]]),
    np.array([[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]]),
]


@pytest.mark.parametrize("loop", [RANDOM.normal(size=(12, 2)) for _ in range(5)] + DEGENERATE)
def test_lengths_and_places_are_shapelys(loop) -> None:
    ring = lines.ring(loop)
    there = shapely.LineString(ring if len(ring) > 1 else np.repeat(ring, 2, axis=0))
    lengths = lines.arc_lengths(loop)
    assert lines.perimeter(loop) == pytest.approx(there.length)
    assert lines.length(ring) == pytest.approx(there.length)
    assert lengths[-1] == pytest.approx(there.length)
    assert np.array_equal(lengths, lines.line_lengths(ring))
    assert lines.point_weights(loop).sum() == pytest.approx(there.length)
    if there.length:
        at = there.length * RANDOM.uniform(0.0, 1.0, 30)
        places = shapely.get_coordinates(shapely.line_interpolate_point(there, at))
        assert lines.point_at(loop, lengths, at) == pytest.approx(places, abs=1e-12)
        assert lines.point_at(loop, lengths, at - 3.0 * there.length) == pytest.approx(places, abs=1e-12)
        assert lines.point_on(ring, lengths, at) == pytest.approx(places, abs=1e-12)


def test_lines_may_lie_in_space() -> None:
    helix = np.column_stack([circle(1.0, 1000), np.linspace(0.0, 2.0, 1000)])
    assert lines.length(helix) == pytest.approx(np.hypot(2.0 * np.pi * 0.999, 2.0), rel=1e-4)
    assert lines.point_on(helix, lines.line_lengths(helix), np.array([0.0])) == pytest.approx(helix[:1])


@pytest.mark.parametrize("loop", [RANDOM.normal(size=(7, 2)) + 1e3 for _ in range(5)] + DEGENERATE)
def test_areas_are_those_of_triangles(loop) -> None:
    fan = [np.linalg.det(np.stack([one - loop[0], other - loop[0]])) for one, other in pairwise(loop)]
    assert lines.signed_area(loop) == pytest.approx(0.5 * sum(fan), abs=1e-9)
    assert lines.signed_area(loop[::-1]) == pytest.approx(-0.5 * sum(fan), abs=1e-9)


def test_orientation() -> None:
    for loop in (circle(1.0, 9), circle(1.0, 9)[::-1]):
        assert lines.signed_area(lines.oriented(loop)) > 0.0
        assert lines.signed_area(lines.oriented(loop, False)) < 0.0


def test_the_centroid_of_a_shape_with_a_hole_is_shapelys() -> None:
    outer, hole = rectangle(0.3, 0.2, 5.0, 3.0), rectangle(0.05, 0.1, 5.02, 3.05)[::-1]
    whole = shapely.Polygon(outer, [hole])
    assert lines.centroid([outer, hole]) == pytest.approx(np.array(whole.centroid.coords[0]), abs=1e-12)


def test_a_part_of_a_line_runs_from_place_to_place() -> None:
    line = RANDOM.normal(size=(9, 2)).cumsum(axis=0)
    whole, lengths = lines.length(line), lines.line_lengths(line)
    for start, end in [(0.0, whole), (0.1 * whole, 0.7 * whole), (float(lengths[2]), float(lengths[5]))]:
        part = lines.part_of(line, start, end)
        assert lines.length(part) == pytest.approx(end - start)
        assert part[[0, -1]] == pytest.approx(lines.point_on(line, lengths, np.array([start, end])))
        assert lines.edge_lengths(part)[:-1].min() > 1e-9 * whole  # no point twice


def test_the_way_between_places_goes_round_the_start() -> None:
    one, other = RANDOM.uniform(0.0, 2.0 * np.pi, (2, 100))
    assert lines.gaps(one, other, 2.0 * np.pi) == pytest.approx(np.abs(np.angle(np.exp(1j * (one - other)))))


def test_the_extent_is_the_longer_side() -> None:
    assert lines.extent(rectangle(0.2, 0.7, 3.0, 4.0)) == pytest.approx(0.7)
    assert lines.extent(np.zeros((1, 2))) == 0.0


@pytest.mark.parametrize("smoothed", [0, 2])
def test_normals_of_a_circle_point_to_its_middle(smoothed: int) -> None:
    ring = circle(2.0, 60)
    assert left_normals(ring, smoothed) == pytest.approx(-ring / 2.0)
    assert left_normals(ring[::-1], smoothed) == pytest.approx(ring[::-1] / 2.0)


def test_a_crumpled_rim_has_smooth_normals_on_average() -> None:
    ring = circle(1.0, 200) * (1.0 + 0.004 * (-1.0) ** np.arange(200))[:, None]
    assert np.abs(left_normals(ring, smoothed=2) + circle(1.0, 200)).max() < 0.01
    assert np.array_equal(left_normals(np.zeros((4, 2))), np.zeros((4, 2)))


def test_each_direction_counts_twice_and_those_beside_it_once() -> None:
    loop = RANDOM.normal(size=(6, 2))
    along = [loop[(k + 1) % 6] - loop[k - 1] for k in range(6)]
    for k, normal in enumerate(left_normals(loop, smoothed=1)):
        x, y = along[k - 1] + 2.0 * along[k] + along[(k + 1) % 6]
        assert normal == pytest.approx(np.array([-y, x]) / np.hypot(x, y))


@pytest.mark.parametrize("count", [3, 4, 7, 30])
def test_a_loop_turns_by_a_whole_circle(count: int) -> None:
    polygon = circle(1.0, count)
    assert turns(polygon) == pytest.approx(2.0 * np.pi / count)
    assert turns(polygon[::-1]) == pytest.approx(-2.0 * np.pi / count)
    simple = circle(1.0, 30) * RANDOM.uniform(0.3, 1.0, (30, 1))
    assert turns(simple).sum() == pytest.approx(2.0 * np.pi)


def test_turns_over_a_reach_see_a_cut_off_corner() -> None:
    square = np.array([[0.1, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0], [0.0, 0.1]])
    assert np.degrees(turns(square, 2.0)[[0, -1]]) == pytest.approx(90.0, abs=5.0)
    lengths = lines.arc_lengths(square)
    assert turns_at(square, lengths, lengths[:-1], 2.0) == pytest.approx(turns(square, 2.0))


def test_corners_far_apart_are_each_one() -> None:
    assert corners(rectangle(3.0, 2.0)).tolist() == [0, 1, 2, 3]
    assert corners(rectangle(3.0, 2.0), reach=0.5).tolist() == [0, 1, 2, 3]
    assert len(corners(np.zeros((3, 2)))) == 0


def test_cleaning_leaves_no_repeated_point_and_no_spike() -> None:
    for _ in range(50):
        loop = circle(1.0, 12) * RANDOM.uniform(0.5, 1.0, (12, 1))
        dirty = np.repeat(loop, RANDOM.integers(1, 4, len(loop)), axis=0)
        tip = int(RANDOM.integers(len(dirty)))
        spike = np.array([dirty[tip] * 1.5, dirty[tip]])
        cleaned = clean(np.insert(dirty, tip + 1, spike, axis=0), 1e-9)
        assert sorted(map(tuple, cleaned)) == sorted(map(tuple, loop))
    assert len(clean(np.zeros((5, 2)), 1e-9)) == 1
    assert len(clean(np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 0.0], [1.0, 0.0]]), 1e-9)) <= 2

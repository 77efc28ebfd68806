# SPDX-License-Identifier: LGPL-2.1-or-later
"""Crossings, what lies inside and how often a loop goes round, against shapely and brute force."""

import numpy as np
import pytest
import shapely
from plane_shapes import circle

from BalloonWorkbench.core.geometry.crossings import contains, crossed_at, first_crossing, inside, winding


def test_crossings_agree_with_another_library_on_random_loops():
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


def test_lines_and_loops_meet_where_shapely_says() -> None:
    """Open lines, loops and both together, also with a line of one point among them."""
    random = np.random.default_rng(11)
    met = 0
    for _ in range(200):
        line = random.uniform(-1.5, 1.5, (3, 2))
        others = [random.uniform(-1.5, 1.5, (2, 2)), random.uniform(-1.0, 1.0, (1, 2))]
        ring = shapely.LinearRing(circle(1.0, 5))
        drawn = [shapely.LineString(part) for part in (line, others[0])]
        apart = drawn[0].is_simple and not (ring.intersects(drawn[0]) or ring.intersects(drawn[1]))
        apart = apart and not drawn[0].intersects(drawn[1])
        place = first_crossing([circle(1.0, 5)], [line, others[1], others[0]])
        assert (place is None) == apart
        if place is not None:
            met += 1
            near = [each.distance(shapely.Point(place)) < 1e-9 for each in (ring, *drawn)]
            assert sum(near) >= 1 + drawn[0].is_simple
    assert 50 < met < 200


def test_touching_and_overlapping_edges_meet() -> None:
    comb = np.array([[0, 0], [2, 0], [2, 1], [1, 0], [0, 1]], dtype=float)  # a tip on an edge
    assert first_crossing([comb]) == pytest.approx([1.0, 0.0])
    on_one_line = [np.array([[0.0, 0.0], [2.0, 0.0]]), np.array([[1.0, 0.0], [3.0, 0.0]])]
    assert first_crossing([], on_one_line) == pytest.approx([1.5, 0.0])
    assert first_crossing([], [on_one_line[0], on_one_line[1] + (0.0, 1e-6)]) is None


def test_a_search_can_be_ended() -> None:
    def check() -> None:
        raise TimeoutError

    with pytest.raises(TimeoutError):
        first_crossing([circle(1.0, 100)], (), check)


@pytest.mark.parametrize("count", [1, 2, 5])
def test_inside_of_several_loops_is_an_odd_number_of_them(count: int) -> None:
    random = np.random.default_rng(count)
    loops = [circle(random.uniform(0.3, 1.0), 7) + random.uniform(-0.5, 0.5, 2) for _ in range(count)]
    points = random.uniform(-1.5, 1.5, (2000, 2))
    around = sum(shapely.contains_xy(shapely.Polygon(loop), points[:, 0], points[:, 1]) for loop in loops)
    assert np.array_equal(inside(loops, points), np.asarray(around) % 2 == 1)


def test_points_of_one_height_and_edges_along_it() -> None:
    """As lattices and pictures have them: rows of points through corners and along edges of a loop."""
    cross = np.array(
        [[1, 0], [2, 0], [2, 1], [3, 1], [3, 2], [2, 2], [2, 3], [1, 3], [1, 2], [0, 2], [0, 1], [1, 1]]
    )
    x, y = (part.ravel() for part in np.meshgrid(np.arange(0.25, 3.0, 0.5), np.arange(0.0, 3.0, 0.5)))
    points = np.column_stack([x, y])
    middle = np.column_stack([x, y + 0.01])  # an edge belongs to what lies above it
    assert np.array_equal(contains(cross.astype(float), points), contains(cross.astype(float), middle))


def test_heights_are_crossed_in_pairs() -> None:
    random = np.random.default_rng(5)
    loop = random.normal(size=(40, 2))
    for height in [*random.normal(size=50), *loop[:5, 1]]:
        at = crossed_at(loop, height)
        assert len(at) % 2 == 0
        line = shapely.LineString([(-9.0, height + 1e-12), (9.0, height + 1e-12)])
        met = shapely.get_coordinates(shapely.LineString(np.vstack([loop, loop[:1]])).intersection(line))
        assert np.sort(at) == pytest.approx(np.sort(met[:, 0]), abs=1e-9)
    assert len(crossed_at(loop, 99.0)) == 0


def test_winding_counts_how_often_the_angle_goes_round() -> None:
    random = np.random.default_rng(9)
    turns = np.linspace(0.0, 4.0 * np.pi, 60, endpoint=False)  # twice round
    loop = np.column_stack([np.cos(turns), np.sin(turns)]) * (1.0 + 0.3 * np.cos(0.5 * turns))[:, None]
    points = random.uniform(-1.5, 1.5, (300, 2))
    ends = np.roll(loop, -1, axis=0)
    seen = (ends - points[:, None]) @ [1, 1j] / ((loop - points[:, None]) @ [1, 1j])
    assert np.array_equal(winding(loop, ends, points), np.rint(np.angle(seen).sum(axis=1) / (2.0 * np.pi)))
    assert np.array_equal(winding(ends, loop, points), -winding(loop, ends, points))
    assert set(winding(loop, ends, points)) == {0, 1, 2}

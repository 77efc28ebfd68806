# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nearest places: every way to them agrees with shapely, at corners, far away, on edges without length."""

import numpy as np
import pytest
import shapely
from plane_shapes import circle, rectangle

from BalloonWorkbench.core.errors import MissingPackageError
from BalloonWorkbench.core.geometry import nearest
from BalloonWorkbench.core.geometry.nearest import (
    locate,
    nearest_along,
    nearest_edges,
    nearest_on_line,
    nearest_places,
)
from BalloonWorkbench.core.geometry.polyline import arc_lengths, edge_vectors, point_at, ring

RANDOM = np.random.default_rng(6)
POINTS = np.concatenate([RANDOM.uniform(-2.0, 2.0, (300, 2)), RANDOM.uniform(-50.0, 50.0, (20, 2))])


def loops():
    """Even ones, long edges beside short ones, a repeated point, one line out and back."""
    clustered = np.sort(np.concatenate([RANDOM.uniform(0.0, 0.2, 80), RANDOM.uniform(0.2, 6.2, 12)]))
    yield "circle", circle(1.0, 90)
    yield "rectangle", rectangle(2.0, 0.5, -1.0, -0.2)
    yield "clustered", np.column_stack([np.cos(clustered), np.sin(clustered)])
    yield "repeated", np.repeat(circle(1.0, 7), 2, axis=0)
    yield "flat", np.array([[-1.0, 0.0], [0.0, 0.0], [1.0, 0.0]])


LOOPS = dict(loops())


@pytest.mark.parametrize("name", LOOPS)
def test_every_way_to_the_nearest_place_gives_the_same(name: str) -> None:
    loop = LOOPS[name]
    there = shapely.LineString(ring(loop))
    away = shapely.distance(there, shapely.points(POINTS))
    edge, share, distance = nearest_on_line(ring(loop), POINTS)
    assert distance == pytest.approx(away, abs=1e-12)
    places = loop[edge] + share[:, None] * edge_vectors(loop)[edge]
    assert np.linalg.norm(places - POINTS, axis=1) == pytest.approx(away, abs=1e-12)
    lengths = arc_lengths(loop)
    for found in (
        nearest_places([loop], POINTS),
        point_at(loop, lengths, locate(loop, POINTS)),
        nearest_along(loop, POINTS, np.zeros(len(POINTS)), np.full(len(POINTS), lengths[-1])),
    ):
        assert np.linalg.norm(found - POINTS, axis=1) == pytest.approx(away, abs=1e-9)


@pytest.mark.parametrize("few", [0, 10**9])
def test_of_several_loops_the_nearest_one_and_its_place(few: int, monkeypatch) -> None:
    """With shapely's index and without it."""
    monkeypatch.setattr(nearest, "_FEW", few)
    moves = zip(LOOPS.values(), (1.0, 0.4, 0.7, 1.0, 0.2), (0.0, 1.5, -2.0, 3.0, 0.0))
    chosen = [loop * size + shift for loop, size, shift in moves]
    found = nearest.nearest_on_loops(chosen, POINTS)
    lines = [shapely.LineString(ring(loop)) for loop in chosen]
    away = np.array([shapely.distance(line, shapely.points(POINTS)) for line in lines])
    assert found.distance == pytest.approx(away.min(axis=0), abs=1e-12)
    owner, share = nearest.way_round(chosen, found)
    for number, loop in enumerate(chosen):
        mine = owner == number
        lengths = arc_lengths(loop)
        places = point_at(loop, lengths, share[mine] * lengths[-1])
        assert np.linalg.norm(places - POINTS[mine], axis=1) == pytest.approx(
            away.min(axis=0)[mine], abs=1e-9
        )


def test_a_place_is_looked_for_only_within_reach() -> None:
    """A strip: its other side is nearer, but far along the rim."""
    strip = rectangle(10.0, 0.1)
    found = nearest_along(strip, np.array([[5.0, 0.09]]), np.array([5.0]), np.array([1.0]))
    assert found[0] == pytest.approx([5.0, 0.0])
    beyond = nearest_along(strip, np.array([[5.0, 0.0]]), np.array([2.0]), np.array([0.5]))
    assert beyond[0] == pytest.approx([2.5, 0.0], abs=0.51)


@pytest.mark.parametrize("few", [0, 10**9])
def test_many_corners_close_together_hide_no_long_edge(few: int, monkeypatch) -> None:
    """Looked for among the edges beside the nearest corners, the long one below would be missed."""
    monkeypatch.setattr(nearest, "_FEW", few)
    comb = [[5.4, 0.75], [5.46, 0.76], [5.48, 0.75], [5.5, 0.76], [5.52, 0.75], [5.54, 0.76], [5.6, 0.75]]
    loop = np.array([[0.0, 0.0], [10.0, 0.0], [10.0, 5.0], [5.6, 5.0], *comb[::-1], [5.4, 5.0], [0.0, 5.0]])
    found = nearest.nearest_on_loops([loop], np.array([[5.5, 0.3]]))
    assert (found.edge[0], found.distance[0]) == (0, pytest.approx(0.3))


def test_many_points_are_taken_in_parts(monkeypatch) -> None:
    monkeypatch.setattr(nearest, "_FEW", 10**9)
    whole = nearest_on_line(circle(1.0, 50), POINTS)
    monkeypatch.setattr(nearest, "_CHUNK", 100)
    for one, other in zip(whole, nearest_on_line(circle(1.0, 50), POINTS)):
        assert np.array_equal(one, other)


def test_without_shapely_it_takes_longer(monkeypatch) -> None:
    asked = []

    def missing():
        asked.append(True)
        raise MissingPackageError("Patterns need shapely.")

    whole = nearest_on_line(circle(1.0, 300), POINTS)
    monkeypatch.setattr(nearest, "shapely", missing)
    assert nearest_on_line(circle(1.0, 300), POINTS).distance == pytest.approx(whole.distance, abs=1e-15)
    assert asked


def test_no_points_and_one_edge() -> None:
    assert len(nearest_on_line(circle(1.0, 5), np.zeros((0, 2))).distance) == 0
    found = nearest_edges(np.array([[0.5, 2.0]]), np.zeros((1, 2)), np.array([[1.0, 0.0]]))
    assert (found.edge[0], found.share[0], found.distance[0]) == (0, 0.5, 2.0)

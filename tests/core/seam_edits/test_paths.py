# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shortest paths over a surface against great circles, unfolded cubes and straight lines."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest
from solids import ball, box, torus

from BalloonWorkbench.core.geometry.polyline import length
from BalloonWorkbench.core.seam_edits.paths import PathSurface
from BalloonWorkbench.core.targets.target import Target


def path_length(target: Target, start: int, goal: int) -> float:
    path = PathSurface(target.points, target.triangles).path(start, goal)
    assert path is not None
    return length(path.places(target.points))


def vertex(target: Target, *place: float) -> int:
    away = np.linalg.norm(target.points - place, axis=1)
    assert away.min() < 1e-9
    return int(np.argmin(away))


def test_great_circles_of_a_ball() -> None:
    target, random = ball(count=25), np.random.default_rng(1)
    surface = PathSurface(target.points, target.triangles)
    for start, goal in random.integers(len(target.points), size=(30, 2)):
        path = surface.path(int(start), int(goal))
        assert path is not None
        angle = np.arccos(np.clip(target.points[start] @ target.points[goal], -1.0, 1.0))
        assert length(path.places(target.points)) == pytest.approx(angle, rel=1e-3)


def unfolded(one: np.ndarray, other: np.ndarray) -> float:
    """The shortest way between points of two faces of a cube that share the edge x = y = .5, or are one."""
    if one[0] == other[0] == 0.5 or one[1] == other[1] == 0.5:
        return float(np.linalg.norm(one - other))
    a, b = (one, other) if one[0] == 0.5 else (other, one)
    straight = [np.hypot((0.5 - a[1]) + (0.5 - b[0]), a[2] - b[2])]
    for side in (-1.0, 1.0):  # over the top or the bottom, round the corner
        up, across = 0.5 - side * a[2], 0.5 - side * b[2]
        straight.append(np.hypot(up + (0.5 - b[0]), (0.5 - a[1]) + across))
    return float(min(straight))


def test_a_cube_is_unfolded() -> None:
    target, random = box(count=6), np.random.default_rng(2)
    own = np.flatnonzero(np.isclose(target.points[:, :2], 0.5).any(axis=1))
    surface = PathSurface(target.points, target.triangles)
    for start, goal in random.choice(own, size=(60, 2)):
        if start == goal:
            continue
        path = surface.path(int(start), int(goal))
        assert path is not None
        least = unfolded(target.points[start], target.points[goal])
        found = length(path.places(target.points))
        # a path that is straight everywhere may be longer than another one round a corner
        assert least * (1.0 - 1e-9) <= found <= 1.05 * least
    corners = list(product((-0.5, 0.5), repeat=3))
    assert path_length(target, vertex(target, *corners[0]), vertex(target, *corners[-1])) == pytest.approx(
        np.sqrt(5.0)
    )


def test_the_inner_side_of_a_ring() -> None:
    """Between two places of the inner equator the way runs along it: a circle of radius .6."""
    target = torus()
    path = path_length(target, vertex(target, 0.6, 0.0, 0.0), vertex(target, 0.0, 0.6, 0.0))
    assert path == pytest.approx(0.6 * np.pi / 2.0, rel=1e-3)


def test_neighbours_and_the_same_vertex() -> None:
    target = box(count=2)
    surface = PathSurface(target.points, target.triangles)
    one, other = target.triangles[0][:2].tolist()
    path = surface.path(one, other)
    assert path is not None
    assert path.ends.tolist() == [[one, one], [other, other]]
    same = surface.path(one, one)
    assert same is not None
    assert same.ends.tolist() == [[one, one]]


def test_a_path_stays_on_a_surface_with_a_border() -> None:
    """An L of flat triangles: the way bends round its inner corner."""
    target = box(count=4)
    flat = np.isclose(target.points[target.triangles][:, :, 2], 0.5).all(axis=1)
    middles = target.points[target.triangles].mean(axis=1)
    kept = target.triangles[flat & ~((middles[:, 0] > 0.0) & (middles[:, 1] > 0.0))]
    surface = PathSurface(target.points, kept)
    path = surface.path(vertex(target, 0.5, 0.0, 0.5), vertex(target, 0.0, 0.5, 0.5))
    assert path is not None
    assert length(path.places(target.points)) == pytest.approx(1.0)
    path = surface.path(vertex(target, 0.5, -0.5, 0.5), vertex(target, -0.5, 0.5, 0.5))
    assert path is not None
    assert length(path.places(target.points)) == pytest.approx(np.sqrt(2.0))
    path = surface.path(vertex(target, 0.5, -0.25, 0.5), vertex(target, 0.0, 0.5, 0.5))
    assert path is not None
    assert length(path.places(target.points)) == pytest.approx(0.5 + np.hypot(0.5, 0.25))

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes with edges at which more than two triangles meet: one body, and what was left out is told."""

from __future__ import annotations

import numpy as np
import pytest
from solids import ball, box, welded

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.targets.mesh_files import RawMesh
from BalloonWorkbench.core.targets.read_target import target_of
from BalloonWorkbench.core.targets.target import Target
from BalloonWorkbench.core.types import Floats, Ints

Mesh = tuple[Floats, Ints]


def cubes(shift: tuple[float, float, float]) -> Mesh:
    """Two cubes of 100 mm, one of them shifted by so many edges, as one mesh."""
    one = box(count=2)
    points = np.concatenate([one.points, one.points + shift])
    return welded(100.0 * points, np.concatenate([one.triangles, one.triangles + len(one.points)]))


def made(mesh: Mesh) -> Target:
    target = target_of(RawMesh(*mesh), "mesh")
    assert (target.twins >= 0).all()
    return target


def test_of_bodies_that_touch_along_an_edge_one_is_made() -> None:
    target = made(cubes((1.0, 1.0, 0.0)))
    assert target.volume == pytest.approx(1e-3)
    assert any("largest" in note for note in target.notes)


def test_of_bodies_that_touch_in_a_point_one_is_made() -> None:
    assert made(cubes((1.0, 1.0, 1.0))).volume == pytest.approx(1e-3)


def test_the_wall_between_two_bodies_is_left_out() -> None:
    """Two cubes side by side: the face that both had is within the body."""
    target = made(cubes((1.0, 0.0, 0.0)))
    assert target.volume == pytest.approx(2e-3)
    assert any("walls inside it" in note for note in target.notes)


@pytest.mark.parametrize("count", [1, 40])
def test_sheets_on_the_surface_are_left_out(count: int) -> None:
    body = ball()
    points, triangles = 100.0 * body.points, body.triangles
    some = triangles[np.random.default_rng(3).permutation(len(triangles))[:count]]
    tips = 1.3 * points[some[:, 0]]
    sheets = np.column_stack([some[:, 0], some[:, 1], len(points) + np.arange(count)]).astype(np.int32)
    target = made((np.concatenate([points, tips]), np.concatenate([triangles, sheets])))
    assert target.volume == pytest.approx(1e-3 * body.volume, rel=1e-9)
    assert any(f"left out: {count}." in note for note in target.notes)


def test_a_plate_through_a_body_is_left_out() -> None:
    """A disc that closes off one half of a body, on edges of its surface."""
    body = box(count=4)
    rim = np.flatnonzero(np.abs(body.points[:, 2]) < 1e-9)
    ring = rim[np.argsort(np.arctan2(body.points[rim, 1], body.points[rim, 0]))]
    centre = len(body.points)
    plate = np.column_stack([ring, np.roll(ring, -1), np.full(len(ring), centre)]).astype(np.int32)
    points = 100.0 * np.concatenate([body.points, [[0.0, 0.0, 0.0]]])
    target = made((points, np.concatenate([body.triangles, plate])))
    assert target.volume == pytest.approx(1e-3)


def test_what_stays_unclear_is_refused_with_its_place() -> None:
    """Six triangles round one edge, three of which are each way round next to each other."""
    body = box(count=2)
    points, triangles = 100.0 * body.points, body.triangles
    turned = 1.0 * points
    turned[:, 2] += 20.0
    inside = np.concatenate([points, turned])
    both = np.concatenate([triangles, triangles[:, ::-1] + len(points)])
    pair = np.array([triangles[0, 0], triangles[0, 1]])
    other = np.arange(len(inside))
    other[pair + len(points)] = pair
    with pytest.raises(InputError, match=r"more than two triangles meet: 1, one of them at \(") as refused:
        made((inside, other[both]))
    assert str(refused.value).endswith(".")

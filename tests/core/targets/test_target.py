# SPDX-License-Identifier: LGPL-2.1-or-later
"""Targets against formulas: volumes, seams between their panels, nearest places, symmetry."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

import numpy as np
import pytest
from solids import ball, box, capsule, egg, rounded_box, torus

from BalloonWorkbench.core.targets.half_edges import half_edges
from BalloonWorkbench.core.targets.nearest_surface import NearestSurface
from BalloonWorkbench.core.targets.refine import cut_where_zero, refined
from BalloonWorkbench.core.targets.symmetry_planes import axis_of, symmetry_planes
from BalloonWorkbench.core.targets.target import Division, SeamLine, Target
from BalloonWorkbench.core.types import Floats, Ints

NONE = np.zeros((0, 2), dtype=np.int32)


def division(target: Target, of_place: Callable[[Floats], Ints], cuts: Ints = NONE) -> Division:
    panels = of_place(target.points[target.triangles].mean(axis=1)).astype(np.int32)
    return Division(target, panels, tuple(map(str, range(panels.max() + 1))), cuts)


def sector(count: int) -> Callable[[Floats], Ints]:
    return lambda at: (np.arctan2(at[:, 1], at[:, 0]) % (2.0 * np.pi) // (2.0 * np.pi / count)).astype(
        np.int32
    )


@pytest.mark.parametrize(
    ("target", "volume"),
    [
        (ball(), 4.0 / 3.0 * np.pi),
        (box((1.0, 2.0, 3.0)), 6.0),
        (capsule(), (2.0 + 4.0 / 3.0) * np.pi),
        (torus(), 2.0 * np.pi**2 * 0.4**2),
    ],
)
def test_volumes(target: Target, volume: float) -> None:
    assert (target.twins >= 0).all()
    assert target.volume == pytest.approx(volume, rel=1e-2)


def assert_seams_are_whole(made: Division) -> None:
    """Each edge between panels is in one seam; the sides are of the panels, and run as they should."""
    seen: set[tuple[int, int]] = set()
    for seam in made.seams:
        for k, side in enumerate(seam.sides):
            np.testing.assert_array_equal(made.opened.vertices[side], seam.vertices)
            assert (made.opened.panels[side] == seam.panels[k]).all()
        assert_runs_along(made, seam)
        edges = {tuple(sorted(edge)) for edge in zip(seam.vertices[:-1].tolist(), seam.vertices[1:].tolist())}
        assert not edges & seen
        seen |= edges
        inner = set(seam.vertices[1:-1].tolist())
        assert not inner & set(made.nodes.tolist())
    expected = np.sort(half_edges(made.target.triangles)[made.seam_edges], axis=1)
    assert seen == {tuple(edge) for edge in expected.tolist()}


def assert_runs_along(made: Division, seam: SeamLine) -> None:
    ahead = {tuple(edge) for edge in half_edges(made.opened.triangles).tolist()}
    left, right = (side.tolist() for side in seam.sides)
    assert set(pairwise(left)) <= ahead
    assert set(pairwise(right[::-1])) <= ahead


@pytest.mark.parametrize(
    ("made", "seams", "nodes"),
    [
        (division(egg(), sector(6)), 6, 2),
        (division(ball(), lambda at: at[:, 2] > 0.0), 2, 0),
        (division(ball(), lambda at: (at[:, 2] > 0.0) * 4 + sector(4)(at)), 12, 6),
        (division(torus(), sector(3)), 6, 0),
        (division(torus(), lambda at: at[:, 2] > 0.0), 4, 0),
    ],
)
def test_seams_run_from_node_to_node(made: Division, seams: int, nodes: int) -> None:
    assert_seams_are_whole(made)
    assert (len(made.seams), len(made.nodes)) == (seams, nodes)


def test_a_cut_opens_its_panel() -> None:
    target = torus()
    cut = np.arange(32)  # the points of the first ring round the tube
    cuts = np.column_stack([cut, np.roll(cut, -1)]).astype(np.int32)
    made = Division(target, np.zeros(len(target.triangles), dtype=np.int32), ("tube",), cuts)
    assert_seams_are_whole(made)
    assert len(made.opened.vertices) == len(target.points) + 32
    assert all(seam.panels == (0, 0) for seam in made.seams)


def test_distances_from_a_box_are_those_of_the_formula() -> None:
    target, places = box(), np.random.default_rng(1).uniform(-1.0, 1.0, (2000, 3))
    beyond = np.abs(places) - 0.5
    expected = np.linalg.norm(np.maximum(beyond, 0.0), axis=1) + np.minimum(beyond.max(axis=1), 0.0)
    nearest = NearestSurface(target.points, target.triangles).query(places)
    np.testing.assert_allclose(nearest.distances, expected, atol=1e-12)
    corners = target.points[target.triangles[nearest.triangles]]
    np.testing.assert_allclose(np.einsum("kc,kcd->kd", nearest.shares, corners), nearest.places, atol=1e-12)


def test_large_and_small_triangles_are_found_alike() -> None:
    """Each place is compared with all triangles."""
    target = box()
    fine = refined(target.points, target.triangles[:200], 0.02)
    points = np.concatenate([fine.points, target.points])
    triangles = np.concatenate([fine.triangles, target.triangles[200:] + len(fine.points)])
    places = np.random.default_rng(2).uniform(-1.0, 1.0, (300, 3))
    beyond = np.abs(places) - 0.5
    outside = beyond.max(axis=1) > 0.0
    expected = np.linalg.norm(np.maximum(beyond, 0.0), axis=1)
    nearest = NearestSurface(points, triangles).query(places)
    np.testing.assert_allclose(np.abs(nearest.distances[outside]), expected[outside], atol=1e-12)


def test_refining_and_cutting_keep_the_surface() -> None:
    target = box((1.0, 2.0, 3.0), count=2)
    fine = refined(target.points, target.triangles, 0.2)
    assert np.linalg.norm(np.diff(fine.points[half_edges(fine.triangles)], axis=1), axis=2).max() <= 0.2
    values = fine.points @ (0.3, 0.5, 0.8) - 0.1
    split = cut_where_zero(fine.points, fine.triangles, values)
    made = Target(split.points, split.triangles)
    assert (made.twins >= 0).all()
    assert made.volume == pytest.approx(6.0, rel=1e-12)
    assert made.areas.sum() == pytest.approx(22.0, rel=1e-12)
    ahead = (split.points @ (0.3, 0.5, 0.8) - 0.1)[split.triangles]
    assert (np.minimum(-ahead.min(axis=1), ahead.max(axis=1)) < 0.03 * 0.2).all(), (
        "nothing lies on both sides"
    )


@pytest.mark.parametrize(
    ("target", "round_about", "planes"),
    [
        (capsule(), 2, 3),
        (torus(), 2, 3),
        (ball((1.0, 1.0, 0.5)), 2, 3),
        (ball((1.0, 0.8, 0.5)), None, 3),
        (rounded_box(), None, 3),
    ],
)
def test_symmetry(target: Target, round_about: int | None, planes: int) -> None:
    axis = axis_of(target.points, target.triangles)
    assert (axis is None) == (round_about is None)
    if axis is not None:
        np.testing.assert_allclose(np.abs(axis[1]), np.eye(3)[round_about], atol=1e-6)
        np.testing.assert_allclose(axis[0][:2], 0.0, atol=1e-6)
    assert len(symmetry_planes(target.points, target.triangles)) == planes


def test_a_leaning_body_has_its_own_planes() -> None:
    target = ball((1.0, 0.7, 0.4))
    turn = np.linalg.qr(np.random.default_rng(3).normal(size=(3, 3)))[0]
    normals = [normal for _, normal in symmetry_planes(target.points @ turn.T + 5.0, target.triangles)]
    assert len(normals) == 3
    np.testing.assert_allclose(np.abs(np.array(normals) @ turn).max(axis=1), 1.0, atol=1e-3)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces that cross themselves: found where they do, cut out where that is safe, told where not."""

from __future__ import annotations

import numpy as np
import pytest
from solids import ball, box, torus

from BalloonWorkbench.core.targets.mending.crossings import crossing_triangles
from BalloonWorkbench.core.targets.mesh_files import RawMesh
from BalloonWorkbench.core.targets.read_target import target_of
from BalloonWorkbench.core.targets.target import Target
from BalloonWorkbench.core.types import Floats, Ints


def by_planes(points: Floats, triangles: Ints) -> set[int]:
    """The same one pair at a time: an edge goes through a triangle if five volumes have the right signs."""
    found = set()

    def volume(*at: int) -> float:
        a, b, c, d = points[list(at)]
        return float(np.linalg.det([b - a, c - a, d - a]))

    for i, one in enumerate(triangles.tolist()):
        for j, other in enumerate(triangles.tolist()):
            if i == j or len({*one, *other}) < 5:
                continue
            for k in range(3):
                p, q = one[k], one[(k + 1) % 3]
                if p in other or q in other or volume(*other, p) * volume(*other, q) >= 0.0:
                    continue
                sides = [volume(p, q, other[m], other[(m + 1) % 3]) for m in range(3)]
                if min(sides) > 0.0 or max(sides) < 0.0:
                    found |= {i, j}
    return found


def test_the_same_as_every_pair_by_itself() -> None:
    random = np.random.default_rng(2)
    points = random.normal(size=(40, 3))
    triangles = np.array([random.choice(40, 3, replace=False) for _ in range(45)], dtype=np.int32)
    assert set(crossing_triangles(points, triangles).tolist()) == by_planes(points, triangles)


@pytest.mark.parametrize("target", [ball(), box(), torus()])
def test_sound_bodies_do_not_cross_themselves(target: Target) -> None:
    assert not len(crossing_triangles(target.points, target.triangles))


def test_two_balls_cross_in_a_circle() -> None:
    body = ball()
    shift = np.array([1.0, 0.13, 0.07])
    points = np.concatenate([body.points, body.points + shift])
    triangles = np.concatenate([body.triangles, body.triangles + len(body.points)])
    crossed = points[triangles[crossing_triangles(points, triangles)]].mean(axis=1)
    off = (crossed - 0.5 * shift) @ shift / np.linalg.norm(shift)
    assert np.abs(off).max() < 0.1
    around = np.linalg.norm(crossed - 0.5 * shift, axis=1)
    np.testing.assert_allclose(around, np.sqrt(1.0 - 0.25 * shift @ shift), atol=0.1)


def test_a_thorn_through_the_other_side_is_cut_out() -> None:
    body = ball()
    points = 100.0 * body.points
    points[300] *= -1.5
    target = target_of(RawMesh(points, body.triangles), "ball")
    assert any("cut out" in note for note in target.notes)
    assert target.volume == pytest.approx(1e-3 * body.volume, rel=0.02)
    assert not len(crossing_triangles(target.points, target.triangles))


def test_a_surface_that_crosses_itself_everywhere_is_told_with_a_place() -> None:
    body = ball()
    noise = np.random.default_rng(1).normal(size=body.points.shape)
    target = target_of(RawMesh(100.0 * body.points + 8.0 * noise, body.triangles), "ball")
    told = [note for note in target.notes if "crosses itself" in note]
    assert len(told) == 1
    assert "Film cannot follow" in told[0]

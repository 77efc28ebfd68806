# SPDX-License-Identifier: LGPL-2.1-or-later
"""Divided bodies: so many panels, each a disc, on the same surface, symmetric where the body is."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from solids import ball, box, capsule, pear, rounded_box, torus

from BalloonWorkbench.core.geometry.vectors import rotation, unit
from BalloonWorkbench.core.memoize import forget
from BalloonWorkbench.core.segmentation.divide import divide
from BalloonWorkbench.core.targets.nearest_surface import NearestSurface
from BalloonWorkbench.core.targets.read_target import read_target
from BalloonWorkbench.core.targets.target import Division, Target

MESHES = Path(__file__).parents[2] / "resources" / "meshes"


def spot() -> Target:
    return read_target(MESHES / "spot.obj", width=0.3)


def brick() -> Target:
    return box((1.0, 2.0, 3.0))


def fish() -> Target:
    return read_target(MESHES / "fish.obj", width=0.3)


@cache
def divided(body: Callable[[], Target], count: int) -> Division:
    """What several tests look at."""
    return divide(body(), count)


def euler(made: Division) -> list[int]:
    """Vertices - edges + triangles of each panel as it is cut open: 1 for a disc."""
    opened = made.opened
    edges = np.where(made.seam_edges, 1.0, 0.5)
    count = np.bincount(opened.panels) + np.bincount(made.panels)
    return np.rint(count - np.bincount(np.repeat(made.panels, 3), edges)).astype(int).tolist()


def areas(made: Division) -> np.ndarray:
    return np.bincount(made.panels, made.target.areas) / made.target.areas.sum()


@pytest.mark.slow
@pytest.mark.parametrize(
    ("body", "count", "away"),
    [
        (spot, 16, 5e-3),
        (spot, 17, 5e-3),
        (spot, 60, 5e-3),
        (fish, 24, 5e-3),
        (ball, 2, 0.0),
        (ball, 7, 0.0),
        (torus, 9, 0.0),
        (rounded_box, 24, 1e-4),
        (brick, 9, 0.0),
    ],
)
def test_as_many_discs_as_wanted_on_the_same_surface(
    body: Callable[[], Target], count: int, away: float
) -> None:
    made, target = divided(body, count), body()
    assert len(made.names) == len(set(made.names)) == count
    assert euler(made) == [1] * count
    assert (made.target.twins >= 0).all()
    assert made.target.volume == pytest.approx(target.volume, rel=1e-2 if away else 1e-9)
    assert made.target.areas.min() > 0.0
    off = NearestSurface(target.points, target.triangles).query(made.target.points).distances
    assert np.abs(off).mean() <= away * target.diagonal + 1e-12
    assert areas(made).min() > 0.1 / count


def test_the_faces_of_a_box_are_its_panels() -> None:
    made = divided(brick, 6)
    normals = unit(made.target.area_vectors)
    assert all(np.ptp(normals[made.panels == panel], axis=0).max() < 1e-9 for panel in range(6))


@pytest.mark.parametrize(("target", "count"), [(ball(), 12), (capsule(), 8), (pear(), 5)])
def test_bodies_of_revolution_are_made_of_equal_gores(target: Target, count: int) -> None:
    made = divide(target, count)
    assert len(made.seams) == count
    assert len(made.nodes) == 2
    np.testing.assert_allclose(areas(made), 1.0 / count, rtol=0.02)


def test_a_ring_is_made_of_strips_round_it() -> None:
    """Strips between equal angles of the tube: (angle, sine) of its section give their areas."""
    made = divide(torus(), 8)
    limits = np.pi * (2.0 * np.arange(9) - 1.0) / 8.0
    expected = np.diff(limits + 0.4 * np.sin(limits)) / (2.0 * np.pi)
    np.testing.assert_allclose(np.sort(areas(made)), np.sort(expected), rtol=0.03)


@pytest.mark.parametrize(("body", "count"), [(spot, 16), (fish, 16)])
def test_panels_of_a_symmetric_body_are_mirror_images(body: Callable[[], Target], count: int) -> None:
    made = divided(body, count)
    centres = made.target.points[made.target.triangles].mean(axis=1)
    sums = np.stack([np.bincount(made.panels, centres[:, k] * made.target.areas) for k in range(3)], axis=1)
    middles = np.column_stack([sums / areas(made)[:, None] / made.target.areas.sum(), areas(made)])
    plane = 0.5 * (centres[:, 0].max() + centres[:, 0].min())
    image = middles * (-1.0, 1.0, 1.0, 1.0) + (2.0 * plane, 0.0, 0.0, 0.0)
    apart = np.linalg.norm(middles[:, None] - image[None], axis=2).min(axis=1)
    assert apart.max() < 1e-9


def test_the_same_body_gives_the_same_panels() -> None:
    first = divided(spot, 12)
    forget()
    second = divide(spot(), 12)
    assert first.panels.tobytes() == second.panels.tobytes()
    assert first.target.points.tobytes() == second.target.points.tobytes()


def test_the_unit_does_not_matter() -> None:
    body = spot()
    large = Target(1000.0 * body.points, body.triangles)
    assert divide(large, 12).panels.tobytes() == divided(spot, 12).panels.tobytes()


@pytest.mark.slow
def test_a_body_whose_halves_differ_is_told() -> None:
    """A pinch on one side, small enough for a mirror plane."""
    target = ball((1.0, 0.7, 0.5), 24)
    points = target.points.copy()
    pinched = np.argmax(points[:, 0] + 0.3 * points[:, 1])
    points[pinched] *= 1.0 - 0.015
    notes = divide(Target(points, target.triangles), 6).target.notes
    alike = [note for note in notes if "made alike" in note]
    assert len(alike) == 1
    assert not [note for note in divide(target, 6).target.notes if "made alike" in note]


@pytest.mark.parametrize("count", [6, 8, 9])
def test_gores_meet_in_one_point_where_the_mesh_has_none(count: int) -> None:
    """The axis goes through triangles somewhere, as through the flat ends of a turned solid."""
    target = ball()
    turn = np.eye(3)
    turn[1:, 1:] = rotation(0.0042)
    made = divide(Target(target.points @ turn * (1.0, 1.0, 1.5), target.triangles), count)
    assert len(made.seams) == count
    assert len(made.nodes) == 2

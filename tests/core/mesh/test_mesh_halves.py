# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes of symmetric outlines: both halves are images of each other."""

from __future__ import annotations

import numpy as np
import pytest
from drawn_shapes import NAMED, corners_of, hole, letter, star

from BalloonWorkbench.core.geometry.polyline import signed_area
from BalloonWorkbench.core.geometry.triangulation import signed_areas
from BalloonWorkbench.core.mesh.halves import triangulate_mirrored
from BalloonWorkbench.core.mesh.quality import min_angles
from BalloonWorkbench.core.mesh.relax import chord_middles
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.outline.symmetry import exact_mirror, mirrored
from BalloonWorkbench.core.panels.panel import Panel

_TURN = np.array([[np.cos(0.4), -np.sin(0.4)], [np.sin(0.4), np.cos(0.4)]])
SHAPES = {
    "heart": NAMED["heart"],
    "star": star(5, 0.15, 0.06),
    "ring": NAMED["ring"],
    "A": letter("A"),
    "face": Outline(
        NAMED["disc"].outer, (hole(0.01, -0.04, 0.03), hole(0.012, 0.0, -0.05), hole(0.01, 0.04, 0.03))
    ),
    "T, aslant": corners_of((-5, 0), (5, 0), (5, 20), (15, 20), (15, 28), (-15, 28), (-15, 20), (-5, 20)).map(
        lambda loop: 0.01 * loop @ _TURN.T
    ),
}


def halves(outline: Outline, size: float = 0.01) -> tuple[Outline, Panel, np.ndarray]:
    """The outline made exactly symmetric, its mesh, and the image (n,) of each vertex."""
    mirror = exact_mirror(outline)
    assert mirror is not None
    even = mirrored(outline, mirror)
    panel = triangulate_mirrored(even, size, mirror)
    assert panel is not None
    points = panel.rest_positions
    away = np.linalg.norm(mirror.reflect(points)[:, None] - points, axis=2)
    assert away.min(axis=1).max() < 1e-12
    return even, panel, away.argmin(axis=1)


@pytest.mark.parametrize("name", SHAPES)
def test_both_halves_are_images(name: str) -> None:
    even, panel, image = halves(SHAPES[name])
    np.testing.assert_array_equal(image[image], np.arange(len(image)))
    triangles = {frozenset(triangle) for triangle in panel.triangles.tolist()}
    assert {frozenset(triangle) for triangle in image[panel.triangles].tolist()} == triangles
    areas = signed_areas(panel.rest_positions, panel.triangles)
    assert areas.min() > 0.0
    loops = [panel.rest_positions[seam] for seam in panel.loops]
    assert areas.sum() == pytest.approx(sum(map(signed_area, loops)), rel=1e-12)
    assert np.unique(panel.triangles).tolist() == list(range(len(image)))
    for loop, drawn in zip(loops, even.loops, strict=True):  # in the order and sense of the outline
        assert signed_area(loop) == pytest.approx(signed_area(drawn), rel=0.1)
        assert np.linalg.norm(loop.mean(axis=0) - drawn.mean(axis=0)) < 0.03


@pytest.mark.parametrize("name", SHAPES)
def test_it_is_as_good_as_the_plain_mesh(name: str) -> None:
    even, panel, _ = halves(SHAPES[name])
    plain = triangulate(even, 0.01)
    assert len(panel.rest_positions) == pytest.approx(len(plain.rest_positions), rel=0.1)
    # a sharp tip on the axis is halved
    assert min_angles(panel).min() > 0.45 * min_angles(plain).min()
    assert np.percentile(min_angles(panel), 5) > 0.8 * np.percentile(min_angles(plain), 5)
    assert not len(chord_middles(panel.rest_positions, panel.loops, panel.triangles))


def test_none_where_it_cannot_be() -> None:
    heart = NAMED["heart"]
    mirror = exact_mirror(heart)
    assert mirror is not None
    even = mirrored(heart, mirror)
    welded = Outline(even.outer, welds=(np.array([[0.0, 0.0], [0.0, 0.02]]),))
    assert triangulate_mirrored(welded, 0.01, mirror) is None
    aside = Outline(even.outer, (hole(0.01, 0.05, 0.0),))
    assert triangulate_mirrored(aside, 0.01, mirror) is None
    assert triangulate_mirrored(even.map(lambda loop: loop + 1.0), 0.01, mirror) is None

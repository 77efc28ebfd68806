# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is corrected of panels follows its values as it says; balloons are laid over targets."""

from __future__ import annotations

import numpy as np
import pytest
from divided import octants, torus_panels
from scipy.interpolate import CubicSpline
from solids import ball

from BalloonWorkbench.core.bags.division import side_line
from BalloonWorkbench.core.bags.mesh_bag import mesh_bag
from BalloonWorkbench.core.flattening.bag_of import bag_of
from BalloonWorkbench.core.flattening.flatten import flatten
from BalloonWorkbench.core.flattening.seam_curves import knot_shapes, smooth_line
from BalloonWorkbench.core.flattening.seam_points import all_points, at_points
from BalloonWorkbench.core.geometry.polyline import length, signed_area
from BalloonWorkbench.core.target_design.mirrored_panels import MirroredPanels
from BalloonWorkbench.core.target_design.off_target import TargetSurface
from BalloonWorkbench.core.target_design.seam_unknowns import SeamUnknowns, spans_of


@pytest.mark.parametrize("count", [1, 2, 5])
def test_shapes_of_knots_are_natural_splines(count: int) -> None:
    at, knots = np.linspace(0.0, 1.0, 41), np.linspace(0.0, 1.0, count + 1)
    expected = CubicSpline(knots, np.eye(count + 1), bc_type="natural")(at)
    np.testing.assert_allclose(knot_shapes(at, count), expected, atol=1e-12)


def test_a_ragged_line_becomes_smooth_and_a_sharp_one_stays() -> None:
    x = np.linspace(0.0, 1.0, 61)
    ragged = np.column_stack([x, 0.1 * np.sin(3.0 * x) + 1e-3 * (-1.0) ** np.arange(61)])
    curve = smooth_line(ragged, 6, 60, 5e-3)
    assert np.abs(curve[:, 1] - 0.1 * np.sin(3.0 * curve[:, 0])).max() < 1.5e-3
    sharp = np.array([[0.0, 0.0], [0.5, 0.5], [1.0, 0.0]])
    assert smooth_line(sharp, 2, 64, 1e-3)[:, 1].max() > 0.49


def test_lengths_and_meshes_follow_the_values() -> None:
    division = torus_panels(2, 2)
    bag = bag_of(division, flatten(division)).bag
    unknowns = SeamUnknowns.of(bag, spans_of(bag, division.target.diagonal))
    lengths = [length(side_line(bag, seam.a, against=False)) for seam in bag.seams]
    values = np.random.default_rng(3).normal(size=unknowns.size)
    apart = []
    for step in (1e-6, -1e-6):
        moved = at_points(bag, all_points(bag) + unknowns.moves @ (step * values))
        apart.append(
            [
                length(side_line(moved, seam.a, against=False))
                - length(side_line(moved, seam.b, against=True))
                for seam in bag.seams
            ]
        )
    np.testing.assert_allclose(np.subtract(*apart) / 2e-6, 0.0, atol=1e-5 * max(lengths))
    meshed = mesh_bag(bag, 0.3)
    ahead = meshed.with_bag(at_points(bag, all_points(bag) + unknowns.moves @ values))
    moves = [
        after.rest_positions - before.rest_positions
        for after, before in zip(ahead.assembly.panels, meshed.assembly.panels)
    ]
    np.testing.assert_allclose(unknowns.rest_moves(meshed) @ values, np.concatenate(moves), atol=1e-9)


def test_moves_keep_seams_equally_long_and_as_many_as_can_be() -> None:
    division = octants()
    bag = bag_of(division, flatten(division)).bag
    spans = spans_of(bag, division.target.diagonal)
    unknowns = SeamUnknowns.of(bag, spans)
    corners = 2 * 3 * len(bag.panels)
    assert unknowns.size == corners + 2 * sum(count - 1 for count in spans) - len(bag.seams)


def test_panels_that_are_images_share_their_moves() -> None:
    """A ball in octants has the 48 symmetries of a cube: a corner and half a side are all that is free."""
    division = octants()
    body = bag_of(division, flatten(division))
    mirrored = MirroredPanels.of(body)
    assert [len(images) for images in mirrored.orbits] == [48]
    spans = spans_of(body.bag, division.target.diagonal)
    assert len(set(spans)) == 1
    bag = mirrored.alike(body.bag)
    unknowns = SeamUnknowns.of(bag, spans, mirrored)
    assert unknowns.size == 1 + spans[0] // 2
    moved = unknowns.moved(bag, np.full(unknowns.size, 0.02), mirrored)
    areas = [signed_area(panel.outer) for panel in moved.panels]
    assert np.ptp(areas) < 1e-9 * areas[0]
    assert abs(areas[0] - signed_area(body.bag.panels[0].outer)) > 1e-3 * areas[0]


def test_a_body_is_laid_over_its_target() -> None:
    target = ball((1.0, 1.5, 0.6), 12)
    angle = 0.1
    turn = np.array(
        [[np.cos(angle), -np.sin(angle), 0.0], [np.sin(angle), np.cos(angle), 0.0], [0.0, 0.0, 1.0]]
    )
    moved = target.points @ turn + (0.05, -0.02, 0.03)
    places, turned, off = TargetSurface(target).laid_over(moved, np.ones(len(moved)))
    assert np.abs(off.distances).max() < 2e-3
    np.testing.assert_allclose(places, target.points, atol=5e-3)
    np.testing.assert_allclose(turned @ turned.T, np.eye(3), atol=1e-12)

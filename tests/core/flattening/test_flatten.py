# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panels laid flat: seams equally long, exact where a panel unrolls, never folded over."""

from __future__ import annotations

import numpy as np
import pytest
from divided import box_faces, divided, drum, gored_ball, octants, torus_panels
from solids import ball, torus

from BalloonWorkbench.core.bags.check_bag import check_bag
from BalloonWorkbench.core.bags.division import side_line
from BalloonWorkbench.core.bags.mesh_bag import default_size, mesh_bag
from BalloonWorkbench.core.bags.topology import Topology
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.flattening.bag_of import FlatBody, bag_of
from BalloonWorkbench.core.flattening.flatten import flatten
from BalloonWorkbench.core.geometry.polyline import edge_lengths, length, perimeter, signed_area
from BalloonWorkbench.core.geometry.triangulation import side_lengths, signed_areas
from BalloonWorkbench.core.targets.target import Division

BODIES = {
    "gores": gored_ball,
    "octants": lambda: octants((1.0, 1.4, 0.7)),
    "cube": box_faces,
    "torus": torus_panels,
    "drum": drum,
    "halves": lambda: divided(ball(count=8), lambda at: at[:, 2] > 0.0),
}


def laid(division: Division) -> FlatBody:
    return bag_of(division, flatten(division))


@pytest.mark.parametrize("name", BODIES)
def test_both_sides_of_a_seam_are_equally_long(name: str) -> None:
    division = BODIES[name]()
    flat = np.concatenate(flatten(division))
    for seam in division.seams:
        one, other = (np.linalg.norm(np.diff(flat[side], axis=0), axis=1) for side in seam.sides)
        assert np.abs(one - other).max() < 1e-12 * one.sum()


@pytest.mark.parametrize("name", BODIES)
def test_the_bag_is_in_order_and_its_seams_are_equally_long(name: str) -> None:
    division = BODIES[name]()
    bag = laid(division).bag
    check_bag(bag, opening_needed=True)
    assert Topology(bag).euler_number == (0 if name == "torus" else 2)
    for seam in bag.seams:
        one, other = side_line(bag, seam.a, against=False), side_line(bag, seam.b, against=True)
        assert length(one) == pytest.approx(length(other), rel=1e-12)
        steps = [np.linalg.norm(np.diff(line, axis=0), axis=1) for line in (one, other)]
        np.testing.assert_allclose(steps[0], steps[1], rtol=1e-9)


@pytest.mark.parametrize("name", BODIES)
def test_no_triangle_turns_over(name: str) -> None:
    division = BODIES[name]()
    opened = division.opened
    assert (signed_areas(np.concatenate(flatten(division)), opened.triangles) > 0.0).all()


@pytest.mark.parametrize("division", [box_faces((1.0, 2.0, 0.5)), drum(), drum(upper=0.4)])
def test_what_unrolls_is_laid_flat_exactly(division: Division) -> None:
    flat = np.concatenate(flatten(division))
    triangles = division.opened.triangles
    inside = division.target.points[division.target.triangles]
    sides = np.linalg.norm(np.roll(inside, -2, axis=1) - np.roll(inside, -1, axis=1), axis=2)
    np.testing.assert_allclose(side_lengths(flat, triangles), sides, rtol=1e-9)
    np.testing.assert_allclose(signed_areas(flat, triangles), division.target.areas, rtol=1e-9)


def test_the_side_of_a_drum_is_a_rectangle() -> None:
    side, bottom, _ = laid(drum(around=64, height=1.5)).bag.panels
    around = 2.0 * 64 * np.sin(np.pi / 64)
    assert perimeter(side.outer) == pytest.approx(2.0 * (around + 1.5), rel=1e-3)
    assert signed_area(side.outer) == pytest.approx(1.5 * around, rel=2e-3)
    assert perimeter(bottom.outer) == pytest.approx(around, rel=1e-3)


def test_a_ring_keeps_its_hole() -> None:
    upper, lower = laid(divided(torus(), lambda at: at[:, 2] > 0.0)).bag.panels
    assert len(upper.holes) == len(lower.holes) == 1
    assert signed_area(upper.holes[0]) < 0.0 < signed_area(upper.outer)


def test_a_panel_without_an_edge_is_refused() -> None:
    with pytest.raises(InputError, match="'Panel 1' is the whole surface"):
        flatten(divided(ball(count=4), lambda at: np.zeros(len(at), dtype=np.int32)))


@pytest.mark.parametrize("name", BODIES)
def test_the_mesh_begins_on_the_target(name: str) -> None:
    """Vertices are laid on a surface given by formulas, as finely as its triangles are."""
    body = laid(BODIES[name]())
    meshed = mesh_bag(body.bag, default_size(body.bag, 600))
    at = body.on_target(meshed)
    assert len(at) == meshed.assembly.offsets[-1]
    off = {
        "gores": lambda p: np.linalg.norm(p, axis=1) - 1.0,
        "octants": lambda p: np.linalg.norm(p / (1.0, 1.4, 0.7), axis=1) - 1.0,
        "cube": lambda p: np.abs(p).max(axis=1) - 0.5,
        "torus": lambda p: np.hypot(np.hypot(p[:, 0], p[:, 1]) - 1.0, p[:, 2]) - 0.4,
        "drum": lambda p: np.abs(np.column_stack([np.hypot(*p.T[:2]) - 1.0, p[:, 2], p[:, 2] - 1.5])).min(
            axis=1
        ),
        "halves": lambda p: np.linalg.norm(p, axis=1) - 1.0,
    }[name]
    assert np.abs(off(at)).max() < 0.03


def test_the_edges_of_a_seam_are_even() -> None:
    bag = laid(octants()).bag
    for panel in bag.panels:
        steps = edge_lengths(panel.outer)
        assert steps.max() < 1.2 * steps.min()

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bags as meshes: vertices at equal fractions of both sides of each seam, nothing glued to a point."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace

import numpy as np
import pytest
from bag_volumes import KNOWN, box, cone

from BalloonWorkbench.core.bags.bag import Bag, BagPanel, BagSeam, Side
from BalloonWorkbench.core.bags.division import side_line
from BalloonWorkbench.core.bags.mesh_bag import MeshedBag, default_size, mesh_bag
from BalloonWorkbench.core.bags.topology import Topology
from BalloonWorkbench.core.bodies.banded import banded_bag
from BalloonWorkbench.core.bodies.joined import joined_bag, polygon
from BalloonWorkbench.core.bodies.ready import READY, ready_bag
from BalloonWorkbench.core.errors import AssemblyError, InputError, MeshError
from BalloonWorkbench.core.geometry.polyline import length
from BalloonWorkbench.core.geometry.triangulation import signed_areas
from BalloonWorkbench.core.mesh.quality import min_angles
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.types import Floats

BODIES = [*READY]


def lens(sagitta: float, points: int = 16) -> Bag:
    """Two equal panels between two arcs, which come to sharp tips."""
    across = np.linspace(0.0, 1.0, points, endpoint=False)
    lower = np.column_stack([across, -4.0 * sagitta * across * (1.0 - across)])
    outer = np.concatenate([lower, [1.0, 0.0] - lower])
    sides = [(0, points), (points, 0)]
    # the second panel is the first one's mirror image, along the line between the tips
    seams = [BagSeam(Side(0, *sides[0]), Side(1, 0, points)), BagSeam(Side(0, *sides[1]), Side(1, points, 0))]
    return Bag((BagPanel("front", outer), BagPanel("back", outer)), tuple(seams))


def fractions(meshed: MeshedBag, number: int) -> list[Floats]:
    """How far round its side, by the points of the bag, each vertex of a seam is."""
    bag, assembly, parts = meshed.bag, meshed.assembly, []
    for side, run, against in zip(bag.seams[number].sides, assembly.seams[number].runs, (False, True)):
        line = side_line(bag, side, against=against)
        steps = np.linalg.norm(np.diff(line, axis=0), axis=1)
        ends = np.concatenate([[0.0], np.cumsum(steps)])
        at = []
        for place in assembly.panels[run.panel].rest_positions[run.vertices]:
            share = np.clip(
                np.einsum("ij,ij->i", place - line[:-1], np.diff(line, axis=0)) / steps**2, 0.0, 1.0
            )
            away = np.linalg.norm(line[:-1] + share[:, None] * np.diff(line, axis=0) - place, axis=1)
            edge = int(np.argmin(np.round(away / ends[-1], 9)))
            assert away[edge] < 1e-9
            at.append(ends[edge] + share[edge] * steps[edge])
        parts.append(np.array(at) / ends[-1])
    return parts


@pytest.mark.parametrize("vertices", [150, 2000])
@pytest.mark.parametrize("name", BODIES)
def test_seams_and_triangles(name: str, vertices: int) -> None:
    bag = ready_bag(name)
    size = default_size(bag, vertices)
    meshed = mesh_bag(bag, size)
    assembly = meshed.assembly
    surface, topology = assembly.surface, Topology(bag)
    assert vertices == 150 or 0.85 * vertices < assembly.offsets[-1] < 1.25 * vertices
    assert surface.euler_number == topology.euler_number == 2
    assert surface.bodies == topology.bodies == 1
    assert not surface.turned.any()
    for number in range(len(bag.seams)):
        one, other = fractions(meshed, number)
        assert one[0] == pytest.approx(0.0, abs=1e-9)
        assert one[-1] == pytest.approx(1.0)
        np.testing.assert_allclose(one, other, atol=1e-6)
        sides = [length(side_line(bag, bag.seams[number].a, against=False))]
        assert np.diff(one).max() * sides[0] < 1.6 * size


@pytest.mark.parametrize("bag", [lens(0.05), lens(0.3), cone(12.0), box(1.0, 1.0, 0.02)])
@pytest.mark.parametrize("vertices", [30, 800])
def test_no_triangle_falls_on_another(bag: Bag, vertices: int) -> None:
    """Also in tips: each edge of the balloon has two triangles, none is a point, no two are one."""
    surface = mesh_bag(bag, default_size(bag, vertices)).assembly.surface
    triangles = np.sort(surface.by_seams[surface.triangles], axis=1)
    assert (np.diff(triangles, axis=1) > 0).all()
    assert len(np.unique(triangles, axis=0)) == len(triangles)
    edges = Counter((int(a), int(b)) for k in ((0, 1), (1, 2), (0, 2)) for a, b in triangles[:, list(k)])
    assert set(edges.values()) == {2}


def torus() -> Bag:
    """A rectangle sealed to itself all round."""
    outer = np.array([(0.0, 0.0), (3.0, 0.0), (3.0, 1.0), (0.0, 1.0)])
    seams = (BagSeam(Side(0, 0, 1), Side(0, 3, 2)), BagSeam(Side(0, 1, 2), Side(0, 0, 3)))
    return Bag((BagPanel("sheet", outer),), seams)


def pillow() -> Bag:
    """Two squares, each of two triangles: the seams along the diagonals have the same ends."""
    half = np.array([(0.0, 0.0), (1.0, 0.0), (0.5, 0.5)])
    front, back = [("01", "12", "02"), ("01", "03", "13")], [("x", "03", "13"), ("x", "12", "02")]
    names = [front[0], front[1], (back[0][0], back[0][2], back[0][1]), (back[1][0], back[1][2], back[1][1])]
    return joined_bag([(f"half {k}", polygon(half, sides)) for k, sides in enumerate(names)], "01")


@pytest.mark.parametrize(("bag", "euler_number"), [(torus(), 0), (pillow(), 2)])
def test_the_coarsest_mesh_is_a_surface(bag: Bag, euler_number: int) -> None:
    """Where both ends of a seam are one point, or two seams share both ends."""
    surface = mesh_bag(bag, 10.0).assembly.surface
    assert surface.euler_number == euler_number
    triangles = np.sort(surface.by_seams[surface.triangles], axis=1)
    assert (np.diff(triangles, axis=1) > 0).all()
    edges = Counter((int(a), int(b)) for k in ((0, 1), (1, 2), (0, 2)) for a, b in triangles[:, list(k)])
    assert set(edges.values()) == {2}


def test_edges_follow_curves_however_coarse() -> None:
    for panel in mesh_bag(ready_bag("cylinder", radius=1.0, height=1.0), 10.0).assembly.panels[1:]:
        assert len(panel.loops[0]) >= 8


@pytest.mark.parametrize("name", BODIES)
def test_vertices_follow_the_points(name: str) -> None:
    """A stretched and turned bag has stretched and turned triangles; sums of weights are one."""
    bag = ready_bag(name)
    meshed = mesh_bag(bag, default_size(bag, 400))
    change = np.array([[1.2, 0.3], [-0.1, 0.9]])

    def moved(points: Floats) -> Floats:
        return points @ change + (0.5, -0.2)

    other = replace(bag, panels=tuple(replace(panel, outer=moved(panel.outer)) for panel in bag.panels))
    moved_bag = meshed.with_bag(other)
    assert moved_bag.weights is meshed.weights  # worked out once
    again = moved_bag.assembly.panels
    for panel, follower, weights in zip(meshed.assembly.panels, again, meshed.weights):
        np.testing.assert_allclose(weights.sum(axis=1), 1.0)
        assert weights.min() > -0.05
        np.testing.assert_allclose(follower.rest_positions, moved(panel.rest_positions), atol=1e-9)
        assert follower.triangles is panel.triangles


def test_moves_of_points_are_moves_of_vertices() -> None:
    bag = ready_bag("beach-ball")
    meshed = mesh_bag(bag, default_size(bag, 400))
    rng = np.random.default_rng(1)
    moves = [1e-3 * rng.normal(size=(len(panel.outer), 2, 3)) for panel in bag.panels]
    fields = meshed.rest_moves(moves)
    for k in range(3):
        panels = [replace(panel, outer=panel.outer + move[:, :, k]) for panel, move in zip(bag.panels, moves)]
        after = meshed.with_bag(replace(bag, panels=tuple(panels))).assembly.panels
        change = [b.rest_positions - a.rest_positions for a, b in zip(meshed.assembly.panels, after)]
        np.testing.assert_allclose(fields[:, :, k], np.concatenate(change), atol=1e-12)


def test_places_in_space_are_spread_between_those_of_points() -> None:
    bag = box(1.0, 2.0, 3.0)
    meshed = mesh_bag(bag, 0.3)
    flat = [np.column_stack([panel.outer, np.full(len(panel.outer), 7.0)]) for panel in bag.panels]
    rest = np.concatenate([panel.rest_positions for panel in meshed.assembly.panels])
    np.testing.assert_allclose(meshed.places(flat), np.column_stack([rest, np.full(len(rest), 7.0)]))


def test_equal_panels_get_equal_triangles() -> None:
    one, other = mesh_bag(ready_bag("beach-ball"), 0.03).assembly.panels[:2]
    np.testing.assert_array_equal(one.triangles, other.triangles)
    np.testing.assert_array_equal(one.rest_positions, other.rest_positions)


def test_meshes_are_the_same_again() -> None:
    one, other = (mesh_bag(KNOWN["cone"].bag(), 0.1).assembly for _ in range(2))
    assert all(
        a.rest_positions.tobytes() == b.rest_positions.tobytes() for a, b in zip(one.panels, other.panels)
    )


def test_triangles_are_even() -> None:
    for panel in mesh_bag(box(1.0, 2.0, 0.3), 0.1).assembly.panels:
        assert np.degrees(min_angles(panel).min()) > 25.0
        assert signed_areas(panel.rest_positions, panel.triangles).min() > 0.0


def test_corners_of_both_sides_keep_a_vertex() -> None:
    """A square and a disc of the same rim: the disc gets vertices where the square has corners."""
    corners = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])
    turn = 2.0 * np.pi * np.arange(200) / 200
    disc = (1.0 / (50.0 * np.sin(np.pi / 200)) / 2.0) * np.column_stack([np.cos(turn), np.sin(turn)])
    seams = (BagSeam(Side(0, 0, 2), Side(1, 100, 0)), BagSeam(Side(0, 2, 0), Side(1, 0, 100)))
    meshed = mesh_bag(Bag((BagPanel("square", corners), BagPanel("disc", disc)), seams), 0.118)
    square, round_ = meshed.assembly.panels
    assert all((square.rest_positions == corner).all(axis=1).any() for corner in corners)
    for at in (50, 150):
        assert np.linalg.norm(round_.rest_positions - disc[at], axis=1).min() < 1e-9


def test_a_hole_has_seams_of_its_own() -> None:
    """A flat ring of two faces with a band outside and one inside: a ring in space."""
    outer = np.array([(0.0, 0.0), (3.0, 0.0), (3.0, 3.0), (0.0, 3.0)])
    hole = np.array([(1.0, 1.0), (1.0, 2.0), (2.0, 2.0), (2.0, 1.0)])
    bag = banded_bag(Outline(outer, (hole,)), 0.5)
    assert Topology(bag).euler_number == 0
    surface = mesh_bag(bag, 0.2).assembly.surface
    assert surface.euler_number == 0
    assert surface.bodies == 1


def test_moved_too_far_is_noticed() -> None:
    bag = box(1.0, 1.0, 1.0)
    meshed = mesh_bag(bag, 0.3)
    first, *others = bag.panels
    over = replace(first, outer=first.outer[::-1].copy())
    with pytest.raises(AssemblyError, match="clockwise"):
        meshed.with_bag(replace(bag, panels=(over, *others))).assembly.surface  # noqa: B018
    with pytest.raises(InputError, match="other points"):
        meshed.with_bag(replace(bag, panels=(replace(first, outer=first.outer[:3]), *others)))


@pytest.mark.parametrize(("size", "text"), [(0.0, "above 0"), (np.nan, "above 0"), (1e-5, "at least")])
def test_a_size_that_makes_no_sense(size: float, text: str) -> None:
    with pytest.raises(MeshError, match=text):
        mesh_bag(box(1.0, 1.0, 1.0), size)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Balloons as GLB files, read again by trimesh: closed, outward, in metres, y up, pictures in their place."""

from __future__ import annotations

import io
import json
from collections.abc import Sequence
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import trimesh
from drawn_shapes import NAMED
from hostile_texts import PLAIN, UNSHOWN
from inflated import lifted
from profiles import sphere
from scipy.spatial import cKDTree

from BalloonWorkbench.core.artwork.picture import Picture, covering
from BalloonWorkbench.core.artwork.wrap import wrapped
from BalloonWorkbench.core.bag_design.bag_design import BagDesign
from BalloonWorkbench.core.bag_design.gore_fit import inflate_gores
from BalloonWorkbench.core.bodies.check_profile import checked_profile
from BalloonWorkbench.core.bodies.profile import OPEN
from BalloonWorkbench.core.film.film import Look
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.scenes.glb import glb_bytes
from BalloonWorkbench.core.scenes.surface_mesh import (
    MOST_PIXELS,
    Finish,
    Painted,
    SurfaceMesh,
    bag_meshes,
    small_picture,
    two_panel_meshes,
)
from BalloonWorkbench.core.solver.inflation import MIRROR, Inflation

LOOK = Look("foil", "#8040ff")
WELD = 0.005
RED, BLUE, GREEN = (200, 10, 20, 255), (10, 20, 200, 255), (20, 150, 30, 255)


@cache
def heart() -> Inflation:
    return lifted(triangulate(NAMED["heart"], 0.02))


@cache
def gored() -> BagDesign:
    return inflate_gores(sphere(0.3), 6, film("mylar"), 2000.0, mesh_size=0.12)


def halves(
    left: tuple[int, ...], right: tuple[int, ...], low: Sequence[float], size: Sequence[float]
) -> Picture:
    """A picture of two colours, exactly as wide and high as a box."""
    pixels = np.full((60, 80, 4), left, np.uint8)
    pixels[:, 40:] = right
    return Picture(pixels, np.array(low, float), np.array(size) / (80, 60))


def read(content: bytes) -> trimesh.Scene:
    return trimesh.load(io.BytesIO(content), file_type="glb", process=False)


def described(content: bytes) -> dict:
    """The file's JSON."""
    return dict(json.loads(content[20 : 20 + int.from_bytes(content[12:16], "little")]))


def together(scene: trimesh.Scene) -> trimesh.Trimesh:
    """All of it as one surface, whose vertices are one where they are in one place."""
    whole = trimesh.util.concatenate(
        [trimesh.Trimesh(each.vertices, each.faces, process=False) for each in scene.geometry.values()]
    )
    whole.merge_vertices()
    return whole


def is_closed(whole: trimesh.Trimesh) -> bool:
    """Each edge is there as often in one direction as in the other; at sharp tips both films share some."""
    forth = np.sort(whole.edges[:, 0] * len(whole.vertices) + whole.edges[:, 1])
    back = np.sort(whole.edges[:, 1] * len(whole.vertices) + whole.edges[:, 0])
    return bool((forth == back).all())


def colours_at(part: trimesh.Trimesh, at: np.ndarray) -> np.ndarray:
    """Colours (k, 3) of what is printed at places of the texture, the first row of which is at 1."""
    image = np.asarray(part.visual.material.baseColorTexture.convert("RGB"))
    rows = np.clip(((1.0 - at[:, 1]) * len(image)).astype(int), 0, len(image) - 1)
    columns = np.clip((at[:, 0] * image.shape[1]).astype(int), 0, image.shape[1] - 1)
    return image[rows, columns].astype(int)


@pytest.mark.parametrize("name", ["heart", "ring"])
def test_two_panels_are_closed_with_their_weld(name: str) -> None:
    inflation = lifted(triangulate(NAMED[name], 0.025))
    content = glb_bytes("Balloon", {"Balloon": two_panel_meshes([inflation], WELD, LOOK, Painted())[0]})
    whole = together(read(content))
    assert is_closed(whole)
    assert whole.volume == pytest.approx(inflation.volume, rel=1e-5)  # m3, and positive: outward
    rim = sum(map(len, inflation.panel.loops))
    assert len(whole.faces) == 2 * len(inflation.panel.triangles) + 4 * rim
    width, height, depth = np.ptp(inflation.positions, axis=0) * (1, 1, 2)
    assert whole.extents == pytest.approx((width + 2 * WELD, height + 2 * WELD, depth), abs=0.3 * WELD)
    # upright: y of the file is that of the drawing, seen along z
    seen = whole.vertices - whole.bounds.mean(axis=0)
    middle = 0.5 * (inflation.positions[:, :2].min(axis=0) + inflation.positions[:, :2].max(axis=0))
    away, _ = cKDTree(seen).query(inflation.positions - (*middle, 0.0))
    assert away.max() < 0.5 * WELD


def test_two_simulated_panels_are_both_there() -> None:
    fat = replace(heart(), lower=heart().positions * MIRROR * (1.0, 1.0, 0.5))
    whole = together(read(glb_bytes("", {"a": two_panel_meshes([fat], WELD, LOOK, Painted())[0]})))
    assert is_closed(whole)
    assert whole.volume == pytest.approx(0.75 * heart().volume, rel=1e-5)


def test_normals_point_outward_and_have_the_length_1() -> None:
    for part in read(
        glb_bytes("", {"a": two_panel_meshes([heart()], WELD, LOOK, Painted())[0]})
    ).geometry.values():
        np.testing.assert_allclose(np.linalg.norm(part.vertex_normals, axis=1), 1.0, atol=1e-5)
        facing = np.einsum("ij,ij->i", part.face_normals, part.vertex_normals[part.faces].mean(axis=1))
        assert facing[part.area_faces > 0.0].min() > 0.0


def test_a_vertex_without_a_normal_gets_one() -> None:
    bare = Finish((1.0, 0.0, 0.0), 1.0, 0.0, 1.0)
    flat = SurfaceMesh(np.eye(3), np.array([[0, 1, 2]], np.int32), np.zeros((3, 3)), np.zeros((3, 2)), bare)
    (part,) = read(glb_bytes("", {"a": [flat]})).geometry.values()
    np.testing.assert_allclose(part.vertex_normals, np.tile([0.0, 0.0, 1.0], (3, 1)))


def test_pictures_lie_where_they_are_printed() -> None:
    """Red left and blue right on the front; green behind; also on the weld, which is a little darker."""
    low, size = heart().positions[:, :2].min(axis=0), np.ptp(heart().positions[:, :2], axis=0)
    painted = Painted(halves(RED, BLUE, low, size), halves(GREEN, GREEN, low, size))
    content = glb_bytes("", {"a": two_panel_meshes([heart()], WELD, LOOK, painted)[0]})
    parts = read(content).geometry.values()
    assert len(described(content)["images"]) == 2
    seen = set()
    for part in parts:
        front = part.vertex_normals[:, 2].mean() > 0.0
        shown = colours_at(part, part.visual.uv)
        x = part.vertices[:, 0]
        clear = np.abs(x) > 0.02 * size[0]
        wanted = np.where(x[:, None] < 0.0, RED[:3], BLUE[:3]) if front else np.tile(GREEN[:3], (len(x), 1))
        np.testing.assert_array_equal(shown[clear], wanted[clear])
        factor = part.visual.material.baseColorFactor
        seen.add((front, factor is None or bool(factor[0] > 250)))
    assert len(seen) == 4  # both sides, film and weld


def test_bare_film_has_its_colour_as_screens_show_it() -> None:
    """baseColorFactor is of light: 0x80 of 255 is 0.2159 of it (IEC 61966-2-1)."""
    look = Look("clear", "#8040ff", 0.5)
    content = glb_bytes("", {"a": two_panel_meshes([heart()], WELD, look, Painted())[0]})
    first = described(content)["materials"][0]
    assert first["pbrMetallicRoughness"]["baseColorFactor"] == pytest.approx(
        [0.2159, 0.0513, 1.0, 0.5], abs=1e-4
    )
    assert first["alphaMode"] == "BLEND"
    assert len(described(content)["materials"]) == 2


@pytest.mark.parametrize("name", [*PLAIN, *UNSHOWN, "a</script>\n"])
def test_any_name_comes_back(name: str) -> None:
    meshes = two_panel_meshes([heart(), heart()], WELD, LOOK, Painted())
    content = glb_bytes(name, {f"{name} 1": meshes[0], f"{name} 2": meshes[1]})
    assert [each["name"] for each in described(content)["nodes"]] == [
        f"{name} {k}".encode(errors="replace").decode() for k in (1, 2)
    ]
    assert len(read(content).graph.nodes_geometry) == 4


def test_the_same_gives_the_same_bytes() -> None:
    low, size = (-0.2, -0.2), (0.4, 0.4)
    one, other = (
        glb_bytes("", {"a": two_panel_meshes([heart()], WELD, LOOK, Painted(picture, picture))[0]})
        for picture in (halves(RED, BLUE, low, size), halves(RED, BLUE, low, size))
    )
    assert one == other
    assert len(described(one)["images"]) == 1  # both sides show the same


def test_gores_stand_upright_with_the_picture_round_them() -> None:
    """Closed, y up; the picture begins at a seam and goes round once: red first, then blue."""
    design = gored()
    films, low, size = wrapped(design, range(6))
    picture = halves(RED, BLUE, low, size)
    meshes = bag_meshes(design, LOOK, [(each, picture) for each in films])
    content = glb_bytes("", {"a": meshes})
    (part,) = read(content).geometry.values()
    whole = together(read(content))
    assert whole.is_watertight
    assert is_closed(whole)
    assert len(whole.faces) == sum(len(panel.triangles) for panel in design.inflation.assembly.panels)
    across, up, deep = np.ptp(design.inflation.positions, axis=0)[[0, 2, 1]]
    assert whole.extents == pytest.approx((across, up, deep), abs=1e-5)
    assert 0.9 * design.inflation.volume < whole.volume <= design.inflation.volume
    middles = part.vertices[part.faces].mean(axis=1)
    turn = np.mod(
        np.arctan2(-middles[:, 2], middles[:, 0]) + np.pi / 6, 2.0 * np.pi
    )  # -z is away from the eye
    shown = colours_at(part, part.visual.uv[part.faces].mean(axis=1))
    clear = (np.abs(turn - np.pi) > 0.1) & (turn > 0.1) & (turn < 2.0 * np.pi - 0.1)
    clear &= np.hypot(middles[:, 0], middles[:, 2]) > 0.1 * across
    wanted = np.where(turn[:, None] < np.pi, RED[:3], BLUE[:3])
    assert clear.sum() > 50
    np.testing.assert_array_equal(shown[clear], wanted[clear])
    assert not described(content)["materials"][0]["doubleSided"]


def test_an_open_end_shows_the_inner_side() -> None:
    turn = np.linspace(-0.8, 0.5 * np.pi, 40)
    profile = checked_profile(0.3 * np.column_stack([np.cos(turn), np.sin(turn)]), lower=OPEN)
    design = inflate_gores(profile, 6, film("mylar"), 500.0, mesh_size=0.15)
    content = glb_bytes("", {"a": bag_meshes(design, LOOK)})
    whole = together(read(content))
    assert not is_closed(whole)
    assert described(content)["materials"][0]["doubleSided"]


def test_a_large_picture_is_made_smaller_in_its_place() -> None:
    """2 x 2 pixels make one; what is left over at the right and below is left out, the rest stays."""
    pixels = np.zeros((1000, 1501, 4), np.uint8)
    pixels[..., 3] = 255
    pixels[300:700, 400:900, 0] = 240
    picture = covering(pixels, np.array([0.1, -0.2]), np.array([0.1501, 0.1]))
    small = small_picture(picture)
    assert max(small.pixels.shape[:2]) <= MOST_PIXELS
    point = picture.low + picture.pixel * (400.0, 1000.0 - 300.0)  # upper left corner of the red box
    column, row = (float(at) for at in small.columns_rows(point))
    assert (column, row) == pytest.approx((199.5, 149.5), abs=1e-3)
    assert small.pixels[150, 200, 0] == 240
    assert small.pixels[149, 199, 0] == 0


def test_many_vertices_have_longer_numbers() -> None:
    count = 22_000
    corners = np.random.default_rng(3).random((3 * count, 3))
    bare = Finish((0.5, 0.5, 0.5), 1.0, 0.0, 1.0)
    triangles = np.arange(3 * count, dtype=np.int32).reshape(-1, 3)
    mesh = SurfaceMesh(
        corners, triangles, np.tile([0.0, 0.0, 1.0], (3 * count, 1)), np.zeros((3 * count, 2)), bare
    )
    (part,) = read(glb_bytes("", {"a": [mesh]})).geometry.values()
    np.testing.assert_array_equal(part.faces, triangles)
    middle = 0.5 * (corners.min(axis=0) + corners.max(axis=0))
    np.testing.assert_allclose(part.vertices, corners - middle, atol=1e-7)

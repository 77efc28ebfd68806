# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes of many outlines, with the constrained Delaunay library and with its fallback."""

from __future__ import annotations

import re
import time

import numpy as np
import pytest
from drawn_shapes import NAMED, Outline, corners_of, generated, hole, oriented, polar

from BalloonWorkbench.core.errors import MeshError
from BalloonWorkbench.core.geometry.polyline import signed_area
from BalloonWorkbench.core.geometry.triangulation import signed_areas
from BalloonWorkbench.core.mesh import delaunay
from BalloonWorkbench.core.mesh.quality import delaunay_loss, interior_edges, locked, min_angles
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.panels.panel import Panel


@pytest.fixture(params=["pythoncdt", "scipy"])
def library(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> str:
    if request.param == "scipy":
        monkeypatch.setattr(delaunay, "pythoncdt", None)
    else:
        assert delaunay.pythoncdt is not None
    return request.param


def distance_to(loops: tuple[np.ndarray, ...], points: np.ndarray) -> np.ndarray:
    """Distance of points (n, 2) to closed loops."""
    a = np.concatenate(loops)[:, None]
    b = np.concatenate([np.roll(loop, -1, axis=0) for loop in loops])[:, None]
    share = ((points - a) * (b - a)).sum(axis=2) / ((b - a) ** 2).sum(axis=2)
    foot = a + share.clip(0.0, 1.0)[..., None] * (b - a)
    return np.linalg.norm(points - foot, axis=2).min(axis=0)


def keys(starts: np.ndarray, ends: np.ndarray) -> np.ndarray:
    """One sorted number per directed edge."""
    return np.sort(starts.astype(np.int64) * 1_000_000 + ends)


def tips(panel: Panel, below: float) -> np.ndarray:
    """Seam vertices whose inner angle is below so many degrees."""
    found = [np.empty((0, 2))]
    for seam in panel.loops:
        here = panel.rest_positions[seam]
        back, ahead = np.roll(here, 1, axis=0) - here, np.roll(here, -1, axis=0) - here
        cross = ahead[:, 0] * back[:, 1] - ahead[:, 1] * back[:, 0]
        angle = np.degrees(np.arctan2(cross, (ahead * back).sum(axis=1))) % 360.0
        found.append(here[angle < below])
    return np.concatenate(found)


def assert_sound(panel: Panel, outline: Outline, size: float) -> None:
    points, triangles = panel.rest_positions, panel.triangles
    areas = signed_areas(points, triangles)
    assert areas.min() > 0.0
    # The seams bound the triangles: together they fill the polygons of the seams, edge by edge.
    assert [len(panel.loops), *(np.sign(signed_area(points[seam])) for seam in panel.loops)] == [
        len(outline.loops),
        1.0,
        *(-1.0 for _ in outline.holes),
    ]
    assert areas.sum() == pytest.approx(sum(signed_area(points[seam]) for seam in panel.loops), rel=1e-9)
    starts, ends = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
    directed = keys(starts, ends)
    assert (np.diff(directed) > 0).all()
    rim = np.setdiff1d(directed, keys(ends, starts))
    seams = [keys(seam, np.roll(seam, -1)) for seam in panel.loops]
    np.testing.assert_array_equal(rim, np.sort(np.concatenate(seams)))
    edges = (len(directed) + len(rim)) // 2
    assert len(points) - edges + len(triangles) == 1 - len(outline.holes)
    np.testing.assert_array_equal(np.unique(triangles), np.arange(len(points)))
    # The seams lie on the outline and enclose its area but for the sagitta of an edge.
    seam = points[np.concatenate(panel.loops)]
    assert distance_to(outline.loops, seam).max() < 1e-12
    assert areas.sum() == pytest.approx(outline.area, rel=6e-3)
    # Quality.
    middle = points[triangles].mean(axis=1)
    sharp = tips(panel, 60.0)
    away = np.full(len(middle), np.inf)
    for tip in sharp:
        away = np.minimum(away, np.linalg.norm(middle - tip, axis=1))
    assert np.degrees(min_angles(panel)[away > 1.5 * size]).min() > 20.0
    very_sharp = {tuple(tip) for tip in tips(panel, 40.1)}
    for triangle in triangles[locked(panel)]:
        assert any(tuple(point) in very_sharp for point in points[triangle])
    assert delaunay_loss(panel) < 0.002
    # An inner edge that joins two vertices of the seam is found at the foot of a very sharp tip only.
    inner, _ = interior_edges(triangles)
    chords = inner[np.isin(inner, np.concatenate(panel.loops)).all(axis=1)]
    feet = {
        tuple(sorted(int(v) for v in t if tuple(points[v]) not in very_sharp))
        for t in triangles[locked(panel)]
    }
    assert {tuple(chord) for chord in chords.tolist()} <= feet


@pytest.mark.parametrize("name", NAMED)
@pytest.mark.parametrize("vertices", [300, 900])
def test_named_outlines(name: str, vertices: int, library: str) -> None:
    outline = NAMED[name]
    size = size_for(outline, vertices)
    panel = triangulate(outline, size)
    assert_sound(panel, outline, size)
    assert 0.85 * vertices < len(panel.rest_positions) < 2.2 * vertices


@pytest.mark.parametrize("seed", range(40))
def test_generated_outlines(seed: int, library: str) -> None:
    outline = generated(seed)
    size = size_for(outline, 500)
    assert_sound(triangulate(outline, size), outline, size)


def test_both_libraries_mesh_alike(monkeypatch: pytest.MonkeyPatch) -> None:
    first = triangulate(NAMED["holes"], 0.008)
    monkeypatch.setattr(delaunay, "pythoncdt", None)
    second = triangulate(NAMED["holes"], 0.008)
    np.testing.assert_allclose(first.rest_positions, second.rest_positions, rtol=0.0, atol=1e-6)
    assert len(first.triangles) == len(second.triangles)


def test_same_input_same_mesh() -> None:
    first, second = (triangulate(NAMED["holes"], 0.008) for _ in range(2))
    assert first.rest_positions.tobytes() == second.rest_positions.tobytes()
    assert first.triangles.tobytes() == second.triangles.tobytes()


@pytest.mark.parametrize("name", ["disc", "square", "ring", "L", "star"])
def test_seams_are_evenly_spaced_in_loop_order(name: str) -> None:
    size = size_for(NAMED[name], 1000)
    panel = triangulate(NAMED[name], size)
    for number, seam in enumerate(panel.loops):
        here = panel.rest_positions[seam]
        steps = np.linalg.norm(np.roll(here, -1, axis=0) - here, axis=1)
        assert steps.max() < 1.25 * steps.min()
        wanted = size if number == 0 else 0.25 * size  # the rim of a hole is finer
        assert np.abs(steps / wanted - 1.0).max() < 0.2


@pytest.mark.parametrize("name", ["square", "star", "L", "wedge", "spiky"])
def test_corners_are_seam_vertices(name: str) -> None:
    panel = triangulate(NAMED[name], size_for(NAMED[name], 600))
    seam = panel.rest_positions[panel.loops[0]]
    for corner in NAMED[name].outer:
        assert np.linalg.norm(seam - corner, axis=1).min() < 1e-12


def test_square_corner_is_halved() -> None:
    """The two triangles in a right angle share an edge to the interior: neither is locked."""
    panel = triangulate(NAMED["square"], 0.02)
    assert not locked(panel).any()


def test_thin_neck_gets_small_elements_and_the_rest_stays_coarse() -> None:
    outline, size = NAMED["neck"], 0.006
    panel = triangulate(outline, size)
    x = panel.rest_positions[panel.triangles].mean(axis=1)[:, 0]
    edges = np.sqrt(signed_areas(panel.rest_positions, panel.triangles) * 4.0 / np.sqrt(3.0))
    middle, side = edges[np.abs(x) < 0.01].mean(), edges[np.abs(x) > 0.1].mean()
    assert 0.0015 < middle < 0.0028  # 8 mm thick: four elements would be 2 mm
    assert 0.8 * size < side < 1.15 * size


def test_too_thin_names_the_place_and_a_size_that_works() -> None:
    bars = [(0.0, 0.0), (0.1, 0.0), (0.1, 0.049), (0.2, 0.049), (0.2, 0.0), (0.3, 0.0)]
    outline = corners_of(*bars, (0.3, 0.1), (0.2, 0.1), (0.2, 0.051), (0.1, 0.051), (0.1, 0.1), (0.0, 0.1))
    with pytest.raises(MeshError) as caught:
        triangulate(outline, 0.01)
    text = str(caught.value)
    thick, x, y, size, advised = (float(number) for number in re.findall(r"\d+\.?\d*", text))
    assert (thick, size) == (2.0, 10.0)
    assert 100.0 <= x <= 200.0
    assert y == pytest.approx(49.0, abs=0.2) or y == pytest.approx(51.0, abs=0.2)
    assert_sound(triangulate(outline, 1e-3 * advised), outline, 1e-3 * advised)
    triangulate(outline, size_for(outline, 2500))


def test_narrow_slit_is_no_thin_part() -> None:
    """Two arms 0.2 mm apart that bend together: the gap is outside, and the seams must not cross."""
    arm = np.linspace(0.0, 1.2, 400)
    gap = 1e-4
    # Round the outside, back along the inside, and in between into the slit, which is open at angle 0.
    way = [
        polar(0.15, arm * 1.2),
        polar(0.05, arm[::-1] * 1.2),
        polar(0.1 - gap, arm),
        polar(0.1 + gap, arm[::-1]),
    ]
    outline = Outline(oriented(np.concatenate(way)))
    panel = triangulate(outline, 0.01)
    assert_sound(panel, outline, 0.01)
    seam = panel.rest_positions[panel.loops[0]]
    in_slit = np.abs(np.linalg.norm(seam, axis=1) - 0.1) < 2.0 * gap
    assert in_slit.sum() > 20


def test_tiny_hole_keeps_its_shape() -> None:
    outline = Outline(polar(0.15), (hole(0.002, 0.03, 0.01),))
    panel = triangulate(outline, 0.012)
    assert len(panel.loops[1]) >= 8
    assert np.degrees(min_angles(panel)).min() > 20.0


@pytest.mark.parametrize("size", [0.0, -0.01, np.nan, np.inf, 1.0, 1e-6])
def test_senseless_sizes(size: float) -> None:
    with pytest.raises(MeshError, match=r"mesh"):
        triangulate(NAMED["disc"], size)


def test_crossing_outline(library: str) -> None:
    eight = corners_of((0.0, 0.0), (0.2, 0.2), (0.2, 0.0), (0.0, 0.21))
    with pytest.raises(MeshError):
        triangulate(eight, 0.01)


def test_ten_thousand_vertices_in_a_moment() -> None:
    size = size_for(NAMED["disc"], 10_000)
    triangulate(NAMED["disc"], 0.02)
    start = time.process_time()
    triangulate(NAMED["disc"], size)
    assert time.process_time() - start < 2.0  # 0.3 s on an idle machine

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Welds inside a balloon: held flat, folded sharply, and the volume that is left beside them."""

from __future__ import annotations

from dataclasses import astuple, replace

import numpy as np
import pytest
import shapely
from drawn_shapes import corners_of, hole, polar

from BalloonWorkbench.core.correction.fit import fit
from BalloonWorkbench.core.errors import OutlineError
from BalloonWorkbench.core.film.library import custom_film, film
from BalloonWorkbench.core.geometry.triangulation import signed_areas
from BalloonWorkbench.core.mesh import delaunay
from BalloonWorkbench.core.mesh.quality import min_angles
from BalloonWorkbench.core.mesh.reuse import move_rim
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.outline.validity import check
from BalloonWorkbench.core.outline.welds import spot
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.pattern.build import build_pattern
from BalloonWorkbench.core.pattern.pattern import Role
from BalloonWorkbench.core.results.stl import balloon_mesh, enclosed_volume
from BalloonWorkbench.core.solver.backend import backend_named
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.model import Model, film_problem
from BalloonWorkbench.core.solver.split_along_welds import split_along_welds
from BalloonWorkbench.core.solver.start import vertex_normals

# stiff enough to be inextensible: E t / (p L) is about 7 000
STIFF = replace(custom_film(2.4e10, 0.3, 25e-6), seal_width=0.0)
RECTANGLE = corners_of((0.0, 0.0), (0.3, 0.0), (0.3, 0.2), (0.0, 0.2)).outer
BEND = np.column_stack([0.09 * np.cos(np.linspace(1.7, 4.5, 40)), 0.09 * np.sin(np.linspace(1.7, 4.5, 40))])

DISC = Outline(polar(0.15))
WELDED = replace(DISC, welds=(np.array([[-0.09, 0.0], [0.09, 0.0]]),))
HALVES = Outline(RECTANGLE, welds=(np.array([[0.0, 0.1], [0.14, 0.1]]), np.array([[0.16, 0.1], [0.3, 0.1]])))
ANGLE = np.array([[-0.05, -0.02], [-0.02, -0.02], [-0.02, 0.04]])
WINDING = Outline(polar(0.15), (hole(0.04, 0.06, 0.0),), welds=(BEND, ANGLE))


def meshed(outline: Outline, size: float = 0.012) -> Panel:
    return triangulate(check(outline), size)


def edges(triangles: np.ndarray) -> set[tuple[int, int]]:
    pairs = np.sort(triangles[:, [1, 2, 2, 0, 0, 1]].reshape(-1, 2), axis=1)
    return set(map(tuple, pairs.tolist()))


@pytest.mark.parametrize("package", ["pythoncdt", "scipy"])
@pytest.mark.parametrize("outline", [WELDED, HALVES, WINDING], ids=["disc", "halves", "winding"])
def test_welds_are_edges_of_the_mesh(outline: Outline, package: str, monkeypatch: pytest.MonkeyPatch) -> None:
    if package == "scipy":
        monkeypatch.setattr(delaunay, "pythoncdt", None)
    panel = meshed(outline)
    assert len(panel.welds) == len(outline.welds)
    present = edges(panel.triangles)
    for line, drawn in zip(panel.welds, outline.welds, strict=True):
        assert {tuple(sorted(pair)) for pair in zip(line[:-1].tolist(), line[1:].tolist())} <= present
        points = shapely.points(panel.rest_positions[line])
        assert shapely.distance(points, shapely.LineString(drawn)).max() < 2e-4
    assert signed_areas(panel.rest_positions, panel.triangles).sum() == pytest.approx(outline.area, rel=2e-3)
    assert np.degrees(min_angles(panel).min()) > 20.0
    # no edge but its own joins two vertices of the seams and welds, or it would pinch the balloon
    sealed = set(panel.sealed.tolist())
    chains = [*(np.append(seam, seam[0]) for seam in panel.loops), *panel.welds]
    own = {tuple(sorted(pair)) for chain in chains for pair in zip(chain[:-1].tolist(), chain[1:].tolist())}
    chords = [pair for pair in present - own if sealed.issuperset(pair)]
    assert len(chords) <= 8  # at the tips where a weld meets the rim


def test_an_end_at_the_rim_is_a_vertex_of_the_rim() -> None:
    panel = meshed(HALVES)
    for line, end in zip(panel.welds, (0, -1), strict=True):
        assert line[end] in panel.loops[0]
        assert line[-1 - end] not in panel.loops[0]


def test_moved_welds_keep_the_mesh() -> None:
    panel = meshed(WINDING)
    grow = 1.1 * panel.rest_positions
    moved = move_rim(panel, [grow[seam] for seam in panel.loops], [grow[weld] for weld in panel.welds])
    assert moved is not None
    assert moved.welds is panel.welds
    np.testing.assert_allclose(moved.rest_positions, grow, atol=1e-12)


def test_slit_panel_has_two_sides() -> None:
    panel = meshed(HALVES)
    flat, origin = split_along_welds(panel)
    doubled = origin[len(panel.rest_positions) :]
    inner = np.concatenate([panel.welds[0][:-1], panel.welds[1][1:]])  # all but the free ends
    assert sorted(doubled.tolist()) == sorted(inner.tolist())
    np.testing.assert_array_equal(origin[flat.triangles], panel.triangles)
    middle = flat.rest_positions[flat.triangles].mean(axis=1)[:, 1]
    for line, right in zip(flat.welds[::2], flat.welds[1::2], strict=True):
        for vertex, copy in zip(line, right):
            if vertex != copy:
                assert (middle[(flat.triangles == vertex).any(axis=1)] > 0.1).all()
                assert (middle[(flat.triangles == copy).any(axis=1)] < 0.1).all()


def test_a_weld_from_rim_to_rim_parts_the_film() -> None:
    """No edge leads from the triangles above it to those below but its own."""
    panel = meshed(replace(DISC, welds=(np.array([[-0.1375, 0.06], [0.1375, 0.06]]),)))
    (wall,) = panel.welds
    assert {int(wall[0]), int(wall[-1])} <= set(panel.loops[0].tolist())
    above = panel.rest_positions[panel.triangles].mean(axis=1)[:, 1] > 0.06
    shared = edges(panel.triangles[above]) & edges(panel.triangles[~above])
    assert shared == {tuple(sorted(pair)) for pair in zip(wall[:-1].tolist(), wall[1:].tolist())}


@pytest.mark.parametrize(
    ("weld", "message"),
    [
        ([[0.0, 0.0], [0.2, 0.0]], r"leaves the film at \(200, 0\)"),
        ([[0.06, -0.1], [0.06, 0.1]], "meets the outline"),
        ([[0.06, 0.0], [0.1, 0.1]], "leaves the film"),
        ([[-0.1, 0.0], [0.0, 0.0], [-0.05, 0.05], [-0.05, -0.05]], "itself"),
        ([[0.0, 0.0], [0.0, 0.0]], "no length"),
        ([[0.0, 0.0], [0.0, np.nan]], "not a number"),
    ],
)
def test_welds_that_make_no_sense(weld: list[list[float]], message: str) -> None:
    with pytest.raises(OutlineError, match=message):
        check(Outline(polar(0.15), (hole(0.03, 0.06, 0.0),), welds=(np.array(weld),)))


@pytest.fixture(scope="module")
def welded() -> Inflation:
    return inflate(meshed(WELDED), film("mylar"), 2000.0, backend="native")


def test_both_solvers_agree_about_a_weld(welded: Inflation) -> None:
    other = inflate(welded.panel, film("mylar"), 2000.0, backend="numpy")
    assert other.volume == pytest.approx(welded.volume, rel=1e-8)
    np.testing.assert_allclose(other.positions, welded.positions, atol=1e-7)


def test_both_solvers_have_the_same_energy_of_a_weld(welded: Inflation) -> None:
    flat, origin = split_along_welds(welded.panel)
    problem = film_problem(welded.panel, film("mylar"), 2000.0)
    size = float(np.ptp(flat.rest_positions, axis=0).max())
    noise = np.random.default_rng(5).normal(0.0, 1e-3, (len(welded.positions), 3))
    positions = ((welded.positions + noise) / size)[origin]
    directors = vertex_normals(positions, flat)
    one, two = (backend_named(name).energies(problem, positions, directors) for name in ("native", "numpy"))
    assert astuple(one) == pytest.approx(astuple(two), rel=1e-9)
    assert one.seam > 0.0


def test_a_weld_stays_flat_and_takes_volume(welded: Inflation) -> None:
    (line,) = welded.panel.welds
    assert welded.report.converged
    assert (welded.positions[line, 2] == 0.0).all()
    assert (
        welded.positions[np.setdiff1d(np.arange(len(welded.positions)), welded.panel.sealed), 2] > 0.0
    ).all()
    free = inflate(meshed(DISC), film("mylar"), 2000.0)
    assert 0.5 * free.volume < welded.volume < 0.7 * free.volume
    # the film folds: beside the line its slope is steep on both sides
    beside = np.abs(welded.panel.rest_positions[:, 1]) < 0.014
    middle = np.abs(welded.panel.rest_positions[:, 0]) < 0.06
    steep = welded.positions[beside & middle & (welded.positions[:, 2] > 0.0), 2]
    assert steep.min() > 0.01


def test_a_weld_leaves_the_balloon_symmetric(welded: Inflation) -> None:
    """In its air, whose centre is that of the disc; single vertices of the rim lie in crumples."""
    corners = welded.positions[welded.panel.triangles]
    volumes = signed_areas(welded.positions[:, :2], welded.panel.triangles) * corners[:, :, 2].mean(axis=1)
    centre = volumes @ corners[:, :, :2].mean(axis=1) / volumes.sum()
    assert np.abs(centre).max() < 5e-4 * 0.15
    upper = welded.positions[:, 1] > 0.0
    heights = [welded.positions[side, 2].max() for side in (upper, ~upper)]
    assert heights[0] == pytest.approx(heights[1], rel=0.01)


def test_both_panels_agree_with_the_mirrored_one(welded: Inflation) -> None:
    both = inflate(welded.panel, film("mylar"), 2000.0, model=Model(two_panels=True, twist=0.0), start=welded)
    assert both.volume == pytest.approx(welded.volume, rel=2e-3)
    (line,) = welded.panel.welds
    np.testing.assert_allclose(both.lower[line], both.positions[line], atol=1e-12)


def test_a_welded_rectangle_is_two_of_half_the_width() -> None:
    """Two rectangles 1 x 3: V = 0.8358 of the cube of the short side; the gap for the air changes little."""
    whole = inflate(meshed(HALVES), STIFF, 300.0)
    assert whole.report.converged
    assert whole.volume == pytest.approx(2.0 * 0.8358 * 0.1**3, rel=0.015)


def ring_volume(inner: float) -> float:
    """Volume of two annuli inner < r < 1 sealed on both rims: the planar ring by quadrature.

    r^2 = r0^2 + D sin(theta), with the crown r0 and D such that the film has its width and both rims lie in
    one plane.
    """
    from scipy.integrate import quad
    from scipy.optimize import brentq

    def integral(crown: float, spread: float, weight) -> float:
        def along(theta: float) -> float:
            radius = np.sqrt(crown**2 + spread * np.sin(theta))
            return float(weight(theta, radius) * spread / (2.0 * radius))

        start = np.arcsin(max((inner**2 - crown**2) / spread, -1.0))
        return float(quad(along, start, np.pi / 2)[0])

    def spread_of(crown: float) -> float:
        least = crown**2 - inner**2
        return brentq(lambda d: integral(crown, d, lambda t, r: np.sin(t)), least * (1 + 1e-9), 50.0 * least)

    crown = brentq(lambda c: integral(c, spread_of(c), lambda t, r: 1.0) - (1.0 - inner), inner + 1e-3, 0.85)
    return 2.0 * np.pi * integral(crown, spread_of(crown), lambda t, r: r**2 * np.sin(t))


def test_ring_quadrature_gives_the_published_ring() -> None:
    assert ring_volume(0.5) == pytest.approx(0.3359562, rel=1e-5)


def test_a_spot_weld_in_a_disc_makes_a_ring() -> None:
    """Where the spot is, the film is as flat and as round as at the inner rim of a ring."""
    radius = 0.15
    tufted = replace(DISC, spots=(spot(np.zeros(2), 0.3 * radius),))
    balloon = inflate(meshed(tufted, 0.01), replace(STIFF, seal_width=0.02), 300.0)
    assert balloon.report.converged
    assert balloon.volume == pytest.approx(ring_volume(0.15) * radius**3, rel=0.015)


@pytest.fixture(scope="module")
def designed():
    faced = replace(
        WELDED,
        welds=(np.array([[-0.15, 0.0], [-0.05, 0.0]]), np.array([[0.0, 0.03], [0.0, 0.09]])),
        spots=(spot(np.array([0.06, -0.05]), 0.014),),
    )
    return fit(faced, film("mylar"), 2000.0, mesh_size=0.014)


def test_welds_appear_where_they_are_drawn(designed) -> None:
    assert designed.residual.mean < 0.005 * 0.3
    positions, rim = designed.inflation.positions[:, :2], designed.inflation.panel.loops[0]
    for line, drawn in zip(designed.inflation.panel.welds, designed.target.welds, strict=True):
        away = shapely.distance(shapely.points(positions[line]), shapely.LineString(drawn)) / 0.3
        assert away[~np.isin(line, rim)].max() < 0.004
        # a weld's end at the rim is a point of the rim: it slides along it, and the film sticks out there
        assert away.max() < 0.011
    ends = positions[designed.inflation.panel.welds[1][[0, -1]]]
    assert np.linalg.norm(ends - designed.target.welds[1][[0, -1]], axis=1).max() < 0.003 * 0.3
    assert designed.inflation.panel.welds[0][0] in designed.inflation.panel.loops[0]


def test_the_pattern_has_the_welds_on_their_own_layer(designed) -> None:
    pattern = build_pattern(designed.pattern, 0.005)
    welds = pattern.of(Role.WELD)
    assert [weld.closed for weld in welds] == [False, False, True]
    assert not pattern.of(Role.CUT_INNER)
    film_area = shapely.Polygon(designed.pattern.outer).buffer(0.0026)  # as far as the weld round it
    for weld in welds:
        assert film_area.contains(shapely.LineString(weld.points))
    # longer than drawn: the film draws in
    assert shapely.LineString(welds[1].points).length > 0.06


def test_the_mesh_of_a_welded_balloon_is_closed(designed) -> None:
    positions, triangles = balloon_mesh(designed.inflation)
    _, counts = np.unique(
        np.sort(triangles[:, [1, 2, 2, 0, 0, 1]].reshape(-1, 2), axis=1), axis=0, return_counts=True
    )
    assert set(counts.tolist()) == {2}
    assert enclosed_volume(positions, triangles) == pytest.approx(designed.inflation.volume, rel=0.02)


@pytest.mark.parametrize("size", [0.004, 0.0065, 0.009, 0.0117, 0.014, 0.02])
@pytest.mark.parametrize("gap", [0.0, 0.0004, 0.0012, 0.0017])
def test_a_weld_that_reaches_the_rim_does_so_on_every_mesh(size: float, gap: float) -> None:
    """An end stays a hair away from the rim, so that lines do not cross; film between them would slip."""
    line = np.array([[gap - 0.15, 0.0], [-0.05, 0.0]])
    panel = triangulate(replace(DISC, welds=(line,)), size)
    assert panel.welds[0][0] in panel.loops[0]
    assert panel.welds[0][-1] not in panel.loops[0]

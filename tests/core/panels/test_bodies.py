# SPDX-License-Identifier: LGPL-2.1-or-later
"""Balloons of many panels against closed forms and against another program.

Film without bending and without a sealed band. The volume between the facets errs with the square of their
size; two meshes, one twice as fine, give it without that error.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import bodies
import numpy as np
import pytest
from solver_cases import PRESSURE, film, needs_native, panel

from BalloonWorkbench.core.errors import AssemblyError
from BalloonWorkbench.core.panels.assembly import Assembly
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.panels.seam import Run, Seam
from BalloonWorkbench.core.results.film_state import film_state
from BalloonWorkbench.core.solver.element.kinematics import facet_volume
from BalloonWorkbench.core.solver.equilibrium import newton
from BalloonWorkbench.core.solver.inflate import _laid_over, inflate
from BalloonWorkbench.core.solver.inflation import MIRROR, Inflation
from BalloonWorkbench.core.solver.model import Model, film_problem
from BalloonWorkbench.core.solver.native import c_interface
from BalloonWorkbench.core.solver.problem import Equilibrium, NewtonSettings
from BalloonWorkbench.core.solver.split_along_welds import split_assembly
from BalloonWorkbench.core.solver.start import start_of, vertex_normals

BARE = Model(bending=False)
EXACT = NewtonSettings(1e-7)
A = 1.3110287771  # of the Mylar balloon


def blown(assembly: Assembly, k: float = 1000.0, backend: str | None = None) -> Inflation:
    result = inflate(assembly, film(k), PRESSURE, backend=backend, model=BARE, settings=EXACT)
    assert result.report.converged
    return result


def between_facets(result: Inflation) -> float:
    return facet_volume(result.positions, result.assembly.surface.triangles)


def refined(make: Callable[[int], Assembly], coarse: int, k: float, backend: str) -> float:
    """The volume of a body between ever smaller facets."""
    once, twice = (between_facets(blown(make(n), k, backend)) for n in (coarse, 2 * coarse))
    return twice + (twice - once) / 3.0


def cube(cells: int) -> Assembly:
    return bodies.box(1.0, 1.0, 1.0, cells)


def drum_volume(height: float) -> float:
    """Of two discs of radius 1 and a band between them, from a film that cannot stretch."""
    if height >= 2.0 * (A - 1.0):
        return np.pi * (height - 2.0 * (A - 1.0)) + 2.0 * np.pi / 3.0 * A
    return 2.0 * np.pi / 3.0 * A * ((1.0 + 0.5 * height) / A) ** 3


@pytest.mark.parametrize(
    ("make", "coarse", "k", "volume", "backend"),
    [
        (cube, 4, 1e3, 1.2629, "native"),
        (cube, 4, 1e4, 1.2608, "native"),
        (bodies.tetrahedron, 6, 1e4, 0.17296, "native"),
        (bodies.octahedron, 3, 1e4, 0.5398, "native"),
        (bodies.octahedron, 3, 1e4, 0.5398, "numpy"),
    ],
    ids=["cube", "stiff-cube", "tetrahedron", "octahedron", "octahedron-numpy"],
)
def test_polyhedra(
    make: Callable[[int], Assembly], coarse: int, k: float, volume: float, backend: str
) -> None:
    """Edge 1; extrapolated from three nested meshes and confirmed by Surface Evolver."""
    assert refined(make, coarse, k, backend) == pytest.approx(volume, rel=0.003)


@pytest.mark.parametrize(
    ("height", "backend"), [(0.25, "native"), (1.0, "native"), (2.0, "native"), (0.25, "numpy")]
)
def test_drums(height: float, backend: str) -> None:
    volume = refined(lambda rows: bodies.drum(height, rows), 3, 1e3, backend)
    assert volume == pytest.approx(drum_volume(height), rel=0.003)


@needs_native
def test_the_very_mesh_of_another_program() -> None:
    """Surface Evolver, relaxed_elastic_A: a cube of 6 x 8 x 8 squares, each cut by both diagonals."""
    body = bodies.box(1.0, 1.0, 1.0, 8, both_diagonals=True)
    assert len(np.unique(body.surface.first)) == 770
    result = blown(body)
    assert between_facets(result) == pytest.approx(1.256910, abs=2e-6)
    problem = film_problem(body, film(1000.0), PRESSURE, BARE)
    energies = newton.energies(problem, result.positions, result.directors)
    assert energies.total == pytest.approx(-1.255604, abs=2e-6)


@pytest.mark.parametrize(
    "body",
    [cube(4), bodies.tetrahedron(6), bodies.drum(1.0, 5), bodies.thick_ring(0.7, 1.0, 0.3, 2, 24)],
    ids=["cube", "tetrahedron", "drum", "ring"],
)
@needs_native
def test_both_solvers_agree(body: Assembly) -> None:
    one, other = (blown(body, backend=name) for name in ("native", "numpy"))
    assert one.volume == pytest.approx(other.volume, rel=1e-6)
    np.testing.assert_allclose(one.positions, other.positions, atol=1e-4)


def test_two_panels_with_a_seam_are_the_mirrored_one() -> None:
    """Given as two panels and a seam, with bending and with a sealed band."""
    disc = panel("disc", 250)
    banded = film(300.0, seal_width=0.02)
    mirrored = inflate(disc, banded, PRESSURE)
    whole = inflate(Assembly.mirrored(disc).in_full(), banded, PRESSURE)
    assert whole.volume == pytest.approx(mirrored.volume, rel=1e-4)
    upper, lower = np.split(whole.positions, 2)
    size = disc.size
    np.testing.assert_allclose(upper, mirrored.positions, atol=3e-3 * size)
    np.testing.assert_allclose(lower, mirrored.positions * (1.0, 1.0, -1.0), atol=3e-3 * size)


def test_two_panels_find_their_shape_in_space() -> None:
    """Of panels that do not lie on one another nothing is known but their seams."""
    disc = panel("disc", 250)
    beside = replace(disc, rest_positions=disc.rest_positions @ [[0.6, 0.8], [-0.8, 0.6]])
    whole = Assembly.mirrored(disc).in_full()
    apart = Assembly((disc, beside), whole.seams)
    assert not apart.is_pair
    one = inflate(whole, film(300.0), PRESSURE, settings=EXACT)
    other = inflate(apart, film(300.0), PRESSURE, settings=EXACT)
    assert other.volume == pytest.approx(one.volume, rel=1e-5)


@pytest.mark.parametrize(
    ("body", "volume"),
    [
        (bodies.gored_sphere(8, 16, 4), 0.9858 * 4.0 * np.pi / 3.0),
        (bodies.box(1.0, 1.0, 8.0, 3), None),
        (bodies.thick_ring(0.7, 1.0, 0.3, 2, 30), None),
        (bodies.thick_ring(0.85, 1.0, 0.1, 2, 48), None),
        (bodies.letter_l(3), None),
        (bodies.box(1.0, 1.0, 0.05, 20), None),
    ],
    ids=["gores", "long-box", "ring", "thin-ring", "letter", "plate"],
)
def test_any_body_finds_a_shape(body: Assembly, volume: float | None) -> None:
    """Convex or not, with a hole or without: outside out, no film stretched, hardly any lost in crumples."""
    result = blown(body)
    assert result.report.newton_steps < 60
    state = film_state(result, film(1000.0))
    assert state.strains[:, 0].max() < 0.02
    if volume is not None:
        assert result.volume == pytest.approx(volume, rel=0.01)
    flat = state.areas.sum()
    assert 0.0 < 36.0 * np.pi * result.volume**2 / flat**3 < 1.0
    assert _area(result) > 0.85 * flat


def _area(result: Inflation) -> float:
    a, b, c = np.moveaxis(result.positions[result.assembly.surface.triangles], 1, 0)
    return 0.5 * float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum())


def test_a_folded_rectangle_is_a_pillow() -> None:
    """One panel sealed to itself: a fold costs nothing, as a seam does not."""
    cells = 6
    sheet = bodies.rectangle(2 * cells, cells, 2.0, 1.0)
    places = np.array([(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (0.0, 1.0)])
    sides = [bodies.run(0, sheet, places[k], places[(k + 1) % 6]) for k in range(6)]
    pairs = ((0, 1), (3, 4), (2, 5))
    folded = Assembly((sheet,), tuple(Seam(sides[a], bodies.back(sides[b])) for a, b in pairs))
    pillow = Assembly.mirrored(bodies.rectangle(cells, cells, 1.0, 1.0)).in_full()
    assert between_facets(blown(folded)) == pytest.approx(between_facets(blown(pillow)), rel=1e-4)


def test_a_corner_folded_flat_has_a_normal() -> None:
    """Two triangles back to back at one end: their normals cancel, but not at the other."""
    places = np.array([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, 1.0, 0.0), (1.0, 0.0, 0.0)])
    sheet = Panel(np.zeros((4, 2)), np.array([[0, 1, 2], [0, 2, 3]], dtype=np.int32), ())
    normals = vertex_normals(places, sheet)
    np.testing.assert_allclose(np.abs(normals), np.tile([0.0, 0.0, 1.0], (4, 1)))


def test_a_corner_of_triangles_without_an_area_has_a_normal() -> None:
    places = np.array([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (2.0, 0.0, 0.0)])
    sheet = Panel(np.zeros((4, 2)), np.array([[0, 1, 2], [0, 1, 3]], dtype=np.int32), ())
    np.testing.assert_array_equal(vertex_normals(places, sheet), np.tile([0.0, 0.0, 1.0], (4, 1)))


def test_a_balloon_is_never_mirrored_to_its_start() -> None:
    """A start that is the mirror image is met as well as a turn can."""
    corners = np.array([(0.0, 0.0, 0.0), (3.0, 0.0, 0.0), (0.0, 2.0, 0.0), (0.0, 0.0, 1.0)])
    laid = _laid_over(Equilibrium(corners, corners, 0, 0, True), corners * MIRROR).positions
    assert np.linalg.det(laid[1:] - laid[0]) == pytest.approx(6.0)


@needs_native
def test_where_panels_are_laid_does_not_matter() -> None:
    """Side by side, as they are, or all on one another: only the order of the unknowns is another."""
    body = cube(4)
    problem = film_problem(body, film(1000.0), PRESSURE, BARE)
    start = start_of(split_assembly(body), problem, None, 0.0)
    stacked = np.concatenate([one.rest_positions / body.size for one in body.panels])
    assert np.ptp(problem.rest_positions, axis=0).tolist() == pytest.approx([6.0, 1.0])
    apart, together = (
        c_interface.solve(one, start, EXACT).positions
        for one in (problem, replace(problem, rest_positions=stacked))
    )
    np.testing.assert_allclose(apart, together, atol=1e-6)


def test_a_start_that_does_not_fit_is_not_used() -> None:
    """One of a mirrored panel for a body in space, of a body for a mirrored panel, of other panels."""
    square = bodies.rectangle(4, 4, 1.0, 1.0)
    mirrored, body = inflate(square, film(1000.0), PRESSURE), cube(4)
    cold = blown(body)
    for start in (mirrored, blown(cube(3)), np.zeros((7, 3))):
        again = inflate(body, film(1000.0), PRESSURE, start=start, model=BARE, settings=EXACT)
        assert again.positions.tobytes() == cold.positions.tobytes()
    for start in (cold, blown(cube(3))):
        again = inflate(square, film(1000.0), PRESSURE, start=start)
        assert again.positions.tobytes() == mirrored.positions.tobytes()


def test_panels_of_two_meshes_over_each_other() -> None:
    """Their seam lies over itself, but one is no mirror image of the other."""
    one, other = bodies.rectangle(6, 6, 1.0, 1.0), bodies.crossed(bodies.rectangle(6, 6, 1.0, 1.0))
    rim = np.append(one.loops[0], one.loops[0][:1])
    np.testing.assert_array_equal(one.rest_positions[rim], other.rest_positions[rim])
    both = Assembly((one, other), (Seam(Run(0, rim), Run(1, rim)),))
    assert not both.is_pair
    coarse, fine = (between_facets(blown(Assembly.mirrored(half).in_full())) for half in (one, other))
    assert coarse < between_facets(blown(both)) < fine


def test_a_result_is_where_it_began() -> None:
    """A body is free in space; what is given as its start says where it lies."""
    body = cube(3)
    first = blown(body)
    turn = np.linalg.qr(np.random.default_rng(3).normal(size=(3, 3)))[0]
    turn *= np.linalg.det(turn)
    moved = first.positions @ turn + (5.0, -2.0, 1.0)
    again = inflate(body, film(1000.0), PRESSURE, start=moved, model=BARE, settings=EXACT)
    np.testing.assert_allclose(again.positions, moved, atol=1e-3)
    warm = inflate(body, film(1000.0), PRESSURE, start=first, model=BARE, settings=EXACT)
    assert warm.report.newton_steps < 0.5 * first.report.newton_steps
    assert warm.volume == pytest.approx(first.volume, rel=1e-6)


def test_bodies_beside_each_other_are_two() -> None:
    one = cube(2)
    both = Assembly(
        one.panels * 2,
        one.seams
        + tuple(
            replace(
                seam,
                first=replace(seam.first, panel=seam.first.panel + 6),
                second=replace(seam.second, panel=seam.second.panel + 6),
            )
            for seam in one.seams
        ),
    )
    assert both.surface.bodies == 2
    with pytest.raises(AssemblyError, match="2 bodies"):
        inflate(both, film(1000.0), PRESSURE)

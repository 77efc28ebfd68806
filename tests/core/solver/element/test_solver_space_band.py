# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sealed band along seams in space: it keeps the curvature of the film's edge in the film's own plane."""

from __future__ import annotations

from dataclasses import replace

import bodies
import numpy as np
import pytest
from solver_cases import PRESSURE, circle, film, needs_native

from BalloonWorkbench.core.panels.assembly import Assembly
from BalloonWorkbench.core.solver.element.seam_band import SeamBand, seam_hinges
from BalloonWorkbench.core.solver.element.shell import Shell, tangent_frames, turned
from BalloonWorkbench.core.solver.element.space_band import SpaceBand
from BalloonWorkbench.core.solver.equilibrium import newton
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.model import Model, film_problem
from BalloonWorkbench.core.solver.native import c_interface
from BalloonWorkbench.core.solver.problem import FilmProblem
from BalloonWorkbench.core.solver.split_along_welds import split_assembly
from BalloonWorkbench.core.solver.start import start_of
from BalloonWorkbench.core.types import Floats

UP = np.array([0.0, 0.0, 1.0])


def band_of(rest: Floats, rigidity: float = 1.0) -> SpaceBand:
    loop = np.arange(len(rest), dtype=np.int32)
    return SpaceBand(rest, seam_hinges([loop]), np.full(len(rest), rigidity))


def problem() -> tuple[FilmProblem, Floats, Floats]:
    """A drum with everything, at random places with directors at random."""
    drum = bodies.drum(1.0, 3)
    bare = film_problem(drum, film(20.0, seal_width=0.05), PRESSURE)
    assert bare.in_space
    rigidities = np.linspace(0.2, 0.3, len(bare.hinges))
    full = replace(bare, pressure=0.7, gradient=0.5, flexural_rigidity=0.05, hinge_rigidities=rigidities)
    start = start_of(split_assembly(drum), full, None, 0.0)
    random = np.random.default_rng(3)
    positions = (start.positions + random.normal(0.0, 0.01, start.positions.shape))[full.tied]
    directors = start.directors + random.normal(0.0, 0.3, positions.shape)
    return full, positions, directors / np.linalg.norm(directors, axis=1)[:, None]


def test_it_is_the_law_in_the_plane_where_the_film_is_flat() -> None:
    rest = circle(1.0, 30) * (1.0, 0.6)
    now = rest + np.random.default_rng(2).normal(0.0, 0.05, rest.shape)
    flat = SeamBand(rest, band_of(rest).hinges, np.full(len(rest), 0.7))
    places = np.column_stack([now, np.zeros(len(now))])
    assert band_of(rest, 0.7).energy(places, np.tile(UP, (len(now), 1))) == pytest.approx(
        flat.energy(places), rel=1e-12
    )


def rolled(rest: Floats, radius: float) -> tuple[Floats, Floats]:
    """Flat points (n, 2) on a cylinder, and its normals."""
    angle = rest[:, 0] / radius
    normals = np.column_stack([np.sin(angle), np.zeros(len(rest)), np.cos(angle)])
    return radius * normals + rest[:, 1:] * (0.0, 1.0, 0.0), normals


def test_bending_without_stretch_costs_nothing() -> None:
    """A disc rolled to a cylinder; the energy that is left falls with the spacing squared."""
    left = []
    for count in (60, 120):
        rest = circle(1.0, count)
        left.append(band_of(rest).energy(*rolled(rest, 0.8)))
    assert left[0] < 1e-3 * np.pi  # E I kappa^2 / 2 all round
    assert left[1] < 0.3 * left[0]


def test_a_straight_edge_bent_in_the_film_costs_energy() -> None:
    """Along a circle of latitude of a sphere, where its curvature in the sphere is cot(angle) / r."""
    count, angle = 400, 1.0
    around = 2.0 * np.pi * np.sin(angle)
    straight = np.column_stack([np.linspace(0.0, around, count + 1), np.zeros(count + 1)])
    turn = np.linspace(0.0, 2.0 * np.pi, count + 1)
    normals = np.column_stack(
        [np.sin(angle) * np.cos(turn), np.sin(angle) * np.sin(turn), np.full(count + 1, np.cos(angle))]
    )
    band = SpaceBand(
        straight, seam_hinges([], [np.arange(count + 1, dtype=np.int32)]), np.full(count - 1, 3.0)
    )
    expected = 0.5 * 3.0 * around / np.tan(angle) ** 2
    assert band.energy(normals, normals) == pytest.approx(expected, rel=0.01)


def test_it_does_not_see_a_rigid_motion_nor_an_even_shrinking() -> None:
    rest = circle(1.0, 40) * (1.0, 0.7)
    places, normals = rolled(rest, 0.5)
    shaken = places + np.random.default_rng(1).normal(0.0, 0.03, places.shape)
    axes = np.linalg.qr(np.random.default_rng(4).standard_normal((3, 3)))[0]
    axes *= np.linalg.det(axes)
    band = band_of(rest)
    assert band.energy(shaken @ axes + 3.0, normals @ axes) == pytest.approx(band.energy(shaken, normals))
    small = 0.3 * np.column_stack([rest, np.zeros(len(rest))])
    assert band.energy(small, np.tile(UP, (len(rest), 1))) == pytest.approx(0.0, abs=1e-20)


@pytest.mark.parametrize("exact", [True, False])
def test_derivatives(exact: bool) -> None:
    """Gradient and exact Hessian are slopes, with pressure that grows upwards and bands in space."""
    full, positions, directors = problem()
    shell = Shell(full)
    shell.exact = exact
    frames = tangent_frames(directors)
    gradient, hessian = shell.derivatives(positions, directors, frames)
    direction = np.random.default_rng(5).standard_normal(shell.count)
    moves, turns = shell.spread(direction)
    step = 1e-6
    ahead, behind = (
        shell.energies(positions + h * moves, turned(directors, frames, h * turns)).total
        for h in (step, -step)
    )
    assert (ahead - behind) / (2.0 * step) == pytest.approx(gradient @ direction, rel=1e-7)

    def slope(part: float) -> Floats:
        moved = directors + part * np.einsum("nij,nj->ni", frames, turns)
        lengths = np.linalg.norm(moved, axis=1)[:, None]
        now = moved / lengths
        along = np.einsum("ni,nij->nj", now, frames)
        carried = (frames - now[:, :, None] * along[:, None]) / lengths[:, :, None]
        return shell.derivatives(positions + part * moves, now, carried)[0]

    slopes = (slope(1e-7) - slope(-1e-7)) / 2e-7
    missed = np.linalg.norm(slopes - hessian @ direction) / np.linalg.norm(slopes)
    assert (missed < 1e-8) if exact else (missed > 1e-4)
    assert abs(hessian - hessian.T).max() < 1e-12 * abs(hessian).max()


@needs_native
def test_both_solvers_see_the_same_energy() -> None:
    full, positions, directors = problem()
    one, other = (solver.energies(full, positions, directors) for solver in (c_interface, newton))
    for name in ("membrane", "bending", "pressure", "seam"):
        assert getattr(one, name) == pytest.approx(getattr(other, name), rel=1e-9)
    assert one.seam > 1.0


@pytest.mark.parametrize(
    ("body", "less"),
    [
        (bodies.box(1.0, 1.0, 1.0, 6), 0.005),
        (bodies.drum(1.0, 6), 0.003),
        (bodies.gored_sphere(8, 16, 4), 0.004),
        (bodies.letter_l(5), 0.005),
    ],
    ids=["cube", "drum", "gores", "L"],
)
@needs_native
def test_both_solvers_agree_and_the_band_takes_little(body: Assembly, less: float) -> None:
    banded = film(1000.0, seal_width=0.05)
    one, other = (inflate(body, banded, PRESSURE, backend=name) for name in ("native", "numpy"))
    assert one.report.banded
    assert one.report.newton_steps == other.report.newton_steps <= 20
    assert one.volume == pytest.approx(other.volume, rel=1e-6)
    free = inflate(body, film(1000.0), PRESSURE)
    assert one.volume == pytest.approx(free.volume, rel=less)
    assert abs(one.volume / free.volume - 1.0) > 1e-5


def test_without_bending_seams_in_space_have_no_band() -> None:
    """Nothing would turn the directors, which tell it the plane of the film."""
    problem = film_problem(bodies.drum(1.0, 3), film(20.0, seal_width=0.05), PRESSURE, Model(bending=False))
    assert problem.hinges is None


def test_no_band_runs_through_a_pole() -> None:
    cube = bodies.box(1.0, 1.0, 1.0, 4)
    problem = film_problem(cube, film(20.0, seal_width=0.05), PRESSURE)
    assert len(problem.hinges) == 6 * 4 * 3
    assert not np.isin(cube.surface.first[problem.hinges[:, 1]], cube.surface.poles).any()

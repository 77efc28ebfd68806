# SPDX-License-Identifier: LGPL-2.1-or-later
"""Energy, gradient and Hessian of the discrete film: consistent with each other and between the solvers."""

from dataclasses import replace

import numpy as np
import pytest
from drawn_shapes import NAMED
from solver_cases import PRESSURE, film, needs_native, panel

from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.solver.element.orthotropic import Grain
from BalloonWorkbench.core.solver.element.shell import Shell, tangent_frames, turned
from BalloonWorkbench.core.solver.equilibrium import newton
from BalloonWorkbench.core.solver.model import film_problem
from BalloonWorkbench.core.solver.native import c_interface
from BalloonWorkbench.core.solver.problem import FilmProblem
from BalloonWorkbench.core.solver.start import dome
from BalloonWorkbench.core.types import Floats


def problem() -> FilmProblem:
    """A ring with everything: bending that counts, bands, loads, and some vertices held."""
    ring = triangulate(NAMED["ring"], 0.04)
    bare = film_problem(ring, film(20, seal_width=0.02), PRESSURE)
    fixed = bare.fixed.copy()
    fixed[3] = True
    fixed[5, 3] = True
    loads = np.random.default_rng(8).normal(0.0, 0.01, (len(fixed), 3))
    rigidities = np.linspace(0.2, 0.3, len(bare.hinges))
    return replace(bare, fixed=fixed, loads=loads, flexural_rigidity=0.05, hinge_rigidities=rigidities)


def random_state(seed: int, problem: FilmProblem, scatter: float = 0.02) -> tuple[Floats, Floats]:
    """A dome stretched, shrunk and dented at random, with directors at random: film in all three states."""
    random = np.random.default_rng(seed)
    positions = dome(triangulate(NAMED["ring"], 0.04)) / np.ptp(NAMED["ring"].outer, axis=0).max()
    positions *= random.uniform(0.85, 1.15, 3)
    positions += random.normal(0.0, scatter, positions.shape)
    directors = random.normal((0.0, 0.0, 2.0), 1.0, positions.shape)
    return positions, directors / np.linalg.norm(directors, axis=1)[:, None]


def parts(energies: object) -> list[float]:
    return [getattr(energies, name) for name in ("membrane", "bending", "pressure", "load", "seam")]


@pytest.mark.parametrize("seed", range(3))
def test_gradient_is_the_slope_of_the_energy(seed: int) -> None:
    shell = Shell(problem())
    positions, directors = random_state(seed, problem())
    frames = tangent_frames(directors)
    gradient, _ = shell.derivatives(positions, directors, frames)
    for direction in np.random.default_rng(seed).standard_normal((8, shell.count)):
        moves, turns = shell.spread(direction)
        step = 1e-6
        ahead, behind = (
            shell.energies(positions + h * moves, turned(directors, frames, h * turns)).total
            for h in (step, -step)
        )
        assert (ahead - behind) / (2.0 * step) == pytest.approx(gradient @ direction, rel=1e-5, abs=1e-7)


@pytest.mark.parametrize("seed", range(3))
def test_hessian_is_the_slope_of_the_gradient(seed: int) -> None:
    """Membrane, pressure and band: exact. (The bending part is Gauss-Newton, unless it is asked for.)"""
    shell = Shell(replace(problem(), flexural_rigidity=0.0))
    positions, directors = random_state(seed, problem(), scatter=0.005)
    frames = tangent_frames(directors)
    _, hessian = shell.derivatives(positions, directors, frames)
    direction = np.random.default_rng(seed).standard_normal(shell.count)
    moves, _ = shell.spread(direction)
    step = 1e-7
    ahead, behind = (shell.derivatives(positions + h * moves, directors, frames)[0] for h in (step, -step))
    slope = (ahead - behind) / (2.0 * step)
    assert np.abs(slope - hessian @ direction).max() < 1e-5 * np.abs(slope).max()
    assert abs(hessian - hessian.T).max() < 1e-12 * abs(hessian).max()


@pytest.mark.parametrize("exact", [True, False])
@pytest.mark.parametrize("seed", range(3))
def test_exact_hessian_is_the_slope_of_the_gradient_with_bending(seed: int, exact: bool) -> None:
    """Positions and directors move together, these on their sphere; Gauss-Newton misses it by far."""
    shell = Shell(problem())
    shell.exact = exact
    positions, directors = random_state(seed, problem(), scatter=0.005)
    frames = tangent_frames(directors)
    _, hessian = shell.derivatives(positions, directors, frames)
    direction = np.random.default_rng(seed).standard_normal(shell.count)
    moves, turns = shell.spread(direction)

    def gradient(step: float) -> Floats:
        """By the turns from where the directors began: their frames turn and shrink as they do."""
        moved = directors + step * np.einsum("nij,nj->ni", frames, turns)
        lengths = np.linalg.norm(moved, axis=1)[:, None]
        now = moved / lengths
        along = np.einsum("ni,nij->nj", now, frames)
        carried = (frames - now[:, :, None] * along[:, None]) / lengths[:, :, None]
        return shell.derivatives(positions + step * moves, now, carried)[0]

    slope = (gradient(1e-7) - gradient(-1e-7)) / 2e-7
    missed = np.linalg.norm(slope - hessian @ direction) / np.linalg.norm(slope)
    assert (missed < 1e-8) if exact else (missed > 1e-4)
    assert abs(hessian - hessian.T).max() < 1e-12 * abs(hessian).max()


def test_bending_hessian_is_positive_semi_definite() -> None:
    bending = replace(problem(), membrane_stiffness=0.0, pressure=0.0, loads=None, hinges=None)
    shell = Shell(bending)
    positions, directors = random_state(1, bending)
    _, hessian = shell.derivatives(positions, directors, tangent_frames(directors))
    eigenvalues = np.linalg.eigvalsh(hessian.toarray())
    assert eigenvalues.min() > -1e-10 * eigenvalues.max()


def test_only_pressure_makes_the_hessian_indefinite() -> None:
    positions, directors = random_state(2, problem())
    positions *= 0.5  # largely slack
    frames = tangent_frames(directors)
    for pressure, indefinite in ((0.0, False), (1.0, True)):
        thin = replace(problem(), pressure=pressure, flexural_rigidity=1e-6)
        _, hessian = Shell(thin).derivatives(positions, directors, frames)
        eigenvalues = np.linalg.eigvalsh(hessian.toarray())
        assert (eigenvalues.min() < -1e-8 * eigenvalues.max()) == indefinite


def test_energy_does_not_see_a_rigid_motion() -> None:
    """The film in space, the bands in their plane."""
    positions, directors = random_state(4, problem())
    angle = 0.8
    turn = np.array(
        [[np.cos(angle), -np.sin(angle), 0.0], [np.sin(angle), np.cos(angle), 0.0], [0.0, 0.0, 1.0]]
    )
    tilt = turn[[2, 0, 1]][:, [2, 0, 1]]
    before = parts(newton.energies(problem(), positions, directors))
    after = parts(newton.energies(problem(), positions @ turn.T + (0.3, -0.2, 0.0), directors @ turn.T))
    assert after[0] == pytest.approx(before[0], rel=1e-9)
    assert after[1] == pytest.approx(before[1], rel=1e-9)
    assert after[4] == pytest.approx(before[4], rel=1e-9)
    tilted = parts(newton.energies(problem(), positions @ tilt.T, directors @ tilt.T))
    assert tilted[:2] == pytest.approx(before[:2], rel=1e-9)


@pytest.mark.parametrize("grain", [None, Grain(0.4, 0.25, 0.3, 0.7)], ids=["alike", "grain"])
@pytest.mark.parametrize("tension_field", [True, False], ids=["film", "plain-shell"])
@pytest.mark.parametrize("seed", range(4))
@needs_native
def test_both_solvers_see_the_same_energy(seed: int, tension_field: bool, grain: Grain | None) -> None:
    one_film = replace(problem(), tension_field=tension_field, grain=grain)
    state = random_state(seed, one_film)
    one, other = (parts(solver.energies(one_film, *state)) for solver in (c_interface, newton))
    assert one == pytest.approx(other, rel=1e-9)
    assert all(abs(part) > 1e-6 for part in one)


def test_disc_energy_is_that_of_the_cap() -> None:
    """Volume and stretch of a dome pulled up as a paraboloid, by hand."""
    disc = panel("disc")
    rest = disc.rest_positions
    lifted = np.column_stack([rest, 0.3 * (1.0 - (rest**2).sum(axis=1))])
    bare = FilmProblem(rest, disc.triangles, np.zeros((len(rest), 5), dtype=bool), 2.0, 0.0, 0.0)
    energies = newton.energies(bare, lifted, np.tile([0.0, 0.0, 1.0], (len(rest), 1)))
    assert -energies.pressure == pytest.approx(np.pi * 0.3 / 2.0, rel=0.005)
    # radial Green strain (0.6 r)^2 / 2, none around: the integral of 2 * E^2 / 2 over the disc
    assert energies.membrane == pytest.approx(2.0 * np.pi * 0.6**4 / 4.0 / 6.0, rel=0.01)

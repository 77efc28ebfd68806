# SPDX-License-Identifier: LGPL-2.1-or-later
"""The film in motion: Newmark's steps against closed forms and another integrator, and the way to rest."""

import sys
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from drawn_shapes import NAMED
from scipy.integrate import solve_ivp
from scipy.sparse import csc_matrix
from solver_cases import PRESSURE, film, flat_state, grid, held, panel

from BalloonWorkbench.core.errors import Cancelled, InputError, SolverError
from BalloonWorkbench.core.film.library import films
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.solver.dynamics import motion
from BalloonWorkbench.core.solver.dynamics.animation import Frame, inflate_in_time
from BalloonWorkbench.core.solver.dynamics.newmark import MotionState, Newmark, Scheme
from BalloonWorkbench.core.solver.element.kinematics import facet_volume
from BalloonWorkbench.core.solver.element.shell import Shell, tangent_frames
from BalloonWorkbench.core.solver.equilibrium import linear
from BalloonWorkbench.core.solver.equilibrium.linear import IncompleteFactor, conjugate_gradients
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.model import Model, film_problem
from BalloonWorkbench.core.solver.problem import FilmProblem, NewtonSettings, Start
from BalloonWorkbench.core.types import Floats

MYLAR = films()["mylar"]


def drawn(name: str, vertices: int = 400) -> Panel:
    return triangulate(NAMED[name], size_for(NAMED[name], vertices))


@pytest.fixture(scope="module")
def blown_disc() -> tuple[Inflation, tuple[Frame, ...]]:
    return inflate_in_time(drawn("disc", 250), MYLAR, 2000.0, frames=40)


def moved(newmark: Newmark, state: MotionState, duration: float, steps: int) -> list[MotionState]:
    """The states of even steps, the first one included."""
    states = [state]
    for _ in range(steps):
        after = newmark.step(states[-1], duration / steps, state.load)
        assert after is not None
        states.append(after)
    return states


def stiffness_of_a_balloon() -> csc_matrix:
    """Tangent of a taut star with the masses of a step of 0.5."""
    star = drawn("star")
    size = float(np.ptp(star.rest_positions, axis=0).max())
    balloon = inflate(star, MYLAR, 2000.0)
    shell = Shell(film_problem(star, MYLAR, 2000.0))
    frames = tangent_frames(balloon.directors)
    _, tangent = shell.derivatives(balloon.positions / size, balloon.directors, frames)
    masses = np.repeat(shell.vertex_areas[:, None], 5, axis=1) * (1.0, 1.0, 1.0, 0.0, 0.0)
    return shell.scatter.shifted(tangent, 16.0 * shell.gathered(masses))


@pytest.mark.parametrize(("dropped", "most"), [(1e-5, 8), (1e-3, 60)])
def test_conjugate_gradients_solve_like_elimination(
    dropped: float, most: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(linear, "DROPPED", dropped)
    matrix = stiffness_of_a_balloon()
    exact = np.random.default_rng(7).standard_normal(matrix.shape[0]) / np.sqrt(matrix.diagonal())
    factor = IncompleteFactor(matrix)
    assert factor.definite
    solved = conjugate_gradients(matrix.__matmul__, matrix @ exact, factor, 1e-9)
    assert solved.definite
    assert 1 <= solved.iterations <= most
    assert solved.solution == pytest.approx(exact, abs=1e-6 * np.abs(exact).max())
    direct = np.linalg.solve(matrix.toarray(), matrix @ exact)
    assert solved.solution == pytest.approx(direct, abs=1e-6 * np.abs(exact).max())


def test_preconditioner_is_symmetric() -> None:
    matrix = stiffness_of_a_balloon()
    factor = IncompleteFactor(matrix)
    one, other = np.random.default_rng(3).standard_normal((2, matrix.shape[0]))
    assert one @ factor(other) == pytest.approx(other @ factor(one), rel=1e-9)


@pytest.mark.parametrize("least", [-1.0, 0.0])
def test_indefinite_matrix_is_noticed(least: float) -> None:
    coupled = np.array([[2.0, 1.0, 0.0], [1.0, 2.0, 0.0], [0.0, 0.0, 3.0]])
    coupled -= (1.0 - least) * np.diag([1.0, 1.0, 0.0])  # eigenvalues least, 2 + least and 3
    assert not IncompleteFactor(csc_matrix(coupled)).definite
    load = np.array([1.0, -1.0, 0.0])
    assert not conjugate_gradients(coupled.__matmul__, load, lambda residual: residual, 1e-9).definite


def test_cantilever_swings_like_a_beam() -> None:
    """First mode of a clamped strip, nu = 0: omega = 1.8751^2 sqrt(D / m) / L^2; directors have no mass."""
    points, triangles = grid(16, 1, 1.0, 0.1)
    fixed = held(len(points), moves="y")
    fixed[points[:, 0] == 0.0] = True
    rigidity = 1e-3
    problem = FilmProblem(points, triangles, fixed, 10.0, 0.0, rigidity, 0.0, tension_field=False)
    root = 1.8751040687
    ratio = (np.cosh(root) + np.cos(root)) / (np.sinh(root) + np.sin(root))
    x = root * points[:, 0]
    height = 1e-4 * (np.cosh(x) - np.cos(x) - ratio * (np.sinh(x) - np.sin(x)))
    slope = 1e-4 * root * (np.sinh(x) + np.sin(x) - ratio * (np.cosh(x) - np.cos(x)))
    positions, directors = flat_state(points)
    positions[:, 2] = height
    directors[:, 0] = -slope
    newmark = Newmark(problem, Scheme())
    start = newmark.released(positions, directors / np.linalg.norm(directors, axis=1)[:, None], 0.0)
    quarter = 0.5 * np.pi / (root**2 * np.sqrt(rigidity))
    tip = int(np.argmax(points @ (1.0, 0.1)))
    states = moved(newmark, start, 1.1 * quarter, 60)
    heights = [state.positions[tip, 2] for state in states]
    crossing = np.interp(0.0, heights[::-1], [state.time for state in states][::-1])
    assert crossing == pytest.approx(quarter, rel=0.01)


def drum() -> tuple[FilmProblem, Floats, Floats]:
    """A square film stretched evenly by 2 % in a frame, with its positions and directors."""
    points, triangles = grid(10, 10, 1.0, 1.0)
    fixed = held(len(points), turns=True)
    fixed[np.any((points == 0.0) | (points == 1.0), axis=1)] = True
    problem = FilmProblem(points, triangles, fixed, 50.0, 0.3, 0.0, 0.0)
    positions, directors = flat_state(points)
    positions[:, :2] *= 1.02
    return problem, positions, directors


def test_drum_sounds_right() -> None:
    """omega = pi sqrt(2 S / m) for a square film of side 1, S = k strain / (1 - nu) its even stress."""
    problem, positions, directors = drum()
    wave = np.prod(np.sin(np.pi * problem.rest_positions), axis=1)
    positions[:, 2] = 1e-4 * wave
    newmark = Newmark(problem, Scheme())
    start = newmark.released(positions, directors, 0.0)
    period = 2.0 / np.sqrt(2.0 * 50.0 * (0.02 + 0.5 * 0.02**2) / 0.7)
    states = moved(newmark, start, 1.5 * period, 90)
    swing = np.array([wave @ state.positions[:, 2] for state in states])
    rising = int(np.flatnonzero((swing[:-1] < 0.0) & (swing[1:] >= 0.0))[0])  # after three quarters
    crossing = np.interp(
        0.0, swing[rising : rising + 2], [state.time for state in states[rising : rising + 2]]
    )
    assert crossing == pytest.approx(0.75 * period, rel=0.01)


def energies_of_a_drum(scheme: Scheme, steps: int) -> Floats:
    """Kinetic and potential energy (steps + 1, 2) of large swings, over the film at rest."""
    problem, positions, directors = drum()
    newmark = Newmark(problem, scheme)
    rest = newmark.potential_energy(newmark.released(positions, directors, 0.0))
    positions = positions.copy()
    positions[:, 2] = 0.05 * np.prod(np.sin(np.pi * problem.rest_positions), axis=1)
    states = moved(newmark, newmark.released(positions, directors, 0.0), 2.0, steps)
    return np.array(
        [(newmark.kinetic_energy(state), newmark.potential_energy(state) - rest) for state in states]
    )


def test_free_motion_keeps_its_energy() -> None:
    kinetic, potential = energies_of_a_drum(Scheme(tolerance=1e-12), 160).T
    assert kinetic.max() > 0.8 * potential[0]
    assert kinetic + potential == pytest.approx(np.full(len(kinetic), potential[0]), rel=0.005)


def test_numerical_damping_takes_energy() -> None:
    kinetic, potential = energies_of_a_drum(Scheme(1.0, tolerance=1e-12), 80).T
    assert kinetic.max() > 0.5 * potential[0]
    total = kinetic + potential
    assert np.diff(total).max() < 0.002 * total[0]
    assert total[-1] < 0.7 * total[0]


def hanging_triangle() -> tuple[FilmProblem, Floats, Floats]:
    """A triangle of film hung up at two corners, its third corner loaded and pushed aside."""
    points = np.array([[0.0, 0.0], [1.0, 0.0], [0.5, -0.8]])
    fixed = held(3, turns=True)
    fixed[:2] = True
    loads = np.array([[0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, -0.5, 0.0]])
    problem = FilmProblem(
        points, np.array([[0, 2, 1]], dtype=np.int32), fixed, 20.0, 0.3, 0.0, 0.0, loads, tension_field=False
    )
    positions, directors = flat_state(points)
    positions[2] = (0.55, -0.85, 0.3)
    return problem, positions, directors


def test_second_order_in_time() -> None:
    """Against an explicit Runge-Kutta method of order 8: the error falls by four when the step is halved."""
    problem, positions, directors = hanging_triangle()
    shell = Shell(problem)
    frames = tangent_frames(directors)

    def rates(_: float, unknowns: Floats) -> Floats:
        corners = positions.copy()
        corners[2] = unknowns[:3]
        gradient, _ = shell.derivatives(corners, directors, frames)
        return np.concatenate([unknowns[3:], -gradient / shell.vertex_areas[2]])

    exact = solve_ivp(
        rates, (0.0, 1.0), np.concatenate([positions[2], np.zeros(3)]), "DOP853", rtol=1e-11, atol=1e-12
    ).y[:3, -1]
    assert np.linalg.norm(exact - positions[2]) > 0.05
    errors = []
    for steps in (50, 100, 200):
        newmark = Newmark(problem, Scheme(tolerance=1e-13))
        end = moved(newmark, newmark.released(positions, directors, 0.0), 1.0, steps)[-1]
        errors.append(np.linalg.norm(end.positions[2] - exact))
    assert errors[-1] < 1e-3
    for coarse, fine in pairwise(errors):
        assert coarse / fine == pytest.approx(4.0, rel=0.1)


def test_drag_gives_a_terminal_velocity() -> None:
    """A free film pushed by a load g on its mass, with drag c: v = g (1 - exp(-c t)) / c."""
    points, triangles = grid(3, 3, 1.0, 1.0)
    fixed = held(len(points), turns=True)
    problem = FilmProblem(points, triangles, fixed, 10.0, 0.3, 0.0, 0.0)
    push = np.array([0.3, 0.0, -1.0])
    problem = replace(problem, loads=Shell(problem).vertex_areas[:, None] * push)
    newmark = Newmark(problem, Scheme(damping=2.0))
    end = moved(newmark, newmark.released(*flat_state(points), 0.0), 3.0, 120)[-1]
    velocity = push * (1.0 - np.exp(-6.0)) / 2.0
    assert end.velocities == pytest.approx(np.tile(velocity, (len(points), 1)), abs=1e-4)


def test_flat_film_flies_up_freely() -> None:
    """The middle of a limp panel under a rising pressure, far from its rim: z'' + c z' = t."""
    square = panel("square", 250)
    problem = film_problem(square, film(20), PRESSURE)
    flat, directors = flat_state(square.rest_positions)
    newmark = Newmark(problem, Scheme(damping=2.0, tolerance=1e-8))
    state: MotionState | None = newmark.released(flat, directors, 0.0)
    for step in range(1, 21):
        assert state is not None
        state = newmark.step(state, 0.015, 0.015 * step)
    assert state is not None
    t, c = state.time, 2.0
    height = 0.5 * t**2 / c - t / c**2 + (1.0 - np.exp(-c * t)) / c**3
    middle = int(np.argmin(np.linalg.norm(square.rest_positions, axis=1)))
    assert state.positions[middle, 2] == pytest.approx(height, rel=0.01)


def test_a_step_too_long_is_refused() -> None:
    """A slack film under pressure is unstable: over a long step its tangent is not positive definite."""
    disc = panel("disc", 150)
    problem = film_problem(disc, film(100), PRESSURE)
    positions, directors = flat_state(disc.rest_positions)
    positions[:, :2] *= 0.9
    positions[:, 2] = 1e-3 * (1.0 - (disc.rest_positions**2).sum(axis=1))
    newmark = Newmark(problem, Scheme())
    start = newmark.released(positions, directors, 0.0)
    assert newmark.step(start, 1e3, 1.0) is None
    assert newmark.step(start, 1e-3, 1.0) is not None


@pytest.mark.parametrize("name", ["square", "heart"])
def test_same_rest_as_the_quasi_static_method(name: str) -> None:
    outline = drawn(name, 200)
    quasi_static = inflate(outline, MYLAR, 2000.0)
    blown = inflate(outline, MYLAR, 2000.0, backend="newmark")
    assert blown.report.backend == "newmark"
    assert blown.report.converged
    assert blown.volume == pytest.approx(quasi_static.volume, rel=0.001)
    assert not blown.positions[np.concatenate(outline.loops), 2].any()


def test_a_disc_is_that_of_the_axisymmetric_solution() -> None:
    """For k = 200, by way of the quasi-static method: its disc of the same mesh, and a finer one."""
    disc = panel("disc", 250)
    blown, quasi_static = (inflate(disc, film(200), PRESSURE, backend=name) for name in ("newmark", None))
    fine = inflate(panel("disc", 1500), film(200), PRESSURE)
    assert blown.report.converged
    assert blown.volume == pytest.approx(quasi_static.volume, rel=0.001)
    assert fine.volume == pytest.approx(1.22915, rel=0.003)
    assert 2.0 * fine.positions[:, 2].max() == pytest.approx(0.92817, rel=0.01)
    assert blown.positions[:, 2].max() == pytest.approx(quasi_static.positions[:, 2].max(), rel=0.005)


def test_both_panels() -> None:
    """Tied seams: two panels move as one with its mirror image."""
    square = drawn("square", 90)
    one = inflate(square, MYLAR, 2000.0, backend="newmark")
    both = inflate(square, MYLAR, 2000.0, backend="newmark", model=Model(two_panels=True))
    assert both.report.converged
    assert both.lower is not None
    assert both.volume == pytest.approx(one.volume, rel=0.001)


def test_warm_start_begins_flat_too() -> None:
    heart = drawn("heart", 150)
    first = inflate(heart, MYLAR, 2000.0, backend="newmark")
    again = inflate(heart, MYLAR, 2000.0, backend="newmark", start=first)
    assert again.report.converged
    assert again.volume == pytest.approx(first.volume, rel=0.002)


def test_running_out_of_steps_keeps_the_last_state() -> None:
    result = inflate(
        panel("disc", 150), film(1000), PRESSURE, backend="newmark", settings=NewtonSettings(max_steps=8)
    )
    assert not result.report.converged
    assert np.isfinite(result.positions).all()
    assert 0.0 < result.volume < 1.23


def test_cancel_and_progress() -> None:
    disc = panel("disc", 150)
    seen: list[tuple[float, str]] = []

    def watch(fraction: float, text: str) -> bool:
        seen.append((fraction, text))
        return True

    inflate(disc, film(100), PRESSURE, backend="newmark", progress=watch)
    fractions = [fraction for fraction, _ in seen]
    assert {text for _, text in seen} == {"inflating"}
    assert fractions == sorted(fractions)
    assert fractions[0] == 0.0
    assert fractions[-1] == 1.0

    calls: list[float] = []

    def stop_at_tenth(fraction: float, text: str) -> bool:
        calls.append(fraction)
        return len(calls) < 10

    with pytest.raises(Cancelled):
        inflate_in_time(disc, film(100), PRESSURE, progress=stop_at_tenth)
    assert len(calls) == 10


def test_broken_mesh_is_refused() -> None:
    points = np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [np.nan, 1.0]])
    triangles = np.array([[0, 1, 2], [1, 3, 2]], dtype=np.int32)
    problem = FilmProblem(points, triangles, held(4), 10.0, 0.3, 1e-6)
    start = np.column_stack([np.nan_to_num(points), [0.0, 0.0, 0.0, 0.1]])
    with pytest.raises(SolverError, match="degenerate"):
        motion.solve(problem, Start(start, np.tile([0.0, 0.0, 1.0], (4, 1)), (10.0,)), NewtonSettings())


def test_failing_from_the_first_step_is_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(motion, "SMALLEST_STEP", 2.0 * motion.FIRST_STEP)
    with pytest.raises(SolverError, match="first step"):
        inflate(panel("disc", 150), film(100), PRESSURE, backend="newmark")


def test_without_scipy(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "scipy", None)
    with pytest.raises(InputError, match="'newmark' needs the Python package scipy"):
        inflate_in_time(panel("disc", 150), film(100), PRESSURE)


def test_frames_lead_from_flat_to_rest(blown_disc: tuple[Inflation, tuple[Frame, ...]]) -> None:
    balloon, frames = blown_disc
    assert len(frames) == 40
    times = np.array([frame.time for frame in frames])
    pressures = np.array([frame.pressure for frame in frames])
    assert times[0] == 0.0
    assert np.diff(times).min() > 0.0
    assert pressures[0] == 0.0
    assert np.diff(pressures).min() >= 0.0
    assert pressures[-1] == 2000.0
    assert frames[0].positions[:, :2] == pytest.approx(balloon.panel.rest_positions)
    assert 0.0 <= frames[0].positions[:, 2].max() < 1e-3
    assert np.array_equal(frames[-1].positions, balloon.positions)
    volumes = np.array([facet_volume(frame.positions, balloon.panel.triangles) for frame in frames])
    assert np.diff(volumes).min() > -0.01 * volumes[-1]  # it hardly swings back
    assert volumes[0] < 0.01 * volumes[-1]
    strides = [np.abs(after.positions - before.positions).max() for before, after in pairwise(frames)]
    assert max(strides) < 0.3 * 3.0 / len(frames)  # no jumps
    seam = np.concatenate(balloon.panel.loops)
    assert all(np.abs(frame.positions[seam, 2]).max() == 0.0 for frame in frames)


def test_heavier_film_is_slower(blown_disc: tuple[Inflation, tuple[Frame, ...]]) -> None:
    """Four times the mass takes twice the time for the same frames; the same input gives the same bytes."""
    balloon, frames = blown_disc
    heavy = replace(MYLAR, areal_density=4.0 * MYLAR.areal_density)
    same, slower = inflate_in_time(balloon.panel, heavy, 2000.0, frames=40)
    assert same.positions.tobytes() == balloon.positions.tobytes()
    assert same.volume == balloon.volume
    for one, other in zip(frames, slower, strict=True):
        assert other.time == pytest.approx(2.0 * one.time)
        assert other.positions.tobytes() == one.positions.tobytes()


@pytest.mark.parametrize(
    ("film_changes", "count", "text"), [({}, 1, "two frames"), ({"areal_density": 0.0}, 9, "mass")]
)
def test_impossible_animations(film_changes: dict[str, float], count: int, text: str) -> None:
    with pytest.raises(InputError, match=text):
        inflate_in_time(panel("disc", 150), replace(MYLAR, **film_changes), 2000.0, frames=count)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The discrete Kirchhoff triangle: as an element, in plates, and in the shell under small loads."""

import numpy as np
import pytest
from plate_tables import EIGENVALUES, PLATES
from solver_cases import (
    both_solvers,
    flat_state,
    full_grid,
    held,
    nearest,
    panel,
    quarter_grid,
    vertex_areas,
)

from BalloonWorkbench.core.solver.backend import Backend
from BalloonWorkbench.core.solver.element import dkt
from BalloonWorkbench.core.solver.problem import FilmProblem, NewtonSettings, Start
from BalloonWorkbench.core.types import Bools, Floats, Ints, no_progress

UNIT = np.array([[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]])


def assembled(points: Floats, triangles: Ints, poisson_ratio: float) -> Floats:
    count = len(points)
    stiffness = np.zeros((3 * count, 3 * count))
    for corners, element in zip(triangles, dkt.plate_stiffness(points[triangles], poisson_ratio)):
        unknowns = (3 * corners[:, None] + np.arange(3)).ravel()
        stiffness[np.ix_(unknowns, unknowns)] += element
    return stiffness


def solved(stiffness: Floats, load: Floats, fixed: Bools) -> Floats:
    """Deflections and rotations (n, 3) under a load (n,) on the deflections."""
    force = np.zeros(fixed.shape)
    force[:, 0] = load
    free = np.flatnonzero(~fixed.ravel())
    result = np.zeros(fixed.size)
    result[free] = np.linalg.solve(stiffness[np.ix_(free, free)], force.ravel()[free])
    return result.reshape(-1, 3)


def irregular() -> tuple[Floats, Ints]:
    """A square of 2 x 2 quarters whose inner vertices are pushed about."""
    points, triangles = full_grid(2)
    inner = np.abs(points).max(axis=1) < 0.49
    shift = np.random.default_rng(3).uniform(-0.07, 0.07, points.shape)
    return np.where(inner[:, None], points + shift, points), triangles


def test_single_element() -> None:
    stiffness = dkt.plate_stiffness(UNIT, 0.3)[0]
    assert stiffness[0, 0] == pytest.approx(10.05)
    assert np.trace(stiffness) == pytest.approx(27.925)
    assert np.linalg.eigvalsh(stiffness) == pytest.approx([0.0, 0.0, 0.0, *EIGENVALUES], abs=1e-7)


@pytest.mark.parametrize("cells", PLATES)
def test_square_plate(cells: int) -> None:
    points, triangles = quarter_grid(cells)
    stiffness = assembled(points, triangles, 0.3)
    x, y = points.T
    rim_x, rim_y = x == 0.5, y == 0.5
    supported = np.zeros((len(points), 3), dtype=bool)  # w, w,y and -w,x
    supported[x == 0.0, 2] = True
    supported[y == 0.0, 1] = True
    supported[rim_x | rim_y, 0] = True
    supported[rim_x, 1] = True
    supported[rim_y, 2] = True
    clamped = supported | (rim_x | rim_y)[:, None]
    even = vertex_areas(points, triangles)
    centre = np.where((x == 0.0) & (y == 0.0), 0.25, 0.0)
    found = [solved(stiffness, load, rim)[0, 0] for load in (even, centre) for rim in (supported, clamped)]
    assert found == pytest.approx(PLATES[cells], rel=2e-5)


def test_plates_tend_to_the_exact_ones() -> None:
    exact = (0.004062352661, 0.001265319087, 0.0116008)
    coarse, fine = (np.abs(np.array(PLATES[cells][:3]) - exact) / exact for cells in (8, 16))
    assert (fine < 0.5 * coarse).all()


@pytest.mark.parametrize("curvature", [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (1.0, -2.0, 0.7)])
def test_constant_curvature_patch(curvature: tuple[float, float, float]) -> None:
    """w = a x^2/2 + b y^2/2 + c x y: no residual inside, and the exact energy."""
    a, b, c = curvature
    points, triangles = irregular()
    x, y = points.T
    state = np.column_stack([0.5 * a * x**2 + 0.5 * b * y**2 + c * x * y, b * y + c * x, -a * x - c * y])
    stiffness = assembled(points, triangles, 0.3)
    residual = (stiffness @ state.ravel()).reshape(-1, 3)
    inner = np.abs(points).max(axis=1) < 0.49
    assert np.abs(residual[inner]).max() < 1e-12
    kappa = np.array([a, b, 2.0 * c])
    exact = 0.5 * kappa @ dkt.bending_law(0.3) @ kappa
    assert 0.5 * state.ravel() @ stiffness @ state.ravel() == pytest.approx(exact, rel=1e-12)


def test_twisted_square() -> None:
    """Held on three corners, pushed on the fourth: w = P L^2 / (2 D (1 - nu)) on any mesh."""
    points, triangles = irregular()
    corners = [nearest(points, *corner) for corner in ((-0.5, -0.5), (0.5, -0.5), (-0.5, 0.5), (0.5, 0.5))]
    fixed = np.zeros((len(points), 3), dtype=bool)
    fixed[corners[:3], 0] = True
    load = np.zeros(len(points))
    load[corners[3]] = 1.0
    deflection = solved(assembled(points, triangles, 0.3), load, fixed)[corners[3], 0]
    assert deflection == pytest.approx(1.0 / (2.0 * 0.7), rel=1e-10)


def test_rotation_stiffness_is_the_plate_without_deflections() -> None:
    corners = np.array([[[0.1, 0.2], [1.3, 0.1], [0.4, 0.9]]])
    plate = dkt.plate_stiffness(corners, 0.25)[0]
    rotations = [1, 2, 4, 5, 7, 8]
    # theta_x = -beta_y, theta_y = beta_x
    turn = np.kron(np.eye(3), [[0.0, -1.0], [1.0, 0.0]])
    reduced = turn.T @ plate[np.ix_(rotations, rotations)] @ turn
    assert dkt.rotation_stiffness(corners, 0.25)[0] == pytest.approx(reduced, abs=1e-12)


def deflection_in_shell(
    solver: Backend, points: Floats, triangles: Ints, fixed: Bools, load: Floats, at: int
) -> float:
    """Deflection per load of the film under small nodal loads, without pressure; E t = D = 1."""
    small = 1e-5
    loads = np.zeros((len(points), 3))
    loads[:, 2] = small * load
    problem = FilmProblem(points, triangles, fixed, 1.0, 0.3, 1.0, 0.0, loads)
    state = solver.solve(problem, Start(*flat_state(points), (1.0,)), NewtonSettings(1e-12), no_progress)
    assert state.converged
    return float(state.positions[at, 2]) / small


@pytest.mark.parametrize("cells", [2, 4, 8])
@both_solvers
def test_shell_is_the_clamped_plate(solver: Backend, cells: int) -> None:
    """The directors give the same numbers as the element's own deflections."""
    points, triangles = full_grid(cells)
    fixed = held(len(points), moves="xy")
    fixed[np.abs(points).max(axis=1) == 0.5] = True
    centre = nearest(points, 0.0, 0.0)
    peak = np.zeros(len(points))
    peak[centre] = 1.0
    for load, reference in ((vertex_areas(points, triangles), 1), (peak, 3)):
        found = deflection_in_shell(solver, points, triangles, fixed, load, centre)
        assert found == pytest.approx(PLATES[cells][reference], rel=2e-5)


@both_solvers
def test_shell_is_the_twisted_square(solver: Backend) -> None:
    points, triangles = irregular()
    fixed = held(len(points), moves="xy")
    for corner in ((-0.5, -0.5), (0.5, -0.5), (-0.5, 0.5)):
        fixed[nearest(points, *corner), 2] = True
    load = np.zeros(len(points))
    pushed = nearest(points, 0.5, 0.5)
    load[pushed] = 1.0
    found = deflection_in_shell(solver, points, triangles, fixed, load, pushed)
    assert found == pytest.approx(1.0 / (2.0 * 0.7), rel=1e-6)


@pytest.mark.parametrize(
    ("clamped", "even", "exact"),
    [(True, True, 1.0 / 64.0), (False, True, 0.063702), (True, False, 1.0 / (16.0 * np.pi))],
    ids=["clamped q", "supported q", "clamped P"],
)
@both_solvers
def test_disc_plates(solver: Backend, clamped: bool, even: bool, exact: float) -> None:
    disc = panel("disc", 400)
    points = disc.rest_positions
    fixed = held(len(points), moves="xy")
    fixed[disc.loops[0], 2] = True
    fixed[disc.loops[0], 3:] = clamped
    centre = nearest(points, 0.0, 0.0)
    load = vertex_areas(points, disc.triangles) if even else np.eye(len(points))[centre]
    found = deflection_in_shell(solver, points, disc.triangles, fixed, load, centre)
    assert found == pytest.approx(exact, rel=0.005)

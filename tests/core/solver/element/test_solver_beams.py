# SPDX-License-Identifier: LGPL-2.1-or-later
"""Strips of film against beam theory: with tension, with wrinkles, rolled up."""

from itertools import pairwise

import numpy as np
import pytest
from solver_cases import both_solvers, flat_state, grid, held

from BalloonWorkbench.core.solver.backend import Backend
from BalloonWorkbench.core.solver.element.shell import Shell, tangent_frames
from BalloonWorkbench.core.solver.equilibrium import newton
from BalloonWorkbench.core.solver.problem import FilmProblem, NewtonSettings, Start
from BalloonWorkbench.core.types import no_progress


@both_solvers
def test_stretched_cantilever_deflects_like_a_beam_with_tension(solver: Backend) -> None:
    """Clamped strip, nu = 0, tip forces T along and P across: w = P / T (L - tanh(a L) / a).

    a^2 = T / (D b) with the width b.
    """
    points, triangles = grid(32, 2, 1.0, 0.25)
    rigidity, tension, load = 1e-3, 2e-3, 1e-7
    fixed = held(len(points), moves="y")
    fixed[points[:, 0] == 0.0] = True
    loads = np.zeros((len(points), 3))
    tip = points[:, 0] == 1.0
    share = np.array([0.25, 0.5, 0.25])[:, None]  # of the forces at the three vertices of the tip
    loads[tip] = share * (tension, 0.0, load)
    problem = FilmProblem(points, triangles, fixed, 10.0, 0.0, rigidity, 0.0, loads)
    state = solver.solve(problem, Start(*flat_state(points), (10.0,)), NewtonSettings(1e-13), no_progress)
    assert state.converged
    a = np.sqrt(tension / (0.25 * rigidity))
    deflection = load / tension * (1.0 - np.tanh(a) / a)
    assert state.positions[tip, 2].mean() == pytest.approx(deflection, rel=0.003)


def test_wrinkled_beam() -> None:
    """A stretched strip bent in its plane (Stein & Hedgepeth 1961): tension and moment with half of it slack.

    The ends turn by +-1e-4, the film between them finds its own shape.
    """
    points, triangles = grid(24, 16, 1.5, 1.0)
    points = points - (0.75, 0.5)
    x, y = points.T
    kappa_hat = 4.0  # E t h^2 kappa / (2 P)
    # for E t = h = 1: tension and moment of a strip whose strain is max(0, strain + curvature y)
    curvature = 1e-4
    force = curvature / (2.0 * kappa_hat)
    strain = np.sqrt(2.0 * force * curvature) - 0.5 * curvature
    assert abs(strain) < 0.5 * curvature  # part of the film is slack
    ends = np.abs(x) == 0.75
    fixed = held(len(points), moves="z", turns=True)
    fixed[ends] = True
    start, directors = flat_state(points)
    start[:, 0] += strain * x + curvature * x * y
    start[:, 1] -= 0.5 * curvature * x**2
    shaken = start + np.where(
        ends[:, None], 0.0, 1e-6 * np.random.default_rng(5).standard_normal(start.shape)
    )
    shaken[:, 2] = 0.0
    problem = FilmProblem(points, triangles, fixed, 1.0, 0.0, 1e-12, 0.0)
    state = newton.solve(problem, Start(shaken, directors, (1.0,)), NewtonSettings(1e-9))
    assert state.converged
    free = FilmProblem(points, triangles, held(len(points)), 1.0, 0.0, 1e-12, 0.0)
    pull = Shell(free).derivatives(state.positions, state.directors, tangent_frames(state.directors))[0]
    right = x == 0.75
    along = pull.reshape(-1, 5)[right, 0]
    assert along.sum() == pytest.approx(force, rel=0.02)
    assert 2.0 * (along @ y[right]) / along.sum() == pytest.approx(
        1.0 - 2.0 / 3.0 / np.sqrt(kappa_hat), rel=0.02
    )


def test_full_circle_of_a_bent_strip() -> None:
    """A strip rolled into a circle, nu = 0: energy D b (2 pi)^2 / (2 L) and end moment 2 pi D b / L.

    The positions are given: a film without tension has nothing that keeps its length.
    """
    errors = []
    for cells in (20, 40, 80):
        points, triangles = grid(cells, 2, 1.0, 0.2)
        turn = 2.0 * np.pi * points[:, 0]
        rolled = np.column_stack([np.sin(turn), 2.0 * np.pi * points[:, 1], 1.0 - np.cos(turn)]) / (
            2.0 * np.pi
        )
        normals = np.column_stack([-np.sin(turn), np.zeros_like(turn), np.cos(turn)])
        ends = (points[:, 0] == 0.0) | (points[:, 0] == 1.0)
        fixed = held(len(points), moves="xyz")
        fixed[ends, 3:] = True
        problem = FilmProblem(points, triangles, fixed, 1.0, 0.0, 1.0, 0.0)
        state = newton.solve(problem, Start(rolled, normals, (1.0,)), NewtonSettings(1e-12))
        bending = newton.energies(problem, state.positions, state.directors).bending
        # the moment is what turns the directors of one end
        frames = tangent_frames(state.directors)
        free = FilmProblem(points, triangles, held(len(points), moves="xyz"), 1.0, 0.0, 1.0, 0.0)
        slope = Shell(free).derivatives(state.positions, state.directors, frames)[0].reshape(-1, 2)
        end = points[:, 0] == 1.0
        moment = np.einsum("nij,nj->ni", frames[end], slope[end])[:, 0].sum()
        exact = 0.2 * (2.0 * np.pi) ** 2
        errors.append((abs(bending / (0.5 * exact) - 1.0), abs(-moment / (0.2 * 2.0 * np.pi) - 1.0)))
    assert max(errors[-1]) < 0.002
    for coarse, fine in pairwise(errors):
        assert fine == pytest.approx(np.array(coarse) / 4.0, rel=0.1)

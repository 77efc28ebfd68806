# SPDX-License-Identifier: LGPL-2.1-or-later
"""A disc of film whose rim is held in place: under tension everywhere, so without wrinkles."""

import numpy as np
import pytest
from solver_cases import both_solvers, held, panel

from BalloonWorkbench.core.solver.backend import Backend
from BalloonWorkbench.core.solver.element.dkt import gradients
from BalloonWorkbench.core.solver.element.kinematics import deformation_gradients, green_strains
from BalloonWorkbench.core.solver.element.membrane import principal_tensions
from BalloonWorkbench.core.solver.problem import FilmProblem, NewtonSettings, Start
from BalloonWorkbench.core.solver.start import vertex_normals
from BalloonWorkbench.core.types import no_progress


@both_solvers
def test_hencky_disc(solver: Backend) -> None:
    """Clamped disc under pressure, small slopes, nu = 0.3 (Hencky 1915): its centre."""
    disc, stiffness = panel("disc"), 1e5
    rest, rim = disc.rest_positions, disc.loops[0]
    fixed = held(len(rest))
    fixed[rim, :3] = True
    deflection = 0.653443 * stiffness ** (-1.0 / 3.0)
    start = np.column_stack([rest, deflection * (1.0 - (rest**2).sum(axis=1))])
    start[rim, 2] = 0.0
    problem = FilmProblem(rest, disc.triangles, fixed, stiffness, 0.3, 1e-9)
    state = solver.solve(
        problem, Start(start, vertex_normals(start, disc), (stiffness,)), NewtonSettings(1e-10), no_progress
    )
    assert state.converged
    assert state.positions[:, 2].max() == pytest.approx(deflection, rel=0.001)
    corners = rest[disc.triangles]
    strains = green_strains(deformation_gradients(state.positions, disc.triangles, gradients(corners)[0]))
    tensions = principal_tensions(strains, stiffness, 0.3)
    assert tensions.min() > 0.0
    centre = np.linalg.norm(corners.mean(axis=1), axis=1) < 0.1
    assert tensions[centre].mean() == pytest.approx(0.431101 * stiffness ** (1.0 / 3.0), rel=0.005)

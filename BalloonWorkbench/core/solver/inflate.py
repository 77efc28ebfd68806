# SPDX-License-Identifier: LGPL-2.1-or-later
"""Inflate a panel: from SI numbers to the dimensionless problem and back."""

from __future__ import annotations

import time

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.solver import start as starts
from BalloonWorkbench.core.solver.backend import Backend, backend_named
from BalloonWorkbench.core.solver.element.dkt import gradients
from BalloonWorkbench.core.solver.element.kinematics import deformation_gradients, film_volume, green_strains
from BalloonWorkbench.core.solver.element.membrane import principal_stresses
from BalloonWorkbench.core.solver.inflation import Inflation, SolveReport
from BalloonWorkbench.core.solver.model import Model, film_problem, stiffness_levels
from BalloonWorkbench.core.solver.problem import NewtonSettings
from BalloonWorkbench.core.solver.split_along_welds import slit
from BalloonWorkbench.core.types import Progress, no_progress
from BalloonWorkbench.core.units import pressure_text

#: The lower half is the upper one mirrored in the plane of the seam.
MIRROR = np.array([1.0, 1.0, -1.0])

#: Pressures [Pa] with which the numbers of a balloon stay numbers.
_LEAST, _MOST = 1e-6, 1e8


def inflate(
    panel: Panel,
    film: Film,
    pressure: float,
    *,
    start: Inflation | None = None,
    backend: str | Backend | None = None,
    progress: Progress = no_progress,
    settings: NewtonSettings | None = None,
    model: Model | None = None,
) -> Inflation:
    """The balloon of two equal panels sealed along their seams, under an overpressure [Pa].

    start   an earlier result on a panel of the same connectivity: skips the continuation
    backend "native", "numpy" or None for the best one available; "newmark" blows the balloon up in time
    model   what is simulated, for comparisons

    A seal_width of 0 leaves the rim without the stiffness of a sealed band. A solve that uses up its steps
    gives the best state with report.converged False. Raises InputError for a pressure that is not positive,
    Cancelled when progress returns False.
    """
    if not _LEAST <= pressure <= _MOST:
        raise InputError(
            f"The pressure must be positive and at most {pressure_text(_MOST)}, not"
            f" {pressure_text(pressure)}. "
            "A party balloon has about 2 kPa."
        )
    model = model or Model()
    solver = backend_named(backend)
    began = time.perf_counter()
    size = float(np.ptp(panel.rest_positions, axis=0).max())
    upper, faces = len(panel.rest_positions), len(panel.triangles)
    flat, origin = slit(panel)
    problem = film_problem(flat, film, pressure, model, origin)
    stiffness_k = problem.membrane_stiffness
    if start is None or len(start.positions) != upper:
        positions = starts.dome(flat) / size
        directors = starts.vertex_normals(positions, flat)
        levels = stiffness_levels(stiffness_k)
    else:
        moved, softening = starts.carried_over(start, panel)
        positions = moved[origin] / size
        directors = np.concatenate([start.directors, starts.vertex_normals(positions, flat)[upper:]])
        levels = tuple(stiffness_k / factor for factor in softening)
    if model.two_panels:
        positions, directors = (np.concatenate([half, half * MIRROR]) for half in (positions, directors))
        x, y = (positions - positions.mean(axis=0))[:, :2].T
        positions[:, 2] += model.twist * x * y
        assert problem.tied is not None
        positions = positions[problem.tied]  # the seam of an earlier result is not quite in the plane
    rest = solver.solve(problem, positions, directors, levels, settings or NewtonSettings(), progress)

    energies = solver.energies(problem, rest.positions, rest.directors)
    report = SolveReport(
        solver.name,
        rest.steps,
        rest.factorisations,
        time.perf_counter() - began,
        rest.converged,
        stiffness_k,
        problem.flexural_rigidity * pressure * size**3,
        energies.bending / max(-energies.pressure, 1e-300),
        pressure,
        model,
    )
    shape, _ = gradients(problem.rest_positions[problem.triangles])
    strains = green_strains(deformation_gradients(rest.positions, problem.triangles, shape))
    halves = 1.0 if model.two_panels else 2.0
    return Inflation(
        panel,
        rest.positions[:upper] * size,
        rest.directors[:upper],
        film.membrane_stiffness * principal_stresses(problem.membrane(strains).stress)[:faces],
        halves * film_volume(rest.positions, rest.directors, problem.triangles) * size**3,
        report,
        rest.positions[len(origin) :][:upper] * size if model.two_panels else None,
    )

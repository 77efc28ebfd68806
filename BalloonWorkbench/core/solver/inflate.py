# SPDX-License-Identifier: LGPL-2.1-or-later
"""Inflate a panel: from SI numbers to the dimensionless problem and back."""

from __future__ import annotations

import time

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.mesh.panel import Panel
from BalloonWorkbench.core.solver import start as starts
from BalloonWorkbench.core.solver.backend import backend_named
from BalloonWorkbench.core.solver.dkt import gradients
from BalloonWorkbench.core.solver.inflation import Inflation, SolveReport
from BalloonWorkbench.core.solver.kinematics import deformation_gradients, film_volume, green_strains
from BalloonWorkbench.core.solver.membrane import principal_tensions
from BalloonWorkbench.core.solver.problem import FilmProblem, NewtonSettings
from BalloonWorkbench.core.types import Progress, no_progress

#: Smallest flexural rigidity, in p w^3 with w the typical width of the panel: below it the step count grows
#: with the mesh and nothing visible changes.
BENDING_FLOOR = 1e-6
#: In-plane rigidity of the sealed band, in p w^4: below the floor the rim folds at mesh scale; above the
#: ceiling the band itself would wrinkle, which no beam shows.
SEAM_FLOOR = 1e-6
SEAM_CEILING = 1e-5
#: The continuation begins with a film this soft and grows by this factor.
SOFTEST = 6.0
STIFFENING = 5.0


def inflate(
    panel: Panel,
    film: Film,
    pressure: float,
    *,
    start: Inflation | None = None,
    backend: str | None = None,
    progress: Progress = no_progress,
    settings: NewtonSettings | None = None,
    bending_floor: float = BENDING_FLOOR,
) -> Inflation:
    """The balloon of two equal panels sealed along their seams, under an overpressure [Pa].

    start   an earlier result on a panel of the same connectivity: skips the continuation
    backend "native", "numpy" or None for the best one available

    A seal_width of 0 leaves the rim without the stiffness of a sealed band. A solve that uses up its steps
    gives the best state with report.converged False. Raises InputError for a pressure that is not positive,
    Cancelled when progress returns False.
    """
    if not (np.isfinite(pressure) and pressure > 0.0):
        raise InputError(f"The pressure must be positive, not {pressure:g} Pa. A party balloon has about 2 kPa.")
    solver = backend_named(backend)
    began = time.perf_counter()
    size = float(np.ptp(panel.rest_positions, axis=0).max())
    problem = film_problem(panel, film, pressure, bending_floor)
    stiffness_k = problem.membrane_stiffness
    if start is None or len(start.positions) != len(panel.rest_positions):
        positions = starts.dome(panel) / size
        directors = starts.vertex_normals(positions, panel)
        levels = stiffness_levels(stiffness_k)
    else:
        positions, directors = start.positions / size, start.directors
        levels = (stiffness_k,)
    rest = solver.solve(problem, positions, directors, levels, settings or NewtonSettings(), progress)

    shape, _ = gradients(problem.rest_positions[panel.triangles])
    strains = green_strains(deformation_gradients(rest.positions, panel.triangles, shape))
    report = SolveReport(
        solver.name,
        rest.steps,
        rest.factorisations,
        time.perf_counter() - began,
        rest.converged,
        stiffness_k,
        problem.flexural_rigidity * pressure * size**3,
    )
    return Inflation(
        panel,
        rest.positions * size,
        rest.directors,
        principal_tensions(strains, film.membrane_stiffness, film.poisson_ratio),
        2.0 * film_volume(rest.positions, rest.directors, panel.triangles) * size**3,
        report,
    )


def film_problem(panel: Panel, film: Film, pressure: float, bending_floor: float = BENDING_FLOOR) -> FilmProblem:
    """The dimensionless problem of the upper panel: rim held in z = 0, free in the plane, directors free."""
    size = float(np.ptp(panel.rest_positions, axis=0).max())
    fixed = np.zeros((len(panel.rest_positions), 5), dtype=bool)
    for seam in panel.seams:
        fixed[seam, 2] = True
    width = typical_width(panel)
    seam_rigidity = 0.0
    if film.seal_width > 0.0:
        band = 2.0 * film.membrane_stiffness * film.seal_width**3 / 12.0
        relative = band / (pressure * width**4)
        seam_rigidity = min(max(relative, SEAM_FLOOR), SEAM_CEILING) * (width / size) ** 4
    return FilmProblem(
        panel.rest_positions / size,
        panel.triangles,
        fixed,
        film.membrane_stiffness / (pressure * size),
        film.poisson_ratio,
        max(film.flexural_rigidity / (pressure * size**3), bending_floor * (width / size) ** 3),
        seams=panel.seams,
        seam_rigidity=seam_rigidity,
    )


def typical_width(panel: Panel) -> float:
    """Four times the area by the length of the seams [m]: diameter of a disc, side of a square."""
    _, areas = gradients(panel.rest_positions[panel.triangles])
    length = sum(
        float(np.linalg.norm(panel.rest_positions[np.roll(seam, -1)] - panel.rest_positions[seam], axis=1).sum())
        for seam in panel.seams
    )
    return 4.0 * float(areas.sum()) / length


def stiffness_levels(stiffness: float) -> tuple[float, ...]:
    """Membrane stiffnesses from soft to the film's own, in nearly equal ratios of at most STIFFENING."""
    if stiffness <= SOFTEST:
        return (stiffness,)
    count = int(np.ceil(np.log(stiffness / SOFTEST) / np.log(STIFFENING) - 1e-9))
    return tuple(float(value) for value in SOFTEST * (stiffness / SOFTEST) ** (np.arange(count + 1) / count))

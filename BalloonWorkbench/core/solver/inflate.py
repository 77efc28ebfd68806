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
from BalloonWorkbench.core.types import Floats, Ints, Progress, no_progress

#: Smallest flexural rigidity, in p w^3 with w the typical width of the panel: below it the step count grows
#: with the mesh and nothing visible changes.
BENDING_FLOOR = 1e-6
#: In-plane rigidity of the sealed band, in p w^4. Along the outline it crumples with the film: below the
#: floor the rim folds at mesh scale; above the ceiling the band itself would wrinkle, which no beam shows.
SEAM_FLOOR = 1e-6
SEAM_CEILING = 1e-5
#: Round a hole the film pulls the band taut, so that it keeps all of its rigidity. Without it a ring is
#: unstable: a curved tube wants to curve more (Siefert et al., PNAS 116 (2019) 16692), a closed one kinks.
HOLE_FLOOR = 1e-3
#: The continuation begins with a film this soft and grows by this factor.
SOFTEST = 6.0
STIFFENING = 5.0
#: A warm start is stretched by this: a slack film has no stiffness to start from.
WARM_STRETCH = 1.08


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
        raise InputError(
            f"The pressure must be positive, not {pressure:g} Pa. A party balloon has about 2 kPa."
        )
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
        positions, directors = _stretched(start, panel) / size, start.directors
        levels = tuple(stiffness_k / 3.0**step for step in (3, 2, 1, 0))
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


def _stretched(start: Inflation, panel: Panel) -> Floats:
    """Positions (n, 3) of an earlier result, moved with the panel and stretched until nothing is slack."""
    positions = start.positions.copy()
    positions[:, :2] += panel.rest_positions - start.panel.rest_positions
    centre = positions.mean(axis=0) * (1.0, 1.0, 0.0)
    return centre + WARM_STRETCH * (positions - centre)


def film_problem(
    panel: Panel, film: Film, pressure: float, bending_floor: float = BENDING_FLOOR
) -> FilmProblem:
    """The dimensionless problem of the upper panel: rim held in z = 0, free in the plane, directors free."""
    size = float(np.ptp(panel.rest_positions, axis=0).max())
    fixed = np.zeros((len(panel.rest_positions), 5), dtype=bool)
    for seam in panel.seams:
        fixed[seam, 2] = True
    width = typical_width(panel)
    seams: tuple[Ints, ...] = ()
    seam_rigidities: tuple[float, ...] = ()
    if film.seal_width > 0.0:
        band = 2.0 * film.membrane_stiffness * film.seal_width**3 / 12.0
        relative = band / (pressure * width**4)
        outer, hole = min(max(relative, SEAM_FLOOR), SEAM_CEILING), max(relative, HOLE_FLOOR)
        seams = panel.seams
        seam_rigidities = tuple(
            rigidity * (width / size) ** 4 for rigidity in (outer, *[hole] * (len(panel.seams) - 1))
        )
    return FilmProblem(
        panel.rest_positions / size,
        panel.triangles,
        fixed,
        film.membrane_stiffness / (pressure * size),
        film.poisson_ratio,
        max(film.flexural_rigidity / (pressure * size**3), bending_floor * (width / size) ** 3),
        seams=seams,
        seam_rigidities=seam_rigidities,
    )


def typical_width(panel: Panel) -> float:
    """Four times the area by the length of the seams [m]: diameter of a disc, side of a square."""
    _, areas = gradients(panel.rest_positions[panel.triangles])
    loops = [panel.rest_positions[seam] for seam in panel.seams]
    length = sum(float(np.linalg.norm(np.roll(loop, -1, axis=0) - loop, axis=1).sum()) for loop in loops)
    return 4.0 * float(areas.sum()) / length


def stiffness_levels(stiffness: float) -> tuple[float, ...]:
    """Membrane stiffnesses from soft to the film's own, in nearly equal ratios of at most STIFFENING."""
    if stiffness <= SOFTEST:
        return (stiffness,)
    count = int(np.ceil(np.log(stiffness / SOFTEST) / np.log(STIFFENING) - 1e-9))
    return tuple(float(value) for value in SOFTEST * (stiffness / SOFTEST) ** (np.arange(count + 1) / count))

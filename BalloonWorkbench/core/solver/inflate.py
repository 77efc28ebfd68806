# SPDX-License-Identifier: LGPL-2.1-or-later
"""Inflate a balloon: from SI numbers to the dimensionless problem and back."""

from __future__ import annotations

import time
from dataclasses import replace

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.panels.assembly import Assembly
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.solver.backend import Backend, backend_named
from BalloonWorkbench.core.solver.element.dkt import gradients
from BalloonWorkbench.core.solver.element.kinematics import deformation_gradients, film_volume, green_strains
from BalloonWorkbench.core.solver.element.membrane import principal_stresses
from BalloonWorkbench.core.solver.inflation import MIRROR, Inflation, SolveReport
from BalloonWorkbench.core.solver.model import Model, problem_of, simulated, split_for
from BalloonWorkbench.core.solver.problem import Equilibrium, FilmProblem, NewtonSettings
from BalloonWorkbench.core.solver.start import start_of, vertex_normals
from BalloonWorkbench.core.types import Floats, Progress, no_progress
from BalloonWorkbench.core.units import pressure_text

__all__ = ["MIRROR", "inflate"]

#: What is free in space warps and turns slowly, and no seam in a plane tells when it stays.
_IN_SPACE = NewtonSettings(tolerance=1e-7)
#: Pressures [Pa] with which the numbers of a balloon stay numbers.
_LEAST, _MOST = 1e-6, 1e8


def inflate(
    body: Panel | Assembly,
    film: Film,
    pressure: float,
    *,
    start: Inflation | Floats | None = None,
    backend: str | Backend | None = None,
    progress: Progress = no_progress,
    settings: NewtonSettings | None = None,
    model: Model | None = None,
) -> Inflation:
    """The balloon of panels sealed to each other, under an overpressure [Pa].

    body    an assembly; a panel stands for two equal ones sealed along their boundaries and welds
    start   an earlier result on panels of the same connectivity, which skips the continuation, or places
            (n, 3) [m] of the vertices of an assembly
    backend "native", "numpy" or None for the best one available; "newmark" blows the balloon up in time
    model   what is simulated, for comparisons

    A seal_width of 0 leaves seams without the stiffness of a sealed band, which seams in space never have. A
    solve that uses up its steps gives the best state with report.converged False. Raises InputError for a
    pressure that is not positive or panels that do not fit, Cancelled when progress returns False.
    """
    model, solver, began = model or Model(), backend_named(backend), time.perf_counter()
    whole = Assembly.mirrored(body) if isinstance(body, Panel) else body
    assembly = simulated(whole, model)
    _check(pressure, solver, assembly)
    split, size = split_for(assembly, film, model), assembly.size
    problem = problem_of(split, film, pressure, model)
    first = start_of(split, problem, start, model.twist)
    rest = solver.solve(problem, first, settings or _settings(assembly), progress)
    rest = rest if assembly.mirror else _laid_over(rest, first.positions)
    if not (assembly.mirror or model.bending):  # nothing has turned the directors
        rest = replace(rest, directors=vertex_normals(rest.positions, problem))
    energies = solver.energies(problem, rest.positions, rest.directors)
    report = SolveReport(
        backend=solver.name,
        newton_steps=rest.steps,
        factorisations=rest.factorisations,
        seconds=time.perf_counter() - began,
        converged=rest.converged,
        stiffness_k=problem.membrane_stiffness,
        flexural_rigidity=problem.flexural_rigidity * pressure * size**3,
        bending_share=energies.bending / max(-energies.pressure, 1e-300),
        pressure=pressure,
        model=model,
        banded=problem.hinges is not None,
    )
    count, faces = int(whole.offsets[-1]), sum(len(panel.triangles) for panel in whole.panels)
    volume = film_volume(rest.positions, rest.directors, problem.triangles)
    places = rest.positions[split.own] * size
    return Inflation(
        whole,
        places[:count],
        rest.directors[split.own][:count],
        film.membrane_stiffness * _principal_stresses(problem, rest.positions)[:faces],
        (2.0 if assembly.mirror else 1.0) * volume * size**3,
        report,
        places[count:] if whole is not assembly else None,
    )


def _settings(assembly: Assembly) -> NewtonSettings:
    """When a solve ends as usual: later for what is free in space."""
    return NewtonSettings() if assembly.mirror else _IN_SPACE


def _check(pressure: float, solver: Backend, assembly: Assembly) -> None:
    if not _LEAST <= pressure <= _MOST:
        raise InputError(
            f"The pressure must be positive and at most {pressure_text(_MOST)}, not"
            f" {pressure_text(pressure)}. "
            "A party balloon has about 2 kPa."
        )
    if solver.name == "newmark" and not (assembly.mirror or assembly.is_pair):
        raise InputError("Only two equal panels are blown up in time. Use another solver for this balloon.")


def _principal_stresses(problem: FilmProblem, positions: Floats) -> Floats:
    shape, _ = gradients(problem.rest_positions[problem.triangles])
    strains = green_strains(deformation_gradients(positions, problem.triangles, shape))
    return principal_stresses(problem.membrane(strains).stress)


def _laid_over(rest: Equilibrium, start: Floats) -> Equilibrium:
    """A balloon that is free in space, moved and turned as a whole to where it began (Kabsch 1976)."""
    middle = rest.positions.mean(axis=0)
    left, _, right = np.linalg.svd((rest.positions - middle).T @ (start - start.mean(axis=0)))
    left[:, 2] *= np.linalg.det(left @ right)
    turn = left @ right
    return replace(
        rest,
        positions=(rest.positions - middle) @ turn + start.mean(axis=0),
        directors=rest.directors @ turn,
    )

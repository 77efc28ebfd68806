# SPDX-License-Identifier: LGPL-2.1-or-later
"""Inflate a balloon: from SI numbers to the dimensionless problem and back."""

from __future__ import annotations

import time
from dataclasses import replace

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.geometry.rigid import turn_onto
from BalloonWorkbench.core.panels.assembly import Assembly
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.solver.backend import Backend, backend_named
from BalloonWorkbench.core.solver.element.dkt import gradients
from BalloonWorkbench.core.solver.element.kinematics import deformation_gradients, film_volume, green_strains
from BalloonWorkbench.core.solver.element.membrane import principal_stresses
from BalloonWorkbench.core.solver.inflation import MIRROR, Inflation, SolveReport
from BalloonWorkbench.core.solver.lift import Lift, characteristic_pressure, upright, with_lift
from BalloonWorkbench.core.solver.model import Model, problem_of, simulated, split_for
from BalloonWorkbench.core.solver.problem import Energies, Equilibrium, FilmProblem, NewtonSettings, Start
from BalloonWorkbench.core.solver.split_along_welds import SplitFilm
from BalloonWorkbench.core.solver.start import start_of, vertex_normals
from BalloonWorkbench.core.types import Floats, Progress, no_progress
from BalloonWorkbench.core.units import pressure_text

__all__ = ["MIRROR", "inflate"]

#: Two panels that are free in space warp slowly, and no seam in a plane tells when they stay.
_IN_SPACE = NewtonSettings(tolerance=1e-7)
#: Pressures [Pa] with which the numbers of a balloon stay numbers.
_LEAST, _MOST = 1e-6, 1e8


def inflate(  # noqa: PLR0913 - all but three have a default
    body: Panel | Assembly,
    film: Film,
    pressure: float,
    *,
    start: Inflation | Floats | None = None,
    backend: str | Backend | None = None,
    progress: Progress = no_progress,
    settings: NewtonSettings | None = None,
    model: Model | None = None,
    lift: Lift | None = None,
) -> Inflation:
    """The balloon of panels sealed to each other, under an overpressure [Pa].

    body    an assembly; a panel stands for two equal ones sealed along their boundaries and welds
    start   an earlier result on panels of the same connectivity, which skips the continuation, or places
            (n, 3) [m] of the vertices of an assembly
    backend "native", "numpy" or None for the best one available; "newmark" blows the balloon up in time
    model   what is simulated, for comparisons
    lift    makes the pressure grow upwards from what holds the balloon, where it may be 0 then

    A seal_width of 0 leaves seams without the stiffness of a sealed band. A solve that uses up its steps
    gives the best state with report.converged False. Raises InputError for a pressure that is not positive or
    panels that do not fit, Cancelled when progress returns False.
    """
    model, solver, began = model or Model(), backend_named(backend), time.perf_counter()
    whole = Assembly.mirrored(body) if isinstance(body, Panel) else body
    assembly = simulated(whole, model)
    scale = characteristic_pressure(pressure, lift, assembly.size)
    _check(scale)
    split, size = split_for(assembly, film, model), assembly.size
    problem = problem_of(split, film, scale, model)
    first = start_of(split, problem, start, model.twist)
    if lift is not None:
        problem, first = _lifted(problem, split, pressure, lift, first, standing=start is not None)
    rest = solver.solve(problem, first, settings or _settings(assembly), progress)
    if not assembly.mirror:
        rest = _settled(rest, first, problem, moved=lift is None, turned=model.bending)
    report = SolveReport(
        backend=solver.name,
        newton_steps=rest.steps,
        factorisations=rest.factorisations,
        seconds=time.perf_counter() - began,
        converged=rest.converged,
        stiffness_k=problem.membrane_stiffness,
        flexural_rigidity=problem.flexural_rigidity * scale * size**3,
        bending_share=_bending_share(solver.energies(problem, rest.positions, rest.directors)),
        pressure=pressure,
        model=model,
        banded=problem.hinges is not None,
        lift=lift,
    )
    return _inflation(whole, split, problem, rest, film, report)


def _inflation(
    whole: Assembly,
    split: SplitFilm,
    problem: FilmProblem,
    rest: Equilibrium,
    film: Film,
    report: SolveReport,
) -> Inflation:
    """In SI units and for the vertices of the assembly that was given."""
    assembly, size = split.assembly, split.assembly.size
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


def _bending_share(energies: Energies) -> float:
    return energies.bending / max(-energies.pressure, 1e-300)


def _lifted(
    problem: FilmProblem, split: SplitFilm, pressure: float, lift: Lift, first: Start, *, standing: bool
) -> tuple[FilmProblem, Start]:
    """The problem with lift and where it begins, put upright where nobody said how it stands."""
    if pressure < 0.0:
        raise InputError("The pressure at the lower end must be 0 or more.")
    lift.check(split.assembly)
    if not standing:
        positions = upright(first.positions, lift.places(split))
        first = replace(first, positions=positions, directors=vertex_normals(positions, problem))
    return with_lift(problem, split, pressure, lift, first.positions), first


def _settings(assembly: Assembly) -> NewtonSettings:
    """When a solve ends as usual: later for two panels that are free in space."""
    return _IN_SPACE if assembly.is_pair else NewtonSettings()


def _check(pressure: float) -> None:
    if not _LEAST <= pressure <= _MOST:
        raise InputError(
            f"The pressure must be positive and at most {pressure_text(_MOST)}, not"
            f" {pressure_text(pressure)}. "
            "A party balloon has about 2 kPa."
        )


def _principal_stresses(problem: FilmProblem, positions: Floats) -> Floats:
    shape, _ = gradients(problem.rest_positions[problem.triangles])
    strains = green_strains(deformation_gradients(positions, problem.triangles, shape))
    return principal_stresses(problem.membrane(strains).stress)


def _settled(
    rest: Equilibrium, first: Start, problem: FilmProblem, *, moved: bool, turned: bool
) -> Equilibrium:
    """A body in space laid over its start where it has moved; normals where nothing turned its directors."""
    rest = _laid_over(rest, first.positions) if moved else rest
    return rest if turned else replace(rest, directors=vertex_normals(rest.positions, problem))


def _laid_over(rest: Equilibrium, start: Floats) -> Equilibrium:
    """A balloon that is free in space, moved and turned as a whole to where it began."""
    turn = turn_onto(rest.positions, start)
    return replace(
        rest,
        positions=(rest.positions - rest.positions.mean(axis=0)) @ turn + start.mean(axis=0),
        directors=rest.directors @ turn,
    )

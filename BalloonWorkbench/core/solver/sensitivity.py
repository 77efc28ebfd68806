# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a balloon at rest moves when its flat film does: the derivative of the inflated by the flat shape.

At rest the forces g(x, X) of the film vanish, whatever its rest positions X: dx = -K^-1 (dg/dX) dX with the
Hessian K of the energy. Held constant: the pressure, the rigidities of film and sealed band, whose floors
follow from the size and width of the panels, and the size itself.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.solver.backend import Backend, backend_named
from BalloonWorkbench.core.solver.element.rest_derivatives import force_changes
from BalloonWorkbench.core.solver.element.shell import Shell, tangent_frames
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.lift import with_lift
from BalloonWorkbench.core.solver.model import problem_of, simulated, split_for
from BalloonWorkbench.core.solver.problem import FilmProblem, NewtonSettings, Start, TangentSolution
from BalloonWorkbench.core.solver.split_along_welds import SplitFilm
from BalloonWorkbench.core.solver.start import vertex_normals
from BalloonWorkbench.core.types import Floats, no_progress

_EXACTLY = NewtonSettings(tolerance=1e-14, max_steps=60)


def position_changes(
    inflation: Inflation, film: Film, rest_moves: Floats, backend: str | Backend | None = None
) -> TangentSolution:
    """Changes (n, 3, k) m of the positions for fields of small moves (n, 2, k) m of the rest positions.

    Each vertex moves in the plane of its own panel. The balloon must be at rest: what is left of its forces
    counts as none. It is free to move and turn as a whole, so rounding adds a little of that to the changes,
    which says nothing of its shape. Raises InputError for a weld that crumples: of the film outside its seams
    an inflation keeps nothing.
    """
    solver, report = backend_named(backend), inflation.report
    assembly = simulated(inflation.assembly, report.model)
    split = split_for(assembly, film, report.model)
    if split.strip:
        raise InputError(
            "How a balloon follows its pattern can be worked out for an elastic weld alone: choose that one."
        )
    problem = problem_of(split, film, inflation.characteristic_pressure, report.model)
    if report.lift is not None:
        places = inflation.positions[split.origin] / split.assembly.size
        problem = with_lift(problem, split, report.pressure, report.lift, places)
    positions, directors = _state(inflation, split, problem, solver)
    if len(rest_moves) < assembly.offsets[-1]:  # of one panel, but both are simulated
        rest_moves = np.concatenate([rest_moves, rest_moves])
    sides = np.repeat(np.where(assembly.surface.turned, -1.0, 1.0), np.diff(assembly.offsets))
    moves = (rest_moves * np.stack([sides, np.ones_like(sides)], axis=1)[:, :, None])[split.origin]
    shell = Shell(problem)
    shell.exact = True
    loads = force_changes(shell, positions, directors, tangent_frames(directors), moves)
    solution = solver.tangent_solve(problem, positions, directors, -loads)
    return replace(solution, changes=solution.changes[split.own][: len(inflation.positions)])


def _state(
    inflation: Inflation, split: SplitFilm, problem: FilmProblem, solver: Backend
) -> tuple[Floats, Floats]:
    """Positions and directors (n, 3) of all that was simulated, of which an inflation keeps but a part.

    The directors of the other side of a weld, and of a lower panel, are those at rest between the positions.
    """
    places = [inflation.positions] if inflation.lower is None else [inflation.positions, inflation.lower]
    positions = np.concatenate(places)[split.origin] / split.assembly.size
    directors = vertex_normals(positions, problem)
    known = split.own[: len(inflation.directors)]
    directors[known] = inflation.directors
    held = problem.fixed.copy()
    held[:, :3] = True
    held[known] = True
    if held.all():
        return positions, directors
    start = Start(positions, directors, (problem.membrane_stiffness,))
    rest = solver.solve(replace(problem, fixed=held), start, _EXACTLY, no_progress)
    return positions, rest.directors

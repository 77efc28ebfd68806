# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quasi-static Newton iteration in NumPy and SciPy: the oracle of the native solver and its stand-in.

Stiffness continuation: a film that is too soft finds its shape in a few steps; each stiffer level starts
from the softer one. Only the pressure makes the Hessian indefinite, where the film is slack; the stiffness of
an even tension restores definiteness and shortens steps that would go too far. It calms folds of the size of
the mesh and lets the balloon move as a whole, so that as much of it serves on every mesh.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from BalloonWorkbench.core.errors import Cancelled, SolverError
from BalloonWorkbench.core.solver.element.shell import Shell, tangent_frames, turned
from BalloonWorkbench.core.solver.equilibrium.convergence import Sight
from BalloonWorkbench.core.solver.problem import Energies, Equilibrium, FilmProblem, NewtonSettings
from BalloonWorkbench.core.types import Floats, Progress, no_progress

if TYPE_CHECKING:
    from scipy.sparse import csc_matrix
    from scipy.sparse.linalg import SuperLU

# The native solver is given these numbers (c_interface.py): both must take the same steps.
LEVEL_TOLERANCE = 0.02  # a softer level is good enough at this relative decrement
SHIFT = 1e-6  # of the area of each vertex, on the diagonal: holds what moves in the plane as a whole
DIRECTOR_SHIFT = 0.1  # of the flexural rigidity, for a unit of shift
FIRST_TENSION = 0.03  # in p L, tried when the Hessian is indefinite
LEAST_TENSION = 0.1 * FIRST_TENSION  # after a short step
HELD_BACK = 0.1  # a step with more tension than that says little about the rest
LARGEST_TENSION = 1e12
TENSION_GROWTH = 8.0
TENSION_DECAY = 0.2
NEED_DECAY = 0.5  # of the tension that made the Hessian definite: it is not tried without it again at once
SUFFICIENT = 2e-4  # part of the predicted decrease that a step must bring
SHORTEST = 1e-3  # of a Newton step; shorter ones are rejected
SHORT_STEP = 0.3  # after a step below that the tension grows,
MIDDLING_STEP = 0.5  # so that the next may be as long as that


def solve(
    problem: FilmProblem,
    positions: Floats,
    directors: Floats,
    levels: Sequence[float],
    settings: NewtonSettings,
    progress: Progress = no_progress,
) -> Equilibrium:
    """Bring the film to rest, through the membrane stiffnesses in levels (the last one is the film's own).

    positions (n, 3) and directors (n, 3) are the start. Raises Cancelled when progress asks for it and
    SolverError when the start has no finite energy.
    """
    shell = Shell(problem)
    shift = SHIFT * _masses(shell)
    shell.tension = needed = 0.0
    sight = Sight(problem.fixed, settings.tolerance)
    steps = factorisations = 0
    converged = False
    for level, stiffness in enumerate(levels):
        shell.membrane_stiffness = stiffness
        last = level == len(levels) - 1
        tolerance = settings.tolerance if last else LEVEL_TOLERANCE
        energy = shell.energies(positions, directors)
        if not np.isfinite(energy.total):
            raise SolverError("The simulation has no finite start. Check the outline for degenerate parts.")
        level_done = False
        while not level_done and steps < settings.max_steps:
            frames = tangent_frames(directors)
            gradient, factor, tries = _definite_factor(shell, positions, directors, frames, shift)
            factorisations += tries
            if tries > 1:
                needed = shell.tension
            if factor is None:
                return Equilibrium(positions, directors, steps, factorisations, False)
            step = factor.solve(-gradient)
            decrement = -0.5 * float(gradient @ step)
            steps += 1
            moves, turns = shell.spread(step)
            length, trial = 1.0, energy
            while length >= SHORTEST:
                next_positions = positions + length * moves
                next_directors = turned(directors, frames, length * turns)
                trial = shell.energies(next_positions, next_directors)
                if trial.total <= energy.total - SUFFICIENT * length * decrement:
                    break
                length *= 0.5
            if length < SHORTEST:
                level_done = decrement <= tolerance * abs(energy.total)
                shell.tension = min(max(TENSION_GROWTH**2 * shell.tension, FIRST_TENSION), LARGEST_TENSION)
            else:
                held_back = last and shell.tension > HELD_BACK
                at_rest = sight.at_rest(
                    positions, next_positions, energy, trial, length, decrement, held_back
                )
                positions, directors, energy = next_positions, next_directors, trial
                small = decrement <= tolerance * abs(energy.total)
                level_done = not held_back and (small or at_rest)
                needed *= NEED_DECAY
                shell.tension = max(_next_tension(shell.tension, length), needed)
            converged = last and level_done
            if not progress(
                (level + min(1.0, tolerance * abs(energy.total) / max(decrement, 1e-300))) / len(levels),
                "inflating",
            ):
                raise Cancelled("The simulation was stopped.")
    return Equilibrium(positions, directors, steps, factorisations, converged)


def _masses(shell: Shell) -> Floats:
    """What a unit of shift adds to the diagonal for each free unknown: (count,)."""
    mass = np.empty((len(shell.vertex_areas), 5))
    mass[:, :3] = shell.vertex_areas[:, None]
    mass[:, 3:] = DIRECTOR_SHIFT * shell.flexural_rigidity
    return shell.gathered(mass)


def _next_tension(tension: float, length: float) -> float:
    if length == 1.0:
        return TENSION_DECAY * tension
    if length < SHORT_STEP:
        return max(tension, LEAST_TENSION) * min(MIDDLING_STEP / length, TENSION_GROWTH)
    return tension


def _definite_factor(
    shell: Shell, positions: Floats, directors: Floats, frames: Floats, shift: Floats
) -> tuple[Floats, SuperLU | None, int]:
    """Gradient and factor of the Hessian, with the least tried tension that makes it positive definite.

    None for the factor when there is none.
    """
    tries = 0
    while True:
        gradient, hessian = shell.derivatives(positions, directors, frames)
        factor = _cholesky_like(shell.scatter.shifted(hessian, shift))
        tries += 1
        if factor is not None or shell.tension >= LARGEST_TENSION:
            return gradient, factor, tries
        shell.tension = max(TENSION_GROWTH * shell.tension, FIRST_TENSION)


def _cholesky_like(matrix: csc_matrix) -> SuperLU | None:
    """A factorisation without row exchanges, or None when the matrix is not positive definite."""
    from scipy.sparse.linalg import splu

    try:
        factor = splu(
            matrix, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True}
        )
    except RuntimeError:  # exactly singular
        return None
    # without row exchanges the signs of the pivots are those of the eigenvalues
    definite = bool(np.all(factor.U.diagonal() > 0.0)) and np.array_equal(factor.perm_r, factor.perm_c)
    return factor if definite else None


def energies(problem: FilmProblem, positions: Floats, directors: Floats) -> Energies:
    """Parts of the energy of a state."""
    return Shell(problem).energies(positions, directors)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quasi-static Newton iteration in NumPy and SciPy: the oracle of the native solver and its stand-in.

Stiffness continuation: a film that is too soft finds its shape in a few steps; each stiffer level starts
from the softer one. Only the pressure makes the Hessian indefinite; a shift proportional to the area of
each vertex restores definiteness and shortens steps that would go too far.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from BalloonWorkbench.core.errors import Cancelled, SolverError
from BalloonWorkbench.core.solver.problem import Energies, Equilibrium, FilmProblem, NewtonSettings
from BalloonWorkbench.core.solver.shell import Shell, tangent_frames, turned
from BalloonWorkbench.core.types import Floats, Progress, no_progress

if TYPE_CHECKING:
    from scipy.sparse import csc_matrix
    from scipy.sparse.linalg import SuperLU

# The native solver has the same numbers (native/src/newton.cpp): both must take the same steps.
LEVEL_TOLERANCE = 0.02  # a softer level is good enough at this relative decrement
SMALLEST_SHIFT = 1e-6
FIRST_SHIFT = 0.3  # tried when the unshifted Hessian is indefinite
LARGEST_SHIFT = 1e12
SHIFT_GROWTH = 8.0
SHIFT_DECAY = 0.2
DIRECTOR_SHIFT = 0.1  # of the flexural rigidity, for a unit of shift
SUFFICIENT = 2e-4  # part of the predicted decrease that a step must bring
SHORTEST = 1e-3  # of a Newton step; shorter ones are rejected


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
    mass = _masses(shell)
    shift = SMALLEST_SHIFT
    steps = factorisations = 0
    converged = False
    for level, stiffness in enumerate(levels):
        shell.membrane_stiffness = stiffness
        last = level == len(levels) - 1
        tolerance = settings.tolerance if last else LEVEL_TOLERANCE
        energy = shell.energies(positions, directors).total
        if not np.isfinite(energy):
            raise SolverError("The simulation has no finite start. Check the outline for degenerate parts.")
        level_done = False
        while not level_done and steps < settings.max_steps:
            frames = tangent_frames(directors)
            gradient, hessian = shell.derivatives(positions, directors, frames)
            factor, shift, tries = _definite_factor(shell, hessian, mass, shift)
            factorisations += tries
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
                trial = shell.energies(next_positions, next_directors).total
                if trial <= energy - SUFFICIENT * length * decrement:
                    break
                length *= 0.5
            if length < SHORTEST:
                level_done = decrement <= tolerance * abs(energy)
                shift = min(max(shift * SHIFT_GROWTH**2, FIRST_SHIFT), LARGEST_SHIFT)
            else:
                positions, directors, energy = next_positions, next_directors, trial
                level_done = decrement <= tolerance * abs(energy)
                shift = _next_shift(shift, length)
            converged = last and level_done
            if not progress(
                (level + min(1.0, tolerance * abs(energy) / max(decrement, 1e-300))) / len(levels),
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


def _next_shift(shift: float, length: float) -> float:
    if length == 1.0:
        return max(shift * SHIFT_DECAY, SMALLEST_SHIFT)
    if length < 0.3:
        return max(shift, 0.1 * FIRST_SHIFT) * min(0.5 / length, SHIFT_GROWTH)
    return shift


def _definite_factor(
    shell: Shell, hessian: csc_matrix, mass: Floats, shift: float
) -> tuple[SuperLU | None, float, int]:
    """Factor the Hessian with the smallest tried shift that makes it positive definite; None if none does."""
    tries = 0
    while shift <= LARGEST_SHIFT:
        tries += 1
        factor = _cholesky_like(shell.scatter.shifted(hessian, shift * mass))
        if factor is not None:
            return factor, shift, tries
        shift = max(shift * SHIFT_GROWTH, FIRST_SHIFT)
    return None, shift, tries


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

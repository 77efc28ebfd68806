# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quasi-static Newton iteration in NumPy and SciPy: the oracle of the native solver and its stand-in.

Stiffness continuation: a film that is too soft finds its shape in a few steps; each stiffer level starts
from the softer one. Only the pressure makes the Hessian indefinite, where the film is slack; the stiffness of
an even tension restores definiteness and shortens steps that would go too far. It calms folds of the size of
the mesh and lets the balloon move as a whole, so that as much of it serves on every mesh.

Bodies with seams in space crumple more than two panels do. Film that hangs slack has no stiffness, and a step
carries it so far that it is torn: most of the step is then given up. A small part of the stiffness that it
has when it is taut, in the Hessian alone, lets a step see that it will be. It fades as the film comes to
rest, where it would make Newton's steps too short.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.errors import Cancelled, SolverError
from BalloonWorkbench.core.solver.element.shell import Shell, tangent_frames, turned
from BalloonWorkbench.core.solver.equilibrium.convergence import Convergence, film_tolerance
from BalloonWorkbench.core.solver.equilibrium.direct import Factor, Factorisations
from BalloonWorkbench.core.solver.problem import (
    Energies,
    Equilibrium,
    FilmProblem,
    NewtonSettings,
    Start,
    TangentSolution,
)
from BalloonWorkbench.core.types import Floats, Progress, no_progress

# The native solver is given these numbers (c_interface.py): both must take the same steps.
LEVEL_TOLERANCE = 0.02  # a softer level is good enough at this relative decrement
SHIFT = 1e-6  # of the area of each vertex, on the diagonal: holds what moves in the plane as a whole
SLACK_STIFFNESS = 0.002  # of taut film's, in the Hessian of a body in space; more holds crumpled tips back
SLACK_FADES = 0.01  # below this relative decrement it does
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
    start: Start,
    settings: NewtonSettings,
    progress: Progress = no_progress,
) -> Equilibrium:
    """Bring the film to rest, through the membrane stiffnesses of the start.

    Raises Cancelled when progress asks for it and SolverError when the start has no finite energy.
    """
    iteration = _Iteration(problem, start, settings)
    for level, stiffness in enumerate(start.levels):
        iteration.begin_level(stiffness, last=level == len(start.levels) - 1)
        while not iteration.level_done and iteration.steps < settings.max_steps:
            if not iteration.step():
                return iteration.result(converged=False)
            if not progress((level + iteration.nearness()) / len(start.levels), "inflating"):
                raise Cancelled("The simulation was stopped.")
    return iteration.result(converged=iteration.last and iteration.level_done)


@dataclass(frozen=True)
class _Trial:
    """A state on the way of a step: this part of a Newton step from the one before."""

    positions: Floats
    directors: Floats
    energy: Energies
    length: float


class _Iteration:
    """The state of the iteration, moved on step by step."""

    def __init__(self, problem: FilmProblem, start: Start, settings: NewtonSettings) -> None:
        self._shell, self._direct = Shell(problem), Factorisations()
        self._shift = SHIFT * _masses(self._shell)
        self._shell.tension = self._needed = 0.0
        self._slack_stiffness = SLACK_STIFFNESS if problem.in_space else 0.0
        self._exact = film_tolerance(settings.tolerance, problem.membrane_stiffness)
        self._convergence = Convergence(problem.fixed, self._exact, problem.membrane_stiffness)
        self._positions, self._directors = start.positions, start.directors
        self.steps = self._factorisations = 0
        self.last = self.level_done = False

    def begin_level(self, stiffness: float, *, last: bool) -> None:
        """Go on with another membrane stiffness."""
        self._shell.membrane_stiffness = stiffness
        self._shell.slack_stiffness = self._slack_stiffness
        self.last, self.level_done = last, False
        self._tolerance = self._exact if last else LEVEL_TOLERANCE
        self._energy = self._shell.energies(self._positions, self._directors)
        if not np.isfinite(self._energy.total):
            raise SolverError("The simulation has no finite start. Check the outline for degenerate parts.")

    def step(self) -> bool:
        """One Newton step, or none where even the shortest part of it brings nothing.

        False where no stiffness makes the Hessian positive definite.
        """
        shell = self._shell
        frames = tangent_frames(self._directors)
        gradient, factor, tries = _definite_factor(
            shell, self._direct, self._positions, self._directors, frames, self._shift
        )
        self._factorisations += tries
        if tries > 1:
            self._needed = shell.tension
        if factor is None:
            return False
        step = factor.solve(-gradient)
        self._decrement = -0.5 * float(gradient @ step)
        self.steps += 1
        trial = self._line_search(step, frames)
        if trial is None:
            self.level_done = self._small()
            shell.tension = min(max(TENSION_GROWTH**2 * shell.tension, FIRST_TENSION), LARGEST_TENSION)
        else:
            self._accept(trial)
        return True

    def _line_search(self, step: Floats, frames: Floats) -> _Trial | None:
        """The longest part of a step, halved again and again, that lowers the energy as it should."""
        moves, turns = self._shell.spread(step)
        length = 1.0
        while length >= SHORTEST:
            positions = self._positions + length * moves
            directors = turned(self._directors, frames, length * turns)
            energy = self._shell.energies(positions, directors)
            if energy.total <= self._energy.total - SUFFICIENT * length * self._decrement:
                return _Trial(positions, directors, energy, length)
            length *= 0.5
        return None

    def _accept(self, trial: _Trial) -> None:
        shell = self._shell
        held_back = self.last and shell.tension > HELD_BACK
        at_rest = self._convergence.at_rest(
            self._positions,
            trial.positions,
            self._energy,
            trial.energy,
            trial.length,
            self._decrement,
            held_back,
        )
        self._positions, self._directors, self._energy = trial.positions, trial.directors, trial.energy
        self.level_done = not held_back and (self._small() or at_rest)
        self._needed *= NEED_DECAY
        shell.tension = max(_next_tension(shell.tension, trial.length), self._needed)
        unrest = self._decrement / (SLACK_FADES * max(abs(self._energy.total), 1e-300))
        shell.slack_stiffness = self._slack_stiffness * min(1.0, unrest)

    def _small(self) -> bool:
        return self._decrement <= self._tolerance * abs(self._energy.total)

    def nearness(self) -> float:
        """How near the level is to its end, 0 to 1."""
        return min(1.0, self._tolerance * abs(self._energy.total) / max(self._decrement, 1e-300))

    def result(self, *, converged: bool) -> Equilibrium:
        """The state that was reached."""
        return Equilibrium(self._positions, self._directors, self.steps, self._factorisations, converged)


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
    shell: Shell, direct: Factorisations, positions: Floats, directors: Floats, frames: Floats, shift: Floats
) -> tuple[Floats, Factor | None, int]:
    """Gradient and factor of the Hessian, with the least tried tension that makes it positive definite.

    None for the factor when there is none.
    """
    tries = 0
    while True:
        gradient, hessian = shell.derivatives(positions, directors, frames)
        factor = direct.factor(shell.scatter.shifted(hessian, shift))
        tries += 1
        if factor is not None or shell.tension >= LARGEST_TENSION:
            return gradient, factor, tries
        shell.tension = max(TENSION_GROWTH * shell.tension, FIRST_TENSION)


def energies(problem: FilmProblem, positions: Floats, directors: Floats) -> Energies:
    """Parts of the energy of a state."""
    return Shell(problem).energies(positions, directors)


def tangent_solve(
    problem: FilmProblem, positions: Floats, directors: Floats, loads: Floats
) -> TangentSolution:
    """How the film gives way to loads (n, 5, k) on the unknowns of its vertices, in the first order.

    The turns that loads act on are those of tangent_frames. Where the exact Hessian is not positive definite,
    Newton's takes its place, with the least tried tension that makes it so. The shift, which holds what moves
    as a whole, is that of Newton's method. Raises SolverError when the Hessian is no matrix of numbers.
    """
    shell, frames = Shell(problem), tangent_frames(directors)
    shift = SHIFT * _masses(shell)
    shell.exact = True
    _, hessian = shell.derivatives(positions, directors, frames)
    direct = Factorisations()
    factor = direct.factor(shell.scatter.shifted(hessian, shift))
    exact = factor is not None
    if factor is None:
        shell.exact = False
        _, factor, _ = _definite_factor(shell, direct, positions, directors, frames, shift)
    if factor is None:
        raise SolverError("The balloon is not near rest. Inflate it anew.")
    moves, _ = shell.spread(factor.solve(shell.gathered(loads)))
    return TangentSolution(moves, exact)

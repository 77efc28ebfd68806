# SPDX-License-Identifier: LGPL-2.1-or-later
"""One step in time of a film with mass: Newmark's method, implicit.

Newmark 1959, "A method of computation for structural dynamics"; Furuta et al. 2010, "A film balloon design
system integrated with shell element simulation", inflate balloons with it. With lumped masses M and drag c M
the film obeys M a + c M v + grad E(x, d) = 0. Over a step h

    x1 = x0 + h v0 + h^2 ((1/2 - beta) a0 + beta a1),    v1 = v0 + h ((1 - gamma) a0 + gamma a1)

Put into the equation of motion this is the gradient of

    (1 + c gamma h) / (2 beta h^2) |x - x*|^2_M + c v* . M x + E(x, d)

with x* and v* what is known of x1 and v1, so that a step is a minimisation: Newton's method with a line
search, its linear systems by preconditioned conjugate gradients. The first term makes them positive definite
when the step is short enough.

The unit of time is sqrt(m L / p) with m the film's mass per area: a vertex has the mass of its area.
Directors have no mass. They are at rest at each moment, but where there is drag they lag a little:
a crumpling film has moments in which a director would jump.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.errors import SolverError
from BalloonWorkbench.core.solver.element.shell import Shell, tangent_frames, turned
from BalloonWorkbench.core.solver.equilibrium.linear import IncompleteFactor, conjugate_gradients
from BalloonWorkbench.core.solver.problem import FilmProblem
from BalloonWorkbench.core.types import Floats

RESIDUAL = 1e-3  # of the linear systems, as a part of the load
MOST_ITERATIONS = 100  # of conjugate gradients
MOST_NEWTON_STEPS = 12  # in a step of time; a shorter one is better than more
SUFFICIENT = 2e-4  # part of the predicted decrease that a Newton step must bring
SHORTEST = 1e-2  # of a Newton step
ROUNDING = 1e-12  # a part of the energy that cannot be told from nothing
DIRECTOR_DRAG = 0.3  # of the flexural rigidity, for a unit of damping


@dataclass(frozen=True)
class Scheme:
    """How steps in time are taken.

    gamma      1/2 is of second order and keeps the energy of a linear film; up to 3/2, larger values are of
               first order and damp what is too fast for the steps
    damping    drag by mass [1 / unit of time]
    tolerance  a step is solved when a Newton step would lower its energy by less than this part
    """

    gamma: float = 0.5
    damping: float = 0.0
    tolerance: float = 1e-10

    @property
    def beta(self) -> float:
        """1/4 for gamma = 1/2; else the value that damps fast motion most."""
        return 0.25 * (self.gamma + 0.5) ** 2


@dataclass(frozen=True)
class MotionState:
    """A film in motion; time in units of sqrt(m L / p), load a part of the full pressure, the rest as in
    problem.py.

    positions, directors, velocities, accelerations (n, 3); newton_steps of the step in time that led here,
    and gain: the energy that the first of them promised.
    """

    time: float
    load: float
    positions: Floats
    directors: Floats
    velocities: Floats
    accelerations: Floats
    newton_steps: int = 0
    gain: float = 0.0


class Newmark:
    """A film problem with its masses. Counts its work; watch is called before each Newton step."""

    def __init__(
        self, problem: FilmProblem, scheme: Scheme, watch: Callable[[], None] = lambda: None
    ) -> None:
        self.shell = Shell(problem)
        self.scheme = scheme
        self.newton_steps = self.factorisations = self.iterations = 0
        self._watch = watch
        self.masses = self.shell.vertex_areas[:, None]
        count = len(self.masses)
        self._moving = self.shell.gathered(np.tile([1.0, 1.0, 1.0, 0.0, 0.0], (count, 1)) * self.masses)
        self._turning = self.shell.gathered(np.tile([0.0, 0.0, 0.0, 1.0, 1.0], (count, 1)))

    def put(self, load: float) -> None:
        """Put the film under a part of its full pressure."""
        self.shell.pressure = load * self.shell.problem.pressure
        self.shell.gradient = load * self.shell.problem.gradient

    def released(self, positions: Floats, directors: Floats, load: float) -> MotionState:
        """The film (n, 3), (n, 3) let go at time 0, without velocity."""
        self.put(load)
        gradient, _ = self.shell.derivatives(positions, directors, tangent_frames(directors))
        pull = np.divide(-gradient, self._moving, out=np.zeros_like(gradient), where=self._moving > 0.0)
        accelerations, _ = self.shell.spread(pull)
        return MotionState(0.0, load, positions, directors, np.zeros_like(positions), accelerations)

    def kinetic_energy(self, state: MotionState) -> float:
        """Half of mass times velocity squared."""
        return 0.5 * float(np.sum(self.masses * state.velocities**2))

    def potential_energy(self, state: MotionState) -> float:
        """Energy of the film, the pressure and the loads."""
        self.put(state.load)
        return self.shell.energies(state.positions, state.directors).total

    def step(self, state: MotionState, duration: float, load: float) -> MotionState | None:
        """The film after duration under a part of its pressure; None when a shorter step is needed.

        Raises SolverError when the film has no finite energy.
        """
        beta, gamma, damping = self.scheme.beta, self.scheme.gamma, self.scheme.damping
        known_velocities = state.velocities + (1.0 - gamma) * duration * state.accelerations
        increment = _Increment(
            self,
            load,
            state.positions + duration * state.velocities + (0.5 - beta) * duration**2 * state.accelerations,
            (1.0 + damping * gamma * duration) / (beta * duration**2),
            damping * known_velocities,
            state.directors,
            damping * DIRECTOR_DRAG * self.shell.flexural_rigidity / duration,
        )
        minimum = self._minimum(increment, state, duration)
        if minimum is None:
            return None
        positions, directors, newton_steps, gain = minimum
        accelerations = (positions - increment.known_positions) / (beta * duration**2)
        velocities = known_velocities + gamma * duration * accelerations
        return MotionState(
            state.time + duration,
            load,
            positions,
            directors,
            velocities,
            accelerations,
            newton_steps,
            gain,
        )

    def _minimum(
        self, increment: _Increment, state: MotionState, duration: float
    ) -> tuple[Floats, Floats, int, float] | None:
        """Positions and directors at the end of a step, the Newton steps and the gain of the first one."""
        positions, directors = state.positions, state.directors
        energy, size = increment.energy(positions, directors)
        guess = positions + duration * state.velocities + 0.5 * duration**2 * state.accelerations
        guessed, guessed_size = increment.energy(guess, directors)
        if guessed < energy:
            positions, energy, size = guess, guessed, guessed_size
        if not np.isfinite(energy):
            raise SolverError("The simulation has no finite start. Check the outline for degenerate parts.")
        gain = 0.0
        for count in range(1, MOST_NEWTON_STEPS + 1):
            self._watch()
            frames = tangent_frames(directors)
            step, decrement = self._newton_step(increment, positions, directors, frames)
            if step is None:
                return None
            gain = gain or decrement
            moves, turns = self.shell.spread(step)
            solved = decrement <= self.scheme.tolerance * size
            length = 1.0
            while length >= SHORTEST:
                next_positions = positions + length * moves
                next_directors = turned(directors, frames, length * turns)
                trial, trial_size = increment.energy(next_positions, next_directors)
                if trial <= energy - SUFFICIENT * length * decrement:
                    positions, directors, energy, size = next_positions, next_directors, trial, trial_size
                    break
                length *= 0.5
            if length < SHORTEST and decrement > ROUNDING * size:
                return None
            if solved:
                return positions, directors, count, gain
        return None

    def _newton_step(
        self, increment: _Increment, positions: Floats, directors: Floats, frames: Floats
    ) -> tuple[Floats | None, float]:
        """The step (count,) and the energy that it promises; None when the Hessian is not definite."""
        gradient, hessian = self.shell.derivatives(positions, directors, frames)
        gradient += increment.gradient(positions, frames)
        shift = increment.inertia * self._moving + increment.director_drag * self._turning
        matrix = self.shell.scatter.shifted(hessian, shift)
        factor = IncompleteFactor(matrix)
        self.newton_steps += 1
        self.factorisations += 1
        if not factor.definite:
            return None, 0.0
        solved = conjugate_gradients(matrix.__matmul__, -gradient, factor, RESIDUAL, MOST_ITERATIONS)
        self.iterations += solved.iterations
        return solved.solution if solved.definite else None, -0.5 * float(gradient @ solved.solution)


class _Increment:
    """The energy whose minimum is the end of a step in time."""

    def __init__(
        self,
        newmark: Newmark,
        load: float,
        known_positions: Floats,
        inertia: float,
        drag: Floats,
        directors: Floats,
        director_drag: float,
    ) -> None:
        self.known_positions = known_positions
        self.inertia = inertia
        self.director_drag = director_drag
        self._shell = newmark.shell
        newmark.put(load)
        self._masses = newmark.masses
        self._drag = drag
        self._directors = directors

    def energy(self, positions: Floats, directors: Floats) -> tuple[float, float]:
        """The energy, and the sum of the sizes of its parts."""
        film = self._shell.energies(positions, directors)
        way = positions - self.known_positions
        inertial = 0.5 * self.inertia * float(np.sum(self._masses * way**2))
        dragged = float(np.sum(self._masses * self._drag * way))
        lagging = 0.5 * self.director_drag * float(np.sum((directors - self._directors) ** 2))
        parts = (film.membrane, film.bending, film.pressure, film.load, film.seam, inertial, dragged, lagging)
        return sum(parts), sum(abs(part) for part in parts)

    def gradient(self, positions: Floats, frames: Floats) -> Floats:
        """What motion adds to the gradient of the film's energy: (count,)."""
        forces = np.empty((len(positions), 5))
        forces[:, :3] = self._masses * (self.inertia * (positions - self.known_positions) + self._drag)
        forces[:, 3:] = -self.director_drag * np.einsum("nij,ni->nj", frames, self._directors)
        return self._shell.gathered(forces)

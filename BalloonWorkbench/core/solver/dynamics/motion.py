# SPDX-License-Identifier: LGPL-2.1-or-later
"""A film blown up in time, from flat to rest: the seed of Furuta et al. 2010 with steps that adapt.

The length of a step follows from the error of Newmark's formula (Zienkiewicz and Xie 1991, "A simple error
estimator and adaptive time stepping procedure for dynamic analysis") and from how Newton's method fares.
As the film comes to rest the steps grow without bound, and the last ones are steps of a quasi-static Newton
method.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from BalloonWorkbench.core.errors import Cancelled, SolverError
from BalloonWorkbench.core.solver.dynamics.newmark import MotionState, Newmark, Scheme
from BalloonWorkbench.core.solver.problem import Equilibrium, FilmProblem, NewtonSettings, Start
from BalloonWorkbench.core.types import Floats, Progress, no_progress

#: Times are in units of sqrt(m L / p), in 2 of which the film is taut. With gamma below 0.8 a film that
#: flutters between slack and taut can gain energy from the steps.
SCHEME = Scheme(gamma=1.0, damping=2.0, tolerance=1e-3)
RAMP = 3.0  # the pressure rises for so long
FLATNESS = 1e-3  # a start shape is pressed down to this part of its height
FIRST_STEP = 0.02
SMALLEST_STEP = 1e-6
LONG_STEP = 5.0  # the film is only at rest when it stays so for steps like this
ERROR = 1e-3  # of a step, in units of L
GROWTH = 2.0
SHRINKAGE = 0.4
MANY_NEWTON_STEPS = 6  # in a step of time; the next one is shorter


def motion(newmark: Newmark, start: MotionState, load: Callable[[float], float]) -> Iterator[MotionState]:
    """States of a film after each step in time, without end unless even the shortest step fails.

    load gives the part of the full pressure at a time.
    """
    state, length = start, FIRST_STEP
    area = float(newmark.masses.sum())
    while length >= SMALLEST_STEP:
        after = newmark.step(state, length, load(state.time + length))
        if after is None:
            length *= SHRINKAGE
            continue
        change = after.accelerations - state.accelerations
        error = length**2 / 12.0 * float(np.sqrt(np.sum(newmark.masses * change**2) / area))
        fitting = 0.8 * float(np.cbrt(ERROR / max(error, 1e-300)))
        if error > 3.0 * ERROR and length > 100.0 * SMALLEST_STEP:
            length *= max(fitting, SHRINKAGE)
            continue
        state = after
        yield state
        longest = GROWTH if state.newton_steps <= MANY_NEWTON_STEPS else 0.8
        length *= min(max(fitting, SHRINKAGE), longest)


def solve(
    problem: FilmProblem,
    start: Start,
    settings: NewtonSettings,
    progress: Progress = no_progress,
    record: Callable[[MotionState], object] = lambda state: None,
) -> Equilibrium:
    """Bring the film to rest by blowing it up; the contract of newton.solve, and record sees every state.

    The start is pressed flat, and the film has its own stiffness from the beginning, so that there is no use
    for softer levels. max_steps counts steps in time. Raises as newton.solve does.
    """
    fraction = 0.0

    def watch() -> None:
        if not progress(fraction, "inflating"):
            raise Cancelled("The simulation was stopped.")

    newmark = Newmark(problem, SCHEME, watch)
    flat, normals = pressed_flat(problem, start.positions, start.directors)
    state = newmark.released(flat, normals, 0.0)
    record(state)
    resting = 0
    for count, after in enumerate(motion(newmark, state, ramped), 1):
        length, state = after.time - state.time, after
        record(state)
        fraction = state.time / (state.time + LONG_STEP)
        least = settings.tolerance * abs(newmark.potential_energy(state))
        calm = max(state.gain, newmark.kinetic_energy(state)) <= least
        resting = resting + 1 if calm and length > LONG_STEP and state.time > RAMP else 0
        if resting == 2 or count == settings.max_steps:
            break
    if not state.time:
        raise SolverError(
            "The simulation cannot take its first step. Check the outline for degenerate parts."
        )
    fraction = 1.0
    watch()
    return Equilibrium(
        state.positions, state.directors, newmark.newton_steps, newmark.factorisations, resting == 2
    )


def ramped(time: float) -> float:
    """Part of the full pressure at a time."""
    return min(1.0, time / RAMP)


def pressed_flat(problem: FilmProblem, positions: Floats, directors: Floats) -> tuple[Floats, Floats]:
    """The film before it is blown up, and its directors: (n, 3) each.

    A start shape with a small part of its heights. One that is free in space is pressed along the axis in
    which it is thinnest; one that is held by its lower end from the side, as thin as what holds it. Film that
    is pressed together wrinkles, so that this stretches nothing.
    """
    held = problem.fixed[:, :3].all(axis=1)
    spans = np.ptp(positions, axis=0)
    axis = (
        2
        if problem.fixed[:, 2].any() and not held.any()
        else int(np.argmin(spans[:2] if held.any() else spans))
    )
    middle, kept = (0.0, 0.0) if not held.any() else _slab(positions[held, axis])
    away = positions[:, axis] - middle
    flat, scale = positions.copy(), np.ones_like(positions)
    flat[:, axis] = middle + FLATNESS * away + (1.0 - FLATNESS) * np.clip(away, -kept, kept)
    scale[np.abs(away) > kept, axis] = FLATNESS
    if problem.tied is None:  # else both panels lie on each other, as they do in a start shape
        flat[:, :2] = problem.rest_positions
    normals = directors / scale
    return flat, normals / np.linalg.norm(normals, axis=1)[:, None]


def _slab(places: Floats) -> tuple[float, float]:
    """Middle and half the thickness of what lies at places (k,)."""
    low, high = float(places.min()), float(places.max())
    return 0.5 * (low + high), 0.5 * (high - low)

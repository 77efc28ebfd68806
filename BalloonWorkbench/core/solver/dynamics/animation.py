# SPDX-License-Identifier: LGPL-2.1-or-later
"""An inflation as a film strip, from the flat panel to the balloon at rest.

Only the film has mass, air has none: a real balloon, which also waits for its gas, is slower.
"""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import dataclass, replace
from functools import partial
from itertools import pairwise

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.solver.backend import backend_named
from BalloonWorkbench.core.solver.dynamics import motion
from BalloonWorkbench.core.solver.dynamics.newmark import MotionState
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.types import Floats, Progress, no_progress

#: The strip ends when no vertex is farther than this from its place of rest, in units of the panel's size.
VISIBLE = 2e-3


@dataclass(frozen=True)
class Frame:
    """A balloon on its way: time [s], overpressure [Pa], positions (n, 3) m as in Inflation."""

    time: float
    positions: Floats
    pressure: float
    lower: Floats | None = None


def inflate_in_time(
    panel: Panel,
    film: Film,
    pressure: float,
    *,
    frames: int = 60,
    model: Model | None = None,
    progress: Progress = no_progress,
) -> tuple[Inflation, tuple[Frame, ...]]:
    """The balloon at rest and so many frames of its inflation, the last of which is the balloon at rest.

    Frames are even in movement, not in time: the panel swells in milliseconds and may then creep for seconds.
    With the film's mass per area m and the panel's size L the pressure rises to its full value in
    3 sqrt(m L / p), and the motion is damped with 2 / sqrt(m L / p). Raises as inflate does, and InputError
    for a film without mass or fewer than two frames.
    """
    if frames < 2:
        raise InputError(f"An animation needs at least two frames, not {frames}.")
    if not film.areal_density > 0.0:
        raise InputError(f"The film '{film.name}' has no mass. Give its areal density.")
    states: list[MotionState] = []
    newmark = backend_named("newmark")
    recording = replace(newmark, solve=partial(motion.solve, record=states.append))
    inflation = inflate(panel, film, pressure, backend=recording, model=model, progress=progress)
    unit = float(np.sqrt(film.areal_density * panel.size / pressure))
    upper, half = len(panel.rest_positions), len(states[-1].positions) // 2
    strip = []
    for time in _times(states, frames):
        positions = _positions(states, time) * panel.size
        lower = positions[half : half + upper] if inflation.lower is not None else None
        strip.append(Frame(time * unit, positions[:upper], motion.ramped(time) * pressure, lower))
    last = replace(strip[-1], positions=inflation.positions, lower=inflation.lower)
    return inflation, (*strip[:-1], last)


def _times(states: list[MotionState], count: int) -> list[float]:
    """Times between which the fastest vertex goes equally far, until nothing moves visibly any more."""
    times = np.array([state.time for state in states])
    rest = states[-1].positions
    afar = [float(np.abs(state.positions - rest).max()) > VISIBLE for state in states]
    end = max(times[len(afar) - afar[::-1].index(True)], motion.RAMP)
    moves = [float(np.abs(after.positions - before.positions).max()) for before, after in pairwise(states)]
    way = np.concatenate([[0.0], np.cumsum(moves)])
    return list(np.interp(np.linspace(0.0, np.interp(end, times, way), count), way, times).tolist())


def _positions(states: list[MotionState], time: float) -> Floats:
    """Positions (n, 3) between two states: the cubic with their positions and velocities."""
    after = min(max(bisect_right(states, time, key=lambda state: state.time), 1), len(states) - 1)
    first, second = states[after - 1], states[after]
    length = second.time - first.time
    s = min((time - first.time) / length, 1.0)
    return np.asarray(
        (1.0 + 2.0 * s) * (1.0 - s) ** 2 * first.positions
        + s**2 * (3.0 - 2.0 * s) * second.positions
        + length * s * (1.0 - s) * ((1.0 - s) * first.velocities - s * second.velocities)
    )

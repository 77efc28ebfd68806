# SPDX-License-Identifier: LGPL-2.1-or-later
"""An inflation as a film strip, from the flat panel to the balloon at rest.

Of many panels, whose film is nowhere flat when they are sealed, it begins with the balloon at rest pressed
flat: let out, its film wrinkles and stretches nowhere. Only the film has mass, air has none: a real balloon,
which also waits for its gas, is slower.
"""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import dataclass, replace
from functools import partial
from itertools import pairwise

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.geometry.rigid import turn_onto
from BalloonWorkbench.core.panels.assembly import Assembly
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.solver.backend import backend_named
from BalloonWorkbench.core.solver.dynamics import motion
from BalloonWorkbench.core.solver.dynamics.newmark import MotionState
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.lift import Lift
from BalloonWorkbench.core.solver.model import Model, simulated, split_for
from BalloonWorkbench.core.types import Floats, Progress, no_progress

#: The strip ends when no vertex is farther than this from its place of rest, in units of the panel's size.
VISIBLE = 2e-3


@dataclass(frozen=True)
class Frame:
    """A balloon on its way: time [s], positions and lower (n, 3) m as in Inflation, pressure [Pa].

    The pressure is that inside over that outside, where it is largest.
    """

    time: float
    positions: Floats
    lower: Floats | None
    pressure: float


def inflate_in_time(
    body: Panel | Assembly,
    film: Film,
    pressure: float,
    *,
    frames: int = 60,
    model: Model | None = None,
    start: Floats | None = None,
    lift: Lift | None = None,
    progress: Progress = no_progress,
) -> tuple[Inflation, tuple[Frame, ...]]:
    """The balloon at rest and so many frames of its inflation, the last of which is the balloon at rest.

    start   of many panels, places (n, 3) [m] near which its balloon lies; None: none are known
    lift    as in inflate

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
    if isinstance(body, Panel) or body.mirror:
        start = None
    else:
        start = inflate(body, film, pressure, start=start, model=model, lift=lift).positions
    inflation = inflate(
        body, film, pressure, start=start, backend=recording, model=model, progress=progress, lift=lift
    )
    unit = float(np.sqrt(film.areal_density * inflation.assembly.size / inflation.characteristic_pressure))
    ways = _Ways(states, film, inflation)
    strip = [
        Frame(time * unit, *ways.at(time), motion.ramped(time) * inflation.largest_pressure)
        for time in _times(states, frames)
    ]
    last = replace(strip[-1], positions=inflation.positions, lower=inflation.lower)
    return inflation, (*strip[:-1], last)


class _Ways:
    """Where the vertices of a balloon's panels are at each time."""

    def __init__(self, states: list[MotionState], film: Film, rest: Inflation) -> None:
        assembly, model = simulated(rest.assembly, rest.report.model), rest.report.model
        self._states, self._size = states, assembly.size
        self._own = split_for(assembly, film, model).own
        self._upper = len(rest.positions)
        self._turn, self._shift = np.eye(3), np.zeros(3)
        if not assembly.mirror and rest.report.lift is None:  # free in space it lies where it has moved to
            whole = rest.positions if rest.lower is None else np.concatenate([rest.positions, rest.lower])
            last = self._places(states[-1].positions)
            self._turn = turn_onto(last, whole)
            self._shift = whole.mean(axis=0) - last.mean(axis=0) @ self._turn

    def at(self, time: float) -> tuple[Floats, Floats | None]:
        """As positions and lower of Frame."""
        places = self._places(_positions(self._states, time)) @ self._turn + self._shift
        return places[: self._upper], places[self._upper :] if len(places) > self._upper else None

    def _places(self, positions: Floats) -> Floats:
        return np.asarray(positions[self._own] * self._size)


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

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Inflating to a volume instead of a pressure."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TypeVar

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.panels.assembly import Assembly
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.types import Progress, no_progress
from BalloonWorkbench.core.units import pressure_text, volume_text

#: Pressures tried are such that E t / (p L) lies between these; the first is such a film.
SOFTEST, FIRST, STIFFEST = 2.0, 200.0, 1e6
STRIDE = math.log(4.0)  # of the logarithm of the pressure, until the volume lies between two trials
TOLERANCE = 1e-4  # of the volume
MOST_TRIALS = 40

Result = TypeVar("Result")


def search_pressure(
    volume: float,
    unit: float,
    solve: Callable[[float], Result],
    volume_of: Callable[[Result], float],
    tolerance: float = TOLERANCE,
) -> Result:
    """The result of solve(pressure [Pa]) that has a volume [m3], found by trying.

    unit is E t / L [Pa]. The volume rises with the pressure, but little once the film is taut: strides, then
    a false position in the logarithm of the pressure; an end that stays twice counts half (Illinois).
    Raises InputError when the film would be limp at that volume, or stretched beyond what it can bear.
    """
    if not (math.isfinite(volume) and volume > 0.0):
        raise InputError(f"The volume must be positive, not {volume_text(volume)}.")
    lowest, highest = -math.log(STIFFEST), -math.log(SOFTEST)
    low, high = lowest, highest
    miss_low = miss_high = math.nan  # not tried yet
    at = -math.log(FIRST)
    best, nearest, before = None, math.inf, 0.0
    for _ in range(MOST_TRIALS):
        trial = solve(unit * math.exp(at))
        miss = volume_of(trial) - volume
        if abs(miss) < nearest:
            best, nearest = trial, abs(miss)
        if nearest <= tolerance * volume:
            break
        if miss < 0.0:
            miss_high *= 0.5 if before < 0.0 else 1.0
            low, miss_low = at, miss
        else:
            miss_low *= 0.5 if before > 0.0 else 1.0
            high, miss_high = at, miss
        before = miss
        if at in (lowest, highest) and (math.isnan(miss_low) or math.isnan(miss_high)):
            raise InputError(
                f"This balloon holds {'less than' if miss < 0.0 else 'more than'} {volume_text(volume)} at"
                " any pressure that suits its film: "
                f"{volume_text(volume_of(trial))} at {pressure_text(unit * math.exp(at))}. "
                "Change the size of the balloon or the volume."
            )
        if math.isnan(miss_high):
            at = min(at + STRIDE, highest)
        elif math.isnan(miss_low):
            at = max(at - STRIDE, lowest)
        else:
            middle = (low * miss_high - high * miss_low) / (miss_high - miss_low)
            at = min(max(middle, low + 0.05 * (high - low)), high - 0.05 * (high - low))
    assert best is not None  # the volume of the first trial is a number
    return best


def inflate_to_volume(
    body: Panel | Assembly,
    film: Film,
    volume: float,
    *,
    backend: str | None = None,
    model: Model | None = None,
    progress: Progress = no_progress,
) -> Inflation:
    """The balloon of a volume [m3]; report.pressure is what it needs. Raises what search_pressure does."""

    def tried(pressure: float) -> Inflation:
        return inflate(body, film, pressure, backend=backend, model=model, progress=progress)

    return search_pressure(volume, film.membrane_stiffness / body.size, tried, lambda trial: trial.volume)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Inflating to a volume instead of a pressure."""

from __future__ import annotations

import math

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.mesh.panel import Panel
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.types import Progress, no_progress

#: Pressures tried are such that E t / (p L) lies between these.
SOFTEST, STIFFEST = 2.0, 1e6
TOLERANCE = 1e-4  # of the volume
MOST_SOLVES = 30


def inflate_to_volume(
    panel: Panel,
    film: Film,
    volume: float,
    *,
    backend: str | None = None,
    progress: Progress = no_progress,
) -> tuple[Inflation, float]:
    """The balloon of a volume [m3] and the overpressure [Pa] that it needs.

    The volume rises with the pressure, but little once the film is taut: a false position in the logarithm
    of the pressure. Raises InputError when the film would be limp at that volume, or stretched beyond what
    it can bear.
    """
    if not (math.isfinite(volume) and volume > 0.0):
        raise InputError(f"The volume must be positive, not {volume:g} m3.")
    size = float((panel.rest_positions.max(axis=0) - panel.rest_positions.min(axis=0)).max())
    unit = film.membrane_stiffness / size

    def tried(logarithm: float, start: Inflation | None) -> Inflation:
        return inflate(
            panel, film, unit * math.exp(logarithm), start=start, backend=backend, progress=progress
        )

    low, high = -math.log(STIFFEST), -math.log(SOFTEST)
    below, above = tried(low, None), tried(high, None)
    if not below.volume <= volume <= above.volume:
        raise InputError(
            f"This film can hold {1e3 * below.volume:.4g} to {1e3 * above.volume:.4g} litres,"
            f" not {1e3 * volume:.4g}. Change the size of the balloon or the volume."
        )
    best, pressure = (below, low) if volume - below.volume < above.volume - volume else (above, high)
    miss_low, miss_high = below.volume - volume, above.volume - volume
    for _ in range(MOST_SOLVES):
        if abs(best.volume - volume) <= TOLERANCE * volume:
            break
        middle = (low * miss_high - high * miss_low) / (miss_high - miss_low)
        middle = min(max(middle, low + 0.05 * (high - low)), high - 0.05 * (high - low))
        best, pressure = tried(middle, None), middle
        miss = best.volume - volume
        if miss < 0.0:  # the end that stays counts half (Illinois), so that both ends move
            low, miss_low, miss_high = middle, miss, 0.5 * miss_high
        else:
            high, miss_high, miss_low = middle, miss, 0.5 * miss_low
    return best, unit * math.exp(pressure)

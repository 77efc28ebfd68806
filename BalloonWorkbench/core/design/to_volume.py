# SPDX-License-Identifier: LGPL-2.1-or-later
"""A design whose balloon has a given volume: the pressure follows."""

from __future__ import annotations

from dataclasses import replace
from typing import Protocol

from BalloonWorkbench.core.design.design import Design
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.solver.volume_load import search_pressure
from BalloonWorkbench.core.types import Progress

TOLERANCE = 1e-3  # of the volume


class DesignAtPressure(Protocol):
    """A way to design at a pressure: fit.fit or fit.inflate_outline with its options."""

    def __call__(self, target: Outline, film: Film, pressure: float, *, progress: Progress) -> Design:
        """The design of an outline."""


def design_to_volume(
    work: DesignAtPressure, target: Outline, film: Film, volume: float, *, progress: Progress
) -> Design:
    """The design of an outline whose balloon has a volume [m3]; its inflation's report tells the pressure.

    Raises what the work raises, and InputError when no sensible pressure gives that volume.
    """
    began: list[Design] = []

    def tried(pressure: float) -> Design:
        began.append(work(target, film, pressure, progress=_part(progress, len(began))))
        return began[-1]

    unit = film.membrane_stiffness / max(target.size)
    best = search_pressure(volume, unit, tried, lambda design: design.inflation.volume, TOLERANCE)
    return replace(best, seconds=sum(design.seconds for design in began))


def _part(progress: Progress, number: int) -> Progress:
    """Progress of one trial among a few."""

    def report(fraction: float, text: str) -> bool:
        return progress(1.0 - 0.7 ** (number + fraction), f"trial {number + 1}, {text}")

    return report

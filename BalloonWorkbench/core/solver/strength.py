# SPDX-License-Identifier: LGPL-2.1-or-later
"""How near the film is to tearing: where it is tightest, and up to which pressure it holds."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.types import Floats


@dataclass(frozen=True)
class Strength:
    """The weakest spot of a balloon.

    place     (3,) m, middle of the triangle of the upper film with the largest tension
    tension   N/m, there
    limit     N/m that the film bears, None where its strength is not known
    pressure  Pa, at which the balloon was inflated
    """

    place: Floats
    tension: float
    limit: float | None
    pressure: float

    @property
    def margin(self) -> float | None:
        """How many times the tension the film bears."""
        return None if self.limit is None else self.limit / self.tension

    @property
    def safe_pressure(self) -> float | None:
        """Pa that the film bears.

        A film that hardly stretches keeps its shape, so its tensions grow as the pressure does; where it
        stretches after all, they grow less. Tensile strength is not the weld's: a bad one opens earlier.
        """
        return None if self.margin is None else self.margin * self.pressure


def strength(inflation: Inflation, film: Film) -> Strength:
    """The weakest spot of an inflated balloon made of this film."""
    tightest = int(np.argmax(inflation.tensions[:, 0]))
    return Strength(
        inflation.positions[inflation.panel.triangles[tightest]].mean(axis=0),
        float(inflation.tensions[tightest, 0]),
        None if film.max_stress is None else film.max_stress * film.thickness,
        inflation.report.pressure,
    )

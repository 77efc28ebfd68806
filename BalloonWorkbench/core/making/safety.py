# SPDX-License-Identifier: LGPL-2.1-or-later
"""Up to which pressure film and weld hold, with a margin, and where they would give way."""

from __future__ import annotations

from dataclasses import dataclass, replace

from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.making.trade_figures import making
from BalloonWorkbench.core.memoize import memoized
from BalloonWorkbench.core.results.strength import Load, Loads, settled_loads
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.types import Floats

FILM, WELD = "film", "weld"
_MOST_TRIALS = 6
_NEAR = 0.01


@dataclass(frozen=True)
class Safety:
    """What holds a balloon together.

    film_load, weld_load    the largest of the film and at the weld, at `pressure` [Pa], which is that at the
                            top where it grows upwards
    film_limit, weld_limit  what they bear [N/m], None where that is not known
    margin                  strength over load that is asked for
    safe_pressure           at which that margin is left [Pa], None where no strength is known
    weakest                 FILM or WELD, empty where no strength is known
    at_rest                 False where the film did not come to rest: its loads are an estimate
    """

    film_load: Load
    weld_load: Load
    film_limit: float | None
    weld_limit: float | None
    pressure: float
    margin: float
    safe_pressure: float | None
    weakest: str
    at_rest: bool = True

    @property
    def load(self) -> Load:
        """What the weakest bears; the film's where no strength is known."""
        return self.weld_load if self.weakest == WELD else self.film_load

    @property
    def place(self) -> Floats | None:
        """Where that is on the inflated balloon (3,) [m], None where no strength is known."""
        return self.load.place if self.weakest else None


@memoized(most=8)
def safety(inflation: Inflation, film: Film, *, exact: bool = True) -> Safety:
    """The pressure at which film and weld still bear a margin times their load, by the data of the trade."""
    data = making()
    return safety_with(inflation, film, data.seal_strength(film), data.safety, exact=exact)


def safety_with(
    inflation: Inflation, film: Film, weld_limit: float | None, margin: float, *, exact: bool = True
) -> Safety:
    """The pressure at which film and weld still bear `margin` times their load.

    Tensions grow in proportion to the pressure while the film does not stretch, and less than that when it
    does: so the pressure found in proportion is safe where it is above that of the inflation. Where it is
    below, the balloon is inflated anew at lower pressures, until the margin is there; not so unless `exact`.
    """
    estimate = own = _in_proportion(inflation, film, weld_limit, margin)
    for _ in range(_MOST_TRIALS):
        if (
            not exact
            or estimate.safe_pressure is None
            or estimate.safe_pressure >= estimate.pressure * (1.0 - _NEAR)
        ):
            break
        model = inflation.report.model
        less = estimate.safe_pressure / estimate.pressure
        lift = inflation.report.lift and replace(
            inflation.report.lift, gradient=less * inflation.report.lift.gradient
        )
        inflation = inflate(
            inflation.assembly,
            film,
            less * inflation.report.pressure,
            start=inflation,
            model=model,
            lift=lift,
        )
        estimate = _in_proportion(inflation, film, weld_limit, margin)
    return Safety(
        own.film_load,
        own.weld_load,
        own.film_limit,
        weld_limit,
        own.pressure,
        margin,
        estimate.safe_pressure,
        estimate.weakest,
        own.at_rest and estimate.at_rest,
    )


def _in_proportion(inflation: Inflation, film: Film, weld_limit: float | None, margin: float) -> Safety:
    loads, at_rest = settled_loads(inflation, film)
    film_limit = None if film.max_stress is None else film.max_stress * film.thickness
    pressure = inflation.largest_pressure
    safe, weakest = _safe_pressure(loads, film_limit, weld_limit, margin, pressure)
    return Safety(loads.film, loads.weld, film_limit, weld_limit, pressure, margin, safe, weakest, at_rest)


def _safe_pressure(
    loads: Loads, film_limit: float | None, weld_limit: float | None, margin: float, pressure: float
) -> tuple[float | None, str]:
    """In proportion to the pressure of these loads [Pa], and what gives way first."""
    limits = ((FILM, film_limit, loads.film), (WELD, weld_limit, loads.weld))
    reserves = {name: limit / load.value for name, limit, load in limits if limit is not None and load.value}
    if not reserves:
        return None, ""
    weakest = min(reserves, key=lambda name: reserves[name])
    return pressure * reserves[weakest] / margin, weakest

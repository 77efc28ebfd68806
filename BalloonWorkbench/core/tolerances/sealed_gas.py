# SPDX-License-Identifier: LGPL-2.1-or-later
"""A balloon whose gas is sealed in: what its temperature does to its pressure and volume.

The amount of an ideal gas stays: (outside + p) V / T is what it was when the balloon was filled. Film hardly
stretches, so nearly all of it goes into the overpressure: 2 kPa become 5.5 kPa when a room is warmer by 10 K.
Where the gas no longer fills the balloon, it is limp: it has the volume of its gas, and no overpressure.
"""

from __future__ import annotations

from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.packages import without_scipy
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.problem import NewtonSettings

#: Of the pressure at filling: below it a balloon is limp; to which the pressure is worked out.
_LIMP, _EXACT = 0.01, 1e-3


def at_temperature(
    filled: Inflation, film: Film, outside: float, warmer: float, settings: NewtonSettings
) -> tuple[Inflation, float, float]:
    """A filled balloon at another temperature: its film, its volume [m3] and its overpressure [Pa].

    outside  pressure of the air [Pa]; warmer: temperature of the gas by that at filling;
    settings: when the film is at rest.
    A limp one is shown with what little pressure gives it a shape.
    """
    pressure = filled.report.pressure
    if warmer == 1.0:
        return filled, filled.volume, pressure
    gas = warmer * (outside + pressure) * filled.volume
    known = {pressure: filled}

    def more(trial: float) -> float:
        """What a balloon at a pressure [Pa] holds more than there is, by what there is."""
        if trial not in known:
            nearest = known[min(known, key=lambda tried: abs(tried - trial))]
            known[trial] = inflate(
                filled.assembly,
                film,
                trial,
                start=nearest,
                backend=filled.report.backend,
                model=filled.report.model,
                settings=settings,
            )
        return (outside + trial) * known[trial].volume / gas - 1.0

    least, stiff = _LIMP * pressure, gas / filled.volume - outside  # the pressure if the film did not stretch
    if stiff < least and more(least) >= 0.0:
        return known[least], gas / outside, 0.0
    # a balloon does not shrink when its pressure grows
    ends = (max(stiff, least), pressure) if warmer < 1.0 else (pressure, stiff)
    try:
        from scipy.optimize import brentq
    except ImportError as error:
        raise without_scipy("Temperatures need scipy: install it with pip install scipy.") from error
    if more(ends[0]) >= 0.0 or more(ends[1]) <= 0.0:  # film so stiff that nothing is left to find
        inside = stiff
    else:
        inside = float(brentq(more, *ends, xtol=_EXACT * pressure))
    more(inside)
    return known[inside], known[inside].volume, inside

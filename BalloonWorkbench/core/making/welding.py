# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long the seams of a balloon take: on the way of the tool, and to lay the edges on each other.

Nobody publishes such times for hand work: the usual ones in resources/making.json are assumptions, told with
the result, and the maker's own replace them.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.making.trade_figures import making
from BalloonWorkbench.core.units import number_text

_MINUTE, _HOUR = 60.0, 3600.0


@dataclass(frozen=True)
class WeldingTime:
    """How long a number of seams takes.

    seconds   all together [s]
    speed     of the tool along a seam [m/s]
    handling  of each seam: to lay its edges on each other and hold them [s]
    """

    seconds: float
    speed: float
    handling: float

    @property
    def hours(self) -> float:
        """All together [h]."""
        return self.seconds / _HOUR

    def sentence(self) -> str:
        """How long, and on which basis."""
        speed, handling = number_text(self.speed * _MINUTE, 2), number_text(self.handling / _MINUTE, 2)
        hours = number_text(self.hours, 2)
        return f"It takes {hours} h at {speed} m/min and {handling} min for each seam."


def welding_time(
    seam_length: float, seams: int, speed: float | None = None, handling: float | None = None
) -> WeldingTime:
    """How long so many seams of a length [m] take together.

    speed [m/min], handling [min] of each seam: None for the usual
    """
    usual = making()
    speed = usual.weld_speed if speed is None else speed / _MINUTE
    handling = usual.handling if handling is None else handling * _MINUTE
    if not speed > 0.0 or not handling >= 0.0:
        raise InputError("The speed of welding must be above 0, and the time for each seam not below it.")
    return WeldingTime(seam_length / speed + seams * handling, speed, handling)


def welding_report(time: WeldingTime) -> dict[str, Any]:
    """The same as plain data; keys carry their units."""
    return {
        "hours": time.hours,
        "speed_m_per_min": time.speed * _MINUTE,
        "handling_min_per_seam": time.handling / _MINUTE,
        "sentence": time.sentence(),
    }

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The profile: half the section of a body of revolution, from its lower to its upper end."""

from __future__ import annotations

from dataclasses import dataclass

from BalloonWorkbench.core.types import Floats

#: How an end is closed: gores that meet in a point, a disc of film, or not at all.
POINT, DISC, OPEN = "point", "disc", "open"


@dataclass(frozen=True)
class Profile:
    """Half the section of a body of revolution, as it is to be seen inflated.

    points        (n, 2) m: distance r >= 0 from the axis and height z, from the lower end to the upper one
    lower, upper  how each end is closed: POINT where r is 0 there, else DISC or OPEN
    notes         one sentence each, for the user
    """

    points: Floats
    lower: str = POINT
    upper: str = POINT
    notes: tuple[str, ...] = ()

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Caps: discs that close the points where many panels meet, which no weld does."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.bags.bag import Bag
from BalloonWorkbench.core.bags.topology import Topology
from BalloonWorkbench.core.geometry.vectors import direction
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role

#: From so many corners on a point is capped; the cap's radius in seal widths.
_MANY, _RADIUS = 4, 3.0
_STEPS = 96


def capped_poles(bag: Bag) -> list[tuple[tuple[int, int, int], ...]]:
    """Points where four panels or more meet, each as (panel, loop, point) of the corners that are cut."""
    poles = [
        tuple(corner for corner in corners if bag.panels[corner[0]].cut) for corners in Topology(bag).poles
    ]
    return [corners for corners in poles if len(corners) >= _MANY]


def cap_pieces(bag: Bag, seal_width: float) -> list[Pattern]:
    """A disc for each of the capped poles."""
    count = len(capped_poles(bag))
    rim = _RADIUS * seal_width * direction(np.arange(_STEPS) * 2.0 * np.pi / _STEPS)
    return [Pattern((Contour(Role.CUT, rim, True),), None, seal_width, 0.0)] * count

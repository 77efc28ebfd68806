# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bags from panels whose sides have names: sides of one name are sealed together."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from BalloonWorkbench.core.bags.bag import Bag, BagPanel, BagSeam, Opening, Side
from BalloonWorkbench.core.types import Floats

#: A side: its name, and its points (k, 2) m without the last one, which the next side begins with.
NamedSide = tuple[str, Floats]


def joined_bag(panels: Sequence[tuple[str, Sequence[NamedSide]]], opening: str) -> Bag:
    """Panels by name, with their sides counter-clockwise seen from outside; two sides have each name.

    opening  the side at which the bag is filled, of the first panel that has it
    """
    pieces, seams = [], []
    seen: dict[str, Side] = {}
    filled = None
    for number, (panel, sides) in enumerate(panels):
        starts = np.cumsum([0, *(len(points) for _, points in sides)]).tolist()
        pieces.append(BagPanel(panel, np.concatenate([points for _, points in sides])))
        for (name, _), start, end in zip(sides, starts, starts[1:]):
            if name == opening and filled is None:
                filled = Opening(number, start)
            last = end % starts[-1]
            if name in seen:
                seams.append(BagSeam(seen.pop(name), Side(number, last, start)))
            else:
                seen[name] = Side(number, start, last)
    return Bag(tuple(pieces), tuple(seams), filled)


def polygon(corners: Floats, names: Sequence[str]) -> list[NamedSide]:
    """Straight sides between corners (n, 2) m; side k begins at corner k."""
    return [(name, corners[k : k + 1]) for k, name in enumerate(names)]


def rectangle(width: float, height: float, names: Sequence[str]) -> list[NamedSide]:
    """From the lower left corner: the lower side, the right one, the upper one, the left one [m]."""
    corners = np.array([(0.0, 0.0), (width, 0.0), (width, height), (0.0, height)])
    return polygon(corners, names)


def moved(line: Floats, x: float, y: float) -> Floats:
    """A side (k, 2) moved by x and y [m]."""
    return line + np.array([x, y])

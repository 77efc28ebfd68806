# SPDX-License-Identifier: LGPL-2.1-or-later
"""The opening of a bag as people say it: the number of a seam, or an edge of a panel."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from BalloonWorkbench.core.bags.bag import Bag, BagPanel, BagSeam, Opening
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.polyline import line_lengths
from BalloonWorkbench.core.geometry.vectors import perpendicular, unit
from BalloonWorkbench.core.types import Floats, Ints

#: Names of panels in a sentence, at most.
_MOST_NAMES = 12
#: A seam for the opening is at least this part of the longest one; its middle, from and to these shares.
_LONG_ENOUGH = 0.5
_MIDDLE = (0.3, 0.7)


def free_opening(panels: tuple[BagPanel, ...], seams: tuple[BagSeam, ...]) -> Opening | None:
    """The edge with the most room outside both panels for an intake, in the middle of a long seam.

    None where no seam joins outer loops.
    """
    sides = [
        [side.points(panels, against=against) for side, against in ((seam.a, False), (seam.b, True))]
        for seam in seams
    ]
    lengths = [
        0.0 if seam.a.loop or seam.b.loop else float(line_lengths(panels[seam.a.panel].outer[numbers[0]])[-1])
        for seam, numbers in zip(seams, sides)
    ]
    best, least = None, np.inf
    for seam, numbers, length in zip(seams, sides, lengths):
        if not length > 0.0 or length < _LONG_ENOUGH * max(lengths):
            continue
        edges = len(numbers[0]) - 1
        low, high = int(_MIDDLE[0] * edges), max(int(_MIDDLE[1] * edges), int(_MIDDLE[0] * edges) + 1)
        inside = [
            _hidden(panels[side.panel].outer, numbers[k][low : high + 1], sense)
            for k, (side, sense) in enumerate(((seam.a, 1.0), (seam.b, -1.0)))
        ]
        hidden = np.maximum(*inside) / length
        if hidden.min() < least - 1e-6:
            least = float(hidden.min())
            best = Opening(seam.a.panel, int(numbers[0][low + int(np.argmin(hidden))]))
    return best


def _hidden(loop: Floats, numbers: Ints, sense: float) -> Floats:
    """How far a panel reaches out beyond each edge between points (k,) of its loop: (k - 1,) m.

    sense  1 along the loop, which is counter-clockwise, -1 against it
    """
    line = loop[numbers]
    outward = -sense * perpendicular(unit(np.diff(line, axis=0)))
    middles = 0.5 * (line[:-1] + line[1:])
    beyond = outward @ loop.T - np.einsum("kd,kd->k", outward, middles)[:, None]
    return np.asarray(beyond.max(axis=1))


def bag_with_opening(bag: Bag, text: str) -> Bag:
    """The bag with its opening at a seam or an edge; raises InputError where there is no such.

    text  the number of a seam, from 1 as on both its edges; or a panel and the number of the point of its
          outer loop at which the edge begins, such as "top.2"
    """
    if text.strip().isdecimal():
        return replace(bag, opening=_on_seam(bag, int(text)))
    name, _, at = text.rpartition(".")
    for number, panel in enumerate(bag.panels):
        if panel.name == name and at.isdecimal() and int(at) < len(panel.outer):
            return replace(bag, opening=Opening(number, int(at)))
    names = ", ".join(panel.name for panel in bag.panels[:_MOST_NAMES])
    more = ", ..." if len(bag.panels) > _MOST_NAMES else ""
    raise InputError(
        f'"{text}" is no edge of a panel: write it as in {bag.panels[0].name}.0, or give the number of a'
        f" seam, 1 to {len(bag.seams)}. There are the panels {names}{more}."
    )


def _on_seam(bag: Bag, number: int) -> Opening:
    """The middle edge of a seam, on the first of its sides that lies on an outer loop."""
    if not 1 <= number <= len(bag.seams):
        raise InputError(f"There is no seam {number} for the opening: the seams are 1 to {len(bag.seams)}.")
    seam = bag.seams[number - 1]
    for side, against in ((seam.a, False), (seam.b, True)):
        if side.loop == 0:
            points = side.points(bag.panels, against=against)
            starts = points[1:] if against else points[:-1]
            return Opening(side.panel, int(starts[len(starts) // 2]))
    one, other = (bag.panels[side.panel].name for side in seam.sides)
    raise InputError(
        f"Seam {number} joins holes of panels {one} and {other}, where no intake can be: say another seam."
    )

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The opening of a bag as people say it: the number of a seam, or an edge of a panel."""

from __future__ import annotations

from dataclasses import replace

from BalloonWorkbench.core.bags.bag import Bag, Opening
from BalloonWorkbench.core.errors import InputError

#: Names of panels in a sentence, at most.
_MOST_NAMES = 12


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

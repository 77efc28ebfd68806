# SPDX-License-Identifier: LGPL-2.1-or-later
"""The order in which panels are joined: flat seams first, the one with the opening last."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from BalloonWorkbench.core.bag_pattern.seams import SeamMark

#: What a seam does: it joins two parts, closes a part to a ring or a body, or is the last one.
JOIN, CLOSE, LAST = "join", "close", "last"


@dataclass(frozen=True)
class JoinStep:
    """One seam in the order of the work.

    seam    its number, from 1
    panels  numbers of both panels, from 0
    kind    JOIN, CLOSE or LAST
    flat    whether it is sealed lying flat; else one edge must turn
    opening whether the intake is in it
    """

    seam: int
    panels: tuple[int, int]
    kind: str
    flat: bool
    opening: bool


def assembly_order(seams: Sequence[SeamMark], opening: int | None) -> tuple[JoinStep, ...]:
    """All seams that are made. First a spanning tree of the panels from flat seams, and flat seams that close
    a ring; then those where an edge must turn, panel by panel; last the opening's (its number, from 1).
    """
    made = [seam for seam in seams if seam.made]
    last = opening if any(seam.number == opening for seam in made) else None
    group = {panel: panel for seam in made for panel in seam.panels}

    def root(panel: int) -> int:
        while group[panel] != panel:
            panel = group[panel]
        return panel

    flat = [seam for seam in made if seam.flat and seam.number != last]
    turned = [seam for seam in made if not seam.flat and seam.number != last]
    first_of = {pair: seam.number for seam in reversed(turned) for pair in [frozenset(seam.panels)]}
    turned.sort(key=lambda seam: (first_of[frozenset(seam.panels)], seam.number))
    steps, closing = [], []
    for seam in flat:
        one, other = map(root, seam.panels)
        if one == other:
            closing.append(seam)
        else:
            group[one] = other
            steps.append((seam, JOIN))
    steps += [(seam, CLOSE) for seam in closing]
    for seam in turned:
        one, other = map(root, seam.panels)
        steps.append((seam, CLOSE if one == other else JOIN))
        group[one] = other
    steps += [(seam, LAST) for seam in made if seam.number == last]
    if last is None and steps:
        steps[-1] = steps[-1][0], LAST
    return tuple(
        JoinStep(seam.number, seam.panels, kind, seam.flat, seam.number == opening) for seam, kind in steps
    )

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Equal panels: which can be cut as copies of one, and which are its mirror image."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.bags.bag import Bag, BagPanel
from BalloonWorkbench.core.geometry.polyline import edge_lengths, perimeter
from BalloonWorkbench.core.types import Floats

#: Equal panels are nowhere farther apart than that [m].
_EQUAL = 1e-6


@dataclass(frozen=True)
class PanelCopies:
    """Panels of one shape.

    panels    their numbers in the bag, from 0; the first one is the pattern of the others
    mirrored  for each whether it is the first one's mirror image
    """

    panels: tuple[int, ...]
    mirrored: tuple[bool, ...]


def panel_copies(bag: Bag) -> tuple[PanelCopies, ...]:
    """All cut panels by their shape, in the order of the bag; moved, turned or begun elsewhere they are
    equal."""
    groups: list[tuple[list[int], list[bool]]] = []
    for number, panel in enumerate(bag.panels):
        if not panel.cut:
            continue
        for panels, mirrored in groups:
            first = bag.panels[panels[0]]
            if _equal(first, panel) or _equal(_reflected(first), panel):
                mirrored.append(not _equal(first, panel))
                panels.append(number)
                break
        else:
            groups.append(([number], [False]))
    return tuple(PanelCopies(tuple(panels), tuple(mirrored)) for panels, mirrored in groups)


def _reflected(panel: BagPanel) -> BagPanel:
    outer, *holes = (loop[::-1] * np.array([-1.0, 1.0]) for loop in panel.loops)
    return BagPanel(panel.name, outer, tuple(holes))


def _equal(one: BagPanel, other: BagPanel) -> bool:
    if len(one.loops) != len(other.loops) or len(one.outer) != len(other.outer):
        return False
    if abs(perimeter(one.outer) - perimeter(other.outer)) > _EQUAL:
        return False
    lengths, goal_lengths = edge_lengths(one.outer), edge_lengths(other.outer)
    count = len(lengths)
    for start in range(count):
        if np.abs(np.roll(lengths, -start) - goal_lengths).max() > _EQUAL:
            continue
        laid = _laid_on(np.roll(one.outer, -start, axis=0), other.outer, one.loops)
        if all(_near(mine, theirs) for mine, theirs in zip(_by_place(laid), _by_place(other.loops))):
            return True
    return False


def _laid_on(points: Floats, goals: Floats, loops: tuple[Floats, ...]) -> tuple[Floats, ...]:
    """Loops moved and turned so that points (n, 2) come nearest to goals (n, 2)."""
    middle, goal = points.mean(axis=0), goals.mean(axis=0)
    here, there = (points - middle) @ (1.0, 1.0j), (goals - goal) @ (1.0, 1.0j)
    turning = np.vdot(here, there)
    turning /= max(abs(turning), 1e-300)
    matrix = np.array([[turning.real, turning.imag], [-turning.imag, turning.real]])
    return tuple((loop - middle) @ matrix + goal for loop in loops)


def _by_place(loops: tuple[Floats, ...]) -> list[Floats]:
    """The outer loop, then the holes from left to right."""
    return [loops[0], *sorted(loops[1:], key=lambda loop: np.round(loop.mean(axis=0), 5).tolist())]


def _near(one: Floats, other: Floats) -> bool:
    """Whether each point of one loop is one of the other."""
    if len(one) != len(other):
        return False
    apart = np.linalg.norm(one[:, None] - other[None], axis=2)
    return bool(max(apart.min(axis=0).max(), apart.min(axis=1).max()) < _EQUAL)

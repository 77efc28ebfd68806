# SPDX-License-Identifier: LGPL-2.1-or-later
"""The seams of a bag as they are made: numbers, lengths of both sides, and how flat they lie."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.bags.bag import Bag, BagSeam, Side
from BalloonWorkbench.core.bags.division import side_line
from BalloonWorkbench.core.geometry.polyline import length, line_lengths, point_on
from BalloonWorkbench.core.geometry.vectors import perpendicular, turn
from BalloonWorkbench.core.types import Floats

#: Parts of a seam between whose directions it bends.
_PARTS = 48
#: A seam that bends by less than that more on one side than on the other is sealed flat [rad].
FLAT = 0.2


@dataclass(frozen=True)
class SeamMark:
    """A seam as it is marked and made.

    number              on both its edges, from 1 in the order of the bag's seams
    panels              numbers of both panels in the bag, from 0
    sides               both stretches of the panels' loops
    length_a, length_b  of both sides [m]
    flatness            integral of the difference of both sides' curvatures along it [rad]: 0 where they lie
                        on each other, 2 pi for a straight band round a disc
    made                False where one of the panels is not cut: an end that stays open
    tabs                cuts across the allowance of the side that must turn
    """

    number: int
    panels: tuple[int, int]
    sides: tuple[Side, Side]
    length_a: float
    length_b: float
    flatness: float
    made: bool = True
    tabs: int = 0

    @property
    def flat(self) -> bool:
        """Whether both panels lie flat while it is sealed; else one edge must turn to follow the other."""
        return self.flatness < FLAT


def seam_marks(bag: Bag) -> tuple[SeamMark, ...]:
    """All seams of a bag, numbered in its order."""
    marks = []
    for number, seam in enumerate(bag.seams, 1):
        one, other = side_lines(bag, seam)
        panels = seam.a.panel, seam.b.panel
        made = all(bag.panels[panel].cut for panel in panels)
        flatness = float(np.abs(bending_apart(one, other)).sum())
        marks.append(SeamMark(number, panels, seam.sides, length(one), length(other), flatness, made))
    return tuple(marks)


def side_lines(bag: Bag, seam: BagSeam) -> tuple[Floats, Floats]:
    """Points (k, 2) of both sides on their flat panels [m], both in the direction of the seam."""
    return side_line(bag, seam.a, against=False), side_line(bag, seam.b, against=True)


def bending_apart(one: Floats, other: Floats) -> Floats:
    """By how much more the first side bulges than the second in each part of a seam: (parts,) rad.

    Both lines (k, 2) run in the direction of the seam, film to the left of the first and to the right of the
    second; only the whole of it is exact, where corners lie at the ends.
    """
    return _bending(one) + _bending(other)


def _bending(line: Floats) -> Floats:
    """Turn to the left in each part of a line (parts,) [rad], its ends as the parts beside them."""
    along = line_lengths(line)
    points = point_on(line, along, np.linspace(0.0, along[-1], _PARTS + 1))
    steps = np.diff(points, axis=0)
    turns = turn(steps[:-1], steps[1:])
    return np.interp(np.arange(_PARTS) + 0.5, np.arange(1, _PARTS), turns)


@dataclass(frozen=True)
class Station:
    """A place on one side of a seam.

    at       (2,) m
    along    (2,) unit vector in the direction of the panel's loop, film to its left
    outward  (2,) unit vector away from the film
    forward  1.0 where the seam runs along the loop, -1.0 where it runs against it
    """

    at: Floats
    along: Floats
    outward: Floats
    forward: float


def station(line: Floats, share: float, reach: float, forward: float) -> Station:
    """The place at a share of the length of a side (k, 2), its direction over so much on both sides [m]."""
    lengths = line_lengths(line)
    middle = share * lengths[-1]
    around = np.clip([middle - reach, middle, middle + reach], 0.0, lengths[-1])
    before, at, after = point_on(line, lengths, around)
    along = forward * (after - before) / max(float(np.linalg.norm(after - before)), 1e-300)
    return Station(at, along, -perpendicular(along), forward)

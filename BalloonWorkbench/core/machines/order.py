# SPDX-License-Identifier: LGPL-2.1-or-later
"""The order of the work: nothing is done to a piece of film after it was cut free.

Cuts contain each other: a panel its holes, a hole the small panel that lies in it. Panel by panel, what lies
inside a cut comes before that cut: first the lines, role by role, then the cuts inside, each after its own.
Of what may come in any order the way of the tool decides.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain, groupby
from typing import Any, NamedTuple

import numpy as np

from BalloonWorkbench.core.machines.travel import shortest_order
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.pattern.pattern import Contour, Role
from BalloonWorkbench.core.types import Floats

#: Closed lines of these roles cut free what is inside.
CUTS = (Role.CUT_INNER, Role.CUT)
RANKS = {role: rank for rank, role in enumerate(Role)}


class Step(NamedTuple):
    """The number of a contour in the order of the work.

    turn  0 where going through the layers once, in the order of their roles, is early enough; 1 for what
          waits for the second time, as the hole of a panel does that has another panel in it
    """

    number: int
    turn: int


def in_order(contours: Sequence[Contour], ways: Floats) -> list[Step]:
    """All contours in the order of the work.

    ways  (n, 2, 2), where the tool comes to each and leaves it; the first begins at their lower left corner
    """
    inside: list[list[int]] = [[] for _ in contours]
    outermost: list[int] = []
    for number, around in enumerate(_around(contours)):
        (outermost if around is None else inside[around]).append(number)

    def lines_first(number: int) -> int:
        contour = contours[number]
        return len(RANKS) if _frees(contour) else RANKS[contour.role]

    def done(number: int) -> list[Step]:
        before = together(inside[number], ways[number, 0], ways[number, 0])
        rank = RANKS[contours[number].role]
        turns = [steps[-1].turn + (RANKS[contours[steps[-1].number].role] > rank) for steps in before]
        return [*chain.from_iterable(before), Step(number, max(turns, default=0))]

    def together(numbers: list[int], start: Floats, finish: Floats | None = None) -> list[list[Step]]:
        blocks: list[list[Step]] = []
        groups = [list(group) for _, group in groupby(sorted(numbers, key=lines_first), key=lines_first)]
        for group in groups:
            steps = [done(number) for number in group]
            begins = ways[[block[0].number for block in steps], 0]
            ends = ways[[block[-1].number for block in steps], 1]
            order = shortest_order(begins, ends, start, finish if group is groups[-1] else None)
            blocks += [steps[number] for number in order]
            start = ends[order[-1]]
        return blocks

    corner = ways.reshape(-1, 2).min(axis=0, initial=np.inf)
    return list(chain.from_iterable(together(outermost, corner)))


def _frees(contour: Contour) -> bool:
    return contour.closed and contour.role in CUTS


def _around(contours: Sequence[Contour]) -> list[int | None]:
    """For each contour the number of the smallest cut around it, None where there is none."""
    package = shapely()
    cuts = [number for number, contour in enumerate(contours) if _frees(contour)]
    areas = {number: package.Polygon(contours[number].points) for number in cuts}
    places = np.array([_place(contour) for contour in contours], dtype=object)
    around: list[int | None] = [None] * len(contours)
    smallest: dict[int, float] = {}
    for number, which in zip(*package.STRtree(list(areas.values())).query(places, predicate="within")):
        cut = cuts[which]
        size = float(areas[cut].area)
        own = float(areas[number].area) if number in areas else 0.0  # a point of a cut lies in its own holes
        if own < size < smallest.get(number, float("inf")):
            around[number], smallest[number] = cut, size
    return around


def _place(contour: Contour) -> Any:
    """A point of shapely that lies where the contour does: amid a line, or inside what a cut frees."""
    package = shapely()
    if _frees(contour):
        return package.Polygon(contour.points).representative_point()
    return package.LineString(contour.points).interpolate(0.5, normalized=True)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paper test: flat panels read back from their DXF and glued along their numbers give the bag again."""

from __future__ import annotations

from collections import Counter

import numpy as np
import pytest
from made_bags import BAGS, FILM, made
from paper import NEAR, read

from BalloonWorkbench.core.bags.bag import Bag
from BalloonWorkbench.core.machines.machine import machines
from BalloonWorkbench.core.machines.machine_file import machine_file
from BalloonWorkbench.core.pattern.pattern import Role


def loop_length(points: np.ndarray) -> float:
    return float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())


def simulated(bag: Bag) -> list[tuple[tuple[int, float, bool], ...]]:
    """For each seam, of both sides: panel, length [mm], whether the seam runs along the panel's loop."""
    seams = []
    for seam in bag.seams:
        sides = []
        for side, against in ((seam.a, False), (seam.b, True)):
            points = bag.panels[side.panel].loops[side.loop][side.points(bag.panels, against=against)]
            sides.append((side.panel, 1e3 * loop_length(points), not against))
        seams.append(tuple(sides))
    return seams


@pytest.mark.slow
@pytest.mark.parametrize("name", sorted(set(BAGS) - {"envelope"}))
def test_panels_glued_along_their_numbers_are_the_bag(name: str) -> None:
    bag = BAGS[name]
    patterns = made(name, intake=False)
    laid = [contour.points for contour in patterns.sheet.of(Role.CUT)]
    middles = np.array([0.5 * (cut.min(axis=0) + cut.max(axis=0)) for cut in laid]) - patterns.sheet.bounds[0]
    file = machine_file(patterns.sheet, machines()["any-dxf"])
    sheet = read(file, 1e3 * FILM.seal_width, 1e3 * middles)
    assert len(sheet.areas) == len(bag.panels)
    assert sheet.areas == pytest.approx([1e6 * area(panel.loops) for panel in bag.panels], rel=1e-4)
    assert Counter(edge.number for edge in sheet.edges) == dict.fromkeys(range(1, len(bag.seams) + 1), 2)
    for number, sides in enumerate(simulated(bag), 1):
        glued = [(edge.panel, edge.length, edge.along) for edge in sheet.edges if edge.number == number]
        for mine, theirs in zip(sorted(glued, key=lambda side: not side[2]), sides, strict=True):
            assert (mine[0], mine[2]) == (theirs[0], theirs[2])
            assert mine[1] == pytest.approx(theirs[1], abs=NEAR)


def area(loops: tuple[np.ndarray, ...]) -> float:
    total = 0.0
    for loop in loops:
        x, y = loop.T
        total += 0.5 * float(x @ np.roll(y, -1) - np.roll(x, -1) @ y)
    return total

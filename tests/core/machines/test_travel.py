# SPDX-License-Identifier: LGPL-2.1-or-later
"""The way of a tool between pieces of work is short, and nothing is done too early for it."""

from itertools import pairwise, permutations

import numpy as np
import pytest

from BalloonWorkbench.core.machines.machine import FOLDER, read_machine
from BalloonWorkbench.core.machines.order import CUTS
from BalloonWorkbench.core.machines.toolpaths import Toolpaths, draw
from BalloonWorkbench.core.machines.travel import shortest_order, travel
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role

PLOTTER = read_machine(FOLDER / "hpgl-plotter.json")


def length(order, begins, ends, start, finish=None) -> float:
    places = [(start, start), *((begins[k], ends[k]) for k in order)]
    if finish is not None:
        places.append((finish, finish))
    return sum(float(np.linalg.norm(after[0] - before[1])) for before, after in pairwise(places))


@pytest.mark.parametrize("seed", range(6))
def test_few_pieces_are_within_a_tenth_of_the_best_order(seed: int) -> None:
    rng = np.random.default_rng(seed)
    begins = rng.random((7, 2))
    ends = begins if seed % 2 else rng.random((7, 2))
    start, finish = np.zeros(2), np.ones(2) if seed % 3 else None
    order = shortest_order(begins, ends, start, finish)
    assert sorted(order) == list(range(7))
    best = min(length(each, begins, ends, start, finish) for each in permutations(range(7)))
    assert length(order, begins, ends, start, finish) <= 1.1 * best


def test_a_grid_is_gone_through_row_by_row() -> None:
    x, y = np.meshgrid(np.arange(10.0), np.arange(10.0))
    places = np.random.default_rng(1).permutation(np.stack([x.ravel(), y.ravel()], axis=1))
    order = shortest_order(places, places, np.zeros(2))
    assert travel(places[order], places[order]) <= 1.1 * 99.0


@pytest.mark.parametrize("count", [0, 1, 2])
def test_hardly_anything_to_do(count: int) -> None:
    places = np.zeros((count, 2))
    assert shortest_order(places, places, np.ones(2), np.ones(2)) == list(range(count))


def square(x: float, y: float, size: float, role: Role) -> Contour:
    corners = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    return Contour(role, size * corners + [x, y], True)


def test_what_is_cut_free_comes_last_whatever_the_way() -> None:
    """Panels strewn over the sheet, each with a hole and a notch: all of one before its own cut."""
    rng = np.random.default_rng(3)
    places = rng.permutation([(x, y) for x in range(5) for y in range(4)]) * 0.1
    contours = []
    for x, y in places:
        contours.append(square(x, y, 0.08, Role.CUT))
        contours.append(square(x + 0.03, y + 0.03, 0.01, Role.CUT_INNER))
    paths = draw(Pattern(tuple(contours), None, 0.006, 0.4), PLOTTER)
    cut = [path for path in paths.paths if path.role in CUTS]
    assert len(cut) == 40
    for hole, panel in zip(cut[::2], cut[1::2], strict=True):
        assert (hole.role, panel.role) == (Role.CUT_INNER, Role.CUT)
        assert np.all(panel.curve.bounds[0] < hole.curve.bounds[0])
        assert np.all(hole.curve.bounds[1] < panel.curve.bounds[1])
    assert between_panels(paths) < 1.1 * 19 * 100.0, "neighbours are 100 mm apart"


def between_panels(paths: Toolpaths) -> float:
    middles = np.array([np.mean(path.curve.bounds, axis=0) for path in paths.paths if path.role is Role.CUT])
    return float(np.linalg.norm(np.diff(middles, axis=0), axis=1).sum())

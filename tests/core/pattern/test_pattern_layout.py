# SPDX-License-Identifier: LGPL-2.1-or-later
"""Several patterns on one sheet: in their places while there is room, else apart; no cut meets another."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest
import shapely
from drawn_shapes import NAMED, generated

from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.pattern.build import build_pattern
from BalloonWorkbench.core.pattern.layout import SPACING, beside, on_one_sheet
from BalloonWorkbench.core.pattern.pattern import Pattern, Role


def at(outline: Outline, x: float, y: float, factor: float = 1.0) -> Pattern:
    return build_pattern(outline.map(lambda loop: factor * loop + (x, y)), 0.005)


def films(patterns: list[Pattern]) -> list[shapely.Polygon]:
    """What is cut out, told from the contours anew."""
    found = []
    for pattern in patterns:
        (outer,) = pattern.of(Role.CUT)
        holes = [contour.points for contour in pattern.of(Role.CUT_INNER)]
        found.append(shapely.Polygon(outer.points, holes))
    return found


def least_gap(patterns: list[Pattern]) -> float:
    return min(shapely.distance(one, other) for one, other in combinations(films(patterns), 2))


def test_patterns_with_room_stay_where_they_are() -> None:
    patterns = [at(NAMED["disc"], 0.0, 0.0), at(NAMED["star"], 0.5, 0.1)]
    assert all((shift == 0.0).all() for shift in beside(patterns))


def test_an_island_stays_in_the_hole_of_its_ring() -> None:
    ring = at(NAMED["ring"], 0.0, 0.0)
    island = build_pattern(NAMED["disc"].map(lambda loop: 0.3 * loop), 0.005, PatternOptions(intake=False))
    assert all((shift == 0.0).all() for shift in beside([ring, island]))
    assert least_gap([ring, island]) > SPACING


def test_patterns_too_near_to_each_other_are_laid_apart() -> None:
    outlines = [NAMED["ring"], *(generated(seed) for seed in range(8)), NAMED["disc"]]
    patterns = [at(outline, 0.05 * k, 0.02 * k, 1.0 - 0.07 * k) for k, outline in enumerate(outlines)]
    assert least_gap(patterns) == 0.0
    shifts = beside(patterns)
    moved = [pattern.moved(shift) for pattern, shift in zip(patterns, shifts, strict=True)]
    assert least_gap(moved) > SPACING - 1e-9
    low = np.min([pattern.bounds[0] for pattern in moved], axis=0)
    high = np.max([pattern.bounds[1] for pattern in moved], axis=0)
    needed = sum(np.prod(pattern.size) for pattern in moved)
    assert needed / np.prod(high - low) > 0.5  # not one endless row
    assert max(high - low) < 2.5 * min(high - low)


def test_one_sheet_has_all_contours_unchanged_but_for_the_shift() -> None:
    patterns = [at(NAMED["ring"], 0.0, 0.0), at(NAMED["disc"], 0.05, 0.0)]
    sheet = on_one_sheet(patterns)
    assert [contour.role for contour in sheet.contours] == [
        contour.role for pattern in patterns for contour in pattern.contours
    ]
    assert sheet.seam_length == pytest.approx(sum(pattern.seam_length for pattern in patterns))
    old = [contour.points for pattern in patterns for contour in pattern.contours]
    for before, after in zip(old, sheet.contours, strict=True):
        np.testing.assert_allclose(np.diff(before, axis=0), np.diff(after.points, axis=0), atol=1e-12)
    assert on_one_sheet(patterns[:1]) is patterns[0]

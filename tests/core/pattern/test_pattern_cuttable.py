# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cut has no gap and no notch narrower than a tool, and keeps everything else."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from drawn_shapes import NAMED, generated

from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.pattern.build import build_pattern
from BalloonWorkbench.core.pattern.cuttable import LEAST_RADIUS, closed_gaps, opened_hole
from BalloonWorkbench.core.pattern.pattern import Pattern, Role
from BalloonWorkbench.core.pattern.shapes import closed_loop

MM = 1e-3


def cut_film(pattern: Pattern) -> shapely.Polygon:
    (outer,) = (contour.points for contour in pattern.contours if contour.role is Role.CUT)
    holes = [contour.points for contour in pattern.contours if contour.role is Role.CUT_INNER]
    return shapely.Polygon(outer, holes)


def too_narrow(film: shapely.Polygon) -> float:
    """Thickness [m] of the thickest gap into which a disc of nearly the least radius does not fit."""
    radius = 0.97 * LEAST_RADIUS
    waste = film.envelope.buffer(0.05).difference(film)
    reached = waste.buffer(-radius).buffer(radius, quad_segs=32)
    lost = [piece for piece in shapely.get_parts(waste.difference(reached)) if piece.area > 0.0]
    return max((2.0 * shapely.maximum_inscribed_circle(piece).length for piece in lost), default=0.0)


def comb(gap: float) -> Outline:
    """Two arms 30 mm wide and 100 mm long, so far apart [m] as seams."""
    left = [(0.0, 0.0), (0.06 + gap, 0.0), (0.06 + gap, 0.13), (0.03 + gap, 0.13)]
    right = [(0.03 + gap, 0.03), (0.03, 0.03), (0.03, 0.13), (0.0, 0.13)]
    return Outline(np.array([*left, *right]))


@pytest.mark.parametrize("gap", [14.2, 14.8, 15.2, 18.0])
def test_gaps_between_arms(gap: float) -> None:
    """The cut takes 7 mm from each side: what is left is at least 1 mm wide, or closed."""
    film = cut_film(build_pattern(comb(gap * MM), 0.005, PatternOptions(intake=False)))
    across = film.intersection(shapely.LineString([(-0.1, 0.1), (0.2, 0.1)]))
    pieces = shapely.get_parts(across)
    if gap < 15.0:
        assert len(pieces) == 1
    else:
        assert len(pieces) == 2
        assert pieces[0].distance(pieces[1]) == pytest.approx((gap - 14.0) * MM, abs=1e-5)


@pytest.mark.parametrize("opening", [4.0, 20.0, 60.0, 100.0])
def test_notches_end_in_a_round(opening: float) -> None:
    """The apex of a notch in a square is filled up to where a disc of the least radius touches its sides."""
    half = np.radians(0.5 * opening)
    film = shapely.box(-0.1, -0.1, 0.1, 0.1).difference(
        shapely.Polygon([(0.0, 0.0), (0.2 * np.tan(half), 0.2), (-0.2 * np.tan(half), 0.2)])
    )
    closed = closed_gaps(film)
    apex = closed.intersection(shapely.LineString([(0.0, -0.05), (0.0, 0.2)])).bounds[3]
    assert apex == pytest.approx(LEAST_RADIUS * (1.0 / np.sin(half) - 1.0), abs=2e-5)
    outer = shapely.MultiPoint([(-0.1, -0.1), (0.1, -0.1)])
    corners = shapely.MultiPoint(shapely.get_coordinates(closed))
    assert max(corner.distance(corners) for corner in shapely.get_parts(outer)) < 1e-9


def test_holes_end_in_rounds() -> None:
    hole = shapely.Polygon([(0.0, 0.0), (0.02, 0.0), (0.0, 0.02)])
    (kept,) = opened_hole(hole)
    assert kept.within(hole.buffer(1e-9))
    away = shapely.Point(0.0, 0.0).distance(kept)
    assert away == pytest.approx(LEAST_RADIUS * (np.sqrt(2.0) - 1.0), abs=1e-5)
    assert opened_hole(shapely.box(0.0, 0.0, 0.9 * MM, 0.1)) == []


def test_smooth_contours_stay_as_they_are() -> None:
    disc = shapely.Point(0.0, 0.0).buffer(0.1, quad_segs=64)
    assert closed_gaps(disc) is disc
    assert opened_hole(disc)[0] is disc


SHAPES = {name: NAMED[name] for name in ("star", "heart", "L", "S", "ring")} | {
    f"generated {seed}": generated(seed) for seed in (1, 2, 4, 9, 12, 14)
}


@pytest.mark.parametrize("name", SHAPES)
def test_no_cut_is_too_narrow_for_the_tool(name: str) -> None:
    film = cut_film(build_pattern(SHAPES[name], 0.005))
    assert film.is_valid
    assert too_narrow(film) < 0.03 * MM


def test_a_loop_made_simpler_does_not_cross_itself() -> None:
    """Slivers hardly wider than what may be left out."""
    random = np.random.default_rng(0)
    tried = 0
    for _ in range(300):
        count, half = int(random.integers(8, 40)), random.uniform(2e-6, 3e-5)
        low, high = (np.sort(random.uniform(0.0, 0.002, count)) for _ in range(2))
        middle = np.cumsum(random.normal(0.0, 1.5e-5, count))
        side = np.stack([low, middle - half], axis=1)
        back = np.stack([high, np.interp(high, low, middle) + half], axis=1)
        ring = shapely.LinearRing(np.concatenate([side, back[::-1], [[-0.01, 0.0]]]))
        if ring.is_simple:
            tried += 1
            assert shapely.LinearRing(closed_loop(ring, True)).is_simple
    assert tried > 100

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Notches and the tie tab: where they are, and where they cannot be."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from drawn_shapes import NAMED

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.pattern.build import build_pattern
from BalloonWorkbench.core.pattern.marks import with_notches, with_tie_tab
from BalloonWorkbench.core.pattern.pattern import Pattern, Role

SEAL, ALLOWANCE = 0.005, 0.003


def made(name: str, intake: bool = True) -> Pattern:
    return build_pattern(NAMED[name], SEAL, PatternOptions(allowance=ALLOWANCE, intake=intake))


def film(pattern: Pattern) -> shapely.Polygon:
    (cut,) = pattern.of(Role.CUT)
    return shapely.Polygon(cut.points)


@pytest.mark.parametrize("name", ["disc", "heart", "S"])
def test_notches_stay_between_cut_and_weld(name: str) -> None:
    pattern = with_notches(made(name), 24, 0.002)
    marks = pattern.of(Role.NOTCH)
    assert 18 <= len(marks) <= 24  # none at the mouth
    whole = film(pattern)
    for mark in marks:
        line = shapely.LineString(mark.points)
        assert line.length == pytest.approx(0.002)
        assert whole.exterior.distance(shapely.Point(mark.points[0])) < 1e-9
        assert whole.buffer(1e-9).covers(line)
        for seal in pattern.of(Role.SEAL):
            assert shapely.LineString(seal.points).distance(line) > 0.5 * SEAL
    assert pattern.contours[-1].role is Role.CUT


def test_notches_are_even() -> None:
    pattern = with_notches(made("disc", intake=False), 12, 0.001)
    (cut,) = pattern.of(Role.CUT)
    line = shapely.LinearRing(cut.points)
    places = np.array([line.project(shapely.Point(mark.points[0])) for mark in pattern.of(Role.NOTCH)])
    places = np.sort(places % line.length)
    assert np.diff(places) == pytest.approx(np.full(11, line.length / 12), abs=1e-6)


def test_senseless_notches_are_refused() -> None:
    assert not with_notches(made("disc"), 0, 1.0).of(Role.NOTCH)
    with pytest.raises(InputError, match="weld"):
        with_notches(made("disc"), 5, 0.004)
    with pytest.raises(InputError, match="fewer"):
        with_notches(made("disc"), 900, 0.001)
    with pytest.raises(InputError, match="1000"):
        with_notches(made("disc"), -1, 0.001)


def test_tab_is_outside_the_weld_and_opposite_the_intake() -> None:
    plain = made("heart")
    pattern = with_tie_tab(plain)
    (hole,) = pattern.of(Role.CUT_INNER)
    assert shapely.Polygon(hole.points).area == pytest.approx(np.pi * 0.002**2, rel=0.01)
    hole_at = hole.points.mean(axis=0)
    away = hole_at - np.asarray(film(plain).centroid.coords[0])
    turn = np.arctan2(away[1], away[0]) - plain.intake.angle
    assert abs(np.cos(turn) + 1.0) < 0.01
    assert not film(plain).contains(shapely.Point(hole_at))
    assert film(pattern).contains(shapely.Polygon(hole.points).buffer(0.003))
    for seal in pattern.of(Role.SEAL):
        assert shapely.LineString(seal.points).distance(shapely.Polygon(hole.points)) > 0.5 * SEAL
    assert film(pattern).area > film(plain).area
    assert pattern.contours[-1].role is Role.CUT


def test_tab_goes_where_it_is_told_but_not_into_a_bay() -> None:
    pattern = with_tie_tab(made("disc", intake=False), 0.0)
    assert pattern.bounds[1][0] == pytest.approx(0.15 + SEAL + ALLOWANCE + 0.004 + 0.006, abs=1e-4)
    bay = np.array(
        [[0, 0], [0.2, 0], [0.2, 0.1], [0.11, 0.1], [0.11, 0.02], [0.09, 0.02], [0.09, 0.1], [0, 0.1]]
    )
    outline = type(NAMED["disc"])(bay.astype(float))
    narrow = build_pattern(outline, 0.002, PatternOptions(allowance=0.001, intake=False))
    with pytest.raises(InputError, match="another angle"):
        with_tie_tab(narrow, 0.5 * np.pi)


@pytest.mark.parametrize("angle", [np.inf, -np.inf, np.nan])
def test_a_tie_tab_needs_a_direction(angle: float) -> None:
    with pytest.raises(InputError, match="choose another angle"):
        with_tie_tab(made("disc"), angle)


def test_notches_are_square_to_the_cut_beside_a_corner() -> None:
    """Each stands on the edge that it lies on, not on the one before."""
    plain = made("L", intake=False)
    pattern = with_notches(plain, 37, 0.001)
    marks = pattern.contours[: len(pattern.contours) - len(plain.contours)]
    (cut,) = plain.of(Role.CUT)
    loop = np.concatenate([cut.points, cut.points[:1]])
    assert len(marks) == 37
    for mark in marks:
        start, end = mark.points
        steps = np.diff(loop, axis=0)
        share = np.clip(((start - loop[:-1]) * steps).sum(axis=1) / (steps**2).sum(axis=1), 0.0, 1.0)
        away = np.hypot(*(start - loop[:-1] - share[:, None] * steps).T)
        angles = [abs(float((end - start) @ step)) / np.hypot(*step) for step in steps[away < 1e-9]]
        assert min(angles) < 1e-9


def test_hole_of_the_tab_keeps_off_the_weld() -> None:
    """Half a weld from its middle is enough: a wide weld with a narrow allowance still has room."""
    for seal in (0.002, 0.01, 0.02):
        pattern = with_tie_tab(
            build_pattern(NAMED["disc"], seal, PatternOptions(allowance=0.0, intake=False)), 0.0
        )
        (hole,) = pattern.of(Role.CUT_INNER)
        (weld,) = pattern.of(Role.SEAL)
        room = shapely.LinearRing(weld.points).distance(shapely.Polygon(hole.points)) - 0.5 * seal
        assert room == pytest.approx(0.002, abs=2e-5)


def test_one_notch_is_one() -> None:
    plain = made("square", intake=False)
    pattern = with_notches(plain, 1, 0.001)
    assert len(pattern.contours) == len(plain.contours) + 1
    assert with_notches(plain, 0, 0.001) is plain

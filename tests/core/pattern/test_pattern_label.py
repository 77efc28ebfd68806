# SPDX-License-Identifier: LGPL-2.1-or-later
"""Labels: outlines of the right height, in the film, away from welds and holes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import shapely
from drawn_shapes import NAMED

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.pattern.build import build_pattern
from BalloonWorkbench.core.pattern.label import with_label
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role


def labelled(name: str, text: str, height: float = 0.006) -> Pattern:
    return with_label(build_pattern(NAMED[name], 0.005), text, height)


def test_letters_have_their_height_and_holes() -> None:
    pattern = labelled("disc", "HOB")
    loops = [contour.points for contour in pattern.of(Role.ENGRAVE)]
    assert len(loops) == 3 + 1 + 2  # the O has one hole, the B two
    tall = max(loops, key=lambda loop: np.ptp(loop[:, 1]))
    assert np.ptp(tall[:, 1]) == pytest.approx(0.006, rel=0.05)
    assert all(contour.closed for contour in pattern.of(Role.ENGRAVE))
    assert pattern.contours[-1].role is Role.CUT


@pytest.mark.parametrize("name", ["ring", "holes", "heart"])
def test_text_is_on_free_film(name: str) -> None:
    pattern = labelled(name, "fish 300 mm", 0.004)
    text = shapely.MultiPoint(np.concatenate([contour.points for contour in pattern.of(Role.ENGRAVE)]))
    (cut,) = pattern.of(Role.CUT)
    assert shapely.Polygon(cut.points).contains(text)
    for hole in pattern.of(Role.CUT_INNER):
        assert not shapely.Polygon(hole.points).intersects(text.convex_hull)
    for seal in pattern.of(Role.SEAL):
        assert shapely.LineString(seal.points).distance(text.convex_hull) > 0.0


def test_label_keeps_off_welds_inside() -> None:
    """A line of weld through the middle of a square, and a hole: the letters are beside both."""
    plain = build_pattern(NAMED["square"], 0.005)
    across = Contour(Role.WELD, np.array([[0.02, 0.15], [0.28, 0.15]]), False)
    pattern = with_label(replace(plain, contours=(across, *plain.contours)), "HEART", 0.02)
    box = shapely.MultiPoint(np.concatenate([each.points for each in pattern.of(Role.ENGRAVE)])).envelope
    assert box.area > 0.0
    for role in (Role.WELD, Role.SEAL):
        for line in pattern.of(role):
            assert shapely.LineString(line.points).distance(box) > 0.0025 - 1e-5


def test_what_cannot_be_written() -> None:
    assert not labelled("disc", "  ").of(Role.ENGRAVE)
    with pytest.raises(InputError, match="shorter"):
        labelled("S", "a text that is far too long", 0.01)
    with pytest.raises(InputError, match="60"):
        labelled("disc", "x" * 61)


def test_same_label_same_outlines() -> None:
    first, second = (labelled("disc", "Bö") for _ in range(2))
    assert all(
        np.array_equal(a.points, b.points) for a, b in zip(first.contours, second.contours, strict=True)
    )


def test_label_takes_the_room_that_there_is() -> None:
    """Its box goes into the circle inside the weld, in whose middle it is; from 0.1 mm to 10 m high."""
    pattern = build_pattern(NAMED["disc"], 0.005, PatternOptions(intake=False))
    (weld,) = pattern.of(Role.SEAL)
    radius = np.hypot(*(weld.points - weld.points.mean(axis=0)).T).min() - 0.0025

    def box(height: float) -> np.ndarray:
        letters = with_label(pattern, "Heart 7", height).of(Role.ENGRAVE)
        points = np.concatenate([contour.points for contour in letters])
        return np.array([points.min(axis=0), points.max(axis=0)])

    low, high = box(0.01)
    assert 0.5 * (low + high) == pytest.approx(weld.points.mean(axis=0), abs=1e-4)
    highest = 0.01 * 2.0 * radius / np.hypot(*(high - low))
    box(0.995 * highest)
    with pytest.raises(InputError, match="shorter"):
        box(1.005 * highest)
    with_label(pattern, "A", 1e-4)
    for height in (0.9e-4, 10.1, float("nan")):
        with pytest.raises(InputError, match="between"):
            with_label(pattern, "A", height)
    with pytest.raises(InputError, match="wide"):
        with_label(pattern, "A", 10.0)

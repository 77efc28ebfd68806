# SPDX-License-Identifier: LGPL-2.1-or-later
"""Loops: validity with the place of the fault, size limits."""

import math

import numpy as np
import pytest

from BalloonWorkbench.core.errors import InputError, OutlineError
from BalloonWorkbench.core.geometry.polyline import signed_area
from BalloonWorkbench.core.outline import validity
from BalloonWorkbench.core.outline.outline import Outline


def rectangle(width, height, x=0.0, y=0.0):
    return np.array([[x, y], [x + width, y], [x + width, y + height], [x, y + height]])


def test_loops_are_oriented_and_keep_their_area():
    checked = validity.check(Outline(rectangle(0.3, 0.2)[::-1], (rectangle(0.1, 0.1, 0.05, 0.05),)))
    assert signed_area(checked.outer) == pytest.approx(0.06)
    assert signed_area(checked.holes[0]) == pytest.approx(-0.01)
    assert checked.area == pytest.approx(0.05)


def test_repeated_points_and_spikes_go_and_the_corners_stay():
    square = rectangle(0.1, 0.1)
    spike = [[0.1, 0.05], [0.15, 0.05], [0.1, 0.05]]
    drawn = np.vstack([square[:1], square[:2], square[1:2], spike, square[2:], square[:1]])
    checked = validity.check(Outline(drawn)).outer
    assert {tuple(p) for p in square.round(9)} <= {tuple(p) for p in checked.round(9)}
    assert len(checked) == 5  # the foot of the spike stays on the edge
    assert signed_area(checked) == pytest.approx(0.01)


@pytest.mark.parametrize(
    ("outer", "message"),
    [
        ([[0, 0], [0.01, 0.01], [0.01, 0], [0, 0.01]], r"crosses .* \(5, 5\) mm"),
        ([[0, 0], [0.02, 0], [0.02, 0.02], [0.01, 0], [0, 0.02]], r"touches itself at \(10, 0\) mm"),
        ([[0, 0], [0.01, 0], [0.02, 0]], "no area"),
        ([[0, 0], [0.01, 0]], "no area"),
        ([[0.5, 0.5]] * 6, "no area"),
        (np.zeros((0, 2)), "no area"),
        ([[0, 0], [0.01, math.nan], [0.01, 0.01]], "not a number"),
        ([[0, 0], [math.inf, 0], [0.01, 0.01]], "not a number"),
    ],
)
def test_a_bad_outline_says_what_and_where(outer, message):
    with pytest.raises(OutlineError, match=message):
        validity.check(Outline(np.array(outer, dtype=float)))


@pytest.mark.parametrize(
    ("hole", "message"),
    [
        (rectangle(0.05, 0.05, 0.08, 0.02), r"meets the outline .* \(100, "),
        (rectangle(0.05, 0.05, 0.05, 0.05), "meets the outline"),  # shares edges
        (rectangle(0.01, 0.01, 0.5, 0.5), "outside the outline"),
        (rectangle(0.02, 0.02, 0.035, 0.035), "in another hole"),
    ],
)
def test_a_bad_hole_says_what(hole, message):
    with pytest.raises(OutlineError, match=message):
        validity.check(Outline(rectangle(0.1, 0.1), (rectangle(0.04, 0.04, 0.03, 0.03), hole)))


def test_an_outline_is_scaled_to_fit():
    outline = Outline(rectangle(2.0, 1.0))
    assert validity.scale_to(outline, 0.3, None).size == pytest.approx((0.3, 0.15))
    assert validity.scale_to(outline, None, 0.3).size == pytest.approx((0.6, 0.3))
    assert validity.scale_to(outline, 0.3, 0.3).size == pytest.approx((0.3, 0.15))
    assert validity.scale_to(outline, 0.3, 0.1).size == pytest.approx((0.2, 0.1))
    assert validity.scale_to(outline, None, None) is outline


@pytest.mark.parametrize("width", [0.0, -0.3, 1e5, 9e-4, math.nan, math.inf])
def test_impossible_sizes_are_refused(width):
    for size in ((width, None), (None, width), (0.3, width)):
        with pytest.raises(InputError, match="between 1 mm and 100 m"):
            validity.scale_to(Outline(rectangle(2.0, 1.0)), *size)


def test_an_outline_of_impossible_own_size_is_refused():
    with pytest.raises(InputError, match="width of 300 m "):
        validity.scale_to(Outline(rectangle(300.0, 150.0)), None, None)
    with pytest.raises(InputError, match="height"):
        validity.scale_to(Outline(rectangle(1.0, 0.001)), 0.3, None)
    assert validity.scale_to(Outline(rectangle(300.0, 150.0)), 0.3, None).size == pytest.approx((0.3, 0.15))

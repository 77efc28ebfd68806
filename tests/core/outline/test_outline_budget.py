# SPDX-License-Identifier: LGPL-2.1-or-later
"""What reading a drawing may take, and the searches that keep it short, against the slow way."""

import numpy as np
import pytest

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry import crossings
from BalloonWorkbench.core.geometry.crossings import box_pairs, contains
from BalloonWorkbench.core.outline import budget as limits
from BalloonWorkbench.core.outline.budget import Budget


def test_points_elements_levels_and_time_have_an_end(monkeypatch):
    budget = Budget()
    budget.spend_points(limits.MOST_POINTS)
    with pytest.raises(InputError, match="more than 200000 points"):
        budget.spend_points(1)
    with pytest.raises(InputError, match="more than 100000 elements"):
        budget.spend_elements(limits.MOST_ELEMENTS + 1)
    with pytest.raises(InputError, match="show themselves"):
        Budget().spend_elements(float("inf"))
    for endless in (float("inf"), float("nan")):
        with pytest.raises(InputError, match="more than 200000 points"):
            Budget().spend_points(endless)
    with pytest.raises(InputError, match="inside each other"):
        budget.check_level(limits.MOST_LEVELS + 1)
    monkeypatch.setattr(limits, "_PAUSE", 0.0)
    with pytest.raises(InputError, match="takes more than 0 s"):
        Budget(0.0).check_time()


@pytest.mark.parametrize("chunk", [1, 7, 1_000_000])
def test_boxes_that_overlap_are_paired_once(chunk, monkeypatch):
    """Also in strips, into which they go when there are many above each other."""
    monkeypatch.setattr(crossings, "_CHUNK", chunk)
    random = np.random.default_rng(5)
    for wide, tall in ((0.3, 0.3), (0.9, 0.01), (0.01, 0.9), (0.0, 0.0)):
        low = random.uniform(size=(150, 2)).round(1)
        high = low + random.uniform(size=(150, 2)) * (wide, tall)
        slow = {
            (i, j)
            for i in range(150)
            for j in range(i)
            if (low[i] <= high[j]).all() and (low[j] <= high[i]).all()
        }
        pairs = [
            (max(i, j), min(i, j))
            for one, two in box_pairs(low, high)
            for i, j in zip(one.tolist(), two.tolist())
        ]
        assert len(pairs) == len(set(pairs))
        assert set(pairs) == slow


def test_very_many_boxes_are_compared_in_strips():
    """20 000 stripes above each other: each meets its neighbours alone, in a blink."""
    low = np.column_stack([np.zeros(20_000), np.arange(20_000.0)])
    high = low + 1.0
    assert crossings._strips(low, high) > 1000
    assert sum(len(one) for one, _ in box_pairs(low, high)) == 19_999


@pytest.mark.parametrize("chunk", [1, 1_000_000])
def test_points_inside_a_loop_are_those_of_an_even_odd_count(chunk, monkeypatch):
    monkeypatch.setattr(crossings, "_CHUNK", chunk)
    random = np.random.default_rng(6)
    loop = random.uniform(size=(40, 2)).round(1)
    points = np.concatenate([random.uniform(size=(60, 2)).round(1), random.uniform(size=(60, 2))])
    slow = np.zeros(len(points), dtype=bool)
    for (x1, y1), (x2, y2) in zip(loop, np.roll(loop, -1, axis=0)):
        for k, (x, y) in enumerate(points):
            if (y1 > y) != (y2 > y):
                slow[k] ^= x < (x2 - x1) * (y - y1) / (y2 - y1) + x1
    assert np.array_equal(contains(loop, points), slow)
    assert 10 < slow.sum() < 110

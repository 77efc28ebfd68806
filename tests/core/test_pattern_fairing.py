# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fairing: exact shapes stay, scatter goes, corners and the limit hold."""

from __future__ import annotations

import numpy as np
import pytest
from drawn_shapes import NAMED, polar

from BalloonWorkbench.core.pattern.arcs import fit_curve
from BalloonWorkbench.core.pattern.fairing import faired

MOST = 5e-5  # m


def moves(before: np.ndarray, after: np.ndarray) -> np.ndarray:
    return np.hypot(*(after - before).T)


@pytest.mark.parametrize("name", ["disc", "S", "neck"])
def test_smooth_shapes_stay(name: str) -> None:
    loop = NAMED[name].outer
    assert moves(loop, faired(loop)).max() < 0.1 * MOST or name != "disc"
    assert moves(loop, faired(loop)).max() <= MOST * (1.0 + 1e-9)


@pytest.mark.parametrize("name", ["square", "star", "L", "wedge"])
def test_polygons_stay(name: str) -> None:
    assert np.array_equal(faired(NAMED[name].outer), NAMED[name].outer)


def test_scatter_goes() -> None:
    """A circle of 100 mm with points up to 0.03 mm off: what is left is far less, and takes few arcs."""
    random = np.random.default_rng(1)
    turn = np.linspace(0.0, 2.0 * np.pi, 700, endpoint=False)
    loop = polar(0.1 + random.uniform(-3e-5, 3e-5, 700), turn)
    even = faired(loop)
    assert np.std(np.hypot(*even.T)) < 0.4 * np.std(np.hypot(*loop.T))
    assert moves(loop, even).max() <= MOST * (1.0 + 1e-9)
    assert len(fit_curve(even, True)) < 0.3 * len(fit_curve(loop, True))


def test_nothing_moves_farther() -> None:
    """Waves of 0.2 mm, which an even line would cut off, stay but for 0.05 mm."""
    turn = np.linspace(0.0, 2.0 * np.pi, 900, endpoint=False)
    loop = polar(0.1 + 2e-4 * np.cos(150 * turn), turn)
    assert 0.9 * MOST < moves(loop, faired(loop)).max() <= MOST * (1.0 + 1e-9)


def test_corners_keep_their_place() -> None:
    """A square with points every millimetre, scattered along its sides, corners not."""
    random = np.random.default_rng(2)
    side = np.stack([np.arange(0.0, 0.1, 0.001), random.uniform(-4e-5, 4e-5, 100)], axis=1)
    side[0] = 0.0
    turns = [np.array([[np.cos(a), np.sin(a)], [-np.sin(a), np.cos(a)]]) for a in np.arange(4) * np.pi / 2]
    starts = np.array([[0.0, 0.0], [0.1, 0.0], [0.1, 0.1], [0.0, 0.1]])
    loop = np.concatenate([start + side @ turn for start, turn in zip(starts, turns)])
    even = faired(np.roll(loop, 33, axis=0))
    even = np.roll(even, -33, axis=0)
    assert np.array_equal(even[::100], loop[::100])
    sides = np.abs(even[1:100, 1])
    assert sides.max() < np.abs(loop[1:100, 1]).max()
    assert len(fit_curve(even, True)) < 0.7 * len(fit_curve(loop, True))


def test_tips_do_not_cross() -> None:
    """The heart's formula has a tip whose sides are nearer to each other than the limit."""
    import shapely

    assert shapely.Polygon(faired(NAMED["heart"].outer)).is_valid

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fairing: smooth shapes stay, scatter goes, corners and the limit hold; distances by shapely."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from drawn_shapes import NAMED, generated, polar

from BalloonWorkbench.core.arcs.fit_arcs import fit_curve
from BalloonWorkbench.core.design.fairing import LIMIT, faired

TURN = np.linspace(0.0, 2.0 * np.pi, 700, endpoint=False)


def apart(before: np.ndarray, after: np.ndarray) -> float:
    """The largest distance between two loops, both ways [m]."""
    one, other = (shapely.LinearRing(loop).segmentize(3e-4) for loop in (before, after))
    return float(shapely.hausdorff_distance(one, other))


def scattered_circle() -> np.ndarray:
    """100 mm large, its points up to 0.03 mm off."""
    return polar(0.1 + np.random.default_rng(1).uniform(-3e-5, 3e-5, len(TURN)), TURN)


@pytest.mark.parametrize("name", ["disc", "heart", "flower", "S", "neck", "square", "star", "L", "wedge"])
def test_smooth_shapes_and_polygons_stay(name: str) -> None:
    assert np.array_equal(faired(NAMED[name].outer), NAMED[name].outer)


@pytest.mark.parametrize("seed", [0, 3, 8, 10])
def test_generated_shapes_stay(seed: int) -> None:
    assert np.array_equal(faired(generated(seed).outer), generated(seed).outer)


def test_scatter_goes() -> None:
    """What is left of a scattered circle are a few arcs, nearer to the circle than its points were."""
    even = faired(scattered_circle())
    assert apart(scattered_circle(), even) <= LIMIT
    assert len(fit_curve(even, True)) <= 5
    assert np.std(np.hypot(*even.T)) < 1.5e-5


def test_nothing_moves_farther() -> None:
    """Waves of 0.5 mm stay but for the limit, and the scatter upon them goes."""
    radius = 0.1 + 5e-4 * np.cos(20 * TURN) + np.random.default_rng(2).uniform(-3e-5, 3e-5, len(TURN))
    loop = polar(radius, TURN)
    even = faired(loop)
    assert 0.5 * LIMIT < apart(loop, even) <= 1.01 * LIMIT
    assert np.ptp(np.hypot(*even.T)) > 1e-3 - 2.0 * LIMIT
    assert len(fit_curve(even, True)) < 0.4 * len(fit_curve(loop, True))


def test_a_small_balloon_moves_less() -> None:
    loop = 0.5 * scattered_circle()
    assert apart(loop, faired(loop)) <= 0.1 / 3000.0
    tiny = 0.1 * scattered_circle()
    assert np.array_equal(faired(tiny), tiny)


def test_corners_keep_their_place() -> None:
    """A square with points every millimetre, scattered along its sides, corners not: four lines."""
    random = np.random.default_rng(2)
    side = np.stack([np.arange(0.0, 0.3, 0.001), random.uniform(-4e-5, 4e-5, 300)], axis=1)
    side[0] = 0.0
    turns = [np.array([[np.cos(a), np.sin(a)], [-np.sin(a), np.cos(a)]]) for a in np.arange(4) * np.pi / 2]
    starts = 0.3 * np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    loop = np.concatenate([start + side @ turn for start, turn in zip(starts, turns)])
    even = faired(np.roll(loop, 33, axis=0))
    for corner in starts:
        assert np.abs(even - corner).max(axis=1).min() < 1e-12
    curve = fit_curve(even, True)
    assert len(curve) <= 5  # one divided where the curve begins
    assert not curve.bulges.any()


def test_tips_do_not_cross() -> None:
    """The heart's formula has a tip whose sides are nearer to each other than the limit."""
    heart = NAMED["heart"].outer
    scatter = np.random.default_rng(5).uniform(-3e-5, 3e-5, heart.shape)
    scatter[np.abs(heart[:, 0]) < 0.005] = 0.0
    even = faired(heart + scatter)
    assert shapely.Polygon(heart + scatter).is_valid
    assert shapely.Polygon(even).is_valid
    assert len(fit_curve(even, True)) < 0.5 * len(fit_curve(heart + scatter, True))

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The division of a body does not hang on how it lies, on the order of its points, or on the last bits."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from solids import rounded_box

from BalloonWorkbench.core.segmentation.divide import divide
from BalloonWorkbench.core.targets.half_edges import euler_numbers, twins
from BalloonWorkbench.core.targets.read_target import read_target
from BalloonWorkbench.core.targets.target import Target

MESHES = Path(__file__).parents[2] / "resources" / "meshes"
#: Variants of which a panel was lost once; all of them in `make fuzz`.
VARIANTS = range(int(os.environ["BALLOON_VARIANTS"])) if "BALLOON_VARIANTS" in os.environ else (9, 17)


def fish() -> Target:
    return read_target(MESHES / "fish.obj", width=0.3)


def variant(target: Target, number: int) -> Target:
    """The body with other last bits, turned, or with its points and triangles in another order."""
    random = np.random.default_rng(number)
    points, triangles = target.points, target.triangles
    if number % 3 == 0:
        return Target(points * (1.0 + 1e-12 * random.normal(size=points.shape)), triangles)
    if number % 3 == 1:
        turn = np.linalg.qr(random.normal(size=(3, 3)))[0]
        return Target(points @ (turn * np.sign(np.linalg.det(turn))), triangles)
    order = random.permutation(len(points))
    triangles = np.argsort(order)[triangles][random.permutation(len(triangles))]
    return Target(points[order], np.roll(triangles, number % 2, axis=1).astype(np.int32))


@pytest.mark.slow
@pytest.mark.parametrize(("body", "count"), [(fish, 24), (rounded_box, 24)])
@pytest.mark.parametrize("number", VARIANTS)
def test_as_many_discs_however_the_body_is_given(body: Callable[[], Target], count: int, number: int) -> None:
    made = divide(variant(body(), number), count)
    areas = np.bincount(made.panels, made.target.areas, count) / made.target.areas.sum()
    assert len(made.names) == count
    assert areas.min() * count > 0.1
    opened = made.opened
    # cut open each panel is a surface of its own: no two share a vertex
    assert (euler_numbers(twins(opened.triangles), made.panels) == 1).all()


def test_last_bits_decide_nothing() -> None:
    """Other processors and libraries round otherwise."""
    target = fish()
    noise = np.random.default_rng(1).integers(-1, 2, target.points.shape)
    other = Target(target.points * (1.0 + 2.2e-16 * noise), target.triangles)
    np.testing.assert_array_equal(divide(other, 24).panels, divide(target, 24).panels)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""How thin an outline gets: necks, arms and strips, however narrow, and no tips."""

from __future__ import annotations

import numpy as np
import pytest

from BalloonWorkbench.core.errors import MeshError
from BalloonWorkbench.core.mesh.sizing import size_field
from BalloonWorkbench.core.mesh.thickness import fine_spacing, thickness
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.types import Floats

SPACING = 0.05


def rectangle(width: float, height: float, x: float = 0.0, y: float = 0.0) -> Floats:
    return np.array([[x, y], [x + width, y], [x + width, y + height], [x, y + height]])


def circle(radius: float, x: float = 0.0, y: float = 0.0) -> Floats:
    angle = 2.0 * np.pi * np.arange(400) / 400
    return np.column_stack([x + radius * np.cos(angle), y + radius * np.sin(angle)])


def neck(width: float) -> Outline:
    """Two squares with a neck between them."""
    low, high = 0.5 - 0.5 * width, 0.5 + 0.5 * width
    left = [[0, 0], [1, 0], [1, low], [2, low], [2, 0], [3, 0]]
    return Outline(np.array([*left, [3, 1], [2, 1], [2, high], [1, high], [1, 1], [0, 1]], dtype=float))


def thinnest(outline: Outline) -> tuple[float, Floats]:
    return thickness(outline, 2.5, fine_spacing(outline, SPACING, 1e-4)).thinnest


@pytest.mark.parametrize(
    ("outline", "width"),
    [
        (Outline(rectangle(1.0, 3.0)), 1.0),
        (Outline(circle(1.0), (circle(0.5)[::-1],)), 0.5),
        (Outline(np.array([[0, 0], [3, 0], [3, 1], [1, 1], [1, 3], [0, 3]], dtype=float)), 1.0),
        (Outline(rectangle(1.0, 1.0), (rectangle(0.03, 0.4, 0.2, 0.2)[::-1],)), 0.2),
        (Outline(rectangle(4.0, 0.3)), 0.3),
        (Outline(rectangle(1.0, 1.0), (circle(0.2, 0.25, 0.5)[::-1],)), 0.05),
        *((neck(width), width) for width in (0.1, 0.03, 0.01, 0.003)),
    ],
)
def test_width_of_the_thinnest_place(outline: Outline, width: float) -> None:
    """The narrowest necks are less than a tenth of the samples' distance at first."""
    assert thinnest(outline)[0] == pytest.approx(width, rel=0.06)


def test_the_thin_place_is_where_the_neck_is() -> None:
    x, y = thinnest(neck(0.01))[1]
    assert 1.0 <= x <= 2.0 and abs(y - 0.5) == pytest.approx(0.005)


def test_a_sharp_tip_is_not_thin() -> None:
    tip = Outline(np.array([[0.0, 0.0], [4.0, 0.0], [0.0, 1.0]]))
    assert thinnest(tip)[0] > 0.5
    assert fine_spacing(tip, SPACING, 1e-4) == SPACING


@pytest.mark.parametrize("width", [2e-5, 5e-4, 1e-3, 1.01e-3, 4e-3, 9e-3])
def test_a_strip_thinner_than_half_an_element_is_refused(width: float) -> None:
    """However near its walls are to each other: they may be nearer than the points that look for them."""
    with pytest.raises(MeshError, match="too thin for a mesh of 20 mm"):
        size_field(strip(width), 0.02)


def test_a_strip_thicker_than_half_an_element_is_meshed() -> None:
    assert size_field(strip(0.011), 0.02).at(np.array([[0.15, 0.0055]])) <= 0.011


def strip(width: float) -> Outline:
    return Outline(np.array([[0.0, 0.0], [0.3, 0.0], [0.3, width], [0.0, width]]))

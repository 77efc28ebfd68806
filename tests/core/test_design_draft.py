# SPDX-License-Identifier: LGPL-2.1-or-later
"""The quick look at a balloon: as large as the drawing, and near the known balloons."""

import numpy as np
import pytest

from BalloonWorkbench.core.design.draft import draft
from BalloonWorkbench.core.errors import Cancelled, MeshError
from BalloonWorkbench.core.film.library import DEFAULT_FILM, film
from BalloonWorkbench.core.outline.outline import Outline

FILM = film(DEFAULT_FILM)
PRESSURE = 2000.0


def disc(radius: float, count: int = 240) -> np.ndarray:
    turn = 2 * np.pi * np.arange(count) / count
    return radius * np.column_stack([np.cos(turn), np.sin(turn)])


def test_disc_is_nearly_the_mylar_balloon() -> None:
    """Paulsen, Amer. Math. Monthly 101 (1994): one of radius r is 1.1981 r thick and holds 2.7458 r^3."""
    radius = 0.15
    look = draft(Outline(disc(radius)), FILM, PRESSURE)
    positions = look.inflation.positions
    assert np.ptp(positions[:, 0]) == pytest.approx(2 * radius, rel=0.02)
    assert 2 * positions[:, 2].max() == pytest.approx(1.1981 * radius, rel=0.04)
    assert look.inflation.volume == pytest.approx(2.7458 * radius**3, rel=0.06)
    assert np.ptp(look.pattern.outer[:, 0]) == pytest.approx(1.3110 * 2 * radius, rel=0.04)


def test_look_lies_over_the_drawing() -> None:
    """The balloon has the middle and the size of the drawing's box; its panel is the drawing."""
    shape = np.array([[0.1, 0.2], [0.5, 0.2], [0.5, 0.3], [0.1, 0.4]])
    look = draft(Outline(shape), FILM, PRESSURE)
    flat = look.inflation.positions[:, :2]
    middle = 0.5 * (flat.min(axis=0) + flat.max(axis=0))
    assert middle == pytest.approx([0.3, 0.3], abs=0.01)
    assert np.ptp(flat, axis=0) == pytest.approx([0.4, 0.2], rel=0.02)
    panel = look.inflation.panel.rest_positions
    assert panel.min(axis=0) == pytest.approx([0.1, 0.2], abs=1e-3)
    assert panel.max(axis=0) == pytest.approx([0.5, 0.4], abs=1e-3)


def test_a_hole_stays_a_hole() -> None:
    look = draft(Outline(disc(0.15), (disc(0.06)[::-1],)), FILM, PRESSURE)
    inside = np.linalg.norm(look.inflation.panel.rest_positions, axis=1)
    assert inside.min() > 0.059
    assert len(look.pattern.holes) == 1


def test_a_line_is_no_balloon_yet() -> None:
    line = np.array([[0.0, 0.0], [0.3, 0.0], [0.3, 0.004], [0.0, 0.004]])
    with pytest.raises(MeshError, match="it is a line"):
        draft(Outline(line), FILM, PRESSURE)


def test_it_stops_when_told() -> None:
    with pytest.raises(Cancelled):
        draft(Outline(disc(0.15)), FILM, PRESSURE, progress=lambda fraction, text: False)

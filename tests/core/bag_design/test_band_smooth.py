# SPDX-License-Identifier: LGPL-2.1-or-later
"""Patterns of letters with a side band are fit to cut: smooth along their rims, equal pieces equally long.

BALLOON_BAGS above 50 (`make fuzz`) tries those without a hole or corners, too.
"""

from __future__ import annotations

import os

import numpy as np
import pytest
from drawn_letters import letter_outline

from BalloonWorkbench.core.bag_design.bag_design import BagDesign
from BalloonWorkbench.core.bag_design.band_fit import fit_band
from BalloonWorkbench.core.bodies.banded import SideBand, banded_bag
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.types import Floats

PIECE = 0.5
ALL = int(os.environ.get("BALLOON_BAGS", "1")) > 50
EDGE = None if ALL else 0.014  # [m]; an automatic mesh is finer
WINDOW, SPACING = 0.01, 0.002  # over which the rim's turning is measured [m]


def oval(a: float, b: float, count: int, start: float = 0.1) -> Floats:
    angles = start + 2.0 * np.pi * np.arange(count) / count
    return np.stack([a * np.cos(angles), b * np.sin(angles)], axis=1)


def disc(count: int) -> Outline:
    return Outline(oval(0.15, 0.15, count))


def ring(count: int, inner: int) -> Outline:
    return Outline(oval(0.15, 0.15, count), (oval(0.06, 0.06, inner)[::-1],))


def designed(outline: Outline) -> BagDesign:
    return fit_band(outline, SideBand(0.04, PIECE), film("mylar"), 2000.0, mesh_size=EDGE)


def turning_changes(loop: Floats, least: float) -> int:
    """How often a closed loop begins to turn the other way, by more than so much [deg] within WINDOW."""
    closed = np.vstack([loop, loop[:1]])
    along = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(closed, axis=0), axis=1)))
    at = np.arange(0.0, along[-1], SPACING)
    places = np.stack([np.interp(at, along, column) for column in closed.T], axis=1)
    x, y = (np.roll(places, -1, axis=0) - places).T
    angles = np.arctan2(y, x)
    turns = np.roll(angles, -round(WINDOW / SPACING)) - angles
    turns = np.degrees(np.mod(turns + np.pi, 2.0 * np.pi) - np.pi)
    senses = np.sign(turns[np.abs(turns) > least])
    return int((senses != np.roll(senses, 1)).sum())


def waviness(loop: Floats) -> float:
    """Half of what the radius varies by, as a part of it."""
    radii = np.linalg.norm(loop - 0.5 * (loop.min(axis=0) + loop.max(axis=0)), axis=1)
    return float(0.5 * np.ptp(radii) / radii.mean())


ROUND = {"ring": ring(101, 61), **({"disc": disc(97)} if ALL else {})}
#: How often the rims of a sign may turn otherwise; a ring is round as an O is.
LETTERS = {"B": (16, 6, 6), **({"O": (0, 0)} if ALL else {})}


@pytest.mark.parametrize("outline", ROUND.values(), ids=ROUND)
def test_what_is_round_is_cut_round(outline: Outline) -> None:
    """The film crumples along the rim; the pattern does not. Polygons of prime numbers are round, too."""
    design = designed(outline)
    for loop in design.bag.panels[0].loops:
        assert waviness(loop) < 1e-3
        assert turning_changes(loop, 0.6) == 0
    pieces = [float(np.ptp(panel.outer[:, 0])) for panel in design.bag.panels[2:5]]
    assert np.ptp(pieces) < 5e-5
    assert design.residual is not None
    assert design.residual.mean < 0.01 * design.size


@pytest.mark.parametrize(("sign", "most"), LETTERS.items())
def test_a_letter_turns_hardly_more_often_than_it_is_drawn(sign: str, most: tuple[int, ...]) -> None:
    """Beside each of its corners the rim of a face bends in, which makes two changes."""
    design = designed(letter_outline("sans bold", sign))
    changes = [turning_changes(loop, 0.6) for loop in design.bag.panels[0].loops]
    assert all(found <= limit for found, limit in zip(changes, most, strict=True))
    if sign == "O":
        lengths = [float(np.ptp(panel.outer[:, 0])) for panel in design.bag.panels[2:]]
        assert np.ptp(lengths[:2]) < 5e-5
        assert np.ptp(lengths[2:]) < 5e-5


@pytest.mark.parametrize("count", [12, 97])
def test_equal_pieces_come_out_equal_without_correction(count: int) -> None:
    bag = banded_bag(disc(count), 0.04, 0.35)
    pieces = [float(np.ptp(panel.outer[:, 0])) for panel in bag.panels[2:]]
    assert len(pieces) > 2
    assert max(pieces) <= 0.35
    if count > 12:  # the twelve have corners, at which pieces meet
        assert np.ptp(pieces) < 5e-5

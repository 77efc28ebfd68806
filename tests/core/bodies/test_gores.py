# SPDX-License-Identifier: LGPL-2.1-or-later
"""Flat gores: their widths, their ends, what is sealed to what."""

import numpy as np
import pytest
from profiles import PROFILES, airship, bell, bottle, cone, sphere

from BalloonWorkbench.core.bags.bag import Bag, Side
from BalloonWorkbench.core.bags.check_bag import check_bag
from BalloonWorkbench.core.bodies.gores import gored_bag, plain_gores
from BalloonWorkbench.core.bodies.profile import Profile
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.polyline import length, perimeter
from BalloonWorkbench.core.types import Floats


def along(bag: Bag, side: Side, *, against: bool) -> Floats:
    return bag.panels[side.panel].loops[side.loop][side.points(bag.panels, against=against)]


@pytest.mark.parametrize("name", PROFILES)
@pytest.mark.parametrize("count", [3, 6, 13])
def test_gores_are_sealed_all_round_with_equal_lengths(name: str, count: int) -> None:
    bag = gored_bag(PROFILES[name](), count)
    check_bag(bag, opening_needed=False)
    cut = [seam for seam in bag.seams if all(bag.panels[side.panel].cut for side in seam.sides)]
    assert len(cut) >= count  # what closes an open end is gathered
    for seam in cut:
        one, other = length(along(bag, seam.a, against=False)), length(along(bag, seam.b, against=True))
        assert one == pytest.approx(other, rel=1e-9)


def test_gores_of_a_sphere_are_sinusoidal() -> None:
    bag = gored_bag(sphere(2.0), 8)
    y, x = bag.panels[0].outer.T
    assert np.ptp(y) == pytest.approx(2.0 * np.pi, rel=1e-4)
    latitude = y / 2.0 - 0.5 * np.pi
    assert np.abs(x) == pytest.approx(2.0 * np.pi / 8 * np.cos(latitude), abs=1e-3)
    assert all(panel.outer is bag.panels[0].outer for panel in bag.panels)
    assert [panel.name for panel in bag.panels][-1] == "gore 8"


def test_gores_of_a_cone_are_its_sectors() -> None:
    """All edges as long as the slant, and the lower end a part of a circle round the tip."""
    bag = gored_bag(cone(0.25, 0.6), 5)
    outer, slant = bag.panels[0].outer, 0.65
    tip = outer[np.argmax(outer[:, 0])]
    away = np.linalg.norm(outer - tip, axis=1)
    assert away[outer[:, 0] < 0.03] == pytest.approx(slant, rel=0.02)
    assert np.ptp(away[outer[:, 0] < 0.03]) < 2e-3 * slant + 0.02
    # the disc is as large as the cone is around, but for what a flat arc is longer than a plain width
    disc = bag.panels[-1].outer
    assert perimeter(disc) == pytest.approx(2.0 * np.pi * 0.25, rel=0.03)


def test_an_open_end_is_closed_by_a_disc_that_is_not_cut() -> None:
    bag = gored_bag(bell(), 6)
    assert [panel.cut for panel in bag.panels] == [True] * 6 + [False]
    assert bag.opening is None
    closed = gored_bag(bottle(), 6)
    assert [panel.cut for panel in closed.panels] == [True] * 8
    assert closed.opening is not None


def test_the_opening_is_in_a_seam_away_from_the_poles() -> None:
    bag = gored_bag(airship(), 6)
    assert bag.opening is not None
    outer = bag.panels[bag.opening.panel].outer
    edge = outer[[bag.opening.at, bag.opening.at + 1]]
    assert (edge[:, 1] < -0.05).all() and 0.1 < edge[0, 0] / np.ptp(outer[:, 0]) < 0.2


@pytest.mark.parametrize("count", [2, 101, -1])
def test_too_few_and_too_many_gores_are_refused(count: int) -> None:
    with pytest.raises(InputError, match="Take 3 to 100"):
        gored_bag(sphere(), count)


def test_corners_of_a_profile_are_corners_of_the_edges() -> None:
    line = np.array([(0.0, 0.0), (0.2, 0.1), (0.2, 0.7), (0.0, 1.0)])
    gores = plain_gores(Profile(line), 6)
    at = np.linalg.norm(np.diff(line, axis=0), axis=1).cumsum()
    assert np.isin(np.round(at, 9), np.round(gores.along, 9)).all()

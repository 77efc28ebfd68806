# SPDX-License-Identifier: LGPL-2.1-or-later
"""The disc that pulls a profile's film along the profile, against closed forms and the inflated disc."""

import numpy as np
import pytest

from BalloonWorkbench.core.bodies.loose_disc import loose_radius
from BalloonWorkbench.core.bodies.profile import DISC, Profile

MYLAR = (
    1.3110287771  # meridian of an inflated balloon of two discs, from its middle to its rim, by its radius
)


def leaning(degrees: float, radius: float = 0.3) -> Profile:
    """A straight profile that leaves a disc at this angle to its plane; the upper end mirrors it."""
    turn = np.radians(degrees)
    foot = np.array([radius, 0.0])
    ahead = foot + 0.2 * radius * np.array([np.cos(turn), np.sin(turn)])
    return Profile(
        np.array([foot, ahead, ahead * (1.0, 0.0) + (0.0, 1.0 - ahead[1]), (radius, 1.0)]), DISC, DISC
    )


@pytest.mark.parametrize("end", [0, -1])
def test_a_straight_wall_has_half_an_inflated_disc(end: int) -> None:
    assert loose_radius(leaning(90.0), end) == pytest.approx(0.3 * MYLAR, rel=1e-4)


def test_a_profile_that_goes_on_flat_has_a_disc_of_its_own_size() -> None:
    assert loose_radius(leaning(0.2), 0) == pytest.approx(0.3, rel=1e-3)


@pytest.mark.parametrize("degrees", [30.0, 60.0, 110.0, 130.0])
def test_the_meridian_of_the_disc_meets_the_profile_at_its_angle(degrees: float) -> None:
    """Its curvature is 2 r / a^2 at a radius r (Paulsen): followed in small steps from the middle."""
    radius, turn = 0.3, np.radians(degrees)
    widest = radius / np.sqrt(np.sin(turn))
    steps = 200_000
    step = loose_radius(leaning(degrees), 0) / steps
    r = angle = 0.0
    for _ in range(steps):
        middle = r + 0.5 * step * np.cos(angle)
        angle += step * 2.0 * middle / widest**2
        r += step * np.cos(angle - step * middle / widest**2)
    assert r == pytest.approx(radius, rel=1e-3)
    assert angle == pytest.approx(turn, rel=1e-3)

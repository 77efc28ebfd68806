# SPDX-License-Identifier: LGPL-2.1-or-later
"""An accuracy finds the fewest panels in four balloons; the curve says what more panels buy."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest
from solids import ball

from BalloonWorkbench.core.errors import Cancelled, InputError
from BalloonWorkbench.core.film.library import film as film_named
from BalloonWorkbench.core.target_design.panel_count import MOST, TRIES, CountSearch, fit_body_to_accuracy
from BalloonWorkbench.core.target_design.panel_curve import CurvePoint, curve_point, envelope, panel_curve

POLYESTER = film_named("mylar")
PRESSURE = 1000.0


def searched(law: Callable[[int], float], accuracy: float, start: int) -> CountSearch:
    """The search after as many balloons as it may take, where they follow a law."""
    search, count = CountSearch(accuracy), start
    for _ in range(TRIES):
        search.errors[count] = law(count)
        following = search.next()
        if following is None:
            break
        count = following
    return search


@pytest.mark.parametrize("power", [0.4, 1.0, 2.0])
@pytest.mark.parametrize("start", [6, 12, 30])
@pytest.mark.parametrize("wanted", [8, 15, 33])
def test_four_balloons_find_the_fewest_panels_of_a_law(power: float, start: int, wanted: int) -> None:
    """Within a fifth, of laws c / n^power for which exactly the wanted number is needed."""
    search = searched(lambda count: 0.01 * (wanted / count) ** power, 0.01 * (1.0 + 1e-9), start)
    assert search.reaching is not None
    assert wanted <= search.reaching <= 1.2 * wanted


def test_what_no_number_reaches_is_tried_up_to_the_most() -> None:
    search = searched(lambda count: 0.004 + 0.01 / count, 0.003, 12)
    assert search.reaching is None
    assert max(search.errors) == MOST
    assert len(search.errors) <= TRIES


def test_a_number_without_a_balloon_is_no_end() -> None:
    search = searched(lambda count: math.inf if count < 20 else 0.05 / count, 0.002, 12)
    assert search.reaching is not None
    assert search.reaching >= 25


@pytest.mark.slow
def test_a_ball_takes_no_more_panels_than_gores_would() -> None:
    """16 %/n^2 of gored spheres: 1 % takes 4."""
    design = fit_body_to_accuracy(ball(count=8), 0.01, POLYESTER, PRESSURE, mesh_size=0.3)
    assert design.reached
    assert design.residual is not None
    assert design.residual.mean <= 0.01 * design.size
    assert len(design.bag.panels) == 4


@pytest.mark.parametrize("accuracy", [0.0, -0.1, 1.0, math.nan])
def test_an_accuracy_is_a_part_of_the_diagonal(accuracy: float) -> None:
    with pytest.raises(InputError, match="above 0 and below 1"):
        fit_body_to_accuracy(ball(), accuracy, POLYESTER, PRESSURE)


def test_the_envelope_only_falls() -> None:
    points = [CurvePoint(n, error) for n, error in ((6, 0.5), (8, 0.3), (12, 0.4), (16, 0.25), (24, 0.25))]
    points.append(CurvePoint(10, math.inf, problem="Panel '3' crosses itself."))
    assert [point.panels for point in envelope(points[::-1])] == [6, 8, 16]
    assert envelope([]) == ()


def test_a_count_without_a_balloon_says_why() -> None:
    point = curve_point(ball(), 0, POLYESTER, PRESSURE)
    assert "divided into 2 to" in point.problem
    assert math.isinf(point.error)


@pytest.mark.slow
def test_the_curve_stops_between_two_counts_and_goes_on() -> None:
    body, told = ball(count=8), []

    def until_half(fraction: float, text: str) -> bool:
        told.append(fraction)
        return fraction < 0.5

    with pytest.raises(Cancelled):
        panel_curve(body, POLYESTER, PRESSURE, (6, 8), progress=until_half)
    assert told == sorted(told)
    assert curve_point.knows(body, 6, POLYESTER, PRESSURE)
    assert not curve_point.knows(body, 8, POLYESTER, PRESSURE)
    (six,) = panel_curve(body, POLYESTER, PRESSURE, (6,))
    assert six.error <= 0.16 / 6**2

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the intake of many panels is wanted: on any seam, how far along it, or in the middle of a panel."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pytest
import shapely
from drawn_shapes import NAMED
from made_bags import BAGS

from BalloonWorkbench.core.bag_pattern.bag_patterns import BagPatterns
from BalloonWorkbench.core.bag_pattern.make import bag_patterns
from BalloonWorkbench.core.bags.bag import Opening
from BalloonWorkbench.core.bags.opening import bag_with_opening
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.pattern.make import make_pattern
from BalloonWorkbench.core.pattern.pattern import Role

FILM = film("bopp-foil")
#: A seam of the ring's inner side.
HOLE = next(number for number, seam in enumerate(BAGS["ring"].seams, 1) if seam.a.loop)


@cache
def made(name: str, opening: str, **options: Any) -> BagPatterns:
    return bag_patterns(BAGS[name], FILM, PatternOptions(opening=opening, **options))


def shares(name: str, patterns: BagPatterns) -> dict[int, float]:
    """Where the welds of the panels are open along the opening's seam, as parts of its length."""
    bag = BAGS[name]
    (number,) = (step.seam for step in patterns.order if step.opening)
    seam, found = bag.seams[number - 1], {}
    for side, against in ((seam.a, False), (seam.b, True)):
        pattern = patterns.pattern_of(side.panel)
        assert pattern is not None
        (seal,) = [each for each in pattern.of(Role.SEAL) if not each.closed]
        ends = seal.points[[0, -1]].mean(axis=0) - patterns.shifts[patterns.panels.index(side.panel)]
        line = shapely.LineString(bag.panels[side.panel].outer[side.points(bag.panels, against=against)])
        found[side.panel] = line.project(shapely.Point(ends), normalized=True)
    return found


@pytest.mark.parametrize(
    ("name", "opening", "share"),
    [
        ("ball", "3", 0.3),
        ("ball", "7", 0.5),
        ("letter M", "2", 0.6),
        ("box", "12", 0.4),
        ("airship", "8", 0.5),
    ],
)
def test_any_seam_is_chosen_by_its_number(name: str, opening: str, share: float) -> None:
    patterns = made(name, opening, opening_share=share, intake_width=0.006)
    seam = BAGS[name].seams[int(opening) - 1]
    assert next(step.seam for step in patterns.order if step.opening) == int(opening)
    found = shares(name, patterns)
    assert set(found) == {seam.a.panel, seam.b.panel}
    assert list(found.values()) == pytest.approx([share, share], abs=0.03)


def test_without_a_share_it_is_in_the_middle_of_the_seam() -> None:
    assert list(shares("ball", made("ball", "4")).values()) == pytest.approx([0.5, 0.5], abs=0.01)


def test_an_edge_is_chosen_by_panel_and_point() -> None:
    assert bag_with_opening(BAGS["box"], "side 2.2").opening == Opening(1, 2)
    assert set(shares("box", made("box", "side 2.2"))) == {1, 5}


def test_a_bag_without_an_opening_gets_one() -> None:
    closed = replace(BAGS["box"], opening=None)
    patterns = bag_patterns(closed, FILM, PatternOptions(opening="12"))
    assert sum(step.opening for step in patterns.order) == 1


@pytest.mark.parametrize(("name", "panel"), [("box", "top"), ("ball", "gore 3"), ("ring", "front")])
def test_a_nozzle_sits_in_the_middle_of_a_panel(name: str, panel: str) -> None:
    patterns = made(name, panel, intake_kind="nozzle")
    number = patterns.names.index(panel)
    own = [pattern.intake is not None for pattern in patterns.patterns]
    assert own == [place == number for place in range(len(own))]
    pattern = patterns.patterns[number]
    (hole,) = [cut for cut in pattern.of(Role.CUT_INNER) if np.ptp(cut.points, axis=0).max() < 0.01]
    film_of = shapely.Polygon(BAGS[name].panels[patterns.panels[number]].outer)
    film_of = film_of.difference(
        shapely.union_all([shapely.Polygon(h) for h in BAGS[name].panels[number].holes])
    )
    middle = shapely.Point(hole.points.mean(axis=0) - patterns.shifts[number])
    radius = shapely.maximum_inscribed_circle(film_of).length
    assert middle.distance(film_of.boundary) == pytest.approx(radius, rel=0.02)
    assert all(seal.closed for pattern in patterns.patterns for seal in pattern.of(Role.SEAL))
    flange = shapely.Point(hole.points.mean(axis=0)).buffer(0.012)
    marks = [each for role in (Role.PEN, Role.ENGRAVE) for each in pattern.of(role)]
    on_it = [mark for mark in marks if shapely.LineString(mark.points).intersects(flange)]
    assert not on_it


@pytest.mark.parametrize(
    ("name", "options", "said"),
    [
        ("box", {"opening": "13"}, "no seam 13 .* 1 to 12"),
        ("box", {"opening": "lid.1"}, '"lid.1" is no edge of a panel: .* side 1.0'),
        ("box", {"opening": "top.9"}, '"top.9" is no edge'),
        ("box", {"opening": "top"}, "Panel top: an intake of this kind leads through a seam"),
        ("box", {"opening": "2", "opening_share": 1.5}, "from 0 to 1"),
        ("envelope", {"opening": "11"}, "Seam 11 is at an end that stays open"),
        ("envelope", {"opening": "lower disc", "intake_kind": "nozzle"}, "lower disc is not cut"),
        ("ring", {"opening": str(HOLE)}, "cannot lead into a hole of panel front"),
        ("box", {"opening": "top", "intake_kind": "nozzle", "intake_length": 0.5}, "Panel top: .* no room"),
    ],
)
def test_what_cannot_be_is_said_in_a_sentence(name: str, options: dict[str, Any], said: str) -> None:
    with pytest.raises(InputError, match=said):
        bag_patterns(BAGS[name], FILM, PatternOptions(**options))


def test_what_has_no_effect_is_told() -> None:
    angled = bag_patterns(BAGS["box"], FILM, PatternOptions(intake_angle=1.0))
    assert any("direction" in warning for warning in angled.warnings)
    two = make_pattern(NAMED["disc"], FILM.seal_width, PatternOptions(opening="2"))
    assert any("one seam" in warning for warning in two.warnings)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Patterns of many panels: nothing crosses, marks match, the weld stays whole, the neck is on both edges."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import shapely
from made_bags import BAGS, FILM, drum, made

from BalloonWorkbench.core.bag_pattern.make import bag_patterns
from BalloonWorkbench.core.bags.bag import Opening
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.machines.machine import machines
from BalloonWorkbench.core.machines.preflight import preflight
from BalloonWorkbench.core.making.bag_numbers import bag_pieces
from BalloonWorkbench.core.nesting import nest as nesting
from BalloonWorkbench.core.nesting.layout import Stock
from BalloonWorkbench.core.nesting.nest import nest
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.pattern.pattern import Pattern, Role

SEAL, ALLOWANCE = FILM.seal_width, PatternOptions.allowance


def welds(pattern: Pattern) -> shapely.Geometry:
    return shapely.MultiLineString([seal.line for seal in pattern.of(Role.SEAL)])


@pytest.mark.parametrize("name", sorted(BAGS))
def test_nothing_crosses_and_nothing_overlaps(name: str) -> None:
    patterns = made(name)
    errors = [
        finding.text
        for finding in preflight(patterns.sheet, machines()["any-dxf"])
        if finding.severity == "error"
    ]
    assert not errors
    films = [shapely.Polygon(cut.points) for cut in patterns.sheet.of(Role.CUT)]
    assert len(films) == len(patterns.patterns) + len(patterns.pieces)
    near = shapely.STRtree(films).query(films, predicate="dwithin", distance=0.004)
    assert (near[0] == near[1]).all()


@pytest.mark.parametrize("name", ["drum", "airship", "ring", "ready pouch"])
def test_notches_and_tabs_leave_the_weld_whole_and_begin_at_the_cut(name: str) -> None:
    for pattern in made(name).patterns:
        edges = shapely.MultiLineString(
            [c.line for role in (Role.CUT, Role.CUT_INNER) for c in pattern.of(role)]
        )
        for notch in pattern.of(Role.NOTCH):
            assert edges.distance(shapely.Point(notch.points[0])) < 1e-6
            assert shapely.LineString(notch.points).distance(welds(pattern)) > 0.5 * SEAL - 1e-5


def test_groups_of_notches_stand_at_the_same_shares_of_both_edges() -> None:
    """Of a ball without a neck, whose seams end in the poles: along the meridian's length from below."""
    patterns = made("ball", intake=False)
    seam = patterns.seams[0]
    places = []
    for panel, side in zip(seam.panels, (1.0, -1.0)):
        pattern = patterns.patterns[panel].moved(-patterns.shifts[panel])
        outer = BAGS["ball"].panels[panel].outer
        right = [notch.points[0] for notch in pattern.of(Role.NOTCH) if side * notch.points[0][1] < 0.0]
        half = len(outer) // 2
        edge = outer[: half + 1] if side > 0.0 else np.concatenate([outer[half:], outer[:1]])[::-1]
        line = shapely.LineString(edge)
        places.append(sorted(line.project(shapely.Point(point)) for point in right))
    assert places[0] == pytest.approx(places[1], abs=2e-5)
    gaps = np.diff(places[0])
    groups = np.split(np.arange(len(gaps) + 1), np.flatnonzero(gaps > 0.01) + 1)
    assert [len(group) for group in groups] == [1, 2, 3, 1, 2][: len(groups)]
    middles = [np.mean([places[0][k] for k in group]) for group in groups]
    shares = np.array(middles) / seam.length_a
    assert shares == pytest.approx(np.arange(1, len(groups) + 1) / (len(groups) + 1), abs=1e-3)


def test_seam_and_cut_keep_their_distance_from_the_seam() -> None:
    patterns = made("drum", intake=False)
    top = patterns.patterns[0].moved(-patterns.shifts[0])
    (seal,), (cut,) = top.of(Role.SEAL), top.of(Role.CUT)
    assert np.linalg.norm(seal.points, axis=1) == pytest.approx(0.15 + 0.5 * SEAL, abs=1e-4)
    assert np.linalg.norm(cut.points, axis=1) == pytest.approx(0.15 + SEAL + ALLOWANCE, abs=1e-4)


@pytest.mark.parametrize("name", ["box", "drum", "ball", "ring", "ready beach-ball"])
def test_the_neck_leaves_both_edges_at_one_place(name: str) -> None:
    with_neck = made(name)
    mouths = []
    for panel, pattern, shift in zip(with_neck.panels, with_neck.patterns, with_neck.shifts):
        open_seals = [seal for seal in pattern.of(Role.SEAL) if not seal.closed]
        if open_seals:
            (seal,) = open_seals
            mouths.append((panel, 0.5 * (seal.points[0] + seal.points[-1]) - shift, seal))
    seam = BAGS[name].seams[next(step.seam for step in with_neck.order if step.opening) - 1]
    assert sorted(panel for panel, *_ in mouths) == sorted({seam.a.panel, seam.b.panel})
    lengths = []
    for side, against in ((seam.a, False), (seam.b, True)):
        loops = BAGS[name].panels[side.panel].loops
        line = shapely.LineString(loops[side.loop][side.points(BAGS[name].panels, against=against)])
        middle = next(at for number, at, _ in mouths if number == side.panel)
        lengths.append(line.project(shapely.Point(middle)))
    assert lengths[0] == pytest.approx(lengths[1], abs=3e-4)
    ends = [np.linalg.norm(seal.points[0] - seal.points[-1]) for _, _, seal in mouths]
    assert ends == pytest.approx([0.01 + SEAL] * len(ends), rel=0.05)


def test_the_opening_keeps_away_from_the_ends_of_its_seam() -> None:
    ball = replace(BAGS["ball"], opening=Opening(0, 0))
    patterns = bag_patterns(ball, FILM, PatternOptions())
    (intake,) = [pattern.intake for pattern in patterns.patterns if pattern.intake is not None]
    tip = BAGS["ball"].panels[0].outer[0] + patterns.shifts[0]
    assert np.linalg.norm(intake.at - tip) > 2.0 * SEAL


def test_an_envelope_is_open_below_and_needs_no_neck() -> None:
    patterns = made("envelope")
    for pattern, shift in zip(patterns.patterns, patterns.shifts):
        assert pattern.intake is None
        (seal,) = pattern.of(Role.SEAL)
        assert not seal.closed
        gore = BAGS["envelope"].panels[0].outer
        low = gore[gore[:, 0] < np.sort(gore[:, 0])[2], :].mean(axis=0) + shift
        assert shapely.LineString(seal.points).distance(shapely.Point(low)) > 0.01


def test_what_cannot_be_made_is_said_in_a_sentence() -> None:
    small = drum(0.004, 0.01, 24)
    for bag, options, said in (
        (replace(BAGS["box"], opening=None), PatternOptions(), "has no opening"),
        (replace(BAGS["box"], opening=Opening(5, 9)), PatternOptions(), "Panel top has no edge 9"),
        (small, PatternOptions(), "is .* long, and the intake takes"),
        (BAGS["box"], PatternOptions(seal_width=2.0), "seal width must be"),
        (BAGS["box"], PatternOptions(copies=0), "copies"),
        (BAGS["box"], PatternOptions(corner_radius=0.05, intake=False), "Panel side 1: .*corner relief"),
    ):
        with pytest.raises(InputError, match=said):
            bag_patterns(bag, FILM, options)


def test_poles_of_many_gores_are_capped() -> None:
    assert made("ball").caps == 2
    assert made("box").caps == 0
    (cap, _) = made("ball").pieces
    assert np.ptp(cap.of(Role.CUT)[0].points, axis=0) == pytest.approx([6.0 * SEAL, 6.0 * SEAL], rel=1e-3)


def test_a_film_valve_has_its_strips_beside_the_panels_once() -> None:
    patterns = bag_patterns(BAGS["box"], film("pe"), PatternOptions(intake_kind="film-valve"))
    stocks = [piece.stocks for piece in patterns.pieces]
    assert stocks.count(("valve",)) == len(patterns.pieces) - patterns.caps > 0
    assert patterns.sheet.stocks == ("", "valve")


def test_copies_of_the_balloon_are_all_on_the_sheet() -> None:
    one, three = made("box"), made("box", copies=3)
    assert len(three.sheet.of(Role.CUT)) == 3 * len(one.sheet.of(Role.CUT))
    assert three.film_area == pytest.approx(one.film_area)


@pytest.mark.slow
def test_all_panels_are_laid_out_on_film(monkeypatch: pytest.MonkeyPatch) -> None:
    """In rows: the search does not make or lose any."""
    monkeypatch.setattr(nesting, "PACKAGE", "no_such_package")
    patterns = made("ready tetrahedron")
    pieces = bag_pieces(patterns, 2, None)
    layouts, _ = nest(pieces, Stock(1.0))
    assert sum(len(layout.places) for layout in layouts) == 2 * (
        len(patterns.patterns) + len(patterns.pieces)
    )


def test_names_and_which_piece_it_is_are_on_each_panel() -> None:
    patterns = made("box")
    assert patterns.names == ("side 1", "side 2", "side 3", "side 4", "bottom", "top")
    assert all(pattern.of(Role.ENGRAVE) for pattern in patterns.patterns)
    named = [len(pattern.of(Role.ENGRAVE)) for pattern in patterns.patterns]
    assert named[4] > named[5]  # bottom 5/6, top 6/6


def test_the_grain_is_marked_where_the_film_has_one() -> None:
    def lines(grain: bool) -> int:
        pattern = bag_patterns(BAGS["box"], replace(FILM, grain=grain), PatternOptions()).patterns[0]
        return len(pattern.of(Role.PEN))

    assert lines(True) - lines(False) == 3

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Seams of bags: how flat they lie, where tabs are, which panels are equal, what is joined first."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from made_bags import BAGS, made, rectangle

from BalloonWorkbench.core.bag_pattern.copies import panel_copies
from BalloonWorkbench.core.bag_pattern.order import CLOSE, JOIN, LAST
from BalloonWorkbench.core.bag_pattern.seams import seam_marks, side_lines
from BalloonWorkbench.core.bag_pattern.tabs import tab_shares
from BalloonWorkbench.core.bags.bag import Bag, BagPanel, BagSeam, Side
from BalloonWorkbench.core.film.library import film

FILM = film("bopp-foil")


def test_a_band_turns_once_round_each_disc() -> None:
    """2 pi in all round a disc, nothing where the band's ends meet."""
    marks = seam_marks(BAGS["drum"])
    assert sum(mark.flatness for mark in marks[:2]) == pytest.approx(2.0 * np.pi, rel=1e-3)
    assert sum(mark.flatness for mark in marks[2:4]) == pytest.approx(2.0 * np.pi, rel=1e-3)
    assert marks[4].flatness == pytest.approx(0.0, abs=1e-9)
    assert marks[0].length_a == pytest.approx(np.pi * 0.15, rel=1e-3)


@pytest.mark.parametrize("name", ["box", "ball", "ready tetrahedron"])
def test_gores_and_straight_edges_are_sealed_lying_flat(name: str) -> None:
    assert max(mark.flatness for mark in seam_marks(BAGS[name])) < 1e-6


def test_edges_that_bulge_the_same_way_lie_on_each_other_and_those_in_and_out_too() -> None:
    """One arc bulges out of its panel, the other into its own: laid on each other they part by both bends."""
    angles = np.linspace(-0.5, 0.5, 41)
    arc = np.column_stack([np.cos(angles) - np.cos(0.5), np.sin(angles)])
    left = np.array([[-1.0, arc[-1, 1]], [-1.0, arc[0, 1]]])
    bulging = BagPanel("bulging", np.concatenate([arc, left]))
    hollow = BagPanel("hollow", np.concatenate([arc * (-1.0, 1.0), left]))
    along, back = Side(0, 0, 40), Side(1, 40, 0)
    for other, turns in ((bulging, 0.0), (hollow, 2.0)):
        bag = Bag((bulging, other), (BagSeam(along, back),))
        assert seam_marks(bag)[0].flatness == pytest.approx(turns, rel=1e-2, abs=1e-9)


def test_only_the_straighter_side_is_cut_into_tabs() -> None:
    drum = BAGS["drum"]
    for number, straight in ((0, 1), (2, 0)):  # the band is the second side above, the first below
        shares = tab_shares(*side_lines(drum, drum.seams[number]), 0.007)
        assert len(shares[1 - straight]) == 0
        assert len(shares[straight]) >= 15
        assert np.ptp(np.diff(shares[straight])) < 1e-9, "evenly round a disc"


def turned(loop: np.ndarray, angle: float, start: int) -> np.ndarray:
    turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
    return np.roll(loop, start, axis=0) @ turn + (0.3, -2.0)


def test_equal_panels_are_seen_however_they_lie() -> None:
    shape = np.array([[0.0, 0.0], [0.5, 0.0], [0.7, 0.2], [0.1, 0.4]])
    hole = np.array([[0.2, 0.1], [0.2, 0.2], [0.3, 0.1]])
    mirrored = shape[::-1] * (-1.0, 1.0)
    other = shape + (0.0, 1e-4) * np.array([[0.0], [0.0], [1.0], [0.0]])
    panels = [
        BagPanel("one", shape, (hole,)),
        BagPanel("turned", turned(shape, 1.0, 2), (turned(hole, 1.0, 1),)),
        BagPanel("mirrored", turned(mirrored, 2.0, 1), (turned(hole[::-1] * (-1.0, 1.0), 2.0, 0),)),
        BagPanel("without the hole", shape),
        BagPanel("another hole", shape, (hole + np.array([0.01, 0.0]),)),
        BagPanel("nearly", other, (hole,)),
        BagPanel("not cut", shape, (hole,), cut=False),
    ]
    groups = [(group.panels, group.mirrored) for group in panel_copies(Bag(tuple(panels), ()))]
    assert groups == [((0, 1, 2), (False, False, True)), ((3,), (False,)), ((4,), (False,)), ((5,), (False,))]


def test_a_rectangle_is_its_own_mirror_image() -> None:
    bag = Bag((BagPanel("a", rectangle(1.0, 2.0)), BagPanel("b", rectangle(2.0, 1.0))), ())
    assert panel_copies(bag)[0].mirrored == (False, False)


@pytest.mark.parametrize("name", sorted(BAGS))
def test_the_order_joins_all_panels_and_ends_with_the_opening(name: str) -> None:
    bag = BAGS[name]
    patterns = made(name)
    seams = {mark.number for mark in patterns.seams if mark.made}
    order = patterns.order
    assert sorted(step.seam for step in order) == sorted(seams)
    joins = [step for step in order if step.kind == JOIN]
    tree = {panel: {panel} for panel in patterns.panels}
    for step in joins:
        one, other = (tree[panel] for panel in step.panels)
        assert one is not other, "a join joins two parts"
        one |= other
        tree.update(dict.fromkeys(one, one))
    assert len(joins) in (len(patterns.panels) - 1, len(patterns.panels) - 2)
    assert [step.kind for step in order].count(LAST) == 1
    assert order[-1].kind == LAST
    assert order[-1].opening or bag.opening is None
    flat = [step.flat for step in order[:-1]]
    assert flat == sorted(flat, reverse=True), "flat seams come first"
    assert {step.kind for step in order} <= {JOIN, CLOSE, LAST}


def test_a_seam_of_panels_that_are_not_cut_is_not_made() -> None:
    envelope = BAGS["envelope"]
    patterns = made("envelope")
    assert len(patterns.patterns) == 10
    assert sum(mark.made for mark in patterns.seams) == 10
    assert replace(envelope, opening=None) == envelope

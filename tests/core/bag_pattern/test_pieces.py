# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pieces of a balloon beside each other: edges, partners, and what is nearest to a place."""

import numpy as np
import pytest
from made_bags import BAGS, FILM, rectangle

from BalloonWorkbench.core.bag_pattern.make import bag_pieces
from BalloonWorkbench.core.geometry.nearest import nearest_on_loops
from BalloonWorkbench.core.geometry.polyline import length, perimeter
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.pattern.make import make_pattern, sheet_of
from BalloonWorkbench.core.pattern.pattern import Role
from BalloonWorkbench.core.pattern.pieces import sheet_pieces, two_panel_pieces

OPTIONS = PatternOptions(intake=False)


def off_weld(pieces, edge):
    """How far the points of an edge are from the middle of the weld on its piece, (n,) m."""
    welds = [weld.points for weld in pieces.pieces[edge.piece].pattern.of(Role.SEAL)]
    return nearest_on_loops(welds, edge.line).distance


@pytest.mark.parametrize("bag", [BAGS["box"], BAGS["drum"]], ids=["box", "drum"])
def test_each_edge_of_a_bag_has_its_partner(bag):
    pieces = bag_pieces(bag, FILM, OPTIONS)
    assert len(pieces.edges) == 2 * len(bag.seams)
    for number, edge in enumerate(pieces.edges):
        partner = pieces.partner(number)
        assert partner != number
        assert pieces.partner(partner) == number
        assert length(edge.line) == pytest.approx(length(pieces.edges[partner].line), rel=1e-3)
        # half a seal width inside the weld of its own piece, wherever that lies
        assert off_weld(pieces, edge)[1:-1] == pytest.approx(0.5 * FILM.seal_width, abs=1e-4)
    boundary = sum(perimeter(loop) for panel in bag.panels for loop in panel.loops)
    assert sum(length(edge.line) for edge in pieces.edges) == pytest.approx(boundary)


def test_two_equal_panels_are_sealed_edge_to_edge():
    seam = Outline(rectangle(0.3, 0.2), (rectangle(0.1, 0.05)[::-1] + np.array([0.1, 0.08]),))
    pieces = two_panel_pieces(seam, 0.005, OPTIONS)
    assert [piece.name for piece in pieces.pieces] == ["front", "back"]
    assert len(pieces.edges) == 16  # four sides of the rim and of the hole, on both
    for number, edge in enumerate(pieces.edges):
        partner = pieces.edges[pieces.partner(number)]
        assert {edge.piece, partner.piece} == {0, 1}
        assert length(edge.line) == pytest.approx(length(partner.line))
        assert off_weld(pieces, edge) == pytest.approx(0.0025, abs=0.0011)
    lengths = sorted(length(edge.line) for edge in pieces.edges)
    assert lengths == pytest.approx(sorted([0.3, 0.2, 0.1, 0.05] * 4))


def test_a_smooth_seam_is_one_edge():
    turns = np.linspace(0.0, 2.0 * np.pi, 90, endpoint=False)
    disc = 0.1 * np.column_stack([np.cos(turns), np.sin(turns)])
    one, other = two_panel_pieces(Outline(disc), 0.005, OPTIONS).edges
    assert length(one.line) == pytest.approx(0.2 * np.pi, rel=1e-3)
    assert one.line[0] == pytest.approx(one.line[-1])
    assert length(other.line) == pytest.approx(length(one.line))


def test_an_end_that_stays_open_has_no_partner():
    pieces = bag_pieces(BAGS["envelope"], FILM, OPTIONS)
    alone = [edge for number, edge in enumerate(pieces.edges) if pieces.partner(number) is None]
    assert alone
    assert all(edge.seam for edge in alone)
    assert len(alone) < len(pieces.edges)


def test_what_is_nearest_to_a_place():
    pieces = two_panel_pieces(Outline(rectangle(0.3, 0.2)), 0.005, OPTIONS)
    assert pieces.nearest_edge(np.array([0.15, 0.01])) == (0, pytest.approx(0.01))
    assert pieces.nearest_edge(np.array([0.29, 0.1])) == (1, pytest.approx(0.01))
    beside = np.array([0.001, 0.001])  # the corner, the edge, and neither
    assert pieces.nearest_point(beside, 0.002) == pytest.approx(np.zeros(2), abs=1e-9)
    along = np.array([0.1, 0.001])
    assert pieces.nearest_point(along, 0.002) == pytest.approx(np.array([0.1, 0.0]), abs=1e-9)
    assert (pieces.nearest_point(along, 0.0005) == along).all()


def test_a_sheet_has_welds_without_partners():
    options = PatternOptions(intake=False, mirror=True, copies=2)
    sheet = sheet_of(make_pattern(Outline(rectangle(0.3, 0.2)), 0.005, options), options)
    pieces = sheet_pieces(sheet)
    assert len(pieces.pieces) == len(pieces.edges) == 4
    assert {edge.piece for edge in pieces.edges} == {0, 1, 2, 3}
    assert [pieces.partner(number) for number in range(4)] == [None] * 4

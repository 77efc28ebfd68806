# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where flat pieces lie, what is kept of it, and what they snap to."""

from dataclasses import replace

import numpy as np
import pytest

from BalloonWorkbench.core.arrangement.arrangement import (
    Arrangement,
    PiecePlace,
    arrangement_of,
    laid_at,
    laid_pieces,
)
from BalloonWorkbench.core.arrangement.seam_vertices import along_edge
from BalloonWorkbench.core.arrangement.snapping import STEP, Neighbours
from BalloonWorkbench.core.geometry.polyline import length, signed_area
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role
from BalloonWorkbench.core.pattern.pieces import FlatPiece, PatternPieces, PieceEdge

ARROW = np.array([[0.02, 0.02], [0.06, 0.02]])


def piece(name, width, height, shift=(0.0, 0.0)):
    loop = np.array([[0.0, 0.0], [width, 0.0], [width, height], [0.0, height]]) + shift
    arrow = Contour(Role.PEN, ARROW + shift, False)
    return FlatPiece(name, Pattern((arrow, Contour(Role.CUT, loop, True)), None, 0.005, 0.0))


def edges_of(number, flat):
    loop = flat.pattern.contours[-1].line
    return [PieceEdge(number, loop[k : k + 2], k + 1) for k in range(4)]


def pieces(scale=1.0, names=("a", "b", "c")):
    flat = tuple(
        piece(name, 0.1 * scale, 0.06 * scale, (0.12 * scale * k, 0.0)) for k, name in enumerate(names)
    )
    return PatternPieces(flat, tuple(edge for k, each in enumerate(flat) for edge in edges_of(k, each)))


def test_nothing_kept_lies_as_the_pattern_lays_it():
    base = pieces()
    laid = laid_pieces(base, Arrangement())
    assert laid.pieces is base
    assert (laid.gone, laid.new) == ((), ())
    assert laid.places[1].middle == pytest.approx((0.17, 0.03))
    again = laid_pieces(base, arrangement_of(base, laid.places)).pieces
    for one, other in zip(again.edges, base.edges, strict=True):
        assert one.line == pytest.approx(other.line)


@pytest.mark.parametrize("mirrored", [False, True])
def test_edges_arrow_and_sense_go_with_a_piece(mirrored):
    base = pieces()
    places = list(laid_pieces(base, Arrangement()).places)
    places[0] = replace(places[0], angle=np.radians(30.0), mirrored=mirrored).moved(np.array([0.5, 0.1]))
    laid = laid_at(base, places)
    cut, arrow = laid.pieces[0].pattern.of(Role.CUT)[0], laid.pieces[0].pattern.of(Role.PEN)[0]
    assert signed_area(cut.points) == pytest.approx(0.006)  # still counter-clockwise
    along = np.degrees(np.arctan2(*(arrow.points[-1] - arrow.points[0])[::-1]))
    grain = np.degrees(places[0].grain(0.0))
    assert along % 180.0 == pytest.approx(grain)
    assert grain == pytest.approx(30.0)
    assert np.degrees(places[0].grain(np.radians(20.0))) == pytest.approx(10.0 if mirrored else 50.0)
    for number in range(4):
        own = laid.edges[number].line
        assert length(own) == pytest.approx(length(base.edges[number].line))
        assert np.linalg.norm(cut.points[:, None] - own, axis=2).min(axis=0) == pytest.approx(0.0, abs=1e-12)
    assert laid.edges[5].line == pytest.approx(base.edges[5].line)


def test_turned_over_twice_is_as_before():
    place = PiecePlace((0.1, 0.2), np.radians(40.0))
    over = place.turned_over()
    corner = np.array([0.3, 0.1])
    assert corner @ over.matrix == pytest.approx(corner @ place.matrix * (-1.0, 1.0))
    assert over.turned_over().matrix == pytest.approx(place.matrix)
    assert place.turned(STEP).turned(-STEP).angle == pytest.approx(place.angle)


def test_all_grow_apart_with_their_size_and_others_come_and_go():
    base = pieces()
    places = [place.moved(np.array([0.0, 0.3])) for place in laid_pieces(base, Arrangement()).places]
    places[1] = places[1].turned(STEP)
    kept = arrangement_of(base, places)
    larger = laid_pieces(pieces(2.0), kept)
    for now, before in zip(larger.places, places, strict=True):
        assert now.middle == pytest.approx(2.0 * np.array(before.middle))
    assert larger.places[1].angle == pytest.approx(STEP)
    changed = laid_pieces(pieces(names=("c", "a", "d")), kept)
    assert (changed.gone, changed.new) == (("b",), ("d",))
    assert changed.places[:2] == (places[2], places[0])
    others = max(each.pattern.bounds[1][0] for each in changed.pieces.pieces[:2])
    assert changed.pieces.pieces[2].pattern.bounds[0][0] > others
    none = laid_pieces(pieces(names=("x", "y")), kept)
    assert none.gone == ("a", "b", "c")
    assert none.pieces is none.base


def test_pieces_of_one_name_lie_each_for_itself():
    base = pieces(names=("a", "a", "a"))
    places = list(laid_pieces(base, Arrangement()).places)
    places[1] = places[1].turned_over()
    laid = laid_pieces(base, arrangement_of(base, places))
    assert [place.mirrored for place in laid.places] == [False, True, False]


def test_what_a_piece_touches():
    laid = laid_pieces(pieces(), Arrangement())
    near = Neighbours(laid, 1)
    reach = 0.002
    alone = np.array([0.0, 0.2])
    assert near.touching(alone, reach) == pytest.approx(alone)
    # 1 mm short of the left one's right edge, above its corner: edge on edge, the rest of the way is kept
    assert near.touching(np.array([-0.019, 0.03]), reach) == pytest.approx([-0.02, 0.03])
    # the same near its corner: corner in corner
    assert near.touching(np.array([-0.019, 0.0015]), reach) == pytest.approx([-0.02, 0.0])
    # on top of it
    assert near.touching(np.array([-0.07, 0.0612]), reach) == pytest.approx([-0.07, 0.06])
    assert near.touching(np.array([-0.015, 0.03]), reach) == pytest.approx([-0.015, 0.03])


def test_what_a_turn_snaps_to():
    base = pieces()
    places = list(laid_pieces(base, Arrangement()).places)
    places[0] = places[0].turned(np.radians(37.0))
    near = Neighbours(laid_pieces(base, arrangement_of(base, places)), 1)

    def turned(degrees, grain=None, mirrored=False):
        place = replace(places[1], angle=np.radians(degrees), mirrored=mirrored)
        return np.degrees(near.turn(place, None if grain is None else np.radians(grain)).angle)

    assert turned(14.0) == pytest.approx(15.0)
    assert turned(38.0) == pytest.approx(37.0)  # along an edge of the first one
    assert turned(-54.0) == pytest.approx(-53.0)  # the other edge
    assert turned(21.0) == pytest.approx(21.0)
    assert turned(68.0, grain=20.0) == pytest.approx(70.0)  # its grain is upright
    assert turned(22.0, grain=20.0, mirrored=True) == pytest.approx(20.0)


def test_vertices_along_an_edge():
    side = np.linspace(0.0, 1.0, 6)[:-1]
    rest = np.concatenate(
        [
            np.column_stack(each)
            for each in (
                (side, 0 * side),
                (0 * side + 1, side),
                (1 - side, 0 * side + 1),
                (0 * side, 1 - side),
            )
        ]
    )
    loop = np.arange(20)
    hole = np.arange(20, 24)
    rest = np.concatenate([rest, [[0.4, 0.4], [0.4, 0.6], [0.6, 0.6], [0.6, 0.4]]])
    right = np.column_stack([np.ones(9), np.linspace(0.0, 1.0, 9)])
    assert along_edge(right, [loop, hole], rest).tolist() == [5, 6, 7, 8, 9, 10]
    assert along_edge(right[::-1], [loop, hole], rest).tolist() == [10, 9, 8, 7, 6, 5]
    left = np.array([[0.0, 1.0], [0.0, 0.0]])  # over the end of the loop
    assert along_edge(left, [loop, hole], rest).tolist() == [15, 16, 17, 18, 19, 0]
    whole = rest[[20, 21, 22, 23, 20]]
    assert along_edge(whole, [loop, hole], rest).tolist() == [20, 21, 22, 23, 20]


def test_a_slanted_edge_turns_along_another_one():
    slanted = FlatPiece(
        "d",
        Pattern(
            (Contour(Role.CUT, np.array([[0.3, 0.0], [0.4, 0.0], [0.4, 0.1364], [0.3, 0.1]]), True),),
            None,
            0.005,
            0.0,
        ),
    )
    first = pieces(names=("a",))
    base = PatternPieces((*first.pieces, slanted), (*first.edges, *edges_of(1, slanted)))
    laid = laid_pieces(base, Arrangement())
    near = Neighbours(laid, 1)
    for degrees, mirrored, turned in ((-19.0, False, -20.0), (19.0, True, 20.0)):
        place = replace(laid.places[1], angle=np.radians(degrees), mirrored=mirrored)
        assert np.degrees(near.turn(place, None).angle) == pytest.approx(turned, abs=0.01)

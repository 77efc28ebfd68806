# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edits of a traced outline: what they do to it, and what becomes of them when the picture changes."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from drawn_pictures import any_of, box, coloured, disc, drawn
from drawn_shapes import corners_of, hole

from BalloonWorkbench.core.errors import InputError, OutlineError
from BalloonWorkbench.core.geometry.nearest import nearest_on_loops
from BalloonWorkbench.core.geometry.normals import turns
from BalloonWorkbench.core.geometry.polyline import signed_area
from BalloonWorkbench.core.outline.drawing import Drawing
from BalloonWorkbench.core.outline.validity import scale_to
from BalloonWorkbench.core.outline_edits.apply_edits import (
    EditFrame,
    appended,
    apply_edits,
    edits_of_nodes,
    node_edit,
    with_edit,
)
from BalloonWorkbench.core.outline_edits.edit import (
    ADD,
    FILL,
    KINDS,
    MOVE,
    REMOVE,
    ROUND,
    SHARP,
    OutlineEdit,
    edit_text,
    edits_of,
)
from BalloonWorkbench.core.outline_edits.nodes import CORNER, SMOOTH, NodeDrawing, with_nodes
from BalloonWorkbench.core.tracing.picture import drawing_of

PLATE = Drawing(
    (replace(corners_of((0, 0), (0.3, 0), (0.3, 0.2), (0, 0.2)), holes=(hole(0.03, 0.15, 0.1),)),)
)

BARE = Drawing((replace(PLATE.largest, holes=()),))
#: A plate with its upper corners cut off.
HOUSE = Drawing((corners_of((0, 0), (0.3, 0), (0.3, 0.2), (0.2, 0.3), (0.1, 0.3), (0, 0.2)),))


@cache
def pictured(*changes: str) -> Drawing:
    """A body 0.3 m wide with an ear, traced; changes: "tail" has one more part, "no ear" lacks it."""
    shapes = [disc(200, 150, 100)]
    if "no ear" not in changes:
        shapes.append(box(180, 240, 220, 320))
    if "tail" in changes:
        shapes.append(box(20, 130, 120, 160))
    picture = drawn(any_of(*shapes), 400, 400, fine=3)
    return scale_to(drawing_of(coloured(picture)), 0.3 * (1.4 if "tail" in changes else 1.0), None)


def at(x: float, y: float) -> np.ndarray:
    return np.array([x, y], dtype=np.float64)


def edited(nodes: NodeDrawing, kind: str, place: np.ndarray, to: np.ndarray | None = None) -> NodeDrawing:
    return with_edit(nodes, node_edit(nodes, kind, place, to))


def outer(nodes: NodeDrawing) -> np.ndarray:
    return nodes.loops[0].points


def test_nodes_are_the_corners_and_a_few_more_and_move_nothing() -> None:
    nodes = with_nodes(PLATE)
    plate, inner = nodes.loops
    corner = plate.points[plate.kinds == CORNER]
    assert sorted(corner.tolist()) == sorted(PLATE.largest.outer.tolist())
    assert len(plate.nodes) == 4
    assert 3 <= len(inner.nodes) <= 8
    assert (inner.kinds[inner.nodes] == SMOOTH).all()
    assert nodes.drawing.largest.area == pytest.approx(PLATE.largest.area, rel=1e-12)


def test_a_corner_that_moves_keeps_its_sides_straight_and_the_hole() -> None:
    nodes = with_nodes(PLATE)
    after = edited(nodes, MOVE, at(0.3, 0.2), at(0.4, 0.25))
    # by the shoelace formula of the quadrilateral
    assert signed_area(outer(after)) == pytest.approx(0.5 * (0.3 * 0.25 + 0.4 * 0.2), rel=1e-9)
    assert np.array_equal(after.loops[1].points, nodes.loops[1].points)


def test_a_smooth_node_takes_its_stretch_along_without_a_kink() -> None:
    nodes = with_nodes(PLATE)
    inner = nodes.loops[1]
    node = inner.points[inner.nodes[0]]
    away = 0.01 * (node - at(0.15, 0.1)) / 0.03
    after = edited(nodes, MOVE, node, node + away).loops[1]
    assert np.abs(turns(after.points, 0.003)).max() < np.radians(25.0)
    assert np.linalg.norm(after.points - node - away, axis=1).min() < 1e-12
    others = inner.points[inner.nodes[1:]]
    assert nearest_on_loops([after.points], others).distance.max() < 1e-12


def test_removed_corners_leave_a_straight_line() -> None:
    after = edited(with_nodes(BARE), REMOVE, at(0.3, 0.2))
    assert len(after.loops[0].nodes) == 3
    assert signed_area(outer(after)) == pytest.approx(0.5 * 0.3 * 0.2, rel=1e-9)


def test_a_hole_is_filled_by_its_last_nodes_and_the_outline_keeps_three() -> None:
    nodes = with_nodes(PLATE)
    while len(nodes.loops) == 2:
        inner = nodes.loops[1]
        nodes = edited(nodes, REMOVE, inner.points[inner.nodes[0]])
    assert nodes.drawing.largest.holes == ()
    nodes = edited(nodes, REMOVE, at(0.3, 0.2))
    assert len(nodes.loops[0].nodes) == 3
    with pytest.raises(InputError, match="keeps three nodes"):
        node_edit(nodes, REMOVE, at(0.3, 0.0))


def test_sharp_and_round_are_had_back() -> None:
    nodes = with_nodes(PLATE)
    smooth = edited(nodes, ROUND, at(0.3, 0.2))
    assert (
        np.abs(turns(outer(smooth), 0.002))[np.argmin(np.linalg.norm(outer(smooth) - at(0.3, 0.2), axis=1))]
        < 0.1
    )
    assert signed_area(outer(smooth)) > 0.06  # it bulges through the corner
    sharp = edited(smooth, SHARP, at(0.3, 0.2))
    assert signed_area(outer(sharp)) == pytest.approx(0.06, rel=1e-9)


def test_a_node_is_added_where_it_changes_nothing() -> None:
    nodes = with_nodes(PLATE)
    after = edited(nodes, ADD, at(0.1, 0.201))
    assert len(after.loops[0].nodes) == 5
    assert signed_area(outer(after)) == pytest.approx(0.06, rel=1e-12)
    peak = edited(after, MOVE, at(0.1, 0.2), at(0.1, 0.25))
    assert signed_area(outer(peak)) == pytest.approx(0.06 + 0.5 * 0.3 * 0.05, rel=1e-9)


def test_what_would_cross_is_refused() -> None:
    nodes = with_nodes(PLATE)
    with pytest.raises(OutlineError, match="hole"):
        edited(nodes, MOVE, at(0.3, 0.2), at(0.12, 0.08))
    with pytest.raises(OutlineError, match="crosses"):
        edited(nodes, MOVE, at(0.3, 0.2), at(0.1, -0.1))


def kept(drawing: Drawing, kind: str, place: np.ndarray, to: np.ndarray | None = None) -> OutlineEdit:
    edit = EditFrame.of(drawing).kept(node_edit(with_nodes(drawing), kind, place, to))
    (again,) = edits_of([edit_text(edit)])
    return again


def test_edits_are_kept_in_parts_of_the_canvas() -> None:
    """Through their text, on the drawing twice as large."""
    edit = kept(PLATE, MOVE, at(0.3, 0.2), at(0.4, 0.25))
    large = apply_edits(PLATE.map(lambda loop: 2.0 * loop), [edit])
    assert not large.left_out
    once = apply_edits(PLATE, [edit])
    assert large.drawing.largest.area == pytest.approx(4.0 * once.drawing.largest.area, rel=1e-6)
    assert once.drawing.size == pytest.approx((0.4, 0.25), rel=1e-6)


def test_an_edit_stays_at_its_place_in_a_changed_picture() -> None:
    """A tail on the other side makes the box wider: the picture is what the places belong to."""
    before, changed = pictured(), pictured("tail")
    nodes = with_nodes(before)
    ear = outer(nodes)[np.argmax(outer(nodes)[:, 1])]
    high = nodes.size
    edit = kept(before, MOVE, ear, ear + at(0.0, 0.1 * high))
    once, after = apply_edits(before, [edit]), apply_edits(changed, [edit])
    assert not once.left_out
    assert not after.left_out
    grown = [result.drawing.size[1] / plain.size[1] for result, plain in ((once, before), (after, changed))]
    assert grown == pytest.approx([1.1, 1.1], abs=0.01)


def test_an_edit_whose_place_is_gone_is_named() -> None:
    before, changed = pictured(), pictured("no ear")
    nodes = with_nodes(before)
    ear, foot = (outer(nodes)[chosen(outer(nodes)[:, 1])] for chosen in (np.argmax, np.argmin))
    edits = [kept(before, SHARP, ear), kept(before, MOVE, foot, foot - at(0.0, 0.02))]
    result = apply_edits(changed, edits)
    (sentence,) = result.left_out
    assert sentence.startswith("Outline edit 1 at (")
    assert "does not pass there any more" in sentence
    assert result.drawing.notes[-1] == sentence
    assert result.drawing.size[1] == pytest.approx(changed.size[1] + 0.02, abs=2e-4)


def test_another_hole_than_the_one_that_was_filled_stays() -> None:
    edit = kept(PLATE, FILL, at(0.18, 0.1))
    assert apply_edits(PLATE, [edit]).drawing.largest.holes == ()
    elsewhere = Drawing((replace(BARE.largest, holes=(hole(0.03, 0.06, 0.1),)),))
    result = apply_edits(elsewhere, [edit])
    assert len(result.drawing.largest.holes) == 1
    assert "does not pass there any more" in result.left_out[0]


def test_an_edit_that_would_cross_on_the_changed_picture_is_left_out() -> None:
    edit = kept(PLATE, MOVE, at(0.3, 0.2), at(0.2, 0.15))
    wide = Drawing((replace(PLATE.largest, holes=(hole(0.07, 0.15, 0.1),)),))
    assert not apply_edits(PLATE, [edit]).left_out
    (sentence,) = apply_edits(wide, [edit]).left_out
    assert "meets" in sentence


def test_the_same_happens_on_the_other_side_of_a_symmetric_outline() -> None:
    for kind, to in ((MOVE, at(0.25, 0.35)), (REMOVE, None), (ROUND, None)):
        edit = replace(kept(HOUSE, kind, at(0.2, 0.3), to), mirrored=True)
        after = apply_edits(HOUSE, [edit])
        assert not after.left_out
        loop = after.nodes.loops[0].points
        mirrored = loop * (-1.0, 1.0) + (0.3, 0.0)
        assert nearest_on_loops([loop], mirrored).distance.max() < 1e-4, kind
        one = apply_edits(HOUSE, [replace(edit, mirrored=False)]).drawing.largest.area
        both, none = after.drawing.largest.area, HOUSE.largest.area
        assert abs(both - none) > 1.5 * abs(one - none) > 0.0, kind


def test_a_node_on_the_axis_stays_on_it() -> None:
    kite = Drawing((corners_of((0.1, 0), (0.2, 0.1), (0.1, 0.3), (0, 0.1)),))
    edit = replace(kept(kite, MOVE, at(0.1, 0.3), at(0.15, 0.35)), mirrored=True)
    after = apply_edits(kite, [edit]).nodes.loops[0].points
    assert np.linalg.norm(after - at(0.1, 0.35), axis=1).min() < 1e-9
    assert after[:, 1].max() == pytest.approx(0.35)


def test_several_shapes_are_edited_wherever_the_place_is() -> None:
    second = corners_of((0.5, 0), (0.6, 0), (0.6, 0.1), (0.5, 0.1))
    two = Drawing((PLATE.largest, second))
    after = apply_edits(two, [kept(two, MOVE, at(0.6, 0.1), at(0.7, 0.1))]).drawing
    assert after.parts[1].size == pytest.approx((0.2, 0.1), rel=1e-6)
    assert after.parts[0].area == pytest.approx(PLATE.largest.area, rel=1e-12)


def test_a_node_that_is_moved_on_is_moved_once() -> None:
    nodes = with_nodes(PLATE)
    canvas, edits = EditFrame.of(PLATE), ()
    place = at(0.3, 0.2)
    for step in (at(0.31, 0.2), at(0.32, 0.21)):
        edit = node_edit(nodes, MOVE, place, step)
        nodes, place = with_edit(nodes, edit), step
        edits = appended(edits, canvas.kept(edit))
    assert len(edits) == 1
    assert np.allclose(apply_edits(PLATE, edits).nodes.loops[0].points, outer(nodes), atol=1e-9)
    other = canvas.kept(node_edit(nodes, MOVE, at(0.0, 0.0), at(0.0, -0.01)))
    assert len(appended(edits, other)) == 2


def test_nodes_that_move_together_stay_as_they_are_to_each_other() -> None:
    """A hole goes elsewhere as a whole, further than any of its nodes alone could."""
    nodes = with_nodes(PLATE)
    inner = nodes.loops[1]
    by = at(0.08, 0.02)
    (edit,) = edits_of_nodes(nodes, MOVE, [*inner.points[inner.nodes]], by)
    (again,) = edits_of([edit_text(EditFrame.of(PLATE).kept(edit))])
    after = apply_edits(PLATE, [again])
    assert not after.left_out
    moved = PLATE.largest.holes[0] + by
    assert nearest_on_loops([after.drawing.largest.holes[0]], moved).distance.max() < 1e-6


def test_all_nodes_of_a_hole_and_one_of_the_outline_go_at_once() -> None:
    nodes = with_nodes(PLATE)
    places = [at(0.3, 0.2), *nodes.loops[1].points[nodes.loops[1].nodes]]
    edits = edits_of_nodes(nodes, REMOVE, places, at(0.0, 0.0))
    assert [edit.kind for edit in edits] == [REMOVE, FILL]
    frame = EditFrame.of(PLATE)
    after = apply_edits(PLATE, [frame.kept(edit) for edit in reversed(edits)])
    assert not after.left_out
    assert after.drawing.largest.holes == ()
    assert after.drawing.largest.area == pytest.approx(0.03, rel=1e-9)


def test_texts_that_are_no_edits_are_refused() -> None:
    for text in (
        "{",
        "[]",
        '{"do": "fly", "at": [[0, 0]]}',
        '{"do": "add", "at": [[0]]}',
        '{"do": "add", "at": [[0, "a"]]}',
        '{"do": "add", "at": [[0, 0]], "to": [1, 1]}',
        '{"do": "add", "at": [[0, 0]], "form": 1}',
        '{"do": "move", "at": [[0, 0], [1, 0], [1, 1]]}',
        '{"do": "move", "at": [[0, 0]], "to": [0, 0]}',
        '{"do": "fill", "at": [[0, 0]], "mirrored": 1}',
        '{"do": "fill", "at": [[1e300, 0]]}',
    ):
        with pytest.raises(InputError):
            edits_of([text])


def test_edits_at_odd_places_are_sentences() -> None:
    """What nobody designed for: far away, on a hole that is none, all places one, numbers without sense."""
    for kind in KINDS:
        count = 1 if kind in (ADD, FILL) else 3
        for place in ((0.0, 0.0), (5.0, 5.0), (100.0, -100.0), (0.5, 0.5)):
            edit = OutlineEdit(kind, np.array([place] * count), at(100.0, 0.5))
            result = apply_edits(PLATE, [edit])
            assert len(result.drawing.parts) == 1
            assert all(np.isfinite(loop).all() for loop in result.drawing.largest.loops)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where flat pieces lie, kept in a Pattern object."""

import math

import FreeCAD as App
import numpy as np
import pytest
import sketches

import BalloonWorkbench
from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.engine.export import print_pieces
from BalloonWorkbench.app.shapes import piece_places
from BalloonWorkbench.core.errors import InputError


@pytest.fixture
def pattern(doc):
    sketch = sketches.rectangle(doc, 90, 60)
    return create.balloon_from_sketch(doc, sketch, mesh_size=15, correct=False).pattern


def test_a_new_pattern_keeps_nothing(pattern):
    laid = piece_places.laid(pattern)
    assert laid.pieces is laid.base
    assert not pattern.ArrangedPieces


@pytest.mark.parametrize("mirrored", [False, True])
@pytest.mark.parametrize("angle", [0.0, 30.0, 90.0, 179.0, -135.0])
def test_places_come_back_from_properties_and_file(pattern, tmp_path, angle, mirrored):
    BalloonWorkbench.arrange(pattern, "back", at=(10.5, -200), angle=angle, mirrored=mirrored)
    laid = piece_places.laid(pattern)
    assert laid.places[0].middle == pytest.approx(np.mean(laid.base.pieces[0].pattern.bounds, axis=0))
    doc = pattern.Document
    doc.saveAs(str(tmp_path / "Test.FCStd"))
    App.closeDocument(doc.Name)
    doc = App.openDocument(str(tmp_path / "Test.FCStd"))
    back = piece_places.laid(doc.Pattern).places[1]
    assert back.middle == pytest.approx((0.0105, -0.2), abs=1e-12)
    assert math.degrees(back.angle) == pytest.approx(angle, abs=1e-9)
    assert back.mirrored == mirrored
    assert "Touched" not in doc.Pattern.State


def test_it_decides_nothing_of_what_is_cut(pattern, tmp_path):
    before = pattern.Shape.BoundBox.DiagonalLength
    written = [BalloonWorkbench.export(pattern, tmp_path / "before.dxf").read_bytes()]
    BalloonWorkbench.arrange(pattern, "front", at=(0, 500), angle=45)
    assert "Touched" not in pattern.State
    pattern.touch()
    pattern.Document.recompute()
    written.append(BalloonWorkbench.export(pattern, tmp_path / "after.dxf").read_bytes())
    assert written[0] == written[1]
    assert pattern.Shape.BoundBox.DiagonalLength == pytest.approx(before)


def test_a_larger_drawing_keeps_front_and_back_apart(doc, tmp_path):
    drawing = tmp_path / "rectangle.svg"
    drawing.write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 90 60"><path d="M0 0h90v60h-90z"/></svg>'
    )
    made = create.balloon_from_picture(doc, drawing, width="90 mm", mesh_size=15, correct=False)
    pattern = made.pattern
    BalloonWorkbench.arrange(pattern, "front", at=(0, 0), angle=90)
    BalloonWorkbench.arrange(pattern, "back", at=(120, 0), angle=90)
    BalloonWorkbench.change(made, width="180 mm")
    laid = piece_places.laid(pattern)
    assert not laid.gone
    grown = np.array(laid.places[1].middle) - laid.places[0].middle
    assert 0.18 < grown[0] < 0.25
    one, other = (piece.pattern.bounds for piece in laid.pieces.pieces[:2])
    assert one[1][0] < other[0][0]
    assert math.degrees(laid.places[0].angle) == pytest.approx(90.0)


def test_a_piece_that_is_not_there(pattern):
    with pytest.raises(InputError, match="no piece lid: its pieces are front, back"):
        BalloonWorkbench.arrange(pattern, "lid", at=(0, 0))
    BalloonWorkbench.arrange(pattern, "back", at=(0, 0))
    BalloonWorkbench.arrange(pattern)
    assert not pattern.ArrangedPieces
    assert not pattern.PiecePlaces


def test_paper_has_them_as_they_lie(pattern, tmp_path):
    files = []
    for name, at in (("near.pdf", (0, -70)), ("far.pdf", (0, -900))):
        BalloonWorkbench.arrange(pattern, "back", at=at)
        files.append(print_pieces(pattern, tmp_path / name, "A4").read_bytes())
    pages = [file.count(b"/Type /Page\n") + file.count(b"/Type /Page ") for file in files]
    assert 1 <= pages[0] < pages[1]


def test_pieces_over_each_other_go_to_paper_too(pattern, tmp_path):
    middle = piece_places.laid(pattern).places[0].middle
    BalloonWorkbench.arrange(pattern, "back", at=[1e3 * value for value in middle], mirrored=True)
    assert print_pieces(pattern, tmp_path / "over.pdf", "Letter").read_bytes().startswith(b"%PDF")

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edits of an outline by hand belong to the document: kept, undone, copied, applied to another picture."""

import sys
from pathlib import Path

import FreeCAD as App
import numpy as np
import pytest

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.drawings.outline_edits import edit
from BalloonWorkbench.app.outline import set_drawing
from BalloonWorkbench.app.shapes import part_shapes
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.units import to_mm

sys.path.append(str(Path(__file__).parents[2] / "core"))
import drawn_pictures as pictures


def file_of(folder, name, *shapes):
    path = folder / name
    shape = pictures.any_of(pictures.box(60, 60, 340, 260), *shapes)
    path.write_bytes(pictures.png(pictures.coloured(pictures.drawn(shape, 400, 320, fine=2))[..., :3]))
    return path


@pytest.fixture
def outline(doc, tmp_path):
    """A plate of 280 x 200 mm."""
    made = create.make(doc).outline
    made.Width = 280
    set_drawing(made, file_of(tmp_path, "plate.png"))
    doc.recompute([made])
    return made


def grown(outline, by=40.0):
    """Its upper right corner goes up."""
    edit(outline, "move", (280, 200), to=(280, 200 + by))
    outline.Document.recompute([outline])


def height(outline):
    return outline.SizeY.Value


def test_an_edit_changes_the_outline_alone(outline):
    grown(outline)
    assert height(outline) == pytest.approx(240, abs=0.5)
    area = 280 * 200 + 0.5 * 280 * 40
    assert outline.Shape.Area == pytest.approx(area, rel=2e-3)
    assert status.is_ready(outline)
    outline.OutlineEdits = []
    outline.Document.recompute([outline])
    assert height(outline) == pytest.approx(200, abs=0.5)


def test_edits_follow_the_size(outline):
    grown(outline)
    outline.Width = 560
    outline.Document.recompute([outline])
    assert height(outline) == pytest.approx(480, abs=1.0)


def test_edits_are_saved_copied_and_undone(outline, tmp_path):
    doc = outline.Document
    doc.openTransaction("Edit outline")
    grown(outline)
    doc.commitTransaction()
    doc.undo()
    doc.recompute([outline])
    assert (height(outline), list(outline.OutlineEdits)) == (pytest.approx(200, abs=0.5), [])
    doc.redo()
    doc.recompute([outline])
    assert height(outline) == pytest.approx(240, abs=0.5)
    copy = doc.copyObject(outline)
    assert list(copy.OutlineEdits) == list(outline.OutlineEdits)
    points = [tuple(at) for at in outline.LoopPoints]
    path, name = tmp_path / "kept.FCStd", outline.Name
    doc.saveAs(str(path))
    App.closeDocument(doc.Name)
    opened = App.openDocument(str(path))
    try:
        kept = opened.getObject(name)
        kept.touch()
        opened.recompute([kept])
        assert np.allclose([tuple(at) for at in kept.LoopPoints], points, atol=1e-9)
        assert len(kept.OutlineEdits) == 1
    finally:
        App.closeDocument(opened.Name)


def test_edits_stay_in_a_changed_picture_or_are_named(outline, tmp_path):
    grown(outline)
    edit(outline, "add", (140, 0))
    set_drawing(outline, file_of(tmp_path, "tail.png", pictures.box(20, 140, 100, 180)))
    outline.Width = 320
    outline.Document.recompute([outline])
    assert height(outline) == pytest.approx(240, abs=6.0)
    assert not [note for note in outline.Notes if "left out" in note]
    other = tmp_path / "disc.png"
    disc = pictures.drawn(pictures.disc(320, 220, 60), 400, 320, fine=2)
    other.write_bytes(pictures.png(pictures.coloured(disc)[..., :3]))
    set_drawing(outline, other)
    outline.Document.recompute([outline])
    lost = [note for note in outline.Notes if "left out" in note]
    assert [note[:14] for note in lost] == ["Outline edit 1", "Outline edit 2"]
    assert status.is_ready(outline)
    set_drawing(outline, file_of(tmp_path, "plate again.png"))
    outline.Width = 280
    outline.Document.recompute([outline])
    assert height(outline) == pytest.approx(240, abs=0.5)


def test_what_crosses_is_refused_and_the_last_outline_stays(outline):
    grown(outline)
    kept = list(outline.OutlineEdits)
    with pytest.raises(InputError, match="crosses"):
        edit(outline, "move", (0, 0), to=(200, 300))
    assert list(outline.OutlineEdits) == kept
    with pytest.raises(InputError, match="no node near"):
        edit(outline, "move", (140, 100), to=(0, 0))
    with pytest.raises(InputError, match='"fly"'):
        edit(outline, "fly", (0, 0))
    with pytest.raises(InputError, match="place to move to"):
        edit(outline, "move", (0, 0))


def test_a_text_that_is_none_is_a_sentence_and_the_outline_stays(outline):
    area = outline.Shape.Area
    outline.OutlineEdits = ["{"]
    outline.Document.recompute([outline])
    assert not status.is_ready(outline)
    assert outline.Shape.Area == area


def test_shapes_of_one_drawing_share_their_edits(doc, tmp_path):
    path = file_of(tmp_path, "two.png", pictures.box(60, 290, 340, 316))
    parts = create.make(doc)
    parts.outline.Width = 280
    set_drawing(parts.outline, path)
    doc.recompute([parts.outline])
    (other,) = create.add_companions(parts)
    doc.recompute([other.outline])
    edit(other.outline, "move", (280, 256), to=(290, 256))
    doc.recompute([parts.outline])
    doc.recompute([other.outline])
    assert other.outline.SizeX.Value == pytest.approx(290, abs=0.6)
    assert parts.outline.SizeX.Value == pytest.approx(280, abs=0.6)
    assert not other.outline.OutlineEdits


def test_what_follows_a_sketch_is_edited_there(doc):
    parts = create.make(doc)
    with pytest.raises(InputError, match="no drawing yet"):
        edit(parts.outline, "add", (0, 0))
    wire = doc.addObject("Part::Feature", "Wire")
    parts.outline.Source = (wire, [])
    with pytest.raises(InputError, match="follows Wire"):
        edit(parts.outline, "add", (0, 0))
    with pytest.raises(InputError, match="no outline to edit"):
        edit(parts.balloon, "add", (0, 0))


def test_the_preview_finds_the_picture_under_an_edited_outline(outline):
    from BalloonWorkbench.app.outline import read_all

    grown(outline)
    canvas = to_mm(read_all(outline)[0].canvas)
    assert canvas.tolist() == [pytest.approx([-60, -60], abs=0.6), pytest.approx([340, 260], abs=0.6)]
    assert part_shapes.stored(outline, "Loop").size[1] == pytest.approx(0.24, abs=5e-4)

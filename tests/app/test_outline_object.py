# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Outline object follows its drawing or sketch, and keeps what it had when that is of no use."""

import json
import math
import shutil
from pathlib import Path

import FreeCAD as App
import numpy as np
import pytest
import sketches

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.outline import set_drawing
from BalloonWorkbench.app.shapes import part_shapes

HEART = Path("resources/examples/pictures/heart.png")


@pytest.fixture
def outline(doc):
    """An Outline alone: nothing here has to be inflated."""
    parts = create.make(doc)
    doc.removeObject(parts.pattern.Name)
    doc.removeObject(parts.balloon.Name)
    return parts.outline


@pytest.fixture
def picture(outline):
    set_drawing(outline, HEART)
    outline.Width = 200
    outline.Document.recompute()
    return outline


def json_file(folder, outer, *holes, unit="mm"):
    path = folder / "drawing.json"
    path.write_text(json.dumps({"unit": unit, "outer": outer, "holes": holes}))
    return path


SQUARE = [[0, 0], [100, 0], [100, 60], [0, 60]]
HOLE = [[30, 20], [60, 20], [60, 40], [30, 40]]


def refused(outline, *words):
    """The outline is marked with a text that has these words."""
    assert not status.is_ready(outline)
    assert all(word in outline.Status for word in words), outline.Status


def kept(outline, change, *words):
    """A change that cannot be followed leaves the last good outline."""
    area, points = outline.Shape.Area, list(outline.LoopPoints)
    change()
    outline.Document.recompute()
    refused(outline, status.STALE, *words)
    assert outline.Shape.Area == area
    assert outline.LoopPoints == points


def test_new_outline_says_what_it_needs(outline):
    outline.Document.recompute()
    assert outline.Status == status.EMPTY + "Choose a picture or a sketch."


def test_picture_has_the_wanted_width(picture):
    assert picture.Status == status.READY
    assert picture.Kind == "picture"
    assert picture.SizeX.Value == pytest.approx(200)
    assert picture.Shape.BoundBox.XLength == pytest.approx(200)
    assert picture.Shape.isValid()
    assert picture.HoleCount == 0


def test_picture_without_opencv(picture, monkeypatch):
    """Qt reads the picture then, and NumPy finds the shape."""
    from BalloonWorkbench.core.tracing import picture_file, raster

    with_opencv = part_shapes.stored(picture, "Loop")
    for module in (picture_file, raster):
        monkeypatch.setattr(module, "opencv", lambda: None)
    picture.touch()
    picture.Document.recompute()
    assert picture.Status == status.READY
    assert part_shapes.stored(picture, "Loop").area == pytest.approx(with_opencv.area, rel=1e-3)


def test_height_alone_gives_the_width(picture):
    shape = picture.SizeX.Value / picture.SizeY.Value
    picture.Width, picture.Height = 0, 90
    picture.Document.recompute()
    assert picture.SizeY.Value == pytest.approx(90)
    assert picture.SizeX.Value / picture.SizeY.Value == pytest.approx(shape, rel=1e-6)


def test_both_sizes_fit_inside_or_stretch(picture):
    shape = picture.SizeX.Value / picture.SizeY.Value
    picture.Width, picture.Height = 100, 300
    picture.Document.recompute()
    assert (picture.SizeX.Value, picture.SizeY.Value) == pytest.approx((100, 100 / shape), rel=1e-6)
    picture.KeepAspect = False
    picture.Document.recompute()
    assert (picture.SizeX.Value, picture.SizeY.Value) == pytest.approx((100, 300))


def test_the_drawing_travels_in_the_document(outline, tmp_path):
    original = tmp_path / "mine.png"
    shutil.copy(HEART, original)
    set_drawing(outline, original)
    original.unlink()
    outline.Document.recompute()
    assert outline.Status == status.READY
    saved = tmp_path / "d.FCStd"
    outline.Document.saveAs(str(saved))
    App.closeDocument(outline.Document.Name)
    again = App.openDocument(str(saved))
    try:
        assert Path(again.Outline.Drawing).name == "mine.png"
        again.Outline.Width = 50
        again.recompute()
        assert again.Outline.SizeX.Value == pytest.approx(50)
    finally:
        App.closeDocument(again.Name)


def test_json_keeps_its_own_size_and_holes(outline, tmp_path):
    set_drawing(outline, json_file(tmp_path, SQUARE, HOLE))
    outline.Width = 0
    outline.Document.recompute()
    assert outline.Status == status.READY
    assert outline.Kind == "json"
    assert outline.HoleCount == 1
    assert outline.Shape.Area == pytest.approx(100 * 60 - 30 * 20)
    assert [len(wire.Edges) for wire in outline.Shape.Wires] == outline.LoopCounts


def test_drawing_of_another_kind_replaces_the_first(picture, tmp_path):
    set_drawing(picture, json_file(tmp_path, SQUARE))
    picture.Document.recompute()
    assert picture.Kind == "json"
    assert picture.Shape.Area == pytest.approx(200 * 120)


def test_stored_points_are_exact(outline, tmp_path):
    third = [[0, 0], [100 / 3, 0], [100 / 3, 200 / 7]]
    set_drawing(outline, json_file(tmp_path, third))
    outline.Width = 0
    outline.Document.recompute()
    kept = [(point.x, point.y) for point in outline.LoopPoints]
    assert np.max(np.abs(np.array(kept) - third)) < 1e-12
    assert np.array_equal(part_shapes.stored(outline, "Loop").outer, np.round(np.array(third) / 1000, 9))


def test_sketch_edit_is_followed(doc, outline):
    rectangle = sketches.rectangle(doc, 120, 80)
    outline.Source = rectangle
    doc.recompute()
    assert outline.Kind == "sketch"
    assert outline.Shape.Area == pytest.approx(120 * 80)
    rectangle.setDatum("Width", App.Units.Quantity("150 mm"))
    doc.recompute()
    assert outline.SizeX.Value == pytest.approx(150)
    assert outline.Shape.Area == pytest.approx(150 * 80)


def test_outline_lies_in_the_plane_of_its_sketch(doc, outline):
    rectangle = sketches.rectangle(doc, 120, 80)
    outline.Source = rectangle
    rectangle.Placement = App.Placement(App.Vector(0, 0, 40), App.Rotation(App.Vector(1, 0, 0), 90))
    doc.recompute()
    for box in (outline.Shape.BoundBox, rectangle.Shape.BoundBox):
        assert (box.XMax, box.YMax, box.ZMin, box.ZMax) == pytest.approx((120, 0, 40, 120), abs=1e-6)


def test_ring_has_a_hole(doc, outline):
    outline.Source = sketches.ring(doc, 35, 70)
    doc.recompute()
    assert outline.HoleCount == 1
    assert outline.Shape.Area == pytest.approx(math.pi * (70**2 - 35**2), rel=3e-4)


def test_open_line_in_a_sketch_is_a_weld(doc, outline):
    outer = sketches.polygon((0, 0), (90, 0), (90, 60), (0, 60))
    bent = [sketches.line((20, 30), (50, 30)), sketches.line((50, 30), (70, 40))]
    outline.Source = sketches.sketch(doc, *outer, *bent)
    doc.recompute()
    assert outline.Status == status.READY
    assert outline.Notes == []
    assert outline.LoopWeldCounts == [3]
    (weld,) = part_shapes.stored(outline, "Loop").welds
    ends = sorted((weld[[0, -1]] * 1000).tolist())
    assert ends == [pytest.approx([20, 30]), pytest.approx([70, 40])]
    assert outline.Shape.Area == pytest.approx(90 * 60)
    assert outline.Shape.Wires[-1].Length == pytest.approx(30 + math.hypot(20, 10))
    kept(outline, lambda: outline.Source[0].addGeometry(sketches.line((10, 10), (100, 10))), "weld leaves")


def test_part_chooses_among_several_shapes(doc, outline):
    small = sketches.polygon((200, 0), (220, 0), (220, 20))
    outline.Source = sketches.sketch(doc, *sketches.polygon((0, 0), (90, 0), (90, 90), (0, 90)), *small)
    doc.recompute()
    assert outline.Part == 1
    assert outline.Shape.Area == pytest.approx(90 * 90)
    assert outline.Notes == ["This is shape 1 of the 2 in the drawing."]
    outline.Part = 2
    doc.recompute()
    assert outline.Shape.Area == pytest.approx(200)
    assert outline.Shape.BoundBox.XMin == pytest.approx(200)
    kept(outline, lambda: setattr(outline, "Part", 3), "2 shapes", "Part")
    kept(outline, lambda: setattr(outline, "Part", 0), "2 shapes")


def test_picked_face_of_a_solid(doc, outline):
    box = doc.addObject("Part::Box", "Box")
    outline.Source = (box, ["Face6"])
    doc.recompute()
    assert outline.Shape.Area == pytest.approx(100)
    assert outline.Placement.Base.z == pytest.approx(10)


@pytest.mark.parametrize("width", [0, -5])
def test_picture_without_a_size(picture, width):
    kept(picture, lambda: setattr(picture, "Width", width), "size")


def test_width_of_a_hundred_kilometres(picture):
    kept(picture, lambda: setattr(picture, "Width", "100 km"), "width")


def test_text_file_is_no_picture(picture, tmp_path):
    path = tmp_path / "text.png"
    path.write_text("this is no picture")
    kept(picture, lambda: set_drawing(picture, path), "picture")


def test_nan_in_json(picture, tmp_path):
    path = json_file(tmp_path, [[0, 0], [100, float("nan")], [100, 60]])
    kept(picture, lambda: set_drawing(picture, path))


def test_missing_file_changes_nothing(picture):
    before = picture.Drawing
    with pytest.raises(OSError, match="does not exist"):
        set_drawing(picture, "/no/such/file.png")
    assert picture.Drawing == before


@pytest.fixture
def square_sketch(doc, outline):
    outline.Source = sketches.sketch(doc, *sketches.polygon((0, 0), (90, 0), (90, 90), (0, 90)))
    doc.recompute()
    assert outline.Status == status.READY
    return outline.Source[0]


def redraw(sketch, *geometry):
    def change():
        sketch.deleteAllGeometry()
        sketch.addGeometry(list(geometry), False)

    return change


def test_sketch_that_was_opened(outline, square_sketch):
    kept(outline, lambda: square_sketch.delGeometry(0), "open", "Close")


def test_self_crossing_sketch(outline, square_sketch):
    bow = sketches.polygon((0, 0), (90, 90), (90, 0), (0, 90))
    kept(outline, redraw(square_sketch, *bow), "crosses", "(45, 45) mm")


def test_sketch_without_area(outline, square_sketch):
    flat = sketches.polygon((0, 0), (90, 0), (40, 0))
    kept(outline, redraw(square_sketch, *flat))


def test_emptied_sketch(outline, square_sketch):
    kept(outline, redraw(square_sketch), "Sketch")


def test_repaired_sketch_is_ready_again(doc, outline, square_sketch):
    square_sketch.delGeometry(0)
    doc.recompute()
    refused(outline, "open")
    redraw(square_sketch, *sketches.polygon((0, 0), (50, 0), (50, 50)))()
    doc.recompute()
    assert outline.Status == status.READY
    assert outline.Shape.Area == pytest.approx(1250)


def test_undo_and_redo(doc, picture):
    doc.openTransaction("wider")
    picture.Width = 260
    doc.recompute()
    doc.commitTransaction()
    assert picture.SizeX.Value == pytest.approx(260)
    doc.undo()
    doc.recompute()
    assert picture.Width.Value == 200
    assert picture.SizeX.Value == pytest.approx(200)
    doc.redo()
    doc.recompute()
    assert picture.SizeX.Value == pytest.approx(260)

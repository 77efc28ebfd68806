# SPDX-License-Identifier: LGPL-2.1-or-later
"""New balloon from picture: the whole way through the panel."""

import json
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import hands
import pytest

from BalloonWorkbench.app.balloon import request
from BalloonWorkbench.app.border import status
from BalloonWorkbench.gui.panels.widgets.drawing_preview import Preview

HEART = str(Path("resources/examples/pictures/heart.png").resolve())


@pytest.fixture
def panel(doc):
    """The open panel with a heart of 120 mm and a coarse mesh."""
    Gui.runCommand("BalloonWorkbench_FromPicture")
    hands.wait_until(hands.panel_is_seen)
    hands.click(hands.find("Live"), x=8)  # what follows by itself is tested in test_panels.py
    hands.type_into(hands.find("Drawing"), HEART)
    hands.type_into(hands.find("Width"), "12 cm")
    hands.type_into(hands.find("MeshSize"), "14 mm")
    return doc


def parts(doc):
    return doc.Outline, doc.Balloon, doc.Pattern


def names(doc):
    return [obj.Name for obj in doc.Objects]


def as_drawn():
    """In a moment."""
    hands.choose(hands.find("Mode"), "Inflate as drawn")


def apply():
    hands.click(hands.find("Apply"))
    hands.wait_until(lambda: hands.find("Apply").isVisible())


@pytest.mark.slow
def test_ok_makes_the_balloon(panel):
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert [obj.Status for obj in parts(panel)] == [status.READY] * 3
    assert panel.Outline.SizeX.Value == pytest.approx(120)
    assert panel.Balloon.Mesh.isSolid()
    assert panel.Balloon.MeshSize.Value == pytest.approx(14)
    assert panel.UndoNames == ["New balloon from picture"]
    assert panel.BalloonGroup.Label == "heart"
    hands.screenshot("from-picture-done")
    panel.undo()
    assert names(panel) == []
    panel.redo()
    assert names(panel) == ["BalloonGroup", "Outline", "Balloon", "Pattern"]
    assert panel.Balloon.Mesh.isSolid()


def test_apply_shows_the_result_before_ok(panel):
    apply()
    assert hands.panel_is_open()
    assert panel.Balloon.Status == status.READY
    labels = [label.text() for label in hands.find("Result").findChildren(hands.QtWidgets.QLabel)]
    assert f"{panel.Balloon.InflatedThickness.Value:.4g} mm" in labels
    assert panel.Balloon.ActiveBackend in labels
    image = hands.screenshot("from-picture-applied")
    assert len({image.pixel(x, 450) for x in range(300, image.width(), 5)}) > 30  # shaded, not flat


def test_outline_is_drawn_over_the_picture(panel):
    hands.show_tab(hands.find("Drawing"))
    hands.wait(0.1)
    image = hands.find("Preview").grab().toImage()
    colours = [
        hands.QtGui.QColor(image.pixel(x, y)) for x in range(image.width()) for y in range(image.height())
    ]
    red = [colour for colour in colours if colour.red() > 180 and colour.green() < 90]
    line = hands.find("Preview").palette().highlight().color()
    near = [colour for colour in colours if abs(colour.hue() - line.hue()) < 12 and colour.saturation() > 90]
    assert len(red) > 0.2 * len(colours)
    assert len(near) > 100


def test_cancel_leaves_the_document_untouched(panel):
    apply()
    hands.press("Cancel")
    hands.wait_until(hands.panel_is_closed)
    assert names(panel) == []
    assert panel.UndoNames == []


@pytest.mark.works_out
def test_cancel_while_it_works(panel):
    with hands.work_held():
        hands.click(hands.find("Apply"))
        hands.wait_until(lambda: hands.find("Progress").isVisible())
        hands.press("Cancel")
        hands.wait_until(hands.panel_is_closed, 5)
    assert names(panel) == []


@pytest.mark.works_out
def test_stop_keeps_the_panel_and_the_last_result(panel):
    as_drawn()
    apply()
    volume = panel.Balloon.Volume.Value
    hands.type_into(hands.find("MeshSize"), "9 mm")
    with hands.work_held():
        hands.click(hands.find("Apply"))
        hands.wait_until(lambda: hands.find("Stop").isVisible())
        hands.click(hands.find("Stop"))
        hands.wait_until(lambda: hands.find("Apply").isVisible(), 5)
    assert hands.panel_is_open()
    assert panel.Balloon.Volume.Value == volume
    assert hands.message()


@pytest.mark.slow
@pytest.mark.works_out
def test_window_lives_while_it_works(panel):
    beats = []
    timer = hands.QtCore.QTimer()
    timer.timeout.connect(lambda: beats.append(hands.find("Stop").isVisible()))
    timer.start(50)
    apply()
    assert sum(beats) >= 4
    hands.show_tab(hands.find("Pressure"))


@pytest.mark.works_out
def test_value_changed_while_it_works_counts(panel):
    as_drawn()
    with hands.work_held():
        hands.click(hands.find("Apply"))
        hands.wait_until(lambda: hands.find("Stop").isVisible())
        hands.type_into(hands.find("Pressure"), "3 kPa")
        hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert panel.Balloon.Pressure.Value == pytest.approx(3)
    assert panel.Balloon.SolvedFor == request(panel.Balloon).key()
    assert [obj.Status for obj in parts(panel)] == [status.READY] * 3


def test_without_a_document_one_is_made_and_taken_back():
    Gui.runCommand("BalloonWorkbench_FromPicture")
    hands.wait_until(hands.panel_is_seen)
    assert len(App.listDocuments()) == 1
    hands.press("Cancel")
    hands.wait_until(hands.panel_is_closed)
    assert not App.listDocuments()


@pytest.mark.parametrize(
    ("field", "text", "word"),
    [
        ("Drawing", "/no/such/picture.png", "no file"),
        ("Width", "0 mm", "size"),
        ("Width", "100 km", "width"),
        ("Pressure", "0 kPa", "pressure"),
        ("Pressure", "-1 kPa", "pressure"),
    ],
)
def test_senseless_value_is_told_in_the_panel(panel, field, text, word):
    hands.type_into(hands.find(field), text)
    if field != "Drawing":
        hands.press("Ok")
    hands.wait_until(hands.message, 10)
    assert word in hands.message()
    assert hands.panel_is_open()
    hands.press("Cancel")
    assert names(panel) == []


def test_file_that_is_no_picture(panel, tmp_path):
    path = tmp_path / "text.png"
    path.write_text("no picture")
    hands.type_into(hands.find("Drawing"), str(path))
    assert "picture" in hands.message()


def test_custom_film_can_be_edited(panel):
    young = hands.find("YoungModulus")
    assert not young.isEnabled()
    hands.choose(hands.find("Film"), "Custom")
    assert young.isEnabled()
    assert not hands.find("FirstWeld").text()
    hands.type_into(young, "2000000 kPa")
    hands.type_into(hands.find("Thickness"), "0.05 mm")
    assert panel.Balloon.YoungModulus.Value == pytest.approx(2e6)
    hands.choose(hands.find("Film"), "Polyethylene film (LDPE), 50 µm")
    assert not young.isEnabled()
    assert young.property("rawValue") == pytest.approx(panel.Balloon.YoungModulus.Value)
    assert panel.Balloon.YoungModulus.Value < 1e6
    assert hands.find("FirstWeld").text().startswith("Start values for welding: bar or iron 108C")


def test_pattern_follows_at_once(panel):
    apply()
    width = panel.Pattern.PatternWidth.Value
    hands.type_into(hands.find("SealWidth"), "9 mm")
    assert panel.Pattern.PatternWidth.Value > width + 5
    hands.tick(hands.find("Intake"))
    assert not panel.Pattern.Intake
    assert all(wire.isClosed() for wire in panel.Pattern.Shape.Wires)
    assert hands.find("IntakeWidth").isHidden()


def test_typed_number_counts_without_return(panel):
    as_drawn()
    hands.type_into(hands.find("Width"), "90 mm", confirm=False)
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert panel.Outline.SizeX.Value == pytest.approx(90)


def test_deleting_the_objects_closes_the_panel(panel):
    panel.removeObject("Balloon")
    hands.wait_until(hands.panel_is_closed, 5)


def test_closing_the_document_closes_the_panel(panel):
    App.closeDocument(panel.Name)
    hands.wait_until(hands.panel_is_closed, 5)


def test_undo_closes_the_panel(panel):
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    panel.Balloon.ViewObject.Proxy.doubleClicked(panel.Balloon.ViewObject)
    hands.wait_until(hands.panel_is_seen)
    panel.undo()
    panel.undo()
    hands.wait_until(hands.panel_is_closed, 5)
    assert names(panel) == []


@pytest.mark.slow
def test_each_shape_of_the_drawing_becomes_a_balloon(panel, tmp_path):
    def boxes(*sides):
        parts = [
            {"outer": [[x, 0], [x + side, 0], [x + side, side], [x, side]]} for x, side in zip((0, 90), sides)
        ]
        path = tmp_path / f"{len(sides)}.json"
        path.write_text(json.dumps({"unit": "mm", "parts": parts}))
        return str(path)

    hands.type_into(hands.find("Drawing"), boxes(60, 40))
    hands.type_into(hands.find("MeshSize"), "10 mm")
    apply()
    first, second = panel.Balloon, panel.Balloon001
    assert [first.Status, second.Status] == [status.READY] * 2
    # two equal square pillows but for their size
    assert first.Volume.Value / second.Volume.Value == pytest.approx(1.5**3, rel=0.1)
    hands.type_into(hands.find("Drawing"), boxes(60))
    apply()
    assert names(panel) == ["BalloonGroup", "Outline", "Balloon", "Pattern"]
    hands.press("Cancel")
    assert names(panel) == []


def test_preview_comes_to_rest_in_a_panel_of_any_height():
    area, box, preview = hands.QtWidgets.QScrollArea(), hands.QtWidgets.QWidget(), Preview()
    hands.QtWidgets.QVBoxLayout(box).addWidget(preview)
    area.setWidget(box)
    area.setWidgetResizable(True)
    for height in range(150, 290, 2):  # where its own height brings the scroll bar, and takes it away
        area.resize(400, height)
        area.show()
        hands.wait(0.005)
        assert preview.height() >= preview.minimumHeight()
    area.close()


@pytest.mark.slow
@pytest.mark.works_out  # what is known already closes the panel at Return
def test_the_side_that_follows_is_shown(panel):
    """Not as 0: what the drawing comes to; with the proportions kept the side that was typed last decides."""
    outline = panel.Outline
    height = outline.SizeY.Value
    field = hands.find("Height")
    assert outline.Height.Value == 0.0
    assert field.property("rawValue") == pytest.approx(height, abs=0.01)
    hands.key(field, hands.QtCore.Qt.Key_Return, "\r")
    hands.find("Width").setFocus()
    hands.wait(0.1)
    assert outline.Height.Value == 0.0, "looking at it changes nothing"
    hands.type_into(hands.find("Height"), "60")
    hands.wait_until(lambda: outline.SizeY.Value == pytest.approx(60.0))
    assert outline.Width.Value == 0.0
    assert hands.find("Width").property("rawValue") == pytest.approx(60.0 * 120.0 / height, abs=0.01)
    hands.tick(hands.find("KeepAspect"))
    assert outline.Width.Value == pytest.approx(60.0 * 120.0 / height, abs=0.01)
    hands.type_into(hands.find("Width"), "200")
    hands.wait_until(lambda: outline.SizeX.Value == pytest.approx(200.0))
    assert outline.SizeY.Value == pytest.approx(60.0)
    hands.press("Cancel")

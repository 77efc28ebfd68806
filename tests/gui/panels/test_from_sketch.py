# SPDX-License-Identifier: LGPL-2.1-or-later
"""New balloon from sketch, and editing it afterwards."""

import FreeCAD as App
import FreeCADGui as Gui
import hands
import pytest
import sketches

from BalloonWorkbench.app.border import status


@pytest.fixture
def rectangle(doc):
    return sketches.rectangle(doc, 90, 60)


@pytest.fixture
def made(fitted):
    return fitted


def done():
    return not hands.panel_is_open()


def solved():
    return hands.find("Apply").isVisible()


@pytest.mark.slow
def test_selected_sketch_is_inflated_at_once(rectangle):
    doc = rectangle.Document
    Gui.Selection.addSelection(rectangle)
    Gui.runCommand("BalloonWorkbench_FromSketch")
    hands.wait_until(lambda: doc.Balloon.SolvedFor != "")
    hands.wait_until(solved)
    assert doc.Balloon.Status == status.READY
    assert doc.UndoCount == 0 or doc.HasPendingTransaction
    hands.screenshot("from-sketch")
    hands.press("Ok")
    hands.wait_until(done)
    assert doc.UndoNames[0] == "New balloon from sketch"
    assert doc.Balloon.getParentGroup().Label == "Rectangle balloon"
    assert not rectangle.ViewObject.Visibility
    doc.undo()
    assert [obj.Name for obj in doc.Objects] == ["Rectangle"]
    assert rectangle.ViewObject.Visibility


def test_sketch_can_be_selected_later(rectangle):
    doc = rectangle.Document
    Gui.runCommand("BalloonWorkbench_FromSketch")
    hands.wait_until(hands.panel_is_seen)
    assert "Select a sketch" in hands.find("Source").text()
    Gui.Selection.addSelection(rectangle)
    hands.wait(0.1)
    assert hands.find("Source").text() == "Rectangle"
    assert doc.Outline.Status == status.READY
    hands.press("Cancel")
    hands.wait_until(done)
    assert [obj.Name for obj in doc.Objects] == ["Rectangle"]


def test_open_sketch_is_told_in_the_panel(doc):
    line = sketches.sketch(doc, sketches.line((0, 0), (50, 0)), name="Line")
    Gui.Selection.addSelection(line)
    Gui.runCommand("BalloonWorkbench_FromSketch")
    hands.wait_until(hands.message)
    assert "is open" in hands.message()
    assert hands.panel_is_open()


def test_objects_are_dressed(made):
    for obj in made:
        assert type(obj.ViewObject.Proxy).__module__ == "BalloonWorkbench.gui.view"
        assert obj.ViewObject.Proxy.icon_name() == obj.Name.lower()
    colours = made.pattern.ViewObject.LineColorArray
    assert len(colours) == sum(len(wire.Edges) for wire in made.pattern.Shape.Wires)
    assert len(set(colours)) == 2


def test_stale_objects_have_another_icon(made):
    made.balloon.Pressure = -1
    made.balloon.Document.recompute()
    assert made.balloon.ViewObject.Proxy.icon_name() == "balloon_warning"
    assert made.outline.ViewObject.Proxy.icon_name() == "outline"


def test_edit_is_one_undo_step(made):
    doc = made.balloon.Document
    volume = made.balloon.Volume.Value
    made.balloon.ViewObject.Proxy.doubleClicked(made.balloon.ViewObject)
    hands.wait_until(hands.panel_is_seen)
    hands.type_into(hands.find("Pressure"), "4 kPa")
    hands.choose(hands.find("Mode"), "Inflate as drawn")
    hands.press("Ok")
    hands.wait_until(done)
    assert made.balloon.Pressure.Value == pytest.approx(4)
    assert made.balloon.Volume.Value < volume
    assert doc.UndoNames == ["Edit balloon"]
    doc.undo()
    assert made.balloon.Pressure.Value == pytest.approx(2)
    assert made.balloon.Volume.Value == volume


def test_cancelled_edit_changes_nothing(made):
    doc = made.balloon.Document
    volume = made.balloon.Volume.Value
    made.balloon.ViewObject.Proxy.doubleClicked(made.balloon.ViewObject)
    hands.wait_until(hands.panel_is_seen)
    hands.choose(hands.find("Mode"), "Inflate as drawn")  # it is live: the balloon follows by itself
    hands.wait_until(lambda: made.balloon.Volume.Value < volume and solved())
    hands.press("Cancel")
    hands.wait_until(done)
    assert made.balloon.Mode == "Fit to drawing"
    assert made.balloon.Volume.Value == volume
    assert [obj.Status for obj in made] == [status.READY] * 3
    assert doc.UndoNames == []


@pytest.mark.slow
def test_field_of_a_bound_property_shows_it(made):
    made.balloon.setExpression("Pressure", "1 kPa + 2 kPa")
    made.balloon.Document.recompute()
    made.balloon.ViewObject.Proxy.doubleClicked(made.balloon.ViewObject)
    hands.wait_until(hands.panel_is_seen)
    assert hands.find("Pressure").property("rawValue") == pytest.approx(3)
    assert hands.find("Pressure").isEnabled()  # behind f(x) the expression can be changed
    assert hands.find("Pressure").property("expression").replace(" ", "") == "1kPa+2kPa"


def test_second_panel_is_not_opened(made):
    for _ in range(2):
        made.balloon.ViewObject.Proxy.doubleClicked(made.balloon.ViewObject)
    hands.wait_until(hands.panel_is_seen)
    hands.press("Cancel")
    hands.wait_until(done)


def test_editing_the_sketch_is_followed_in_the_window(made):
    made.outline.Source[0].setDatum("Width", App.Units.Quantity("110 mm"))
    made.balloon.Document.recompute()
    assert made.balloon.InflatedWidth.Value == pytest.approx(110, rel=0.03)


def test_reopened_in_the_window(made, tmp_path):
    doc = made.balloon.Document
    path = str(tmp_path / "box.FCStd")
    doc.saveAs(path)
    App.closeDocument(doc.Name)
    again = App.openDocument(path)
    hands.wait(0.2)
    balloon = again.Balloon
    assert type(balloon.ViewObject.Proxy).__name__ == "BalloonView"
    assert balloon.ViewObject.DisplayMode == "Film"
    balloon.ViewObject.Proxy.doubleClicked(balloon.ViewObject)
    hands.wait_until(hands.panel_is_seen)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Seams of a body are merged, cut and moved with the mouse in the 3D view, taken back, and typed."""

import FreeCAD as App
import FreeCADGui as Gui
import hands
import Part
import pytest
import view_port

from BalloonWorkbench.app.border import status

QtCore, QtGui, QtWidgets = hands.QtCore, hands.QtGui, hands.QtWidgets


pytestmark = pytest.mark.usefixtures("without_figures")


@pytest.fixture
def cube(doc):
    """The panel on a cube of 100 mm that is not inflated."""
    box = doc.addObject("Part::Box", "Box")
    box.Length = box.Width = box.Height = 100
    doc.recompute()
    Gui.activeDocument().activeView().viewIsometric()
    Gui.Selection.addSelection(box)
    with hands.work_held():
        Gui.runCommand("BalloonWorkbench_FromBody")
        hands.wait_until(hands.panel_is_seen)
        doc.Balloon.Live = False
        if hands.find("Stop").isVisible():
            hands.click(hands.find("Stop"))
        hands.wait_until(lambda: hands.find("Apply").isVisible())
    assert doc.Target.PanelCount == 6
    Gui.SendMsgToActiveView("ViewFit")
    hands.wait(0.5)
    return doc.Target


@pytest.fixture
def port():
    area = view_port.view_area()
    yield area.viewport()


def pixel(port, target, place):
    return view_port.pixel(port, target.getGlobalPlacement().multVec(App.Vector(*place)))


def press_key(widget, code, modifier=QtCore.Qt.NoModifier):
    """As Qt does it: whether somebody wants it is asked first."""
    asked = QtGui.QKeyEvent(QtCore.QEvent.ShortcutOverride, code, modifier)
    QtWidgets.QApplication.sendEvent(widget, asked)
    assert asked.isAccepted(), "FreeCAD's own shortcut would have it"
    QtWidgets.QApplication.sendEvent(widget, QtGui.QKeyEvent(QtCore.QEvent.KeyPress, code, modifier))
    hands.wait(0.2)


def away(target, place):
    """How far the nearest seam is from a place of the body."""
    at = target.getGlobalPlacement().multVec(App.Vector(*place))
    return target.Shape.distToShape(Part.Vertex(at))[0]


def test_the_mouse_changes_seams(cube, port):
    hint = hands.find("BodySeamHint")
    hands.tick(hands.find("SeamMirrored"))
    hands.click(hands.find("SeamMerge"))
    assert "Click a seam" in hint.text()
    view_port.move(port, pixel(port, cube, (0, -50, 49)))
    hands.screenshot("seams-merge")
    view_port.click(port, pixel(port, cube, (0, -50, 49)))
    assert cube.PanelCount == 5
    assert away(cube, (0, -50, 50)) > 40.0
    press_key(port, QtCore.Qt.Key_Z, QtCore.Qt.ControlModifier)
    assert cube.PanelCount == 6

    hands.click(hands.find("SeamCut"))
    view_port.click(port, pixel(port, cube, (-25, -48, 50)))
    assert "ends" in hint.text()
    view_port.move(port, pixel(port, cube, (-25, 20, 50)))
    hands.screenshot("seams-cut")
    press_key(port, QtCore.Qt.Key_Escape)
    assert "begins" in hint.text(), "Esc gives up the first place, and keeps the tool"
    view_port.click(port, pixel(port, cube, (-25, -48, 50)))
    view_port.click(port, pixel(port, cube, (-25, 48, 50)))
    assert cube.PanelCount == 7
    assert away(cube, (-25, 0, 50)) < 1.0

    hands.click(hands.find("SeamMove"))
    start, end = pixel(port, cube, (-25, 0, 50)), pixel(port, cube, (-10, 0, 50))
    view_port.move(port, start)
    hands.drag(port, start, end)
    hands.screenshot("seams-moved")
    assert away(cube, (-10, 0, 50)) < 1.0
    assert away(cube, (-25, 0, 50)) > 5.0

    press_key(port, QtCore.Qt.Key_Escape)
    assert not hands.find("SeamMove").isChecked()
    assert "Take a tool" in hint.text()
    assert status.is_ready(cube)
    assert len(cube.SeamEdits) == 2
    hands.press("Cancel")
    hands.wait_until(hands.panel_is_closed)
    assert [obj.Name for obj in App.ActiveDocument.Objects] == ["Box"]


def test_seams_are_changed_without_the_mouse(cube):
    rows, places = hands.find("BodySeams"), hands.find("SeamPlaces")
    assert rows.count() == 12
    rows.setCurrentRow(3)
    press_key(rows, QtCore.Qt.Key_Delete)
    assert cube.PanelCount == 5
    hands.click(hands.find("TakeBackSeam"))
    assert cube.PanelCount == 6
    hands.type_into(places, "0 -50 50; 0 50 50")
    assert cube.PanelCount == 7, "this cut is its own mirror image"
    hands.type_into(places, "far away")
    assert "Type two places" in hands.message()
    assert "Type two places" in hands.find("BodySeamHint").text(), "also where the user looks"
    hands.press("Cancel")
    hands.wait_until(hands.panel_is_closed)

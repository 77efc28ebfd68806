# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pattern in the panel: kinds of intakes, values with units, and an intake dragged with the mouse."""

import math

import FreeCAD as App
import FreeCADGui as Gui
import hands
import pytest

from BalloonWorkbench.app.border import status

QtCore, QtGui, QtWidgets = hands.QtCore, hands.QtGui, hands.QtWidgets


def mouse(kind, pixel, button, buttons):
    """A real event at a pixel of the 3D view, counted from the lower left as FreeCAD does."""
    view = Gui.ActiveDocument.ActiveView.graphicsView()
    x, y = (value / view.devicePixelRatioF() for value in pixel)
    at = QtCore.QPointF(x, view.viewport().height() - 1 - y)
    there = QtCore.QPointF(view.viewport().mapToGlobal(at.toPoint()))
    event = QtGui.QMouseEvent(kind, at, there, button, buttons, QtCore.Qt.NoModifier)
    QtWidgets.QApplication.sendEvent(view.viewport(), event)
    hands.wait(0.05)


def drag(start, end, steps=6):
    left, none = QtCore.Qt.LeftButton, QtCore.Qt.NoButton
    mouse(QtCore.QEvent.MouseMove, start, none, none)
    mouse(QtCore.QEvent.MouseButtonPress, start, left, left)
    for k in range(1, steps + 1):
        at = [a + (b - a) * k / steps for a, b in zip(start, end)]
        mouse(QtCore.QEvent.MouseMove, at, none, left)
    mouse(QtCore.QEvent.MouseButtonRelease, end, left, none)


def on_screen(pattern, x, y):
    point = Gui.ActiveDocument.ActiveView.getPointOnScreen(pattern.Placement.multVec(App.Vector(x, y, 0)))
    return [float(value) for value in point]


def test_intake_is_dragged_along_the_outline(opened):
    """From where it is to the middle of the upper edge of the box."""
    pattern = opened.pattern
    view = Gui.ActiveDocument.ActiveView
    view.viewTop()
    view.fitAll()
    hands.show_tab(hands.find("DragIntake"))
    hands.click(hands.find("DragIntake"))
    hands.wait(1.5)  # the camera flies
    box = opened.balloon
    points = [tuple(point)[:2] for point in box.SeamPoints[: box.SeamCounts[0]]]
    top, left, right = max(y for _, y in points), min(x for x, _ in points), max(x for x, _ in points)
    from BalloonWorkbench.app.pattern import build

    root = [1000.0 * float(value) for value in build(pattern).intake.at]
    assert pattern.IntakeAuto
    goal = (left + 0.5 * (right - left), top)
    drag(on_screen(pattern, *root), on_screen(pattern, goal[0], goal[1] + 8.0))
    hands.wait_until(lambda: not pattern.IntakeAuto)
    hands.screenshot("drag_intake")
    assert pattern.IntakeBy == "Place on the seam"
    found = build(pattern).intake
    assert 1000.0 * found.at[0] == pytest.approx(goal[0], abs=2.0)
    assert 1000.0 * found.at[1] == pytest.approx(top, abs=1.0)
    assert math.degrees(found.angle) == pytest.approx(90.0, abs=3.0)
    assert pattern.IntakeAngle.Value == pytest.approx(math.degrees(found.angle))
    assert pattern.Status == status.READY
    # beside the handle the mouse is the view's
    along = pattern.IntakeAlong.Value
    drag(on_screen(pattern, *root), on_screen(pattern, *goal), steps=2)
    assert pattern.IntakeAlong.Value == along
    root_node = view.getSceneGraph()
    count = root_node.getNumChildren()
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert root_node.getNumChildren() == count - 1
    pattern.Document.undo()
    assert pattern.IntakeAuto


def test_kinds_and_values_in_the_panel(opened):
    pattern = opened.pattern
    hands.choose(hands.find("IntakeKind"), "Self-sealing film valve")
    assert "does not weld" in hands.message()
    hands.choose(hands.find("IntakeKind"), "Straw neck")
    opened.balloon.Film = "nylon-foil"
    pattern.Document.recompute()
    hands.choose(hands.find("IntakeKind"), "Self-sealing film valve")
    assert pattern.IntakeWidth.Value == 24
    assert "strips" in hands.find("HowToFill").text()
    assert pattern.Roles.count("CUT") == 1 + 2
    assert not hands.find("NotchDepth").isVisible()
    hands.find("Notches").setValue(8)
    assert hands.find("NotchDepth").isVisible()
    hands.type_into(hands.find("Allowance"), "0.3 cm")
    hands.type_into(hands.find("CornerRadius"), "2 mm")
    hands.type_into(hands.find("LabelText"), "B1")
    hands.tick(hands.find("Mirror"))
    hands.find("Copies").setValue(2)
    hands.screenshot("pattern_box")
    assert pattern.Status == status.READY
    assert (pattern.Allowance.Value, pattern.CornerRadius.Value, pattern.LabelText) == (3, 2, "B1")
    assert pattern.Roles.count("CUT") == 2 * 2 * 2
    assert pattern.Shape.isValid()
    assert "NOTCH" in pattern.Roles
    hands.click(hands.find("MakeSketch"))
    (sketch,) = [obj for obj in pattern.Document.Objects if obj.isDerivedFrom("Sketcher::SketchObject")][1:]
    assert sketch.GeometryCount > sketch.ConstraintCount == len(sketch.Shape.Edges) > 10
    assert sketch.Shape.Wires[0].isClosed()
    hands.type_into(hands.find("CornerRadius"), "40 mm")
    assert "relief" in hands.message()


def express(field, text):
    """Type = into a field and an expression into the line that opens; returns the line while it is there."""
    hands.key(field, QtCore.Qt.Key_Equal, "=")
    line = field.findChild(QtWidgets.QLineEdit, "Expression")
    line.selectAll()
    hands.key(line, QtCore.Qt.Key_Delete)
    hands.type_into(line, text)
    return line if line.isVisible() else None


def test_whole_number_takes_an_expression(opened):
    pattern, doc = opened.pattern, opened.pattern.Document
    sheet = doc.addObject("Spreadsheet::Sheet", "Sheet")
    sheet.set("A1", "=2")
    doc.recompute()
    field = hands.find("Copies")
    hands.show_tab(field)
    refused = express(field, "Sheet.Nothing")
    assert "whole number" in refused.toolTip()
    hands.key(refused, QtCore.Qt.Key_Escape)
    assert hands.panel_is_open()
    assert express(field, "Sheet.A1 + 1") is None
    assert (pattern.Copies, field.value(), field.isReadOnly()) == (3, 3, True)
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    sheet.set("A1", "=4")
    doc.recompute()
    assert pattern.Copies == 5
    pattern.ViewObject.Proxy.doubleClicked(pattern.ViewObject)
    hands.wait_until(hands.panel_is_seen)
    field = hands.find("Copies")
    assert express(field, "") is None
    hands.type_into(field, "2")
    assert (pattern.Copies, pattern.ExpressionEngine) == (2, [])

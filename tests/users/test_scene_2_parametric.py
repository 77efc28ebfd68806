# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scene 2: an engineer's balloon follows a sketch and a cell; its tension as colours, its cuts as arcs."""

import FreeCAD as App
import FreeCADGui as Gui
import hands
import pytest
import sketches
import steps
from user import show

QtCore, QtWidgets = hands.QtCore, hands.QtWidgets


def test_scene_2_parametric(user, story, tmp_path):
    doc = App.newDocument("Bracket")
    hands.wait(0.3)
    drawn = _balloon_of_sketch(user, story, doc)
    _dimension_changed(user, story, doc, drawn)
    _pressure_from_a_cell(user, story, doc)
    _tension(user, story, doc.Balloon)
    _real_arcs(user, story, doc)
    _second_balloon(user, story, doc)
    _undone_and_redone(user, story, doc)
    _saved_and_opened(user, story, doc, tmp_path / "bracket.FCStd")


def _balloon_of_sketch(user, story, doc):
    drawn = sketches.rectangle(doc, 90, 60)
    Gui.SendMsgToActiveView("ViewFit")
    user.select(drawn)
    story.step("sketch-selected")
    user.command("BalloonWorkbench_FromSketch")
    hands.wait_until(hands.panel_is_seen)
    story.step("panel-opens")
    steps.inflated()
    story.step("inflated")
    for number in range(hands.find("Steps").count()):
        user.button(f"Step{number}")
        steps.inflated()
        story.step(f"page-{number + 1}")
    for word in ("Size", "Volume", "Off the drawing", "margin 2"):
        story.expect(word in steps.said(), f"the panel does not say: {word}")
    steps.leave(user)
    story.expect("001" not in doc.Balloon.Label, f"the first balloon is called {doc.Balloon.Label}")
    story.step("ok")
    return drawn


def _dimension_changed(user, story, doc, drawn):
    """In the sketch itself: its list of constraints, FreeCAD's box for a length."""
    user.double_click(user.in_tree(drawn))
    hands.wait_until(lambda: Gui.ActiveDocument.getInEdit() is not None, 20)
    hands.wait_until(lambda: bool(_rows("Width")), 20)
    hands.wait(0.5)
    story.step("sketch-opened")
    rows, place = _rows("Width")
    with user.answering("140 mm", "InsertDatum", lambda: story.step("dimension-typed")):
        user.double_click(rows.viewport().mapToGlobal(place))
        hands.wait_until(lambda: drawn.getDatum("Width").Value == pytest.approx(140), 20)
    hands.wait(0.3)
    user.panel("Close")
    hands.wait_until(lambda: Gui.ActiveDocument.getInEdit() is None, 60)
    hands.wait_until(lambda: doc.Balloon.InflatedWidth.Value == pytest.approx(140, rel=0.03), 60)
    story.step("dimension-140")


def _rows(text):
    """The list with an entry of this text, and where that is; empty when there is none."""
    for rows in hands.visible(QtWidgets.QListWidget):
        for number in range(rows.count()):
            if text in rows.item(number).text():
                rows.scrollToItem(rows.item(number))
                return rows, rows.visualItemRect(rows.item(number)).center()
    return ()


def _pressure_from_a_cell(user, story, doc):
    sheet = doc.addObject("Spreadsheet::Sheet", "Sizes")
    sheet.set("A1", "pressure")
    sheet.set("B1", "=3 kPa")
    sheet.setAlias("B1", "pressure")
    doc.recompute()
    user.open_in_tree(doc.Balloon)
    hands.wait_until(hands.panel_is_seen)
    field = hands.find("Pressure")
    hands.show_tab(field)
    show(hands.find("Apply"))  # FreeCAD's box for expressions needs room below the field
    hands.wait(0.5)  # the page takes its place
    user.click(field.mapToGlobal(QtCore.QPoint(20, field.height() // 2)))
    story.step("pressure-page")
    with user.answering("Sizes.pressure * 1", "Expression", lambda: story.step("expression-dialog")):
        user.write("=")
        hands.wait_until(lambda: doc.Balloon.Pressure.Value == pytest.approx(3), 20)
    steps.leave(user)
    story.expect(bool(doc.Balloon.ExpressionEngine), "the expression was not kept")
    story.step("expression")
    _type_into_cell(user, story, sheet, "=2 kPa")
    hands.wait_until(lambda: doc.Balloon.Pressure.Value == pytest.approx(2), 60)
    story.expect(steps.is_ready(), "the balloon does not follow the cell")


def _type_into_cell(user, story, sheet, text):
    """Open the spreadsheet, type into the second cell, and go back to the 3D view."""
    user.double_click(user.in_tree(sheet))
    hands.wait_until(lambda: bool(_tables()), 20)
    hands.wait(0.5)
    table = _tables()[0]
    user.click(table.viewport().mapToGlobal(table.visualRect(table.model().index(0, 1)).center()))
    user.write(text)
    user.key("Return")
    hands.wait(0.5)
    story.step("cell")
    area = Gui.getMainWindow().findChild(QtWidgets.QMdiArea)
    area.closeActiveSubWindow()
    Gui.activateWorkbench("BalloonWorkbench")  # FreeCAD 1.1 stays in that of spreadsheets
    hands.wait(0.5)


def _tables():
    tables = hands.visible(QtWidgets.QTableView)
    return [table for table in tables if "Sheet" in table.metaObject().className()]


def _tension(user, story, balloon):
    user.open_in_tree(balloon)
    hands.wait_until(hands.panel_is_seen)
    steps.inflated()
    user.button("GoColourMap")
    hands.wait_until(lambda: _is_shown("ColourMapPanel"), 60)
    hands.wait(0.5)
    user.choose(hands.find("ColourMap"), "ension")
    hands.wait(0.5)
    story.step("tension")
    story.expect(balloon.ViewObject.ColourMap != "Off", "no colours are shown")
    steps.leave(user)
    story.step("tension-kept")


def _is_shown(name):
    return any(widget.objectName() == name for widget in hands.visible(QtWidgets.QWidget))


def _real_arcs(user, story, doc):
    user.open_in_tree(doc.Pattern)
    hands.wait_until(hands.panel_is_seen)
    steps.inflated()
    sketches_before = len(_sketches(doc))
    user.button("MakeSketch")
    hands.wait_until(lambda: len(_sketches(doc)) > sketches_before, 20)
    hands.wait(0.3)
    story.step("arcs")
    steps.leave(user)
    made = _sketches(doc)[-1]
    kinds = {type(each).__name__ for each in made.Geometry}
    story.expect("ArcOfCircle" in kinds, f"the sketch of the cuts has no arcs: {kinds}")
    story.expect(made.ConstraintCount > 0, "the sketch of the cuts is not tied together")
    story.step("sketch-of-the-cuts")
    made.ViewObject.Visibility = False


def _sketches(doc):
    return [obj for obj in doc.Objects if obj.isDerivedFrom("Sketcher::SketchObject")]


def _second_balloon(user, story, doc):
    second = sketches.sketch(doc, *sketches.polygon((0, 0), (70, 0), (35, 60)), name="Triangle")
    steps.command(user, "FromSketch", second)
    steps.inflated()
    story.step("second-panel")
    steps.leave(user)
    steps.to_view(user)
    user.key("v")
    user.key("f")
    story.step("second")


def _undone_and_redone(user, story, doc):
    names = [obj.Name for obj in doc.Objects]
    user.key("Ctrl", "z")
    hands.wait(0.5)
    story.expect(len(doc.Objects) < len(names), "undo left the second balloon")
    story.step("undone")
    user.key("Ctrl", "Shift", "z")
    hands.wait(0.5)
    story.expect([obj.Name for obj in doc.Objects] == names, "redo did not bring the second balloon back")
    story.step("redone")


def _saved_and_opened(user, story, doc, file):
    with user.answering(file):
        user.key("Ctrl", "s")
        hands.wait_until(file.exists, 20)
    App.closeDocument(doc.Name)
    App.openDocument(str(file))
    hands.wait(1.0)
    story.expect(steps.is_ready(), "the balloons are not ready after opening")
    story.step("reopened")

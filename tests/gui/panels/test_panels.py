# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of a balloon as a user works with it: pages, keys, expressions, live and manual, next steps."""

from itertools import pairwise

import FreeCAD as App
import FreeCADGui as Gui
import hands
import pytest

from BalloonWorkbench.app.balloon import request
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import create
from BalloonWorkbench.gui.panels.balloon import result_box
from BalloonWorkbench.gui.window import tree_signs
from BalloonWorkbench.gui.window.user_units import lengths_text

QtCore, QtWidgets = hands.QtCore, hands.QtWidgets


def open_panel(obj):
    obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
    hands.wait_until(hands.panel_is_seen)


def test_double_click_opens_the_page_of_the_object(made):
    pages = {"outline": "Outline", "balloon": "Film", "pattern": "Pattern"}
    for name, page in pages.items():
        open_panel(getattr(made, name))
        tabs = hands.find("Steps")
        assert tabs.tabText(tabs.currentIndex()) == page
        hands.screenshot(f"panel-{name}")
        hands.leave()
        hands.wait_until(hands.panel_is_closed)
    open_panel(made.balloon.getParentGroup())
    assert hands.find("Steps").isVisible()


def kept(parts):
    """What the properties say, as text."""
    return {
        (obj.Name, name): str(getattr(obj, name))
        for obj in parts
        for name in obj.PropertiesList
        if not name.startswith("Shape")
    }


def test_every_field_has_a_tooltip_and_changes_nothing_by_itself(made):
    before = kept(made)
    open_panel(made.balloon)
    tabs = hands.find("Steps")
    kinds = QtWidgets.QAbstractSpinBox, QtWidgets.QComboBox, QtWidgets.QCheckBox, QtWidgets.QPushButton
    for page in range(tabs.count()):
        tabs.setCurrentIndex(page)
        hands.wait(0.02)
        fields = [widget for kind in kinds for widget in hands.visible(kind)]
        fields = [widget for widget in fields if tabs.isAncestorOf(widget)]
        assert fields
        assert [widget.objectName() for widget in fields if len(widget.toolTip()) < 10] in ([], [""])
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert kept(made) == before
    assert made.balloon.Document.UndoNames in ([], ["Edit balloon"])


def test_tab_goes_down_the_page(made):
    open_panel(made.balloon)
    hands.find("Film").setFocus()
    page = hands.find("Steps").currentWidget()
    seen = []
    for _ in range(6):
        seen.append(QtWidgets.QApplication.focusWidget())
        hands.key(seen[-1], QtCore.Qt.Key_Tab, "\t")
        hands.wait(0.02)
    assert len(set(map(id, seen))) >= 5
    # at one moment: a panel comes in parts, which move what is there already
    places = [widget.mapTo(page, QtCore.QPoint(0, 0)).y() for widget in seen]
    assert all(after > before - 3 for before, after in pairwise(places))


def test_escape_is_cancel(made):
    open_panel(made.balloon)
    hands.type_into(hands.find("Pressure"), "4 kPa")
    hands.wait_until(lambda: made.balloon.ActivePressure.Value == pytest.approx(4))
    hands.key(hands.find("Pressure"), QtCore.Qt.Key_Escape)
    hands.wait_until(hands.panel_is_closed, 5)
    assert made.balloon.Pressure.Value == pytest.approx(2)
    assert made.balloon.ActivePressure.Value == pytest.approx(2)
    assert made.balloon.Document.UndoNames == []


def test_return_confirms_and_then_is_ok(made):
    open_panel(made.balloon)
    hands.type_into(hands.find("Pressure"), "4 kPa")
    assert hands.panel_is_open()
    hands.key(hands.find("Pressure"), QtCore.Qt.Key_Return, "\r")
    hands.wait_until(hands.panel_is_closed)
    assert made.balloon.ActivePressure.Value == pytest.approx(4)
    assert made.balloon.Document.UndoNames == ["Edit balloon"]


def test_live_balloon_follows_without_apply(made):
    open_panel(made.balloon)
    volume = made.balloon.Volume.Value
    hands.choose(hands.find("Mode"), "Fit to drawing")
    hands.wait_until(lambda: made.balloon.Volume.Value > volume)
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert made.balloon.Document.UndoNames == ["Edit balloon"]
    made.balloon.Document.undo()
    assert made.balloon.Volume.Value == volume


def test_ok_closes_when_values_come_back_to_what_is_there(made):
    """The work for the values between is given up, and nothing is left to be done."""
    was = made.balloon.Pressure.UserString
    open_panel(made.balloon)
    with hands.work_held():
        hands.type_into(hands.find("Pressure"), "3 kPa")
        hands.wait_until(lambda: hands.find("Stop").isVisible())
        hands.type_into(hands.find("Pressure"), was)
        hands.press("Ok")
        hands.wait_until(hands.panel_is_closed, 20)
    assert made.balloon.Status == status.READY


def test_result_tells_what_a_creased_weld_does(made):
    """Of a corrected pattern alone; an older document has no such number yet."""
    assert "If the weld creases" not in dict(result_box.measures(made.balloon, made.pattern))
    open_panel(made.balloon)
    hands.choose(hands.find("Mode"), "Fit to drawing")
    hands.wait_until(lambda: made.balloon.CreasedMax.Value > 0)
    mean, largest = lengths_text(made.balloon.CreasedMean.Value, made.balloon.CreasedMax.Value)
    hands.wait_until(lambda: f"{mean}, at most {largest}" in _labels())
    assert "If the weld creases" in _labels()


def _labels():
    return [label.text() for label in hands.visible(hands.QtWidgets.QLabel)]


@pytest.mark.works_out
def test_newest_value_wins_while_the_solver_runs(made):
    open_panel(made.balloon)
    with hands.work_held():
        hands.type_into(hands.find("MeshSize"), "4 mm")
        hands.wait_until(lambda: hands.find("Stop").isVisible())
        hands.type_into(hands.find("MeshSize"), "12 mm")
    hands.wait_until(lambda: made.balloon.SolvedFor == request(made.balloon).key())
    assert made.balloon.MeshSize.Value == 12
    assert len(made.balloon.PanelPoints) < 250


def test_manual_balloon_waits_for_apply(made):
    open_panel(made.balloon)
    hands.click(hands.find("Live"), x=8)
    assert not made.balloon.Live
    hands.type_into(hands.find("Pressure"), "4 kPa")
    hands.wait(0.8)
    assert made.balloon.ActivePressure.Value == pytest.approx(2)
    hands.click(hands.find("Apply"))
    hands.wait_until(lambda: made.balloon.ActivePressure.Value == pytest.approx(4))


def test_manual_balloon_is_stale_and_says_why(made):
    made.balloon.Live = False
    made.outline.Source[0].setDatum("Width", App.Units.Quantity("70 mm"))
    made.balloon.Document.recompute()
    assert made.outline.SizeX.Value == pytest.approx(70)
    assert made.balloon.InflatedWidth.Value > 70
    assert made.balloon.Status.startswith(status.STALE + "The outline changed")
    assert made.pattern.Status.startswith(status.STALE)
    icons = {obj.Name: obj.ViewObject.Proxy.icon_name() for obj in (*made, made.balloon.getParentGroup())}
    assert {name for name, path in icons.items() if "_warning" in path} == {
        "Balloon",
        "Pattern",
        "BalloonGroup",
    }
    assert "outline changed" in tree_signs.remark(made.balloon.getParentGroup())


def tree_place(obj):
    """The tree that shows an object, and where."""
    for tree in hands.visible(QtWidgets.QTreeWidget):
        if tree.metaObject().className() == "Gui::TreeWidget":
            tree.expandAll()
            hands.wait(0.1)
            found = tree.findItems(obj.Label, QtCore.Qt.MatchExactly | QtCore.Qt.MatchRecursive, 0)
            if found:
                return tree, tree.visualItemRect(found[0]).center()
    raise AssertionError(f"no tree shows {obj.Label}")


def test_tooltip_in_the_tree_tells_the_reason(made):
    made.balloon.Live = False
    made.balloon.Pressure = 3
    made.balloon.Document.recompute()
    tree, place = tree_place(made.balloon)
    port = tree.viewport()
    event = hands.QtGui.QHelpEvent(QtCore.QEvent.ToolTip, place, port.mapToGlobal(place))
    QtWidgets.QApplication.sendEvent(port, event)
    hands.wait(0.1)
    assert "Pressure changed" in QtWidgets.QToolTip.text()
    hands.screenshot("stale-in-tree")
    QtWidgets.QToolTip.hideText()


def test_inflate_now_in_the_context_menu(made):
    made.balloon.Live = False
    made.balloon.Pressure = 3
    made.balloon.Document.recompute()
    made.balloon.Document.clearUndos()
    menu = QtWidgets.QMenu()
    made.balloon.ViewObject.Proxy.setupContextMenu(made.balloon.ViewObject, menu)
    assert [action.text() for action in menu.actions()] == ["Inflate now", "Colour map", "Animate inflation"]
    menu.actions()[0].trigger()
    assert made.balloon.ActivePressure.Value == pytest.approx(3)
    assert [obj.Status for obj in made] == [status.READY] * 3
    assert made.balloon.Document.UndoNames == ["Inflate now"]


def test_expression_is_typed_into_a_field(made):
    sheet = made.balloon.Document.addObject("Spreadsheet::Sheet", "Sheet")
    sheet.set("A1", "=3 kPa")
    made.balloon.Document.recompute()
    open_panel(made.balloon)
    field = hands.find("Pressure")
    hands.key(field, QtCore.Qt.Key_Equal, "=")
    hands.wait_until(
        lambda: [w for w in hands.visible(QtWidgets.QDialog) if "Expression" in w.metaObject().className()], 5
    )
    dialog = next(w for w in hands.visible(QtWidgets.QDialog) if "Expression" in w.metaObject().className())
    line = dialog.findChild(QtWidgets.QWidget, "expression")
    line.selectAll()
    for letter in "Sheet.A1 + 1 kPa":
        hands.key(line, 0, letter)
    hands.wait(0.2)
    hands.screenshot("expression")
    dialog.accept()
    hands.wait_until(lambda: made.balloon.ActivePressure.Value == pytest.approx(4))
    assert made.balloon.ExpressionEngine[0][0] == "Pressure"
    assert hands.find("Pressure").isEnabled()  # its f(x) can be clicked
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    sheet.set("A1", "=5 kPa")
    made.balloon.Document.recompute()
    assert made.balloon.ActivePressure.Value == pytest.approx(6)


def test_cancel_restores_the_looks(made):
    before = tuple(made.balloon.ViewObject.ShapeColor)
    open_panel(made.balloon)
    hands.choose(hands.find("Film"), "Kraft paper, 80 g/m²")
    assert tuple(made.balloon.ViewObject.ShapeColor) != pytest.approx(before, abs=0.05)
    hands.press("Cancel")
    hands.wait_until(hands.panel_is_closed)
    assert made.balloon.Film == "mylar"
    assert tuple(made.balloon.ViewObject.ShapeColor) == pytest.approx(before, abs=0.01)


def test_buttons_lead_on(made):
    leads = {"ColourMap": "ColourMapPanel", "Advice": "AdviceSource", "ExportPattern": "Machine"}
    for command, widget in leads.items():
        open_panel(made.pattern)
        hands.click(hands.find(f"Go{command}"))
        hands.wait_until(
            lambda name=widget: (
                hands.panel_is_seen() and Gui.getMainWindow().findChild(QtWidgets.QWidget, name)
            )
        )
        assert hands.find(widget).isVisible()
        hands.leave()
        hands.wait_until(hands.panel_is_closed)


def test_results_are_saved_from_the_window(made, tmp_path, stand_in):
    Gui.runCommand("BalloonWorkbench_ColourMap")
    hands.wait_until(hands.panel_is_seen)
    for ending in ("vtu", "stl"):
        path = tmp_path / f"rectangle.{ending}"
        answer = str(path), f"(*.{ending})"
        stand_in.setattr(
            QtWidgets.QFileDialog, "getSaveFileName", staticmethod(lambda *_, answer=answer: answer)
        )
        hands.click(hands.find("SaveResults"))
        assert str(path) in hands.find("ColourMapMessage").text()
        assert path.stat().st_size > 1000


def test_tree_has_a_group_with_an_icon(made):
    group = made.balloon.getParentGroup()
    assert [obj.Name for obj in group.Group] == ["Outline", "Balloon", "Pattern"]
    assert group.ViewObject.Proxy.icon_name() == "group"
    icons = [obj.ViewObject.Icon.pixmap(16, 16).toImage() for obj in (group, *made)]
    colours = [{image.pixel(x, y) for x in range(16) for y in range(16)} for image in icons]
    assert len(set(map(frozenset, colours))) == 4
    red = [hands.QtGui.QColor(icon.pixel(8, 6)) for icon in (icons[0], icons[2])]
    assert all(colour.red() > colour.blue() + 40 for colour in red[1:])


def test_empty_balloon_has_a_red_sign(doc):
    parts = create.make(doc)
    doc.recompute()
    assert parts.balloon.ViewObject.Proxy.icon_name() == "balloon_error"
    assert parts.balloon.getParentGroup().ViewObject.Proxy.icon_name() == "group_error"


@pytest.fixture
def inches():
    """Imperial decimal, as FreeCAD's preferences have it."""
    App.Units.setSchema(3)
    yield
    App.Units.setSchema(0)


def test_results_are_told_in_the_units_of_the_user(made, inches):
    open_panel(made.balloon)
    labels = [label.text() for label in hands.find("Result").findChildren(QtWidgets.QLabel)]
    assert f"{made.balloon.InflatedThickness.Value / 25.4:.4g} in" in labels
    assert not [text for text in labels if " mm" in text]

# SPDX-License-Identifier: LGPL-2.1-or-later
"""A study with the mouse and the keyboard: rows, working out, stopping, looking at a row, plots."""

import FreeCAD as App
import FreeCADGui as Gui
import hands
import pytest
import sketches

from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.studies import study as studies


@pytest.fixture
def made(doc):
    """A finished small balloon, selected."""
    parts = create.balloon_from_sketch(doc, sketches.rectangle(doc, 120, 80), mesh_size=12, correct=False)
    doc.clearUndos()
    Gui.Selection.addSelection(parts.balloon)
    return parts


@pytest.fixture
def study(made, tmp_path):
    """Its study, of the pressure alone, with the panel open; its balloons are kept beside the test."""
    obj = studies.make(made.balloon.Document, made, variants={"Pressure": ["2 kPa"]})
    obj.Folder = str(tmp_path)
    obj.Document.recompute()
    obj.Document.clearUndos()
    open_panel(obj)
    return obj


def open_panel(obj):
    obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
    hands.wait_until(hands.panel_is_seen)


def make_rows(first, last, count):
    hands.type_into(hands.find("StudyFirst"), first, confirm=False)
    hands.type_into(hands.find("StudyLast"), last, confirm=False)
    hands.find("StudySteps").setValue(count)
    hands.click(hands.find("StudyMakeRows"))
    hands.wait_until(lambda: hands.find("StudyRows").rowCount() == count)


def work_out(count):
    hands.click(hands.find("StudyStart"))
    assert hands.find("StudyStart").text() == "Stop"
    hands.wait_until(lambda: hands.find("StudyStart").text() == "Work out", 120)
    assert hands.find("StudyMessage").text().startswith(f"{count} of {count} rows are worked out.")


def double_click(table, row):
    """The first cell of a row."""
    table.scrollToItem(table.item(row, 0))
    hands.wait(0.1)
    at = hands.QtCore.QPointF(table.visualItemRect(table.item(row, 0)).center())
    there = hands.QtCore.QPointF(table.viewport().mapToGlobal(at.toPoint()))
    left, none = hands.QtCore.Qt.LeftButton, hands.QtCore.Qt.NoModifier
    for kind in ("MouseButtonPress", "MouseButtonRelease", "MouseButtonDblClick", "MouseButtonRelease"):
        buttons = hands.QtCore.Qt.NoButton if kind == "MouseButtonRelease" else left
        event = hands.QtGui.QMouseEvent(
            getattr(hands.QtCore.QEvent, kind), at, at, there, left, buttons, none
        )
        hands.QtWidgets.QApplication.sendEvent(table.viewport(), event)
    hands.wait(0.05)


def test_from_the_command_to_results_in_the_spreadsheet(made, tmp_path):
    """The command makes study and spreadsheet; OK keeps the results, one undo takes all away."""
    doc = made.balloon.Document
    Gui.runCommand("BalloonWorkbench_Study")
    hands.wait_until(hands.panel_is_seen)
    doc.Study.Folder = str(tmp_path)
    assert hands.find("StudyRows").rowCount() == 1
    assert doc.Study.ViewObject.Visibility
    hands.screenshot("study_new")
    work_out(1)
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert [doc.StudyTable.get(cell) for cell in ("A1", "B1")] == ["Pressure", "volume_m3"]
    assert doc.StudyTable.get("B2") == pytest.approx(1e-9 * made.balloon.Volume.Value, rel=1e-5)
    assert (doc.Study.Rows, doc.Study.Finished, doc.Study.Failed) == (1, 1, 0)
    doc.undo()
    assert not [obj for obj in doc.Objects if obj.Name in ("Study", "StudyTable")]


def test_rows_are_made_worked_out_seen_and_taken(study):
    doc, balloon = study.Document, study.Balloon
    make_rows("1 kPa", "3 kPa", 3)
    work_out(3)
    table = hands.find("StudyRows")
    volumes = [table.item(row, 1).text() for row in range(3)]
    assert len(set(volumes)) == 3
    assert set(hands.find("StudyPlot").points) == {2, 3, 4}
    hands.screenshot("study")
    double_click(table, 2)
    hands.wait_until(lambda: study.Shown is not None)
    assert study.Shown.Label == f"{balloon.Label}, row 4"
    assert (study.Shown.ViewObject.Visibility, balloon.ViewObject.Visibility) == (True, False)
    assert study.Shown.Mesh.CountFacets == balloon.Mesh.CountFacets
    table.selectRow(2)
    hands.click(hands.find("StudyTake"))
    assert balloon.Pressure.Value == 3.0
    assert study.Shown.Mesh.Volume == pytest.approx(balloon.Mesh.Volume, rel=1e-5)
    assert hands.find("StudyMessage").text().startswith("3 of 3"), "rows of the same document stay"
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert [study.Table.get(f"A{row}").Value for row in (2, 3, 4)] == [1.0, 2.0, 3.0]
    assert study.Table.get("B4") > study.Table.get("B2") > 0.0
    doc.undo()
    assert balloon.Pressure.Value == 2.0


@pytest.mark.slow
def test_stopped_and_gone_on_with(study):
    make_rows("1 kPa", "2 kPa", 36)  # more than are done while a click is awaited
    hands.click(hands.find("StudyStart"))
    hands.wait_until(lambda: not hands.find("StudyMessage").text().startswith("0 of"), 60)
    hands.click(hands.find("StudyStart"))
    hands.wait_until(lambda: hands.find("StudyStart").text() == "Work out")
    done = int(hands.find("StudyMessage").text().split()[0])
    assert 1 <= done < 36
    work_out(36)
    hands.press("Cancel")
    hands.wait_until(hands.panel_is_closed)
    assert study.Table.getContents("A3") == "", "Cancel takes the rows back"


def test_the_panel_closes_while_rows_are_worked_out(study):
    make_rows("1 kPa", "2 kPa", 12)
    hands.click(hands.find("StudyStart"))
    hands.wait(0.5)
    hands.press("Cancel")
    hands.wait_until(hands.panel_is_closed)
    assert study.Rows == 1


def test_mistakes_are_sentences(study):
    hands.type_into(hands.find("StudyFirst"), "3 mm", confirm=False)
    hands.click(hands.find("StudyMakeRows"))
    assert "another unit" in hands.find("StudyMessage").text()
    study.Table.set("A1", "Pressur")
    study.Table.recompute()
    hands.click(hands.find("StudyStart"))
    assert "nearest" in hands.find("StudyMessage").text()
    hands.press("Cancel")
    hands.wait_until(hands.panel_is_closed)


def test_the_document_is_closed_while_rows_are_worked_out(study):
    make_rows("1 kPa", "2 kPa", 12)
    hands.click(hands.find("StudyStart"))
    hands.wait(0.5)
    App.closeDocument(study.Document.Name)
    hands.wait(0.5)
    assert hands.panel_is_closed()


@pytest.mark.slow
@pytest.mark.parametrize("gone", ["Table", "Balloon"])
def test_what_it_needs_is_deleted(study, gone):
    """A sentence says what to choose; the panel can still be left."""
    make_rows("1 kPa", "2 kPa", 3)
    work_out(3)
    doc, table = study.Document, hands.find("StudyRows")
    table.selectRow(1)
    doc.removeObject(getattr(study, gone).Name)
    doc.recompute()
    for act in (
        lambda: hands.click(hands.find("StudyStart")),
        lambda: hands.click(hands.find("StudyMakeRows")),
        lambda: hands.click(hands.find("StudyTake")),
        lambda: double_click(table, 1),
    ):
        act()
        assert "choose" in hands.find("StudyMessage").text()
    hands.press("Cancel")
    hands.wait_until(hands.panel_is_closed)
    assert doc.getObject(study.Name) is not None


def test_undone_with_the_panel_open(made):
    doc = made.balloon.Document
    Gui.runCommand("BalloonWorkbench_Study")
    hands.wait_until(hands.panel_is_seen)
    Gui.runCommand("Std_Undo")
    hands.wait(0.5)
    if hands.panel_is_open():
        hands.leave()
    assert doc.getObject("StudyTable") is None or doc.getObject("Study") is not None
    assert made.balloon.Status == "up to date"

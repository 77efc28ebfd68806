# SPDX-License-Identifier: LGPL-2.1-or-later
"""Export pattern: choosing, writing and failing in the panel."""

import re
from pathlib import Path

import FreeCADGui as Gui
import hands
import pytest

from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.properties import property_table
from BalloonWorkbench.gui.panels.balloon import result_box
from BalloonWorkbench.gui.panels.widgets import target_file


@pytest.fixture
def panel(made):
    Gui.Selection.addSelection(made.balloon)
    Gui.runCommand("BalloonWorkbench_ExportPattern")
    hands.wait_until(hands.panel_is_seen)
    return made


def test_size_is_shown_in_millimetres(panel):
    text = hands.find("Size").text()
    assert f"{panel.pattern.PatternWidth.Value:.4g} x {panel.pattern.PatternHeight.Value:.4g} mm" in text
    hands.screenshot("export")


@pytest.mark.parametrize("kind", ["DXF", "SVG"])
def test_file_is_written(panel, tmp_path, kind):
    hands.type_into(hands.find("File"), str(tmp_path / "mine.dxf"), confirm=False)
    combo = hands.find("Machine")
    combo.setFocus()
    if kind == "SVG":
        hands.key(combo, hands.QtCore.Qt.Key_Down)
    assert combo.currentText() == f"Any program ({kind})"
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert [path.name for path in tmp_path.iterdir()] == [f"mine.{kind.lower()}"]
    start = next(tmp_path.iterdir()).read_bytes()[:200]
    assert (b"<svg" in start) == (kind == "SVG")
    assert panel.pattern.Document.UndoNames == []


def test_unwritable_place_is_told_in_the_panel(panel, tmp_path):
    (tmp_path / "file").write_text("no folder")
    hands.type_into(hands.find("File"), str(tmp_path / "file" / "pattern.dxf"), confirm=False)
    hands.press("Ok")
    assert "write" in hands.message()
    assert hands.panel_is_open()


def test_stale_pattern_is_told_in_the_panel(panel, tmp_path):
    panel.balloon.Pressure = -1
    panel.balloon.Document.recompute()
    hands.type_into(hands.find("File"), str(tmp_path / "pattern.dxf"), confirm=False)
    hands.press("Ok")
    assert "pressure" in hands.message()
    assert not list(tmp_path.iterdir())


def test_file_is_named_after_the_balloon_and_goes_beside_the_document(panel):
    """Its name is seen whole, its folder below it, both as the tooltip."""
    folder = Path(panel.pattern.Document.FileName).parent
    assert hands.find("File").text() == "Rectangle balloon.dxf"
    assert hands.find("FileFolder").text() == f"in {folder}"
    assert hands.find("File").toolTip() == str(folder / "Rectangle balloon.dxf")
    combo = hands.find("Machine")
    combo.setCurrentIndex(combo.findText("Plain paper (PDF)"))
    assert hands.find("File").text() == "Rectangle balloon-paper.pdf"
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert (folder / "Rectangle balloon-paper.pdf").is_file()


@pytest.mark.parametrize("label", ["Balloon", "Balloon001", "Painted balloon"])
def test_balloon_without_a_name_is_called_as_its_document(made, label):
    made.balloon.getParentGroup().Label = label
    assert target_file.name_of(made.pattern) == "Test"


def test_names_are_fit_for_every_file_system(made):
    made.balloon.getParentGroup().Label = 'Fish: "3/4" <new>?'
    Gui.Selection.addSelection(made.balloon)
    Gui.runCommand("BalloonWorkbench_ExportPattern")
    hands.wait_until(hands.panel_is_seen)
    assert hands.find("File").text() == "Fish_ _3_4_ _new_.dxf"


def type_name(text):
    """Into the field of the file, which is left then; Return would be OK."""
    hands.type_into(hands.find("File"), text, confirm=False)
    hands.find("File").editingFinished.emit()


def test_a_chosen_name_without_its_ending_is_another_file(panel, tmp_path, stand_in):
    """The dialog has asked about "mine", not about the file that is written."""
    there = tmp_path / "mine.dxf"
    there.write_text("precious")
    dialog = hands.QtWidgets.QFileDialog
    stand_in.setattr(dialog, "getSaveFileName", staticmethod(lambda *_: (str(tmp_path / "mine"), "")))
    hands.find("File").parent()._browse()
    assert not hands.find("FileReplace").isChecked()
    hands.press("Ok")
    assert "mine.dxf" in hands.message()
    assert there.read_text() == "precious"
    stand_in.setattr(dialog, "getSaveFileName", staticmethod(lambda *_: (str(there), "")))
    hands.find("File").parent()._browse()
    assert hands.find("FileReplace").isChecked()


def test_no_file_is_replaced_unasked(panel, tmp_path):
    """A box asks; its tick is for that name only."""
    there = tmp_path / "mine.dxf"
    there.write_text("precious")
    type_name(str(there))
    assert hands.find("FileReplace").isVisible()
    hands.press("Ok")
    assert "mine.dxf" in hands.message()
    assert there.read_text() == "precious"
    hands.click(hands.find("FileReplace"), x=8)
    type_name("other.dxf")
    assert not hands.find("FileReplace").isVisible()
    type_name("mine.dxf")
    assert not hands.find("FileReplace").isChecked()
    hands.click(hands.find("FileReplace"), x=8)
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert b"SECTION" in there.read_bytes()


def test_next_file_goes_where_the_last_one_went(panel, tmp_path):
    hands.type_into(hands.find("File"), str(tmp_path / "mine.dxf"), confirm=False)
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    Gui.runCommand("BalloonWorkbench_ExportPattern")
    hands.wait_until(hands.panel_is_seen)
    assert hands.find("FileFolder").text() == f"in {tmp_path}"
    assert hands.find("File").text() == "Rectangle balloon.dxf"


def test_no_measures_of_what_is_not_there(doc):
    """A balloon that is still without a drawing: dashes, in every panel that can be opened on it."""
    Gui.Selection.addSelection(create.make(doc).balloon)
    commands = ("ExportPattern", "AssemblySheet", "Artwork", "ColourMap")
    offered = [name for name in commands if Gui.Command.get(f"BalloonWorkbench_{name}").isActive()]
    assert offered == ["ExportPattern"]
    for command in offered:
        Gui.runCommand(f"BalloonWorkbench_{command}")
        hands.wait_until(hands.panel_is_seen)
        texts = [label.text() for label in hands.visible(hands.QtWidgets.QLabel)]
        assert not [text for text in texts if re.search(r"(?<![\d.])0(\.0+)? (x|mm|g\b|l\b)", text)], command
        hands.leave()
        hands.wait_until(hands.panel_is_closed)


def test_dash_while_the_pattern_is_not_ready(made):
    """The balloon is there, its pattern is not: as after a mistake in its values."""
    made.pattern.Allowance = -1
    made.balloon.Weight = 0
    with property_table.results(made.pattern) as pattern:
        pattern.Roles, pattern.PatternWidth, pattern.PatternHeight = [], 0, 0
    told = dict(result_box.measures(made.balloon, made.pattern))
    assert told["Pattern"] == told["Weight"] == "\N{EN DASH}"


def test_closing_the_document_closes_the_panel(panel):
    import FreeCAD as App

    App.closeDocument(panel.pattern.Document.Name)
    hands.wait_until(hands.panel_is_closed, 5)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Export pattern: choosing, writing and failing in the panel."""

import FreeCADGui as Gui
import hands
import pytest


@pytest.fixture
def panel(made):
    Gui.Selection.addSelection(made.balloon)
    Gui.runCommand("BalloonWorkbench_ExportPattern")
    hands.wait_until(hands.panel_is_open)
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


def test_closing_the_document_closes_the_panel(panel):
    import FreeCAD as App

    App.closeDocument(panel.pattern.Document.Name)
    hands.wait_until(hands.panel_is_closed, 5)

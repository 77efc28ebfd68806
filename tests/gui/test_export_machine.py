# SPDX-License-Identifier: LGPL-2.1-or-later
"""Export for a machine: the panel names the file, shows the check, writes, and refuses."""

import json

import FreeCADGui as Gui
import hands
import pytest
import sketches

from BalloonWorkbench.app import create
from BalloonWorkbench.core.export.machine import FOLDER


@pytest.fixture
def made(doc, tmp_path, monkeypatch):
    folder = tmp_path / "machines"
    folder.mkdir()
    data = json.loads((FOLDER / "lightburn.json").read_text(encoding="utf-8"))
    tiny = {**data, "name": "tiny", "title": "Tiny laser", "bed_mm": [50, 50]}
    (folder / "tiny.json").write_text(json.dumps(tiny), encoding="utf-8")
    coarse = {**data, "name": "coarse", "title": "Coarse laser", "least_radius_mm": 90}
    (folder / "coarse.json").write_text(json.dumps(coarse), encoding="utf-8")
    monkeypatch.setenv("BALLOON_MACHINES", str(folder))
    parts = create.balloon_from_sketch(doc, sketches.ring(doc), mesh_size=12, correct=False)
    Gui.Selection.addSelection(parts.pattern)
    Gui.runCommand("BalloonWorkbench_ExportPattern")
    hands.wait_until(hands.panel_is_open)
    return parts


def choose(title):
    combo = hands.find("Machine")
    combo.setCurrentIndex(combo.findText(title))
    hands.wait(0.05)


def remarks():
    rows = hands.find("Preflight")
    return [rows.item(row).text() for row in range(rows.count())]


def test_machine_names_the_file_and_it_is_written(made, tmp_path):
    choose("Plain paper (PDF)")
    assert remarks() == ["Checked: ready to make."]
    assert hands.find("File").text().endswith("pattern-paper.pdf")
    assert hands.find("Pages").isVisible()
    hands.find("Pages").setCurrentIndex(1)
    hands.screenshot("export_machine")
    hands.type_into(hands.find("File"), str(tmp_path / "sheet.pdf"), confirm=False)
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    content = (tmp_path / "sheet.pdf").read_bytes()
    assert content.startswith(b"%PDF")
    assert content.count(b"/Type /Page\n") > 1


def test_too_small_a_bed_is_shown_and_refused(made, tmp_path):
    choose("Tiny laser")
    (text,) = remarks()
    assert text.startswith("Not possible")
    assert "in)" in text
    hands.type_into(hands.find("File"), str(tmp_path / "x.dxf"), confirm=False)
    hands.press("Ok")
    assert "bed" in hands.message()
    assert not (tmp_path / "x.dxf").exists()


def test_place_of_a_remark_is_marked_in_the_view(made):
    root = Gui.ActiveDocument.ActiveView.getSceneGraph()
    before = root.getNumChildren()
    choose("Coarse laser")
    assert "radius" in remarks()[0]
    hands.find("Preflight").setCurrentRow(0)
    assert root.getNumChildren() == before + 1
    choose("Any program (SVG)")
    assert root.getNumChildren() == before

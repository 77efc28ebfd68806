# SPDX-License-Identifier: LGPL-2.1-or-later
"""Export for a machine: the panel names the file, shows the check, writes, and refuses."""

import json

import FreeCAD as App
import FreeCADGui as Gui
import hands
import pytest
import sketches
from read_back import pages_of

from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.properties import preferences
from BalloonWorkbench.core.machines.machine import FOLDER
from BalloonWorkbench.gui.window import macro_recorder


@pytest.fixture
def made(doc, tmp_path, monkeypatch):
    folder = tmp_path / "machines"
    folder.mkdir()
    data = json.loads((FOLDER / "lightburn.json").read_text(encoding="utf-8"))
    tiny = {**data, "name": "tiny", "title": "Tiny laser", "bed_mm": [50, 50]}
    (folder / "tiny.json").write_text(json.dumps(tiny), encoding="utf-8")
    coarse = {**data, "name": "coarse", "title": "Coarse laser", "least_radius_mm": 90}
    (folder / "coarse.json").write_text(json.dumps(coarse), encoding="utf-8")
    laser = json.loads((FOLDER / "gcode-grbl.json").read_text(encoding="utf-8"))
    laser["tool"] |= {"feed_mm_min": 600, "power_percent": 40}
    foil = {**laser, "name": "foil", "title": "Foil on a laser", "bed_mm": None}
    (folder / "foil.json").write_text(json.dumps(foil), encoding="utf-8")
    monkeypatch.setenv("BALLOON_MACHINES", str(folder))
    parts = create.balloon_from_sketch(doc, sketches.ring(doc), mesh_size=12, correct=False)
    Gui.Selection.addSelection(parts.pattern)
    Gui.runCommand("BalloonWorkbench_ExportPattern")
    hands.wait_until(hands.panel_is_seen)
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
    assert hands.find("File").text() == "Ring balloon-paper.pdf"
    assert hands.find("Pages").isVisible()
    hands.find("Pages").setCurrentIndex(1)
    hands.screenshot("export_machine")
    hands.type_into(hands.find("File"), str(tmp_path / "sheet.pdf"), confirm=False)
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert pages_of(tmp_path / "sheet.pdf")[0] > 1


def test_too_small_a_bed_is_shown_and_refused(made, tmp_path):
    choose("Tiny laser")
    (text,) = remarks()
    assert text.startswith("Not possible")
    assert "in)" in text
    hands.type_into(hands.find("File"), str(tmp_path / "x.dxf"), confirm=False)
    hands.press("Ok")
    assert "bed" in hands.message()
    assert not (tmp_path / "x.dxf").exists()


@pytest.fixture(autouse=True)
def no_beds():
    """No bed and no tabs of the user's own, before and after."""
    group = App.ParamGet(preferences.PATH)
    own = "Beds", "Tabs", "TabsBelow"
    for name in own:
        group.RemGroup(name)
    yield
    for name in own:
        group.RemGroup(name)


def lines_of_macro(monkeypatch):
    """What is recorded from now on."""
    lines = []
    monkeypatch.setattr(macro_recorder, "call", lambda *given, **named: lines.append((given, named)))
    return lines


def test_larger_than_the_bed_is_written_when_that_is_ticked(made, tmp_path, stand_in):
    choose("Tiny laser")
    assert not hands.find("WriteAnyway").isChecked()
    hands.screenshot("export_too_large")
    hands.type_into(hands.find("File"), str(tmp_path / "x.dxf"), confirm=False)
    hands.click(hands.find("WriteAnyway"), x=8)
    lines = lines_of_macro(stand_in)
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert (tmp_path / "x.dxf").stat().st_size > 200
    assert lines[0][1] == {"machine": '"tiny"', "oversize": '"write"'}


def test_larger_than_the_bed_is_split_when_that_is_ticked(made, tmp_path, stand_in):
    """One of both ticks at a time; the files lie beside the first."""
    choose("Tiny laser")
    width, height = made.pattern.PatternWidth.Value + 50.0, 0.7 * made.pattern.PatternHeight.Value
    hands.type_into(hands.find("Bed"), f"{width:.0f} x {height:.0f} mm")
    hands.type_into(hands.find("File"), str(tmp_path / "x.dxf"), confirm=False)
    hands.click(hands.find("WriteAnyway"), x=8)
    hands.click(hands.find("SplitOverBeds"), x=8)
    assert not hands.find("WriteAnyway").isChecked()
    for name in ("x-2.dxf", "x-13.dxf", "x-02.dxf", "xx-2.dxf"):  # two of them belong to an earlier split
        (tmp_path / name).write_text("of mine")
    hands.press("Ok")
    hands.wait_until(hands.message)
    assert "x-13.dxf, x-2.dxf is there already" in hands.message()
    assert (tmp_path / "x-2.dxf").read_text() == "of mine"
    for name in ("x-2.dxf", "x-13.dxf", "x-02.dxf", "xx-2.dxf"):
        (tmp_path / name).unlink()
    lines = lines_of_macro(stand_in)
    hands.press("Ok")
    hands.wait_until(lambda: hands.panel_is_closed() or hands.message())
    assert hands.panel_is_closed()
    names = sorted(path.name for path in tmp_path.glob("x*.dxf"))
    assert names == ["x-2.dxf", "x.dxf"]
    assert lines[0][1]["oversize"] == '"split"'


def test_tick_is_for_one_machine(made):
    choose("Tiny laser")
    hands.click(hands.find("WriteAnyway"), x=8)
    choose("Any program (DXF)")
    choose("Tiny laser")
    assert not hands.find("WriteAnyway").isChecked()


def test_bed_is_a_field_kept_for_the_machine(made, tmp_path, stand_in):
    choose("Tiny laser")
    assert hands.find("Bed").text() == "50 x 50 mm"
    hands.type_into(hands.find("Bed"), "nonsense")
    assert "length" in remarks()[0]
    hands.type_into(hands.find("Bed"), "90 x 60 cm")
    assert remarks() == ["Checked: ready to make."]
    assert not hands.find("WriteAnyway").isVisible()
    hands.press("Cancel")
    hands.wait_until(hands.panel_is_closed)
    Gui.runCommand("BalloonWorkbench_ExportPattern")
    hands.wait_until(hands.panel_is_seen)
    choose("Tiny laser")
    assert hands.find("Bed").text() == "900 x 600 mm"
    choose("Any program (DXF)")
    assert hands.find("Bed").text() == ""
    assert hands.find("Bed").placeholderText() == "No limit"
    choose("Tiny laser")
    hands.type_into(hands.find("File"), str(tmp_path / "x.dxf"), confirm=False)
    lines = lines_of_macro(stand_in)
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert lines[0][1] == {"machine": '"tiny"', "bed": '"900 mm x 600 mm"'}


def test_tabs_are_kept_for_the_machine(made, tmp_path, stand_in):
    choose("Plain paper (PDF)")
    assert not hands.find("TabWidth").isVisible()
    choose("Any program (DXF)")
    hands.type_into(hands.find("TabWidth"), "many")
    assert "length" in remarks()[0]
    hands.type_into(hands.find("TabWidth"), "40 mm")
    assert "A tab must be" in remarks()[0]
    hands.type_into(hands.find("TabWidth"), "0.4 mm")
    assert remarks() == ["Checked: ready to make."]
    hands.screenshot("export_tabs")
    hands.type_into(hands.find("TabsBelow"), "1 cm")
    choose("Tiny laser")
    assert hands.find("TabWidth").text() == ""
    choose("Any program (DXF)")
    assert (hands.find("TabWidth").text(), hands.find("TabsBelow").text()) == ("0.4 mm", "10 mm")
    hands.type_into(hands.find("TabsBelow"), "50 cm")
    hands.type_into(hands.find("File"), str(tmp_path / "x.dxf"), confirm=False)
    lines = lines_of_macro(stand_in)
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert lines[0][1] == {"machine": '"any-dxf"', "tabs": '"0.4 mm"', "tabs_below": '"500 mm"'}
    assert (tmp_path / "x.dxf").read_bytes().count(b"LWPOLYLINE") > 8


def test_a_sketch_decides_the_size_itself(made):
    """It is not touched: the panel says where to make it smaller."""
    choose("Tiny laser")
    assert not hands.find("ScaleToFit").isVisible()
    assert hands.find("WhyNotScaled").text() == "The size comes from Ring: make it smaller there."


def test_scaled_to_fit_in_one_undo_step(tmp_path, stand_in, doc):
    """The drawing is smaller, the balloon solved anew, the weld as before; one undo brings it back."""
    path = tmp_path / "square.json"
    path.write_text(json.dumps({"unit": "mm", "outer": [[0, 0], [200, 0], [200, 150], [0, 150]]}))
    parts = create.balloon_from_picture(doc, path, "200 mm", mesh_size=25, correct=False, intake=False)
    doc.clearUndos()
    weld, volume = parts.pattern.SealWidth.Value, parts.balloon.Volume.Value
    Gui.Selection.addSelection(parts.pattern)
    Gui.runCommand("BalloonWorkbench_ExportPattern")
    hands.wait_until(hands.panel_is_seen)
    choose("LightBurn (laser)")
    hands.type_into(hands.find("Bed"), "160 x 120 mm")
    lines = lines_of_macro(stand_in)
    hands.click(hands.find("ScaleToFit"))
    hands.wait_until(lambda: parts.outline.Width.Value < 190)
    hands.wait_until(lambda: "wide instead of 200 mm" in hands.message())
    hands.screenshot("export_scaled")
    assert not any(text.startswith("Not possible") for text in remarks())
    assert 109 < parts.pattern.PatternHeight.Value <= 110  # the bar takes 10 mm
    assert parts.balloon.Volume.Value < 0.8 * volume
    assert parts.pattern.SealWidth.Value == weld
    assert lines[0][0][0] == "change"
    assert doc.UndoNames == ["Scale to fit"]
    hands.press("Cancel")
    hands.wait_until(hands.panel_is_closed)
    doc.undo()
    assert parts.outline.Width.Value == pytest.approx(200)
    assert parts.balloon.Volume.Value == pytest.approx(volume)


def test_place_of_a_remark_is_marked_in_the_view(made):
    root = Gui.ActiveDocument.ActiveView.getSceneGraph()
    before = root.getNumChildren()
    choose("Coarse laser")
    assert "radius" in remarks()[0]
    hands.find("Preflight").setCurrentRow(0)
    assert root.getNumChildren() == before + 1
    choose("Any program (SVG)")
    assert root.getNumChildren() == before


@pytest.mark.slow
def test_tool_paths_come_into_the_document_and_one_undo_takes_them_back(made, stand_in):
    """Offered for machines that read G-code; without what only the user knows the panel stays and says so."""
    document, before = made.pattern.Document, len(made.pattern.Document.Objects)
    choose("Plain paper (PDF)")
    assert not hands.find("AsToolPaths").isVisible()
    choose("GRBL machine (G-code)")
    assert hands.find("File").text() == "Ring balloon-gcode-grbl.gcode"
    hands.click(hands.find("AsToolPaths"), x=8)
    assert "Not possible: Nobody but you knows the feed and power of your laser" in remarks()[0]
    hands.press("Ok")
    hands.wait(0.05)
    assert "Nobody but you" in hands.find("Message").text()
    choose("Foil on a laser")
    hands.screenshot("export_tool_paths")
    lines = lines_of_macro(stand_in)
    docks = Gui.getMainWindow().findChildren(hands.QtWidgets.QDockWidget)
    report = next(dock for dock in docks if dock.objectName() == "Report view")
    report.hide()
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    hands.wait(0.3)
    assert not report.isVisible(), "the report view comes up"
    (job,) = (obj for obj in document.Objects[before:] if obj.Name.startswith("Job"))
    (paths,) = job.Operations.Group
    assert "M4 S400" in paths.Path.toGCode()
    assert job.ViewObject.Proxy and paths.ViewObject.Proxy and paths.ViewObject.Icon
    films = [obj for obj in document.Objects[before:] if obj.Label.endswith("film")]
    shown = [obj for obj in films if obj.ViewObject.Visibility]
    assert shown
    assert all(obj.ViewObject.Transparency > 50 for obj in shown), "path and balloon are seen through it"
    (positional, named), *_ = lines
    assert positional == ("tool_paths", macro_recorder.obj(made.pattern), '"foil"')
    assert named == {"result": [job]}
    document.undo()
    assert len(document.Objects) == before
    document.redo()
    document.undo()
    assert len(document.Objects) == before

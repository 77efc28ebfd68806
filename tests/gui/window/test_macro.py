# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user does is written into the macro, and the macro does it again, without a window."""

import json
import shutil
import subprocess
from pathlib import Path

import brush
import FreeCAD as App
import FreeCADGui as Gui
import hands
import pytest
import sketches
from flat_hands import open_tab

from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.document.parts import patterns
from BalloonWorkbench.core.results.colour_map import WRINKLES
from BalloonWorkbench.gui.pattern_view import tab as pattern_tab
from BalloonWorkbench.gui.window import macro_recorder

HEART = Path("resources/examples/pictures/heart.png").resolve()


@pytest.fixture
def macro(monkeypatch):
    """The lines that go into the macro; they run as in FreeCAD."""
    lines = []
    run = Gui.doCommand

    def listen(line):
        lines.append(line)
        run(line)

    monkeypatch.setattr(macro_recorder.Gui, "doCommand", listen)
    return lines


def measures(doc):
    """What two documents must agree in."""
    found = {}
    for pattern in patterns(doc):
        balloon = pattern.Balloon
        found[balloon.Name] = [
            balloon.Volume.Value,
            balloon.InflatedThickness.Value,
            balloon.Mesh.CountFacets,
            pattern.PatternWidth.Value,
            pattern.SeamLength.Value,
        ]
    return found


def run_without_window(lines, tmp_path, before=""):
    """Run a macro in FreeCAD's console program; returns the measures of its document."""
    told = tmp_path / "told.json"
    code = f"""
import json, os, sys
import FreeCAD as App
App.newDocument("Replay")
{before}
{chr(10).join(lines)}
sys.path.append({str(Path(__file__).parents[1])!r})
from BalloonWorkbench.app.document.parts import patterns
from BalloonWorkbench.core.results.colour_map import WRINKLES
found = {{}}
for pattern in patterns(App.ActiveDocument):
    balloon = pattern.Balloon
    found[balloon.Name] = [balloon.Volume.Value, balloon.InflatedThickness.Value, balloon.Mesh.CountFacets,
                           pattern.PatternWidth.Value, pattern.SeamLength.Value]
open({str(told)!r}, "w").write(json.dumps(found))
os._exit(0)
"""
    path = tmp_path / "replay.py"
    path.write_text(code, encoding="utf-8")
    ended = subprocess.run(
        ["freecadcmd", str(path)], capture_output=True, text=True, timeout=hands.patience(120), check=False
    )
    assert told.exists(), ended.stdout + ended.stderr
    return json.loads(told.read_text(encoding="utf-8"))


@pytest.mark.slow
def test_new_balloon_from_picture(macro, tmp_path):
    Gui.runCommand("BalloonWorkbench_FromPicture")
    hands.wait_until(hands.panel_is_seen)
    hands.type_into(hands.find("Drawing"), str(HEART))
    hands.type_into(hands.find("Width"), "120 mm")
    hands.type_into(hands.find("MeshSize"), "12 mm")
    hands.choose(hands.find("Film"), "Polyethylene film (LDPE), 50 µm")
    hands.type_into(hands.find("Allowance"), "4 mm")
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed, 120)
    made = [line for line in macro if "from_picture" in line]
    assert len(made) == 1
    assert f'from_picture(App.ActiveDocument, "{HEART}", width="120 mm"' in made[0]
    assert all(text in made[0] for text in ('film="pe"', 'mesh_size="12 mm"', 'allowance="4 mm"'))
    assert "young" not in made[0], "the film's own values need no saying"
    replayed = run_without_window(macro, tmp_path)
    assert list(replayed) == list(measures(App.ActiveDocument))
    for name, expected in measures(App.ActiveDocument).items():
        assert replayed[name] == pytest.approx(expected, rel=1e-6)


def test_cancelled_balloon_leaves_no_line(doc, macro):
    Gui.runCommand("BalloonWorkbench_FromPicture")
    hands.wait_until(hands.panel_is_seen)
    hands.press("Cancel")
    assert not macro


def test_edit_records_what_changed(opened, macro, tmp_path):
    """The same line does the same to another balloon like it."""
    hands.type_into(hands.find("Pressure"), "1.2 kPa")
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed, 60)
    balloon = f'BalloonWorkbench.parts(App.ActiveDocument.getObject("{opened.balloon.Name}"))'
    assert macro == ["import BalloonWorkbench", f'BalloonWorkbench.change({balloon}, pressure="1.2 kPa")']
    before = f"""
sys.path.append({str(Path(sketches.__file__).parent)!r})
import sketches
from BalloonWorkbench.app.document import create
plate = sketches.rectangle(App.ActiveDocument, 90, 60)
create.balloon_from_sketch(App.ActiveDocument, plate, mesh_size=10, correct=False)
"""
    replayed = run_without_window(macro, tmp_path, before)
    expected = measures(opened.balloon.Document)[opened.balloon.Name]
    assert replayed[opened.balloon.Name] == pytest.approx(expected, rel=1e-6)


def test_inflate_now_and_a_sketch_of_the_pattern(opened, macro):
    balloon, doc = opened.balloon, opened.balloon.Document
    hands.show_tab(hands.find("MakeSketch"))
    hands.click(hands.find("MakeSketch"))
    assert not macro, "the panel can still be cancelled"
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed, 60)
    pattern = f'App.ActiveDocument.getObject("{opened.pattern.Name}")'
    assert macro[1:] == [f"sketch = BalloonWorkbench.sketch({pattern})"]
    first = doc.Objects[-1]
    replay(macro)
    assert doc.Objects[-1] != first
    assert doc.Objects[-1].GeometryCount == first.GeometryCount
    macro.clear()
    balloon.Live = False
    balloon.Pressure = 3
    doc.recompute()
    menu = hands.QtWidgets.QMenu()
    balloon.ViewObject.Proxy.setupContextMenu(balloon.ViewObject, menu)
    menu.actions()[0].trigger()
    made = f'BalloonWorkbench.parts(App.ActiveDocument.getObject("{balloon.Name}"))'
    assert macro[1:] == [f"BalloonWorkbench.inflate({made})"]
    balloon.Pressure = 4
    doc.recompute()
    assert balloon.ActivePressure.Value == pytest.approx(3)
    replay(macro)
    assert balloon.ActivePressure.Value == pytest.approx(4)


def test_from_sketch(doc, macro):
    sketch = sketches.rectangle(doc, 90, 60)
    Gui.Selection.addSelection(sketch)
    Gui.runCommand("BalloonWorkbench_FromSketch")
    hands.wait_until(hands.panel_is_seen)
    hands.type_into(hands.find("MeshSize"), "15 mm")
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed, 120)
    source = f'App.ActiveDocument.getObject("{sketch.Name}")'
    made = f'BalloonWorkbench.from_sketch(App.ActiveDocument, {source}, mesh_size="15 mm")'
    assert macro[-1] == f"balloon = {made}"
    count = len(doc.Objects)
    exec(macro[-1], {"BalloonWorkbench": __import__("BalloonWorkbench"), "App": App})
    assert len(doc.Objects) == count + 4, "run again, it makes a second balloon"
    first, second = measures(doc).values()
    assert second == pytest.approx(first, rel=1e-6)


def test_recorded_call_does_not_run_twice(doc, macro):
    """The window has done the work: while its call is recorded nothing is made."""
    made = create.make(doc)
    count = len(doc.Objects)
    macro_recorder.call(
        "from_picture", "App.ActiveDocument", '"no such file.png"', result=made, name="balloon"
    )
    assert len(doc.Objects) == count
    assert macro[-1] == 'balloon = BalloonWorkbench.from_picture(App.ActiveDocument, "no such file.png")'


def test_export(doc, macro, tmp_path):
    create.balloon_from_sketch(doc, sketches.rectangle(doc, 90, 60), mesh_size=15, correct=False)
    Gui.runCommand("BalloonWorkbench_ExportPattern")
    hands.wait_until(hands.panel_is_seen)
    hands.type_into(hands.find("File"), str(tmp_path / "plate.dxf"))  # Return is OK
    hands.wait_until(hands.panel_is_closed)
    written = next(tmp_path.glob("plate*"))
    content = written.read_bytes()
    written.unlink()
    exec("\n".join(macro), {"App": App})
    assert written.read_bytes() == content


def test_repair(doc, macro):
    import Part

    corners = [(0, 0), (120, 0), (120, 45), (220, 45), (220, 53), (120, 53), (120, 100), (0, 100)]
    wire = doc.addObject("Part::Feature", "Plate")
    wire.Shape = Part.makePolygon([App.Vector(x, y) for x, y in (*corners, corners[0])])
    made = create.balloon_from_sketch(doc, wire, mesh_size=14, correct=False, intake=False)
    Gui.runCommand("BalloonWorkbench_Advice")
    hands.wait_until(hands.panel_is_seen)
    findings = hands.find("Findings")
    findings.setCurrentRow(0)
    hands.wait(0.1)
    hands.click(hands.find("Repair"))
    hands.wait(0.1)
    repaired = list(made.outline.Repairs)
    assert len(repaired) == 1
    made.outline.Repairs = []
    doc.recompute()
    exec("\n".join(macro), {"App": App})
    assert list(made.outline.Repairs) == repaired
    Gui.Control.closeDialog()


def replay(lines):
    """Run a macro in the document that is open."""
    exec("\n".join(lines), {"App": App, "Gui": Gui})


@pytest.mark.slow
def test_paint(doc, macro):
    window = brush.open_window()
    brush.press(f"PaintColour{brush.RED}")
    brush.draw(window.canvas, brush.ellipse(0.5, 0.5, 0.3, 0.2))
    hands.type_into(window.form.width_field, "90 mm")
    brush.press("PaintMake")
    hands.wait_until(brush.is_closed, 60)
    hands.wait_until(hands.panel_is_seen)
    hands.leave()
    made = [line for line in macro if "from_picture" in line]
    assert len(made) == 1
    assert 'width="90 mm"' in made[0]
    expected = measures(doc)
    again = App.newDocument("Replay")
    replay(macro)
    for name, found in measures(again).items():
        assert found == pytest.approx(expected[name], rel=1e-6)


@pytest.mark.slow
def test_artwork_layout_assembly_and_map(made, rectangle_file, macro, tmp_path):
    """Four commands of one balloon; their lines do the same to a balloon that has seen none of them."""
    picture, page = tmp_path / "blue.png", tmp_path / "sheet.pdf"
    blue = hands.QtGui.QImage(40, 30, hands.QtGui.QImage.Format_RGB32)
    blue.fill(hands.QtGui.QColor(20, 60, 220))
    blue.save(str(picture))
    Gui.Selection.addSelection(made.balloon)
    for command, field, text in (
        ("Artwork", "Picture", str(picture)),
        ("Nest", "FilmWidth", "300 mm"),
        ("AssemblySheet", "AssemblyFile", str(page)),
        ("ColourMap", "", ""),
    ):
        Gui.runCommand(f"BalloonWorkbench_{command}")
        hands.wait_until(hands.panel_is_seen)
        if field:
            hands.type_into(hands.find(field), text, confirm=False)
        else:
            combo = hands.find("ColourMap")
            combo.setCurrentIndex(combo.findData(WRINKLES))
        if field == "Picture":
            hands.find(field).editingFinished.emit()
        hands.press("Ok")
        hands.wait_until(hands.panel_is_closed)
    for function in ("artwork", "nest", "assembly_sheet"):
        assert sum(f"BalloonWorkbench.{function}(" in line for line in macro) == 1
    expected, written = made_of(made.balloon.Document), page.read_bytes()
    page.unlink()
    App.closeDocument(made.balloon.Document.Name)
    again = App.openDocument(str(shutil.copy(rectangle_file, tmp_path / "again.FCStd")))
    replay(macro)
    assert made_of(again) == expected
    assert page.read_bytes() == written


def test_printed_pieces(made, macro, tmp_path, monkeypatch):
    """The line writes the same page again."""
    page = tmp_path / "pieces.pdf"
    tab = open_tab(made.pattern)
    monkeypatch.setattr(pattern_tab, "ask_where_to_write", lambda *_asked: str(page))
    buttons = hands.visible(hands.QtWidgets.QToolButton)
    hands.click(next(each for each in buttons if tab.isAncestorOf(each) and each.text() == "Print"))
    hands.wait_until(lambda: page.name in tab.line.text(), 20)
    assert sum("BalloonWorkbench.print_pieces(" in line for line in macro) == 1
    written = page.read_bytes()
    page.unlink()
    replay(macro)
    assert page.read_bytes() == written


def test_a_study(made, macro):
    """The line makes and works out the same rows again, beside the study that is there."""
    doc = made.balloon.Document
    Gui.Selection.addSelection(made.balloon)
    Gui.runCommand("BalloonWorkbench_Study")
    hands.wait_until(hands.panel_is_seen)
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert sum("BalloonWorkbench.study(" in line for line in macro) == 1
    rows = doc.Study.Rows
    replay([line for line in macro if "BalloonWorkbench" in line])
    again = doc.getObject("Study001")
    assert (again.Rows, again.Finished, again.Failed) == (rows, rows, 0)


def made_of(doc):
    """What the documents must agree in."""
    art, sheet = doc.Artwork, doc.FilmSheet
    return (
        art.Status,
        Path(art.Picture).read_bytes(),
        art.PatternWidth.Value,
        sheet.Status,
        sheet.FilmWidth.Value,
        sheet.Layouts,
        doc.Balloon.ViewObject.ColourMap,
    )

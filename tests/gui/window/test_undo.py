# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whatever a command does to a document is one step: undo takes all of it back, redo brings it again.

Painting is in test_paint_fish.py.
"""

import json
import shutil
from functools import partial
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import hands
import Part
import pytest

from BalloonWorkbench.app import artwork
from BalloonWorkbench.app.document import create, kinds
from BalloonWorkbench.core.nesting import nest as nesting
from BalloonWorkbench.gui import commands

PICTURE = Path("resources/examples/pictures/heart.png").resolve()
#: A body of 60 x 60 mm with an arm, 8 mm wide, to the right.
ARM = [(0, 0), (60, 0), (60, 26), (120, 26), (120, 34), (60, 34), (60, 60), (0, 60)]


@pytest.fixture(scope="module")
def arm_file(tmp_path_factory):
    """A finished balloon with an arm that is too thin, and a wire of four sides."""
    folder = tmp_path_factory.mktemp("arm")
    (folder / "arm.json").write_text(json.dumps({"unit": "mm", "outer": ARM}))
    document = App.newDocument("Arm")
    create.balloon_from_picture(document, folder / "arm.json", width=120, mesh_size=9, correct=False)
    corners = [App.Vector(*corner) for corner in ((0, 90), (80, 90), (80, 140), (0, 140), (0, 90))]
    document.addObject("Part::Feature", "Plate").Shape = Part.makePolygon(corners)
    document.recompute()
    document.saveAs(str(folder / "Arm.FCStd"))
    App.closeDocument(document.Name)
    return folder / "Arm.FCStd"


@pytest.fixture
def arm(arm_file, tmp_path, monkeypatch):
    """Its document, with nothing to undo; layouts come from the quick method."""
    monkeypatch.setattr(nesting, "PACKAGE", "no_such_package")
    document = App.openDocument(str(shutil.copy(arm_file, tmp_path)))
    document.clearUndos()
    hands.wait(0.1)
    return document


def held(document):
    """All that the document's objects hold, as far as it can be compared."""
    return {
        (obj.Name, name): _value(obj, name)
        for obj in document.Objects
        for name in obj.PropertiesList
        if name not in ("Proxy", "ViewObject")
    }


def _value(obj, name):
    value = getattr(obj, name)
    if obj.getTypeIdOfProperty(name) == "App::PropertyFileIncluded":
        return Path(value).read_bytes() if value else b""
    if hasattr(value, "Edges"):
        return len(value.Edges), round(value.Length, 6), round(value.Area, 6)
    if obj.getTypeIdOfProperty(name) == "Materials::PropertyMaterial":
        return value.UUID
    if hasattr(value, "CountFacets"):
        return value.CountFacets, round(value.Volume, 6)
    return str(value)


def keep(button="Ok"):
    hands.press(button)
    hands.wait_until(hands.panel_is_closed, 120)


def from_picture(_document):
    hands.type_into(hands.find("Drawing"), str(PICTURE))
    hands.type_into(hands.find("Width"), "90 mm")
    hands.type_into(hands.find("MeshSize"), "12 mm")
    keep()


def from_sketch(document):
    hands.wait_until(hands.panel_is_seen)
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(document.Plate)
    hands.wait(0.1)
    hands.type_into(hands.find("MeshSize"), "14 mm")
    keep()


def repair(_document):
    findings = hands.find("Findings")
    rows = [row for row in range(findings.count()) if "too thin" in findings.item(row).text()]
    findings.setCurrentRow(rows[0])
    hands.wait(0.1)
    hands.click(hands.find("Repair"))
    hands.wait(0.2)
    keep("Close")


def put_artwork(_document):
    hands.type_into(hands.find("Picture"), str(PICTURE), confirm=False)
    hands.find("Picture").editingFinished.emit()
    hands.wait(0.1)
    keep()


def lay_out(_document):
    hands.find("Balloons").setValue(2)
    keep()


def export(document):
    hands.type_into(hands.find("File"), str(Path(document.FileName).with_suffix(".svg")), confirm=False)
    keep()


def write_sheet(document):
    hands.type_into(hands.find("AssemblyFile"), str(Path(document.FileName).with_suffix("")), confirm=False)
    keep()


def keep_study(_document):
    keep()


def look(_document):
    hands.wait(0.2)
    hands.leave()


#: What the user does once the panel of a command is open.
CHANGES = {
    "Advice": repair,
    "FromPicture": from_picture,
    "FromSketch": from_sketch,
    "Artwork": put_artwork,
    "Nest": lay_out,
    "Study": keep_study,
}
LOOKS = {"ColourMap": look, "Animate": look, "Equipment": look, "ExportPattern": export}
LOOKS |= {"AssemblySheet": write_sheet, "Machines": look, "TestCard": look, "Compare": look}
LOOKS["ExportForWeb"] = look
#: It has a window of its own; these open documents of their own; tests/gui/many_panels undoes the others.
OTHERS = {"Paint", "EditOutline", "PatternView", "Examples", "FromProfile", "FromBody", "FromPanels"}


def run(name, work, document):
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(document.Balloon)
    Gui.runCommand(f"BalloonWorkbench_{name}")
    hands.wait_until(hands.panel_is_seen)
    work(document)


def open_panel(obj):
    obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
    hands.wait_until(hands.panel_is_seen)


def edit_balloon(document):
    open_panel(document.Balloon)
    hands.type_into(hands.find("Pressure"), "3 kPa")
    hands.type_into(hands.find("Allowance"), "4 mm")
    keep()


def edit_artwork(document):
    open_panel(artwork.of_balloon(document.Balloon))
    hands.type_into(hands.find("Bleed"), "7 mm")
    keep()


def edit_layout(document):
    open_panel(next(obj for obj in document.Objects if kinds.is_film_sheet(obj)))
    hands.find("Balloons").setValue(3)
    keep()


def differences(one, other):
    keys = one.keys() | other.keys()
    return {key: (one.get(key), other.get(key)) for key in keys if one.get(key) != other.get(key)}


def test_every_command_is_here():
    known = {name.partition("_")[2] for name in commands._COMMANDS | commands._RARE}
    assert known == CHANGES.keys() | LOOKS.keys() | OTHERS


@pytest.mark.slow
def test_all_commands_are_undone_one_by_one(arm):
    steps = [partial(run, name, work) for name, work in CHANGES.items()]
    states = [held(arm)]
    for number, step in enumerate([*steps, edit_balloon, edit_artwork, edit_layout], 1):
        step(arm)
        assert arm.UndoCount == number, arm.UndoNames
        states.append(held(arm))
        assert states[-1] != states[-2], arm.UndoNames[0]
    names = list(arm.UndoNames)
    for name, state in zip(names, reversed(states[:-1]), strict=True):
        arm.undo()
        hands.wait(0.05)
        assert differences(held(arm), state) == {}, name
    assert arm.UndoCount == 0
    for name, state in zip(reversed(names), states[1:], strict=True):
        arm.redo()
        hands.wait(0.05)
        assert differences(held(arm), state) == {}, name
    assert list(arm.UndoNames) == names


@pytest.mark.slow
def test_commands_that_only_look_leave_nothing_to_undo(arm):
    before = held(arm)
    for name, work in LOOKS.items():
        run(name, work, arm)
        assert arm.UndoCount == 0, name
        assert differences(held(arm), before) == {}, name

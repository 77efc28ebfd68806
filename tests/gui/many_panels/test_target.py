# SPDX-License-Identifier: LGPL-2.1-or-later
"""New balloon from body: a selected solid, a mesh, a file; one undo step, edited, cancelled, saved."""

import FreeCAD as App
import FreeCADGui as Gui
import hands
import Mesh
import pytest

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document.parts import panels_of
from BalloonWorkbench.gui.window import file_dialogs, macro_recorder

pytestmark = pytest.mark.usefixtures("without_figures")


@pytest.fixture
def lines(monkeypatch):
    """What goes into the macro; it is run as in FreeCAD."""
    told, run = [], Gui.doCommand

    def listen(line):
        told.append(line)
        run(line)

    monkeypatch.setattr(macro_recorder.Gui, "doCommand", listen)
    return told


@pytest.fixture
def box(doc):
    """A cube of 100 mm."""
    made = doc.addObject("Part::Box", "Box")
    made.Length = made.Width = made.Height = 100
    doc.recompute()
    return made


def open_panel(*selected):
    """The panel on what is selected, quick to inflate."""
    for obj in selected:
        Gui.Selection.addSelection(obj)
    with hands.work_held():  # nothing is inflated that is not quick
        Gui.runCommand("BalloonWorkbench_FromBody")
        hands.wait_until(hands.panel_is_seen)
        hands.choose(hands.find("Mode"), "Inflate as drawn")
        hands.type_into(hands.find("MeshSize"), "20 mm")
        hands.find("Steps").setCurrentIndex(0)


def solved(doc):
    return lambda: status.is_ready(doc.Pattern) and hands.find("Apply").isVisible()


def finish(doc):
    hands.wait_until(solved(doc), 120)
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed, 120)


@pytest.mark.slow
def test_selected_box_becomes_a_balloon(box, lines, tmp_path):
    doc = box.Document
    open_panel(box)
    assert hands.find("Source").text() == "Box"
    assert not hands.find("BodyFile").isVisible(), "the solid is followed"
    hands.wait_until(solved(doc), 120)
    assert "6 panels" in hands.find("BodyNotes").text()
    assert "1200 mm of seams" in hands.find("BodyNotes").text(), "twelve edges of 100 mm"
    hands.screenshot("target-box")
    finish(doc)
    target, balloon = doc.Target, doc.Balloon
    assert [obj.Status for obj in (target, balloon, doc.Pattern)] == [status.READY] * 3
    assert balloon.PanelCount == target.PanelCount == len(panels_of(doc.Pattern)) == 6
    # inextensible film: 1.26 times the volume of the cube
    assert balloon.Volume.getValueAs("l").Value == pytest.approx(1.26, rel=0.05)
    assert balloon.getParentGroup().Label == "Box balloon"
    (line,) = [line for line in lines if "from_body" in line]
    assert 'from_body(App.ActiveDocument, App.ActiveDocument.getObject("Box"), ' in line
    assert 'mesh_size="20 mm"' in line
    assert len({panel.ViewObject.ShapeColor for panel in panels_of(doc.Pattern)}) == 6

    assert doc.UndoNames[0] == "New balloon from body"
    doc.undo()
    hands.wait(0.1)
    assert [obj.Name for obj in doc.Objects] == ["Box"]
    doc.redo()
    hands.wait(0.1)
    assert status.is_ready(doc.Pattern)

    path = str(tmp_path / "box.FCStd")
    doc.saveAs(path)
    App.closeDocument(doc.Name)
    again = App.openDocument(path)
    hands.wait(0.1)
    again.Target.ViewObject.Proxy.doubleClicked(again.Target.ViewObject)
    hands.wait_until(hands.panel_is_seen)
    assert hands.find("Source").text() == "Box"
    volume = again.Balloon.Volume.Value
    again.Box.Height = 200
    again.recompute([again.Box])
    hands.click(hands.find("Apply"))
    hands.wait_until(lambda: again.Balloon.Volume.Value > 1.5 * volume and solved(again)(), 120)
    # inextensible film: 2.532 times a cube
    assert again.Balloon.Volume.getValueAs("l").Value == pytest.approx(2.532, rel=0.05)
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed, 120)


def test_cancel_leaves_nothing(box, lines):
    doc = box.Document
    open_panel(box)
    hands.press("Cancel")
    hands.wait_until(hands.panel_is_closed)
    assert [obj.Name for obj in doc.Objects] == ["Box"]
    assert box.ViewObject.Visibility
    assert not lines


@pytest.mark.slow
def test_a_file_is_chosen(doc, lines, tmp_path, stand_in):
    path = tmp_path / "block.stl"
    Mesh.createBox(100.0, 80.0, 60.0).write(str(path))
    stand_in.setattr(file_dialogs, "ask_for_body", lambda _parent: str(path))
    open_panel()
    assert "Select a solid or a mesh" in hands.find("Source").text()
    hands.type_into(hands.find("BodyFile"), str(tmp_path / "none.stl"))
    assert "There is no file" in hands.message()
    hands.type_into(hands.find("Panels"), "6")
    hands.find("BodyFile").parent()._browse()
    assert doc.Target.PanelCount == 6
    finish(doc)
    assert doc.Target.Kind == "stl"
    assert doc.Balloon.PanelCount == 6
    assert doc.Balloon.getParentGroup().Label == "block"
    (line,) = [line for line in lines if "from_body" in line]
    assert f'from_body(App.ActiveDocument, "{path}", ' in line
    assert "panels=6" in line


def test_a_mesh_is_picked_while_the_panel_is_open(doc):
    ball = doc.addObject("Mesh::Feature", "Ball")
    ball.Mesh = Mesh.createSphere(80.0, 24)
    open_panel()
    doc.Balloon.Live = False
    hands.type_into(hands.find("Panels"), "6")
    Gui.Selection.addSelection(ball)
    hands.wait(0.1)
    assert hands.find("Source").text() == "Ball"
    assert (doc.Target.Kind, doc.Target.PanelCount) == ("mesh", 6)
    assert doc.Target.Status == status.READY
    hands.screenshot("target-mesh")


def test_what_is_no_body_is_told(doc):
    doc.addObject("Part::Plane", "Plate")
    doc.recompute()
    open_panel(doc.Plate)
    hands.wait_until(lambda: "not closed" in hands.message())
    hands.press("Ok")  # nothing to keep: the panel stays
    hands.wait(0.1)
    assert hands.panel_is_open()

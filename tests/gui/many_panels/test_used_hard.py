# SPDX-License-Identifier: LGPL-2.1-or-later
"""Balloons of many panels in the window, used hard: undone, saved, left and recomputed amid the work."""

import math
from contextlib import ExitStack

import FreeCAD as App
import FreeCADGui as Gui
import hands
import pytest
import sketches
import view_port

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document.parts import panels_of

COARSE = 30  # mm


def open_bag(doc, body="Tetrahedron"):
    """The panel on a new bag of a ready body, which is solved."""
    Gui.runCommand("BalloonWorkbench_FromPanels")
    hands.wait_until(hands.panel_is_seen)
    doc.Balloon.MeshSize = COARSE
    hands.choose(hands.find("Ready"), body)
    return doc.Balloon


@pytest.fixture
def amid(doc):
    """The same, whose solve has begun; it goes on when this is called."""
    with ExitStack() as held:
        held.enter_context(hands.work_held())
        open_bag(doc)
        hands.wait_until(hands.find("Stop").isVisible)
        yield held.close


def settled(doc):
    return doc.getObject("Pattern") is not None and status.is_ready(doc.Pattern)


@pytest.fixture
def tetra(doc):
    """A finished bag."""
    open_bag(doc)
    hands.wait_until(lambda: settled(doc), 120)
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    return doc


def test_panels_in_the_tree_and_what_undo_leaves(tetra):
    panels = panels_of(tetra.Pattern)
    assert len(panels) == 4
    assert len({panel.ViewObject.ShapeColor for panel in panels}) == 4
    assert all(panel.ViewObject.Visibility for panel in panels)
    assert not tetra.Pattern.ViewObject.Visibility
    # a double-click on one opens the panel of its balloon
    panels[2].ViewObject.Proxy.doubleClicked(panels[2].ViewObject)
    hands.wait_until(hands.panel_is_seen)
    hands.leave()
    assert [obj.Name for obj in panels_of(tetra.Pattern)] == [obj.Name for obj in panels]
    tetra.undo()
    hands.wait(0.1)
    assert tetra.Objects == []
    tetra.redo()
    hands.wait(0.1)
    assert len(panels_of(tetra.Pattern)) == 4
    tetra.recompute()
    assert len(panels_of(tetra.Pattern)) == 4
    assert status.is_ready(tetra.Pattern)


def test_one_panel_is_exported(tetra, tmp_path):
    panel = panels_of(tetra.Pattern)[1]
    Gui.Selection.addSelection(panel)
    Gui.runCommand("BalloonWorkbench_ExportPattern")
    hands.wait_until(hands.panel_is_seen)
    assert panel.Label in hands.find("Pattern").currentText()
    assert hands.find("Pattern").count() == 2, "the pattern, and the one that is selected"
    hands.type_into(hands.find("File"), str(tmp_path / "one.dxf"), confirm=False)
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert (tmp_path / "one.dxf").stat().st_size > 0


def test_undo_amid_the_task(doc, amid):
    """The objects of the open panel go: it closes, and nothing of it is left."""
    doc.abortTransaction()
    amid()
    hands.wait(0.5)
    if hands.panel_is_open():
        hands.leave()
    assert doc.Objects == []


def test_saved_while_it_is_solved(doc, amid, tmp_path):
    balloon = doc.Balloon
    path = tmp_path / "amid.FCStd"
    doc.saveAs(str(path))
    amid()
    hands.wait_until(lambda: settled(doc), 120)
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert balloon.Status == status.READY
    opened = App.openDocument(str(path))
    hands.wait(0.2)
    opened.recompute()
    hands.wait(0.2)
    assert opened.getObject("Balloon").Status == status.READY


def test_recomputed_while_it_is_solved(doc, amid):
    balloon = doc.Balloon
    doc.recompute()
    amid()
    hands.wait_until(lambda: settled(doc), 120)
    doc.recompute()
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert balloon.Status == status.READY
    assert len(panels_of(doc.Pattern)) == 4


def test_another_document_is_chosen_amid_the_task(doc, amid):
    """What the panel does stays in its own."""
    other = App.newDocument("Other")
    amid()
    hands.wait_until(lambda: settled(doc), 120)
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert len(panels_of(doc.Pattern)) == 4
    assert other.Objects == []


def test_the_document_is_closed_amid_the_task(doc, amid):
    App.closeDocument(doc.Name)
    hands.wait(0.5)
    if hands.panel_is_open():
        hands.leave()
    assert hands.panel_is_closed()


def test_a_seam_is_chosen_by_either_edge_in_the_view(doc):
    """A click of the mouse on the flat panels in the 3D view, on one edge and on its partner."""
    open_bag(doc, "Box")
    hands.wait_until(lambda: settled(doc), 120)
    flat, rows = hands.find("FlatPanels"), hands.find("Seams")
    Gui.activeDocument().activeView().viewTop()
    Gui.SendMsgToActiveView("ViewFit")
    hands.wait(0.5)
    port = view_port.view_area().viewport()
    for edge in flat.shown.of_seam(4):
        rows.setCurrentRow(-1)
        (x, y), (dx, dy) = 0.5 * (edge.line[0] + edge.line[1]), edge.line[1] - edge.line[0]
        away = 2.0 / math.hypot(dx, dy)  # some 2 mm beside the edge, on the film or not
        at = doc.Bag.Placement.multVec(App.Vector(x + away * dy, y - away * dx, 0))
        view_port.click(port, view_port.pixel(port, at))
        hands.wait_until(lambda: rows.currentRow() == 4, 5)


def test_sketches_are_shown_by_the_bag_and_come_back(doc):
    drawn = [sketches.rectangle(doc, 80, 80) for _ in range(2)]
    doc.clearUndos()
    for sketch in drawn:
        Gui.Selection.addSelection(sketch)
    Gui.runCommand("BalloonWorkbench_FromPanels")
    hands.wait_until(hands.panel_is_seen)
    assert not any(sketch.ViewObject.Visibility for sketch in drawn)
    assert doc.Bag.getParentGroup().Label == "Rectangle bag"
    hands.press("Cancel")
    hands.wait_until(hands.panel_is_closed)
    assert all(sketch.ViewObject.Visibility for sketch in drawn)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The advice panel: findings in a list, marks in the 3D view, repairs that can be undone."""

import json

import FreeCADGui as Gui
import hands
import pytest

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import create

#: A body of 60 x 60 mm with an arm, 8 mm wide, to the right.
OUTLINE = [(0, 0), (60, 0), (60, 26), (120, 26), (120, 34), (60, 34), (60, 60), (0, 60)]


@pytest.fixture
def parts(doc, tmp_path):
    path = tmp_path / "arm.json"
    path.write_text(json.dumps({"unit": "mm", "outer": OUTLINE, "holes": []}))
    made = create.balloon_from_picture(doc, path, width=120, mesh_size=6, correct=False)
    Gui.activeDocument().activeView().viewTop()
    Gui.SendMsgToActiveView("ViewFit")
    return made


@pytest.fixture
def panel(parts):
    Gui.runCommand("BalloonWorkbench_Advice")
    hands.wait_until(hands.panel_is_seen)
    yield parts
    if hands.panel_is_open():
        hands.press("Close")
        hands.wait_until(hands.panel_is_closed)


def texts():
    findings = hands.find("Findings")
    return [findings.item(row).text() for row in range(findings.count())]


def choose(word):
    findings = hands.find("Findings")
    findings.setCurrentRow(next(row for row, text in enumerate(texts()) if word in text))
    hands.wait(0.1)


def scene_nodes():
    return Gui.activeDocument().activeView().getSceneGraph().getNumChildren()


def test_finding_is_marked_while_it_is_chosen(panel):
    nodes = scene_nodes()
    choose("arm is too thin")
    assert scene_nodes() == nodes + 1
    hands.screenshot("advice")
    hands.find("Findings").setCurrentRow(len(texts()) - 1)
    assert scene_nodes() == nodes + 1
    hands.find("Findings").setCurrentRow(-1)
    assert scene_nodes() == nodes
    choose("arm is too thin")
    hands.press("Close")
    hands.wait_until(hands.panel_is_closed)
    assert scene_nodes() == nodes


def test_repair_is_one_undo_step(panel):
    doc = panel.outline.Document
    assert "Measured" in hands.find("AdviceSource").text()
    assert f"{100 * panel.balloon.Puffiness:.0f} %" in hands.find("AdviceSource").text()
    volume = panel.balloon.Volume.Value
    choose("arm is too thin")
    assert hands.find("Repair").text().startswith("Widen to")
    hands.click(hands.find("Repair"))
    hands.wait(0.2)
    assert not any("arm is too thin" in text for text in texts())
    assert [obj.Status for obj in panel] == [status.READY] * 3
    assert panel.balloon.Volume.Value > volume
    assert doc.UndoNames[0].startswith("Widen to")
    doc.undo()
    hands.wait(0.2)
    assert panel.outline.Repairs == []
    assert panel.balloon.Volume.Value == volume
    assert any("arm is too thin" in text for text in texts())
    assert hands.panel_is_open()


def test_map_colours_the_shape(panel):
    nodes = scene_nodes()
    hands.click(hands.find("ThicknessMap"), x=8)
    assert scene_nodes() == nodes + 1
    assert "red" in hands.find("Legend").text()
    image = hands.screenshot("advice-map")
    row = [hands.QtGui.QColor(image.pixel(x, y)) for y in range(200, 900, 8) for x in range(500, 1300, 8)]
    assert len([colour for colour in row if colour.blue() > 180 and colour.red() < 60]) > 20
    hands.click(hands.find("ThicknessMap"), x=8)
    assert scene_nodes() == nodes


def test_finding_without_a_repair_offers_none(panel):
    findings = hands.find("Findings")
    findings.setCurrentRow(-1)
    hands.wait(0.05)
    assert not hands.find("Repair").isEnabled()


def test_outline_of_no_use_is_told(parts):
    parts.outline.Width = 0
    parts.outline.Height = 1e9
    parts.outline.recompute()
    Gui.runCommand("BalloonWorkbench_Advice")
    hands.wait_until(hands.panel_is_seen)
    assert texts() == []
    assert hands.find("AdviceMessage").text()
    hands.press("Close")
    hands.wait_until(hands.panel_is_closed)


def test_deleting_the_balloon_closes_the_panel(panel):
    panel.outline.Document.removeObject(panel.balloon.Name)
    hands.wait_until(hands.panel_is_closed, 5)

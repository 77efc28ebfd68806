# SPDX-License-Identifier: LGPL-2.1-or-later
"""The advice panel on a balloon of many panels: findings in its list, their marks on the balloon."""

import FreeCADGui as Gui
import hands

import BalloonWorkbench


def test_findings_of_many_panels_are_listed_and_marked(doc):
    BalloonWorkbench.from_panels(doc, "Box", mesh_size=60, pressure="40 kPa")
    Gui.activeDocument().activeView().viewTop()
    Gui.runCommand("BalloonWorkbench_Advice")
    hands.wait_until(hands.panel_is_seen)
    findings = hands.find("Findings")
    texts = [findings.item(row).text() for row in range(findings.count())]
    assert any("stronger film" in text for text in texts)
    nodes = Gui.activeDocument().activeView().getSceneGraph().getNumChildren()
    findings.setCurrentRow(0)
    hands.wait(0.1)
    assert Gui.activeDocument().activeView().getSceneGraph().getNumChildren() == nodes + 1
    assert not hands.find("Repair").isVisible()
    hands.press("Close")
    hands.wait_until(hands.panel_is_closed)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""New body of gores: from a selected sketch to the balloon, one undo step, edited and cancelled."""

import math
from itertools import pairwise

import FreeCADGui as Gui
import hands
import pytest
import sketches

from BalloonWorkbench.app.border import status


@pytest.fixture
def half(doc):
    """Half the outline of a ball of 200 mm, as a polyline of twelve lines."""
    turns = [math.pi * (k / 12 - 0.5) for k in range(13)]
    points = [(100 * math.cos(turn), 100 * math.sin(turn)) for turn in turns]
    points[0], points[-1] = (0.0, -100.0), (0.0, 100.0)
    lines = [sketches.line(*pair) for pair in pairwise(points)]
    return sketches.sketch(doc, *lines, name="Half")


def solved(doc):
    return lambda: doc.getObject("Balloon").SolvedFor != "" and hands.find("Apply").isVisible()


@pytest.mark.slow
def test_selected_sketch_becomes_a_ball(half):
    doc = half.Document
    Gui.Selection.addSelection(half)
    with hands.work_held():  # nothing is inflated that is not coarse
        Gui.runCommand("BalloonWorkbench_FromProfile")
        hands.wait_until(hands.panel_is_seen)
        hands.type_into(hands.find("MeshSize"), "30 mm")
    hands.wait_until(solved(doc), 120)
    body, balloon = doc.GoredBody, doc.Balloon
    assert body.Status == balloon.Status == status.READY
    assert balloon.PanelCount == body.Gores == 6
    assert balloon.InflatedHeight.Value == pytest.approx(200, rel=0.1)
    assert doc.Pattern.Roles
    hands.screenshot("gored-body")
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert doc.UndoNames[0] == "New body of gores"
    assert balloon.getParentGroup().Label == "Half body"
    doc.undo()
    assert [obj.Name for obj in doc.Objects] == ["Half"]


class _Painted(hands.QtCore.QObject):
    """How high a page was, and where a field was in it, each time that it was painted."""

    def __init__(self, field):
        super().__init__()
        self.field, self.seen = field, set()

    def eventFilter(self, page, event):  # noqa: N802
        if event.type() == hands.QtCore.QEvent.Paint:
            self.seen.add((page.height(), self.field.mapTo(page, hands.QtCore.QPoint(0, 0)).y()))
        return False


def test_fields_stay_where_they_are_while_it_works(half):
    """So that a second click on an arrow finds the same field."""
    doc = half.Document
    Gui.Selection.addSelection(half)
    with hands.work_held():
        Gui.runCommand("BalloonWorkbench_FromProfile")
        hands.wait_until(hands.panel_is_seen)
        hands.type_into(hands.find("MeshSize"), "30 mm")
    hands.find("Steps").setCurrentIndex(0)
    hands.wait_until(solved(doc), 120)
    hands.wait(0.5)
    field, page = hands.find("Gores"), hands.find("Steps")
    painted = _Painted(field)
    page.installEventFilter(painted)
    field.stepBy(1)
    hands.wait_until(lambda: doc.Balloon.PanelCount == 7 and hands.find("Apply").isVisible(), 120)
    hands.wait(0.5)
    assert len(painted.seen) == 1, painted.seen


def test_the_law_is_told_before_anything_is_inflated(doc):
    Gui.runCommand("BalloonWorkbench_FromProfile")
    hands.wait_until(hands.panel_is_seen)
    doc.Balloon.Live = False
    hands.choose(hands.find("ProfileFrom"), "Natural shape")
    hands.type_into(hands.find("Gores"), "0")
    needed = doc.GoredBody.GoresNeeded
    assert needed > 3
    assert hands.find("GoresNeeded").text().startswith(f"{needed} gores")
    assert not doc.Balloon.SolvedFor
    hands.press("Cancel")
    hands.wait_until(hands.panel_is_closed)
    assert not doc.Objects

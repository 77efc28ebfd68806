# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scene 4: gores of a profile, panels of a solid whose seams are changed, a digit with a side band."""

from dataclasses import replace
from pathlib import Path

import Draft
import FreeCAD as App
import FreeCADGui as Gui
import hands
import numpy as np
import pytest
import sketches
import steps
from user import show

from BalloonWorkbench.app import target as target_object
from BalloonWorkbench.app.border import status
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.seam_edits.apply_edits import with_edit
from BalloonWorkbench.core.target_design import fit_target
from BalloonWorkbench.core.units import to_mm
from BalloonWorkbench.gui.bodies.picked_edits import merge_edit
from BalloonWorkbench.gui.pattern_view import tab as tabs

QtWidgets = hands.QtWidgets
FONT = Path(App.getResourceDir(), "Mod/TechDraw/Resources/fonts/osifont-lgpl3fe.ttf")


def test_scene_4_gores(user, story):
    doc = App.newDocument("Ball")
    half = sketches.sketch(doc, *_half_of_a_ball(), name="Half")
    hands.wait(0.3)
    steps.command(user, "FromProfile", half)
    user.button("Step3")
    user.replace(hands.find("MeshSize"), "25 mm")
    user.button("Step0")
    steps.inflated()
    story.step("six-gores")
    needed, length = hands.find("GoresNeeded").text(), doc.Pattern.SeamLength.Value
    story.expect("%" in needed, f"nothing is said of how near so many gores come: {needed}")
    _two_up(user, hands.find("Gores"))
    steps.inflated()
    story.step("eight-gores")
    story.expect(doc.Balloon.PanelCount == 8, "there are no 8 gores")
    story.expect(doc.Pattern.SeamLength.Value > 1.2 * length, "more gores have no longer seams")
    steps.leave(user)
    story.step("gores-kept")
    story.expect(len(doc.UndoNames) == 1, "the body of gores is more than one step to undo")


def _two_up(user, field):
    """Two clicks on the upper arrow of a number."""
    show(field)
    option = QtWidgets.QStyleOptionSpinBox()
    option.initFrom(field)
    arrow = field.style().subControlRect(
        QtWidgets.QStyle.CC_SpinBox, option, QtWidgets.QStyle.SC_SpinBoxUp, field
    )
    user.click(field.mapToGlobal(arrow.center()), times=2)


def _half_of_a_ball():
    return [sketches.arc((0, 0), 100, -90, 90)]


@pytest.fixture
def quick(monkeypatch):
    """A coarse balloon that is hardly corrected: what is looked at are its seams."""
    monkeypatch.setattr(fit_target, "VERTICES", 600)
    monkeypatch.setattr(fit_target, "STEPS", 1)


def test_scene_4_solid(user, story, quick):
    doc = App.newDocument("Bottle")
    bottle = _bottle(doc)
    user.select(bottle)
    story.step("bottle")
    steps.command(user, "FromBody")
    steps.inflated(240)
    hands.wait_until(lambda: "hide" in steps.said(), 240)  # a thread counts
    story.step("panels")
    _seams(user, story, doc)
    steps.leave(user)
    story.step("solid-kept")
    _partner(user, story, doc)
    _fillet(user, story, doc, bottle)


def _bottle(doc):
    base = doc.addObject("Part::Cylinder", "Base")
    base.Radius, base.Height = 50, 140
    doc.recompute()
    bottle = doc.addObject("Part::Fillet", "Bottle")
    rims = [n for n, edge in enumerate(base.Shape.Edges, 1) if edge.Curve.TypeId == "Part::GeomCircle"]
    bottle.Base, bottle.Edges = base, [(number, 15.0, 15.0) for number in rims]
    base.ViewObject.Visibility = False
    doc.recompute()
    doc.clearUndos()
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    hands.wait(0.5)
    return bottle


def _seams(user, story, doc):
    """Two panels become one with a click on their seam; another seam is dragged; the change is taken back."""
    target, count = doc.Target, doc.Target.PanelCount
    rows = hands.find("BodySeams")
    story.expect(rows.count() > 0 and not rows.item(0).icon().isNull(), "seams have no colours in the list")
    user.button("SeamMerge")
    steps.to_view(user)
    steps.look_at_all(user, "corner")
    can, cannot = _seams_in_front(target)
    if cannot:
        user.click(steps.in_view(cannot[0]))
        hands.wait_until(lambda: "\n" in hands.find("BodySeamHint").text(), 20)
        story.step("cannot-be-merged")
        story.expect(target.PanelCount == count, "panels were merged that cannot be laid flat")
    user.go(steps.in_view(can[0]))
    hands.wait(0.3)
    story.step("seam-under-the-mouse")
    user.click(steps.in_view(can[0]))
    hands.wait_until(lambda: target.PanelCount < count, 20)
    steps.inflated(240)
    story.step("merged")
    user.button("TakeBackSeam")
    hands.wait_until(lambda: count == target.PanelCount, 60)
    steps.inflated(240)
    user.button("SeamMove")
    place = can[0]
    there = _beside(target, place)
    before = list(target.SeamEdits)
    ends = [steps.in_view(place), steps.in_view(there)]
    user.drag([ends[0] + (ends[1] - ends[0]) * k / 8 for k in range(9)])
    hands.wait_until(lambda: list(target.SeamEdits) != before, 20)
    steps.inflated(240)
    story.step("moved")
    user.key("Escape")
    story.expect(not hands.find("SeamMove").isChecked(), "Esc does not lay the tool down")


def _seams_in_front(target):
    """Middles (3,) mm of the seams before us, the nearest first: those that can be merged, and the others."""
    made = target_object.division(target)
    points, view = to_mm(made.target.points), _ahead()
    can, cannot = [], []
    for number, seam in enumerate(made.seams):
        at = points[seam.vertices[len(seam.vertices) // 2]]
        try:
            with_edit(made, replace(merge_edit(made, number), mirrored=True), alone=target.Panels == 1)
        except BalloonError:
            cannot.append((float((at - points.mean(axis=0)) @ view), *at))
        else:
            can.append((float((at - points.mean(axis=0)) @ view), *at))
    return [[_global(target, at[1:]) for at in sorted(each) if at[0] < 0.0] for each in (can, cannot)]


def _beside(target, place):
    """A place of the body a sixth of its size away from one on it, towards the eye."""
    points = to_mm(target_object.division(target).target.points)
    here = np.array(target.getGlobalPlacement().inverse().multVec(App.Vector(*place)))
    far = np.abs(np.linalg.norm(points - here, axis=1) - np.ptp(points, axis=0).min() / 6)
    return _global(target, points[np.argmin(far + 0.2 * (points - here) @ _ahead())])


def _ahead():
    return np.array(Gui.activeDocument().activeView().getViewDirection())


def _global(target, place):
    return tuple(target.getGlobalPlacement().multVec(App.Vector(*place)))


def _partner(user, story, doc):
    """An edge that is picked in the flat view lights up with its partner."""
    user.select(doc.Balloon)
    user.command("BalloonWorkbench_PatternView")
    hands.wait_until(lambda: bool(tabs._tabs) and tabs._tabs[0].isVisible(), 20)
    hands.wait(0.5)
    tab = tabs._tabs[0]
    story.step("flat")
    edge = tab.view.pieces.edges[0]
    at = hands.QtCore.QPointF(tab.view.place_of(0.5 * (edge.line[0] + edge.line[-1]))).toPoint()
    user.click(tab.view.viewport().mapToGlobal(at))
    hands.wait_until(lambda: tab.line.text().startswith("Seam "), 10)
    story.step("both-edges")
    Gui.getMainWindow().findChild(QtWidgets.QMdiArea).closeActiveSubWindow()
    hands.wait(0.3)


def _fillet(user, story, doc, bottle):
    volume = doc.Balloon.Volume.Value
    bottle.Edges = [(number, 30.0, 30.0) for number, _, _ in bottle.Edges]
    doc.recompute()
    hands.wait_until(lambda: doc.Balloon.Volume.Value < 0.99 * volume, 240)
    story.expect(
        [obj.Status for obj in (doc.Target, doc.Balloon, doc.Pattern)] == [status.READY] * 3,
        "not all follows the fillet",
    )
    story.step("fillet")


def test_scene_4_digit(user, story):
    doc = App.newDocument("Seven")
    seven = Draft.make_shapestring("7", str(FONT), 600.0)
    doc.recompute()
    Gui.SendMsgToActiveView("ViewFit")
    hands.wait(0.3)
    user.select(seven)
    story.step("digit")
    with hands.work_held():  # what it is to be is said before it is inflated
        steps.command(user, "FromSketch")
        user.button("Step3")
        user.replace(hands.find("MeshSize"), "30 mm")
        user.button("Step1")
    steps.inflated()
    story.step("two-panels")
    user.button("SideBand")
    story.step("band-rows")
    user.replace(hands.find("Band"), "60 mm")
    hands.wait_until(lambda: doc.Balloon.PanelCount >= 3, 120)
    steps.inflated(120)
    story.step("side-band")
    thickness = doc.Balloon.InflatedThickness.Value
    story.expect(thickness > 55, f"with a band of 60 mm it is {thickness:.0f} mm thick")
    steps.leave(user)
    steps.to_view(user)
    steps.look_at_all(user, "corner")
    story.step("digit-kept")
    pattern = doc.Pattern
    story.expect(len(pattern.Order) > 1, "nothing says which seam comes first")
    steps.command(user, "AssemblySheet", doc.Balloon)
    hands.wait_until(lambda: "float?" in steps.said(), 60)
    story.step("assembly")
    steps.leave(user, "Cancel")

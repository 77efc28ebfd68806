# SPDX-License-Identifier: LGPL-2.1-or-later
"""A point of the sketch is dragged with the mouse, the sketcher is closed: everything follows."""

import FreeCAD as App
import FreeCADGui as Gui
import hands
import pytest
import sketches
from view_port import move, pixel, view_area

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import create

QtCore, QtGui, QtWidgets = hands.QtCore, hands.QtGui, hands.QtWidgets


@pytest.fixture
def loose(doc):
    """A balloon on a triangle whose corners hang together and can be dragged."""
    corners = (-60, -30), (60, -30), (20, 50)
    lines = [sketches.line(a, b) for a, b in zip(corners, (*corners[1:], corners[0]))]
    drawn = sketches.sketch(doc, *lines, name="Triangle")
    import Sketcher

    for here in range(3):
        drawn.addConstraint(Sketcher.Constraint("Coincident", here, 2, (here + 1) % 3, 1))
    doc.recompute()
    parts = create.balloon_from_sketch(doc, drawn, mesh_size=14, correct=False)
    doc.clearUndos()
    return parts


def drag_the_tip(parts, rise):
    """Open the sketch, pull its upper corner up by so many mm and close the sketcher."""
    drawn = parts.outline.Source[0]
    for obj in parts:
        obj.ViewObject.Visibility = False
    Gui.activeDocument().setEdit(drawn.Name)
    Gui.activeDocument().activeView().viewTop()
    hands.wait(0.5)
    Gui.SendMsgToActiveView("ViewFit")
    hands.wait(0.3)
    area = view_area()  # as long as it is held, so is its view port
    port = area.viewport()
    start, end = (pixel(port, App.Vector(20, height, 0)) for height in (50, 50 + rise))
    for away in (12, 6, 2, 0):
        move(port, (start[0] + away, start[1]))
    hands.drag(port, start, end, steps=10)
    hands.wait(0.2)
    hands.screenshot("sketch-dragged")
    hands.press("Close")
    hands.wait_until(hands.panel_is_closed)
    hands.wait(0.2)


def test_everything_follows_a_dragged_point(loose):
    pattern_height, volume = loose.pattern.PatternHeight.Value, loose.balloon.Volume.Value
    drag_the_tip(loose, 20)
    tip = max(edge.BoundBox.YMax for edge in loose.outline.Source[0].Shape.Edges)
    assert tip == pytest.approx(70, abs=3)
    assert loose.outline.SizeY.Value == pytest.approx(tip + 30, abs=0.1)
    assert loose.pattern.PatternHeight.Value > pattern_height + 15
    assert loose.balloon.Volume.Value > 1.1 * volume
    assert [obj.Status for obj in loose] == [status.READY] * 3


def test_manual_balloon_only_says_that_it_is_stale(loose):
    loose.balloon.Live = False
    volume = loose.balloon.Volume.Value
    drag_the_tip(loose, 20)
    assert loose.outline.SizeY.Value > 95
    assert loose.balloon.Volume.Value == volume
    assert loose.balloon.Status.startswith(status.STALE + "The outline changed")
    assert loose.balloon.ViewObject.Proxy.icon_name() == "balloon_warning"

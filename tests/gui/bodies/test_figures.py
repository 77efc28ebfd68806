# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the window tells of a body's balloon: figures, distance as colours, few or many panels."""

import FreeCAD as App
import FreeCADGui as Gui
import hands
import numpy as np
import pytest
from pivy import coin

import BalloonWorkbench
from BalloonWorkbench.app.border import status
from BalloonWorkbench.gui.bags.seam_colours import seam_colour
from BalloonWorkbench.gui.panels.bodies import panel_curve_box

QtWidgets = hands.QtWidgets


@pytest.fixture
def ball(doc):
    """A balloon of 8 panels as drawn, of a sphere of 100 mm."""
    made = doc.addObject("Part::Sphere", "Ball")
    made.Radius = 50
    doc.recompute()
    parts = BalloonWorkbench.from_body(doc, made, panels=8, mesh_size=20, mode="Inflate as drawn")
    assert parts.balloon.Status == status.READY
    return parts


def rows():
    """Names and values of the measures that the panel shows."""
    texts = [label.text() for label in hands.visible(QtWidgets.QLabel)]
    return " | ".join(texts)


def test_figures_of_a_ball(ball):
    ball.balloon.ViewObject.Proxy.doubleClicked(ball.balloon.ViewObject)
    hands.wait_until(hands.panel_is_seen)
    hands.wait_until(lambda: "hide" in rows(), 120)  # a thread counts
    told = rows()
    mean, diagonal = ball.balloon.ResidualMean.Value, 100.0 * 3.0**0.5
    assert f"{100.0 * mean / diagonal:.2g} %"[:3] in told
    assert "8 panels" in told and "95 % below" in told
    assert " h at " in told and "strain" in told
    hands.screenshot("body-figures")
    hands.leave()


def test_distance_from_the_body_as_colours(ball):
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(ball.balloon)
    Gui.runCommand("BalloonWorkbench_ColourMap")
    hands.wait_until(hands.panel_is_seen)
    choice = hands.find("ColourMap")
    offered = [choice.itemData(k) for k in range(choice.count())]
    assert "Distance" in offered
    Gui.SendMsgToActiveView("ViewFit")
    for kind in ("Distance", "Strain", "Wrinkles"):
        choice.setCurrentIndex(offered.index(kind))
        hands.wait(0.3)
        search = coin.SoSearchAction()
        search.setType(coin.SoTexture2.getClassTypeId())
        search.apply(ball.balloon.ViewObject.RootNode)
        assert search.getPath() is not None, kind
        hands.screenshot(f"body-{kind}")
    hands.leave()


def test_seams_have_the_colours_and_numbers_of_the_pattern(ball):
    view, shape = ball.outline.ViewObject, ball.outline.Shape
    seams = len(shape.Wires)
    assert seams == ball.balloon.SeamCount
    expected = [seam_colour(number) for number, wire in enumerate(shape.Wires) for _ in wire.Edges]
    assert np.allclose([colour[:3] for colour in view.LineColorArray], expected, atol=0.01)
    search = coin.SoSearchAction()
    search.setType(coin.SoText2.getClassTypeId())
    search.setInterest(coin.SoSearchAction.ALL)
    search.apply(view.RootNode)
    texts = {path.getTail().string.getValues()[0] for path in search.getPaths()}
    assert {str(number + 1) for number in range(seams)} <= texts


@pytest.mark.slow
def test_curve_slider_and_accuracy(ball, stand_in):
    stand_in.setattr(panel_curve_box, "COUNTS", (8, 12))
    ball.balloon.Live = False
    ball.outline.ViewObject.Proxy.doubleClicked(ball.outline.ViewObject)
    hands.wait_until(hands.panel_is_seen)
    look, slider, told = hands.find("PanelCurve"), hands.find("PanelSlider"), hands.find("PanelCurveTold")
    assert not slider.isVisible()
    hands.click(look)
    assert look.text() == "Stop"
    hands.wait_until(lambda: look.text() != "Stop", 240)
    assert slider.maximum() == 1
    slider.setValue(1)
    hands.wait(0.1)
    assert ball.outline.Panels == 12 and ball.outline.PanelCount == 12
    assert told.text().startswith("12 panels: about")
    hands.screenshot("body-curve")
    error = {point.panels: point.error for point in hands.find("PanelCurve").parent()._points}
    assert error[8] > 1.2 * error[12]
    hands.find("MeanDistance").setValue(100.0 * 1.05 * error[8])
    hands.wait(0.1)
    assert ball.outline.Panels == 8, "the fewest that come so near"
    hands.find("MeanDistance").setValue(0.01)
    hands.wait(0.1)
    assert "No number of panels" in told.text()
    hands.press("Cancel")
    hands.wait_until(hands.panel_is_closed)
    assert App.ActiveDocument.getObject(ball.outline.Name).Panels == 8

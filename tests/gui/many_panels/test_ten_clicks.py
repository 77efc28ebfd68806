# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a solid with fillets to a file of its panels laid out on film, with the mouse."""

import FreeCADGui as Gui
import hands
import pytest
import view_port

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import kinds
from BalloonWorkbench.app.properties import preferences
from BalloonWorkbench.core.target_design import fit_target

_ANSWER = 240  # s, of one processor that has nothing else to do


class Clicks:
    """Clicks of the left button, counted; the keyboard is not touched."""

    def __init__(self):
        self.count = 0

    def model(self, point):
        """On a point of the model (3,) mm."""
        area = view_port.view_area()  # kept: its view port goes with what Python knows of it
        port = area.viewport()
        self.count += 1
        view_port.click(port, view_port.pixel(port, point))

    def command(self, name):
        """On the button of a command in the tool bar."""
        buttons = [
            bar.widgetForAction(action)
            for bar in hands.visible(hands.QtWidgets.QToolBar)
            for action in bar.actions()
            if action.objectName() == name
        ]
        (button,) = [each for each in buttons if not each.visibleRegion().isEmpty()]
        hands.wait_until(button.isEnabled, 10)
        self._on(button)

    def button(self, name):
        self._on(hands.find(name))

    def panel(self, name):
        """On a button of the open panel's row."""
        self.count += 1
        hands.press(name)

    def _on(self, widget):
        self.count += 1
        hands.click(widget)


@pytest.fixture
def clicks():
    return Clicks()


@pytest.fixture(autouse=True)
def quick(monkeypatch, without_figures):
    """A coarse balloon that is hardly corrected: what is counted here are clicks."""
    monkeypatch.setattr(fit_target, "VERTICES", 400)
    monkeypatch.setattr(fit_target, "STEPS", 1)


@pytest.fixture
def solid(doc):
    """A box whose upright edges are round."""
    box = doc.addObject("Part::Box", "Box")
    box.Length, box.Width, box.Height = 120, 80, 60
    doc.recompute()
    upright = [
        number
        for number, edge in enumerate(box.Shape.Edges, 1)
        if abs(edge.tangentAt(edge.FirstParameter).z) > 0.9
    ]
    made = doc.addObject("Part::Fillet", "Housing")
    made.Base, made.Edges = box, [(number, 20.0, 20.0) for number in upright]
    box.ViewObject.Visibility = False
    doc.recompute()
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    hands.wait(0.8)
    return made


def sheet_of(doc):
    return next(obj for obj in doc.Objects if kinds.is_film_sheet(obj))


def is_shown(name):
    return any(widget.objectName() == name for widget in hands.visible(hands.QtWidgets.QWidget))


@pytest.mark.slow
def test_a_solid_is_on_film_in_ten_clicks(solid, clicks, tmp_path):
    doc = solid.Document
    preferences.put_export_folder(doc, tmp_path)
    clicks.model(solid.Shape.BoundBox.Center)
    hands.wait_until(lambda: Gui.Selection.getSelection() == [solid], 10)
    clicks.command("BalloonWorkbench_FromBody")
    hands.wait_until(lambda: status.is_ready(doc.Pattern), _ANSWER)
    hands.wait(1.0)
    hands.screenshot("ten-clicks-balloon")
    clicks.button("GoNest")
    hands.wait_until(lambda: any(kinds.is_film_sheet(obj) for obj in doc.Objects), _ANSWER)
    hands.wait_until(lambda: is_shown("NestPanel"), 60)
    hands.wait(1.0)  # the panel before it goes
    clicks.panel("Ok")
    hands.wait_until(hands.panel_is_closed, _ANSWER)
    hands.wait(0.5)
    clicks.command("BalloonWorkbench_ExportPattern")
    hands.wait_until(hands.panel_is_seen, 60)
    hands.screenshot("ten-clicks-export")
    clicks.panel("Ok")
    hands.wait_until(hands.panel_is_closed, 60)
    written = list(tmp_path.glob("*.dxf"))
    assert len(written) == 1
    assert clicks.count <= 10

    # a dimension of the solid: body, balloon, pattern and sheet follow
    sheet, pattern = sheet_of(doc), doc.Pattern
    used, seams, volume = sheet.UsedLength.Value, pattern.SeamLength.Value, doc.Balloon.Volume.Value
    assert sheet.Patterns == [pattern] and sheet.Pieces == doc.Target.PanelCount == 10
    doc.Box.Height = 120
    doc.recompute()
    hands.wait_until(lambda: doc.Balloon.Volume.Value > 1.5 * volume, _ANSWER)
    doc.recompute()
    assert [obj.Status for obj in (doc.Target, doc.Balloon, pattern)] == [status.READY] * 3
    assert doc.Target.BodySize.z == pytest.approx(120)
    assert pattern.SeamLength.Value > 1.1 * seams
    assert sheet.UsedLength.Value > 1.1 * used
    hands.screenshot("ten-clicks-taller")

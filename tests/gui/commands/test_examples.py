# SPDX-License-Identifier: LGPL-2.1-or-later
"""The examples in the menu: each opens a copy that looks as it should, without an error."""

import FreeCAD as App
import FreeCADGui as Gui
import hands
import pytest
from brush import close_window
from pictures import framed, picture

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document.examples import EXAMPLES
from BalloonWorkbench.gui.paint import window as paint_window


@pytest.mark.slow
@pytest.mark.parametrize("example", EXAMPLES, ids=lambda example: example.name)
def test_it_opens_from_the_menu(example):
    assert f"BalloonWorkbench_Example_{example.name.replace('-', '_')}" in Gui.listCommands()
    Gui.runCommand(f"BalloonWorkbench_Example_{example.name.replace('-', '_')}")
    hands.wait_until(lambda: App.ActiveDocument is not None)
    doc = App.ActiveDocument
    hands.wait(0.5)
    assert doc.FileName == ""
    assert doc.Label == example.title
    if example.name == "ring":  # tests/app/document/test_examples.py does so with all of them
        for obj in doc.Objects:
            obj.touch()
        doc.recompute()
    assert [obj.Status for obj in (doc.Balloon.Outline, doc.Balloon, doc.Pattern)] == [status.READY] * 3
    image = hands.screenshot(f"example-{example.name}")
    left, right = image.width() // 4, image.width() - 40
    colours = {image.pixel(x, y) for x in range(left, right, 6) for y in range(200, image.height() - 200, 6)}
    assert len(colours) > 200  # shaded, not flat


@pytest.mark.slow
def test_the_heart_follows_a_cell_beside_its_panel():
    with framed():
        Gui.runCommand("BalloonWorkbench_Example_parametric_heart")
        hands.wait_until(lambda: App.ActiveDocument is not None)
        doc = App.ActiveDocument
        doc.Balloon.MeshSize = 20
        doc.Sizes.set("height", "=300 mm")
        doc.recompute()
        assert doc.Outline.SizeY.Value == pytest.approx(300, abs=0.5)
        Gui.SendMsgToActiveView("ViewFit")
        assert doc.Balloon.ViewObject.Proxy.doubleClicked(doc.Balloon.ViewObject)
        hands.wait_until(hands.panel_is_seen)
        picture("tutorial-heart")
        hands.press("Cancel")
        hands.wait_until(hands.panel_is_closed)


def test_the_menu_has_them():
    menus = Gui.getMainWindow().menuBar().actions()
    ours = next(menu for menu in menus if "Balloon" in menu.text()).menu()
    texts = [action.text() for action in ours.actions()]
    assert any("Examples" in text for text in texts)


def test_the_painted_fish_is_painted_on():
    Gui.runCommand("BalloonWorkbench_Example_painted_fish")
    hands.wait_until(lambda: App.ActiveDocument is not None)
    outline = App.ActiveDocument.Outline
    assert outline.ViewObject.Proxy.doubleClicked(outline.ViewObject)
    hands.wait_until(lambda: bool(paint_window._open), 10)
    assert len(paint_window._open[0].painting.steps) > 8
    close_window()

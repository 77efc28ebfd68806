# SPDX-License-Identifier: LGPL-2.1-or-later
"""A document that was written without a window looks and works like one made in it."""

import os
import subprocess

import FreeCAD as App
import FreeCADGui as Gui
import hands
import pytest

from BalloonWorkbench.app.border import status


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    """What the command line makes of a heart."""
    folder = tmp_path_factory.mktemp("written")
    command = [".venv/bin/python", "-m", "BalloonWorkbench", "design"]
    heart = "resources/examples/pictures/heart.png"
    options = [heart, "--width", "120mm", "--mesh-size", "14mm", "--out", str(folder / "out")]
    environment = {**os.environ, "FREECAD_USER_HOME": str(folder)}
    subprocess.run(
        [*command, *options], check=True, env=environment, capture_output=True, timeout=hands.patience(120)
    )
    return folder / "out" / "balloon.FCStd"


@pytest.fixture
def doc(written):
    document = App.openDocument(str(written))
    hands.wait(0.2)
    return document


def test_objects_are_dressed_and_shown(doc):
    for name in ("Outline", "Balloon", "Pattern"):
        vobj = doc.getObject(name).ViewObject
        assert type(vobj.Proxy).__name__ == f"{name}View"
        assert vobj.Visibility
    assert doc.BalloonGroup.ViewObject.Visibility
    assert doc.Balloon.ViewObject.DisplayMode == "Film"
    assert len(set(doc.Pattern.ViewObject.LineColorArray)) == 2


def test_balloon_can_be_seen(doc):
    view = Gui.getDocument(doc.Name).ActiveView
    view.viewIsometric()
    view.fitAll()
    image = hands.screenshot("from-command-line")
    points = [(x, y) for x in range(300, image.width(), 8) for y in range(200, image.height() - 60, 8)]
    colours = [hands.QtGui.QColor(image.pixel(x, y)) for x, y in points]
    foil = [colour for colour in colours if colour.red() > 2 * max(colour.green(), colour.blue())]
    assert len(foil) > 0.01 * len(colours)


def test_pattern_has_the_colours_of_its_layers(doc):
    view = Gui.getDocument(doc.Name).ActiveView
    view.viewTop()
    view.fitAll()
    image = hands.screenshot("from-command-line-top")
    colours = [image.pixel(x, y) & 0xFFFFFF for x in range(300, image.width()) for y in range(200, 900)]
    assert colours.count(0xFF0000) > 200
    assert colours.count(0xFF00FF) > 200


@pytest.mark.slow
def test_double_click_edits_it(doc):
    doc.Balloon.ViewObject.Proxy.doubleClicked(doc.Balloon.ViewObject)
    hands.wait_until(hands.panel_is_seen)
    assert hands.find("Drawing").text() == "heart.png"
    hands.type_into(hands.find("Pressure"), "3 kPa")
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert doc.Balloon.Status == status.READY
    assert doc.Balloon.Pressure.Value == pytest.approx(3)

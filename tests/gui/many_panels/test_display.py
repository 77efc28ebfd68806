# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colour maps, display modes and the panels for making, of a balloon of many panels."""

import FreeCADGui as Gui
import hands
import pytest

from BalloonWorkbench.app.document import create
from BalloonWorkbench.gui.view3d.balloon_display import MODES
from BalloonWorkbench.gui.view3d.film_map import choices_of, map_nodes
from BalloonWorkbench.gui.view3d.skin import skin_of


@pytest.fixture
def box(doc):
    """A ready box of few triangles."""
    return create.balloon_from_panels(doc, "Box", mesh_size="30 mm")


def test_all_panels_and_seams_are_in_the_film(box):
    skin = skin_of(box.balloon)
    assert set(skin.panels.tolist()) == set(range(6))
    assert len(skin.lines) == 12
    assert len(skin.triangles) == len(skin.panels)


def test_every_map_and_mode_is_shown(box):
    balloon = box.balloon
    for choice in choices_of(balloon)[1:]:
        assert map_nodes(balloon, choice)
        balloon.ViewObject.ColourMap = choice
        hands.wait(0.1)
    balloon.ViewObject.ColourMap = "Off"
    balloon.ViewObject.CompareOutlines = True
    for mode in MODES:
        balloon.ViewObject.DisplayMode = mode
        hands.wait(0.1)
        assert balloon.ViewObject.DisplayMode == mode


def test_panels_for_making_open(box):
    for command in ("Advice", "ColourMap", "Animate", "Nest", "ExportPattern", "AssemblySheet"):
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(box.balloon)
        Gui.runCommand(f"BalloonWorkbench_{command}")
        hands.wait_until(hands.panel_is_seen, otherwise=f"no panel of {command}")
        hands.wait(0.2)
        hands.leave()
        hands.wait_until(hands.panel_is_closed)


def test_macro_makes_the_same_bag(doc, stand_in):
    lines = []
    stand_in.setattr(Gui, "doCommand", lines.append)
    Gui.runCommand("BalloonWorkbench_FromPanels")
    hands.wait_until(hands.panel_is_seen)
    hands.choose(hands.find("Ready"), "Tetrahedron")
    hands.type_into(hands.find("MeshSize"), "30 mm")
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed, 60)
    (made,) = [line for line in lines if "from_panels" in line]
    assert made.startswith('balloon = BalloonWorkbench.from_panels(App.ActiveDocument, "Tetrahedron"')

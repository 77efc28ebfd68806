# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench shows its commands where a user looks for them."""

import FreeCAD as App
import FreeCADGui as Gui
import hands
import pytest
from PySide import QtSvg

COMMANDS = ("FromPicture", "FromSketch", "FromProfile", "FromBody", "FromPanels", "EditOutline", "Advice")
COMMANDS += (
    "PatternView",
    "ColourMap",
    "Animate",
    "Study",
    "Artwork",
    "Nest",
    "ExportPattern",
    "AssemblySheet",
)
COMMANDS += ("ExportForWeb", "Compare")
TEXTS = [
    "Paint a balloon",
    "New balloon from picture",
    "New balloon from sketch",
    "New body of gores",
    "New balloon from body",
    "New bag of panels",
    "Edit outline",
    "Advice",
    "Pattern view",
    "Colour map",
    "Animate inflation",
    "Study",
    "Artwork",
    "Lay out on film",
    "Export pattern",
    "Assembly sheet",
    "Export for the web",
    "Compare with a photograph",
]


def test_workbench_has_a_name_and_an_icon(workbench):
    assert workbench.name() == "BalloonWorkbench"
    assert workbench.MenuText == "Film Balloon"
    assert QtSvg.QSvgRenderer(workbench.Icon).isValid()


def test_toolbar_and_menu_have_the_commands():
    window = Gui.getMainWindow()
    bars = [
        bar for bar in window.findChildren(hands.QtWidgets.QToolBar) if bar.windowTitle() == "Film Balloon"
    ]
    assert [action.text().replace("&", "") for action in bars[0].actions()] == TEXTS
    menus = [menu for menu in window.menuBar().actions() if menu.text().replace("&", "") == "Film Balloon"]
    entries = [action.text().replace("&", "") for action in menus[0].menu().actions()]
    assert entries == [*TEXTS, "", "My machines", "Test card", "Examples", "What works here"]


@pytest.mark.parametrize("name", COMMANDS)
def test_command_has_an_icon_and_a_tooltip(name):
    command = Gui.Command.get(f"BalloonWorkbench_{name}")
    info = command.getInfo()
    assert len(info["toolTip"]) > 20
    action = command.getAction()[0]
    image = action.icon().pixmap(48, 48).toImage()
    colours = {image.pixel(x, y) for x in range(0, 48, 4) for y in range(0, 48, 4)}
    assert len(colours) > 8


def test_commands_are_offered_when_they_make_sense():
    active = {name: Gui.Command.get(f"BalloonWorkbench_{name}").isActive for name in COMMANDS}
    assert {name: is_active() for name, is_active in active.items()} == {
        "FromPicture": True,
        "FromSketch": False,
        "FromProfile": True,
        "FromBody": True,
        "FromPanels": True,
        "EditOutline": False,
        "Advice": False,
        "PatternView": False,
        "ColourMap": False,
        "Animate": False,
        "Study": False,
        "Artwork": False,
        "Nest": False,
        "ExportPattern": False,
        "AssemblySheet": False,
        "ExportForWeb": False,
        "Compare": False,
    }
    App.newDocument("Empty")
    assert active["FromSketch"]()
    assert not active["ExportPattern"]()
    assert not active["Advice"]()
    Gui.runCommand("BalloonWorkbench_FromPicture")
    hands.wait_until(hands.panel_is_seen)
    assert not any(is_active() for is_active in active.values())

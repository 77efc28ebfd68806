# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every command says what it is: in its menu, as a tip, in the status bar, and on a page of its own."""

import re
import sys
import types
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlparse

import FreeCADGui as Gui
import hands
import pytest

OURS = [name for name in Gui.listCommands() if name.startswith("BalloonWorkbench_")]
#: What Draft and BIM take; loading them here would leave widgets behind.
TAKEN = ("B, P", "B, S", "B, U", "B, Z")


def page_of(text):
    """The file that a What's this text leads to."""
    return Path(unquote(urlparse(text).path) if text.startswith("file:") else text)


def whats_this(name):
    """What the buttons of a command say to What's this; examples are in the menu of another one."""
    actions = Gui.Command.get(name).getAction() or Gui.Command.get("BalloonWorkbench_Examples").getAction()
    (text,) = {action.whatsThis() for action in actions}
    return text


def test_commands_are_known():
    assert len(OURS) >= 6


@pytest.mark.parametrize("name", OURS)
def test_command_says_what_it_is(name):
    info = Gui.Command.get(name).getInfo()
    assert info["menuText"]
    assert len(info["statusTip"]) > 20
    assert page_of(whats_this(name)).is_file()


@pytest.mark.parametrize("name", OURS)
def test_page_is_whole(name):
    """Its pictures are there, and it is about this command."""
    info = Gui.Command.get(name).getInfo()
    page = page_of(whats_this(name))
    text = page.read_text(encoding="utf-8")
    if "_Example_" not in name:  # they share a page
        assert f"<title>{info['menuText'].replace('&', '')}</title>" in text
    for link in re.findall(r'(?:src|href)="([^"]+)"', text):
        assert (page.parent / link).is_file(), link
    HTMLParser().feed(text)
    keys = Gui.Command.get(name).getShortcut()
    assert all(f"<kbd>{key}</kbd>" in text for key in keys.split(", ") if key)


def test_keys_belong_to_one_command():
    shortcuts = {name: Gui.Command.get(name).getShortcut() for name in Gui.listCommands()}
    for name in OURS:
        mine = shortcuts[name]
        assert not mine or [other for other, keys in shortcuts.items() if keys == mine] == [name]
        assert mine not in TAKEN


@pytest.mark.parametrize(("language", "folder"), [("German", "de"), ("Spanish", "es-ES"), ("Polish", "help")])
def test_pages_follow_the_language(language, folder):
    """Of the commands that FreeCAD has long known, and of their buttons; English where there is no page."""
    Gui.setLocale(language)
    hands.wait(0.3)
    try:
        for name in OURS:
            page = page_of(whats_this(name))
            assert page.is_file()
            assert page.parent.name == folder
    finally:
        Gui.setLocale("English")
        hands.wait(0.3)
    assert page_of(whats_this(OURS[0])).parent.name == "help"


@pytest.fixture
def help_module(monkeypatch):
    """What FreeCAD asks to show a page."""
    shown = []
    module = types.ModuleType("Help")
    module.show = lambda page, *_more: shown.append(page)
    monkeypatch.setitem(sys.modules, "Help", module)
    return shown


def test_whats_this_opens_the_page(help_module):
    """As Shift+F1 and a click on the button do."""
    action = Gui.Command.get("BalloonWorkbench_FromPicture").getAction()[0]
    # Qt 5 and 6 have different names for it
    owners = getattr(action, "associatedObjects", None) or action.associatedWidgets
    bars = [bar for bar in owners() if isinstance(bar, hands.QtWidgets.QToolBar)]
    button = bars[0].widgetForAction(action)
    Gui.runCommand("Std_WhatsThis")
    hands.wait(0.1)
    hands.click(button)
    hands.wait(0.3)
    assert not hands.panel_is_open(), "the command must not run"
    assert [page_of(page).name for page in help_module] == ["FromPicture.html"]

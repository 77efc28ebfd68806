# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the commands have in common: names, keys, tips, help, and when they are offered."""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui

from BalloonWorkbench.app.host import help_text
from BalloonWorkbench.gui.qt import HELP, QtCore, icon
from BalloonWorkbench.gui.window import borders
from BalloonWorkbench.gui.window.sentences import language

#: B for balloon, then a letter that FreeCAD's own workbenches leave free.
_KEYS = {
    "Paint": "B, D",
    "FromPicture": "B, I",
    "FromSketch": "B, K",
    "FromProfile": "B, O",
    "FromBody": "B, Y",
    "FromPanels": "B, N",
    "EditOutline": "B, J",
    "Advice": "B, A",
    "PatternView": "B, F",
    "ColourMap": "B, M",
    "Animate": "B, V",
    "Study": "B, T",
    "Artwork": "B, R",
    "Nest": "B, L",
    "ExportPattern": "B, E",
    "AssemblySheet": "B, H",
}
_pages: dict[str, str] = {}  # of each command
_turner: list[QtCore.QObject] = []


class Command:
    """A command that is offered while no panel is open."""

    drawing = menu_text = tool_tip = ""

    def GetResources(self):
        return {"Pixmap": icon(self.drawing), "MenuText": self.menu_text, "ToolTip": self.tool_tip}

    def IsActive(self):
        return not Gui.Control.activeDialog()


class PatternCommand(Command):
    """A command that needs a balloon."""

    def IsActive(self):
        from BalloonWorkbench.app.document.parts import patterns

        return App.ActiveDocument is not None and super().IsActive() and bool(patterns(App.ActiveDocument))


class ResultCommand(PatternCommand):
    """A command that needs a balloon with a result."""

    def IsActive(self):
        return super().IsActive() and any(parts.balloon.SolvedFor for parts in known_parts())


def known_parts() -> list:
    """The parts of each balloon of the document in front."""
    from BalloonWorkbench.app.document.parts import parts_of, patterns

    return [*filter(None, map(parts_of, patterns(App.ActiveDocument)))]


def selected_parts() -> list:
    """The parts of the selected balloons."""
    from BalloonWorkbench.app.document.parts import parts_of

    return [*filter(None, map(parts_of, Gui.Selection.getSelection()))]


def solved_parts():
    """The parts of the selected balloon, else of the first one, that has a result."""
    return next(parts for parts in (*selected_parts(), *known_parts()) if parts.balloon.SolvedFor)


def add(name: str, command, page: str = "") -> None:
    """Make a command known to FreeCAD, with its key and a page of docs/help: its own, or another one."""
    own, short = command.GetResources(), name.split("_")[1]
    own["StatusTip"] = own["ToolTip"]
    own["WhatsThis"] = name  # FreeCAD shows that in tooltips; the page goes into the buttons
    _pages[name] = page or short
    if short in _KEYS:
        own["Accel"] = _KEYS[short]
    command.GetResources = lambda: own
    if hasattr(command, "Activated"):  # a submenu has none
        command.Activated = borders.command(name, command.Activated)
    command.IsActive = borders.offered(name, command.IsActive)
    Gui.addCommand(name, command)


def follow_language() -> None:
    """Lay the pages into the buttons once there are some, and whenever FreeCAD changes its language."""
    if not _turner:
        _turner.append(_Turner(Gui.getMainWindow()))
        QtCore.QTimer.singleShot(0, _turn)


def _turn() -> None:
    for name, page in _pages.items():
        for action in Gui.Command.get(name).getAction():
            action.setWhatsThis(help_text(_page_of(page)))


def _page_of(name: str):
    """The file of a page in the window's language, in English where there is none."""
    own = HELP / language() / f"{name}.html"
    return own if own.is_file() else HELP / f"{name}.html"


class _Turner(QtCore.QObject):
    """A child of the window, which tells its children that the language has changed."""

    def event(self, event):
        if event.type() == QtCore.QEvent.LanguageChange:
            _turn()
        return super().event(event)

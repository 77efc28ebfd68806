# SPDX-License-Identifier: LGPL-2.1-or-later
"""What's this of each command: a page of docs/help in the language of the window, which may change."""

from __future__ import annotations

import FreeCADGui as Gui

from BalloonWorkbench.app.host import help_text
from BalloonWorkbench.gui.qt import HELP, QtCore

_commands: dict[str, tuple[dict, str]] = {}  # what FreeCAD keeps of each command, and its page
_turner: list[QtCore.QObject] = []


def page_of(name: str):
    """The file of a page in the window's language, in English where there is none."""
    own = HELP / Gui.supportedLocales().get(Gui.getLocale(), "en") / f"{name}.html"
    return own if own.is_file() else HELP / f"{name}.html"


def explain(command: str, resources: dict, page: str) -> None:
    """Give a command its page, by what it tells FreeCAD of itself."""
    resources["WhatsThis"] = help_text(page_of(page))
    _commands[command] = resources, page


def follow_language() -> None:
    """Turn the pages whenever FreeCAD changes its language."""
    if not _turner:
        _turner.append(_Turner(Gui.getMainWindow()))


class _Turner(QtCore.QObject):
    """A child of the window, which tells its children that the language has changed."""

    def event(self, event):
        if event.type() == QtCore.QEvent.LanguageChange:
            for name, (resources, page) in _commands.items():
                explain(name, resources, page)
                for action in Gui.Command.get(name).getAction():
                    action.setWhatsThis(resources["WhatsThis"])
        return super().event(event)

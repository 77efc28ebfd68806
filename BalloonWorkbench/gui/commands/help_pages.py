# SPDX-License-Identifier: LGPL-2.1-or-later
"""What's this of each command: a page of docs/help in the language of the window, which may change."""

from __future__ import annotations

import FreeCADGui as Gui

from BalloonWorkbench.app.host import help_text
from BalloonWorkbench.gui.qt import HELP, QtCore

_pages: dict[str, str] = {}  # of each command
_turner: list[QtCore.QObject] = []


def page_of(name: str):
    """The file of a page in the window's language, in English where there is none."""
    own = HELP / Gui.supportedLocales().get(Gui.getLocale(), "en") / f"{name}.html"
    return own if own.is_file() else HELP / f"{name}.html"


def explain(command: str, page: str) -> str:
    """Give a command its page; what it tells FreeCAD instead, which shows that in tooltips: its name."""
    _pages[command] = page
    return command


def follow_language() -> None:
    """Lay the pages into the buttons once there are some, and whenever FreeCAD changes its language."""
    if not _turner:
        _turner.append(_Turner(Gui.getMainWindow()))
        QtCore.QTimer.singleShot(0, _turn)


def _turn() -> None:
    for name, page in _pages.items():
        for action in Gui.Command.get(name).getAction():
            action.setWhatsThis(help_text(page_of(page)))


class _Turner(QtCore.QObject):
    """A child of the window, which tells its children that the language has changed."""

    def event(self, event):
        if event.type() == QtCore.QEvent.LanguageChange:
            _turn()
        return super().event(event)

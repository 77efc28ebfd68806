# SPDX-License-Identifier: LGPL-2.1-or-later
"""The examples, as a submenu: each opens a copy."""

from __future__ import annotations

import FreeCADGui as Gui

from BalloonWorkbench.app.document.examples import EXAMPLES, Example, open_copy
from BalloonWorkbench.app.properties.property_table import QT_TRANSLATE_NOOP
from BalloonWorkbench.gui.commands.command import Command, add
from BalloonWorkbench.gui.qt import translate


class OpenExample(Command):
    """Opens a copy of one example."""

    drawing = "balloon"

    def __init__(self, example: Example):
        self._example = example
        self.menu_text, self.tool_tip = translate(example.title), translate(example.tooltip)

    def Activated(self):
        from BalloonWorkbench.gui.view3d.fit_view import fit_all

        doc = open_copy(self._example)
        doc.Label = translate(self._example.title)
        fit_all(Gui.getDocument(doc.Name))


class Examples(Command):
    """All of them."""

    drawing = "balloon"
    menu_text = QT_TRANSLATE_NOOP("BalloonWorkbench_Examples", "Examples")
    tool_tip = QT_TRANSLATE_NOOP(
        "BalloonWorkbench_Examples", "Open a finished balloon, to look at it and to change it"
    )

    def GetCommands(self):
        return tuple(_name(example) for example in EXAMPLES)


def _name(example: Example) -> str:
    return f"BalloonWorkbench_Example_{example.name.replace('-', '_')}"


def register() -> None:
    """Make the commands of the submenu known to FreeCAD."""
    for example in EXAMPLES:
        add(_name(example), OpenExample(example), "Examples")

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The examples, as a submenu: each opens a copy."""

from __future__ import annotations

import FreeCADGui as Gui

from BalloonWorkbench.app.document.examples import EXAMPLES, Example, open_copy
from BalloonWorkbench.app.properties.property_table import QT_TRANSLATE_NOOP
from BalloonWorkbench.gui.commands.documented import documented
from BalloonWorkbench.gui.qt import icon, translate


class OpenExample:
    """Opens a copy of one example."""

    def __init__(self, example: Example):
        self._example = example

    def GetResources(self):
        return {
            "Pixmap": icon("balloon"),
            "MenuText": translate(self._example.title),
            "ToolTip": translate(self._example.tooltip),
        }

    def IsActive(self):
        return not Gui.Control.activeDialog()

    def Activated(self):
        from BalloonWorkbench.gui.view3d.fit_view import fit_all

        doc = open_copy(self._example)
        doc.Label = translate(self._example.title)
        fit_all(Gui.getDocument(doc.Name))


class Examples:
    """All of them."""

    def GetResources(self):
        return {
            "Pixmap": icon("balloon"),
            "MenuText": QT_TRANSLATE_NOOP("BalloonWorkbench_Examples", "Examples"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "BalloonWorkbench_Examples", "Open a finished balloon, to look at it and to change it"
            ),
        }

    def GetCommands(self):
        return tuple(_name(example) for example in EXAMPLES)

    def IsActive(self):
        return not Gui.Control.activeDialog()


def _name(example: Example) -> str:
    return f"BalloonWorkbench_Example_{example.name.replace('-', '_')}"


def register() -> None:
    """Make the commands of the submenu known to FreeCAD."""
    for example in EXAMPLES:
        Gui.addCommand(_name(example), documented(_name(example), OpenExample(example), "Examples"))

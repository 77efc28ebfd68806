# SPDX-License-Identifier: LGPL-2.1-or-later
"""New balloon from a picture or another drawing file."""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui

from BalloonWorkbench.app.properties.property_table import QT_TRANSLATE_NOOP
from BalloonWorkbench.gui.qt import icon, translate
from BalloonWorkbench.gui.window.borders import undo_step


class FromPicture:
    """Asks for a file, makes the objects of its balloon and opens their panel."""

    def GetResources(self):
        return {
            "Pixmap": icon("from_picture"),
            "MenuText": QT_TRANSLATE_NOOP("BalloonWorkbench_FromPicture", "New balloon from picture"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "BalloonWorkbench_FromPicture",
                "Trace a picture, SVG, DXF or JSON file and design the balloon that looks like it",
            ),
        }

    def IsActive(self):
        return not Gui.Control.activeDialog()

    def Activated(self):
        from BalloonWorkbench.gui.panels import show
        from BalloonWorkbench.gui.panels.balloon.balloon_panel import BalloonPanel
        from BalloonWorkbench.gui.window import file_dialogs, macro_recorder

        path = file_dialogs.ask_for_drawing(Gui.getMainWindow())
        if path is None:
            return
        doc = App.ActiveDocument
        fresh = doc is None
        if fresh:
            doc = App.newDocument("Balloon")
        with undo_step(doc, translate("New balloon from picture")):
            parts, edit = macro_recorder.begin(doc)
            panel = BalloonPanel(parts, new_document=fresh, edit=edit)
            show(panel)
        if path:
            panel.begin_with(path)

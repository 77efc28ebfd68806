# SPDX-License-Identifier: LGPL-2.1-or-later
"""New balloon that follows a sketch, a wire or a face."""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui

from BalloonWorkbench.app.properties.property_table import QT_TRANSLATE_NOOP
from BalloonWorkbench.gui.qt import icon, translate
from BalloonWorkbench.gui.window.borders import undo_step


class FromSketch:
    """Makes the objects of a balloon, links the selected sketch and opens their panel."""

    def GetResources(self):
        return {
            "Pixmap": icon("from_sketch"),
            "MenuText": QT_TRANSLATE_NOOP("BalloonWorkbench_FromSketch", "New balloon from sketch"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "BalloonWorkbench_FromSketch",
                "Design the balloon that looks like the selected sketch, wire or face and follows it",
            ),
        }

    def IsActive(self):
        return App.ActiveDocument is not None and not Gui.Control.activeDialog()

    def Activated(self):
        from BalloonWorkbench.app.group import name_group
        from BalloonWorkbench.gui.panels import show
        from BalloonWorkbench.gui.panels.balloon.balloon_panel import BalloonPanel
        from BalloonWorkbench.gui.window import macro_recorder
        from BalloonWorkbench.gui.window.selection import selected_source

        source = selected_source()
        doc = App.ActiveDocument
        with undo_step(doc, translate("New balloon from sketch")):
            parts, edit = macro_recorder.begin(doc)
            if source is not None:
                parts.outline.Source = source
                name_group(parts.balloon.getParentGroup(), f"{source[0].Label} balloon")
                if source[0].isDerivedFrom("Sketcher::SketchObject"):
                    source[0].ViewObject.Visibility = False  # the outline shows it
            show(BalloonPanel(parts, sketch=True, edit=edit))

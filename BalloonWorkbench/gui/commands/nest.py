# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panels laid out on film."""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui

from BalloonWorkbench.app.properties.property_table import QT_TRANSLATE_NOOP
from BalloonWorkbench.gui.qt import icon, translate
from BalloonWorkbench.gui.window.borders import undo_step


class Nest:
    """Makes a sheet of film with the selected balloons, or all, and opens its panel."""

    def GetResources(self):
        return {
            "Pixmap": icon("nest"),
            "MenuText": QT_TRANSLATE_NOOP("BalloonWorkbench_Nest", "Lay out on film"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "BalloonWorkbench_Nest",
                "Lay the panels of one or several balloons closely on a roll or on sheets of film",
            ),
        }

    def IsActive(self):
        from BalloonWorkbench.app.document.parts import patterns

        doc = App.ActiveDocument
        return doc is not None and not Gui.Control.activeDialog() and bool(patterns(doc))

    def Activated(self):
        from BalloonWorkbench.app import film_sheet
        from BalloonWorkbench.app.document import kinds
        from BalloonWorkbench.app.document.parts import parts_of, patterns
        from BalloonWorkbench.gui.panels import show
        from BalloonWorkbench.gui.panels.making.nest import NestPanel

        doc = App.ActiveDocument
        selected = Gui.Selection.getSelection()
        sheets = [obj for obj in selected if kinds.is_film_sheet(obj)]
        chosen = [parts.pattern for parts in map(parts_of, selected) if parts]
        known = list(dict.fromkeys(chosen)) or patterns(doc)
        with undo_step(doc, translate("Lay out on film")):
            show(NestPanel(sheets[0] if sheets else film_sheet.make(doc, known)))

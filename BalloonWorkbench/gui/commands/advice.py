# SPDX-License-Identifier: LGPL-2.1-or-later
"""Advice on a balloon."""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui

from BalloonWorkbench.app.properties.property_table import QT_TRANSLATE_NOOP
from BalloonWorkbench.gui.qt import icon


class Advice:
    """Opens the panel of the coach on the selected balloon."""

    def GetResources(self):
        return {
            "Pixmap": icon("advice"),
            "MenuText": QT_TRANSLATE_NOOP("BalloonWorkbench_Advice", "Advice"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "BalloonWorkbench_Advice",
                "Show which parts of a shape will inflate badly, and repair them",
            ),
        }

    def IsActive(self):
        from BalloonWorkbench.app.document.parts import patterns

        doc = App.ActiveDocument
        return doc is not None and not Gui.Control.activeDialog() and bool(patterns(doc))

    def Activated(self):
        from BalloonWorkbench.app.document.parts import parts_of, patterns
        from BalloonWorkbench.gui.panels import show
        from BalloonWorkbench.gui.panels.results.advice import AdvicePanel

        chosen = [parts for parts in map(parts_of, Gui.Selection.getSelection()) if parts]
        known = [parts for parts in map(parts_of, patterns(App.ActiveDocument)) if parts]
        if chosen or known:
            show(AdvicePanel((chosen or known)[0]))

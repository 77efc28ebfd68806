# SPDX-License-Identifier: LGPL-2.1-or-later
"""Paint a balloon."""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui

from BalloonWorkbench.app.properties.property_table import QT_TRANSLATE_NOOP
from BalloonWorkbench.gui.qt import icon


class Paint:
    """Opens the paint window."""

    def GetResources(self):
        return {
            "Pixmap": icon("paint"),
            "MenuText": QT_TRANSLATE_NOOP("BalloonWorkbench_Paint", "Paint a balloon"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "BalloonWorkbench_Paint",
                "Draw with pen and brush, and watch the balloon and its pattern grow beside it",
            ),
        }

    def IsActive(self):
        return not Gui.Control.activeDialog()

    def Activated(self):
        from BalloonWorkbench.gui.paint.window import open_for

        open_for(App.ActiveDocument or App.newDocument("Balloon"))

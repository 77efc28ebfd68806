# SPDX-License-Identifier: LGPL-2.1-or-later
"""The assembly sheet of a balloon."""

from __future__ import annotations

from BalloonWorkbench.app.properties.property_table import QT_TRANSLATE_NOOP
from BalloonWorkbench.gui.commands import solved
from BalloonWorkbench.gui.qt import icon


class AssemblySheet:
    """Opens the panel with the selected balloon's numbers, which writes its page."""

    def GetResources(self):
        return {
            "Pixmap": icon("assembly_sheet"),
            "MenuText": QT_TRANSLATE_NOOP("BalloonWorkbench_AssemblySheet", "Assembly sheet"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "BalloonWorkbench_AssemblySheet",
                "Tell what the balloon takes and whether it floats, and write one page on how to make it",
            ),
        }

    def IsActive(self):
        return solved.is_offered()

    def Activated(self):

        from BalloonWorkbench.gui.panels import show
        from BalloonWorkbench.gui.panels.making.assembly import AssemblyPanel

        show(AssemblyPanel(solved.chosen()))

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results of a balloon as colours."""

from __future__ import annotations

from BalloonWorkbench.app.properties.property_table import QT_TRANSLATE_NOOP
from BalloonWorkbench.gui.commands import solved
from BalloonWorkbench.gui.qt import icon


class ColourMap:
    """Opens the panel that chooses what is shown on the selected balloon."""

    def GetResources(self):
        return {
            "Pixmap": icon("colour_map"),
            "MenuText": QT_TRANSLATE_NOOP("BalloonWorkbench_ColourMap", "Colour map"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "BalloonWorkbench_ColourMap",
                "Show tension, wrinkles, thickness and other results as colours on the balloon",
            ),
        }

    def IsActive(self):
        return solved.is_offered()

    def Activated(self):
        from BalloonWorkbench.gui.panels import show
        from BalloonWorkbench.gui.panels.results.colour_map import ColourMapPanel

        show(ColourMapPanel(solved.chosen()))

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The inflation of a balloon, played."""

from __future__ import annotations

from BalloonWorkbench.app.properties.property_table import QT_TRANSLATE_NOOP
from BalloonWorkbench.gui.commands import solved
from BalloonWorkbench.gui.qt import icon


class Animate:
    """Opens the panel that plays the inflation of the selected balloon."""

    def GetResources(self):
        return {
            "Pixmap": icon("animate"),
            "MenuText": QT_TRANSLATE_NOOP("BalloonWorkbench_Animate", "Animate inflation"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "BalloonWorkbench_Animate",
                "Play how the balloon inflates, from the flat film to rest, with a slider",
            ),
        }

    def IsActive(self):
        return solved.is_offered()

    def Activated(self):
        from BalloonWorkbench.gui.panels import show
        from BalloonWorkbench.gui.panels.results.animation import AnimationPanel

        show(AnimationPanel(solved.chosen()))

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Artwork on a balloon."""

from __future__ import annotations

import FreeCAD as App

from BalloonWorkbench.app.properties.property_table import QT_TRANSLATE_NOOP
from BalloonWorkbench.gui.commands import solved
from BalloonWorkbench.gui.qt import icon, translate
from BalloonWorkbench.gui.window.borders import undo_step


class Artwork:
    """Opens the panel on the artwork of the selected balloon; makes one where there is none."""

    def GetResources(self):
        return {
            "Pixmap": icon("artwork"),
            "MenuText": QT_TRANSLATE_NOOP("BalloonWorkbench_Artwork", "Artwork"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "BalloonWorkbench_Artwork",
                "Print a picture on the film so that it reads right on the inflated balloon",
            ),
        }

    def IsActive(self):
        return solved.is_offered()

    def Activated(self):

        from BalloonWorkbench.app import artwork
        from BalloonWorkbench.gui.panels import show
        from BalloonWorkbench.gui.panels.making.artwork import ArtworkPanel

        parts = solved.chosen()
        with undo_step(App.ActiveDocument, translate("Artwork")):
            obj = artwork.of_balloon(parts.balloon) or artwork.make(parts.pattern)
            show(ArtworkPanel(obj))

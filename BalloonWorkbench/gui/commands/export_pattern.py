# SPDX-License-Identifier: LGPL-2.1-or-later
"""Export of a pattern for a cutter."""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui

from BalloonWorkbench.app.properties.property_table import QT_TRANSLATE_NOOP
from BalloonWorkbench.gui.qt import icon


class ExportPattern:
    """Opens the export panel on the selected pattern, artwork or sheet of film."""

    def GetResources(self):
        return {
            "Pixmap": icon("export_pattern"),
            "MenuText": QT_TRANSLATE_NOOP("BalloonWorkbench_ExportPattern", "Export pattern"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "BalloonWorkbench_ExportPattern",
                "Write the flat pattern of a balloon for a cutter, a plotter, a heat sealer or a printer",
            ),
        }

    def IsActive(self):
        from BalloonWorkbench.app.document.parts import patterns

        doc = App.ActiveDocument
        return doc is not None and not Gui.Control.activeDialog() and bool(patterns(doc))

    def Activated(self):
        from BalloonWorkbench.app.document.parts import parts_of, patterns
        from BalloonWorkbench.gui.panels import show
        from BalloonWorkbench.gui.panels.making.export import ExportPanel

        doc = App.ActiveDocument
        selected = Gui.Selection.getSelection()
        others = [obj for obj in doc.Objects if hasattr(getattr(obj, "Proxy", None), "cut_pattern")]
        chosen = [obj for obj in selected if obj in others]
        chosen += [parts.pattern for parts in map(parts_of, selected) if parts]
        show(ExportPanel([*patterns(doc), *others], chosen[0] if chosen else None))

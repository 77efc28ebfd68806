# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a finished balloon to the workshop: prints, panels on film, files for machines, the assembly sheet."""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui

from BalloonWorkbench.app.properties.property_table import QT_TRANSLATE_NOOP
from BalloonWorkbench.gui.commands.command import (
    Command,
    PatternCommand,
    ResultCommand,
    selected_parts,
    solved_parts,
)
from BalloonWorkbench.gui.qt import translate
from BalloonWorkbench.gui.window.borders import undo_step


class ArtworkCommand(ResultCommand):
    """Opens the panel on the artwork of the selected balloon; makes one where there is none."""

    drawing = "artwork"
    menu_text = QT_TRANSLATE_NOOP("BalloonWorkbench_Artwork", "Artwork")
    tool_tip = QT_TRANSLATE_NOOP(
        "BalloonWorkbench_Artwork",
        "Print a picture on the film so that it reads right on the inflated balloon",
    )

    def Activated(self):
        from BalloonWorkbench.app import artwork
        from BalloonWorkbench.gui.panels import show
        from BalloonWorkbench.gui.panels.making.artwork import ArtworkPanel

        parts = solved_parts()
        with undo_step(App.ActiveDocument, translate("Artwork")):
            obj = artwork.of_balloon(parts.balloon) or artwork.make(parts.pattern)
            show(ArtworkPanel(obj))


class Nest(PatternCommand):
    """Makes a sheet of film with the selected balloons, or all, and opens its panel."""

    drawing = "nest"
    menu_text = QT_TRANSLATE_NOOP("BalloonWorkbench_Nest", "Lay out on film")
    tool_tip = QT_TRANSLATE_NOOP(
        "BalloonWorkbench_Nest",
        "Lay the panels of one or several balloons closely on a roll or on sheets of film",
    )

    def Activated(self):
        from BalloonWorkbench.app import film_sheet
        from BalloonWorkbench.app.document import kinds
        from BalloonWorkbench.app.document.parts import patterns
        from BalloonWorkbench.gui.panels import show
        from BalloonWorkbench.gui.panels.making.nest import NestPanel

        doc = App.ActiveDocument
        sheets = [obj for obj in Gui.Selection.getSelection() if kinds.is_film_sheet(obj)]
        chosen = list(dict.fromkeys(parts.pattern for parts in selected_parts())) or patterns(doc)
        with undo_step(doc, translate("Lay out on film")):
            show(NestPanel(sheets[0] if sheets else film_sheet.make(doc, chosen)))


class ExportPattern(PatternCommand):
    """Opens the export panel on the selected pattern, artwork or sheet of film."""

    drawing = "export_pattern"
    menu_text = QT_TRANSLATE_NOOP("BalloonWorkbench_ExportPattern", "Export pattern")
    tool_tip = QT_TRANSLATE_NOOP(
        "BalloonWorkbench_ExportPattern",
        "Write the flat pattern of a balloon for a cutter, a plotter, a heat sealer or a printer",
    )

    def Activated(self):
        from BalloonWorkbench.app.document.kinds import is_panel, is_pattern
        from BalloonWorkbench.app.document.parts import patterns
        from BalloonWorkbench.gui.panels import show
        from BalloonWorkbench.gui.panels.making.export import ExportPanel

        doc = App.ActiveDocument
        others = [obj for obj in doc.Objects if hasattr(getattr(obj, "Proxy", None), "cut_pattern")]
        chosen = [obj for obj in Gui.Selection.getSelection() if obj in others]
        chosen += [parts.pattern for parts in selected_parts()]
        offered = [obj for obj in others if not (is_pattern(obj) or is_panel(obj)) or obj in chosen[:1]]
        show(ExportPanel(list(dict.fromkeys([*patterns(doc), *offered])), chosen[0] if chosen else None))


class AssemblySheet(ResultCommand):
    """Opens the panel with the selected balloon's numbers, which writes its page."""

    drawing = "assembly_sheet"
    menu_text = QT_TRANSLATE_NOOP("BalloonWorkbench_AssemblySheet", "Assembly sheet")
    tool_tip = QT_TRANSLATE_NOOP(
        "BalloonWorkbench_AssemblySheet",
        "Tell what the balloon takes and whether it floats, and write one page on how to make it",
    )

    def Activated(self):
        from BalloonWorkbench.gui.panels import show
        from BalloonWorkbench.gui.panels.making.assembly import AssemblyPanel

        show(AssemblyPanel(solved_parts()))


class Machines(Command):
    """Opens the panel on the user's own machines."""

    drawing = "machines"
    menu_text = QT_TRANSLATE_NOOP("BalloonWorkbench_Machines", "My machines")
    tool_tip = QT_TRANSLATE_NOOP(
        "BalloonWorkbench_Machines",
        "Set up cutters, lasers, sealers and printers of your own: bed, file format, kerf, knife and tool",
    )

    def Activated(self):
        from BalloonWorkbench.gui.panels import show_alone
        from BalloonWorkbench.gui.panels.making.machines import MachinesPanel

        show_alone(MachinesPanel())


class TestCard(Command):
    """Opens the panel that makes a test card, and keeps what came out of one."""

    drawing = "test_card"
    menu_text = QT_TRANSLATE_NOOP("BalloonWorkbench_TestCard", "Test card")
    tool_tip = QT_TRANSLATE_NOOP(
        "BalloonWorkbench_TestCard",
        "Find feed, power, temperature or depth of a tool for a film: weld or cut a card of fields",
    )

    def Activated(self):
        from BalloonWorkbench.gui.panels import show_alone
        from BalloonWorkbench.gui.panels.making.test_card import TestCardPanel

        show_alone(TestCardPanel())

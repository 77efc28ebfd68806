# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a finished balloon shows: advice, its flat pieces, results as colours, its inflation."""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui

from BalloonWorkbench.app.document import kinds
from BalloonWorkbench.app.document.parts import patterns
from BalloonWorkbench.app.properties.property_table import QT_TRANSLATE_NOOP
from BalloonWorkbench.gui.commands.command import (
    PatternCommand,
    ResultCommand,
    known_parts,
    selected_parts,
    solved_parts,
)
from BalloonWorkbench.gui.qt import translate
from BalloonWorkbench.gui.window.borders import undo_step


class AdviceCommand(PatternCommand):
    """Opens the panel of advice on the selected balloon."""

    drawing = "advice"
    menu_text = QT_TRANSLATE_NOOP("BalloonWorkbench_Advice", "Advice")
    tool_tip = QT_TRANSLATE_NOOP(
        "BalloonWorkbench_Advice",
        "Show which parts of a shape will inflate badly, and repair them",
    )

    def Activated(self):
        from BalloonWorkbench.gui.panels import show
        from BalloonWorkbench.gui.panels.results.advice import AdvicePanel

        for parts in (selected_parts() or known_parts())[:1]:
            show(AdvicePanel(parts))


class EditOutline(PatternCommand):
    """Opens a tab with the nodes of the selected balloon's outline."""

    drawing = "edit_outline"
    menu_text = QT_TRANSLATE_NOOP("BalloonWorkbench_EditOutline", "Edit outline")
    tool_tip = QT_TRANSLATE_NOOP(
        "BalloonWorkbench_EditOutline",
        "Move, add and remove nodes of the outline over its picture, and set how the picture is read",
    )

    def IsActive(self):
        return super().IsActive() and any(kinds.is_outline(parts.outline) for parts in known_parts())

    def Activated(self):
        from BalloonWorkbench.app.drawings.outline_edits import editable
        from BalloonWorkbench.gui.outline_editor.tab import open_tab

        drawn = [parts for parts in known_parts() if kinds.is_outline(parts.outline)]
        open_tab(editable((selected_parts() or drawn)[0].outline))


class PatternViewCommand(PatternCommand):
    """Opens a tab with the flat pieces of the selected pattern or sheet of film."""

    drawing = "pattern_view"
    menu_text = QT_TRANSLATE_NOOP("BalloonWorkbench_PatternView", "Pattern view")
    tool_tip = QT_TRANSLATE_NOOP(
        "BalloonWorkbench_PatternView",
        "Show all panels flat in a tab of their own: pick an edge to see its partner, and measure",
    )

    def Activated(self):
        from BalloonWorkbench.gui.pattern_view.tab import open_tab

        chosen = [*filter(kinds.is_film_sheet, Gui.Selection.getSelection())]
        chosen += [parts.pattern for parts in selected_parts()]
        open_tab((chosen or patterns(App.ActiveDocument))[0])


class ColourMapCommand(ResultCommand):
    """Opens the panel that chooses what is shown on the selected balloon."""

    drawing = "colour_map"
    menu_text = QT_TRANSLATE_NOOP("BalloonWorkbench_ColourMap", "Colour map")
    tool_tip = QT_TRANSLATE_NOOP(
        "BalloonWorkbench_ColourMap",
        "Show tension, wrinkles, thickness and other results as colours on the balloon",
    )

    def Activated(self):
        from BalloonWorkbench.gui.panels import show
        from BalloonWorkbench.gui.panels.results.colour_map import ColourMapPanel

        show(ColourMapPanel(solved_parts()))


class Animate(ResultCommand):
    """Opens the panel that plays the inflation of the selected balloon."""

    drawing = "animate"
    menu_text = QT_TRANSLATE_NOOP("BalloonWorkbench_Animate", "Animate inflation")
    tool_tip = QT_TRANSLATE_NOOP(
        "BalloonWorkbench_Animate",
        "Play how the balloon inflates, from the flat film to rest, with a slider",
    )

    def Activated(self):
        from BalloonWorkbench.gui.panels import show
        from BalloonWorkbench.gui.panels.results.animation import AnimationPanel

        show(AnimationPanel(solved_parts()))


class StudyCommand(ResultCommand):
    """Opens the selected study; makes one of the selected balloon where there is none."""

    drawing = "study"
    menu_text = QT_TRANSLATE_NOOP("BalloonWorkbench_Study", "Study")
    tool_tip = QT_TRANSLATE_NOOP(
        "BalloonWorkbench_Study",
        "Work out many variants of a balloon from a spreadsheet, and compare them",
    )

    def Activated(self):
        from BalloonWorkbench.app.studies import study
        from BalloonWorkbench.app.studies.varied import SHEET, VARIABLES
        from BalloonWorkbench.gui.panels import show
        from BalloonWorkbench.gui.panels.results.study import StudyPanel

        doc, selected = App.ActiveDocument, Gui.Selection.getSelection()
        chosen = next(filter(kinds.is_study, selected), None)
        variables, table = (
            next((obj for obj in selected if obj.TypeId == kind), None) for kind in (VARIABLES, SHEET)
        )
        with undo_step(doc, translate("Study")):
            if chosen is None:
                chosen = study.make(doc, solved_parts(), variables, table)
                doc.recompute()
            show(StudyPanel(chosen))


class ExportForWeb(ResultCommand):
    """Opens the panel that writes the selected balloon for others."""

    drawing = "share"
    menu_text = QT_TRANSLATE_NOOP("BalloonWorkbench_ExportForWeb", "Export for the web")
    tool_tip = QT_TRANSLATE_NOOP(
        "BalloonWorkbench_ExportForWeb",
        "Write the balloon with its artwork as a web page that turns it, as a 3D model or as a picture",
    )

    def Activated(self):
        from BalloonWorkbench.gui.panels import show
        from BalloonWorkbench.gui.panels.results.share import SharePanel

        show(SharePanel(solved_parts()))


class CompareCommand(ResultCommand):
    """Opens the panel that compares the selected balloon with a photograph."""

    drawing = "compare"
    menu_text = QT_TRANSLATE_NOOP("BalloonWorkbench_Compare", "Compare with a photograph")
    tool_tip = QT_TRANSLATE_NOOP(
        "BalloonWorkbench_Compare",
        "Lay a photograph of the finished balloon over the simulated one, and see how near it came",
    )

    def Activated(self):
        from BalloonWorkbench.gui.panels import show
        from BalloonWorkbench.gui.panels.results.comparison import ComparisonPanel

        show(ComparisonPanel(solved_parts()))

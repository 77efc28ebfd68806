# SPDX-License-Identifier: LGPL-2.1-or-later
"""New balloons: painted, from a drawing file, from a sketch, of gores, of panels, from a body."""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui

from BalloonWorkbench.app.properties.property_table import QT_TRANSLATE_NOOP
from BalloonWorkbench.gui.commands.command import Command
from BalloonWorkbench.gui.qt import translate
from BalloonWorkbench.gui.window.borders import undo_step


class Paint(Command):
    """Opens the paint window."""

    drawing = "paint"
    menu_text = QT_TRANSLATE_NOOP("BalloonWorkbench_Paint", "Paint a balloon")
    tool_tip = QT_TRANSLATE_NOOP(
        "BalloonWorkbench_Paint",
        "Draw with pen and brush, and watch the balloon and its pattern grow beside it",
    )

    def Activated(self):
        from BalloonWorkbench.gui.paint.window import open_for

        open_for(App.ActiveDocument or App.newDocument("Balloon"))


class FromPicture(Command):
    """Asks for a file, makes the objects of its balloon and opens their panel."""

    drawing = "from_picture"
    menu_text = QT_TRANSLATE_NOOP("BalloonWorkbench_FromPicture", "New balloon from picture")
    tool_tip = QT_TRANSLATE_NOOP(
        "BalloonWorkbench_FromPicture",
        "Trace a picture, SVG, DXF or JSON file and design the balloon that looks like it",
    )

    def Activated(self):
        from BalloonWorkbench.gui.panels import show
        from BalloonWorkbench.gui.panels.balloon.balloon_panel import BalloonPanel
        from BalloonWorkbench.gui.window import file_dialogs, macro_recorder

        path = file_dialogs.ask_for_drawing(Gui.getMainWindow())
        if path is None:
            return
        doc = App.ActiveDocument
        fresh = doc is None
        if fresh:
            doc = App.newDocument("Balloon")
        with undo_step(doc, translate("New balloon from picture")):
            parts, edit = macro_recorder.begin(doc)
            panel = BalloonPanel(parts, new_document=fresh, edit=edit)
            show(panel)
        if path:
            panel.begin_with(path)


class FromSketch(Command):
    """Makes the objects of a balloon, links the selected sketch and opens their panel."""

    drawing = "from_sketch"
    menu_text = QT_TRANSLATE_NOOP("BalloonWorkbench_FromSketch", "New balloon from sketch")
    tool_tip = QT_TRANSLATE_NOOP(
        "BalloonWorkbench_FromSketch",
        "Design the balloon that looks like the selected sketch, wire or face and follows it",
    )

    def IsActive(self):
        return App.ActiveDocument is not None and super().IsActive()

    def Activated(self):
        from BalloonWorkbench.app.group import name_group
        from BalloonWorkbench.gui.panels import show
        from BalloonWorkbench.gui.panels.balloon.balloon_panel import BalloonPanel
        from BalloonWorkbench.gui.window import macro_recorder
        from BalloonWorkbench.gui.window.selection import selected_source

        source = selected_source()
        doc = App.ActiveDocument
        with undo_step(doc, translate("New balloon from sketch")):
            parts, edit = macro_recorder.begin(doc)
            if source is not None:
                parts.outline.Source = source
                name_group(parts.balloon.getParentGroup(), f"{source[0].Label} balloon")
                _hide_sketch(source[0])
            show(BalloonPanel(parts, sketch=True, edit=edit))


class FromProfile(Command):
    """Makes the objects of a body of gores, links the selected sketch and opens their panel."""

    drawing = "from_profile"
    menu_text = QT_TRANSLATE_NOOP("BalloonWorkbench_FromProfile", "New body of gores")
    tool_tip = QT_TRANSLATE_NOOP(
        "BalloonWorkbench_FromProfile",
        "Design the gores of a ball, an airship or another round body from half its outline",
    )

    def Activated(self):
        from BalloonWorkbench.app.group import GORED_BODY, name_group
        from BalloonWorkbench.gui.window.selection import selected_source

        source = selected_source() if App.ActiveDocument is not None else None

        def take(parts):
            if source is not None:
                parts.outline.Source = source
                name_group(parts.balloon.getParentGroup(), f"{source[0].Label} body")
                _hide_sketch(source[0])

        _begin(translate("New body of gores"), GORED_BODY, take)


class FromPanels(Command):
    """Makes the objects of a bag of the selected sketches and faces, and opens their panel."""

    drawing = "from_panels"
    menu_text = QT_TRANSLATE_NOOP("BalloonWorkbench_FromPanels", "New bag of panels")
    tool_tip = QT_TRANSLATE_NOOP(
        "BalloonWorkbench_FromPanels",
        "Seal flat panels along their edges: selected sketches and faces, a ready body or a file",
    )

    def Activated(self):
        from BalloonWorkbench.app.bag import set_panels
        from BalloonWorkbench.app.group import BAG, name_group
        from BalloonWorkbench.gui.window.selection import selected_panels

        chosen = selected_panels() if App.ActiveDocument is not None else []

        def take(parts):
            if chosen:
                set_panels(parts.outline, chosen)
                name_group(parts.balloon.getParentGroup(), f"{chosen[0][0].Label} bag")
                for panel, _faces in chosen:
                    _hide_sketch(panel)

        _begin(translate("New bag of panels"), BAG, take)


class FromBody(Command):
    """Makes the objects of a balloon that fills the selected solid or mesh, and opens their panel."""

    drawing = "from_body"
    menu_text = QT_TRANSLATE_NOOP("BalloonWorkbench_FromBody", "New balloon from body")
    tool_tip = QT_TRANSLATE_NOOP(
        "BalloonWorkbench_FromBody",
        "Find the panels of a balloon that fills the selected solid or mesh",
    )

    def Activated(self):
        from BalloonWorkbench.app.group import TARGET, name_group
        from BalloonWorkbench.gui.window.selection import selected_body

        body = selected_body() if App.ActiveDocument is not None else None

        def take(parts):
            if body is not None:
                parts.outline.Solid = body
                name_group(parts.balloon.getParentGroup(), f"{body.Label} balloon")

        _begin(translate("New balloon from body"), TARGET, take)


def _hide_sketch(source) -> None:
    """A sketch is shown by what follows it."""
    if source.isDerivedFrom("Sketcher::SketchObject"):
        source.ViewObject.Visibility = False


def _begin(title: str, kind: str, take) -> None:
    """The objects of a new balloon of this kind, with what `take` gives them, and their panel."""
    from BalloonWorkbench.gui.panels import show
    from BalloonWorkbench.gui.panels.balloon.balloon_panel import BalloonPanel
    from BalloonWorkbench.gui.window import macro_recorder

    fresh = App.ActiveDocument is None
    doc = App.newDocument("Balloon") if fresh else App.ActiveDocument
    with undo_step(doc, title):
        parts, edit = macro_recorder.begin(doc, title, kind)
        take(parts)
        show(BalloonPanel(parts, new_document=fresh, edit=edit))

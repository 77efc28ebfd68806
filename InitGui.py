# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD runs this inside a function: what a method needs, it imports itself."""

import FreeCADGui as Gui


class BalloonWorkbench(Gui.Workbench):
    """Film Balloon: from a drawing to an inflated balloon and its pattern."""

    MenuText = "Film Balloon"
    ToolTip = "Design balloons from film that does not stretch"

    def __init__(self):
        from BalloonWorkbench.gui.qt import icon

        self.__class__.Icon = icon("workbench")

    def Initialize(self):
        from BalloonWorkbench.gui import commands, equipment

        toolbar, menu = commands.register()
        self.appendToolbar("Film Balloon", toolbar)
        self.appendMenu("Film &Balloon", menu)
        equipment.tell_missing()

    def GetClassName(self):
        return "Gui::PythonWorkbench"


def _plug_in():
    """Let the document objects use the window."""
    from BalloonWorkbench.app import hooks
    from BalloonWorkbench.gui import patience, view

    hooks.dress = view.dress
    hooks.progress = patience.progress


_plug_in()
Gui.addWorkbench(BalloonWorkbench())

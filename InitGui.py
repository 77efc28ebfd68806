# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD runs this inside a function: what a method needs, it imports itself."""

import FreeCADGui as Gui


class BalloonWorkbench(Gui.Workbench):
    """Film Balloon: from a drawing to an inflated balloon and its pattern."""

    MenuText = "Film Balloon"
    ToolTip = "Design balloons from film that does not stretch"

    def __init__(self):
        from BalloonWorkbench.gui.qt import icon, translate

        self.__class__.Icon = icon("workbench")
        self.__class__.MenuText = translate("Film Balloon", "Workbench")
        self.__class__.ToolTip = translate("Design balloons from film that does not stretch", "Workbench")

    def Initialize(self):
        from BalloonWorkbench.app.properties.property_table import QT_TRANSLATE_NOOP
        from BalloonWorkbench.gui import commands
        from BalloonWorkbench.gui.paint.preview import preload
        from BalloonWorkbench.gui.window import equipment, native_offer

        toolbar, menu = commands.register()
        self.appendToolbar(QT_TRANSLATE_NOOP("Workbench", "Film Balloon"), toolbar)
        self.appendMenu(QT_TRANSLATE_NOOP("Workbench", "Film &Balloon"), menu)
        equipment.report_missing()
        native_offer.offer()
        preload.begin()

    def GetClassName(self):
        return "Gui::PythonWorkbench"


def _plug_in():
    """Let the document objects use the window."""
    from BalloonWorkbench.app.border import hooks
    from BalloonWorkbench.gui import attach_view, qt
    from BalloonWorkbench.gui.long_work import blocking
    from BalloonWorkbench.gui.window import borders, preferences_page, sentences

    hooks.attach_view = attach_view.attach_view
    hooks.run_blocking = blocking.run_blocking
    hooks.say = sentences.translated
    hooks.language = sentences.language
    hooks.show_error = borders.show_error
    borders.watch()
    Gui.addIconPath(qt.ICONS)
    Gui.addLanguagePath(str(qt.TRANSLATIONS))
    Gui.updateLocale()
    Gui.addPreferencePage(preferences_page.PreferencesPage, "Film Balloon")


_plug_in()
Gui.addWorkbench(BalloonWorkbench())

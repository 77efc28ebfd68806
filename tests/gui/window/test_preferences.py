# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page in FreeCAD's preferences, in its real dialog."""

import FreeCAD as App
import FreeCADGui as Gui
import hands
import pytest

from BalloonWorkbench.app.properties import preferences
from BalloonWorkbench.gui.window.preferences_page import PreferencesPage


@pytest.fixture(autouse=True)
def no_dialog():
    """The dialog of the preferences is one that stands in front."""


@pytest.fixture(autouse=True)
def usual():
    group = App.ParamGet(preferences.PATH)
    group.Clear()
    yield
    group.Clear()


def in_dialog(act):
    """Open the preferences at our page, act, and return what the action returned."""
    told = []
    timer = hands.QtCore.QTimer()

    def run():
        dialogs = [
            widget
            for widget in hands.QtWidgets.QApplication.topLevelWidgets()
            if widget.isVisible() and widget.inherits("Gui::Dialog::DlgPreferencesImp")
        ]
        if not dialogs:
            return
        timer.stop()
        hands.wait(0.3)
        try:
            told.append(act(dialogs[0]))
        finally:
            dialogs[0].reject()

    timer.timeout.connect(run)
    timer.start(200)
    Gui.showPreferences("Film Balloon", 0)
    hands.wait_until(lambda: bool(told))
    return told[0]


def test_page_is_in_the_dialog():
    def look(dialog):
        pages = dialog.findChildren(hands.QtWidgets.QWidget, "BalloonPreferences")
        hands.screenshot("preferences")
        return [page.isVisible() for page in pages]

    assert in_dialog(look) == [True]


def test_dialog_keeps_what_is_chosen():
    def choose(dialog):
        film = dialog.findChild(hands.QtWidgets.QComboBox, "PreferredFilm")
        film.setCurrentIndex(film.findData("pvc"))
        live = dialog.findChild(hands.QtWidgets.QCheckBox, "PreferredLive")
        live.setChecked(False)
        hands.type_into(dialog.findChild(hands.QtWidgets.QAbstractSpinBox, "PreferredWidth"), "25 cm")
        dialog.accept()

    in_dialog(choose)
    assert preferences.get("Film") == "pvc"
    assert preferences.get("Width") == pytest.approx(250.0)
    assert preferences.get("Live") is False
    assert preferences.get("Pressure") == pytest.approx(2.0)


def test_page_shows_what_is_kept():
    preferences.put("Machine", "paper")
    preferences.put("ExportFolder", "/somewhere")
    preferences.put("Allowance", 3.0)
    page = PreferencesPage()
    page.loadSettings()
    assert page.form.findChild(hands.QtWidgets.QComboBox, "PreferredMachine").currentData() == "paper"
    assert page.form.findChild(hands.QtWidgets.QLineEdit, "PreferredExportFolder").text() == "/somewhere"
    page.saveSettings()
    assert preferences.get("Allowance") == pytest.approx(3.0)
    assert preferences.get("Width") == pytest.approx(300.0)
    page.form.deleteLater()


def test_new_balloon_begins_with_them():
    preferences.put("Film", "pe")
    preferences.put("Width", 180.0)
    Gui.runCommand("BalloonWorkbench_FromPicture")
    hands.wait_until(hands.panel_is_seen)
    assert hands.find("Film").currentData() == "pe"
    assert hands.find("Width").property("rawValue") == pytest.approx(180.0)
    hands.press("Cancel")


def test_page_has_an_icon():
    from PySide import QtSvg

    import BalloonWorkbench
    from BalloonWorkbench.gui.qt import icon

    assert BalloonWorkbench
    assert QtSvg.QSvgRenderer(icon("preferences-film_balloon")).isValid()

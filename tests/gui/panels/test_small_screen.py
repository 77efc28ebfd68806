# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every panel on a screen of 1366 x 768: nothing is cut off, one bar scrolls at most.

In German, whose words are long; in others too with their names in BALLOON_LANGUAGES, between commas.
"""

import os

import cut_off
import FreeCADGui as Gui
import hands
import pytest

from BalloonWorkbench.app.properties import preferences
from BalloonWorkbench.core.machines.machine import machines
from BalloonWorkbench.gui.window.preferences_page import PreferencesPage

QtCore, QtWidgets = hands.QtCore, hands.QtWidgets

LANGUAGES = os.environ.get("BALLOON_LANGUAGES", "German").split(",")


@pytest.fixture
def small():
    """The main window as on a small screen."""
    window = Gui.getMainWindow()
    before, maximized = window.geometry(), window.isMaximized()
    window.showNormal()
    window.setGeometry(0, 0, 1366, 768)
    hands.wait(0.3)
    yield window
    window.setGeometry(before)
    if maximized:
        window.showMaximized()
    hands.wait(0.1)


@pytest.fixture
def speak():
    def change(language):
        Gui.setLocale(language)
        hands.wait(0.3)

    yield change
    change("English")


def look(name):
    """The faults of the open panel."""
    hands.wait(0.2)
    hands.screenshot(f"small-{name}")
    (row,) = hands.panel_buttons()
    (dock,) = [each for each in hands.visible(QtWidgets.QDockWidget) if each.isAncestorOf(row)]
    found = [*cut_off.faults(dock), *cut_off.buttons_off_screen(Gui.getMainWindow())]
    return [f"{name}: {line}" for line in found]


@pytest.mark.parametrize("language", LANGUAGES)
def test_panel_of_a_balloon(small, speak, made, language):
    speak(language)
    made.balloon.ViewObject.Proxy.doubleClicked(made.balloon.ViewObject)
    hands.wait_until(hands.panel_is_seen)
    hands.wait(1.0)  # the maker's numbers come from a thread
    tabs, told = hands.find("Steps"), []
    for page in range(tabs.count()):
        tabs.setCurrentIndex(page)
        hands.wait(0.1)
        told += look(f"balloon-{page}-{language}")
    assert not told, "\n".join(told)


@pytest.mark.parametrize("language", LANGUAGES)
def test_panel_of_a_picture(small, speak, doc, language):
    speak(language)
    Gui.runCommand("BalloonWorkbench_FromPicture")
    hands.wait_until(hands.panel_is_seen)
    told = look(f"picture-{language}")
    hands.press("Cancel")
    assert not told, "\n".join(told)


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize(("command", "entry"), [("FromProfile", 1), ("FromPanels", 6)])
def test_panels_of_many_panels(small, speak, doc, language, command, entry):
    """A natural shape, and a pouch with its seams."""
    speak(language)
    Gui.runCommand(f"BalloonWorkbench_{command}")
    hands.wait_until(hands.panel_is_seen)
    doc.Balloon.Live = False
    told = look(f"{command}-empty-{language}")
    combo = hands.find("ProfileFrom" if command == "FromProfile" else "Ready")
    hands.choose(combo, combo.itemText(entry))
    told += look(f"{command}-{language}")
    hands.press("Cancel")
    assert not told, "\n".join(told)


@pytest.mark.parametrize("language", LANGUAGES)
def test_panel_of_a_body(small, speak, doc, language):
    """Without one, and with one that has the most to say: a ball, whose face is curved both ways."""
    speak(language)
    ball = doc.addObject("Part::Sphere", "Ball")
    doc.recompute()
    Gui.runCommand("BalloonWorkbench_FromBody")
    hands.wait_until(hands.panel_is_seen)
    doc.Balloon.Live = False
    told = look(f"FromBody-empty-{language}")
    Gui.Selection.addSelection(ball)
    hands.wait_until(lambda: hands.find("BodyNotes").text())
    told += look(f"FromBody-{language}")
    hands.press("Cancel")
    assert not told, "\n".join(told)


@pytest.fixture
def tiny_bed():
    """The machine of the export panel has one: its panel has the most to say then."""
    machine = machines()["any-dxf"]
    preferences.put_bed(machine, (0.05, 0.05))
    yield
    preferences.put_bed(machine, None)


COMMANDS = (
    "ExportPattern",
    "Advice",
    "Artwork",
    "Nest",
    "Study",
    "AssemblySheet",
    "ExportForWeb",
    "ColourMap",
    "Animate",
    "Compare",
    "Machines",
    "TestCard",
    "Equipment",
)


@pytest.mark.parametrize("language", LANGUAGES)
def test_other_panels(small, speak, made, tiny_bed, language):
    speak(language)
    told = []
    for command in COMMANDS:
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(made.balloon)
        Gui.runCommand(f"BalloonWorkbench_{command}")
        hands.wait_until(hands.panel_is_seen)
        hands.wait(0.5)
        told += look(f"{command}-{language}")
        hands.leave()
        hands.wait_until(hands.panel_is_closed)
    assert not told, "\n".join(told)


@pytest.mark.parametrize("language", LANGUAGES)
def test_page_of_the_preferences(speak, language):
    """As large as the dialog has room for a page on a small screen."""
    speak(language)
    page = PreferencesPage()
    page.loadSettings()
    page.form.resize(700, 560)
    page.form.show()
    hands.wait(0.1)
    told = cut_off.faults(page.form)
    needed = page.form.minimumSizeHint()
    page.form.hide()
    page.form.deleteLater()
    assert not told, "\n".join(told)
    assert (needed.width(), needed.height()) <= (700, 560)

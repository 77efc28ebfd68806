# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every panel on a screen of 1366 x 768: nothing is cut off, one bar scrolls at most.

In German, whose words are long, and in a longer language from right to left (pseudo.py); in others with their
names in BALLOON_LANGUAGES, between commas, among them Pseudo.
"""

import os
from contextlib import ExitStack

import cut_off
import every_panel
import FreeCADGui as Gui
import hands
import pseudo
import pytest

from BalloonWorkbench.app.properties import preferences
from BalloonWorkbench.core.machines.machine import machines

LANGUAGES = os.environ.get("BALLOON_LANGUAGES", "German,Mirrored").split(",")


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
    with ExitStack() as languages:

        def change(language):
            if language in pseudo.KINDS:
                languages.enter_context(pseudo.spoken(language))
            else:
                Gui.setLocale(language)
            hands.wait(0.3)

        yield change
    Gui.setLocale("English")
    hands.wait(0.3)


def look(panels, language):
    """The faults of panels as they are opened."""
    told = []
    for name in panels:
        hands.wait(0.2)
        hands.screenshot(f"small-{name}-{language}")
        found = [*cut_off.faults(every_panel.dock()), *cut_off.buttons_off_screen(Gui.getMainWindow())]
        told += [f"{name}: {line}" for line in found]
    return told


@pytest.mark.slow
@pytest.mark.parametrize("language", LANGUAGES)
def test_panel_of_a_balloon(small, speak, made, language):
    speak(language)
    told = look(every_panel.balloon(made), language)
    assert not told, "\n".join(told)


@pytest.mark.parametrize("language", LANGUAGES)
def test_panel_of_a_picture(small, speak, doc, language):
    speak(language)
    told = look(every_panel.picture(doc), language)
    assert not told, "\n".join(told)


@pytest.mark.slow
@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize(("command", "entry"), [("FromProfile", 1), ("FromPanels", 6)])
def test_panels_of_many_panels(small, speak, doc, language, command, entry):
    speak(language)
    told = look(every_panel.many_panels(doc, command, entry), language)
    assert not told, "\n".join(told)


@pytest.mark.slow
@pytest.mark.parametrize("language", LANGUAGES)
def test_panel_of_a_body(small, speak, doc, language):
    speak(language)
    told = look(every_panel.body(doc), language)
    assert not told, "\n".join(told)


@pytest.fixture
def tiny_bed():
    """The machine of the export panel has one: its panel has the most to say then."""
    machine = machines()["any-dxf"]
    preferences.put_bed(machine, (0.05, 0.05))
    yield
    preferences.put_bed(machine, None)


@pytest.mark.slow
@pytest.mark.parametrize("language", LANGUAGES)
def test_other_panels(small, speak, made, tiny_bed, language):
    speak(language)
    told = look(every_panel.others(made), language)
    assert not told, "\n".join(told)


@pytest.mark.parametrize("language", LANGUAGES)
def test_form_of_a_copied_machine(small, speak, doc, language):
    speak(language)
    told = look(every_panel.copied_machine(doc), language)
    assert not told, "\n".join(told)


@pytest.mark.parametrize("language", LANGUAGES)
def test_page_of_the_preferences(speak, language):
    speak(language)
    for form in every_panel.preferences_page():
        told, needed = cut_off.faults(form), form.minimumSizeHint()
    assert not told, "\n".join(told)
    assert (needed.width(), needed.height()) <= (700, 560)

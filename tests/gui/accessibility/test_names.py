# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every widget of every panel has a name for a screen reader, and Tab comes to it in reading order."""

import importlib
import pkgutil

import accessible
import every_panel
import hands
import pytest
from hands import QtWidgets

from BalloonWorkbench import gui
from BalloonWorkbench.gui.window.borders import TaskPanel

Qt = hands.QtCore.Qt

pytestmark = pytest.mark.usefixtures("without_figures")


def look(names):
    told = []
    for name in names:
        told += [f"{name}: {line}" for line in accessible.faults(every_panel.dock())]
    return told


def test_panel_of_a_balloon(made):
    told = look(every_panel.balloon(made))
    assert not told, "\n".join(told)


@pytest.mark.slow
def test_panels_of_new_balloons(doc):
    told = [
        *look(every_panel.picture(doc)),
        *look(every_panel.many_panels(doc, "FromProfile", 1)),
        *look(every_panel.many_panels(doc, "FromPanels", 6)),
        *look(every_panel.body(doc)),
        *look(every_panel.copied_machine(doc)),
    ]
    assert not told, "\n".join(told)


@pytest.mark.slow
def test_other_panels(made):
    told = look(every_panel.others(made))
    assert not told, "\n".join(told)


def subclasses(kind):
    """All classes of a kind that are no base of others."""
    own = kind.__subclasses__()
    return set().union(*map(subclasses, own)) if own else {kind}


def test_every_panel_was_looked_at(request):
    """A new one has its line in every_panel.py: then its names, keys, words and colours are looked at."""
    if not {"test_panels_of_new_balloons", "test_other_panels"} <= {
        each.originalname for each in request.session.items
    }:
        pytest.skip("not all of this file is run")
    for module in pkgutil.walk_packages(gui.__path__, f"{gui.__name__}."):
        importlib.import_module(module.name)
    assert subclasses(TaskPanel) == every_panel.looked_at


def test_page_of_the_preferences():
    told = [line for form in every_panel.preferences_page() for line in accessible.faults(form)]
    assert not told, "\n".join(told)


def test_pattern_view(made):
    told = [line for tab in every_panel.pattern_view(made) for line in accessible.faults(tab)]
    assert not told, "\n".join(told)


@pytest.mark.slow
def test_outline_editor(doc, tmp_path):
    """Tab goes to the next node in it: F6 leaves the view, and comes to its buttons with Tab."""
    told = []
    for tab in every_panel.outline_editor(doc, tmp_path):
        told += accessible.faults(tab)
        tab.view.setFocus()
        hands.key(tab.view, Qt.Key_Tab, "\t")
        assert tab.view.hasFocus()
        for held in (Qt.NoModifier, Qt.ShiftModifier):
            tab.view.setFocus()
            hands.key(tab.view, Qt.Key_F6, "", held)
            assert not tab.view.hasFocus()
    assert not told, "\n".join(told)


def test_painting(doc):
    told = []
    for window in every_panel.painting():
        told += accessible.faults(window.canvas.window().findChild(QtWidgets.QDockWidget, "BalloonPaint"))
    assert not told, "\n".join(told)

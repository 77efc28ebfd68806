# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closing paint windows gives the panels beside them their width back, whatever was done."""

import FreeCADGui as Gui
import hands
import pytest
from brush import close_window, open_window, press
from hands import QtCore, QtWidgets

from BalloonWorkbench.gui.paint import window as paint_window


def _width():
    """The widest, which is in front: those behind it do not follow."""
    main = Gui.getMainWindow()
    docks = [dock for dock in hands.visible(QtWidgets.QDockWidget) if not dock.isFloating()]
    left = [dock.width() for dock in docks if main.dockWidgetArea(dock) == QtCore.Qt.LeftDockWidgetArea]
    return max(left, default=0)


@pytest.fixture(autouse=True)
def width_given_back(workbench):
    hands.wait(0.05)
    before = _width()
    yield
    while paint_window._open:
        close_window()
    hands.wait(0.3)
    assert not before or _width() <= before + 40  # px, what a task panel may need


@pytest.fixture
def window(doc):
    """The paint window with all its tools."""
    opened = open_window()
    press("PaintMore")
    yield opened
    close_window()

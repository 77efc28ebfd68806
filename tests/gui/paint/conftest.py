# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closing paint windows gives the panels beside them their width back, whatever was done."""

import FreeCADGui as Gui
import hands
import pytest
from brush import close_window
from hands import QtCore, QtWidgets

from BalloonWorkbench.gui.paint import window as paint_window


def _widths():
    main = Gui.getMainWindow()
    docks = [dock for dock in hands.visible(QtWidgets.QDockWidget) if not dock.isFloating()]
    return {
        dock.objectName(): dock.width()
        for dock in docks
        if main.dockWidgetArea(dock) == QtCore.Qt.LeftDockWidgetArea
    }


@pytest.fixture(autouse=True)
def widths_given_back(workbench):
    hands.wait(0.05)
    before = _widths()
    yield
    while paint_window._open:
        close_window()
    hands.wait(0.1)
    after = _widths()
    assert {name: width for name, width in after.items() if width > before.get(name, width) + 2} == {}

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tabs that show an object of a document: one for each object, with a line that tells what goes on."""

from __future__ import annotations

from collections.abc import Callable

import FreeCADGui as Gui

from BalloonWorkbench.gui.qt import QtCore, QtWidgets, drawn_icon


def tab_of(obj, tabs: list, make: Callable, icon: str):
    """The tab of an object among `tabs`, in front; made where there is none. It has `obj` and a `view`."""
    area = Gui.getMainWindow().findChild(QtWidgets.QMdiArea)
    tab = next((each for each in tabs if each.obj == obj), None)
    if tab is None:
        tab = make(obj)
        tabs.append(tab)
        frame = area.addSubWindow(tab)
        frame.setAttribute(QtCore.Qt.WA_DeleteOnClose)
        frame.setWindowIcon(drawn_icon(icon))
        frame.showMaximized()
    area.setActiveSubWindow(tab.parentWidget())
    tab.view.setFocus()
    return tab


def telling_line(name: str):
    """A line of text below a tab that can be copied."""
    line = QtWidgets.QLabel()
    line.setObjectName(name)
    line.setWordWrap(True)
    line.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
    return line


def column_in(tab):
    """The rows of a tab, without room between them."""
    column = QtWidgets.QVBoxLayout(tab)
    column.setContentsMargins(0, 0, 0, 0)
    column.setSpacing(0)
    return column

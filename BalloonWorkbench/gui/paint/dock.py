# SPDX-License-Identifier: LGPL-2.1-or-later
"""The frame of the paint window: it takes the left half of FreeCAD's window, and gives the room back."""

from __future__ import annotations

from itertools import pairwise
from time import monotonic

import FreeCADGui as Gui

from BalloonWorkbench.gui.qt import QtCore, QtWidgets, drawn_icon
from BalloonWorkbench.gui.window.overlays import EmptyTasks

_SHARE = 0.5  # of the main window
_NARROW = 150  # px, of a panel beside it
_SETTLES = 1.0  # s until Qt has moved the panels: what they measure before is not their width


class _Neighbours:
    """The panels at the left, narrow while a paint window is beside them. The windows share them."""

    def __init__(self) -> None:
        self._widths: dict[QtWidgets.QDockWidget, int] = {}
        self._is_narrow = False
        self._given_back = -_SETTLES

    def narrow(self, main, window) -> dict:
        """The width of each beside a window; how wide it is without is remembered."""
        if not self._is_narrow and monotonic() - self._given_back > _SETTLES:
            self._widths = {
                dock: dock.width()
                for dock in main.findChildren(QtWidgets.QDockWidget)
                if dock is not window
                and dock.isVisible()
                and main.dockWidgetArea(dock) == QtCore.Qt.LeftDockWidgetArea
            }
        self._is_narrow = True
        return {dock: min(width, _NARROW) for dock, width in self._widths.items()}

    def give_back(self, main) -> None:
        """They are as wide as before."""
        docks = [dock for dock in self._widths if dock.isVisible()]
        if self._is_narrow and docks:
            main.resizeDocks(docks, [self._widths[dock] for dock in docks], QtCore.Qt.Horizontal)
        self._is_narrow = False
        self._given_back = monotonic()


_neighbours = _Neighbours()


class PaintDock(QtWidgets.QDockWidget):
    """A dock widget with tools at the left, a bar above, a canvas and a form below.

    `leave` is called whenever it closes; `finish` closes it for good.
    """

    def __init__(self, title: str):
        super().__init__(title, Gui.getMainWindow())
        self.setObjectName("BalloonPaint")
        self.setWindowIcon(drawn_icon("paint"))
        self._tasks = EmptyTasks(self, self.isVisible)
        self._closed = QtCore.QTimer(self)
        self._closed.setSingleShot(True)
        self._closed.timeout.connect(self.give_back)

    def fill(self, above, left, canvas, below) -> None:
        """Put the widgets in their places."""
        body = QtWidgets.QWidget()
        room = QtWidgets.QGridLayout(body)
        room.setContentsMargins(4, 4, 4, 4)
        room.addWidget(above, 0, 0, 1, 2)
        room.addWidget(left, 1, 0)
        room.addWidget(canvas, 1, 1)
        room.addWidget(below, 2, 0, 1, 2)
        room.setColumnStretch(1, 1)
        room.setRowStretch(1, 1)
        self.setWidget(body)
        stops = [stop for part in (above, left, canvas, below) for stop in _focusable(part)]
        for one, other in pairwise(stops):
            QtWidgets.QWidget.setTabOrder(one, other)

    def reveal(self) -> None:
        """Show it; the panels beside it become narrow."""
        main = Gui.getMainWindow()
        if self.parent() is None or main.dockWidgetArea(self) == QtCore.Qt.NoDockWidgetArea:
            main.addDockWidget(QtCore.Qt.LeftDockWidgetArea, self, QtCore.Qt.Horizontal)
        self._closed.stop()
        narrow = _neighbours.narrow(main, self)
        self.show()
        self.raise_()
        self._tasks.start()
        width = min(int(_SHARE * main.width()), self._free_room(main, narrow))
        main.resizeDocks([*narrow, self], [*narrow.values(), width], QtCore.Qt.Horizontal)

    def _free_room(self, main, narrow) -> int:
        """The width up to the panels that FreeCAD 1.1 lays over its 3D view: they would take the mouse."""
        floating = main.findChild(QtWidgets.QWidget, "OverlayRight")
        if floating is None or not floating.isVisible() or floating.size().isEmpty():
            return main.width()
        separator = main.style().pixelMetric(QtWidgets.QStyle.PM_DockWidgetSeparatorExtent, None, main)
        columns = {dock.x(): width for dock, width in narrow.items()}
        return floating.x() - sum(width + separator for width in columns.values())

    def closeEvent(self, event):
        """Put aside; the painting is kept for the next time."""
        self.leave()
        super().closeEvent(event)
        self._closed.start(0)

    def leave(self) -> None:
        """What a window does when it closes."""

    def finish(self) -> None:
        """Close for good."""
        Gui.getMainWindow().removeDockWidget(self)
        self.give_back()
        self.deleteLater()

    def give_back(self) -> None:
        """The panels beside it are as wide as before, and the 3D view has the room."""
        self._closed.stop()
        self._tasks.stop()
        main = Gui.getMainWindow()
        windows = main.findChildren(QtWidgets.QDockWidget, self.objectName())
        if not any(window.isVisible() for window in windows):  # none has taken its place
            _neighbours.give_back(main)


def _focusable(part) -> list:
    """What the key Tab goes to in a part of the window, in its order; the canvas is one.

    Of tools of which one is down, Qt takes that alone: it is another one later.
    """
    return [
        each
        for each in (part, *part.findChildren(QtWidgets.QWidget))
        if each.window() is part.window()  # not in a list that opens
        and (isinstance(each, QtWidgets.QAbstractButton) or each.focusPolicy() & QtCore.Qt.TabFocus)
    ]

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The frame of the paint window: it takes the left half of FreeCAD's window, and gives the room back."""

from __future__ import annotations

from functools import partial
from typing import ClassVar

import FreeCADGui as Gui

from BalloonWorkbench.gui.qt import QtCore, QtWidgets, drawn_icon
from BalloonWorkbench.gui.view3d.fit_view import OVERLAYS

_SHARE = 0.5  # of the main window
_NARROW = 150  # px, of a panel beside it
_LOOKS = 300  # ms between looks at what FreeCAD has laid over its 3D view


class PaintDock(QtWidgets.QDockWidget):
    """A dock widget with tools at the left, a bar above, a canvas and a form below.

    `leave` is called whenever it closes; `finish` closes it for good.
    """

    #: The panels beside it, and how wide they were. One window may take the place of another: all share them.
    _neighbours: ClassVar[list[tuple[QtWidgets.QDockWidget, int]]] = []

    def __init__(self, title: str):
        super().__init__(title, Gui.getMainWindow())
        self.setObjectName("BalloonPaint")
        self.setWindowIcon(drawn_icon("paint"))
        self._laid_aside: list = []
        self._watch = QtCore.QTimer(self)
        self._watch.setInterval(_LOOKS)
        self._watch.timeout.connect(self._mind_overlays)
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

    def reveal(self) -> None:
        """Show it; the panels beside it become narrow."""
        main = Gui.getMainWindow()
        if self.parent() is None or main.dockWidgetArea(self) == QtCore.Qt.NoDockWidgetArea:
            main.addDockWidget(QtCore.Qt.LeftDockWidgetArea, self, QtCore.Qt.Horizontal)
        self._closed.stop()
        if not self._neighbours:  # those that were made narrow before are still to be given back
            others = [dock for dock in main.findChildren(QtWidgets.QDockWidget) if dock.isVisible()]
            self._neighbours += [
                (dock, dock.width())
                for dock in others
                if dock is not self and main.dockWidgetArea(dock) == QtCore.Qt.LeftDockWidgetArea
            ]
        self.show()
        self.raise_()
        self._mind_overlays()
        self._watch.start()
        narrow = {dock: min(width, _NARROW) for dock, width in self._neighbours}
        width = min(int(_SHARE * main.width()), self._free_room(main))
        main.resizeDocks([*narrow, self], [*narrow.values(), width], QtCore.Qt.Horizontal)

    def _mind_overlays(self) -> None:
        """FreeCAD 1.1 lays its task panel over the 3D view: an empty one is a strip over the balloon.

        It comes with the first 3D view, a moment after this window.
        """
        if Gui.Control.activeDialog():
            self._put_back()
        else:
            self._lay_aside(Gui.getMainWindow())

    def _lay_aside(self, main) -> None:
        """FreeCAD shows again at once what is hidden, so an empty task panel has no size for a while."""
        for overlay in map(partial(main.findChild, QtWidgets.QWidget), OVERLAYS):
            if overlay is None or not overlay.isVisible() or overlay.size().isEmpty():
                continue
            names = [dock.objectName() for dock in overlay.findChildren(QtWidgets.QDockWidget)]
            if names == ["Tasks"]:
                self._laid_aside.append((overlay, overlay.geometry(), overlay.maximumSize()))
                overlay.setMaximumSize(0, 0)

    def _put_back(self) -> None:
        for overlay, place, most in self._laid_aside:
            overlay.setMaximumSize(most)
            overlay.setGeometry(place)
        self._laid_aside.clear()

    def _free_room(self, main) -> int:
        """The width up to the panels that FreeCAD 1.1 lays over its 3D view: they would take the mouse."""
        floating = main.findChild(QtWidgets.QWidget, "OverlayRight")
        if floating is None or not floating.isVisible() or floating.size().isEmpty():
            return main.width()
        separator = main.style().pixelMetric(QtWidgets.QStyle.PM_DockWidgetSeparatorExtent, None, main)
        columns = {dock.x(): min(width, _NARROW) for dock, width in self._neighbours}
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
        self._watch.stop()
        self._put_back()
        main = Gui.getMainWindow()
        if any(window.isVisible() for window in main.findChildren(QtWidgets.QDockWidget, self.objectName())):
            return  # another has taken its place
        docks = [(dock, width) for dock, width in self._neighbours if dock.isVisible()]
        if docks:
            main.resizeDocks(*map(list, zip(*docks)), QtCore.Qt.Horizontal)
        self._neighbours.clear()

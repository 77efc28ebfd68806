# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panels that FreeCAD 1.0 and later lay over the middle of the window, where they take the mouse."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import FreeCADGui as Gui

from BalloonWorkbench.gui.qt import QtCore, QtWidgets

_NAMES = ("OverlayLeft", "OverlayRight", "OverlayTop", "OverlayBottom")
_INTERVAL = 300  # ms between two looks at them: FreeCAD shows them at times of its own


def _shown() -> Iterator[tuple]:
    """Name and widget of each overlay that can be seen."""
    for name in _NAMES:
        overlay = Gui.getMainWindow().findChild(QtWidgets.QWidget, name)
        if overlay is not None and overlay.isVisible() and not overlay.size().isEmpty():
            yield name, overlay


def covered(widget) -> tuple[int, int, int, int]:
    """What overlays cover of a widget at its left, top, right and bottom, in px."""
    whole = QtCore.QRect(widget.mapToGlobal(QtCore.QPoint(0, 0)), widget.size())
    left = top = right = bottom = 0
    for name, overlay in _shown():
        hidden = whole.intersected(
            QtCore.QRect(overlay.mapToGlobal(QtCore.QPoint(0, 0)), overlay.size())
        ).translated(-whole.topLeft())
        if hidden.isEmpty():
            continue
        if name == "OverlayLeft":
            left = hidden.right() + 1
        elif name == "OverlayTop":
            top = hidden.bottom() + 1
        elif name == "OverlayRight":
            right = whole.width() - hidden.left()
        else:
            bottom = whole.height() - hidden.top()
    return left, top, right, bottom


class EmptyTasks(QtCore.QObject):
    """Lays the task panel of FreeCAD 1.1 aside while it is empty; `looked` is emitted after each look at it.

    It comes with the first 3D view, also a moment later, and is a strip over what is below it.

    is_in_front  whether what it would lie over is shown just now
    """

    looked = QtCore.Signal()

    def __init__(self, parent, is_in_front: Callable[[], bool]):
        super().__init__(parent)
        self._is_in_front = is_in_front
        self._laid_aside: list[tuple] = []
        self._watch = QtCore.QTimer(self)
        self._watch.setInterval(_INTERVAL)
        self._watch.timeout.connect(self.look)

    def start(self) -> None:
        """From now on, until it is stopped."""
        self.look()
        self._watch.start()

    def stop(self) -> None:
        """It lies where FreeCAD has it."""
        self._watch.stop()
        self._put_back()

    def look(self) -> None:
        """Lay it aside, or put it back as soon as there is a task."""
        if self._is_in_front() and not Gui.Control.activeDialog():
            self._lay_aside()
        else:
            self._put_back()
        self.looked.emit()

    def _lay_aside(self) -> None:
        """FreeCAD shows again at once what is hidden, so it has no size for a while."""
        for _, overlay in _shown():
            if [dock.objectName() for dock in overlay.findChildren(QtWidgets.QDockWidget)] == ["Tasks"]:
                self._laid_aside.append((overlay, overlay.geometry(), overlay.maximumSize()))
                overlay.setMaximumSize(0, 0)

    def _put_back(self) -> None:
        for overlay, place, most in self._laid_aside:
            overlay.setMaximumSize(most)
            overlay.setGeometry(place)
        self._laid_aside.clear()

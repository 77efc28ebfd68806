# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wheel and keys that zoom and pull: the same on the canvas and in all flat pictures."""

from __future__ import annotations

from BalloonWorkbench.gui.qt import QtCore

#: Of the zoom, for a notch of the wheel or a key.
STEP = 1.25
FIT, LARGER, SMALLER = QtCore.Qt.Key_0, QtCore.Qt.Key_Plus, QtCore.Qt.Key_Minus
#: Held down, the left button pulls.
PULL = QtCore.Qt.Key_Space


class OwnKeys:
    """Of a widget whose `_action(event)` gives what a key does, None for a key that is not its own."""

    def event(self, event):
        # FreeCAD would take these keys for its own shortcuts
        if event.type() == QtCore.QEvent.ShortcutOverride and self._action(event) is not None:
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event):
        action = self._action(event)
        if action is None:
            super().keyPressEvent(event)
        else:
            action()
            self.update()


def wheel_zoom(event) -> float:
    """By how much a turn of the wheel zooms."""
    return float(STEP ** (event.angleDelta().y() / 120.0))

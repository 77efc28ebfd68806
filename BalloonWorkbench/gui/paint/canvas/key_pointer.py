# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pointer that the arrow keys move: every tool of the canvas without a mouse."""

from __future__ import annotations

from BalloonWorkbench.gui.qt import QtCore, QtGui

_FAR, _NEAR = 10, 1  # px on the screen for a press of an arrow, and with Shift
_WAYS = {
    QtCore.Qt.Key_Left: (-1, 0),
    QtCore.Qt.Key_Right: (1, 0),
    QtCore.Qt.Key_Up: (0, -1),
    QtCore.Qt.Key_Down: (0, 1),
}
_ARM = 12.0  # px of the cross


class KeyPointer:
    """Where the arrow keys have brought the pointer; place: in the canvas, None while the mouse leads."""

    def __init__(self):
        self.place: QtCore.QPointF | None = None
        self.is_down = False

    @staticmethod
    def way(event):
        """What an arrow key moves, (x, y) px; None for other keys."""
        way = _WAYS.get(event.key())
        if way is None or event.modifiers() & ~(QtCore.Qt.ShiftModifier | QtCore.Qt.KeypadModifier):
            return None
        far = _NEAR if event.modifiers() & QtCore.Qt.ShiftModifier else _FAR
        return QtCore.QPointF(far * way[0], far * way[1])

    def move(self, canvas, way):
        """Go on, first from the middle of the canvas; the new place."""
        room = canvas.rect()
        before = self.place or canvas.pointer or QtCore.QPointF(room.center())
        x = min(max(before.x() + way.x(), 0.0), room.width() - 1.0)
        y = min(max(before.y() + way.y(), 0.0), room.height() - 1.0)
        self.place = QtCore.QPointF(x, y)
        return self.place

    def leave(self) -> None:
        """The mouse leads again."""
        self.place, self.is_down = None, False

    def paint(self, painter, canvas) -> None:
        """Draw a cross that is seen on every colour."""
        if self.place is None or not canvas.hasFocus():
            return
        for colour, width in (("#ffffff", 4.0), ("#d0021b" if self.is_down else "#1c1c22", 1.6)):
            painter.setPen(QtGui.QPen(QtGui.QColor(colour), width))
            for x, y in ((_ARM, 0.0), (0.0, _ARM)):
                arm = QtCore.QPointF(x, y)
                painter.drawLine(self.place - arm, self.place + arm)

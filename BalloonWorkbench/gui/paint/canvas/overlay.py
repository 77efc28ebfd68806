# SPDX-License-Identifier: LGPL-2.1-or-later
"""Over the painting: the outline that was found, and its width."""

from __future__ import annotations

from BalloonWorkbench.gui.paint.painting.layers import SIDE
from BalloonWorkbench.gui.qt import QtCore, QtGui

_OUTLINE = "#00a5c8"
_BELOW = 16.0  # px on the screen between the shape and its width


class Overlay:
    """What is drawn over the paper, with lines as thick on the screen at every zoom."""

    def __init__(self):
        self.clear()

    def show(self, state, width: str) -> None:
        """Take the outlines of a state; width: as text."""
        self._path = QtGui.QPainterPath()
        for loop in state.loops:
            x, y = loop[:, 0] * SIDE, (1.0 - loop[:, 1]) * SIDE
            corners = [QtCore.QPointF(*corner) for corner in zip(x.tolist(), y.tolist())]
            self._path.addPolygon(QtGui.QPolygonF(corners))
            self._path.closeSubpath()
        self._width = width

    def clear(self) -> None:
        self._path, self._width = QtGui.QPainterPath(), ""

    def paint(self, painter, canvas) -> None:
        """Draw over a canvas, in its coordinates."""
        if self._path.isEmpty():
            return
        transform = QtGui.QTransform()
        transform.translate(canvas.paper.origin().x(), canvas.paper.origin().y())
        transform.scale(canvas.paper.zoom, canvas.paper.zoom)
        path = transform.map(self._path)
        painter.setBrush(QtCore.Qt.NoBrush)
        for colour, width in (("#ffffff", 3.0), (_OUTLINE, 1.4)):
            painter.setPen(QtGui.QPen(QtGui.QColor(colour), width))
            painter.drawPath(path)
        self._paint_width(painter, path.boundingRect())

    def _paint_width(self, painter, box) -> None:
        y = box.bottom() + _BELOW
        painter.setPen(QtGui.QPen(QtGui.QColor("#606670"), 1.2))
        for x, inward in ((box.left(), 7.0), (box.right(), -7.0)):
            painter.drawLine(QtCore.QPointF(x, y - 6), QtCore.QPointF(x, y + 6))
            for rise in (-4.0, 4.0):
                painter.drawLine(QtCore.QPointF(x, y), QtCore.QPointF(x + inward, y + rise))
        painter.drawLine(QtCore.QPointF(box.left(), y), QtCore.QPointF(box.right(), y))
        room = QtCore.QRectF(0, 0, 140, 20)
        room.moveCenter(QtCore.QPointF(box.center().x(), y))
        text = painter.boundingRect(room, QtCore.Qt.AlignCenter, self._width).adjusted(-5, -1, 5, 1)
        painter.fillRect(text, QtCore.Qt.white)
        painter.drawText(room, QtCore.Qt.AlignCenter, self._width)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""A small plot: how far balloons of few and of many panels are from their body."""

from __future__ import annotations

import math
from collections.abc import Sequence

from BalloonWorkbench.core.units import percent_text
from BalloonWorkbench.gui.qt import QtCore, QtGui, QtWidgets

_HEIGHT = 110  # px
_MARGIN, _TICK, _DOT = 6, 4, 3.5  # px


class CurvePlot(QtWidgets.QWidget):
    """Panels to the right, on a logarithmic scale; distance in parts of the diagonal upwards, from 0 on."""

    def __init__(self):
        super().__init__()
        self.setObjectName("CurvePlot")
        self.setMinimumHeight(_HEIGHT)
        self._points: list[tuple[int, float]] = []
        self._chosen = 0
        self._asked = 0.0

    def show_points(self, points: Sequence[tuple[int, float]], chosen: int, asked: float = 0.0) -> None:
        """Panels and distances; the number that is chosen, and the distance that is asked for, 0 for none."""
        self._points, self._chosen, self._asked = sorted(points), chosen, asked
        self.update()

    def place_of(self, panels: int, error: float) -> QtCore.QPointF:
        """Where a point of the curve is in the widget, in px."""
        room = self._room()
        low, high = (math.log(self._points[end][0]) for end in (0, -1))
        across = (math.log(panels) - low) / max(high - low, 1e-9) if high > low else 0.5
        top = max(error for _, error in self._points)
        return QtCore.QPointF(
            room.left() + across * room.width(), room.bottom() - error / top * room.height()
        )

    def paintEvent(self, event):
        painter = QtGui.QPainter(self)
        self._paint(painter)
        painter.end()  # now, not when Python forgets it

    def _room(self) -> QtCore.QRectF:
        metrics = self.fontMetrics()
        left = metrics.boundingRect("0.00 %").width() + _TICK + _MARGIN
        right = metrics.boundingRect("88").width()
        return QtCore.QRectF(self.rect()).adjusted(left, 2 * _MARGIN, -right, -metrics.height() - _MARGIN)

    def _paint(self, painter) -> None:
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        painter.fillRect(self.rect(), self.palette().base())
        if not self._points:
            return
        room, metrics, text = self._room(), self.fontMetrics(), self.palette().text().color()
        painter.setPen(QtGui.QPen(text, 1.0))
        painter.drawLine(room.bottomLeft(), room.bottomRight())
        painter.drawLine(room.bottomLeft(), room.topLeft())
        free = -1.0
        for panels, error in self._points:
            at, label = self.place_of(panels, error), str(panels)
            half = 0.5 * metrics.boundingRect(label).width()
            painter.drawLine(QtCore.QPointF(at.x(), room.bottom()), QtCore.QPointF(at.x(), room.bottom() + 3))
            if at.x() - half > free:
                painter.drawText(QtCore.QPointF(at.x() - half, self.height() - _MARGIN), label)
                free = at.x() + half + _TICK
        top = max(error for _, error in self._points)
        for value in (0.0, top):
            label, at = percent_text(value), self.place_of(self._points[0][0], value)
            width = metrics.boundingRect(label).width()
            painter.drawText(
                QtCore.QPointF(room.left() - _TICK - width, at.y() + 0.35 * metrics.height()), label
            )
        self._draw_curve(painter, room, top)

    def _draw_curve(self, painter, room: QtCore.QRectF, top: float) -> None:
        high = self.palette().highlight().color()
        if 0.0 < self._asked < top:
            painter.setPen(QtGui.QPen(high, 1.0, QtCore.Qt.DashLine))
            y = self.place_of(self._points[0][0], self._asked).y()
            painter.drawLine(QtCore.QPointF(room.left(), y), QtCore.QPointF(room.right(), y))
        painter.setPen(QtGui.QPen(high, 2.0))
        places = [self.place_of(*point) for point in self._points]
        painter.drawPolyline(QtGui.QPolygonF(places))
        for (panels, _), place in zip(self._points, places):
            painter.setBrush(high if panels == self._chosen else self.palette().base().color())
            radius = (1.6 if panels == self._chosen else 1.0) * _DOT
            painter.drawEllipse(place, radius, radius)

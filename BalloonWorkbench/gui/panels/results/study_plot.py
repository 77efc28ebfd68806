# SPDX-License-Identifier: LGPL-2.1-or-later
"""A plot of the rows of a study: one column over another."""

from __future__ import annotations

from collections.abc import Mapping

from BalloonWorkbench.core.units import number_text
from BalloonWorkbench.gui.qt import QtCore, QtGui, QtWidgets

_HEIGHT = 150  # px
_MARGIN, _DOT = 6, 3.5  # px


class StudyPlot(QtWidgets.QWidget):
    """Points by the number of their row."""

    def __init__(self):
        super().__init__()
        self.setObjectName("StudyPlot")
        self.setMinimumHeight(_HEIGHT)
        self.points: dict[int, tuple[float, float]] = {}
        self._names, self._chosen = ("", ""), None

    def show_points(
        self, points: Mapping[int, tuple[float, float]], across: str, up: str, chosen: int | None
    ) -> None:
        """Points by row, the names of the axes, the row that stands out."""
        self.points, self._names, self._chosen = dict(points), (across, up), chosen
        self.update()

    def place_of(self, row: int) -> QtCore.QPointF:
        """Where the point of a row is in the widget, in px."""
        area = self._area()
        across, up = ((low, high) for low, high in self._ranges())
        x, y = self.points[row]
        return QtCore.QPointF(
            area.left() + _part(x, *across) * area.width(), area.bottom() - _part(y, *up) * area.height()
        )

    def paintEvent(self, event):
        painter = QtGui.QPainter(self)
        self._paint(painter)
        painter.end()  # now, not when Python forgets it

    def _ranges(self) -> list[tuple[float, float]]:
        return [(min(values), max(values)) for values in zip(*self.points.values())]

    def _area(self) -> QtCore.QRectF:
        metrics = self.fontMetrics()
        left = metrics.boundingRect("0.00001234").width() + 2 * _MARGIN
        line = metrics.height() + _MARGIN
        return QtCore.QRectF(self.rect()).adjusted(left, line, -3 * _MARGIN, -2 * line)

    def _paint(self, painter) -> None:
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        painter.fillRect(self.rect(), self.palette().base())
        if not self.points:
            return
        area, metrics = self._area(), self.fontMetrics()
        painter.setPen(QtGui.QPen(self.palette().text().color(), 1.0))
        painter.drawLine(area.bottomLeft(), area.bottomRight())
        painter.drawLine(area.bottomLeft(), area.topLeft())
        (left, right), (low, high) = self._ranges()
        self._write(painter, area.left(), area.bottom() + metrics.height(), number_text(left, 4), 0.0)
        self._write(painter, area.right(), area.bottom() + metrics.height(), number_text(right, 4), 1.0)
        self._write(painter, area.left() - _MARGIN, area.bottom(), number_text(low, 4), 1.0)
        self._write(painter, area.left() - _MARGIN, area.top() + metrics.ascent(), number_text(high, 4), 1.0)
        self._write(painter, area.center().x(), self.height() - _MARGIN, self._names[0], 0.5)
        self._write(painter, _MARGIN, metrics.height(), self._names[1], 0.0)
        colour = self.palette().highlight().color()
        painter.setPen(QtGui.QPen(colour, 1.5))
        for row in self.points:
            radius = (1.8 if row == self._chosen else 1.0) * _DOT
            painter.setBrush(colour if row == self._chosen else self.palette().base().color())
            painter.drawEllipse(self.place_of(row), radius, radius)

    def _write(self, painter, x: float, y: float, text: str, share: float) -> None:
        """A text whose left end (0), middle or right end (1) is at a place."""
        width = self.fontMetrics().boundingRect(text).width()
        painter.drawText(QtCore.QPointF(max(x - share * width, 0.0), y), text)


def _part(value: float, low: float, high: float) -> float:
    return (value - low) / (high - low) if high > low else 0.5

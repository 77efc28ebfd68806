# SPDX-License-Identifier: LGPL-2.1-or-later
"""A small picture of a body of gores: its profile on both sides of the axis, and the seams between gores."""

from __future__ import annotations

import math

import numpy as np

from BalloonWorkbench.gui.qt import QtCore, QtGui, QtWidgets, painter_on

_LEAST = 150  # px
_MARGIN = 8  # px
_MOST = 100  # seams that are drawn


class ProfilePreview(QtWidgets.QWidget):
    """Shows a profile from the side."""

    def __init__(self):
        super().__init__()
        self.setObjectName("ProfilePreview")
        self.setMinimumHeight(_LEAST)
        self._points, self._gores = np.empty((0, 2)), 0

    def show_profile(self, points: np.ndarray, gores: int) -> None:
        """Draw a profile (n, 2), radius and height in mm, with so many gores."""
        self._points, self._gores = points, min(gores, _MOST)
        self.update()

    def paintEvent(self, event):
        with painter_on(self) as painter:
            self._paint(painter)

    def _paint(self, painter) -> None:
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        painter.fillRect(self.rect(), self.palette().base())
        if len(self._points) < 2:
            return
        width, low, high = 2.0 * self._points[:, 0].max(), *self._heights()
        room = self.rect().adjusted(_MARGIN, _MARGIN, -_MARGIN, -_MARGIN)
        if not (width > 0.0 and high > low):
            return
        scale = min(room.width() / width, room.height() / (high - low))
        transform = QtGui.QTransform()
        transform.translate(0.5 * self.width(), 0.5 * self.height())
        transform.scale(scale, -scale)
        transform.translate(0.0, -0.5 * (low + high))
        whole = QtGui.QPainterPath()
        whole.addPolygon(self._line(transform, 1.0))
        whole.connectPath(_path(self._line(transform, -1.0)).toReversed())
        whole.closeSubpath()
        painter.setBrush(self.palette().alternateBase())
        painter.setPen(QtGui.QPen(self.palette().highlight().color(), 2.0))
        painter.drawPath(whole)
        painter.setPen(QtGui.QPen(self.palette().text().color(), 1.0))
        for share in self._seams():
            painter.drawPolyline(self._line(transform, share))

    def _heights(self) -> tuple[float, float]:
        return float(self._points[:, 1].min()), float(self._points[:, 1].max())

    def _seams(self) -> list[float]:
        """Where the seams in front are seen, in parts of the radius; one gore is in the middle."""
        turns = [(number + 0.5) / self._gores * 2.0 * math.pi for number in range(self._gores)]
        return [math.sin(turn) for turn in turns if math.cos(turn) > 1e-9]

    def _line(self, transform, share: float):
        points = (self._points * (share, 1.0)).tolist()
        return transform.map(QtGui.QPolygonF([QtCore.QPointF(x, y) for x, y in points]))


def _path(line):
    path = QtGui.QPainterPath()
    path.addPolygon(line)
    return path

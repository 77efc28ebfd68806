# SPDX-License-Identifier: LGPL-2.1-or-later
"""One flat piece in the scene: film, lines in their colours and, where wanted, a picture on it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from BalloonWorkbench.core.arrangement.arrangement import PiecePlace
from BalloonWorkbench.core.machines.layers import LAYERS
from BalloonWorkbench.core.pattern.pattern import Role
from BalloonWorkbench.core.pattern.pieces import FlatPiece
from BalloonWorkbench.core.units import to_mm
from BalloonWorkbench.gui.bags.seam_colours import panel_tint
from BalloonWorkbench.gui.qt import QtCore, QtGui, QtWidgets

_CHOSEN, _CHOSEN_COLOUR = 2.5, "#0a64d8"  # px


class PieceItem(QtWidgets.QGraphicsItem):
    """Draws a piece in mm about the middle of its bounds, y up; what is lit on it is its child."""

    def __init__(self, number: int, piece: FlatPiece):
        super().__init__()
        self.number = number
        low, high = piece.pattern.bounds
        self._middle = 0.5 * (low + high)
        cuts = [*piece.pattern.of(Role.CUT), *piece.pattern.of(Role.CUT_INNER)]
        self.film = self.path([cut.line for cut in cuts])
        self._tint = QtGui.QColor.fromRgbF(*panel_tint(number))
        self._lines = []
        for role in piece.pattern.roles:
            lines = self.path([contour.line for contour in piece.pattern.of(role)])
            self._lines.append((cosmetic_pen(QtGui.QColor(LAYERS[role].rgb), 0.0), lines))
        self._picture: tuple | None = None  # a QImage and where it is
        self._bounds = self.film.boundingRect()
        for _, lines in self._lines:
            self._bounds = self._bounds.united(lines.boundingRect())
        self._rim: QtWidgets.QGraphicsPathItem | None = None

    def path(self, lines: Sequence[np.ndarray]):
        """Lines (k, 2) m, where the pattern has them, as a path of the item."""
        path = QtGui.QPainterPath()
        for line in lines:
            points = to_mm(line - self._middle).tolist()
            path.addPolygon(QtGui.QPolygonF([QtCore.QPointF(x, y) for x, y in points]))
        return path

    def lie(self, place: PiecePlace) -> None:
        """Take the piece to its place."""
        (a, b), (c, d) = place.matrix.tolist()
        self.setTransform(QtGui.QTransform(a, b, c, d, 0.0, 0.0))
        self.setPos(*map(to_mm, place.middle))

    def choose(self, on: bool) -> None:
        """Show that it is the one that keys move."""
        if on and self._rim is None:
            self._rim = QtWidgets.QGraphicsPathItem(self.film, self)
            self._rim.setPen(cosmetic_pen(QtGui.QColor(_CHOSEN_COLOUR), _CHOSEN))
        if self._rim is not None:
            self._rim.setVisible(on)

    def show_picture(self, image, low: np.ndarray | None, high: np.ndarray | None) -> None:
        """Lay a picture on the film, its lower left and upper right corner (2,) m where the pattern lies;
        None: the film alone."""
        self._picture = None
        if image is not None:
            (left, bottom), (right, top) = to_mm(np.array([low, high]) - self._middle).tolist()
            # y is up, that of the picture is down
            self._picture = image, QtCore.QRectF(left, -top, right - left, top - bottom)
        self.update()

    def boundingRect(self):
        return self._bounds

    def paint(self, painter, _option, _widget=None):
        painter.setPen(QtCore.Qt.NoPen)
        painter.setBrush(self._tint)
        painter.drawPath(self.film)
        if self._picture is not None:
            image, where = self._picture
            painter.save()
            painter.setClipPath(self.film, QtCore.Qt.IntersectClip)
            painter.setRenderHint(QtGui.QPainter.SmoothPixmapTransform)
            painter.scale(1.0, -1.0)
            painter.drawImage(where, image)
            painter.restore()
        painter.setBrush(QtCore.Qt.NoBrush)
        for pen, lines in self._lines:
            painter.setPen(pen)
            painter.drawPath(lines)


def cosmetic_pen(colour, width: float):
    """As wide on the screen at every zoom, in pixels; 0: the thinnest."""
    pen = QtGui.QPen(colour, width)
    pen.setCosmetic(True)
    return pen

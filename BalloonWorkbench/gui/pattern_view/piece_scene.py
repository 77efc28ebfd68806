# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pieces of a pattern as a scene of Qt in mm, y up: film, lines in their colours, what is lit."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from BalloonWorkbench.core.machines.layers import LAYERS
from BalloonWorkbench.core.pattern.pattern import Role
from BalloonWorkbench.core.pattern.pieces import FlatPiece, PatternPieces
from BalloonWorkbench.core.units import to_mm
from BalloonWorkbench.gui.bags.seam_colours import FREE, panel_tint, seam_colour
from BalloonWorkbench.gui.qt import QtCore, QtGui, QtWidgets

_LIT, _RULE = 6.0, 2.0  # px
_RULE_COLOUR = "#d6006c"
_OVER, _ABOVE = 1.0, 2.0  # z of what is lit, and of the measure
_ARM = 7  # px of the cross at an end of the measure


class PieceScene(QtWidgets.QGraphicsScene):
    """Shows PatternPieces, lights edges and draws a measure; nothing in it is moved by the mouse."""

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setItemIndexMethod(QtWidgets.QGraphicsScene.NoIndex)
        self._pieces: PatternPieces | None = None
        self._lit: list = []
        self._rule: list = []
        self.film = QtCore.QRectF()

    def show_pieces(self, pieces: PatternPieces) -> None:
        """Draw other pieces; nothing is lit then."""
        self.clear()
        self._pieces, self._lit, self._rule = pieces, [], []
        for number, piece in enumerate(pieces.pieces):
            self._add(number, piece)
        self.film = self.itemsBoundingRect()
        room = max(self.film.width(), self.film.height())
        self.setSceneRect(self.film.adjusted(-room, -room, room, room))  # as far as it can be pulled

    def light(self, numbers: Sequence[int]) -> None:
        """Draw edges thick, in the colour of their seam; no numbers: none."""
        self._remove(self._lit)
        for number in numbers:
            edge = self._pieces.edges[number]
            rgb = seam_colour(edge.seam - 1) if edge.seam else FREE
            pen = _pen(QtGui.QColor.fromRgbF(*rgb), _LIT)
            pen.setCapStyle(QtCore.Qt.RoundCap)
            self._lit.append(self._draw(_path([edge.line]), pen, _OVER))

    def measure(self, places: Sequence[np.ndarray]) -> None:
        """Draw crosses at places (2,) m, and a line from the first to the second; no places: none."""
        self._remove(self._rule)
        pen = _pen(QtGui.QColor(_RULE_COLOUR), _RULE)
        if len(places) > 1:
            self._rule.append(self._draw(_path([np.array(places)]), pen, _ABOVE))
        for x, y in map(to_mm, places):
            for arm in ((-_ARM, -_ARM, _ARM, _ARM), (-_ARM, _ARM, _ARM, -_ARM)):
                item = self.addLine(*arm, pen)
                item.setFlag(QtWidgets.QGraphicsItem.ItemIgnoresTransformations)
                item.setPos(x, y)
                item.setZValue(_ABOVE)
                self._rule.append(item)

    def _add(self, number: int, piece: FlatPiece) -> None:
        cuts = [*piece.pattern.of(Role.CUT), *piece.pattern.of(Role.CUT_INNER)]
        film = self.addPath(_path([cut.line for cut in cuts]), QtGui.QPen(QtCore.Qt.NoPen))
        film.setBrush(QtGui.QColor.fromRgbF(*panel_tint(number)))
        for role in piece.pattern.roles:
            lines = [contour.line for contour in piece.pattern.of(role)]
            self._draw(_path(lines), _pen(QtGui.QColor(LAYERS[role].rgb), 0.0))

    def _draw(self, path, pen, z: float = 0.0):
        item = self.addPath(path, pen)
        item.setZValue(z)
        return item

    def _remove(self, items: list) -> None:
        for item in items:
            self.removeItem(item)
        items.clear()


def _pen(colour, width: float):
    """As wide on the screen at every zoom, in pixels; 0: the thinnest."""
    pen = QtGui.QPen(colour, width)
    pen.setCosmetic(True)
    return pen


def _path(lines: Sequence[np.ndarray]):
    """Lines (k, 2) m as a path in mm."""
    path = QtGui.QPainterPath()
    for line in lines:
        path.addPolygon(QtGui.QPolygonF([QtCore.QPointF(x, y) for x, y in to_mm(line).tolist()]))
    return path

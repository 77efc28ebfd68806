# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pieces of a pattern as a scene of Qt in mm, y up: each in its place, what is lit, measure, handle."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from BalloonWorkbench.core.arrangement.arrangement import LaidPieces, PiecePlace
from BalloonWorkbench.core.units import to_mm
from BalloonWorkbench.gui.bags.seam_colours import FREE, seam_colour
from BalloonWorkbench.gui.pattern_view.piece_item import PieceItem, cosmetic_pen
from BalloonWorkbench.gui.qt import QtCore, QtGui, QtWidgets

_LIT, _RULE = 6.0, 2.0  # px
_RULE_COLOUR, _HANDLE_COLOUR = "#d6006c", "#0a64d8"
_OVER, _ABOVE = 1.0, 2.0  # z of the piece that is chosen or lit, and of measure and handle
_ARM = 7  # px of the cross at an end of the measure
#: How far the handle is above its piece, and how large it is [px].
HANDLE_AWAY, HANDLE = 26.0, 7.0


class PieceScene(QtWidgets.QGraphicsScene):
    """Shows LaidPieces, lights edges, draws a measure, and a handle over the piece that is chosen."""

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setItemIndexMethod(QtWidgets.QGraphicsScene.NoIndex)
        self.items_of_pieces: list[PieceItem] = []
        self._laid: LaidPieces | None = None
        self._lit: list = []
        self._rule: list = []
        self._handle: QtWidgets.QGraphicsPathItem | None = None
        self.film = QtCore.QRectF()

    def show_pieces(self, laid: LaidPieces) -> None:
        """Draw pieces; those of the same pattern are only taken to their places."""
        if self._laid is None or laid.base is not self._laid.base:
            self.clear()
            self._lit, self._rule, self._handle = [], [], None
            self.items_of_pieces = [PieceItem(number, piece) for number, piece in enumerate(laid.base.pieces)]
            for item in self.items_of_pieces:
                self.addItem(item)
        self._laid = laid
        for number, place in enumerate(laid.places):
            self.lie(number, place)
        self.film = QtCore.QRectF()
        for item in self.items_of_pieces:
            self.film = self.film.united(item.sceneBoundingRect())
        room = max(self.film.width(), self.film.height())
        self.setSceneRect(self.film.adjusted(-room, -room, room, room))  # as far as it can be pulled

    def show_pictures(self, pictures: Mapping[int, tuple]) -> None:
        """Lay pictures on the pieces by their numbers: each a QImage and two corners, see `PieceItem`."""
        for item in self.items_of_pieces:
            item.show_picture(*pictures.get(item.number, (None, None, None)))

    def lie(self, number: int, place: PiecePlace) -> None:
        """Take a piece somewhere, while it is being dragged."""
        self.items_of_pieces[number].lie(place)
        if self._handle is not None and self._handle.data(0) == number:
            self._move_handle()
        self.update()  # lines are wider on the screen than what Qt takes for their size in mm

    def choose(self, number: int | None, with_handle: bool) -> None:
        """Show which piece is chosen, and a handle by which it can be turned."""
        if self._handle is not None:
            self.removeItem(self._handle)
            self._handle = None
        for item in self.items_of_pieces:
            item.choose(item.number == number)
            item.setZValue(_OVER if item.number == number else 0.0)
        if number is not None and with_handle:
            self._handle = self._drawn_handle()
            self._handle.setData(0, number)
            self._move_handle()
        self.update()

    def handle_place(self):
        """Where the line to the handle begins, in the scene; None without one."""
        return None if self._handle is None else self._handle.pos()

    def light(self, numbers: Sequence[int]) -> None:
        """Draw edges thick, in the colour of their seam; no numbers: none."""
        self._remove(self._lit)
        for number in numbers:
            edge = self._laid.base.edges[number]
            rgb = seam_colour(edge.seam - 1) if edge.seam else FREE
            pen = cosmetic_pen(QtGui.QColor.fromRgbF(*rgb), _LIT)
            pen.setCapStyle(QtCore.Qt.RoundCap)
            owner = self.items_of_pieces[edge.piece]
            item = QtWidgets.QGraphicsPathItem(owner.path([edge.line]), owner)
            item.setPen(pen)
            self._lit.append(item)
        self.update()

    def measure(self, places: Sequence[np.ndarray]) -> None:
        """Draw crosses at places (2,) m, and a line from the first to the second; no places: none."""
        self._remove(self._rule)
        pen = cosmetic_pen(QtGui.QColor(_RULE_COLOUR), _RULE)
        ends = [to_mm(place).tolist() for place in places]
        if len(ends) > 1:
            self._rule.append(self.addLine(*ends[0], *ends[1], pen))
        for x, y in ends:
            for arm in ((-_ARM, -_ARM, _ARM, _ARM), (-_ARM, _ARM, _ARM, -_ARM)):
                item = self.addLine(*arm, pen)
                item.setFlag(QtWidgets.QGraphicsItem.ItemIgnoresTransformations)
                item.setPos(x, y)
                self._rule.append(item)
        for item in self._rule:
            item.setZValue(_ABOVE)

    def _drawn_handle(self):
        path = QtGui.QPainterPath(QtCore.QPointF(0.0, 0.0))
        path.lineTo(0.0, HANDLE - HANDLE_AWAY)
        path.addEllipse(QtCore.QPointF(0.0, -HANDLE_AWAY), HANDLE, HANDLE)
        item = self.addPath(path, QtGui.QPen(QtGui.QColor(_HANDLE_COLOUR), 2.0), self.palette().base())
        item.setFlag(QtWidgets.QGraphicsItem.ItemIgnoresTransformations)
        item.setZValue(_ABOVE)
        return item

    def _move_handle(self) -> None:
        film = self.items_of_pieces[self._handle.data(0)].sceneBoundingRect()
        self._handle.setPos(film.center().x(), film.bottom())  # y is up

    def _remove(self, items: list) -> None:
        for item in items:
            self.removeItem(item)
        items.clear()

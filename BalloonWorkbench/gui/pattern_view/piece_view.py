# SPDX-License-Identifier: LGPL-2.1-or-later
"""The view on the pieces: the wheel zooms, a drag pulls, a click picks an edge or measures."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.pattern.pieces import PatternPieces
from BalloonWorkbench.core.units import from_mm, to_mm
from BalloonWorkbench.gui.pattern_view.piece_scene import PieceScene
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, position
from BalloonWorkbench.gui.window.zoom_keys import FIT, LARGER, PULL, SMALLER, STEP, OwnKeys, wheel_zoom

_AROUND = 0.03  # of the pieces' size, left free beside them
_FARTHEST, _NEAREST = 0.1, 400.0  # of the zoom that shows everything
MEASURE = QtCore.Qt.Key_M
NEAR = 9.0  # px within which an edge or a point is meant


class PieceView(OwnKeys, QtWidgets.QGraphicsView):
    """`picked` carries the number of an edge, None beside all; `measured` two places (2,) m."""

    picked = QtCore.Signal(object)
    measured = QtCore.Signal(object)
    measuring_changed = QtCore.Signal(bool)

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setObjectName("PatternPieces")
        self.pieces: PatternPieces | None = None
        self.measuring = False
        self._places: list[np.ndarray] = []  # of the measure
        self._held: QtCore.QPoint | None = None  # where a button went down, or the pieces were pulled to
        self._pulling = self._space = False
        self._fitted = True  # until it is zoomed or pulled
        self._whole = 1.0  # the zoom at which everything is seen
        self.setScene(PieceScene(self))
        self.setTransformationAnchor(QtWidgets.QGraphicsView.NoAnchor)
        self.setResizeAnchor(QtWidgets.QGraphicsView.NoAnchor)
        self.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOff)
        self.setVerticalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOff)
        self.setFrameShape(QtWidgets.QFrame.NoFrame)
        self.setFocusPolicy(QtCore.Qt.StrongFocus)
        self.setMouseTracking(True)
        self.setBackgroundBrush(self.palette().base())
        self.scale(1.0, -1.0)

    def show_pieces(self, pieces: PatternPieces) -> None:
        """Show other pieces, as large as they were; the first ones whole."""
        self._fitted = self._fitted or self.pieces is None
        self.pieces, self._places = pieces, []
        self.scene().show_pieces(pieces)
        if self._fitted:
            self.fit()

    def set_measuring(self, on: bool) -> None:
        """From now on a click measures, or picks."""
        if on != self.measuring:
            self.measuring = on
            self.forget_measure()
            self.viewport().setCursor(QtCore.Qt.CrossCursor if on else QtCore.Qt.ArrowCursor)
            self.measuring_changed.emit(on)

    def forget_measure(self) -> None:
        """Take the measure away."""
        self._places = []
        self.scene().measure([])

    def place_of(self, place: np.ndarray):
        """Where a place (2,) m of the pieces is in the view, in px."""
        return self.mapFromScene(QtCore.QPointF(*to_mm(place).tolist()))

    # zoom

    @property
    def zoom(self) -> float:
        """Pixels of a mm."""
        return abs(float(self.transform().m11()))

    def fit(self) -> None:
        """Show all pieces."""
        film = self.scene().film
        if film.isEmpty():
            return
        room = _AROUND * max(film.width(), film.height())
        self.fitInView(film.adjusted(-room, -room, room, room), QtCore.Qt.KeepAspectRatio)
        self._fitted, self._whole = True, self.zoom

    def zoom_by(self, factor: float, about=None) -> None:
        """Larger or smaller; the place at a point of the view stays, without one the middle."""
        about = self.viewport().rect().center() if about is None else about.toPoint()
        fixed = self.mapToScene(about)
        goal = min(max(self.zoom * factor, _FARTHEST * self._whole), _NEAREST * self._whole)
        factor = goal / self.zoom
        self.scale(factor, factor)
        moved = self.mapToScene(about) - fixed
        self.translate(moved.x(), moved.y())
        self._fitted = False

    def _pull(self, by) -> None:
        for bar, pixels in ((self.horizontalScrollBar(), by.x()), (self.verticalScrollBar(), by.y())):
            bar.setValue(bar.value() - pixels)
        self._fitted = False

    def resizeEvent(self, event):
        super().resizeEvent(event)
        if self._fitted:
            self.fit()

    def wheelEvent(self, event):
        self.zoom_by(wheel_zoom(event), position(event))
        event.accept()

    # mouse

    def mousePressEvent(self, event):
        self.setFocus()
        middle = event.button() == QtCore.Qt.MiddleButton
        if middle or event.button() == QtCore.Qt.LeftButton:
            self._held, self._pulling = position(event).toPoint(), middle or self._space
        event.accept()

    def mouseMoveEvent(self, event):
        at = position(event)
        if self._held is None:
            near = not self.measuring and self._edge_at(at) is not None
            shape = QtCore.Qt.PointingHandCursor if near else QtCore.Qt.ArrowCursor
            self.viewport().setCursor(QtCore.Qt.CrossCursor if self.measuring else shape)
            return
        at = at.toPoint()
        far = (at - self._held).manhattanLength() >= QtWidgets.QApplication.startDragDistance()
        if self._pulling or far:
            self._pulling = True
            self.viewport().setCursor(QtCore.Qt.ClosedHandCursor)
            self._pull(at - self._held)
            self._held = at

    def mouseReleaseEvent(self, event):
        held, pulled = self._held, self._pulling
        self._held, self._pulling = None, False
        if pulled:
            self.viewport().setCursor(QtCore.Qt.CrossCursor if self.measuring else QtCore.Qt.ArrowCursor)
        elif held is not None and event.button() == QtCore.Qt.LeftButton and self.pieces is not None:
            self._click(position(event))
        event.accept()

    def mouseDoubleClickEvent(self, event):
        self.mousePressEvent(event)

    # keys

    def keyReleaseEvent(self, event):
        if event.key() == PULL and not event.isAutoRepeat():
            self._space = False
        super().keyReleaseEvent(event)

    def _action(self, event):
        """What a key does; None when it is not ours."""
        actions = {
            FIT: self.fit,
            LARGER: lambda: self.zoom_by(STEP),
            SMALLER: lambda: self.zoom_by(1.0 / STEP),
            PULL: self._take_hold,
            MEASURE: lambda: self.set_measuring(not self.measuring),
            QtCore.Qt.Key_Escape: self._lay_down,
        }
        plain = event.modifiers() in (QtCore.Qt.NoModifier, QtCore.Qt.KeypadModifier, QtCore.Qt.ShiftModifier)
        return actions.get(event.key()) if plain else None

    def _take_hold(self) -> None:
        self._space = True

    def _lay_down(self) -> None:
        """The measure first, then what is lit."""
        if self.measuring:
            self.set_measuring(False)
        else:
            self.picked.emit(None)

    def _click(self, at) -> None:
        if not self.measuring:
            self.picked.emit(self._edge_at(at))
            return
        place = self.pieces.nearest_point(self._place_at(at), from_mm(NEAR / self.zoom))
        self._places = [*self._places, place] if len(self._places) == 1 else [place]
        self.scene().measure(self._places)
        if len(self._places) == 2:
            self.measured.emit(self._places)

    def _edge_at(self, at) -> int | None:
        """The edge at a point of the view, within a few pixels."""
        nearest = None if self.pieces is None else self.pieces.nearest_edge(self._place_at(at))
        if nearest is None or nearest[1] > from_mm(NEAR / self.zoom):
            return None
        return nearest[0]

    def _place_at(self, at) -> np.ndarray:
        """The place (2,) m of the pieces at a point of the view."""
        back, _ = self.viewportTransform().inverted()
        there = back.map(at)
        return from_mm(np.array([there.x(), there.y()]))

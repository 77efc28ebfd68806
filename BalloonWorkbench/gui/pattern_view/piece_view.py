# SPDX-License-Identifier: LGPL-2.1-or-later
"""The view on the pieces: the wheel zooms, a drag pulls or moves a piece, a click picks or measures."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from BalloonWorkbench.core.arrangement.arrangement import LaidPieces, PiecePlace
from BalloonWorkbench.core.arrangement.snapping import STEP
from BalloonWorkbench.core.pattern.pieces import PatternPieces
from BalloonWorkbench.core.units import from_mm, to_mm
from BalloonWorkbench.gui.pattern_view.drags import KeyDrag, PullDrag, SlideDrag, TurnDrag
from BalloonWorkbench.gui.pattern_view.piece_scene import HANDLE, HANDLE_AWAY, PieceScene
from BalloonWorkbench.gui.qt import QtCore, QtGui, QtWidgets, position
from BalloonWorkbench.gui.tabs.zoom_keys import FIT, LARGER, PULL, SMALLER
from BalloonWorkbench.gui.tabs.zoom_keys import STEP as ZOOM_STEP
from BalloonWorkbench.gui.tabs.zoom_view import ZoomView

_AROUND = 0.05  # of the pieces' size, left free beside them: there is room for a handle
_FARTHEST, _NEAREST = 0.1, 400.0  # of the zoom that shows everything
NEAR = 9.0  # px within which an edge, a point or the handle is meant
_NUDGE, _FAR_NUDGE = from_mm(1.0), from_mm(10.0)
_KEYS = QtCore.Qt
MEASURE, TURN, MIRROR, EDGE = _KEYS.Key_M, _KEYS.Key_R, _KEYS.Key_H, (_KEYS.Key_Return, _KEYS.Key_Enter)
_WAYS = {
    _KEYS.Key_Left: (-1.0, 0.0),
    _KEYS.Key_Right: (1.0, 0.0),
    _KEYS.Key_Up: (0.0, 1.0),
    _KEYS.Key_Down: (0.0, -1.0),
}


class PieceView(ZoomView):
    """Signals: `picked` carries the number of an edge, None beside all; `chosen` the number of a piece, None
    for none; `measured` two places (2,) m; `laid_out` the number of a piece and its new PiecePlace;
    `undone` whether the last step is taken back, or taken anew."""

    picked = QtCore.Signal(object)
    chosen = QtCore.Signal(object)
    measured = QtCore.Signal(object)
    measuring_changed = QtCore.Signal(bool)
    laid_out = QtCore.Signal(int, object)
    undone = QtCore.Signal(bool)

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setObjectName("PatternPieces")
        self.laid: LaidPieces | None = None
        self.grains: Sequence[float | None] = ()
        self.movable = self.measuring = False
        self.piece: int | None = None  # the one that is chosen
        self.edge: int | None = None  # the one that is lit
        self._places: list[np.ndarray] = []  # of the measure
        self._held: QtCore.QPointF | None = None  # where a button went down
        self._drag: PullDrag | SlideDrag | TurnDrag | KeyDrag | None = None
        self._middle = self._space = False
        self.setScene(PieceScene(self))

    @property
    def pieces(self) -> PatternPieces | None:
        """The pieces as they lie."""
        return None if self.laid is None else self.laid.pieces

    def show_pieces(self, laid: LaidPieces, grains: Sequence[float | None], movable: bool) -> None:
        """Show other pieces, or the same ones elsewhere, as large as they were; the first ones whole.

        grains  of each piece as the pattern lays it [rad], None without one
        """
        others = self.laid is None or laid.base is not self.laid.base
        self._fitted = self._fitted or self.laid is None
        self._drag = self._held = None
        self.laid, self.grains, self.movable = laid, grains, movable
        self.scene().show_pieces(laid)
        self.whole = self.scene().film
        self.forget_measure()
        if others:
            self.piece = self.edge = None
        self.choose(self.piece)
        if self._fitted and others:
            self.fit()

    def choose(self, number: int | None) -> None:
        """Show that a piece is the one that keys move; says nothing of it."""
        self.piece = number
        self.scene().choose(number, self.movable)

    def light(self, edges: Sequence[int]) -> None:
        """Light edges; the first one is the one that was picked."""
        self.edge = edges[0] if edges else None
        self.scene().light(edges)

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

    def handle_at(self):
        """Where the handle is in the view, in px; None without one."""
        foot = self.scene().handle_place()
        return None if foot is None else self.mapFromScene(foot) - QtCore.QPoint(0, round(HANDLE_AWAY))

    # mouse

    def mousePressEvent(self, event):
        self.setFocus()
        self._middle = event.button() == QtCore.Qt.MiddleButton
        if self._middle or event.button() == QtCore.Qt.LeftButton:
            self._held = position(event)
        event.accept()

    def mouseMoveEvent(self, event):
        at = position(event)
        if self._held is None:
            self._show_cursor(at)
            return
        far = (at - self._held).manhattanLength() >= QtWidgets.QApplication.startDragDistance()
        if self._drag is None and (far or self._middle or self._space):
            self._drag = self._begun()
            self.viewport().setCursor(QtCore.Qt.ClosedHandCursor)
        if self._drag is not None:
            self._drag.move(at, bool(event.modifiers() & QtCore.Qt.ShiftModifier))

    def mouseReleaseEvent(self, event):
        held, drag = self._held, self._drag
        self._held = self._drag = None
        if drag is not None:
            self._show_cursor(position(event))
            drag.end()
        elif held is not None and event.button() == QtCore.Qt.LeftButton and self.laid is not None:
            self._click(position(event))
        event.accept()

    def mouseDoubleClickEvent(self, event):
        self.mousePressEvent(event)

    def _begun(self) -> PullDrag | SlideDrag | TurnDrag:
        """The drag that begins where the button went down."""
        pulls = self._middle or self._space or self.measuring or not self.movable
        if not pulls and self._on_handle(self._held):
            return TurnDrag(self, self.piece, self._held)
        number = None if pulls else self._piece_at(self._held)
        if number is None:
            return PullDrag(self, self._held)
        if number != self.piece:
            self.chosen.emit(number)
        return SlideDrag(self, number, self._held)

    def _show_cursor(self, at) -> None:
        if self.measuring:
            shape = QtCore.Qt.CrossCursor
        elif self.movable and self._on_handle(at):
            shape = QtCore.Qt.OpenHandCursor
        elif self._edge_at(at) is not None:
            shape = QtCore.Qt.PointingHandCursor
        elif self.movable and self._piece_at(at) is not None:
            shape = QtCore.Qt.SizeAllCursor
        else:
            shape = QtCore.Qt.ArrowCursor
        self.viewport().setCursor(shape)

    def _click(self, at) -> None:
        if not self.measuring:
            edge = self._edge_at(at)
            if edge is None and (number := self._piece_at(at)) is not None:
                self.chosen.emit(number)
            else:
                self.picked.emit(edge)
            return
        place = self.pieces.nearest_point(self.place_at(at), from_mm(NEAR / self.zoom))
        self._places = [*self._places, place] if len(self._places) == 1 else [place]
        self.scene().measure(self._places)
        if len(self._places) == 2:
            self.measured.emit(self._places)

    def _edge_at(self, at) -> int | None:
        """The edge at a point of the view, within a few pixels."""
        nearest = None if self.laid is None else self.pieces.nearest_edge(self.place_at(at))
        if nearest is None or nearest[1] > from_mm(NEAR / self.zoom):
            return None
        return nearest[0]

    def _piece_at(self, at) -> int | None:
        """The piece whose film is at a point of the view; of several the one that is chosen."""
        there = QtCore.QPointF(*to_mm(self.place_at(at)).tolist())
        under = [
            item.number
            for item in self.scene().items_of_pieces
            if item.film.contains(item.mapFromScene(there))
        ]
        return self.piece if self.piece in under else next(iter(reversed(under)), None)

    def _on_handle(self, at) -> bool:
        handle = self.handle_at()
        return handle is not None and (QtCore.QPointF(handle) - at).manhattanLength() <= HANDLE + NEAR

    # keys

    def focusNextPrevChild(self, forward: bool) -> bool:
        """Tab goes from piece to piece, and after the last one on through the window."""
        count = 0 if self.laid is None else len(self.laid.places)
        first = 0 if forward else count - 1
        goal = first if self.piece is None else self.piece + (1 if forward else -1)
        if not 0 <= goal < count:
            return super().focusNextPrevChild(forward)
        self.chosen.emit(goal)
        return True

    def keyReleaseEvent(self, event):
        if event.key() == PULL and not event.isAutoRepeat():
            self._space = False
        if event.key() in _WAYS and not event.isAutoRepeat():
            self._end_nudge()
        super().keyReleaseEvent(event)

    def _action(self, event):
        """What a key does; None when it is not ours."""
        for keys, back in ((QtGui.QKeySequence.Undo, True), (QtGui.QKeySequence.Redo, False)):
            if self.movable and event.matches(keys):
                return lambda: self.undone.emit(back)
        plain = event.modifiers() & ~(QtCore.Qt.KeypadModifier | QtCore.Qt.ShiftModifier)
        if plain != QtCore.Qt.NoModifier:
            return None
        shift = bool(event.modifiers() & QtCore.Qt.ShiftModifier)
        actions = {
            FIT: self.fit,
            LARGER: lambda: self.zoom_by(ZOOM_STEP),
            SMALLER: lambda: self.zoom_by(1.0 / ZOOM_STEP),
            PULL: self._take_hold,
            MEASURE: lambda: self.set_measuring(not self.measuring),
            QtCore.Qt.Key_Escape: self._lay_down,
        }
        return actions.get(event.key()) or self._piece_action(event.key(), shift)

    def _piece_action(self, key, shift: bool):
        """What a key does with the piece that is chosen."""
        if self.piece is None:
            return None
        if key in EDGE:
            return self._next_edge
        if not self.movable:
            return None
        place = self.laid.places[self.piece]
        if key == TURN:
            return lambda: self.lay(self.piece, place.turned(-STEP if shift else STEP))
        if key == MIRROR:
            return lambda: self.lay(self.piece, place.turned_over())
        if key in _WAYS:
            by = np.array(_WAYS[key]) * (_FAR_NUDGE if shift else _NUDGE)
            return lambda: self._nudge(by)
        return None

    def lay(self, number: int, place: PiecePlace) -> None:
        """Lay a piece elsewhere: it is told of, and stays there when the document has it."""
        self.laid_out.emit(number, place)

    def _nudge(self, by: np.ndarray) -> None:
        """Move the chosen piece a little; it is told of when the key comes up."""
        if self._drag is None:
            self._drag = KeyDrag(self, self.piece)
        if isinstance(self._drag, KeyDrag):
            self._drag.by(by)

    def _end_nudge(self) -> None:
        if isinstance(self._drag, KeyDrag):
            drag, self._drag = self._drag, None
            drag.end()

    def focusOutEvent(self, event):
        self._end_nudge()
        super().focusOutEvent(event)

    def _next_edge(self) -> None:
        """Pick the edge after the one that is lit on the chosen piece."""
        own = [number for number, edge in enumerate(self.pieces.edges) if edge.piece == self.piece]
        if own:
            at = own.index(self.edge) + 1 if self.edge in own else 0
            self.picked.emit(own[at % len(own)])

    def _take_hold(self) -> None:
        self._space = True

    def _lay_down(self) -> None:
        """What is being dragged first, then the measure, then what is picked."""
        if self._drag is not None:
            self._drag.cancel()
            self._drag = self._held = None
        elif self.measuring:
            self.set_measuring(False)
        else:
            self.picked.emit(None)

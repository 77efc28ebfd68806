# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture, the outline with its holes, and the nodes as handles: what mouse and keys do to them.

As in Inkscape's node tool: a click picks a node, with Shift more of them, a drag beside them picks all in a
box; Delete takes nodes away, arrow keys push them.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from BalloonWorkbench.app.drawings.drawing_file import File, file_of
from BalloonWorkbench.core.geometry.nearest import nearest_on_loops, nearest_places
from BalloonWorkbench.core.geometry.polyline import bounds
from BalloonWorkbench.core.outline_edits.nodes import CORNER, NodeDrawing
from BalloonWorkbench.core.units import from_mm, to_mm
from BalloonWorkbench.gui.panels.widgets.drawing_preview import picture_in
from BalloonWorkbench.gui.qt import QtCore, QtGui, QtWidgets, position, translate
from BalloonWorkbench.gui.tabs.zoom_keys import FIT, LARGER, PULL, SMALLER, STEP
from BalloonWorkbench.gui.tabs.zoom_view import ZoomView

Place = tuple[float, float]

NEAR = 9.0  # px within which a node or the line is meant
_HALF = 4.5  # px, half the side of a handle
_PUSH, _PUSH_FAR = 1.0, 10.0  # px of an arrow key, and with Shift
_PICTURE, _SHARPEST = 0.55, 4096  # opacity; px that a picture is shown with at most
_LINE, _CHOSEN, _NODE = "#0072b2", "#d55e00", "#ffffff"
_ARROWS = {
    QtCore.Qt.Key_Left: (-1.0, 0.0),
    QtCore.Qt.Key_Right: (1.0, 0.0),
    QtCore.Qt.Key_Up: (0.0, 1.0),
    QtCore.Qt.Key_Down: (0.0, -1.0),
}


class NodeView(ZoomView):
    """Shows a NodeDrawing. Signals carry places (2,) m: nodes that go by a vector, a place for a new node,
    nodes that go, nodes that change between sharp and round; `dragged` before the button is let go.
    """

    moved = QtCore.Signal(object, object)
    dragged = QtCore.Signal(object, object)
    added = QtCore.Signal(object)
    removed = QtCore.Signal(object)
    toggled = QtCore.Signal(object)
    undone = QtCore.Signal()
    redone = QtCore.Signal()
    left = QtCore.Signal()
    picked = QtCore.Signal()

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setViewportUpdateMode(QtWidgets.QGraphicsView.FullViewportUpdate)
        self.setObjectName("OutlineNodes")
        self.setAccessibleName(translate("Nodes of the outline"))
        self.nodes: NodeDrawing | None = None
        self.chosen: list[Place] = []
        self._shown: NodeDrawing | None = None  # while nodes are dragged, else None
        self._picture, self._picture_box = QtGui.QPixmap(), QtCore.QRectF()
        self._file: File | None = None  # of the picture
        self._held = None  # QPointF in the view where the left button went down
        self._grip: np.ndarray | None = None  # the node that is dragged
        self._by: np.ndarray | None = None  # how far (2,) m it has been
        self._box = None  # QRectF in the view that picks
        self._pulled_from = None
        self._space = self._fresh = False

    # what is shown

    def show_nodes(self, nodes: NodeDrawing, chosen: Sequence[np.ndarray] = ()) -> None:
        """Show another state; of the nodes at these places those that are there are picked."""
        if nodes is not self.nodes:
            self._drop()  # what is held is of another outline
        self.nodes, self._shown = nodes, None
        near, places = 1e-5 * nodes.size, self._places()
        away = [np.linalg.norm(places - each, axis=1) for each in chosen]
        self.chosen = [_key(places[np.argmin(each)]) for each in away if each.min() < near]
        low, high = bounds(np.concatenate([loop.points for loop in nodes.loops]))
        box = QtCore.QRectF(*to_mm(low).tolist(), *to_mm(high - low).tolist())
        self.set_whole(box.united(self._picture_box))
        self.viewport().update()
        self.picked.emit()

    def show_picture(self, path: str, canvas) -> None:
        """The picture below, between its corners (2, 2) m; without a path none."""
        file = file_of(path) if path and canvas is not None else None
        if file != self._file:
            self._file = file
            self._picture = QtGui.QPixmap() if file is None else picture_in(path, _SHARPEST)
        self._picture_box = QtCore.QRectF()
        if not self._picture.isNull():
            (left, low), (right, high) = to_mm(canvas).tolist()
            self._picture_box = QtCore.QRectF(left, low, right - left, high - low)
        self.viewport().update()

    @property
    def is_settled(self) -> bool:
        """What is shown is what is kept."""
        return self._shown is None

    def show_dragged(self, nodes: NodeDrawing) -> None:
        """Show a state that is not kept yet."""
        self._shown = nodes
        self.viewport().update()

    def drawBackground(self, painter, rect):
        super().drawBackground(painter, rect)
        if self._picture.isNull():
            return
        painter.save()
        painter.setRenderHint(QtGui.QPainter.SmoothPixmapTransform)
        painter.setOpacity(_PICTURE)
        painter.translate(self._picture_box.left(), self._picture_box.bottom())
        painter.scale(1.0, -1.0)
        box = QtCore.QRectF(0.0, 0.0, self._picture_box.width(), self._picture_box.height())
        painter.drawPixmap(box, self._picture, QtCore.QRectF(self._picture.rect()))
        painter.restore()

    def drawForeground(self, painter, rect):
        nodes = self._shown or self.nodes
        if nodes is None:
            return
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        path = QtGui.QPainterPath()
        for loop in nodes.loops:
            path.addPolygon(QtGui.QPolygonF([QtCore.QPointF(x, y) for x, y in to_mm(loop.points).tolist()]))
            path.closeSubpath()
        film = QtGui.QColor(_LINE)
        film.setAlphaF(0.18)
        painter.fillPath(path, film)
        painter.strokePath(path, _pen("#ffffff", 4.0))
        painter.strokePath(path, _pen(_LINE, 2.0))
        painter.resetTransform()
        for loop in nodes.loops:
            for at in loop.nodes:
                self._draw_node(painter, loop.points[at], loop.kinds[at] == CORNER)
        if self._box is not None:
            painter.setPen(_pen(_CHOSEN, 1.0))
            painter.setBrush(QtCore.Qt.NoBrush)
            painter.drawRect(self._box)

    def _draw_node(self, painter, place, sharp: bool) -> None:
        at = QtCore.QPointF(self.place_of(place))
        chosen = _key(place) in self.chosen or (self._shown is not None and self._is_dragged(place))
        painter.setPen(_pen("#000000", 1.4))
        painter.setBrush(QtGui.QColor(_CHOSEN if chosen else _NODE))
        half = _HALF + chosen
        handle = QtCore.QRectF(at.x() - half, at.y() - half, 2.0 * half, 2.0 * half)
        if sharp:  # a diamond, and a disc, as Inkscape has them
            painter.save()
            painter.translate(at)
            painter.rotate(45.0)
            painter.translate(-at)
            painter.drawRect(handle)
            painter.restore()
        else:
            painter.drawEllipse(handle)

    def _is_dragged(self, place) -> bool:
        if self._grip is None or self._by is None:
            return False
        return any(np.linalg.norm(np.array(each) + self._by - place) < 1e-9 for each in self.chosen)

    # the mouse

    def mousePressEvent(self, event):
        self.setFocus()
        at = position(event)
        if self._held is not None or self._pulled_from is not None:
            pass  # another button is down
        elif event.button() == QtCore.Qt.MiddleButton or self._space:
            self._pulled_from = at.toPoint()
        elif event.button() == QtCore.Qt.LeftButton and self.nodes is not None:
            self._held, self._fresh = at, False
            self._grip, self._by = self._node_at(at), None
            more = bool(event.modifiers() & QtCore.Qt.ShiftModifier)
            if self._grip is not None:
                self._choose(_key(self._grip), more)
        event.accept()

    def mouseMoveEvent(self, event):
        at = position(event)
        if not event.buttons():  # it was let go where nobody told us
            self._drop()
            self._pulled_from = None
        if self._pulled_from is not None:
            self.pull(at.toPoint() - self._pulled_from)
            self._pulled_from = at.toPoint()
        elif self._held is None:
            self._show_cursor(at)
        elif self._by is not None or self._box is not None or self._is_far(at):
            self._drag_to(at)

    def _is_far(self, at) -> bool:
        return (at - self._held).manhattanLength() >= 4

    def _drag_to(self, at) -> None:
        if self._grip is None:
            self._box = QtCore.QRectF(self._held, at).normalized()
            self.viewport().update()
        elif self.chosen:
            self._by = self.place_at(at) - self.place_at(self._held)
            self.dragged.emit(self._chosen_places(), self._by)

    def mouseReleaseEvent(self, event):
        if self._pulled_from is not None:
            self._pulled_from = None
            return
        if self._held is None or event.button() != QtCore.Qt.LeftButton:
            return
        at, grip, by, box = position(event), self._grip, self._by, self._box
        held, self._held, self._box = self._held, None, None
        more = bool(event.modifiers() & QtCore.Qt.ShiftModifier)
        if box is not None:
            self._choose_in(box, more)
        elif grip is not None and by is not None:
            places, self._by = self._chosen_places(), None
            self.moved.emit(places, by)
        elif grip is None:
            self._click(held)
        self._show_cursor(at)
        event.accept()

    def mouseDoubleClickEvent(self, event):
        """On a node: sharp or round; the second click of one that has just made a node does nothing."""
        grip = self._node_at(position(event)) if event.button() == QtCore.Qt.LeftButton else None
        if grip is not None and not self._fresh:
            self.toggled.emit([grip])
        elif grip is None:
            self.mousePressEvent(event)

    def _click(self, at) -> None:
        """Beside all nodes: on the line a new one, else nothing is picked."""
        place = self._on_line(at)
        if place is not None:
            self._fresh = True
            self.added.emit(place)
        else:
            self.chosen = []
            self.picked.emit()
            self.viewport().update()

    def _show_cursor(self, at) -> None:
        shape = QtCore.Qt.ArrowCursor
        if self._node_at(at) is not None:
            shape = QtCore.Qt.SizeAllCursor
        elif self._on_line(at) is not None:
            shape = QtCore.Qt.CrossCursor
        self.viewport().setCursor(shape)

    # what is picked

    def _choose(self, key: Place, more: bool) -> None:
        if more and key in self.chosen:
            self.chosen.remove(key)
        elif more:
            self.chosen.append(key)
        elif key not in self.chosen:
            self.chosen = [key]
        self.picked.emit()
        self.viewport().update()

    def _choose_in(self, box, more: bool) -> None:
        inside = [
            _key(place) for place in self._places() if box.contains(QtCore.QPointF(self.place_of(place)))
        ]
        self.chosen = [*(self.chosen if more else ()), *inside]
        self.chosen = list(dict.fromkeys(self.chosen))
        self.picked.emit()
        self.viewport().update()

    def choose_all(self) -> None:
        """Pick all nodes."""
        self.chosen = [_key(place) for place in self._places()]
        self.picked.emit()

    def choose_next(self, step: int = 1) -> None:
        """Pick the node after the one that is picked, or before it."""
        keys = [_key(place) for place in self._places()]
        at = keys.index(self.chosen[-1]) + step if self.chosen and self.chosen[-1] in keys else 0
        self.chosen = [keys[at % len(keys)]] if keys else []
        self.picked.emit()

    def _chosen_places(self) -> list[np.ndarray]:
        return [np.array(each) for each in self.chosen]

    def _places(self) -> np.ndarray:
        """All nodes (n, 2) m, loop after loop."""
        loops = () if self.nodes is None else self.nodes.loops
        return np.concatenate([np.zeros((0, 2)), *(loop.points[loop.nodes] for loop in loops)])

    def _node_at(self, at):
        """The node (2,) m at a point of the view, within a few pixels."""
        places = self._places()
        if not len(places):
            return None
        away = np.linalg.norm(places - self.place_at(at), axis=1)
        nearest = int(np.argmin(away))
        return places[nearest] if away[nearest] <= from_mm(NEAR / self.zoom) else None

    def _on_line(self, at):
        """The place (2,) m of the outline at a point of the view, within a few pixels."""
        if self.nodes is None:
            return None
        loops, place = [loop.points for loop in self.nodes.loops], self.place_at(at)[None]
        near = nearest_on_loops(loops, place).distance[0] <= from_mm(NEAR / self.zoom)
        return nearest_places(loops, place)[0] if near else None

    # keys

    def _action(self, event):
        """What a key does; None when it is not ours."""
        key, modifiers = event.key(), event.modifiers() & ~QtCore.Qt.KeypadModifier
        if self._held is not None:  # one thing after the other
            return self._let_go if key == QtCore.Qt.Key_Escape else _nothing
        shift = bool(modifiers & QtCore.Qt.ShiftModifier)
        if modifiers & QtCore.Qt.ControlModifier:
            return {
                QtCore.Qt.Key_Z: self.redone.emit if shift else self.undone.emit,
                QtCore.Qt.Key_Y: self.redone.emit,
                QtCore.Qt.Key_A: self.choose_all,
            }.get(key)
        if modifiers & ~QtCore.Qt.ShiftModifier:
            return None
        if key in _ARROWS:
            return lambda: self._push(np.array(_ARROWS[key]) * (_PUSH_FAR if shift else _PUSH))
        return {
            FIT: self.fit,
            LARGER: lambda: self.zoom_by(STEP),
            SMALLER: lambda: self.zoom_by(1.0 / STEP),
            PULL: self._take_hold,
            QtCore.Qt.Key_Delete: lambda: self._emit_chosen(self.removed),
            QtCore.Qt.Key_Backspace: lambda: self._emit_chosen(self.removed),
            QtCore.Qt.Key_S: lambda: self._emit_chosen(self.toggled),
            QtCore.Qt.Key_Tab: self.choose_next,
            QtCore.Qt.Key_Backtab: lambda: self.choose_next(-1),
            QtCore.Qt.Key_F6: lambda: super(NodeView, self).focusNextPrevChild(not shift),
            QtCore.Qt.Key_Escape: self._let_go,
        }.get(key)

    def focusNextPrevChild(self, onward):
        """The Tab key goes to the next node, F6 to the next widget."""
        return False

    def keyReleaseEvent(self, event):
        if event.key() == PULL and not event.isAutoRepeat():
            self._space = False
        super().keyReleaseEvent(event)

    def _take_hold(self) -> None:
        self._space = True

    def _push(self, pixels: np.ndarray) -> None:
        if self.chosen:
            self.moved.emit(self._chosen_places(), from_mm(pixels / self.zoom))

    def _emit_chosen(self, signal) -> None:
        if self.chosen:
            signal.emit(self._chosen_places())

    def _let_go(self) -> None:
        """Esc: of what is dragged, then of what is picked, then of the editor."""
        if self._held is not None:
            self._drop()
        elif self.chosen:
            self.chosen = []
            self.picked.emit()
        else:
            self.left.emit()
        self.viewport().update()

    def _drop(self) -> None:
        """What is dragged goes back to where it was."""
        if self._held is not None:
            self._held = self._box = self._grip = self._by = self._shown = None
            self.viewport().update()


def _nothing() -> None:
    pass


def _key(place) -> Place:
    return float(place[0]), float(place[1])


def _pen(colour: str, width: float):
    """As wide on the screen at every zoom, in pixels."""
    pen = QtGui.QPen(QtGui.QColor(colour), width)
    pen.setCosmetic(True)
    return pen

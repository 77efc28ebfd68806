# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panels of a bag side by side: each seam has its colour and number on both edges; edges are picked."""

from __future__ import annotations

import math

import numpy as np

from BalloonWorkbench.core.geometry.polyline import bounds, length, line_lengths, point_on
from BalloonWorkbench.gui.bags.bag_edges import BagEdges, PanelEdge
from BalloonWorkbench.gui.bags.seam_colours import FREE, WRONG, panel_tint, seam_colour
from BalloonWorkbench.gui.qt import QtCore, QtGui, QtWidgets, painter_on, position, translate
from BalloonWorkbench.gui.window.user_units import length_text

_LEAST, _MOST, _FORM = 170, 300, 0.75  # px, px, height over width
_SWING = 24  # px, see Preview in drawing_preview.py
_MARGIN = 10  # px
_NEAR = 9.0  # px within which an edge is meant
_LINE, _THICK = 2.5, 6.0  # px
_BESIDE = 10.0  # px from an edge to its number


class FlatView(QtWidgets.QWidget):
    """Shows a bag, `shown`; `clicked` carries the edge, a PanelEdge, and the name of its piece there.

    With keys, arrows go from edge to edge and Space picks the one with the ring.
    """

    clicked = QtCore.Signal(object, str)

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setObjectName("FlatPanels")
        self.setMinimumHeight(_LEAST)
        self.setMouseTracking(True)
        self.setFocusPolicy(QtCore.Qt.StrongFocus)
        self.setAccessibleName(translate("Edges of the panels"))
        self.shown: BagEdges | None = None
        self._chosen: int | None = None
        self._picked = ""
        self._at = 0  # the edge that keys are at, by its number
        self._box = QtCore.QRectF()

    def show_bag(self, shown: BagEdges | None) -> None:
        """Show a bag."""
        self.shown = shown
        self._go(0)
        if shown is not None:
            everything = np.concatenate([loop for loops in shown.loops for loop in loops])
            (left, low), (right, high) = bounds(everything)
            self._box = QtCore.QRectF(left, low, right - left, high - low)
        self.update()

    def choose(self, seam: int | None) -> None:
        """Draw both edges of a seam thick."""
        self._chosen = seam
        self.update()

    def pick(self, name: str) -> None:
        """Draw an edge that waits for its partner thick; no name: none waits."""
        self._picked = name
        self.update()

    def place_of(self, edge: PanelEdge):
        """Where in the widget an edge has its middle, in px."""
        return self._transform().map(QtCore.QPointF(*_middle(edge.line)))

    @property
    def _edges(self) -> list[PanelEdge]:
        return [] if self.shown is None else self.shown.edges

    # the mouse

    def mouseMoveEvent(self, event):
        nearest_edge = self._edge_at(position(event))
        self.setCursor(QtCore.Qt.ArrowCursor if nearest_edge is None else QtCore.Qt.PointingHandCursor)
        self.setToolTip("" if nearest_edge is None else _tip(nearest_edge[0]))

    def mousePressEvent(self, event):
        nearest_edge = self._edge_at(position(event)) if event.button() == QtCore.Qt.LeftButton else None
        if nearest_edge is None:
            event.ignore()
        else:
            self.clicked.emit(*nearest_edge)

    # the keys

    def keyPressEvent(self, event):
        ahead = (QtCore.Qt.Key_Right, QtCore.Qt.Key_Down)
        back = (QtCore.Qt.Key_Left, QtCore.Qt.Key_Up)
        if not self._edges or event.key() not in (*ahead, *back, QtCore.Qt.Key_Space):
            super().keyPressEvent(event)
        elif event.key() == QtCore.Qt.Key_Space:
            edge = self._edges[self._at]
            self.clicked.emit(edge, edge.names[len(edge.names) // 2])
        else:
            self._go(1 if event.key() in ahead else -1)

    def focusInEvent(self, event):
        super().focusInEvent(event)
        self.update()

    def focusOutEvent(self, event):
        super().focusOutEvent(event)
        self.update()

    def _go(self, steps: int) -> None:
        """Take the ring so many edges on; screen readers say what it is at."""
        self._at = (self._at + steps) % max(len(self._edges), 1)
        self.setAccessibleDescription(_tip(self._edges[self._at]) if self._edges else "")
        self.update()

    def _edge_at(self, place) -> tuple[PanelEdge, str] | None:
        """The edge that is nearest to a place in the widget, within a few pixels, and its piece there."""
        back, regular = self._transform().inverted()
        if not self._edges or not regular:
            return None
        at = back.map(place)
        away = [_distances(edge.line, (at.x(), at.y())) for edge in self._edges]
        nearest = int(np.argmin([each.min() for each in away]))
        if away[nearest].min() * self._scale() > _NEAR:
            return None
        return self._edges[nearest], self._edges[nearest].names[int(np.argmin(away[nearest]))]

    # the picture

    def resizeEvent(self, event):
        super().resizeEvent(event)
        height = int(min(max(_FORM * self.width(), _LEAST), _MOST))
        if abs(height - self.minimumHeight()) > _SWING:
            self.setMinimumHeight(height)

    def _scale(self) -> float:
        """Pixels of a millimetre."""
        if self._box.isEmpty():
            return 1.0
        room = self.rect().adjusted(_MARGIN, _MARGIN, -_MARGIN, -_MARGIN)
        return max(min(room.width() / self._box.width(), room.height() / self._box.height()), 1e-9)

    def _transform(self):
        scale, middle = self._scale(), self._box.center()
        transform = QtGui.QTransform()
        transform.translate(0.5 * self.width(), 0.5 * self.height())
        transform.scale(scale, -scale)
        transform.translate(-middle.x(), -middle.y())
        return transform

    def paintEvent(self, event):
        with painter_on(self) as painter:
            self._paint(painter)

    def _paint(self, painter) -> None:
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        painter.fillRect(self.rect(), self.palette().base())
        transform = self._transform()
        painter.setPen(QtCore.Qt.NoPen)
        if self.shown is None:
            return
        shown = self.shown
        for number, loops in enumerate(shown.loops):
            painter.setBrush(QtGui.QColor.fromRgbF(*panel_tint(number)))
            painter.drawPath(_area(loops, transform))
        for edge in shown.edges:
            self._draw(painter, edge, transform)
        numbered = [edge for edge in shown.edges if edge.seam is not None]
        taken = [_label(painter, str(edge.seam + 1), self._inside(edge, transform)) for edge in numbered]
        for panel, loops in zip(shown.bag.panels, shown.loops):
            _name(painter, panel.name, _area(loops, transform), taken)
        if self.hasFocus() and shown.edges:
            _focus_ring(painter, transform.map(QtCore.QPointF(*_middle(shown.edges[self._at].line))))
        if shown.opening is not None:
            _ring(painter, transform.map(QtCore.QPointF(*shown.opening.tolist())))

    def _inside(self, edge: PanelEdge, transform):
        """Beside the middle of an edge, on its panel: the numbers of neighbours stay apart."""
        at = transform.map(QtCore.QPointF(*_middle(edge.line)))
        middle = _area(self.shown.loops[edge.panel], transform).boundingRect().center()
        away = middle - at
        return at + away * (_BESIDE / max(math.hypot(away.x(), away.y()), _BESIDE))

    def _draw(self, painter, edge: PanelEdge, transform) -> None:
        wrong = self.shown is not None and edge.seam in self.shown.wrong
        thick = edge.seam == self._chosen if edge.seam is not None else self._picked in edge.names
        colour = FREE if edge.seam is None else WRONG if wrong else seam_colour(edge.seam)
        pen = QtGui.QPen(QtGui.QColor.fromRgbF(*colour), _THICK if thick else _LINE)
        if edge.seam is None or wrong:
            pen.setStyle(QtCore.Qt.DashLine)
        painter.setPen(pen)
        painter.drawPolyline(_polygon(edge.line, transform))


def _polygon(line: np.ndarray, transform):
    return transform.map(QtGui.QPolygonF([QtCore.QPointF(x, y) for x, y in line.tolist()]))


def _area(loops, transform):
    path = QtGui.QPainterPath()
    for loop in loops:
        path.addPolygon(_polygon(loop, transform))
        path.closeSubpath()
    return path


def _middle(line: np.ndarray) -> tuple[float, float]:
    """The point half along a line."""
    along = line_lengths(line)
    x, y = point_on(line, along, 0.5 * along[-1:])[0]
    return x, y


def _distances(line: np.ndarray, point: tuple[float, float]) -> np.ndarray:
    """How far a point is from each piece of a line, (k - 1,)."""
    start, ahead = line[:-1], np.diff(line, axis=0)
    square = np.maximum(np.einsum("ij,ij->i", ahead, ahead), 1e-30)
    share = np.clip(np.einsum("ij,ij->i", point - start, ahead) / square, 0.0, 1.0)
    away: np.ndarray = np.linalg.norm(start + share[:, None] * ahead - point, axis=1)
    return away


def _tip(edge: PanelEdge) -> str:
    text = length_text(length(edge.line))
    if edge.seam is not None:
        return translate("Seam {}: {}").format(edge.seam + 1, text)
    return translate("In no seam yet: {}").format(text)


def _name(painter, text: str, area, taken: list) -> None:
    """The name of a panel in its middle, where there is room beside the numbers."""
    box = QtCore.QRectF(painter.fontMetrics().boundingRect(text)).adjusted(-1, 0, 1, 0)
    box.moveCenter(area.boundingRect().center())
    if area.contains(box) and not any(box.intersects(other) for other in taken):
        painter.setPen(QtCore.Qt.black)
        painter.drawText(box, QtCore.Qt.AlignCenter, text)


def _label(painter, text: str, at):
    """A number on a light ground, whatever is below it; returns its box."""
    box = QtCore.QRectF(painter.fontMetrics().boundingRect(text)).adjusted(-3, -1, 3, 1)
    box.moveCenter(at)
    painter.setPen(QtCore.Qt.NoPen)
    painter.setBrush(QtGui.QColor(255, 255, 255, 220))
    painter.drawRoundedRect(box, 3, 3)
    painter.setPen(QtCore.Qt.black)
    painter.drawText(box, QtCore.Qt.AlignCenter, text)
    return box


def _ring(painter, at) -> None:
    """Where the bag is filled."""
    painter.setBrush(QtCore.Qt.white)
    painter.setPen(QtGui.QPen(QtCore.Qt.black, 2.0))
    painter.drawEllipse(at, 5.0, 5.0)


def _focus_ring(painter, at) -> None:
    """Round the middle of the edge that keys are at: dark on light, so that it is seen on any ground."""
    painter.setBrush(QtCore.Qt.NoBrush)
    for colour, width in ((QtCore.Qt.white, 5.0), (QtCore.Qt.black, 2.0)):
        painter.setPen(QtGui.QPen(colour, width))
        painter.drawEllipse(at, _BESIDE, _BESIDE)

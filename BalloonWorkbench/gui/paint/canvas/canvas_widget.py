# SPDX-License-Identifier: LGPL-2.1-or-later
"""The canvas: mouse, tablet and keys go to the hand, wheel and middle button move the paper."""

from __future__ import annotations

from BalloonWorkbench.gui.paint.canvas.overlay import Overlay
from BalloonWorkbench.gui.paint.canvas.paper import Paper
from BalloonWorkbench.gui.paint.canvas.scale import Scale
from BalloonWorkbench.gui.paint.canvas.stroke_input import StrokeInput
from BalloonWorkbench.gui.paint.canvas.thin import ThinPlaces
from BalloonWorkbench.gui.paint.painting.painted import SIDE, Painting
from BalloonWorkbench.gui.paint.painting.strokes import LINE
from BalloonWorkbench.gui.paint.painting.tools import MOVE, TOOLS
from BalloonWorkbench.gui.qt import QtCore, QtGui, QtWidgets, is_eraser, position
from BalloonWorkbench.gui.window.zoom_keys import FIT, LARGER, PULL, SMALLER, STEP, OwnKeys, wheel_zoom

_CLOSE = 2.0  # px on the screen between two points of a stroke
_TRACING = 0.45  # opacity of the backdrop
_LETTERS = {"M", "[", "]"} | {tool.key for tool in TOOLS}


class Canvas(OwnKeys, QtWidgets.QWidget):
    """Shows a painting and what is told about it, and lets the user paint.

    `chosen` carries the letter of a tool or setting, `accepted` the number of a remark to be repaired.
    """

    chosen = QtCore.Signal(str)
    accepted = QtCore.Signal(int)
    resized = QtCore.Signal()

    def __init__(self, painting: Painting, parent=None):
        super().__init__(parent)
        self.setObjectName("Canvas")
        self.setMinimumSize(300, 260)
        self.setMouseTracking(True)
        self.setFocusPolicy(QtCore.Qt.StrongFocus)
        self.setAttribute(QtCore.Qt.WA_OpaquePaintEvent)
        self.painting = painting
        self.hand = StrokeInput(painting, self)
        self.paper = Paper(self)
        self.overlay, self.thin, self.scale = Overlay(), ThinPlaces(), Scale()
        self._held = None  # where the paper is held
        self._space = False
        self._pointer: QtCore.QPointF | None = None
        self._compressed: bool | None = None  # whether Qt did that with moves before the canvas was seen
        painting.changed.connect(self.update)

    # mouse and tablet

    def showEvent(self, event):
        super().showEvent(event)
        self._every_move(True)

    def hideEvent(self, event):
        self._every_move(False)
        super().hideEvent(event)

    def _every_move(self, every: bool) -> None:
        """Have each movement of the mouse: Qt leaves out those that came while the window was busy.

        That is a choice for the whole program, so it holds only as long as the canvas is seen.
        """
        compressing = QtCore.Qt.AA_CompressHighFrequencyEvents
        if every and self._compressed is None:
            self._compressed = QtCore.QCoreApplication.testAttribute(compressing)
            QtCore.QCoreApplication.setAttribute(compressing, False)
        elif not every and self._compressed is not None:
            QtCore.QCoreApplication.setAttribute(compressing, self._compressed)
            self._compressed = None

    def mousePressEvent(self, event):
        self.setFocus()
        point = position(event)
        left = event.button() == QtCore.Qt.LeftButton
        if event.button() == QtCore.Qt.MiddleButton or (left and self._is_pulling()):
            self._held = point
            self.setCursor(QtCore.Qt.ClosedHandCursor)
        elif left:
            self._press(point)
        elif event.button() == QtCore.Qt.RightButton and self.hand.bending:
            self.hand.finish_line()
        self.update()
        event.accept()

    def mouseMoveEvent(self, event):
        point = self._pointer = position(event)
        if self._held is not None:
            self.paper.pull(point - self._held)
            self._held = point
        elif self.hand.bending or event.buttons() & QtCore.Qt.LeftButton:
            self._draw_on(point)
        else:
            self.setCursor(
                QtCore.Qt.PointingHandCursor if self.thin.answer_at(point) else QtCore.Qt.ArrowCursor
            )
        self.update()
        event.accept()

    def mouseReleaseEvent(self, event):
        if self._held is not None:
            self._held = None
            self.unsetCursor()
        elif event.button() == QtCore.Qt.LeftButton and not self.hand.bending:
            self.hand.end()
        event.accept()

    def tabletEvent(self, event):
        point = self._pointer = position(event)
        kind = event.type()
        if self._is_pulling():
            event.ignore()  # Qt makes a mouse event of it
            return
        if kind == QtCore.QEvent.TabletPress:
            self.setFocus()
            self._press(point, event.pressure(), is_eraser(event))
        elif kind == QtCore.QEvent.TabletMove and (event.pressure() > 0.0 or self.hand.bending):
            self._draw_on(point, event.pressure())
        elif kind == QtCore.QEvent.TabletRelease and not self.hand.bending:
            self.hand.end()
        self.update()
        event.accept()

    def _press(self, point, pressure: float = 1.0, erase: bool = False) -> None:
        answer = self.thin.answer_at(point) if self.hand.stroke is None else None
        if answer is None:
            self.hand.begin(self.paper.to_paper(point), pressure, erase)
        elif answer.yes:
            self.accepted.emit(answer.number)
        else:
            self.thin.dismiss(answer.number)

    def _draw_on(self, point, pressure: float = 1.0) -> None:
        self.hand.move(self.paper.to_paper(point), pressure, _CLOSE / self.paper.zoom)

    def _is_pulling(self) -> bool:
        return self._space or self.hand.tool.name == MOVE

    def wheelEvent(self, event):
        if event.angleDelta().y():
            self.paper.zoom_by(wheel_zoom(event), position(event))
        event.accept()

    def leaveEvent(self, event):
        self._pointer = None
        self.update()

    def resizeEvent(self, event):
        super().resizeEvent(event)
        self.resized.emit()

    # keys

    def keyReleaseEvent(self, event):
        if event.key() == PULL and not event.isAutoRepeat():
            self._space = False
            self.unsetCursor()
        else:
            super().keyReleaseEvent(event)

    def _action(self, event):
        """What a key does; None when it is not ours."""
        ctrl_y = event.key() == QtCore.Qt.Key_Y and event.modifiers() == QtCore.Qt.ControlModifier
        if event.matches(QtGui.QKeySequence.Undo):
            return self.painting.undo if self.hand.stroke is None else self.hand.cancel
        if event.matches(QtGui.QKeySequence.Redo) or ctrl_y:
            return self.painting.redo
        actions = {
            QtCore.Qt.Key_Escape: self.hand.cancel,
            PULL: self._take_paper,
            FIT: self.paper.fit,
            LARGER: lambda: self.paper.zoom_by(STEP),
            SMALLER: lambda: self.paper.zoom_by(1 / STEP),
        }
        for key, action in actions.items():
            if event.key() == key:
                return action
        letter = event.text().upper()
        return (lambda: self.chosen.emit(letter)) if letter in _LETTERS else None

    def _take_paper(self) -> None:
        self._space = True
        self.setCursor(QtCore.Qt.OpenHandCursor)

    # looks

    def paintEvent(self, event):
        painter = QtGui.QPainter(self)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        painter.setRenderHint(QtGui.QPainter.SmoothPixmapTransform, self.paper.zoom < 3)
        painter.fillRect(self.rect(), self.palette().dark())
        painter.translate(self.paper.origin())
        painter.scale(self.paper.zoom, self.paper.zoom)
        self._paint_paper(painter, QtCore.QRectF(0, 0, SIDE, SIDE))
        painter.resetTransform()
        for layer in (self.scale, self.overlay, self.thin):
            layer.paint(painter, self)
        self._paint_pointer(painter)
        painter.end()  # now, not when Python forgets it

    def _paint_paper(self, painter, paper) -> None:
        painter.fillRect(paper, QtCore.Qt.white)
        painter.setClipRect(paper)
        if self.painting.backdrop is not None:
            painter.setOpacity(_TRACING)
            self.painting.backdrop.draw(painter, paper)
            painter.setOpacity(1.0)
        painter.drawImage(paper, self.painting.image)
        stroke = self.hand.stroke
        if stroke is not None and stroke.tool == LINE:
            stroke.paint_whole(painter, SIDE)
        painter.setClipping(False)
        if self.hand.mirror:
            axis = QtGui.QPen(QtGui.QColor("#1f78d8"), 1.5, QtCore.Qt.DashLine)
            axis.setCosmetic(True)
            painter.setPen(axis)
            painter.drawLine(QtCore.QPointF(SIDE / 2, 0), QtCore.QPointF(SIDE / 2, SIDE))

    def _paint_pointer(self, painter) -> None:
        """A ring as wide as the stroke will be."""
        radius = 0.5 * self.hand.reach() * self.paper.zoom
        if self._pointer is None or not radius or self._held is not None:
            return
        for colour, width in (("#ffffff", 2.4), ("#404040", 1.0)):
            painter.setPen(QtGui.QPen(QtGui.QColor(colour), width))
            painter.setBrush(QtCore.Qt.NoBrush)
            painter.drawEllipse(self._pointer, radius, radius)

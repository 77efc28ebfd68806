# SPDX-License-Identifier: LGPL-2.1-or-later
"""The canvas: mouse, tablet and keys go to the hand, wheel and middle button move the paper."""

from __future__ import annotations

from BalloonWorkbench.gui.paint.canvas.floating import STEP as TURN_STEP
from BalloonWorkbench.gui.paint.canvas.floating import FloatingPicture
from BalloonWorkbench.gui.paint.canvas.inputs import (
    AxisInput,
    Pipette,
    SelectInput,
    StampInput,
    paint_symmetry,
)
from BalloonWorkbench.gui.paint.canvas.key_pointer import KeyPointer
from BalloonWorkbench.gui.paint.canvas.overlay import Overlay
from BalloonWorkbench.gui.paint.canvas.paper import Paper
from BalloonWorkbench.gui.paint.canvas.scale import Scale
from BalloonWorkbench.gui.paint.canvas.stroke_input import StrokeInput
from BalloonWorkbench.gui.paint.canvas.thin import ThinPlaces
from BalloonWorkbench.gui.paint.canvas.words_input import WordsInput
from BalloonWorkbench.gui.paint.painting import tools
from BalloonWorkbench.gui.paint.painting.incoming import can_be_pasted
from BalloonWorkbench.gui.paint.painting.layers import SIDE
from BalloonWorkbench.gui.paint.painting.painted import Painting
from BalloonWorkbench.gui.paint.painting.strokes import LINE
from BalloonWorkbench.gui.qt import QtCore, QtGui, QtWidgets, is_eraser, position, translate
from BalloonWorkbench.gui.tabs.zoom_keys import FIT, LARGER, PULL, SMALLER, STEP, OwnKeys, wheel_zoom

_CLOSE = 2.0  # px on the screen between two points of a stroke
_TRACING = 0.45  # opacity of the backdrop
_LETTERS = {*"M[]QDK,.12345678"} | {tool.key for tool in (*tools.TOOLS, *tools.MORE_TOOLS)}
_TURNS = {"[": -TURN_STEP, "]": TURN_STEP}  # of what is being placed, degrees
_ENTER = (QtCore.Qt.Key_Return, QtCore.Qt.Key_Enter)
#: What is done with the clipboard, by Qt's keys for it.
_CLIPS = {
    "copy": QtGui.QKeySequence.Copy,
    "cut": QtGui.QKeySequence.Cut,
    "paste": QtGui.QKeySequence.Paste,
    "all": QtGui.QKeySequence.SelectAll,
}


class Canvas(OwnKeys, QtWidgets.QWidget):
    """Shows a painting and what is told about it, and lets the user paint.

    `chosen` carries the letter of a tool or setting, `accepted` the number of a remark to be repaired,
    `clipped` what is to be done with the clipboard, `dropped` what was dropped (QMimeData) and where.
    """

    chosen = QtCore.Signal(str)
    accepted = QtCore.Signal(int)
    clipped = QtCore.Signal(str)
    dropped = QtCore.Signal(object, object)
    resized = QtCore.Signal()

    def __init__(self, painting: Painting, parent=None):
        super().__init__(parent)
        self.setObjectName("Canvas")
        self.setMinimumSize(300, 260)
        self.setMouseTracking(True)
        self.setFocusPolicy(QtCore.Qt.StrongFocus)
        self.setAttribute(QtCore.Qt.WA_OpaquePaintEvent)
        self.painting = painting
        self.setAcceptDrops(True)
        self.setAccessibleName(translate("Paper"))
        self.hand = StrokeInput(painting, self)
        self.floating = FloatingPicture(painting, self.hand, self)
        self.words = WordsInput(self.floating, self.hand, self)
        self.stamp, self.selection = StampInput(painting, self.hand, self), SelectInput(self.hand, self)
        self.pipette, self.axis = Pipette(painting, self.hand, self), AxisInput(self.hand, self)
        self._inputs = {
            tools.TEXT: self.words,
            tools.STAMP: self.stamp,
            tools.SELECT: self.selection,
            tools.PIPETTE: self.pipette,
            tools.AXIS: self.axis,
        }
        self._keys = KeyPointer()
        self.paper = Paper(self)
        self.overlay, self.thin, self.scale = Overlay(), ThinPlaces(), Scale()
        self._held = None  # where the paper is held
        self._space = False
        self.pointer: QtCore.QPointF | None = None
        self._compressed: bool | None = None  # whether Qt did that with moves before the canvas was seen
        painting.changed.connect(self.update)
        self.floating.changed.connect(self.update)

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
        if left or self._keys.is_down:
            self._release()  # what the keys have begun, or the mouse when its button came up elsewhere
        self._keys.leave()
        if self._held is not None or self._is_at_work():
            pass  # another button is down
        elif event.button() == QtCore.Qt.MiddleButton or (left and self._is_pulling()):
            self._held = point
            self.setCursor(QtCore.Qt.ClosedHandCursor)
        elif left:
            self._press(point, shift=_with_shift(event))
        elif event.button() == QtCore.Qt.RightButton and self.hand.bending:
            self.hand.finish_line()
        self.update()
        event.accept()

    def mouseMoveEvent(self, event):
        point = self.pointer = position(event)
        if self._held is not None:
            self.paper.pull(point - self._held)
            self._held = point
        elif self.hand.bending or event.buttons() & QtCore.Qt.LeftButton:
            self._draw_on(point, shift=_with_shift(event))
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
        elif event.button() == QtCore.Qt.LeftButton:
            self._release()
        event.accept()

    def tabletEvent(self, event):
        """The pressure counts, the tilt of the pen does not."""
        point = self.pointer = position(event)
        kind = event.type()
        if self._is_pulling():
            event.ignore()  # Qt makes a mouse event of it
            return
        if kind == QtCore.QEvent.TabletPress:
            self.setFocus()
            self._release()
            self._keys.leave()
            self._press(point, event.pressure(), is_eraser(event), _with_shift(event))
        elif kind == QtCore.QEvent.TabletMove and (event.pressure() > 0.0 or self.hand.bending):
            self._draw_on(point, event.pressure(), _with_shift(event))
        elif kind == QtCore.QEvent.TabletRelease:
            self._release()
        self.update()
        event.accept()

    def _press(self, point, pressure: float = 1.0, erase: bool = False, shift: bool = False) -> None:
        at, zoom = self.paper.to_paper(point), self.paper.zoom
        if self.floating.is_there():
            if not self.floating.begin(at, zoom):
                self.floating.confirm()
            return
        answer = self.thin.answer_at(point) if self.hand.stroke is None else None
        if answer is not None and answer.yes:
            self.accepted.emit(answer.number)
        elif answer is not None:
            self.thin.dismiss(answer.number)
        elif self._input() is not None and not erase:
            self._input().begin(at, zoom, shift)
        else:
            self.hand.begin(at, pressure, erase)

    def _draw_on(self, point, pressure: float = 1.0, shift: bool = False) -> None:
        at = self.paper.to_paper(point)
        if self.floating.is_held():
            self.floating.move(at, shift)
        elif self._input() is not None and self._input().is_at_work():
            self._input().move(at, shift)
        else:
            self.hand.move(at, pressure, _CLOSE / self.paper.zoom)

    def _release(self) -> None:
        if self.floating.is_held():
            self.floating.end()
        elif self._input() is not None and self._input().is_at_work():
            self._input().end()
        elif not self.hand.bending:
            self.hand.end()

    def _is_idle(self) -> bool:
        """Nothing is being drawn or placed."""
        return self.hand.stroke is None and not self.floating.is_there() and not self._is_at_work()

    def _is_at_work(self) -> bool:
        """Something follows the pointer until its button comes up."""
        works = (self.hand, *self._inputs.values())
        return self.floating.is_held() or any(each.is_at_work() for each in works)

    def _input(self):
        """What the tool does; None for those of strokes."""
        return self._inputs.get(self.hand.tool.name)

    def _is_pulling(self) -> bool:
        return self._space or self.hand.tool.name == tools.MOVE

    def is_moving_axis(self) -> bool:
        """The axis of symmetry is what the pointer moves."""
        return self.hand.tool.name == tools.AXIS

    def cancel(self) -> None:
        """Drop what is being placed, else what is being drawn with any tool."""
        self._keys.is_down = False
        if self.floating.is_there():
            self.floating.drop()
            return
        self.hand.cancel()
        for each in self._inputs.values():
            each.cancel()
        self.update()

    def finish(self) -> None:
        """What is being drawn or placed is painted: something else begins."""
        self._keys.is_down = False
        for each in self._inputs.values():
            if each.is_at_work():
                each.end()
        self.floating.confirm()
        self.hand.end()

    def dragEnterEvent(self, event):
        if can_be_pasted(event.mimeData()):
            event.acceptProposedAction()

    def dropEvent(self, event):
        self.dropped.emit(event.mimeData(), self.paper.to_paper(position(event)))
        event.acceptProposedAction()

    def wheelEvent(self, event):
        if event.angleDelta().y():
            self.paper.zoom_by(wheel_zoom(event), position(event))
        event.accept()

    def leaveEvent(self, event):
        self.pointer = None
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
            return self.painting.undo if self._is_idle() else self.cancel
        if event.matches(QtGui.QKeySequence.Redo) or ctrl_y:
            return lambda: self.painting.redo() if self._is_idle() else None
        for name, keys in _CLIPS.items():
            if event.matches(keys):
                return lambda name=name: self.clipped.emit(name)
        way = KeyPointer.way(event)
        if way is not None:
            return lambda: self._go(way)
        if event.key() in _ENTER:
            return self._enter
        actions = {
            QtCore.Qt.Key_Escape: self.cancel,
            PULL: self._take_paper,
            FIT: self.paper.fit,
            LARGER: lambda: self._zoom(STEP),
            SMALLER: lambda: self._zoom(1 / STEP),
        }
        for key, action in actions.items():
            if event.key() == key:
                return action
        letter = event.text().upper()
        if letter in _TURNS and self.floating.is_there():
            return lambda: self.floating.turn_by(_TURNS[letter])
        return (lambda: self.chosen.emit(letter)) if letter in _LETTERS else None

    def _go(self, way) -> None:
        """An arrow key: what is being placed moves, else the pointer."""
        if self.floating.is_there():
            self.floating.nudge(way.x() / self.paper.zoom, way.y() / self.paper.zoom)
            return
        self.pointer = self._keys.move(self, way)
        if self._keys.is_down or self.hand.bending:
            self._draw_on(self.pointer)

    def _enter(self) -> None:
        """The button of the pointer that the arrow keys move: down, or up again."""
        if self.floating.is_there():
            self.floating.confirm()
        elif self._keys.is_down:
            self._keys.is_down = False
            self._release()
        elif self._keys.place is not None:
            self._press(self._keys.place)
            at_work = self._input() or self.hand
            self._keys.is_down = at_work.is_at_work()

    def _zoom(self, factor: float) -> None:
        """What is being placed becomes larger or smaller, else the paper."""
        (self.floating.scale_by if self.floating.is_there() else self.paper.zoom_by)(factor)

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
        for layer in (self.scale, self.overlay, self.thin, self.floating, *self._inputs.values(), self._keys):
            layer.paint(painter, self)
        paint_symmetry(painter, self)
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
            stroke.paint_whole(painter)
        painter.setClipping(False)

    def _paint_pointer(self, painter) -> None:
        """A ring as wide as the stroke will be."""
        radius = 0.5 * self.hand.reach() * self.paper.zoom
        if self.pointer is None or not radius or self._held is not None:
            return
        for colour, width in (("#ffffff", 2.4), ("#404040", 1.0)):
            painter.setPen(QtGui.QPen(QtGui.QColor(colour), width))
            painter.setBrush(QtCore.Qt.NoBrush)
            painter.drawEllipse(self.pointer, radius, radius)


def _with_shift(event) -> bool:
    return bool(event.modifiers() & QtCore.Qt.ShiftModifier)

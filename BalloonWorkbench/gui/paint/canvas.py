# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paper: mouse and tablet become strokes; wheel and middle button move it."""

from __future__ import annotations

from BalloonWorkbench.gui.paint.overlay import Overlay
from BalloonWorkbench.gui.paint.painting import SIDE, Painting
from BalloonWorkbench.gui.paint.strokes import ERASER, FILL, LINE, PEN, Fill, Spill, Stroke
from BalloonWorkbench.gui.paint.tools import COLOURS, MOVE, THICKEST, THINNEST, TOOLS, USUAL
from BalloonWorkbench.gui.qt import QtCore, QtGui, QtWidgets, is_eraser, position, translate

_NEAREST, _FARTHEST = 16.0, 0.1  # zoom
_STEP = 1.25  # of the zoom for a notch of the wheel
_CLOSE = 2.0  # px on the screen between two points of a stroke
_BEND = 32  # pieces of a bent line
_TRACING = 0.45  # opacity of the backdrop


class Canvas(QtWidgets.QWidget):
    """Paints on a Painting. `growing` comes while a stroke is drawn, `told` is for the status line."""

    growing = QtCore.Signal()
    told = QtCore.Signal(str)
    chosen = QtCore.Signal(str)  # a tool by its key

    def __init__(self, painting: Painting, parent=None):
        super().__init__(parent)
        self.setObjectName("Canvas")
        self.setMinimumSize(300, 260)
        self.setMouseTracking(True)
        self.setFocusPolicy(QtCore.Qt.StrongFocus)
        self.setAttribute(QtCore.Qt.WA_OpaquePaintEvent)
        self.painting = painting
        self.tool, self.colour = TOOLS[0], COLOURS[0][0]
        self.thickness = USUAL
        self.mirror = False
        self.overlay = Overlay()
        self._zoom, self._origin = 0.0, QtCore.QPointF()  # 0: as large as fits
        self._stroke: Stroke | None = None
        self._bending = False
        self._held = None  # where the paper is held
        self._space = False
        self._pointer: QtCore.QPointF | None = None
        painting.changed.connect(self.update)

    # the view

    @property
    def zoom(self) -> float:
        """Screen pixels for one pixel of the painting."""
        return self._zoom or 0.94 * min(self.width(), self.height()) / SIDE

    def origin(self):
        """Where the upper left corner of the paper is."""
        if self._zoom:
            return self._origin
        return 0.5 * QtCore.QPointF(self.width() - self.zoom * SIDE, self.height() - self.zoom * SIDE)

    def to_paper(self, point):
        return (point - self.origin()) / self.zoom

    def to_screen(self, point):
        return self.origin() + self.zoom * point

    def zoom_by(self, factor: float, about=None) -> None:
        """Larger or smaller, the place under the pointer stays."""
        about = about or QtCore.QPointF(self.rect().center())
        fixed = self.to_paper(about)
        self._zoom = min(max(self.zoom * factor, _FARTHEST), _NEAREST)
        self._origin = about - self._zoom * fixed
        self.update()

    def fit(self) -> None:
        """The whole paper."""
        self._zoom = 0.0
        self.update()

    # painting

    def is_drawing(self) -> bool:
        return self._stroke is not None

    def begin(self, point, pressure: float = 1.0, erase: bool = False) -> None:
        """The pen goes down at a place of the widget."""
        at = self.to_paper(point)
        if self._bending:
            self._finish_line(at)
            return
        if self.tool.name == FILL and not erase:
            self._fill(at)
            return
        tool = next(tool for tool in TOOLS if tool.name == ERASER) if erase else self.tool
        self._stroke = Stroke(tool.name, self.colour, self.mirror)
        self._pressure_share, self._widening = tool.pressure, tool.widening
        self._add(at, pressure)

    def move(self, point, pressure: float = 1.0) -> None:
        """The pen is drawn on."""
        if self._stroke is None:
            return
        at = self.to_paper(point)
        if self._stroke.tool == LINE:
            self._pull(at)
            return
        last = self._stroke.points[-1]
        if (QtCore.QPointF(last[0], last[1]) - at).manhattanLength() * self.zoom >= _CLOSE:
            self._add(at, pressure)
            self.growing.emit()

    def end(self) -> None:
        """The pen goes up."""
        stroke = self._stroke
        if stroke is None:
            return
        if stroke.tool == LINE and not self._bending and len(stroke.points) > 1:
            self._bending = True
            self.told.emit(translate("Move the pointer to bend the line, then click. Esc drops it."))
            return
        if stroke.tool == LINE and len(stroke.points) < 2:
            self.cancel()
            return
        self._stroke, self._bending = None, False
        if stroke.tool == PEN and stroke.is_nearly_closed():
            stroke.points.append(stroke.points[0])
            stroke.paint_part(self.painting.image, len(stroke.points) - 1)
        if stroke.tool != LINE:
            stroke.paint_part(self.painting.image, len(stroke.points))
        self.painting.do(stroke, painted=stroke.tool != LINE)

    def cancel(self) -> None:
        """Drop the stroke that is being drawn."""
        if self._stroke is not None:
            self._stroke, self._bending = None, False
            self.painting.repaint()

    def _width(self, pressure: float) -> float:
        return self.thickness * self._widening * (1.0 - self._pressure_share * (1.0 - pressure))

    def _add(self, at, pressure: float) -> None:
        stroke = self._stroke
        stroke.points.append((at.x(), at.y(), self._width(pressure)))
        if stroke.tool != LINE:
            stroke.paint_part(self.painting.image, len(stroke.points) - 1)
        self.update()

    def _pull(self, at) -> None:
        """The end of a line, or its bow, follows the pointer."""
        points = self._stroke.points
        x, y, width = points[0]
        if not self._bending:
            points[1:] = [(at.x(), at.y(), width)]
        else:
            end = points[-1]
            # the bow goes through the pointer: control point of the parabola at half way
            cx, cy = 2.0 * at.x() - 0.5 * (x + end[0]), 2.0 * at.y() - 0.5 * (y + end[1])
            bow = []
            for step in range(1, _BEND):
                t = step / _BEND
                a, b, c = (1 - t) ** 2, 2 * t * (1 - t), t * t
                bow.append((a * x + b * cx + c * end[0], a * y + b * cy + c * end[1], width))
            points[1:] = [*bow, end]
        self.update()

    def _finish_line(self, at=None) -> None:
        if at is not None:
            self._pull(at)
        else:
            self._stroke.points[1:-1] = []
        self.end()

    def _fill(self, at) -> None:
        if not (0 <= at.x() < SIDE and 0 <= at.y() < SIDE):
            return
        try:
            self.painting.do(Fill(self.colour, at.x(), at.y(), self.mirror))
        except Spill:
            self.told.emit(translate("The colour would run out: close the line around this place first."))

    # events

    def mousePressEvent(self, event):
        self.setFocus()
        point = position(event)
        left = event.button() == QtCore.Qt.LeftButton
        if event.button() == QtCore.Qt.MiddleButton or (left and (self._space or self.tool.name == MOVE)):
            self._held = point
            self.setCursor(QtCore.Qt.ClosedHandCursor)
        elif left:
            self.begin(point)
        elif event.button() == QtCore.Qt.RightButton and self._bending:
            self._finish_line()
        event.accept()

    def mouseMoveEvent(self, event):
        point = self._pointer = position(event)
        if self._held is not None:
            self._origin, self._zoom = self.origin() + (point - self._held), self.zoom
            self._held = point
        elif self._bending or event.buttons() & QtCore.Qt.LeftButton:
            self.move(point)
        self.update()
        event.accept()

    def mouseReleaseEvent(self, event):
        if self._held is not None:
            self._held = None
            self.unsetCursor()
        elif event.button() == QtCore.Qt.LeftButton and not self._bending:
            self.end()
        event.accept()

    def tabletEvent(self, event):
        point = self._pointer = position(event)
        kind = event.type()
        if self.tool.name == MOVE or self._space:
            event.ignore()  # Qt makes a mouse event of it
            return
        if kind == QtCore.QEvent.TabletPress:
            self.setFocus()
            self.begin(point, event.pressure(), is_eraser(event))
        elif kind == QtCore.QEvent.TabletMove and (event.pressure() > 0.0 or self._bending):
            self.move(point, event.pressure())
        elif kind == QtCore.QEvent.TabletRelease and not self._bending:
            self.end()
        self.update()
        event.accept()

    def wheelEvent(self, event):
        notches = event.angleDelta().y() / 120.0
        if notches:
            self.zoom_by(_STEP**notches, position(event))
        event.accept()

    def leaveEvent(self, event):
        self._pointer = None
        self.update()

    def event(self, event):
        # FreeCAD would take these keys for its own shortcuts
        if event.type() == QtCore.QEvent.ShortcutOverride and self._knows(event):
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event):
        if event.matches(QtGui.QKeySequence.Undo):
            self.cancel() if self._stroke is not None else self.painting.undo()
        elif event.matches(QtGui.QKeySequence.Redo) or self._is_ctrl(event, QtCore.Qt.Key_Y):
            self.painting.redo()
        elif event.key() == QtCore.Qt.Key_Escape:
            self.cancel()
        elif event.key() == QtCore.Qt.Key_Space:
            self._space = True
            self.setCursor(QtCore.Qt.OpenHandCursor)
        elif event.key() == QtCore.Qt.Key_0:
            self.fit()
        elif event.key() in (QtCore.Qt.Key_Plus, QtCore.Qt.Key_Minus):
            self.zoom_by(_STEP if event.key() == QtCore.Qt.Key_Plus else 1 / _STEP)
        elif self._knows(event):
            self.chosen.emit(event.text().upper())
        else:
            super().keyPressEvent(event)

    def keyReleaseEvent(self, event):
        if event.key() == QtCore.Qt.Key_Space and not event.isAutoRepeat():
            self._space = False
            self.unsetCursor()
        else:
            super().keyReleaseEvent(event)

    def _knows(self, event) -> bool:
        letter = event.text().upper()
        return (
            event.matches(QtGui.QKeySequence.Undo)
            or event.matches(QtGui.QKeySequence.Redo)
            or self._is_ctrl(event, QtCore.Qt.Key_Y)
            or event.key()
            in (
                QtCore.Qt.Key_Escape,
                QtCore.Qt.Key_Space,
                QtCore.Qt.Key_0,
                QtCore.Qt.Key_Plus,
                QtCore.Qt.Key_Minus,
            )
            or letter in ("M", "[", "]")
            or (bool(letter) and letter in (tool.key for tool in TOOLS))
        )

    @staticmethod
    def _is_ctrl(event, key) -> bool:
        return event.key() == key and event.modifiers() == QtCore.Qt.ControlModifier

    def set_thickness(self, value: int) -> None:
        self.thickness = min(max(value, THINNEST), THICKEST)
        self.update()

    # looks

    def paintEvent(self, event):
        painter = QtGui.QPainter(self)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        painter.setRenderHint(QtGui.QPainter.SmoothPixmapTransform, self.zoom < 3)
        painter.fillRect(self.rect(), self.palette().dark())
        painter.translate(self.origin())
        painter.scale(self.zoom, self.zoom)
        paper = QtCore.QRectF(0, 0, SIDE, SIDE)
        painter.fillRect(paper, QtCore.Qt.white)
        painter.setClipRect(paper)
        if self.painting.backdrop is not None:
            painter.setOpacity(_TRACING)
            self.painting.backdrop.draw(painter, paper)
            painter.setOpacity(1.0)
        painter.drawImage(paper, self.painting.image)
        if self._stroke is not None and self._stroke.tool == LINE:
            self._paint_line(painter)
        painter.setClipping(False)
        if self.mirror:
            axis = QtGui.QPen(QtGui.QColor("#1f78d8"), 1.5, QtCore.Qt.DashLine)
            axis.setCosmetic(True)
            painter.setPen(axis)
            painter.drawLine(QtCore.QPointF(SIDE / 2, 0), QtCore.QPointF(SIDE / 2, SIDE))
        painter.resetTransform()
        self.overlay.paint(painter, self)
        self._paint_pointer(painter)

    def _paint_line(self, painter) -> None:
        path = QtGui.QPainterPath()
        for number, (x, y, _) in enumerate(self._stroke.points):
            path.lineTo(x, y) if number else path.moveTo(x, y)
        line = QtGui.QPen(QtGui.QColor(self.colour), self._stroke.points[0][2])
        line.setCapStyle(QtCore.Qt.RoundCap)
        line.setJoinStyle(QtCore.Qt.RoundJoin)
        painter.strokePath(path, line)
        if self.mirror:
            painter.save()
            painter.translate(SIDE, 0)
            painter.scale(-1, 1)
            painter.strokePath(path, line)
            painter.restore()

    def _paint_pointer(self, painter) -> None:
        """A ring as wide as the stroke will be."""
        if self._pointer is None or self.tool.name in (FILL, MOVE) or self._held is not None:
            return
        radius = 0.5 * self.thickness * self.tool.widening * self.zoom
        for colour, width in (("#ffffff", 2.4), ("#404040", 1.0)):
            painter.setPen(QtGui.QPen(QtGui.QColor(colour), width))
            painter.setBrush(QtCore.Qt.NoBrush)
            painter.drawEllipse(self._pointer, radius, radius)

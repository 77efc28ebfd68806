# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the hand does with stamps, rectangles, the pipette and the axis; strokes are in stroke_input.py."""

from __future__ import annotations

import math
from dataclasses import replace

from BalloonWorkbench.gui.paint.canvas.stroke_input import StrokeInput
from BalloonWorkbench.gui.paint.painting.layers import SIDE
from BalloonWorkbench.gui.paint.painting.painted import Painting
from BalloonWorkbench.gui.paint.painting.pieces import Box, Stamped
from BalloonWorkbench.gui.paint.painting.stamps import Stamp, stamps
from BalloonWorkbench.gui.qt import QtCore, QtGui

_CLICK = 8.0  # px of the paper; a shorter pull is a click
_CLICKED = 100.0  # px, half the width of a stamp that is put down by a click
_STEP = 15.0  # degrees by which a stamp is turned
_AWAY = 0.3  # of the paper's side, the ring that turns the axis from the centre
_REACH = 14.0  # px on the screen, that a pointer may be beside it
_BLUE = "#1f78d8"


class ToolInput(QtCore.QObject):
    """A press, moves and a release on the paper; places are pixels of the painting."""

    def __init__(self, hand: StrokeInput, parent=None):
        super().__init__(parent)
        self.hand = hand
        self.start: QtCore.QPointF | None = None

    def is_at_work(self) -> bool:
        """The button is down."""
        return self.start is not None

    def begin(self, at, zoom: float, shift: bool) -> None:
        """The button goes down; zoom: screen pixels for one of the painting."""
        self.start = QtCore.QPointF(at)
        self.move(at, shift)

    def move(self, at, shift: bool) -> None:
        """The pointer is moved with the button down."""

    def end(self) -> None:
        """The button comes up."""
        self.start = None

    def cancel(self) -> None:
        """What was begun is dropped."""
        self.start = None

    def paint(self, painter, canvas) -> None:
        """Draw over a canvas, in its coordinates."""


class StampInput(ToolInput):
    """Puts down a shape."""

    def __init__(self, painting: Painting, hand: StrokeInput, parent=None):
        super().__init__(hand, parent)
        self._painting = painting
        self.stamp: Stamp = stamps()[0]
        self._step: Stamped | None = None

    def move(self, at, shift: bool) -> None:
        way = at - self.start
        size = math.hypot(way.x(), way.y())
        turn = 0.0
        if size < _CLICK:
            size = _CLICKED
        elif not shift:
            turn = _STEP * round(math.degrees(math.atan2(way.y(), way.x())) / _STEP)
        points = self.stamp.at((self.start.x(), self.start.y()), size, turn)
        self._step = Stamped(self.hand.colour, points, self.hand.symmetry, self.hand.layer)

    def end(self) -> None:
        step, self._step = self._step, None
        super().end()
        if step is not None:
            self._painting.do(step)

    def cancel(self) -> None:
        self._step = None
        super().cancel()

    def paint(self, painter, canvas) -> None:
        if self._step is not None:
            painter.save()
            painter.translate(canvas.paper.origin())
            painter.scale(canvas.paper.zoom, canvas.paper.zoom)
            self._step.draw(painter)
            painter.restore()


class SelectInput(ToolInput):
    """Chooses a rectangle; box: left, top, width and height of what lies on the paper, None for no choice."""

    box: Box | None = None

    def move(self, at, shift: bool) -> None:
        chosen = QtCore.QRectF(self.start, at).normalized() & QtCore.QRectF(0, 0, SIDE, SIDE)
        is_click = min(chosen.width(), chosen.height()) < _CLICK
        self.box = None if is_click else whole(chosen)

    def cancel(self) -> None:
        self.box = None
        super().cancel()

    def paint(self, painter, canvas) -> None:
        if self.box is not None:
            paint_box(painter, on_screen(canvas, self.box))


class Pipette(ToolInput):
    """Takes the colour at a place: of the painting, or of the picture under it."""

    picked = QtCore.Signal(str)

    def __init__(self, painting: Painting, hand: StrokeInput, parent=None):
        super().__init__(hand, parent)
        self._painting = painting
        self._colour = ""

    def move(self, at, shift: bool) -> None:
        image, place = self._painting.image, at.toPoint()
        if not image.rect().contains(place):
            return
        colour = image.pixelColor(place)
        backdrop = self._painting.backdrop
        if colour.alpha() <= 127:
            colour = backdrop.colour_at(at) if backdrop is not None else None
        if colour is not None:
            self._colour = colour.name()

    def end(self) -> None:
        colour, self._colour = self._colour, ""
        super().end()
        if colour:
            self.picked.emit(colour)

    def paint(self, painter, canvas) -> None:
        if self._colour and canvas.pointer is not None:
            painter.setPen(QtGui.QPen(QtCore.Qt.white, 3.0))
            painter.setBrush(QtGui.QColor(self._colour))
            painter.drawEllipse(canvas.pointer + QtCore.QPointF(24, -24), 16, 16)


class AxisInput(ToolInput):
    """Moves the centre of the symmetry, or turns its axis by the ring on it."""

    changed = QtCore.Signal()

    def __init__(self, hand: StrokeInput, parent=None):
        super().__init__(hand, parent)
        self._before = hand.symmetry
        self._is_turning = False

    def begin(self, at, zoom: float, shift: bool) -> None:
        self._before = self.hand.symmetry
        ring = ring_of(self._before)
        self._is_turning = math.hypot(at.x() - ring.x(), at.y() - ring.y()) * zoom < _REACH
        super().begin(at, zoom, shift)

    def move(self, at, shift: bool) -> None:
        before, way = self._before, at - self.start
        if self._is_turning:
            angle = math.degrees(math.atan2(before.y - at.y(), at.x() - before.x))
            angle = _STEP * round(angle / _STEP) if shift else angle
            self.hand.symmetry = replace(before, angle=round(angle, 2))
        else:
            x, y = (min(max(place, 0.0), SIDE) for place in (before.x + way.x(), before.y + way.y()))
            self.hand.symmetry = replace(before, x=round(x, 2), y=round(y, 2))
        self.changed.emit()

    def cancel(self) -> None:
        if self.start is not None:
            self.hand.symmetry = self._before
        super().cancel()


def ring_of(symmetry):
    """Where the axis is turned."""
    turn = math.radians(symmetry.angle)
    return QtCore.QPointF(
        symmetry.x + _AWAY * SIDE * math.cos(turn), symmetry.y - _AWAY * SIDE * math.sin(turn)
    )


def paint_symmetry(painter, canvas) -> None:
    """Draw the axes over a canvas; with what moves and turns them while that is the tool."""
    symmetry = canvas.hand.symmetry
    centre = canvas.paper.to_screen(QtCore.QPointF(symmetry.x, symmetry.y))
    painter.save()
    paper = QtCore.QRectF(canvas.paper.origin(), QtCore.QSizeF(SIDE, SIDE) * canvas.paper.zoom)
    painter.setClipRect(paper)
    painter.setBrush(QtCore.Qt.NoBrush)
    painter.setPen(QtGui.QPen(QtGui.QColor(_BLUE), 1.5, QtCore.Qt.DashLine))
    long = 2.0 * SIDE * canvas.paper.zoom
    for x, y in symmetry.lines():
        painter.drawLine(centre, centre + long * QtCore.QPointF(x, y))
    painter.restore()
    if canvas.is_moving_axis():
        ring = canvas.paper.to_screen(ring_of(symmetry))
        for colour, width in (("#ffffff", 6.0), (_BLUE, 3.0)):
            painter.setPen(QtGui.QPen(QtGui.QColor(colour), width))
            painter.setBrush(QtCore.Qt.NoBrush)
            painter.drawEllipse(ring, 9, 9)
            for way in (QtCore.QPointF(9, 0), QtCore.QPointF(0, 9)):
                painter.drawLine(centre - way, centre + way)


def whole(box) -> Box:
    """A rectangle of whole pixels around one."""
    around = box.toAlignedRect()
    return around.x(), around.y(), around.width(), around.height()


def on_screen(canvas, box: Box):
    """A rectangle of the paper in the canvas."""
    left, top, width, height = box
    corner = canvas.paper.to_screen(QtCore.QPointF(left, top))
    return QtCore.QRectF(corner, QtCore.QSizeF(width, height) * canvas.paper.zoom)


def paint_box(painter, box) -> None:
    """A dashed frame that is seen on every colour."""
    painter.setBrush(QtCore.Qt.NoBrush)
    for colour, style in (("#ffffff", QtCore.Qt.SolidLine), (_BLUE, QtCore.Qt.DashLine)):
        painter.setPen(QtGui.QPen(QtGui.QColor(colour), 1.6, style))
        painter.drawRect(box)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture or words on the paper that are not painted yet: pulled, sized, turned, kept or dropped."""

from __future__ import annotations

import math
from collections.abc import Callable

from BalloonWorkbench.app.drawings.qt_picture import pixels
from BalloonWorkbench.gui.paint.canvas.inputs import on_screen, paint_box
from BalloonWorkbench.gui.paint.canvas.stroke_input import StrokeInput
from BalloonWorkbench.gui.paint.painting.layers import SIDE
from BalloonWorkbench.gui.paint.painting.painted import Painting
from BalloonWorkbench.gui.paint.painting.pieces import PastedPicture, packed
from BalloonWorkbench.gui.qt import QtCore, QtGui

_HANDLE = 7.0  # px on the screen, half of its width
_REACH = 14.0  # px on the screen, that a pointer may be beside it
_ABOVE = 26.0  # px on the screen, from the upper edge to what turns it
STEP = 15.0  # degrees by which it is turned by keys, and with Shift
_SMALLEST, _LARGEST = 8.0, 2.0 * SIDE  # px of the paper


class FloatingPicture(QtCore.QObject):
    """The one picture that is being placed, if any.

    image  as it is, None while nothing is placed
    box    where (QRectF), px of the paper, before it is turned about its middle
    angle  degrees clockwise
    `changed` comes when it is there, moves or is gone.
    """

    changed = QtCore.Signal()

    def __init__(self, painting: Painting, hand: StrokeInput, parent=None):
        super().__init__(parent)
        self._painting, self._hand = painting, hand
        self.image = None
        self.box = QtCore.QRectF()
        self.angle = 0.0
        self._draw_again: Callable | None = None
        self._held: QtCore.QPointF | None = None  # where it is held, from its upper left corner
        self._is_sizing = self._is_turning = False

    def is_there(self) -> bool:
        """Something is being placed."""
        return self.image is not None

    def lay(self, image, middle, draw_again: Callable | None = None) -> None:
        """Place an image around a point; draw_again: makes it anew for another height in px."""
        self.confirm()
        self.image, self._draw_again = image, draw_again
        self.box = QtCore.QRectF(QtCore.QPointF(), QtCore.QSizeF(image.size()))
        self.box.moveCenter(middle)
        self.angle = 0.0
        self.changed.emit()

    def show(self, image) -> None:
        """Another image at the same place, as far as that is on the paper: what is being typed."""
        if self.image is not None:
            self.image = image
            self.box.setSize(QtCore.QSizeF(image.size()))
            self.box.moveLeft(min(self.box.left(), max(SIDE - self.box.width(), 0.0)))
            self.changed.emit()

    def begin(self, at, zoom: float) -> bool:
        """Take hold of it; False beside it."""
        place = self._turned().inverted()[0].map(at)
        corner, ring = self.box.bottomRight() - place, self._ring(zoom) - place
        self._is_turning = math.hypot(ring.x(), ring.y()) * zoom < _REACH
        self._is_sizing = not self._is_turning and max(abs(corner.x()), abs(corner.y())) * zoom < _REACH
        if not (self._is_turning or self._is_sizing or self.box.contains(place)):
            return False
        self._held = corner if self._is_sizing else at - self.box.topLeft()
        return True

    def is_held(self) -> bool:
        return self._held is not None

    def move(self, at, shift: bool = False) -> None:
        """What holds it has moved; shift: it is turned by steps."""
        if self._is_turning:
            way = at - self.box.center()
            angle = math.degrees(math.atan2(way.x(), -way.y()))
            self.angle = STEP * round(angle / STEP) if shift else round(angle, 1)
        elif self._is_sizing:
            low, place = self.box.topLeft(), self._turned().inverted()[0].map(at)
            wide, high = (place + self._held - low).x(), (place + self._held - low).y()
            self._size(max(wide / self.box.width(), high / self.box.height()))
        else:
            self.box.moveTopLeft(at - self._held)
        self.changed.emit()

    def end(self) -> None:
        """It is let go."""
        self._held = None

    def nudge(self, x: float, y: float) -> None:
        """Move it by so many pixels of the paper."""
        self.box.translate(x, y)
        self.changed.emit()

    def scale_by(self, factor: float) -> None:
        """Larger or smaller; its upper left corner stays."""
        self._size(factor)
        self.changed.emit()

    def turn_by(self, angle: float) -> None:
        """Turn it by degrees clockwise."""
        self.angle = math.remainder(self.angle + angle, 360.0)
        self.changed.emit()

    def confirm(self) -> None:
        """Paint it, as one step."""
        if self.image is None:
            return
        image, box = self._upright()
        self.drop()
        nothing = not pixels(image)[..., 3].any()
        if nothing or (box & QtCore.QRect(0, 0, SIDE, SIDE)).isEmpty():
            return
        self._painting.do(PastedPicture(packed(image), box.getRect(), self._hand.layer))

    def drop(self) -> None:
        """It is gone."""
        self.image = self._draw_again = self._held = None
        self.changed.emit()

    def _upright(self) -> tuple:
        """What it looks like on the paper (QImage), and where (QRect)."""
        if not self.angle:
            box = self.box.toRect()
            if self.image.size() == box.size():
                return self.image, box
            size, smooth = box.size(), QtCore.Qt.SmoothTransformation
            return self.image.scaled(size, QtCore.Qt.IgnoreAspectRatio, smooth), box
        box = self._turned().mapRect(self.box).toAlignedRect()
        image = QtGui.QImage(box.size(), QtGui.QImage.Format_ARGB32_Premultiplied)
        image.fill(0)
        painter = QtGui.QPainter(image)
        painter.setRenderHint(QtGui.QPainter.SmoothPixmapTransform)
        painter.translate(-box.topLeft())
        painter.setTransform(self._turned(), True)
        painter.drawImage(self.box, self.image)
        painter.end()
        return image, box

    def _size(self, factor: float) -> None:
        """Its upper left corner stays."""
        fixed = self._turned().map(self.box.topLeft())
        least = _SMALLEST / min(self.box.width(), self.box.height())
        most = _LARGEST / max(self.box.width(), self.box.height())
        size = min(max(factor, least), max(most, least)) * self.box.size()
        if self._draw_again is not None:
            self.image = self._draw_again(size.height())
            size = QtCore.QSizeF(self.image.size())
        self.box.setSize(size)
        self.box.translate(fixed - self._turned().map(self.box.topLeft()))

    def _turned(self):
        """From places of the box to those of the paper."""
        middle = self.box.center()
        there = QtGui.QTransform.fromTranslate(middle.x(), middle.y())
        return there.rotate(self.angle).translate(-middle.x(), -middle.y())

    def _ring(self, zoom: float):
        """What turns it, above the upper edge of the box."""
        return QtCore.QPointF(self.box.center().x(), self.box.top() - _ABOVE / zoom)

    def paint(self, painter, canvas) -> None:
        """Draw over a canvas, in its coordinates."""
        if self.image is None:
            return
        box = on_screen(canvas, self.box.getRect())
        painter.save()
        painter.setRenderHint(QtGui.QPainter.SmoothPixmapTransform)
        painter.translate(box.center())
        painter.rotate(self.angle)
        box.moveCenter(QtCore.QPointF())
        painter.drawImage(box, self.image)
        paint_box(painter, box)
        edge = QtCore.QPointF(0.0, box.top())
        ring = edge - QtCore.QPointF(0.0, _ABOVE)
        handle = QtCore.QRectF(0, 0, 2 * _HANDLE, 2 * _HANDLE)
        handle.moveCenter(box.bottomRight())
        painter.setPen(QtGui.QPen(QtCore.Qt.white, 1.5))
        painter.setBrush(QtGui.QColor("#1f78d8"))
        painter.drawRect(handle)
        painter.drawLine(edge, ring)
        painter.drawEllipse(ring, _HANDLE, _HANDLE)
        painter.restore()

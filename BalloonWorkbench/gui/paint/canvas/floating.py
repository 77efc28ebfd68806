# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture or words that lie on the paper and are not painted yet: pulled, made larger, kept or dropped."""

from __future__ import annotations

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
_SMALLEST, _LARGEST = 8.0, 2.0 * SIDE  # px of the paper


class FloatingPicture(QtCore.QObject):
    """The one picture that is being placed, if any.

    image  as it is, None while nothing is placed
    box    where (QRectF), px of the paper
    `changed` comes when it is there, moves or is gone.
    """

    changed = QtCore.Signal()

    def __init__(self, painting: Painting, hand: StrokeInput, parent=None):
        super().__init__(parent)
        self._painting, self._hand = painting, hand
        self.image = None
        self.box = QtCore.QRectF()
        self._draw_again: Callable | None = None
        self._held: QtCore.QPointF | None = None  # where it is held, from its upper left corner
        self._is_sizing = False

    def is_there(self) -> bool:
        """Something is being placed."""
        return self.image is not None

    def lay(self, image, middle, draw_again: Callable | None = None) -> None:
        """Place an image around a point; draw_again: makes it anew for another height in px."""
        self.confirm()
        self.image, self._draw_again = image, draw_again
        self.box = QtCore.QRectF(QtCore.QPointF(), QtCore.QSizeF(image.size()))
        self.box.moveCenter(middle)
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
        corner = self.box.bottomRight() - at
        self._is_sizing = max(abs(corner.x()), abs(corner.y())) * zoom < _REACH
        if not (self._is_sizing or self.box.contains(at)):
            return False
        self._held = self.box.bottomRight() - at if self._is_sizing else at - self.box.topLeft()
        return True

    def is_held(self) -> bool:
        return self._held is not None

    def move(self, at) -> None:
        """What holds it has moved."""
        if self._is_sizing:
            low = self.box.topLeft()
            wide, high = (at + self._held - low).x(), (at + self._held - low).y()
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

    def confirm(self) -> None:
        """Paint it, as one step."""
        image, box = self.image, self.box.toRect()
        if image is None:
            return
        self.drop()
        nothing = not pixels(image)[..., 3].any()
        if nothing or (box & QtCore.QRect(0, 0, SIDE, SIDE)).isEmpty():
            return
        if image.size() != box.size():
            image = image.scaled(box.size(), QtCore.Qt.IgnoreAspectRatio, QtCore.Qt.SmoothTransformation)
        self._painting.do(PastedPicture(packed(image), box.getRect(), self._hand.layer))

    def drop(self) -> None:
        """It is gone."""
        self.image = self._draw_again = self._held = None
        self.changed.emit()

    def _size(self, factor: float) -> None:
        least = _SMALLEST / min(self.box.width(), self.box.height())
        most = _LARGEST / max(self.box.width(), self.box.height())
        size = min(max(factor, least), max(most, least)) * self.box.size()
        if self._draw_again is not None:
            self.image = self._draw_again(size.height())
            size = QtCore.QSizeF(self.image.size())
        self.box.setSize(size)

    def paint(self, painter, canvas) -> None:
        """Draw over a canvas, in its coordinates."""
        if self.image is None:
            return
        box = on_screen(canvas, self.box.getRect())
        painter.drawImage(box, self.image)
        paint_box(painter, box)
        handle = QtCore.QRectF(0, 0, 2 * _HANDLE, 2 * _HANDLE)
        handle.moveCenter(box.bottomRight())
        painter.setPen(QtGui.QPen(QtCore.Qt.white, 1.5))
        painter.setBrush(QtGui.QColor("#1f78d8"))
        painter.drawRect(handle)

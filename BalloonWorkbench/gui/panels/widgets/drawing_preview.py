# SPDX-License-Identifier: LGPL-2.1-or-later
"""A small picture of the drawing with the outline that was found in it."""

from __future__ import annotations

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.drawings.drawing_file import file_of
from BalloonWorkbench.app.drawings.qt_picture import picture_reader
from BalloonWorkbench.app.shapes import part_shapes
from BalloonWorkbench.core.units import to_mm
from BalloonWorkbench.gui.qt import QtCore, QtGui, QtWidgets, painter_on, translate
from BalloonWorkbench.gui.window.sentences import translated
from BalloonWorkbench.gui.window.user_units import size_text

_MARGIN = 6
_SIDE = 640  # px that a picture is shown with at most
_LEAST, _MOST, _FORM = 150, 280, 0.62  # px, px, height over width: a wide panel has a larger picture
_SWING = 24  # px; a scroll bar that comes and goes with the height changes the width, and would never rest


def notes_of(outline) -> str:
    """What there is to say about an outline: its size, its holes and the remarks made while it was found."""
    if not outline.LoopCounts or not status.is_ready(outline):
        return ""
    size = size_text(outline.SizeX.Value, outline.SizeY.Value)
    size_form = translate("Outline {}, holes: {}") if outline.HoleCount else translate("Outline {}")
    return "\n".join([size_form.format(size, outline.HoleCount), *map(translated, outline.Notes)])


def picture_in(path: str, side: int):
    """The picture in a file as it is traced: upright, and no longer or higher than `side` px."""
    reader = picture_reader(path)
    # the outline follows the camera's note on which side is up in these alone
    reader.setAutoTransform(bytes(reader.format()) == b"jpeg")
    size = reader.size()
    if max(size.width(), size.height()) > side:
        reader.setScaledSize(size.scaled(side, side, QtCore.Qt.KeepAspectRatio))
    return QtGui.QPixmap.fromImageReader(reader)


class Preview(QtWidgets.QWidget):
    """Shows a picture, if there is one, and the outline over it."""

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setObjectName("Preview")
        self.setMinimumHeight(_LEAST)
        self._picture, self._file = QtGui.QPixmap(), None
        self._picture_box = QtCore.QRectF()
        self._path = QtGui.QPainterPath()
        self._welds = QtGui.QPainterPath()

    def show(self, outline, canvas=None) -> None:
        """Draw an outline object; over its picture, where there is one.

        canvas  lower left and upper right corner (2, 2) m of the picture
        """
        self._path, self._welds = QtGui.QPainterPath(), QtGui.QPainterPath()
        if outline.LoopCounts and status.is_ready(outline):
            drawn = part_shapes.stored(outline, "Loop")
            for weld in drawn.welds:
                self._welds.addPolygon(
                    QtGui.QPolygonF([QtCore.QPointF(x, -y) for x, y in to_mm(weld).tolist()])
                )
            for loop in drawn.loops:
                self._path.addPolygon(
                    QtGui.QPolygonF([QtCore.QPointF(x, -y) for x, y in to_mm(loop).tolist()])
                )
                self._path.closeSubpath()
        self._show_picture("" if canvas is None else outline.Drawing)
        self._picture_box = QtCore.QRectF()
        if canvas is not None:
            (left, low), (right, high) = to_mm(canvas).tolist()
            self._picture_box = QtCore.QRectF(left, -high, right - left, high - low)
        self.update()

    def _show_picture(self, path: str) -> None:
        """Read it once, as long as the file is the same."""
        file = file_of(path) if path else None
        if file != self._file:
            self._file = file
            self._picture = QtGui.QPixmap() if file is None else picture_in(path, _SIDE)

    def resizeEvent(self, event):
        super().resizeEvent(event)
        height = int(min(max(_FORM * self.width(), _LEAST), _MOST))
        if abs(height - self.minimumHeight()) > _SWING:
            self.setMinimumHeight(height)

    def paintEvent(self, event):
        with painter_on(self) as painter:
            self._paint(painter)

    def _paint(self, painter) -> None:
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        painter.setRenderHint(QtGui.QPainter.SmoothPixmapTransform)
        painter.fillRect(self.rect(), self.palette().base())
        whole = self._path.boundingRect()
        if not self._picture.isNull():
            whole = whole.united(self._picture_box)
        if whole.width() <= 0 or whole.height() <= 0:
            return
        room = self.rect().adjusted(_MARGIN, _MARGIN, -_MARGIN, -_MARGIN)
        scale = min(room.width() / whole.width(), room.height() / whole.height())
        painter.translate(QtCore.QPointF(room.center()))
        painter.scale(scale, scale)
        painter.translate(-whole.center())
        if not self._picture.isNull():
            painter.drawPixmap(self._picture_box, self._picture, QtCore.QRectF(self._picture.rect()))
        line = QtGui.QPen(self.palette().highlight().color(), 2)
        line.setCosmetic(True)
        painter.setPen(line)
        if self._picture.isNull():
            painter.setBrush(self.palette().alternateBase())
        painter.drawPath(self._path)
        painter.strokePath(self._welds, line)

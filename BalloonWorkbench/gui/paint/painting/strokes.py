# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is done to a painting, one step each: drawn with a tool, filled, or put on it as a picture."""

from __future__ import annotations

import base64
from dataclasses import dataclass, field

import numpy as np

from BalloonWorkbench.app.drawings.qt_picture import pixels
from BalloonWorkbench.core.tracing.raster import label, neighbours
from BalloonWorkbench.gui.qt import QtCore, QtGui

PEN, BRUSH, ERASER, LINE, FILL = "pen", "brush", "eraser", "line", "fill"
_SOFT = 3.0  # px of the brush's soft rim
_ROUND = 8  # points of a stroke that may be meant to be closed
_GAP = 8.0  # px between its ends
_SAME = 40  # levels; colours nearer than this are filled as one
_UNDER = 3  # px that a fill reaches under the soft rim of the line around it


class Spill(Exception):
    """A fill that would run over the border of the picture."""


@dataclass
class PaintStroke:
    """A line drawn with pen, brush or eraser, straight or bent.

    points  (x, y, width) px each
    mirror  drawn a second time, mirrored left to right
    """

    tool: str
    colour: str
    mirror: bool = False
    points: list[tuple[float, float, float]] = field(default_factory=list)

    def paint(self, image) -> None:
        for number in range(len(self.points) + 1):
            self.paint_part(image, number)

    def is_nearly_closed(self) -> bool:
        """It ends where it began, but for a little gap."""
        (x, y, width), end = self.points[0], self.points[-1]
        gap = float(np.hypot(end[0] - x, end[1] - y))
        return len(self.points) > _ROUND and gap < _GAP + 1.5 * width

    def paint_part(self, image, number: int) -> None:
        """Draw the piece that came with one more point, so that a stroke grows while it is drawn.

        The piece after the last point ends the stroke.
        """
        painter = QtGui.QPainter(image)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        if self.tool == ERASER:
            painter.setCompositionMode(QtGui.QPainter.CompositionMode_DestinationOut)
        piece, width = self._piece(number)
        colour = QtGui.QColor(self.colour)
        for mirrored in (False, True)[: 1 + self.mirror]:
            painter.setTransform(_mirroring(image) if mirrored else QtGui.QTransform())
            if self.tool == BRUSH:
                rim = QtGui.QColor(colour)
                rim.setAlpha(60)
                painter.strokePath(piece, _pen(rim, width + _SOFT))
            painter.strokePath(piece, _pen(colour, width))
        painter.end()

    def _piece(self, number: int):
        """From the middle of the last two points round to that of the next two: a smooth line."""
        if number == len(self.points):
            path = QtGui.QPainterPath(
                _middle(self.points, max(number - 1, 1)) if number > 1 else _at(self.points[0])
            )
            path.lineTo(_at(self.points[-1]) + QtCore.QPointF(0.01, 0.0))
            return path, self.points[-1][2]
        x, y, width = self.points[number]
        path = QtGui.QPainterPath(QtCore.QPointF(x, y))
        if number == 0:
            path.lineTo(x + 0.01, y)
        elif number == 1 or self.tool == LINE:
            path = QtGui.QPainterPath(_at(self.points[number - 1]))
            path.lineTo(x, y) if self.tool == LINE else path.lineTo(_middle(self.points, number))
        else:
            path = QtGui.QPainterPath(_middle(self.points, number - 1))
            path.quadTo(_at(self.points[number - 1]), _middle(self.points, number))
        return path, width

    def paint_whole(self, painter, side: float) -> None:
        """Draw all of it as one line on a paper of this side: a look at what is not on the image yet."""
        path = QtGui.QPainterPath(_at(self.points[0]))
        for point in self.points[1:]:
            path.lineTo(_at(point))
        line = _pen(QtGui.QColor(self.colour), self.points[0][2])
        painter.strokePath(path, line)
        if self.mirror:
            painter.strokePath(QtGui.QTransform(-1, 0, 0, 1, side, 0).map(path), line)

    def data(self) -> dict:
        """For the file."""
        points = [[round(value, 2) for value in point] for point in self.points]
        return {"tool": self.tool, "colour": self.colour, "mirror": self.mirror, "points": points}

    @classmethod
    def from_data(cls, data: dict) -> PaintStroke:
        points = [(float(x), float(y), float(width)) for x, y, width in data["points"]]
        return cls(data["tool"], data["colour"], data["mirror"], points)


@dataclass
class Fill:
    """A region of one colour gets another one."""

    colour: str
    x: float
    y: float
    mirror: bool = False
    tool: str = FILL

    def paint(self, image) -> None:
        """Fill around the place; raises Spill, with the image untouched, where an empty region is open."""
        places = [(self.x, self.y), (image.width() - self.x, self.y)][: 1 + self.mirror]
        regions = [_region(image, x, y) for x, y in places]
        region = np.logical_or.reduce([area for area, _ in regions])
        empty = regions[0][1]
        if empty:
            for _ in range(_UNDER):
                region = neighbours(region)
        mask = np.zeros((*region.shape, 4), np.uint8)
        rgb = QtGui.QColor(self.colour)
        mask[region] = (rgb.red(), rgb.green(), rgb.blue(), 255)
        height, width = region.shape
        layer = QtGui.QImage(mask.tobytes(), width, height, 4 * width, QtGui.QImage.Format_RGBA8888)
        painter = QtGui.QPainter(image)
        painter.setCompositionMode(
            QtGui.QPainter.CompositionMode_DestinationOver
            if empty
            else QtGui.QPainter.CompositionMode_SourceAtop  # another colour is no other outline
        )
        painter.drawImage(0, 0, layer)
        painter.end()

    def data(self) -> dict:
        """For the file."""
        return {
            "tool": FILL,
            "colour": self.colour,
            "mirror": self.mirror,
            "at": [round(self.x, 2), round(self.y, 2)],
        }

    @classmethod
    def from_data(cls, data: dict) -> Fill:
        return cls(data["colour"], *map(float, data["at"]), data["mirror"])


@dataclass
class PastedPicture:
    """A picture on the paper, as large as fits.

    content  of the file
    """

    content: bytes
    tool: str = "picture"
    _image: object = field(default=None, repr=False, compare=False)

    def paint(self, image) -> None:
        painter = QtGui.QPainter(image)
        self.draw(painter, QtCore.QRectF(image.rect()))
        painter.end()

    def _unpacked(self):
        """A backdrop is drawn with every movement of the pointer: unpacked once."""
        if self._image is None:
            self._image = QtGui.QImage.fromData(self.content)
        return self._image

    def draw(self, painter, room) -> None:
        """Draw it in the middle of a rectangle."""
        picture = self._unpacked()
        size = QtCore.QSizeF(picture.size())
        size.scale(room.size(), QtCore.Qt.KeepAspectRatio)
        place = QtCore.QRectF(QtCore.QPointF(), size)
        place.moveCenter(room.center())
        painter.setRenderHint(QtGui.QPainter.SmoothPixmapTransform)
        painter.drawImage(place, picture)

    def data(self) -> dict:
        """For the file."""
        return {"tool": self.tool, "content": base64.b64encode(self.content).decode()}

    @classmethod
    def from_data(cls, data: dict) -> PastedPicture:
        return cls(base64.b64decode(data["content"]))


@dataclass
class Clear:
    """Everything is taken off."""

    tool: str = "clear"

    def paint(self, image) -> None:
        image.fill(QtCore.Qt.transparent)

    def data(self) -> dict:
        """For the file."""
        return {"tool": self.tool}

    @classmethod
    def from_data(cls, data: dict) -> Clear:
        return cls()


def _region(image, x: float, y: float):
    """The region of one colour around a place (h, w), and whether it is empty."""
    rgba = pixels(image).astype(np.int16)
    height, width = rgba.shape[:2]
    column, row = (int(min(max(value, 0), most - 1)) for value, most in ((x, width), (y, height)))
    here = rgba[row, column]
    empty = here[3] < 128
    alike = rgba[..., 3] < 128 if empty else (np.abs(rgba - here) < _SAME).all(axis=2)
    labels, _ = label(alike)
    region = labels == labels[row, column]
    if empty and (region[0].any() or region[-1].any() or region[:, 0].any() or region[:, -1].any()):
        raise Spill
    return region, empty


def _pen(colour, width: float):
    return QtGui.QPen(colour, width, QtCore.Qt.SolidLine, QtCore.Qt.RoundCap, QtCore.Qt.RoundJoin)


def _mirroring(image):
    return QtGui.QTransform(-1, 0, 0, 1, image.width(), 0)


def _at(point):
    return QtCore.QPointF(point[0], point[1])


def _middle(points, number: int):
    return 0.5 * (_at(points[number - 1]) + _at(points[number]))

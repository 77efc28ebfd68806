# SPDX-License-Identifier: LGPL-2.1-or-later
"""Steps of a painting that are no strokes: pictures and words, stamps, what is cut away, all taken off."""

from __future__ import annotations

import base64
from dataclasses import dataclass, field

from BalloonWorkbench.gui.paint.painting.layers import LAYERS, SHAPE, SIDE, layer_from
from BalloonWorkbench.gui.paint.painting.symmetry import ONCE, Symmetry, symmetry_from
from BalloonWorkbench.gui.qt import QtCore, QtGui

PICTURE, STAMPED, CUT, CLEAR = "picture", "stamp", "cut", "clear"
_QUALITY = 92  # of a JPEG
Box = tuple[float, float, float, float]


@dataclass
class PastedPicture:
    """A picture on the paper.

    content  of the file
    box      left, top, width and height, px; None: as large as fits on the paper
    """

    content: bytes
    box: Box | None = None
    layer: str = SHAPE
    tool: str = PICTURE
    _image: object = field(default=None, repr=False, compare=False)

    @property
    def layers(self) -> tuple[str, ...]:
        """What it changes."""
        return (self.layer,)

    def paint(self, image, seen=None) -> None:
        """Draw it; seen: what lies on the paper, of which it knows nothing."""
        painter = QtGui.QPainter(image)
        if self.box is None:
            self.draw(painter, QtCore.QRectF(image.rect()))
        else:
            painter.setRenderHint(QtGui.QPainter.SmoothPixmapTransform)
            painter.drawImage(QtCore.QRectF(*self.box), self._unpacked())
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

    def colour_at(self, point):
        """Its colour at a place of the paper, where it lies as a backdrop; None beside it."""
        room = QtGui.QImage(1, 1, QtGui.QImage.Format_ARGB32_Premultiplied)
        room.fill(0)
        painter = QtGui.QPainter(room)
        self.draw(painter, QtCore.QRectF(-point.x(), -point.y(), SIDE, SIDE))
        painter.end()
        colour = room.pixelColor(0, 0)
        return colour if colour.alpha() > 127 else None

    def data(self) -> dict:
        """For the file."""
        return {
            "tool": self.tool,
            "content": base64.b64encode(self.content).decode(),
            "box": self.box,
            "layer": self.layer,
        }

    @classmethod
    def from_data(cls, data: dict) -> PastedPicture:
        box = data.get("box")
        place = None if box is None else tuple(float(value) for value in box)
        return cls(base64.b64decode(data["content"]), place, layer_from(data))


@dataclass
class Stamped:
    """An area of one colour.

    points  round it (x, y) px: it stays as it is when the stamps of a later release look otherwise
    """

    colour: str
    points: list[tuple[float, float]]
    symmetry: Symmetry = ONCE
    layer: str = SHAPE
    tool: str = STAMPED

    @property
    def layers(self) -> tuple[str, ...]:
        """What it changes."""
        return (self.layer,)

    def paint(self, image, seen=None) -> None:
        """Draw it; seen: what lies on the paper, of which it knows nothing."""
        painter = QtGui.QPainter(image)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        self.draw(painter)
        painter.end()

    def draw(self, painter) -> None:
        """Draw it with a painter whose unit is a pixel of the paper."""
        path = QtGui.QPainterPath()
        path.addPolygon(QtGui.QPolygonF([QtCore.QPointF(x, y) for x, y in self.points]))
        path.closeSubpath()
        for transform in self.symmetry.transforms:
            painter.fillPath(transform.map(path), QtGui.QColor(self.colour))

    def data(self) -> dict:
        """For the file."""
        return {
            "tool": self.tool,
            "colour": self.colour,
            "symmetry": self.symmetry.data(),
            "layer": self.layer,
            "points": [[round(x, 2), round(y, 2)] for x, y in self.points],
        }

    @classmethod
    def from_data(cls, data: dict) -> Stamped:
        points = [(float(x), float(y)) for x, y in data["points"]]
        return cls(data["colour"], points, symmetry_from(data), layer_from(data))


@dataclass
class CutAway:
    """What is in a rectangle is taken off; from the shape, its decoration too.

    box  left, top, width and height, px
    """

    box: Box
    layer: str = SHAPE
    tool: str = CUT

    @property
    def layers(self) -> tuple[str, ...]:
        """What it changes."""
        return LAYERS if self.layer == SHAPE else (self.layer,)

    def paint(self, image, seen=None) -> None:
        """Take it off; seen: what lies on the paper, of which it knows nothing."""
        painter = QtGui.QPainter(image)
        painter.setCompositionMode(QtGui.QPainter.CompositionMode_Clear)
        painter.fillRect(QtCore.QRectF(*self.box), QtCore.Qt.black)
        painter.end()

    def data(self) -> dict:
        """For the file."""
        return {"tool": self.tool, "box": self.box, "layer": self.layer}

    @classmethod
    def from_data(cls, data: dict) -> CutAway:
        left, top, width, height = map(float, data["box"])
        return cls((left, top, width, height), layer_from(data))


@dataclass
class Clear:
    """Everything is taken off."""

    tool: str = CLEAR

    @property
    def layers(self) -> tuple[str, ...]:
        """What it changes."""
        return LAYERS

    def paint(self, image, seen=None) -> None:
        image.fill(QtCore.Qt.transparent)

    def data(self) -> dict:
        """For the file."""
        return {"tool": self.tool}

    @classmethod
    def from_data(cls, data: dict) -> Clear:
        return cls()


def packed(image) -> bytes:
    """An image as the content of a file, no larger than the paper."""
    if max(image.width(), image.height()) > SIDE:
        image = image.scaled(SIDE, SIDE, QtCore.Qt.KeepAspectRatio, QtCore.Qt.SmoothTransformation)
    buffer = QtCore.QBuffer()
    buffer.open(QtCore.QIODevice.WriteOnly)
    clear = image.hasAlphaChannel()
    image.save(buffer, "PNG" if clear else "JPG", -1 if clear else _QUALITY)
    return bytes(buffer.data())

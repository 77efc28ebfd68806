# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is done to a painting with pen, brush, eraser, line and fill, one step each."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass, field

import numpy as np

from BalloonWorkbench.app.drawings.qt_picture import pixels
from BalloonWorkbench.core.tracing.raster import label, neighbours
from BalloonWorkbench.gui.paint.painting.layers import DECORATION, SHAPE, layer_from
from BalloonWorkbench.gui.paint.painting.symmetry import ONCE, Symmetry, symmetry_from
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

    points    (x, y, width) px each
    symmetry  how it is drawn again
    """

    tool: str
    colour: str
    symmetry: Symmetry = ONCE
    points: list[tuple[float, float, float]] = field(default_factory=list)
    layer: str = SHAPE

    @property
    def layers(self) -> tuple[str, ...]:
        """What it changes."""
        return (self.layer,)

    def paint(self, image, seen=None) -> None:
        """Draw all of it; seen: what lies on the paper, of which it knows nothing."""
        for number in range(len(self.points) + 1):
            self.paint_part(image, number)

    def is_nearly_closed(self) -> bool:
        """It ends where it began, but for a little gap."""
        (x, y, width), end = self.points[0], self.points[-1]
        gap = float(np.hypot(end[0] - x, end[1] - y))
        return len(self.points) > _ROUND and gap < _GAP + 1.5 * width

    def paint_part(self, image, number: int):
        """Draw the piece that came with one more point, so that a stroke grows while it is drawn.

        The piece after the last point ends the stroke. Returns the region that has changed (QRegion).
        """
        painter = QtGui.QPainter(image)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        if self.tool == ERASER:
            painter.setCompositionMode(QtGui.QPainter.CompositionMode_DestinationOut)
        piece, width = self._piece(number)
        colour = QtGui.QColor(self.colour)
        margin = 0.5 * width + _SOFT
        box, changed = piece.boundingRect().adjusted(-margin, -margin, margin, margin), QtGui.QRegion()
        for transform in self.symmetry.transforms:
            changed += transform.mapRect(box).toAlignedRect()
            painter.setTransform(transform)
            if self.tool == BRUSH:
                rim = QtGui.QColor(colour)
                rim.setAlpha(60)
                painter.strokePath(piece, _pen(rim, width + _SOFT))
            painter.strokePath(piece, _pen(colour, width))
        painter.end()
        return changed

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

    def paint_whole(self, painter) -> None:
        """Draw all of it as one line: a look at what is not on the image yet."""
        path = QtGui.QPainterPath(_at(self.points[0]))
        for point in self.points[1:]:
            path.lineTo(_at(point))
        line = _pen(QtGui.QColor(self.colour), self.points[0][2])
        for transform in self.symmetry.transforms:
            painter.strokePath(transform.map(path), line)

    def data(self) -> dict:
        """For the file."""
        points = [[round(value, 2) for value in point] for point in self.points]
        return {
            "tool": self.tool,
            "colour": self.colour,
            "symmetry": self.symmetry.data(),
            "layer": self.layer,
            "points": points,
        }

    @classmethod
    def from_data(cls, data: dict) -> PaintStroke:
        points = [(float(x), float(y), float(width)) for x, y, width in data["points"]]
        return cls(data["tool"], data["colour"], symmetry_from(data), points, layer_from(data))


@dataclass
class Fill:
    """A region of one colour gets another one."""

    colour: str
    x: float
    y: float
    symmetry: Symmetry = ONCE
    layer: str = SHAPE
    tool: str = FILL

    @property
    def layers(self) -> tuple[str, ...]:
        """What it changes."""
        return (self.layer,)

    def paint(self, image, seen=None) -> None:
        """Fill around the place; raises Spill, with the image untouched, where an empty region is open.

        seen  what lies on the paper: its regions are filled; without it those of the image
        """
        region, empty = self._regions(image if seen is None else seen)
        if empty and self.layer == SHAPE:
            for _ in range(_UNDER):
                region = neighbours(region)
        mask = np.zeros((*region.shape, 4), np.uint8)
        rgb = QtGui.QColor(self.colour)
        mask[region] = (rgb.red(), rgb.green(), rgb.blue(), 255)
        height, width = region.shape
        layer = QtGui.QImage(mask.tobytes(), width, height, 4 * width, QtGui.QImage.Format_RGBA8888)
        painter = QtGui.QPainter(image)
        if self.layer != DECORATION:
            painter.setCompositionMode(
                QtGui.QPainter.CompositionMode_DestinationOver
                if empty
                else QtGui.QPainter.CompositionMode_SourceAtop  # another colour is no other outline
            )
        painter.drawImage(0, 0, layer)
        painter.end()

    def _regions(self, image):
        """What is filled (h, w), and whether that is empty; where the symmetry repeats it, what is closed."""
        regions = _Regions(image)
        region, empty = regions.around(self.x, self.y)
        for transform in self.symmetry.transforms[1:]:
            place = transform.map(QtCore.QPointF(self.x, self.y))
            if image.rect().contains(place.toPoint()):
                with suppress(Spill):
                    region = region | regions.around(place.x(), place.y())[0]
        return region, empty

    def data(self) -> dict:
        """For the file."""
        return {
            "tool": FILL,
            "colour": self.colour,
            "symmetry": self.symmetry.data(),
            "layer": self.layer,
            "at": [round(self.x, 2), round(self.y, 2)],
        }

    @classmethod
    def from_data(cls, data: dict) -> Fill:
        return cls(data["colour"], *map(float, data["at"]), symmetry_from(data), layer_from(data))


class _Regions:
    """The regions of one colour of an image; the labels of a colour are made once."""

    def __init__(self, image):
        self._rgba = pixels(image).astype(np.int16)
        self._labels: dict = {}

    def around(self, x: float, y: float):
        """The region around a place (h, w), and whether it is empty; Spill where that is open."""
        height, width = self._rgba.shape[:2]
        column, row = (int(min(max(value, 0), most - 1)) for value, most in ((x, width), (y, height)))
        here = self._rgba[row, column]
        empty = bool(here[3] < 128)
        key = None if empty else tuple(here.tolist())
        if key not in self._labels:
            alike = self._rgba[..., 3] < 128 if empty else (np.abs(self._rgba - here) < _SAME).all(axis=2)
            self._labels[key], _ = label(alike)
        labels = self._labels[key]
        region = labels == labels[row, column]
        if empty and (region[0].any() or region[-1].any() or region[:, 0].any() or region[:, -1].any()):
            raise Spill
        return region, empty


def _pen(colour, width: float):
    return QtGui.QPen(colour, width, QtCore.Qt.SolidLine, QtCore.Qt.RoundCap, QtCore.Qt.RoundJoin)


def _at(point):
    return QtCore.QPointF(point[0], point[1])


def _middle(points, number: int):
    return 0.5 * (_at(points[number - 1]) + _at(points[number]))

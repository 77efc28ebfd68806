# SPDX-License-Identifier: LGPL-2.1-or-later
"""Simple shapes to put down, from resources/stamps.json."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

from BalloonWorkbench.core.files.data_file import RESOURCES, read_data
from BalloonWorkbench.gui.qt import QtCore, QtGui

_FINE = 100.0  # px of the radius, for which curves are flattened


@dataclass(frozen=True)
class Stamp:
    """A shape that fills a square from -1 to 1 in width or height, y down.

    points  (x, y) round it
    """

    name: str
    title: str
    points: tuple[tuple[float, float], ...]

    def at(self, place: tuple[float, float], size: float, turn: float) -> list[tuple[float, float]]:
        """Its points around a place, twice `size` wide or high, turned clockwise by degrees."""
        transform = QtGui.QTransform.fromTranslate(*place).rotate(turn).scale(size, size)
        corners = [transform.map(QtCore.QPointF(x, y)) for x, y in self.points]
        return [(round(corner.x(), 2), round(corner.y(), 2)) for corner in corners]


@cache
def stamps() -> tuple[Stamp, ...]:
    """All, in the order in which they are shown."""
    return tuple(
        Stamp(each["name"], each["title"], _round(each["path"]))
        for each in read_data(RESOURCES / "stamps.json")["stamps"]
    )


def _round(steps: list) -> tuple[tuple[float, float], ...]:
    """Points round a path of lines [x, y] and curves [x, y, x, y, x, y], in a box of 100."""
    path = QtGui.QPainterPath()
    for number, values in enumerate(steps):
        places = [QtCore.QPointF(*values[k : k + 2]) for k in range(0, len(values), 2)]
        if number == 0:
            path.moveTo(places[0])
        elif len(places) == 1:
            path.lineTo(places[0])
        else:
            path.cubicTo(*places)
    path.closeSubpath()
    polygon = path.toSubpathPolygons(QtGui.QTransform.fromScale(_FINE / 100.0, _FINE / 100.0))[0]
    points = [(point.x() / _FINE, point.y() / _FINE) for point in list(polygon)[:-1]]
    box = polygon.boundingRect()
    middle = box.center() / _FINE
    size = max(box.width(), box.height()) / (2.0 * _FINE)
    return tuple(((x - middle.x()) / size, (y - middle.y()) / size) for x, y in points)

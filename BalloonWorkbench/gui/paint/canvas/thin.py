# SPDX-License-Identifier: LGPL-2.1-or-later
"""Over the painting: thin arms and necks in orange, and the question whether to widen them."""

from __future__ import annotations

from dataclasses import dataclass

from BalloonWorkbench.gui.paint.painting.layers import SIDE
from BalloonWorkbench.gui.paint.preview.advice_marks import Remark
from BalloonWorkbench.gui.qt import QtCore, QtGui

_ORANGE = "#ff7a00"
_RING = 26.0  # px on the screen
_ROOM, _PAD, _AWAY = 240.0, 8.0, 30.0  # px on the screen: width of the text, around it, from its place
_CROSS = 18.0  # px, what takes the question away
_SAME = 20.0  # px of the painting; a question nearer than this to one that was sent away is the same


@dataclass(frozen=True)
class Answer:
    """What a click means: yes to the repair of a remark, or leave me alone with it."""

    number: int
    yes: bool


class ThinPlaces:
    """Places that will not inflate well.

    One question at a time: a click on it is a yes, on its cross a no.
    """

    def __init__(self):
        self.remarks: tuple[Remark, ...] = ()
        self._dismissed: list[tuple[float, float]] = []
        self._bubble = QtCore.QRectF()  # where it was painted
        self._cross = QtCore.QRectF()

    def show(self, remarks) -> None:
        """Take the remarks of a state, the worst first; hints are not worth an interruption."""
        self.remarks = tuple(remark for remark in remarks if remark.severity != "hint")

    def asked(self) -> int | None:
        """Number of the remark that is asked about."""
        for number, remark in enumerate(self.remarks):
            if remark.step is not None and not self._is_dismissed(remark):
                return number
        return None

    def dismiss(self, number: int) -> None:
        """Do not ask about a place again."""
        self._dismissed.append(_corner(self.remarks[number]))

    def answer_at(self, point) -> Answer | None:
        """What a click at a place on the screen says."""
        number = self.asked()
        if number is None or not self._bubble.contains(point):
            return None
        return Answer(number, not self._cross.contains(point))

    def question_place(self):
        """The middle of the question on the screen; None when there is none."""
        return None if self.asked() is None else self._bubble.center()

    def paint(self, painter, canvas) -> None:
        """Draw over a canvas, in its coordinates."""
        self._bubble = self._cross = QtCore.QRectF()
        for remark in self.remarks:
            if remark.step is None:
                painter.setPen(QtGui.QPen(QtGui.QColor(_ORANGE), 3.0))
                painter.setBrush(QtCore.Qt.NoBrush)
                painter.drawEllipse(canvas.paper.to_screen(_at(remark.place)), _RING, _RING)
            else:
                self._paint_part(painter, canvas, remark.step)
        number = self.asked()
        if number is not None and canvas.hand.stroke is None:
            self._paint_question(painter, canvas, self.remarks[number])

    def _is_dismissed(self, remark: Remark) -> bool:
        x, y = _corner(remark)
        return any(abs(x - a) + abs(y - b) < _SAME for a, b in self._dismissed)

    @staticmethod
    def _paint_part(painter, canvas, step) -> None:
        """As wide as it is, and a dashed rim as wide as it would be."""
        points = [canvas.paper.to_screen(QtCore.QPointF(x, y)) for x, y in step.points]
        line = QtGui.QPainterPath(points[0])
        for point in points[1:]:
            line.lineTo(point)
        stroker = QtGui.QPainterPathStroker()
        stroker.setCapStyle(QtCore.Qt.RoundCap)
        stroker.setJoinStyle(QtCore.Qt.RoundJoin)
        colour = QtGui.QColor(_ORANGE)
        stroker.setWidth(max(step.was * canvas.paper.zoom, 4.0))
        colour.setAlphaF(0.75)
        painter.fillPath(stroker.createStroke(line).simplified(), colour)
        stroker.setWidth(step.widened * canvas.paper.zoom)
        painter.setPen(QtGui.QPen(QtGui.QColor(_ORANGE), 1.6, QtCore.Qt.DashLine))
        painter.setBrush(QtCore.Qt.NoBrush)
        painter.drawPath(stroker.createStroke(line).simplified())

    def _paint_question(self, painter, canvas, remark: Remark) -> None:
        place = canvas.paper.to_screen(_at(remark.place))
        flags = int(QtCore.Qt.AlignLeft | QtCore.Qt.AlignVCenter | QtCore.Qt.TextWordWrap)
        font = painter.font()
        font.setBold(True)
        painter.setFont(font)
        text = painter.boundingRect(QtCore.QRectF(0, 0, _ROOM, 200), flags, remark.question)
        box = text.adjusted(-_PAD, -_PAD, _PAD + _CROSS, _PAD)
        above = place.y() - _AWAY - box.height() > 0
        box.moveCenter(QtCore.QPointF(place.x(), place.y()))
        box.moveBottom(place.y() - _AWAY) if above else box.moveTop(place.y() + _AWAY)
        box.moveLeft(min(max(box.left(), 4.0), max(canvas.width() - 4.0 - box.width(), 4.0)))
        edge = box.bottom() - 1 if above else box.top() + 1
        pointer = QtGui.QPolygonF(
            [QtCore.QPointF(place.x() - 8, edge), place, QtCore.QPointF(place.x() + 8, edge)]
        )
        path = QtGui.QPainterPath()
        path.addRoundedRect(box, 7, 7)
        tip = QtGui.QPainterPath()
        tip.addPolygon(pointer)
        tip.closeSubpath()
        painter.setPen(QtGui.QPen(QtGui.QColor(_ORANGE), 2.0))
        painter.setBrush(QtGui.QColor("#fff6ea"))
        painter.drawPath(path.united(tip))
        painter.setPen(QtGui.QColor("#3a2a10"))
        text.moveTopLeft(box.topLeft() + QtCore.QPointF(_PAD, _PAD))
        painter.drawText(text, flags, remark.question)
        self._bubble = box
        self._cross = QtCore.QRectF(box.right() - _CROSS, box.top(), _CROSS, _CROSS)
        cross = self._cross.adjusted(6, 6, -6, -6)
        painter.drawLine(cross.topLeft(), cross.bottomRight())
        painter.drawLine(cross.topRight(), cross.bottomLeft())


def _corner(remark: Remark) -> tuple[float, float]:
    return remark.place[0] * SIDE, (1.0 - remark.place[1]) * SIDE


def _at(place):
    """A place in parts of the picture, y up, in pixels of the painting, y down."""
    return QtCore.QPointF(place[0] * SIDE, (1.0 - place[1]) * SIDE)

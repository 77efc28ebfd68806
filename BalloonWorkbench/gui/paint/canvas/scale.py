# SPDX-License-Identifier: LGPL-2.1-or-later
"""A hand beside the shape, as large as a grown-up's: so that everybody sees how wide the balloon will be."""

from __future__ import annotations

from BalloonWorkbench.gui.paint.painting.layers import SIDE
from BalloonWorkbench.gui.qt import QtCore, QtGui

LENGTH = 185.0  # mm from the wrist to the tip of the middle finger
#: Fingers as lines (x, y at the root, x, y at the tip, width): mm from the wrist, y up, the palm forward.
_FINGERS = (
    (-26, 72, -62, 118, 19),  # thumb
    (-28, 95, -36, 160, 17),
    (-10, 98, -12, 176, 18),
    (9, 98, 13, 166, 17),
    (26, 92, 37, 143, 15),
)
_PALM = ((-28, 14), (26, 14), (37, 92), (27, 104), (-30, 104), (-40, 62))
_GAP = 14.0  # px on the screen from the corner of the canvas


def _hand():
    """Its outline in mm, y up, wrist at the origin."""
    palm = QtGui.QPainterPath()
    palm.addPolygon(QtGui.QPolygonF([QtCore.QPointF(*corner) for corner in _PALM]))
    palm.closeSubpath()
    stroker = QtGui.QPainterPathStroker()
    stroker.setCapStyle(QtCore.Qt.RoundCap)
    stroker.setJoinStyle(QtCore.Qt.RoundJoin)
    stroker.setWidth(20.0)
    shape = palm.united(stroker.createStroke(palm))
    for x, y, tip_x, tip_y, width in _FINGERS:
        finger = QtGui.QPainterPath(QtCore.QPointF(x, y))
        finger.lineTo(tip_x, tip_y)
        stroker.setWidth(width)
        shape = shape.united(stroker.createStroke(finger))
    return shape.simplified()


class Scale:
    """Draws the hand in the lower left corner of the canvas, in the scale of the shape."""

    def __init__(self):
        self.is_visible = False
        self.per_mm = 0.0  # pixels of the painting for a millimetre of the balloon
        self._hand = None

    def fit(self, state, width: float) -> None:
        """Follow the shape of a state that shall become so wide in mm."""
        across = [loop[:, 0] for loop in state.loops]
        extent = max(x.max() for x in across) - min(x.min() for x in across)
        self.per_mm = float(extent) * SIDE / width

    def paint(self, painter, canvas) -> None:
        """Draw on a canvas, in its coordinates."""
        if not (self.is_visible and self.per_mm):
            return
        if self._hand is None:
            self._hand = _hand()
        factor = self.per_mm * canvas.paper.zoom
        box = self._hand.boundingRect()
        transform = QtGui.QTransform()
        transform.translate(_GAP - factor * box.left(), canvas.height() - _GAP + factor * box.top())
        transform.scale(factor, -factor)
        painter.setPen(QtGui.QPen(QtGui.QColor("#8a6f5c"), 1.4))
        colour = QtGui.QColor("#e8bfa0")
        colour.setAlphaF(0.55)
        painter.setBrush(colour)
        painter.drawPath(transform.map(self._hand))

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The hand that paints: what goes down, moves and comes up on the paper becomes a step of the painting."""

from __future__ import annotations

from BalloonWorkbench.gui.paint.painting.layers import SHAPE, SIDE
from BalloonWorkbench.gui.paint.painting.painted import Painting
from BalloonWorkbench.gui.paint.painting.strokes import (
    BRUSH,
    ERASER,
    FILL,
    LINE,
    PEN,
    Fill,
    PaintStroke,
    Spill,
)
from BalloonWorkbench.gui.paint.painting.symmetry import ONCE
from BalloonWorkbench.gui.paint.painting.tools import COLOURS, THICKEST, THINNEST, TOOLS, USUAL
from BalloonWorkbench.gui.qt import QtCore, translate

_BEND = 32  # pieces of a bent line
_LINES = (PEN, BRUSH, ERASER, LINE)


class StrokeInput(QtCore.QObject):
    """Paints on a Painting; places are pixels of it.

    tool, colour, thickness  what it paints with
    symmetry, layer          where that is done again, and on what
    stroke, bending          what it is at: a stroke, and whether that is a line being bent
    `growing` comes while a stroke is drawn, `message` is for the status line.
    """

    growing = QtCore.Signal()
    message = QtCore.Signal(str)

    def __init__(self, painting: Painting, parent=None):
        super().__init__(parent)
        self.painting = painting
        self.tool, self.colour = TOOLS[0], COLOURS[0][0]
        self.thickness = USUAL
        self.symmetry, self.layer = ONCE, SHAPE
        self.stroke: PaintStroke | None = None
        self.bending = False

    def set_thickness(self, value: int) -> None:
        self.thickness = min(max(value, THINNEST), THICKEST)

    def reach(self) -> float:
        """Width of what the tool draws without a tablet [px]; 0 for tools that draw no line."""
        return self.thickness * self.tool.widening if self.tool.name in _LINES else 0.0

    def is_at_work(self) -> bool:
        """The pen is down."""
        return self.stroke is not None and not self.bending

    def begin(self, at, pressure: float = 1.0, erase: bool = False) -> None:
        """The pen goes down."""
        if self.bending:
            self.finish_line(at)
            return
        if self.tool.name == FILL and not erase:
            self._fill(at)
            return
        tool = next(tool for tool in TOOLS if tool.name == ERASER) if erase else self.tool
        self.stroke = PaintStroke(tool.name, self.colour, self.symmetry, layer=self.layer)
        self._pressure_share, self._widening = tool.pressure, tool.widening
        self._add(at, pressure)

    def move(self, at, pressure: float = 1.0, close: float = 0.0) -> None:
        """The pen is drawn on; a point nearer than `close` to the last one is left out."""
        if self.stroke is None:
            return
        if self.stroke.tool == LINE:
            self._pull(at)
            return
        last = self.stroke.points[-1]
        if (QtCore.QPointF(last[0], last[1]) - at).manhattanLength() >= close:
            self._add(at, pressure)
            self.growing.emit()

    def end(self) -> None:
        """The pen goes up."""
        stroke = self.stroke
        if stroke is None:
            return
        if stroke.tool == LINE and not self.bending and len(stroke.points) > 1:
            self.bending = True
            self.message.emit(translate("Move the pointer to bend the line, then click. Esc drops it."))
            return
        if stroke.tool == LINE and len(stroke.points) < 2:
            self.cancel()
            return
        self.stroke, self.bending = None, False
        if stroke.tool == PEN and stroke.is_nearly_closed():
            stroke.points.append(stroke.points[0])
            self.painting.draw_part(stroke, len(stroke.points) - 1)
        if stroke.tool != LINE:
            self.painting.draw_part(stroke, len(stroke.points))
        self.painting.do(stroke, painted=stroke.tool != LINE)

    def cancel(self) -> None:
        """Drop the stroke that is being drawn."""
        if self.stroke is not None:
            self.stroke, self.bending = None, False
            self.painting.repaint()

    def finish_line(self, at=None) -> None:
        """Keep the line, bent through a place or, without one, straight."""
        if at is not None:
            self._pull(at)
        else:
            self.stroke.points[1:-1] = []
        self.end()

    def _width(self, pressure: float) -> float:
        return self.thickness * self._widening * (1.0 - self._pressure_share * (1.0 - pressure))

    def _add(self, at, pressure: float) -> None:
        stroke = self.stroke
        stroke.points.append((*_place(at), round(self._width(pressure), 2)))
        if stroke.tool != LINE:
            self.painting.draw_part(stroke, len(stroke.points) - 1)

    def _pull(self, at) -> None:
        """The end of a line, or its bow, follows the pointer."""
        points = self.stroke.points
        x, y, width = points[0]
        if not self.bending:
            points[1:] = [(*_place(at), width)]
            return
        end = points[-1]
        # the bow goes through the pointer: control point of the parabola at half way
        cx, cy = 2.0 * at.x() - 0.5 * (x + end[0]), 2.0 * at.y() - 0.5 * (y + end[1])
        bow = []
        for step in range(1, _BEND):
            t = step / _BEND
            a, b, c = (1 - t) ** 2, 2 * t * (1 - t), t * t
            bow.append((round(a * x + b * cx + c * end[0], 2), round(a * y + b * cy + c * end[1], 2), width))
        points[1:] = [*bow, end]

    def _fill(self, at) -> None:
        if not (0 <= at.x() < SIDE and 0 <= at.y() < SIDE):
            return
        try:
            self.painting.do(Fill(self.colour, *_place(at), self.symmetry, self.layer))
        except Spill:
            self.message.emit(translate("The colour would run out: close the line around this place first."))


def _place(at) -> tuple[float, float]:
    """As it is in the file, so that what comes back from there is the same."""
    return round(at.x(), 2), round(at.y(), 2)

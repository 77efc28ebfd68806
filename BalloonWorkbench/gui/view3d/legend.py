# SPDX-License-Identifier: LGPL-2.1-or-later
"""A legend in a corner of the 3D view and labels at places in it, drawn by Qt and shown by Coin.

They are part of the scene: they go into saved pictures, and come and go with what they belong to.
"""

from __future__ import annotations

from dataclasses import dataclass

import FreeCADGui as Gui
import numpy as np

from BalloonWorkbench.app.drawings.qt_picture import pixels
from BalloonWorkbench.core.results.colour_map import colours
from BalloonWorkbench.gui.qt import QtCore, QtGui

TOP, BOTTOM = 0.96, -0.94  # of the view's height, where a legend may be
_LEFT = -0.975
_BAR = QtCore.QSizeF(18, 200)  # px, as all sizes here
_MARGIN, _GAP, _TICK = 10, 6, 5
_PAPER, _INK, _WARNING, _MARK = (255, 255, 255, 215), (20, 24, 32), (170, 40, 0), (215, 20, 20)
_FONT, _RING = 13, 6


@dataclass(frozen=True)
class Legend:
    """What a legend tells: a title, then a scale with ticks (share, text), or entries (colour, text).

    colours are (r, g, b) from 0 to 255; notes stand below, warnings in another colour below them
    """

    title: str
    ticks: tuple[tuple[float, str], ...] = ()
    entries: tuple[tuple[tuple[int, int, int], str], ...] = ()
    notes: tuple[str, ...] = ()
    warnings: tuple[str, ...] = ()


def corner_node(legend: Legend, place: float = TOP):
    """A node that shows a legend at the left of the view, at TOP or BOTTOM, however the view turns; and the
    image in it."""
    from pivy import coin

    camera, shift, image = coin.SoOrthographicCamera(), coin.SoTranslation(), coin.SoImage()
    camera.viewportMapping.setValue(coin.SoCamera.LEAVE_ALONE)
    shift.translation.setValue(_LEFT, place, 0.0)
    image.vertAlignment.setValue(coin.SoImage.TOP if place > 0.0 else coin.SoImage.BOTTOM)
    image.horAlignment.setValue(coin.SoImage.LEFT)
    fill(image, drawn(legend))
    return _on_top(coin, coin.SoResetTransform(), camera, shift, image), image


def label_node(place, text: str):
    """A node that shows a ring and a text at a place (x, y, z), in front of everything."""
    from pivy import coin

    shift, image = coin.SoTranslation(), coin.SoImage()
    shift.translation.setValue(*(float(value) for value in place))
    image.vertAlignment.setValue(coin.SoImage.HALF)
    image.horAlignment.setValue(coin.SoImage.CENTER)
    fill(image, _label(text))
    return _on_top(coin, shift, image)


def drawn(legend: Legend):
    """A legend as a QImage."""
    ratio, font = _ratio(), _font()
    metrics, bold = QtGui.QFontMetricsF(font), QtGui.QFont(font)
    bold.setBold(True)
    line = metrics.height()
    rows = [(legend.title, bold), *((text, font) for text in (*legend.notes, *legend.warnings))]
    beside = [text for _, text in (*legend.ticks, *legend.entries)]
    widths = [QtGui.QFontMetricsF(used).horizontalAdvance(text) for text, used in rows]
    widths += [_BAR.width() + _TICK + _GAP + metrics.horizontalAdvance(text) for text in beside]
    width = max(widths) + 2 * _MARGIN
    body = _BAR.height() + line if legend.ticks else (line + _GAP) * len(legend.entries)
    height = 2 * _MARGIN + line + body + line * (len(rows) - 1)
    image = QtGui.QImage(round(width * ratio), round(height * ratio), QtGui.QImage.Format_RGBA8888)
    image.fill(0)
    painter = _painter(image, ratio, QtCore.QRectF(0, 0, width, height))
    top = float(_MARGIN)
    top = _line(painter, bold, _MARGIN, top, legend.title)
    if legend.ticks:
        top = _scale(painter, font, top + 0.5 * line, legend.ticks) + 0.5 * line
    for colour, text in legend.entries:
        painter.fillRect(QtCore.QRectF(_MARGIN, top + _GAP, _BAR.width(), line - 4), QtGui.QColor(*colour))
        _line(painter, font, _MARGIN + _BAR.width() + _GAP, top + _GAP - 2, text)
        top += line + _GAP
    for text in legend.notes:
        top = _line(painter, font, _MARGIN, top, text)
    painter.setPen(QtGui.QColor(*_WARNING))
    for text in legend.warnings:
        top = _line(painter, font, _MARGIN, top, text)
    painter.end()
    return image


def _scale(painter, font, top: float, ticks) -> float:
    """The bar with its ticks; returns where it ends."""
    steps = int(_BAR.height())
    for step, rgb in enumerate(colours(np.linspace(1.0, 0.0, steps)).tolist()):
        painter.fillRect(QtCore.QRectF(_MARGIN, top + step, _BAR.width(), 1.5), QtGui.QColor(*rgb))
    half = 0.5 * QtGui.QFontMetricsF(font).height()
    for share, text in ticks:
        at, right = top + (1.0 - share) * _BAR.height(), _MARGIN + _BAR.width()
        painter.drawLine(QtCore.QPointF(right, at), QtCore.QPointF(right + _TICK, at))
        _line(painter, font, right + _TICK + _GAP, at - half, text)
    return top + _BAR.height()


def _label(text: str):
    """A ring in the middle of the picture, and a short text on paper above and right of it."""
    ratio, font = _ratio(), _font()
    metrics = QtGui.QFontMetricsF(font)
    width, height = metrics.horizontalAdvance(text) + _MARGIN, metrics.height() + 4
    middle = QtCore.QPointF(width + 2 * _RING, height + 2 * _RING)
    image = QtGui.QImage(
        round(2 * middle.x() * ratio), round(2 * middle.y() * ratio), QtGui.QImage.Format_RGBA8888
    )
    image.fill(0)
    painter = _painter(image, ratio, QtCore.QRectF(middle.x() + _RING, _RING, width, height))
    _line(painter, font, middle.x() + _RING + 0.5 * _MARGIN, _RING + 2.0, text)
    for colour, line in ((_PAPER, 5.0), (_MARK, 2.0)):
        painter.setPen(QtGui.QPen(QtGui.QColor(*colour), line))
        painter.setBrush(QtCore.Qt.NoBrush)
        painter.drawEllipse(middle, _RING, _RING)
    painter.end()
    return image


def _painter(image, ratio: float, paper):
    painter = QtGui.QPainter(image)
    painter.scale(ratio, ratio)
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    painter.setPen(QtCore.Qt.NoPen)
    painter.setBrush(QtGui.QColor(*_PAPER))
    painter.drawRoundedRect(paper, 5, 5)
    painter.setPen(QtGui.QColor(*_INK))
    return painter


def _line(painter, font, left: float, top: float, text: str) -> float:
    """Write a line; returns where the next one begins."""
    metrics = QtGui.QFontMetricsF(font)
    painter.setFont(font)
    painter.drawText(QtCore.QPointF(left, top + metrics.ascent()), text)
    return top + metrics.height()


def _font():
    font = QtGui.QFont(Gui.getMainWindow().font())
    font.setPixelSize(_FONT)
    return font


def _ratio() -> float:
    return float(Gui.getMainWindow().devicePixelRatioF())


def fill(node, image) -> None:
    """Let a node show an image."""
    from pivy import coin

    rgba = np.ascontiguousarray(pixels(image)[::-1])
    node.image.setValue(coin.SbVec2s(image.width(), image.height()), 4, rgba.tobytes())


def _on_top(coin, *children):
    """Nodes in front of all others: neither to be picked nor part of what fits into the view."""
    outside = coin.SoType.fromName("SoSkipBoundingGroup").createInstance()
    front, pick, textures = coin.SoAnnotation(), coin.SoPickStyle(), coin.SoTexture2()
    pick.style.setValue(coin.SoPickStyle.UNPICKABLE)
    for child in (pick, textures, *children):
        front.addChild(child)
    outside.addChild(front)
    return outside

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Words as a picture, in a font of the system: in any script, with coloured signs too."""

from __future__ import annotations

import math

from BalloonWorkbench.gui.paint.painting.layers import SIDE
from BalloonWorkbench.gui.qt import QtCore, QtGui

MOST_LETTERS = 80
_SMALLEST, _LARGEST = 6.0, 1.0 * SIDE  # px, of a line's height
_ROUND = 0.22  # of the height, by which joined letters are surrounded
_LEANING = 0.1  # of the height, by which slanted letters may lean out
_LIGHT = 140  # of 255; on darker colours letters are white


def picture_of(
    words: str, family: str, height: float, colour: str, joined: bool = False, widest: float = 2.0 * SIDE
):
    """A line of words (QImage), transparent around them.

    height  of the line, px, less where it would be wider than `widest` px
    joined  on a ground of this colour that holds them together; the letters are white or black
    """
    height = min(max(height, _SMALLEST), _LARGEST)
    font = QtGui.QFont(family)
    font.setPixelSize(max(1, round(height / (1.0 + 2.0 * _ROUND * joined))))
    size = QtGui.QFontMetricsF(font)
    rim = (_ROUND if joined else _LEANING) * font.pixelSize()
    width = math.ceil(max(size.horizontalAdvance(words), size.boundingRect(words).width()) + 2.0 * rim)
    if width > widest and height > _SMALLEST:
        return picture_of(words, family, 0.98 * height * widest / width, colour, joined, widest)
    image = QtGui.QImage(
        max(width, 1), math.ceil(size.height() + 2.0 * rim * joined), QtGui.QImage.Format_ARGB32_Premultiplied
    )
    image.fill(0)
    painter = QtGui.QPainter(image)
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    painter.setRenderHint(QtGui.QPainter.TextAntialiasing)
    painter.setFont(font)
    ground = QtGui.QColor(colour)
    room = QtCore.QRectF(image.rect())
    painter.setPen(ground)
    if joined:
        painter.setBrush(ground)
        painter.drawRoundedRect(room.adjusted(0.5, 0.5, -0.5, -0.5), 2.0 * rim, 2.0 * rim)
        painter.setPen(QtGui.QColor("#1c1c22" if QtGui.qGray(ground.rgb()) > _LIGHT else "#ffffff"))
    painter.drawText(room, int(QtCore.Qt.AlignCenter | QtCore.Qt.TextSingleLine), words)
    painter.end()
    return image

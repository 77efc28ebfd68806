# SPDX-License-Identifier: LGPL-2.1-or-later
"""The two layers of a painting: the shape, which becomes the outline, and the decoration printed on it."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.app.drawings.qt_picture import pixels
from BalloonWorkbench.core.tracing.raster import label
from BalloonWorkbench.gui.qt import QtGui

SIDE = 1000  # px of the paper; a quarter of a millimetre on a balloon of 250 mm
SHAPE, DECORATION = "shape", "decoration"
LAYERS = (SHAPE, DECORATION)


def layer_from(data: dict) -> str:
    """The layer of a step in a file; the first ones had the shape alone."""
    return DECORATION if data.get("layer") == DECORATION else SHAPE


def blank():
    """An empty image of the paper."""
    image = QtGui.QImage(SIDE, SIDE, QtGui.QImage.Format_ARGB32_Premultiplied)
    image.fill(0)
    return image


def most_alpha(image) -> int:
    """The alpha of its least transparent pixel."""
    return int(np.frombuffer(image.constBits(), np.uint32).max()) >> 24  # its highest byte


def is_blank(image) -> bool:
    """Nothing is painted there that would become an outline."""
    return most_alpha(image) <= 127


def enclosed(shape):
    """An image that covers what is bare inside the lines of a shape; None where nothing is."""
    bare = pixels(shape)[..., 3] < 128
    labels, count = label(np.pad(bare, 1, constant_values=True))
    if count < 2:
        return None
    inside = (bare & (labels[1:-1, 1:-1] != labels[0, 0])).astype(np.uint32) * 0xFFFFFFFF
    height, width = inside.shape
    mask = QtGui.QImage(inside.tobytes(), width, height, 4 * width, QtGui.QImage.Format_ARGB32_Premultiplied)
    return mask.copy()


def together(shape, decoration, inside):
    """The shape with the decoration on it, and in what it encloses; beside it there is none."""
    image = shape.copy()
    painter = QtGui.QPainter(image)
    painter.setCompositionMode(QtGui.QPainter.CompositionMode_SourceAtop)
    painter.drawImage(0, 0, decoration)
    painter.end()
    if inside is not None:
        film = decoration.copy()
        painter = QtGui.QPainter(film)
        painter.setCompositionMode(QtGui.QPainter.CompositionMode_DestinationIn)
        painter.drawImage(0, 0, inside)
        painter.end()
        painter = QtGui.QPainter(image)
        painter.setCompositionMode(QtGui.QPainter.CompositionMode_DestinationOver)
        painter.drawImage(0, 0, film)
        painter.end()
    return image

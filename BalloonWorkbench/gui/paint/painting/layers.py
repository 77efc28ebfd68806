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


class Together:
    """The shape with the decoration on it, and in what it encloses; beside it there is none.

    image  of both, once `follow` was called
    """

    def __init__(self) -> None:
        self.image, self._film = blank(), blank()

    def follow(self, shape, decoration, inside, changed) -> None:
        """Take over what has changed, a region; inside: see `enclosed`."""
        modes = QtGui.QPainter
        if inside is not None:
            _lay(self._film, changed, (decoration, modes.CompositionMode_Source))
            _lay(self._film, changed, (inside, modes.CompositionMode_DestinationIn))
        _lay(
            self.image,
            changed,
            (shape, modes.CompositionMode_Source),
            (decoration, modes.CompositionMode_SourceAtop),
        )
        if inside is not None:
            _lay(self.image, changed, (self._film, modes.CompositionMode_DestinationOver))


def _lay(image, region, *others) -> None:
    """Draw others on an image, within a region, each with its mode."""
    painter = QtGui.QPainter(image)
    painter.setClipRegion(region)
    for other, mode in others:
        painter.setCompositionMode(mode)
        painter.drawImage(0, 0, other)
    painter.end()

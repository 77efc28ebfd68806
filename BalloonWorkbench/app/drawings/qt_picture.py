# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pixels of a picture file through Qt, which every FreeCAD has: for machines without a working OpenCV."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np

from BalloonWorkbench.core.errors import PictureError

try:
    from PySide import QtGui  # FreeCAD's name for the Qt it was built with
except ImportError:
    try:
        from PySide6 import QtGui
    except ImportError:
        from PySide2 import QtGui

# Qt 6 refuses pictures above 128 MB unpacked; the reader of pictures has checked the size before.
_MEGABYTES = 512


def picture_reader(source):
    """A QImageReader of a path or a device: it takes pictures as large as ours may be, and holds them upright
    by the camera's note."""
    reader = QtGui.QImageReader(source)
    reader.setAutoTransform(True)
    reader.setDecideFormatFromContent(True)
    if hasattr(reader, "setAllocationLimit"):
        reader.setAllocationLimit(_MEGABYTES)
    return reader


def decode(path: str | os.PathLike[str]) -> np.ndarray:
    """Pixels (h, w, 4) uint8 as red, green, blue, alpha, upright. Needs no running Qt application.

    PictureError where Qt cannot read the file.
    """
    reader = picture_reader(os.fspath(path))
    image = reader.read()
    if image.isNull():
        raise PictureError(
            f"'{Path(path).name}' is damaged or not a picture ({reader.errorString()}). "
            "Save it as PNG, JPEG or BMP once more."
        )
    return pixels(image)


def unpacked(content: bytes, name: str) -> np.ndarray:
    """Pixels (h, w, 4) as of `decode` from the content of a PNG file, which comes from the file `name`."""
    image = QtGui.QImage.fromData(content)
    if image.isNull():
        raise PictureError(f"'{name}' is damaged or not a picture. Save it as PNG, JPEG or BMP once more.")
    return pixels(image)


def pixels(image) -> np.ndarray:
    """Pixels (h, w, 4) uint8 of a QImage as red, green, blue, alpha."""
    image = image.convertToFormat(QtGui.QImage.Format_RGBA8888)
    lines = np.frombuffer(image.constBits(), dtype=np.uint8).reshape(image.height(), image.bytesPerLine())
    return lines[:, : 4 * image.width()].reshape(image.height(), image.width(), 4).copy()

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures from files and from other programs, and what is copied for them."""

from __future__ import annotations

import tempfile
from pathlib import Path

from BalloonWorkbench.app.drawings.qt_picture import picture_reader, pixels
from BalloonWorkbench.core.errors import PictureError
from BalloonWorkbench.core.readers.read import read_drawing
from BalloonWorkbench.core.units import from_mm
from BalloonWorkbench.gui.paint.painting.layers import SIDE
from BalloonWorkbench.gui.paint.painting.pieces import PastedPicture, packed
from BalloonWorkbench.gui.qt import QtCore, QtGui, translate

_MOST_PIXELS = 64_000_000
_SVG = "image/svg+xml"
_PNG = "image/png"
_DRAWN = 0.6  # of the paper's side, that a drawing of lines becomes wide
_VECTORS = {".svg", ".dxf", ".json"}


def picture_from(path: Path) -> PastedPicture:
    """The picture in a file, no larger than the paper, upright; PictureError when it is none."""
    return PastedPicture(packed(_read(picture_reader(str(path)), path.name)))


def can_be_pasted(mime) -> bool:
    """There is a picture, or a file that may hold one."""
    return mime is not None and (mime.hasImage() or bool(_kinds(mime)) or _file_in(mime) is not None)


def pasted(mime, colour: str):
    """The picture (QImage) that another program has copied or that was dropped; BalloonError without one.

    colour  of a drawing of lines, which is filled
    """
    for kind in _kinds(mime):
        return _copied_drawing(mime, colour) if kind == _SVG else _unpacked(mime, kind)
    path = _file_in(mime)
    if path is not None:
        if path.suffix.lower() in _VECTORS:
            return _painted_drawing(path, colour)
        return _read(picture_reader(str(path)), path.name)
    image = QtGui.QImage(mime.imageData()) if mime.hasImage() else QtGui.QImage()
    if image.isNull():
        raise PictureError(translate("There is no picture to paste: copy one first."))
    return _shrunk(image)


def copied(image):
    """A picture for other programs, with its transparency."""
    buffer = QtCore.QBuffer()
    buffer.open(QtCore.QIODevice.WriteOnly)
    image.save(buffer, "PNG")
    mime = QtCore.QMimeData()
    mime.setData(_PNG, buffer.data())
    mime.setImageData(image)
    return mime


def is_opaque(image) -> bool:
    """It has a background."""
    return not image.hasAlphaChannel() or int(pixels(image)[..., 3].min()) == 255


def _kinds(mime) -> list[str]:
    """The kinds of pictures that are offered, the best first: as pixels, as lines."""
    kinds = [kind for kind in mime.formats() if kind.startswith("image/")]
    return sorted(kinds, key=lambda kind: (kind == _SVG, kind != _PNG))


def _file_in(mime) -> Path | None:
    places = [url.toLocalFile() for url in mime.urls() if url.isLocalFile()]
    return Path(places[0]) if places else None


def _unpacked(mime, kind: str):
    content = QtCore.QBuffer()
    content.setData(mime.data(kind))
    content.open(QtCore.QIODevice.ReadOnly)
    return _read(picture_reader(content), translate("The copied picture"))


def _read(reader, name: str):
    """The picture, of an animation its first one; refused by its size before it is unpacked."""
    size = reader.size()
    if size.width() * size.height() > _MOST_PIXELS:
        raise PictureError(
            translate(
                "'{}' has {} x {} pixels, more than {} million. Make it smaller; 2000 across are plenty."
            ).format(name, size.width(), size.height(), _MOST_PIXELS // 10**6)
        )
    is_picture = size.isValid() and not bytes(reader.format()).startswith(b"svg")
    image = reader.read() if is_picture else QtGui.QImage()
    if image.isNull():
        raise PictureError(
            translate("'{}' is not a picture. Save it as PNG, JPEG or BMP once more.").format(name)
        )
    return _shrunk(image)


def _shrunk(image):
    """No larger than the paper."""
    if max(image.width(), image.height()) > SIDE:
        image = image.scaled(SIDE, SIDE, QtCore.Qt.KeepAspectRatio, QtCore.Qt.SmoothTransformation)
    return image


def _copied_drawing(mime, colour: str):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "copied.svg"
        path.write_bytes(bytes(mime.data(_SVG)))
        return _painted_drawing(path, colour)


def _painted_drawing(path: Path, colour: str):
    """A drawing of lines as a picture: its shapes are filled, their holes are not."""
    drawing, _ = read_drawing(path, width=from_mm(SIDE), height=from_mm(SIDE))
    width, height = drawing.size
    scale = _DRAWN * SIDE / max(width, height)
    outline = QtGui.QPainterPath()
    for part in drawing.parts:
        for loop in part.loops:
            corners = [QtCore.QPointF(scale * x, scale * (height - y)) for x, y in loop.tolist()]
            outline.addPolygon(QtGui.QPolygonF(corners))
            outline.closeSubpath()
    box = outline.boundingRect()
    image = QtGui.QImage(
        int(box.width()) + 3, int(box.height()) + 3, QtGui.QImage.Format_ARGB32_Premultiplied
    )
    image.fill(0)
    painter = QtGui.QPainter(image)
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    painter.translate(1.0 - box.left(), 1.0 - box.top())
    painter.fillPath(outline, QtGui.QColor(colour))
    painter.end()
    return image

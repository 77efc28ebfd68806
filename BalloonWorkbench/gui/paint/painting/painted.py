# SPDX-License-Identifier: LGPL-2.1-or-later
"""The painting: its steps in order, with undo and redo, and the picture that they make.

It is kept as a PNG picture that any program can show; the steps travel in a text inside it.
"""

from __future__ import annotations

import base64
import json
import zlib
from pathlib import Path

import numpy as np

from BalloonWorkbench.app.drawings.drawing_file import KEY
from BalloonWorkbench.core.errors import PictureError
from BalloonWorkbench.gui.paint.painting.strokes import (
    BRUSH,
    ERASER,
    FILL,
    LINE,
    PEN,
    Clear,
    Fill,
    PaintStroke,
    PastedPicture,
)
from BalloonWorkbench.gui.paint.painting.widen import WIDEN, Widen
from BalloonWorkbench.gui.qt import QtCore, QtGui, translate

SIDE = 1000  # px; a quarter of a millimetre on a balloon of 250 mm
_KEPT = 8  # steps between two copies of the picture
_COPIES = 12
_MOST_TEXT = 4_000_000  # characters; readers of PNG refuse longer ones
#: The kinds of steps by the name that their file has.
_KINDS = dict.fromkeys((PEN, BRUSH, ERASER, LINE), PaintStroke)
_KINDS |= {FILL: Fill, WIDEN: Widen, "picture": PastedPicture, "clear": Clear}


class Painting(QtCore.QObject):
    """Steps on a square sheet of paper, and a picture under it for tracing.

    image     what is painted, transparent elsewhere
    backdrop  a Picture to trace, not part of the painting; or None
    revision  changes with every change
    """

    changed = QtCore.Signal()

    def __init__(self, parent=None):
        super().__init__(parent)
        self.image = _blank()
        self.backdrop: PastedPicture | None = None
        self.revision = 0
        self._steps: list = []
        self._undone: list = []
        self._copies: dict[int, object] = {}

    @property
    def steps(self) -> tuple:
        """What has been done, the first first."""
        return tuple(self._steps)

    def can_undo(self) -> bool:
        return bool(self._steps)

    def can_redo(self) -> bool:
        return bool(self._undone)

    def is_empty(self) -> bool:
        """Nothing is painted."""
        # alpha is the highest byte of a pixel
        return int(np.frombuffer(self.image.constBits(), np.uint32).max()) >> 24 <= 127

    def do(self, step, painted: bool = False) -> None:
        """One more step; painted: it is on the image already. Raises what the step raises."""
        if not painted:
            step.paint(self.image)
        self._steps.append(step)
        self._undone.clear()
        if len(self._steps) % _KEPT == 0:
            self._keep()
        self.touch()

    def touch(self) -> None:
        """The image has changed."""
        self.revision += 1
        self.changed.emit()

    def undo(self) -> None:
        if self._steps:
            self._undone.append(self._steps.pop())
            self.repaint()

    def redo(self) -> None:
        if self._undone:
            step = self._undone.pop()
            step.paint(self.image)
            self._steps.append(step)
            self.touch()

    def repaint(self) -> None:
        """The image from the steps, from the last copy on."""
        count = len(self._steps)
        self._copies = {number: copy for number, copy in self._copies.items() if number <= count}
        start = max(self._copies, default=0)
        self.image = self._copies[start].copy() if start else _blank()
        for step in self._steps[start:]:
            step.paint(self.image)
        self.touch()

    def set_backdrop(self, picture: PastedPicture | None) -> None:
        self.backdrop = picture
        self.changed.emit()

    def file_image(self):
        """The image with its steps in it, ready to be saved as PNG."""
        image = self.image.convertToFormat(QtGui.QImage.Format_ARGB32)
        text = self._text()
        if len(text) <= _MOST_TEXT:
            image.setText(KEY, text)
        return image

    def load(self, path: Path) -> None:
        """Take the painting from a file; a picture without steps becomes the first one. PictureError."""
        image = QtGui.QImage(str(path))
        if image.isNull():
            raise PictureError(
                translate("'{}' is not a picture. Save it as PNG, JPEG or BMP once more.").format(path.name)
            )
        text = image.text(KEY)
        data = json.loads(zlib.decompress(base64.b64decode(text))) if text else {}
        steps = [_KINDS[step["tool"]].from_data(step) for step in data.get("steps", ())]
        self._steps = steps or [PastedPicture(path.read_bytes())]
        self.backdrop = PastedPicture.from_data(data["backdrop"]) if data.get("backdrop") else None
        self._undone, self._copies = [], {}
        self.repaint()

    def _text(self) -> str:
        data = {
            "version": 1,
            "steps": [step.data() for step in self._steps],
            "backdrop": self.backdrop.data() if self.backdrop else None,
        }
        return base64.b64encode(zlib.compress(json.dumps(data, separators=(",", ":")).encode(), 9)).decode()

    def _keep(self) -> None:
        """A copy of the image, so that undo need not begin at the first step."""
        self._copies[len(self._steps)] = self.image.copy()
        while len(self._copies) > _COPIES:
            del self._copies[min(self._copies)]


def picture_from(path: Path) -> PastedPicture:
    """The picture in a file, no larger than the paper, upright; PictureError when it is none."""
    reader = QtGui.QImageReader(str(path))
    reader.setAutoTransform(True)
    reader.setDecideFormatFromContent(True)
    image = reader.read()
    if image.isNull():
        raise PictureError(
            translate("'{}' is not a picture. Save it as PNG, JPEG or BMP once more.").format(path.name)
        )
    if max(image.width(), image.height()) > SIDE:
        image = image.scaled(SIDE, SIDE, QtCore.Qt.KeepAspectRatio, QtCore.Qt.SmoothTransformation)
    buffer = QtCore.QBuffer()
    buffer.open(QtCore.QIODevice.WriteOnly)
    image.save(buffer, "PNG" if image.hasAlphaChannel() else "JPG", -1 if image.hasAlphaChannel() else 92)
    return PastedPicture(bytes(buffer.data()))


def _blank():
    image = QtGui.QImage(SIDE, SIDE, QtGui.QImage.Format_ARGB32_Premultiplied)
    image.fill(QtCore.Qt.transparent)
    return image

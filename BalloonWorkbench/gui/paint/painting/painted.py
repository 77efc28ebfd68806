# SPDX-License-Identifier: LGPL-2.1-or-later
"""The painting: its steps in order, with undo and redo, and the picture that they make.

It is kept as a PNG picture that any program can show; the steps travel in a text inside it, and beside a
decoration the shape without it in another one.
"""

from __future__ import annotations

import base64
import json
import zlib
from pathlib import Path

from BalloonWorkbench.app.drawings.drawing_file import KEY
from BalloonWorkbench.core.errors import PictureError
from BalloonWorkbench.core.tracing.picture_file import SHAPE_KEY
from BalloonWorkbench.gui.paint.painting.layers import (
    DECORATION,
    LAYERS,
    SHAPE,
    SIDE,
    Together,
    blank,
    enclosed,
    is_blank,
    most_alpha,
)
from BalloonWorkbench.gui.paint.painting.pieces import (
    CLEAR,
    CUT,
    PICTURE,
    STAMPED,
    Clear,
    CutAway,
    PastedPicture,
    Stamped,
    packed,
)
from BalloonWorkbench.gui.paint.painting.strokes import BRUSH, ERASER, FILL, LINE, PEN, Fill, PaintStroke
from BalloonWorkbench.gui.paint.painting.widen import WIDEN, Widen
from BalloonWorkbench.gui.qt import QtCore, QtGui, translate

_PAPER = QtCore.QRect(0, 0, SIDE, SIDE)
_KEPT = 8  # steps between two copies of the picture
_COPIES = 12
_MOST_TEXT = 4_000_000  # characters; readers of PNG refuse longer ones
_VERSION = 2  # of the steps in a file; 1 knew a mirror in the middle alone, and one layer
#: The kinds of steps by the name that their file has.
_KINDS = dict.fromkeys((PEN, BRUSH, ERASER, LINE), PaintStroke)
_KINDS |= {FILL: Fill, WIDEN: Widen, PICTURE: PastedPicture, STAMPED: Stamped, CUT: CutAway, CLEAR: Clear}


class Painting(QtCore.QObject):
    """Steps on a square sheet of paper, and a picture under it for tracing.

    layers    the image of each layer, transparent where nothing is painted
    backdrop  a picture to trace, not part of the painting; or None
    revision  changes with every change
    """

    changed = QtCore.Signal()

    def __init__(self, parent=None):
        super().__init__(parent)
        self.layers = {name: blank() for name in LAYERS}
        self.backdrop: PastedPicture | None = None
        self.revision = 0
        self._steps: list = []
        self._undone: list = []
        self._copies: dict[int, dict] = {}
        self._is_decorated = False
        self._inside: object | None = None  # what the shape encloses
        self._is_inside_known = False
        self._both = Together()
        self._changed = QtGui.QRegion(_PAPER)  # since both were put together

    @property
    def image(self):
        """What is seen: the shape, and on it the decoration."""
        if not self._is_decorated:
            return self.layers[SHAPE]
        if not self._is_inside_known:
            self._inside, self._is_inside_known = enclosed(self.layers[SHAPE]), True
            self._changed = QtGui.QRegion(_PAPER)
        if not self._changed.isEmpty():
            self._both.follow(self.layers[SHAPE], self.layers[DECORATION], self._inside, self._changed)
            self._changed = QtGui.QRegion()
        return self._both.image

    @property
    def steps(self) -> tuple:
        """What has been done, the first first."""
        return tuple(self._steps)

    def can_undo(self) -> bool:
        return bool(self._steps)

    def can_redo(self) -> bool:
        return bool(self._undone)

    def is_empty(self) -> bool:
        """There is no shape."""
        return is_blank(self.layers[SHAPE])

    def draw_part(self, stroke: PaintStroke, number: int) -> None:
        """Paint a piece of a stroke that is being drawn, see `PaintStroke.paint_part`."""
        self._is_decorated |= stroke.layer == DECORATION
        changed = stroke.paint_part(self.layers[stroke.layer], number)
        if self._is_decorated:
            self._changed += changed

    def do(self, step, painted: bool = False) -> None:
        """One more step; painted: it is on the image already. Raises what the step raises."""
        if not painted:
            self._paint(step)
        self._is_inside_known &= SHAPE not in step.layers
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
            self._paint(step)
            self._steps.append(step)
            self.touch()

    def repaint(self) -> None:
        """The image from the steps, from the last copy on."""
        count = len(self._steps)
        self._copies = {number: copy for number, copy in self._copies.items() if number <= count}
        start = max(self._copies, default=0)
        copies = self._copies.get(start, {})
        self.layers = {name: copies[name].copy() if name in copies else blank() for name in LAYERS}
        self._is_decorated = most_alpha(self.layers[DECORATION]) > 0
        self._is_inside_known = False
        self._changed = QtGui.QRegion(_PAPER)
        for step in self._steps[start:]:
            self._paint(step)
        self.touch()

    def set_backdrop(self, picture: PastedPicture | None) -> None:
        self.backdrop = picture
        self.changed.emit()

    def file_image(self):
        """The image with its steps in it, ready to be saved as PNG."""
        image = self.image.convertToFormat(QtGui.QImage.Format_ARGB32)
        image.setText(KEY, self._text())
        if self._is_decorated:
            image.setText(SHAPE_KEY, base64.b64encode(packed(self.layers[SHAPE])).decode())
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
        if data.get("version", _VERSION) > _VERSION:
            raise PictureError(
                translate("'{}' was painted with a newer release: update Film Balloon.").format(path.name)
            )
        steps = [_KINDS[step["tool"]].from_data(step) for step in data.get("steps", ())]
        self._steps = steps or [PastedPicture(path.read_bytes())]
        self.backdrop = PastedPicture.from_data(data["backdrop"]) if data.get("backdrop") else None
        self._undone, self._copies = [], {}
        self.repaint()

    def _paint(self, step) -> None:
        """Put a step on its layers; a fill in the decoration sees what lies below."""
        seen = self.image if step.tool == FILL and step.layer == DECORATION else None
        for name in step.layers:
            if name == SHAPE or len(step.layers) == 1 or self._is_decorated:
                self._is_decorated |= name == DECORATION
                step.paint(self.layers[name], seen)
        self._changed = QtGui.QRegion(_PAPER)
        self._is_inside_known &= SHAPE not in step.layers
        self._is_decorated &= step.tool != CLEAR

    def _text(self) -> str:
        """The steps, or where they are too long for a file the layers as they are."""
        text = self._written(self._steps)
        if len(text) > _MOST_TEXT:
            text = self._written([PastedPicture(packed(self.layers[name]), layer=name) for name in LAYERS])
        return text

    def _written(self, steps) -> str:
        data = {
            "version": _VERSION,
            "steps": [step.data() for step in steps],
            "backdrop": self.backdrop.data() if self.backdrop else None,
        }
        return base64.b64encode(zlib.compress(json.dumps(data, separators=(",", ":")).encode(), 9)).decode()

    def _keep(self) -> None:
        """A copy of the layers, so that undo need not begin at the first step."""
        used = LAYERS if self._is_decorated else (SHAPE,)
        self._copies[len(self._steps)] = {name: self.layers[name].copy() for name in used}
        while len(self._copies) > _COPIES:
            del self._copies[min(self._copies)]

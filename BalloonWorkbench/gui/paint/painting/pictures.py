# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures from files and other programs: as paint, without their background, or under the paper for
tracing."""

from __future__ import annotations

from pathlib import Path

from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.gui.long_work.worker import Worker
from BalloonWorkbench.gui.paint.painting.incoming import is_opaque, pasted, picture_from
from BalloonWorkbench.gui.paint.painting.layers import SHAPE
from BalloonWorkbench.gui.paint.painting.painted import Painting
from BalloonWorkbench.gui.paint.painting.pieces import PastedPicture, packed
from BalloonWorkbench.gui.paint.preview.requests import CutOut
from BalloonWorkbench.gui.qt import QtCore, QtGui
from BalloonWorkbench.gui.window.file_dialogs import ask_for_picture


class Pictures(QtCore.QObject):
    """Puts pictures into a painting; `message` says why one cannot be used.

    `arrived` carries a picture (QImage) that is to be placed, and its middle (QPointF or None).
    """

    message = QtCore.Signal(str)
    arrived = QtCore.Signal(object, object)

    def __init__(self, painting: Painting, hand, parent):
        super().__init__(parent)
        self._painting, self._hand = painting, hand
        self._worker: Worker | None = None

    def choose(self, as_paint: bool) -> None:
        """Ask for a file and put it on or under the paper."""
        path = ask_for_picture(self.parent(), "webp")
        if path:
            (self.put_on if as_paint else self.lay_under)(Path(path))

    def put_on(self, path: Path) -> None:
        """Paint a picture, without its background, on the paper."""
        try:
            content = picture_from(path).content
        except BalloonError as error:
            self.message.emit(str(error))
            return
        self._cut_out(content, lambda cut: self._painting.do(PastedPicture(cut, layer=self._hand.layer)))

    def paste(self, mime, at=None) -> None:
        """Let the user place a picture; what becomes an outline comes without its background."""
        try:
            image = pasted(mime, self._hand.colour)
        except BalloonError as error:
            self.message.emit(str(error))
            return
        if self._hand.layer == SHAPE and is_opaque(image):
            self._cut_out(packed(image), lambda cut: self.arrived.emit(QtGui.QImage.fromData(cut), at))
        else:
            self.arrived.emit(image, at)

    def lay_under(self, path: Path) -> None:
        """A picture for tracing."""
        try:
            self._painting.set_backdrop(picture_from(path))
        except BalloonError as error:
            self.message.emit(str(error))

    def stop(self) -> None:
        """Give up a picture that is being cut out."""
        if self._worker is not None:
            self._worker.abandon()
            self._worker = None

    def _cut_out(self, content: bytes, use) -> None:
        """Take away a background, then use what is left, a PNG; a picture that is on the way gives way."""
        self.stop()
        self._worker = worker = Worker(CutOut(content), self)

        def ended() -> None:
            if worker is not self._worker:
                return
            self._worker = None
            if worker.design is not None:
                use(worker.design)
            else:
                self.message.emit(worker.fault() or str(worker.error))

        worker.ended.connect(ended)
        worker.start()

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures from files: as paint, without their background, or under the paper for tracing."""

from __future__ import annotations

from pathlib import Path

from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.gui.long_work.worker import Worker
from BalloonWorkbench.gui.paint.painting.painted import Painting, picture_from
from BalloonWorkbench.gui.paint.painting.strokes import PastedPicture
from BalloonWorkbench.gui.paint.preview.requests import CutOut
from BalloonWorkbench.gui.qt import QtCore
from BalloonWorkbench.gui.window.file_dialogs import ask_for_picture


class Pictures(QtCore.QObject):
    """Puts pictures into a painting; `told` says why one cannot be used."""

    message = QtCore.Signal(str)

    def __init__(self, painting: Painting, parent):
        super().__init__(parent)
        self._painting = painting
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
        self._worker = Worker(CutOut(content), self)
        self._worker.ended.connect(self._cut_out)
        self._worker.start()

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

    def _cut_out(self) -> None:
        worker, self._worker = self._worker, None
        if worker.design is not None:
            self._painting.do(PastedPicture(worker.design))
        else:
            self.message.emit(str(worker.error))

# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture that is traced anew beside the window, the newest request alone."""

from __future__ import annotations

from dataclasses import dataclass

from BalloonWorkbench.app.drawings.drawing_file import File, file_of, shapes_in
from BalloonWorkbench.app.outline import reading_of
from BalloonWorkbench.app.properties.quantities import metres
from BalloonWorkbench.core.options.drawing import TracingOptions
from BalloonWorkbench.gui.long_work.worker import Worker
from BalloonWorkbench.gui.qt import QtCore


@dataclass(frozen=True)
class TracingRequest:
    """One tracing, and whether it is to be kept."""

    file: File
    size: tuple
    reading: tuple
    tracing: TracingOptions
    keep: bool

    def solve(self, progress):
        """The drawing; the document's recompute then has it at once."""
        return shapes_in(self.file, self.size, *self.reading, self.tracing)


class Retracing(QtCore.QObject):
    """`ended` carries a worker that has traced, or failed, when nothing newer was asked for."""

    ended = QtCore.Signal(object)

    def __init__(self, parent):
        super().__init__(parent)
        self._worker: Worker | None = None
        self._next: TracingRequest | None = None

    def ask(self, obj, tracing: TracingOptions, keep: bool) -> None:
        """Trace the picture of an outline in another way."""
        size = metres(obj.Width) or None, metres(obj.Height) or None
        self._next = TracingRequest(file_of(obj.Drawing), size, reading_of(obj)[:2], tracing, keep)
        if self._worker is None:
            self._begin()

    def stop(self) -> None:
        """Nobody wants an answer any more."""
        self._next = None
        if self._worker is not None:
            worker, self._worker = self._worker, None
            worker.abandon()

    def _begin(self) -> None:
        request, self._next = self._next, None
        self._worker = Worker(request, self)
        self._worker.ended.connect(self._done)
        self._worker.start()

    def _done(self) -> None:
        worker, self._worker = self._worker, None
        if worker is None:
            return
        if self._next is not None:
            self._begin()
        else:
            self.ended.emit(worker)

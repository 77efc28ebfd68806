# SPDX-License-Identifier: LGPL-2.1-or-later
"""The engine in a thread of its own; it sees arrays only, the document stays with the main thread."""

from __future__ import annotations

import gc

from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.gui.qt import QtCore


class _Sweeper(QtCore.QObject):
    """Holds back Python's garbage collector while a worker runs.

    It would run in any thread, and what it finds may be timers and widgets: Qt ends the program when another
    thread than their own deletes them.
    """

    ended = QtCore.Signal()

    def __init__(self):
        super().__init__()
        self._running = 0
        self.ended.connect(self._one_less)

    def one_more(self):
        self._running += 1
        gc.disable()

    def _one_less(self):
        self._running -= 1
        if not self._running:
            gc.enable()


_sweeper = _Sweeper()


class Worker(QtCore.QThread):
    """Solves one request. After `finished`, either `design` or `error` is set."""

    progressed = QtCore.Signal(float, str)

    def __init__(self, request, parent=None):
        super().__init__(parent)
        self.request = request
        self.design = None
        self.error: BalloonError | None = None
        self._stop = False

    def start(self, *priority):
        """Begin; call it in the main thread."""
        _sweeper.one_more()
        super().start(*priority)

    def run(self):
        try:
            self.design = self.request.solve(self._report)
        except BalloonError as error:
            self.error = error
        finally:
            _sweeper.ended.emit()

    def stop(self):
        """Ask the engine to stop at its next step."""
        self._stop = True

    def _report(self, fraction: float, text: str) -> bool:
        self.progressed.emit(fraction, text)
        return not self._stop

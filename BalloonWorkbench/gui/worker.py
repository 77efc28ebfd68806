# SPDX-License-Identifier: LGPL-2.1-or-later
"""The engine in a thread of its own; it sees arrays only, the document stays with the main thread."""

from __future__ import annotations

from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.gui.qt import QtCore


class Worker(QtCore.QThread):
    """Solves one request. After `finished`, either `design` or `error` is set."""

    progressed = QtCore.Signal(float, str)

    def __init__(self, request, parent=None):
        super().__init__(parent)
        self.request = request
        self.design = None
        self.error: BalloonError | None = None
        self._stop = False

    def run(self):
        try:
            self.design = self.request.solve(self._report)
        except BalloonError as error:
            self.error = error

    def stop(self):
        """Ask the engine to stop at its next step."""
        self._stop = True

    def _report(self, fraction: float, text: str) -> bool:
        self.progressed.emit(fraction, text)
        return not self._stop

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Works of which only the newest is wanted: a later one stops the one before."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from BalloonWorkbench.gui.long_work.worker import Worker


class LatestWork:
    """One work at a time; `answered` is called with the worker of the newest one, when it has ended."""

    def __init__(self, answered: Callable[[Worker], None]):
        self._answered = answered
        self._worker: Worker | None = None

    def ask(self, request) -> None:
        """Begin; nobody waits any longer for what was asked before."""
        self.leave()
        worker = self._worker = Worker(request)
        worker.ended.connect(partial(self._ended, worker))
        worker.start()

    def leave(self) -> None:
        """Nobody waits for an answer any more: the work ends at its next step."""
        if self._worker is not None:
            self._worker.stop()
        self._worker = None

    def _ended(self, worker: Worker) -> None:
        worker.deleteLater()
        worker.fault()
        if worker is self._worker:
            self._worker = None
            self._answered(worker)

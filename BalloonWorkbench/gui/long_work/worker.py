# SPDX-License-Identifier: LGPL-2.1-or-later
"""The engine in a thread of its own; it sees arrays only, the document stays with the main thread."""

from __future__ import annotations

import gc
import sys
import time
from collections import deque

from BalloonWorkbench.app.border import hooks
from BalloonWorkbench.core import faults
from BalloonWorkbench.core.errors import BalloonError, ProgramFault
from BalloonWorkbench.gui.long_work.status_progress import StatusProgress
from BalloonWorkbench.gui.qt import QtCore

_TURN = 0.001  # s that a thread may keep the interpreter while another one wants it; Python's own are 0.005
_LOOK = 10  # ms between two looks at what a worker has told


class _Sharing:
    """How the window and the workers share Python.

    The window gets its turn sooner: it asks for it many times for each event. And the garbage collector
    waits. It would run in any thread, and what it finds may be timers and widgets: the program ends when
    another thread than their own deletes them.
    """

    def __init__(self):
        self._running: list[Worker] = []  # kept until they have ended, whatever becomes of who asked
        self._usual_turn = sys.getswitchinterval()

    def begin(self, worker: Worker) -> None:
        self._running.append(worker)
        gc.disable()
        sys.setswitchinterval(_TURN)

    def end(self, worker: Worker) -> None:
        self._running.remove(worker)
        if not self._running:
            gc.enable()
            sys.setswitchinterval(self._usual_turn)


_sharing = _Sharing()


class Worker(QtCore.QThread):
    """Solves one request. After `ended`, either `design` or `error` is set.

    before  carries what a request has to show before its end
    work   seconds of the processor that it took in its own thread
    title  of the work for the status bar, where it can be stopped; without one it is not shown there

    The thread leaves Qt alone, and the window looks at what it has told: PySide 2 looks up the sender of a
    signal unprotected, and the program may end when that is in another thread than the window's. So Qt's own
    `finished`, which comes from there, is nothing to listen to.
    """

    progressed = QtCore.Signal(float, str)
    before = QtCore.Signal(object)
    ended = QtCore.Signal()

    def __init__(self, request, parent=None, title: str = ""):
        super().__init__(parent)
        # without a name the new thread asks PySide for one, unprotected, and the program may end
        self.setObjectName("Balloon worker")
        self.request = request
        self.design = None
        self.error: BalloonError | None = None
        self.work = 0.0
        self._stop = False
        self._messages: deque[tuple[str, tuple]] = deque()  # signals and what they carry
        self._watch = QtCore.QTimer(self)
        self._watch.timeout.connect(self._look)
        self._title = title
        self.status: StatusProgress | None = None

    def start(self, *priority):
        """Begin; call it in the main thread."""
        _sharing.begin(self)
        if self._title:
            self.status = StatusProgress(self._title, self.stop)
            self.progressed.connect(self.status.show_part)
        self._watch.start(_LOOK)
        super().start(*priority)

    def run(self):
        begun = time.thread_time()
        try:
            self.design = self.request.solve(self._report)
        except BaseException as error:  # noqa: BLE001 - Qt would end the thread with Python locked
            self.error = faults.as_balloon_error(error, f"at work on {type(self.request).__name__}")
        finally:
            self.work = time.thread_time() - begun

    def fault(self) -> str:
        """The sentence on a fault, which goes into the report view as well: a newer answer may hide it; else
        empty. Call it in the main thread."""
        if not isinstance(self.error, ProgramFault):
            return ""
        hooks.report(self.error)
        return str(self.error)

    def stop(self):
        """Ask the engine to stop at its next step."""
        self._stop = True

    def abandon(self):
        """Nobody wants its answer any more: wait for the engine's next step, tell nothing, and be gone."""
        self.stop()
        self.wait()
        self._end()
        self.deleteLater()

    def show_before(self, state) -> None:
        """What a request has to show before its end; in the worker's thread."""
        self._messages.append(("before", (state,)))

    def _report(self, fraction: float, text: str) -> bool:
        self._messages.append(("progressed", (fraction, text)))
        return not self._stop

    def _look(self) -> None:
        is_over = self.isFinished()  # before the rest is read: nothing is left behind
        while self._messages:
            signal, values = self._messages.popleft()
            getattr(self, signal).emit(*values)
        if is_over and self._end():
            self.ended.emit()

    def _end(self) -> bool:
        """Leave it; False where that was done before."""
        if not self._watch.isActive():
            return False
        self._watch.stop()
        self._messages.clear()
        if self.status is not None:
            self.status.close()
        _sharing.end(self)
        return True

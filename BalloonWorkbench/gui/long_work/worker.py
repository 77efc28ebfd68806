# SPDX-License-Identifier: LGPL-2.1-or-later
"""The engine in a thread of its own; it sees arrays only, the document stays with the main thread."""

from __future__ import annotations

import gc
import sys
import time

from BalloonWorkbench.app.border import hooks
from BalloonWorkbench.core import faults
from BalloonWorkbench.core.errors import BalloonError, ProgramFault
from BalloonWorkbench.gui.long_work.status_progress import StatusProgress
from BalloonWorkbench.gui.qt import QtCore

_TURN = 0.001  # s that a thread may keep the interpreter while another one wants it; Python's own are 0.005


class _Sharing(QtCore.QObject):
    """How the window and the workers share Python.

    The window gets its turn sooner: it asks for it many times for each event. And the garbage collector
    waits. It would run in any thread, and what it finds may be timers and widgets: the program ends when
    another thread than their own deletes them.
    """

    ended = QtCore.Signal()

    def __init__(self):
        super().__init__()
        self._running = 0
        self._usual_turn = sys.getswitchinterval()
        self.ended.connect(self._one_less)

    def one_more(self):
        self._running += 1
        gc.disable()
        sys.setswitchinterval(_TURN)

    def _one_less(self):
        self._running -= 1
        if not self._running:
            gc.enable()
            sys.setswitchinterval(self._usual_turn)


_sharing = _Sharing()


class Worker(QtCore.QThread):
    """Solves one request. After `finished`, either `design` or `error` is set.

    before  carries what a request has to show before its end
    work   seconds of the processor that it took in its own thread
    title  of the work for the status bar, where it can be stopped; without one it is not shown there
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
        self._title = title
        self.status: StatusProgress | None = None

    def start(self, *priority):
        """Begin; call it in the main thread."""
        _sharing.one_more()
        if self._title:
            self.status = StatusProgress(self._title, self.stop)
            self.progressed.connect(self.status.show_part)
            self.ended.connect(self.status.close)
        super().start(*priority)

    def run(self):
        begun = time.thread_time()
        try:
            self.design = self.request.solve(self._report)
        except BaseException as error:  # noqa: BLE001 - Qt would end the thread with Python locked
            self.error = faults.as_balloon_error(error, f"at work on {type(self.request).__name__}")
        finally:
            self.work = time.thread_time() - begun
            self.ended.emit()
            _sharing.ended.emit()

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

    def _report(self, fraction: float, text: str) -> bool:
        self.progressed.emit(fraction, text)
        return not self._stop

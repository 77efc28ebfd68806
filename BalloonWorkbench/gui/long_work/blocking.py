# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long work inside a recompute: a thread does it, the status bar tells how far it is, Esc stops it, and the
window stays alive. The document is not touched before the work is done, and then by the main thread."""

from __future__ import annotations

from BalloonWorkbench.gui.long_work.worker import Worker
from BalloonWorkbench.gui.qt import QtCore, QtWidgets

_USER_INPUT = frozenset(
    (
        QtCore.QEvent.KeyPress,
        QtCore.QEvent.KeyRelease,
        QtCore.QEvent.Shortcut,
        QtCore.QEvent.ShortcutOverride,
        QtCore.QEvent.MouseButtonPress,
        QtCore.QEvent.MouseButtonRelease,
        QtCore.QEvent.MouseButtonDblClick,
        QtCore.QEvent.Wheel,
        QtCore.QEvent.ContextMenu,
        QtCore.QEvent.Close,
    )
)


class _Job:
    """A function of a progress callback, as a worker wants it; its answer may be None."""

    def __init__(self, job):
        self._job = job

    def solve(self, progress):
        return (self._job(progress),)


class _Guard(QtCore.QObject):
    """Keeps the user's input away from a document that is being recomputed."""

    def eventFilter(self, watched, event):
        if event.type() not in _USER_INPUT:
            return False
        if event.type() == QtCore.QEvent.Close:
            event.ignore()
        return True


def run_blocking(title: str, job):
    """What job(progress) returns; it runs in a thread and must not touch the document.

    Raises the job's BalloonError, Cancelled after Esc.
    """
    application = QtWidgets.QApplication.instance()
    worker = Worker(_Job(job), title=title)
    loop = QtCore.QEventLoop()
    worker.ended.connect(loop.quit)
    worker.start()
    guard = _Guard()
    application.installEventFilter(guard)
    application.installEventFilter(worker.status)  # the last one is asked first: Esc and its button
    try:
        (loop.exec if hasattr(loop, "exec") else loop.exec_)()
    finally:
        application.removeEventFilter(guard)
        worker.wait()
    if worker.error is not None:
        raise worker.error
    return worker.design[0]


def breathe() -> None:
    """Let the window answer while the document is filled; nobody may change it meanwhile."""
    QtWidgets.QApplication.processEvents(QtCore.QEventLoop.ExcludeUserInputEvents)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long work inside a recompute: the status bar tells how far it is, Esc stops it, the window stays alive."""

from __future__ import annotations

import time
from contextlib import contextmanager

import FreeCADGui as Gui

from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate

_INTERVAL = 0.05  # s between looks at the event queue: Esc answers within a tenth of a second
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


class _Guard(QtCore.QObject):
    """Keeps the user's input away from a document that is being recomputed; remembers Esc."""

    def __init__(self):
        super().__init__()
        self.stopped = False

    def eventFilter(self, watched, event):
        if event.type() not in _USER_INPUT:
            return False
        if event.type() == QtCore.QEvent.KeyPress and event.key() == QtCore.Qt.Key_Escape:
            self.stopped = True
        if event.type() == QtCore.QEvent.Close:
            event.ignore()
        return True


@contextmanager
def progress(title: str):
    """Yield a progress callback that keeps the window alive; it returns False after Esc."""
    application = QtWidgets.QApplication.instance()
    bar = QtWidgets.QProgressBar()
    bar.setMaximumWidth(240)
    status_bar = Gui.getMainWindow().statusBar()
    status_bar.addPermanentWidget(bar)
    guard = _Guard()
    looked = time.monotonic()

    def report(fraction: float, text: str) -> bool:
        nonlocal looked
        if time.monotonic() - looked >= _INTERVAL:
            bar.setValue(round(100 * fraction))
            status_bar.showMessage(translate("{}: {}. Esc stops.").format(title, text))
            application.processEvents()
            looked = time.monotonic()
        return not guard.stopped

    application.installEventFilter(guard)
    try:
        yield report
    finally:
        application.removeEventFilter(guard)
        status_bar.removeWidget(bar)
        bar.deleteLater()
        status_bar.clearMessage()

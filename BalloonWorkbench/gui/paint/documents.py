# SPDX-License-Identifier: LGPL-2.1-or-later
"""Paint windows and documents: a window belongs to the document that it paints for, and goes with it."""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui

from BalloonWorkbench.app.border.guard import Guarded
from BalloonWorkbench.gui.qt import QtCore

_watching: list[_DocumentFollower] = []


class _DocumentFollower(Guarded):
    """Told by FreeCAD which document is in front; the windows follow a moment later."""

    def __init__(self, windows: list):
        self._windows = windows
        self._soon = QtCore.QTimer()
        self._soon.setSingleShot(True)
        self._soon.timeout.connect(self.follow)

    def slotActivateDocument(self, _document) -> None:
        self._soon.start(0)

    def follow(self) -> None:
        """Put aside the window of another document, and bring back the one that waits for this one."""
        active = App.ActiveDocument
        if active is None:
            return
        for window in list(self._windows):
            if window.isVisible() and not window.belongs_to(active):
                window.put_aside()
        if Gui.Control.activeDialog() or any(window.isVisible() for window in self._windows):
            return
        for window in self._windows:
            if window.is_aside and window.belongs_to(active):
                window.reveal()
                return


def follow_documents(windows: list) -> None:
    """From now on the windows of this list come and go with their documents."""
    if not _watching:
        _watching.append(_DocumentFollower(windows))
        App.addDocumentObserver(_watching[0])

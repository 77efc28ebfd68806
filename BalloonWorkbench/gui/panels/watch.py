# SPDX-License-Identifier: LGPL-2.1-or-later
"""Notices when the objects of an open panel go away: undo, deletion, a closed document."""

from __future__ import annotations

import FreeCAD as App

from BalloonWorkbench.gui.qt import QtCore


class Watch:
    """Calls `gone` once, after FreeCAD is done, when one of the objects or their document disappears."""

    def __init__(self, objects, gone):
        self._document = objects[0].Document.Name
        self._names = {obj.Name for obj in objects}
        self._gone = gone
        self._active = True
        App.addDocumentObserver(self)

    def remove(self) -> None:
        if self._active:
            self._active = False
            App.removeDocumentObserver(self)

    def slotDeletedObject(self, obj):
        if obj.Document.Name == self._document and obj.Name in self._names:
            self._report()

    def slotDeletedDocument(self, doc):
        if doc.Name == self._document:
            self._report()

    def _report(self):
        if self._active:
            self._active = False
            QtCore.QTimer.singleShot(0, self._leave)

    def _leave(self):
        App.removeDocumentObserver(self)
        self._gone()

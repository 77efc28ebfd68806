# SPDX-License-Identifier: LGPL-2.1-or-later
"""Notices when the objects of an open panel go away: undo, deletion, a closed document."""

from __future__ import annotations

import FreeCAD as App

from BalloonWorkbench.app.border.guard import Guarded


class Watch(Guarded):
    """Calls `gone` once, while the objects still exist: fields that outlive them would end the program."""

    def __init__(self, objects, gone, document=None):
        self._document = (document or objects[0].Document).Name
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
        self.remove()
        self._gone()

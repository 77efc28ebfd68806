# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the panels of artwork and film have in common: one object, one undo step."""

from __future__ import annotations

import FreeCADGui as Gui

from BalloonWorkbench.gui.panels.widgets.fields import Fields
from BalloonWorkbench.gui.panels.widgets.watch import Watch
from BalloonWorkbench.gui.qt import QtGui, QtWidgets, icon
from BalloonWorkbench.gui.window.borders import TaskPanel


class ObjectPanel(TaskPanel):
    """Edits an object inside an undo step that is open: OK keeps it, Cancel takes it back."""

    def __init__(self, obj, name: str, title: str, drawing: str):
        self.obj = obj
        self.doc = obj.Document
        self.is_open = True
        self.form = QtWidgets.QWidget()
        self.form.setObjectName(name)
        self.form.setWindowTitle(title)
        self.form.setWindowIcon(QtGui.QIcon(icon(drawing)))
        self.fields = Fields(obj, self.form)
        self.watch = Watch([obj], self.abandon)

    def keep(self) -> None:
        """OK: close and end the undo step."""
        self.abandon()
        self.doc.commitTransaction()

    def reject(self):
        self.abandon()
        self.doc.abortTransaction()
        self.doc.recompute()
        return True

    def abandon(self) -> None:
        """Close without touching the document."""
        self.is_open = False
        self.watch.remove()
        self.fields.release()
        Gui.Control.closeDialog()

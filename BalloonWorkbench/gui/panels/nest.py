# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of a sheet of film: which balloons, how many, on what film, and how much of it they take."""

from __future__ import annotations

import FreeCADGui as Gui

from BalloonWorkbench.app import film_sheet, status, values
from BalloonWorkbench.app.parts import patterns
from BalloonWorkbench.gui import record
from BalloonWorkbench.gui.panels.fields import Fields
from BalloonWorkbench.gui.panels.watch import Watch
from BalloonWorkbench.gui.qt import QtCore, QtGui, QtWidgets, icon, translate
from BalloonWorkbench.gui.sentences import tell


def show_panel(obj) -> None:
    """Open the panel on a sheet of film, in one undo step."""
    obj.Document.openTransaction(translate("Edit film"))
    Gui.Control.showDialog(NestPanel(obj))


class NestPanel:
    """Edits a sheet of film inside an undo step that is open: OK keeps it, Cancel takes it back."""

    def __init__(self, obj):
        self.obj = obj
        self.doc = obj.Document
        self.is_new = not obj.LaidOutFor
        self.form = QtWidgets.QWidget()
        self.form.setObjectName("NestPanel")
        self.form.setWindowTitle(translate("Lay out on film"))
        self.form.setWindowIcon(QtGui.QIcon(icon("nest")))
        self.fields = Fields(obj, self.form)
        self.choice = QtWidgets.QListWidget()
        self.choice.setObjectName("NestPatterns")
        self.choice.setMaximumHeight(90)
        for pattern in patterns(self.doc):
            entry = QtWidgets.QListWidgetItem(_name(pattern))
            entry.setData(QtCore.Qt.UserRole, pattern.Name)
            taken = pattern in obj.Patterns
            entry.setCheckState(QtCore.Qt.Checked if taken else QtCore.Qt.Unchecked)
            self.choice.addItem(entry)
        self.balloons = self._count("Balloons", 100)
        self.shown = self._count("Shown", 100)
        self.apply = QtWidgets.QPushButton(translate("Lay out"))
        self.apply.setObjectName("LayOut")
        self.apply.setToolTip(translate("Look for the closest layout; Esc takes the best one so far"))
        self.result = QtWidgets.QLabel()
        self.result.setObjectName("NestResult")
        self.result.setWordWrap(True)
        self.message = QtWidgets.QLabel()
        self.message.setObjectName("NestMessage")
        self.message.setWordWrap(True)
        form = QtWidgets.QFormLayout(self.form)
        form.setRowWrapPolicy(QtWidgets.QFormLayout.WrapLongRows)
        form.addRow(translate("Patterns"), self.choice)
        form.addRow(translate("Balloons of each"), self.balloons)
        form.addRow(translate("Film width"), self.fields.quantity("FilmWidth", "mm", 10.0))
        form.addRow(translate("Sheet length"), self.fields.quantity("FilmLength", "mm", 10.0))
        form.addRow(translate("Spacing"), self.fields.quantity("Spacing", "mm"))
        form.addRow(translate("Grain lies"), self.fields.choice("Grain"))
        form.addRow(translate("Shown sheet"), self.shown)
        form.addRow(self.apply)
        form.addRow(translate("Used"), self.result)
        form.addRow(self.message)
        self.shown.valueChanged.connect(lambda _value: self.lay_out() if obj.LaidOutFor else None)
        self.apply.clicked.connect(lambda _checked=False: self.lay_out())
        self.watch = Watch([obj], self.abandon)
        self.show_state()

    def _count(self, name: str, most: int):
        """A spin box for a whole number."""
        box = QtWidgets.QSpinBox()
        box.setObjectName(name)
        box.setRange(1, most)
        box.setKeyboardTracking(False)
        box.setToolTip(translate(self.obj.getDocumentationOfProperty(name), "App::Property"))
        box.setValue(getattr(self.obj, name))
        return box

    def take(self) -> None:
        """The values of the panel, into the object."""
        self.fields.finish_typing()
        names = [
            self.choice.item(row).data(QtCore.Qt.UserRole)
            for row in range(self.choice.count())
            if self.choice.item(row).checkState() == QtCore.Qt.Checked
        ]
        self.obj.Patterns = [self.doc.getObject(name) for name in names]
        self.obj.Balloons, self.obj.Shown = self.balloons.value(), self.shown.value()

    def lay_out(self) -> None:
        """Bring the layout up to date."""
        self.take()
        self.apply.setEnabled(False)
        self.obj.recompute()
        if self.obj is None:  # the panel was closed meanwhile
            return
        self.apply.setEnabled(True)
        self.show_state()
        Gui.SendMsgToActiveView("ViewFit")

    def show_state(self) -> None:
        """What the object says."""
        self.fields.refresh()
        obj, told = self.obj, ""
        if obj.LaidOutFor:
            told = translate("{} pieces on {:.0f} x {:.0f} mm, {:.0f} % used").format(
                obj.Pieces, obj.UsedLength.Value, obj.FilmWidth.Value, obj.Used
            )
            if obj.Sheets > 1:
                told += "\n" + translate("Sheet {} of {}").format(obj.Shown, obj.Sheets)
        self.result.setText(told)
        problem = status.problem(obj) if obj.Status else ""
        self.message.setText("\n".join(tell(text) for text in [problem, *obj.Warnings] if text))

    def accept(self):
        self.take()
        self.obj.recompute()
        if not status.is_ready(self.obj):
            self.show_state()
            return False
        self.abandon()
        self.doc.commitTransaction()
        told = values.texts_of(self.obj, film_sheet.PROPERTIES)
        if not self.is_new:
            told["sheet"] = record.obj(self.obj)
        names = ", ".join(map(record.obj, self.obj.Patterns))
        record.call("nest", f"[{names}]", result=self.obj, name="sheet", **told)
        return True

    def reject(self):
        self.abandon()
        self.doc.abortTransaction()
        self.doc.recompute()
        return True

    def abandon(self) -> None:
        """Close without touching the document."""
        self.watch.remove()
        self.fields.release()
        Gui.Control.closeDialog()


def _name(pattern) -> str:
    group = pattern.getParentGroup()
    return f"{group.Label}: {pattern.Label}" if group else pattern.Label

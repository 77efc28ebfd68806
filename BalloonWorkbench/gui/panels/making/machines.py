# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of the user's own machines: copied from one that is there, named, set, deleted."""

from __future__ import annotations

from dataclasses import dataclass, field

import FreeCADGui as Gui

from BalloonWorkbench.app.properties import preferences
from BalloonWorkbench.core.errors import BalloonError, InputError
from BalloonWorkbench.core.files.data_file import read_data
from BalloonWorkbench.core.machines.machine import machines, own_machines
from BalloonWorkbench.core.machines.own.entries import BED, bed_data
from BalloonWorkbench.core.machines.own.keep import (
    copied,
    delete_machine,
    free_title,
    keep_machines,
    machine_data,
)
from BalloonWorkbench.gui.panels.making.machine_form import MachineForm
from BalloonWorkbench.gui.panels.widgets.narrow import Message, NarrowCombo, WrappedLabel
from BalloonWorkbench.gui.qt import QtGui, QtWidgets, icon, translate
from BalloonWorkbench.gui.window.borders import TaskPanel
from BalloonWorkbench.gui.window.sentences import translated
from BalloonWorkbench.gui.wrapped_check import WrappedCheck


@dataclass(eq=False)
class _Draft:
    """A machine in the list.

    name     of its file; "" of one that has none yet
    title    as it is listed
    own      it is the user's, and can be changed
    data     what its file has; changed: it is to be written
    problem  why its file is of no use
    """

    name: str
    title: str
    own: bool
    data: dict = field(default_factory=dict)
    changed: bool = False
    problem: str = ""


class MachinesPanel(TaskPanel):
    """Edits machines: OK keeps all changes, Cancel none; only deleting is at once."""

    def __init__(self):
        self.form = QtWidgets.QWidget()
        self.form.setObjectName("MachinesPanel")
        self.form.setWindowTitle(translate("My machines"))
        self.form.setWindowIcon(QtGui.QIcon(icon("machines")))
        self.drafts = _drafts()
        self.preferred = self._known(preferences.get("Machine"))
        self.choice = NarrowCombo()
        self.choice.setObjectName("MachineChoice")
        self.choice.setAccessibleName(translate("Machine"))
        self.note, self.message, self.question = WrappedLabel(), Message("Message"), WrappedLabel()
        self.note.setObjectName("MachineNote")
        self.values = MachineForm()
        self.begins = WrappedCheck(translate("Export begins with it"))
        self.begins.setObjectName("ExportBegins")
        self.begins.setToolTip(translate("Export pattern begins with this machine; it is a preference"))
        column = QtWidgets.QVBoxLayout(self.form)
        column.addWidget(self.choice)
        column.addLayout(self._buttons())
        for widget in (self._asking(), self.message, self.note, self.values, self.begins):
            column.addWidget(widget)
        column.addStretch(1)
        self.choice.activated.connect(lambda _index: self._turn())
        self.values.edited.connect(self._edited)
        self.values.refused.connect(self.message.setText)
        self.begins.clicked.connect(self._prefer)
        self._list(self.drafts[0])

    def _known(self, name: str) -> _Draft:
        """The machine of a name that is known."""
        return next(each for each in self.drafts if each.name == name and not each.problem)

    def _buttons(self):
        copy, self.delete = (QtWidgets.QPushButton(text) for text in (translate("Copy"), translate("Delete")))
        copy.setObjectName("CopyMachine")
        copy.setToolTip(translate("Make a machine of your own with the values of this one"))
        self.delete.setObjectName("DeleteMachine")
        copy.clicked.connect(lambda _checked=False: self._copy())
        self.delete.clicked.connect(lambda _checked=False: self._ask())
        row = QtWidgets.QHBoxLayout()
        row.addWidget(copy)
        row.addWidget(self.delete)
        return row

    def _asking(self):
        """What is asked before a machine goes."""
        self.asking = QtWidgets.QWidget()
        yes, no = (QtWidgets.QPushButton(text) for text in (translate("Delete it"), translate("Keep it")))
        yes.setObjectName("DeleteSurely")
        no.setObjectName("DeleteNot")
        yes.clicked.connect(lambda _checked=False: self._delete())
        no.clicked.connect(lambda _checked=False: self.asking.hide())
        row = QtWidgets.QHBoxLayout()
        row.addWidget(yes)
        row.addWidget(no)
        column = QtWidgets.QVBoxLayout(self.asking)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.question)
        column.addLayout(row)
        return self.asking

    def _list(self, shown: _Draft) -> None:
        """List all machines, the user's own first, and show one of them."""
        self.choice.clear()
        for draft in self.drafts:
            title = draft.title if draft.own else translated(draft.title)
            self.choice.addItem(translate("{} (unusable)").format(title) if draft.problem else title)
        self.choice.setCurrentIndex(self.drafts.index(shown))
        self._show(shown)

    def _show(self, shown: _Draft) -> None:
        self._shown = shown
        self.asking.hide()
        self.message.setText(translated(shown.problem))
        self.delete.setEnabled(shown.own)
        self.values.setVisible(bool(shown.data))
        if shown.data:
            self.values.show_data(shown.data)
        self.note.setVisible(not shown.own)
        if not shown.own:
            sentence = translate("It came with the workbench: copy it to set it up as your own.")
            self.note.setText(f"{translated(machines()[shown.name].note)}\n\n{sentence}")
        self.begins.setVisible(not shown.problem)
        self.begins.setChecked(shown is self.preferred)

    def _turn(self) -> None:
        """Show the chosen machine, unless what was typed cannot be left like that."""
        refusal = self._finish_typing()
        if refusal:
            self.choice.setCurrentIndex(self.drafts.index(self._shown))
            self.message.setText(refusal)
        else:
            self._show(self.drafts[self.choice.currentIndex()])

    def _finish_typing(self) -> str:
        return self.values.finish_typing() if self._shown.data else ""

    def _edited(self) -> None:
        shown = self._shown
        shown.data, shown.changed = self.values.data, True
        shown.title = shown.data["title"]
        self.choice.setItemText(self.choice.currentIndex(), shown.title)

    def _prefer(self, chosen: bool) -> None:
        usual = preferences.items()["Machine"].default
        self.preferred = self._shown if chosen else self._known(usual)
        self.begins.setChecked(self._shown is self.preferred)

    def _copy(self) -> None:
        refusal = self._finish_typing()
        if refusal or self._shown.problem:
            self.message.setText(refusal or translated(self._shown.problem))
            return
        shown = self._shown
        try:
            data = shown.data or machine_data(shown.name)
            title = shown.title if shown.own else translate("My {}").format(translated(shown.title))
            taken = [each.data["name"] for each in self.drafts if each.data]
            data = copied(data, free_title(title, taken))
        except BalloonError as error:
            self.message.setText(translated(str(error)))
            return
        self.drafts.insert(0, _Draft("", data["title"], True, data, changed=True))
        self._list(self.drafts[0])
        self.values.begin()

    def _ask(self) -> None:
        sentence = translate("Delete {}? Its file goes for good.")
        self.question.setText(sentence.format(self._shown.title))
        self.asking.show()

    def _delete(self) -> None:
        shown = self._shown
        try:
            if shown.name:
                delete_machine(shown.name)
                preferences.forget_bed(shown.name)
        except BalloonError as error:
            self.asking.hide()
            self.message.setText(translated(str(error)))
            return
        at = self.drafts.index(shown)
        self.drafts.remove(shown)
        if shown is self.preferred:
            self.preferred = self._known(preferences.items()["Machine"].default)
        self._list(self.drafts[min(at, len(self.drafts) - 1)])

    def accept(self):
        """Write what has changed; the panel stays with the reason when that fails."""
        refusal = self._finish_typing()
        if refusal:
            self.message.setText(refusal)
            return False
        changed = [each for each in self.drafts if each.changed]
        try:
            if changed:
                keep_machines([(each.name, each.data) for each in changed])
        except BalloonError as error:
            self.message.setText(translated(str(error)))
            return False
        for each in changed:
            for name in (each.name, each.data["name"]):
                preferences.forget_bed(name)
        preferences.put("Machine", self.preferred.data.get("name", self.preferred.name))
        self.close()
        if changed:
            titles = ", ".join(each.title for each in changed)
            sentence = translate("Kept, and offered by Export pattern: {}").format(titles)
            Gui.getMainWindow().statusBar().showMessage(sentence, 8000)
        return True

    def reject(self):
        self.close()
        return True

    def close(self) -> None:
        Gui.Control.closeDialog()


def _drafts() -> list[_Draft]:
    """The user's machines by their titles, then those that came with the workbench."""
    own, known = [], machines()
    for path, described in own_machines().items():
        if isinstance(described, InputError):
            own.append(_Draft(path.stem, path.stem, True, problem=str(described)))
            continue
        data, bed = dict(read_data(path)), preferences.bed(described)
        if bed != described.bed:  # another one was typed in the export panel
            data[BED] = bed_data(bed)
        own.append(_Draft(path.stem, described.title, True, data))
    names = {draft.name for draft in own if not draft.problem}
    return [
        *sorted(own, key=lambda draft: draft.title.lower()),
        *(_Draft(name, each.title, False) for name, each in known.items() if name not in names),
    ]

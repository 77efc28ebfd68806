# SPDX-License-Identifier: LGPL-2.1-or-later
"""The values of a machine's file as a form; which rows there are follows from the machine and its tool."""

from __future__ import annotations

from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.machines.machine import NO_LIMIT, machine_of, parse_bed
from BalloonWorkbench.core.machines.own.entries import (
    BED,
    ENTRIES,
    NOTE,
    TITLE,
    entry_value,
    with_entry,
)
from BalloonWorkbench.core.machines.own.keep import copied
from BalloonWorkbench.core.units import LENGTH_UNITS
from BalloonWorkbench.gui.panels.widgets.fields import ReturnKey
from BalloonWorkbench.gui.panels.widgets.narrow import NarrowCombo, NarrowForm
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate
from BalloonWorkbench.gui.window.sentences import translated
from BalloonWorkbench.gui.window.user_units import bed_size_text, user_unit
from BalloonWorkbench.gui.wrapping import CheckBox

_LEAST = 60  # px
_WIDE = (TITLE.key, BED, NOTE)  # below their names; every machine has them


class MachineForm(QtWidgets.QWidget):
    """Edits `data`, what a machine's file has.

    `edited` follows each change, `refused` carries the sentence on what cannot be taken, empty when it can.
    """

    edited = QtCore.Signal()
    refused = QtCore.Signal(str)

    def __init__(self):
        super().__init__()
        self.setObjectName("MachineForm")
        self.data: dict = {}
        self._refusals: dict[str, str] = {}  # by the key of the entry
        self._fields = {}
        self._form = NarrowForm(self)
        self._form.setContentsMargins(0, 0, 0, 0)
        for entry in (TITLE, *ENTRIES):
            field = self._fields[entry] = self._field(entry)
            field.setObjectName(f"Machine_{entry.key}")
            field.setToolTip(translate(entry.tip))
            if isinstance(field, QtWidgets.QCheckBox):
                self._form.addRow(field)
                continue
            text = translate(entry.label)
            label = QtWidgets.QLabel(f"{text} ({entry.unit})" if entry.unit else text)
            label.setBuddy(field)
            if entry.key in _WIDE:
                self._form.addRow(label)
                self._form.addRow(field)
            else:
                self._form.addRow(label, field)

    def show_data(self, data: dict) -> None:
        """Edit what another machine's file has."""
        self.data = dict(data)
        self._refusals.clear()
        self._show()

    def begin(self) -> None:
        """Let the name be typed first."""
        self._fields[TITLE].setFocus()
        self._fields[TITLE].selectAll()

    def finish_typing(self) -> str:
        """Take what is still being typed; the sentence on what cannot be taken, else empty."""
        for entry, field in self._fields.items():
            if isinstance(field, QtWidgets.QLineEdit):
                self._take_text(entry)
        return next(iter(self._refusals.values()), "")

    def _field(self, entry):
        if entry.titles:
            field = NarrowCombo()
            for value, title in entry.titles.items():
                field.addItem(translated(title), value)
            field.activated.connect(lambda _index: self._take(entry, field.currentData()))
        elif entry.key == "control_bar":
            field = CheckBox(translate(entry.label))
            field.clicked.connect(lambda checked: self._take(entry, checked))
        else:
            field = QtWidgets.QLineEdit()
            field.setMinimumWidth(_LEAST)
            field.editingFinished.connect(lambda: self._take_text(entry))
            ReturnKey(field, lambda: self._take_text(entry))
        return field

    def _take_text(self, entry) -> None:
        field = self._fields[entry]
        if field.isModified() and self.data:
            field.setModified(False)
            self._take(entry, field.text())

    def _take(self, entry, value) -> None:
        try:
            self.data = self._with(entry, value)
        except BalloonError as error:
            self._refusals[entry.key] = translated(str(error))
        else:
            self._refusals.pop(entry.key, None)
            self._show()
            self.edited.emit()
        self.refused.emit(next(iter(self._refusals.values()), ""))

    def _with(self, entry, value) -> dict:
        if entry is TITLE:
            return copied(self.data, value)
        if entry.key == BED:
            text, unit = value.replace(",", ".").strip(), user_unit("mm", 100.0)[1]
            value = parse_bed(text or NO_LIMIT, unit if unit in LENGTH_UNITS else "mm")
        return with_entry(self.data, entry, value)

    def _show(self) -> None:
        for entry, field in self._fields.items():
            applies = entry.applies(self.data)
            self._form.show_widget(field, applies)
            if not applies:
                self._refusals.pop(entry.key, None)
            if not applies or entry.key in self._refusals:
                continue
            value = entry_value(entry, self.data)
            if isinstance(field, QtWidgets.QComboBox):
                field.setCurrentIndex(field.findData(value))
            elif isinstance(field, QtWidgets.QCheckBox):
                field.setChecked(bool(value))
            else:
                field.setText(bed_size_text(machine_of(self.data).bed) if entry.key == BED else value)
                if entry.key == NOTE:  # longer than its line
                    field.setToolTip(f"{translate(entry.tip)}\n\n{value}")
                field.setCursorPosition(0)
                field.setModified(False)

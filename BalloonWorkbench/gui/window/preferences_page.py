# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page of FreeCAD's preferences: what a new balloon begins with, and where its pattern goes."""

from __future__ import annotations

from BalloonWorkbench.app.border.guard import Guarded
from BalloonWorkbench.app.properties import preferences
from BalloonWorkbench.gui.accessible import name_field, sign_button
from BalloonWorkbench.gui.panels.widgets.fields import UNITS, new_quantity_box
from BalloonWorkbench.gui.qt import QtWidgets, translate
from BalloonWorkbench.gui.window.sentences import translated
from BalloonWorkbench.gui.wrapped_check import WrappedCheck


class PreferencesPage(Guarded):
    """FreeCAD makes one for each opening of the dialog, and asks it to load and to save."""

    def __init__(self, _parent=None):
        self.form = QtWidgets.QWidget()
        self.form.setObjectName("BalloonPreferences")
        self.form.setWindowTitle(translate("Balloons"))
        column = QtWidgets.QVBoxLayout(self.form)
        for title, rows in self._rows().items():
            group = QtWidgets.QGroupBox(title)
            lines = QtWidgets.QFormLayout(group)
            for key, label in rows:
                field = self._field(key, label)
                lines.addRow("" if isinstance(field, QtWidgets.QCheckBox) else label, self._row(key, field))
            column.addWidget(group)
        column.addStretch(1)

    def loadSettings(self) -> None:
        """Show what is kept."""
        for key, field in self._fields():
            value = preferences.get(key)
            if isinstance(field, QtWidgets.QComboBox):
                field.setCurrentIndex(field.findData(value))
            elif isinstance(field, QtWidgets.QCheckBox):
                field.setChecked(value)
            elif isinstance(field, QtWidgets.QLineEdit):
                field.setText(value)
            else:
                field.setProperty("rawValue", value)

    def saveSettings(self) -> None:
        """Keep what is shown."""
        for key, field in self._fields():
            if isinstance(field, QtWidgets.QComboBox):
                preferences.put(key, field.currentData())
            elif isinstance(field, QtWidgets.QCheckBox):
                preferences.put(key, field.isChecked())
            elif isinstance(field, QtWidgets.QLineEdit):
                preferences.put(key, field.text().strip())
            else:
                preferences.put(key, float(field.property("rawValue")))

    def _fields(self):
        """Keys and fields; they are not held, see new_box."""
        for key in preferences.items():
            yield key, self.form.findChild(QtWidgets.QWidget, f"Preferred{key}")

    def _rows(self) -> dict[str, list[tuple[str, str]]]:
        known = [item.prop for item in preferences.items().values() if item.prop]
        fine = [(prop.name, translate(prop.preference)) for prop in known if prop.page == "Solver"]
        general = [(prop.name, translate(prop.preference)) for prop in known if prop.page != "Solver"]
        return {
            translate("New balloons"): general,
            translate("Simulation"): [
                *fine,
                ("OfferSolver", translate("Offer the native solver where it is missing")),
            ],
            translate("Export"): [
                ("ExportFolder", translate("Folder")),
                ("Machine", translate("Machine")),
            ],
        }

    def _field(self, key: str, label: str):
        item = preferences.items()[key]
        if item.prop and item.prop.type in UNITS:
            field = new_quantity_box()
            field.setProperty("unit", UNITS[item.prop.type][0])
            field.setProperty("minimum", 0.0)
        elif preferences.choices(key):
            field = QtWidgets.QComboBox()
            for choice in preferences.choices(key):
                field.addItem(_title(key, choice), choice)
        elif isinstance(item.default, bool):
            field = WrappedCheck(label)
        else:
            field = QtWidgets.QLineEdit()
            field.setPlaceholderText(translate("Beside the document"))
        field.setObjectName(f"Preferred{key}")
        name_field(field, label)
        if item.prop:
            field.setToolTip(translate(item.prop.tooltip, "App::Property"))
        return field

    def _row(self, key: str, field):
        """The field, with a button where a folder is to be chosen."""
        if key != "ExportFolder":
            return field
        row = QtWidgets.QHBoxLayout()
        browse = sign_button("…", translate("Choose a folder"))
        browse.clicked.connect(lambda _checked=False: self._choose_folder(field))
        row.addWidget(field)
        row.addWidget(browse)
        return row

    def _choose_folder(self, field) -> None:
        path = QtWidgets.QFileDialog.getExistingDirectory(
            self.form, translate("Choose a folder"), field.text()
        )
        if path:
            field.setText(path)


def _title(key: str, choice: str) -> str:
    """What people read for a choice."""
    from BalloonWorkbench.app.properties.film import known_films
    from BalloonWorkbench.core.machines.machine import machines

    if key == "Film":
        return translated(known_films()[choice].title)
    if key == "Machine":
        return translated(machines()[choice].title)
    return translated(choice)

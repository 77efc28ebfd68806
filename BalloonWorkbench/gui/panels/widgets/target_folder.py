# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of a panel about the folder that it writes files into, and what is there already."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from BalloonWorkbench.app.properties import preferences
from BalloonWorkbench.gui.panels.widgets.file_row import FileRow
from BalloonWorkbench.gui.qt import QtWidgets, translate


class TargetFolder(QtWidgets.QWidget):
    """A line for the folder, which is made when it is missing, and a button that chooses one.

    Where files are there already, a box asks whether to replace them.
    """

    def __init__(self, doc, object_name: str, name: str):
        super().__init__()
        self._base = preferences.export_folder(doc)
        self.row = FileRow(object_name, "", translate("Folder for the files"), self._ask)
        self.replace = QtWidgets.QCheckBox(translate("Replace the files"))
        self.replace.setObjectName(f"{object_name}Replace")
        self.replace.hide()
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.row)
        column.addWidget(self.replace)
        self.row.chosen.connect(self._show)
        self.row.path.textEdited.connect(lambda _text: self.replace.setChecked(False))
        number, folder = 2, self._base / name
        while folder.exists():
            number, folder = number + 1, self._base / f"{name}-{number}"
        self._show(str(folder))

    @property
    def path(self) -> Path:
        """The folder."""
        return self._base / Path(self.row.path.text().strip()).expanduser()

    def objection(self, names: Sequence[str]) -> str:
        """What to say instead of writing files: empty where none is there or they may be replaced."""
        there = [name for name in names if (self.path / name).exists()]
        self.replace.setVisible(bool(there))
        if not there or self.replace.isChecked():
            return ""
        return translate('{} is there already: tick "Replace the files", or choose another folder.').format(
            ", ".join(there)
        )

    def _show(self, folder: str) -> None:
        self.row.show_name(folder)
        self.row.path.setToolTip(folder)

    def _ask(self, parent) -> str:
        return QtWidgets.QFileDialog.getExistingDirectory(
            parent, translate("Choose a folder"), str(self._base)
        )

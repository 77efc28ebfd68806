# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of a panel about the folder that it writes files into, and what is there already."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from BalloonWorkbench.app.properties import preferences
from BalloonWorkbench.gui.accessible import sign_button
from BalloonWorkbench.gui.panels.widgets.narrow import ElidedLabel
from BalloonWorkbench.gui.qt import QtWidgets, translate
from BalloonWorkbench.gui.wrapped_check import WrappedCheck


class TargetFolder(QtWidgets.QWidget):
    """A line for the name of the folder, which is made when it is missing; below, the folder that it is in.

    A path may be typed into the line. Where files are there already, a box asks whether to replace them.
    """

    def __init__(self, doc, object_name: str, name: str):
        super().__init__()
        self._in = preferences.export_folder(doc)
        self.line = QtWidgets.QLineEdit()
        self.line.setObjectName(object_name)
        self.line.setMinimumWidth(60)
        browse = sign_button("…", translate("Choose a folder"))
        self.place = ElidedLabel()
        self.replace = WrappedCheck(translate("Replace the files"))
        self.replace.setObjectName(f"{object_name}Replace")
        self.replace.hide()
        below = QtWidgets.QHBoxLayout()
        below.addWidget(self.place)
        below.addWidget(browse)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.line)
        column.addLayout(below)
        column.addWidget(self.replace)
        number, free = 2, name
        while (self._in / free).exists():
            number, free = number + 1, f"{name}-{number}"
        self._take(free)
        self.line.editingFinished.connect(lambda: self._take(self.line.text()))
        self.line.textEdited.connect(lambda _text: self.replace.setChecked(False))
        browse.clicked.connect(lambda _checked=False: self._ask())

    @property
    def path(self) -> Path:
        """The folder."""
        self._take(self.line.text())
        return self._in / self.line.text()

    def objection(self, names: Sequence[str]) -> str:
        """What to say instead of writing files: empty where none is there or they may be replaced."""
        there = [name for name in names if (self.path / name).exists()]
        self.replace.setVisible(bool(there))
        if not there or self.replace.isChecked():
            return ""
        return translate('{} is there already: tick "Replace the files", or choose another folder.').format(
            ", ".join(there)
        )

    def _take(self, text: str) -> None:
        """A path that was typed is a folder, and the one that it is in."""
        folder = self._in / Path(text.strip()).expanduser()
        self._in = folder.parent
        self.line.setText(folder.name)
        self.place.setText(translate("in {}").format(self._in))
        for widget in (self.line, self.place):
            widget.setToolTip(str(folder))

    def _ask(self) -> None:
        path = QtWidgets.QFileDialog.getExistingDirectory(self, translate("Choose a folder"), str(self._in))
        if path:
            self.replace.setChecked(False)
            self._take(path)

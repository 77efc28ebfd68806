# SPDX-License-Identifier: LGPL-2.1-or-later
"""A line with the name of a file, and a button that chooses one."""

from __future__ import annotations

from BalloonWorkbench.gui.accessible import sign_button
from BalloonWorkbench.gui.panels.widgets.fields import ReturnKey
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate


class FileRow(QtWidgets.QWidget):
    """`chosen` carries a path that was typed or chosen.

    ask  asks the user for a file; takes the parent of its window, gives a path or None
    """

    chosen = QtCore.Signal(str)

    def __init__(self, name: str, hint: str, tip: str, ask):
        super().__init__()
        self._ask = ask
        self.path = QtWidgets.QLineEdit()
        self.path.setObjectName(name)
        self.path.setMinimumWidth(60)
        self.path.setPlaceholderText(hint)
        self.path.setToolTip(tip)
        self.path.setAccessibleName(hint)
        browse = sign_button("…", translate("Choose a file"))
        row = QtWidgets.QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(self.path)
        row.addWidget(browse)
        browse.clicked.connect(self._browse)
        self.path.editingFinished.connect(self.take)
        ReturnKey(self.path, self.take)

    def show_name(self, name: str) -> None:
        """The name of the file that is taken."""
        self.path.setText(name)
        self.path.setModified(False)

    def take(self) -> None:
        """What was typed counts."""
        if self.path.isModified() and self.path.text().strip():
            self.path.setModified(False)
            self.chosen.emit(self.path.text().strip())

    def release(self) -> None:
        """The panel closes."""
        self.path.setModified(False)

    def _browse(self) -> None:
        path = self._ask(self)
        if path:
            self.chosen.emit(path)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an object follows, and a button with which another sketch, wire or face is selected."""

from __future__ import annotations

from BalloonWorkbench.gui.panels.widgets.narrow import WrappedLabel
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate
from BalloonWorkbench.gui.window.selection import SelectionWatch, selected_source


class SourceRow(QtWidgets.QWidget):
    """Takes what the user selects as the Source of an object: `picked` follows.

    empty  what it asks for while there is none
    """

    picked = QtCore.Signal()

    def __init__(self, obj, empty: str):
        super().__init__()
        self._obj, self._empty = obj, empty
        self.source = WrappedLabel()
        self.source.setObjectName("Source")
        self.pick = QtWidgets.QPushButton(translate("Select another"))
        self.pick.setObjectName("Pick")
        self.pick.setCheckable(True)
        self.pick.setChecked(not obj.Source)
        self.pick.setToolTip(translate("While this is pressed, what you select becomes the source"))
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.source)
        column.addWidget(self.pick)
        self.pick.toggled.connect(self.refresh)
        self._selection = SelectionWatch(self._selected)

    def refresh(self, _checked: bool = False) -> None:
        """Show what it is."""
        if self._obj.Source:
            source, elements = self._obj.Source
            self.source.setText(" ".join([source.Label, *elements]))
        else:
            self.source.setText(self._empty)

    def release(self) -> None:
        """The panel closes."""
        self._selection.remove()

    def _selected(self) -> None:
        selected = selected_source() if self.pick.isChecked() else None
        if selected is not None:
            self._obj.Source = selected
            self.pick.setChecked(False)
            self.picked.emit()

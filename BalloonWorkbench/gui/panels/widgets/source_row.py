# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an object follows, and a button with which another sketch, wire or face is selected."""

from __future__ import annotations

from BalloonWorkbench.gui.panels.widgets.narrow import WrappedLabel
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate
from BalloonWorkbench.gui.window.selection import SelectionWatch, selected_source
from BalloonWorkbench.gui.wrapping import PushButton


class SourceRow(QtWidgets.QWidget):
    """Takes what the user selects as the source of an object: `picked` follows.

    empty     what it asks for while there is none
    prop      the property that links the source
    selected  what the property would be for the present selection; None for nothing that fits
    """

    picked = QtCore.Signal()

    def __init__(self, obj, empty: str, prop: str = "Source", selected=selected_source):
        super().__init__()
        self._obj, self._empty, self._prop, self._chosen = obj, empty, prop, selected
        self.source = WrappedLabel()
        self.source.setObjectName("Source")
        self.pick = PushButton(translate("Select another"))
        self.pick.setObjectName("Pick")
        self.pick.setCheckable(True)
        self.pick.setChecked(not getattr(obj, prop))
        self.pick.setToolTip(translate("While this is pressed, what you select becomes the source"))
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.source)
        column.addWidget(self.pick)
        self.pick.toggled.connect(self.refresh)
        self._selection = SelectionWatch(self._selected)

    def refresh(self, _checked: bool = False) -> None:
        """Show what it is."""
        linked = getattr(self._obj, self._prop)
        source, elements = linked if isinstance(linked, tuple) else (linked, ())
        self.source.setText(" ".join([source.Label, *elements]) if source else self._empty)

    def release(self) -> None:
        """The panel closes."""
        self._selection.remove()

    def _selected(self) -> None:
        selected = self._chosen() if self.pick.isChecked() else None
        if selected is not None:
            setattr(self._obj, self._prop, selected)
            self.pick.setChecked(False)
            self.picked.emit()

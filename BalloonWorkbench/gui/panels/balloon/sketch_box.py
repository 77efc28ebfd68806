# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of the panel about a linked sketch, wire or face."""

from __future__ import annotations

from BalloonWorkbench.gui.panels.widgets.drawing_preview import Preview, notes_of
from BalloonWorkbench.gui.panels.widgets.fields import Fields
from BalloonWorkbench.gui.panels.widgets.narrow import NarrowForm
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate
from BalloonWorkbench.gui.window.selection import SelectionWatch, selected_source


class SketchBox(QtWidgets.QWidget):
    """Takes what the user selects as the source of an outline. `changed` follows each edit."""

    changed = QtCore.Signal()
    refused = QtCore.Signal(str)

    def __init__(self, outline):
        super().__init__()
        self.outline = outline
        self.source = QtWidgets.QLabel()
        self.source.setObjectName("Source")
        self.source.setWordWrap(True)
        self.pick = QtWidgets.QPushButton(translate("Select another"))
        self.pick.setObjectName("Pick")
        self.pick.setCheckable(True)
        self.pick.setChecked(not outline.Source)
        self.pick.setToolTip(translate("While this is pressed, what you select becomes the source"))
        self.fields = Fields(outline, self)
        symmetry = NarrowForm()
        symmetry.addRow(translate("Symmetry"), self.fields.choice("Symmetry"))
        self.preview = Preview()
        self.notes = QtWidgets.QLabel()
        self.notes.setWordWrap(True)
        column = QtWidgets.QVBoxLayout(self)
        for widget in (self.source, self.pick, self.preview, self.notes):
            column.addWidget(widget)
        column.insertLayout(2, symmetry)
        self.fields.changed.connect(lambda name: self.changed.emit())
        self.pick.toggled.connect(self.refresh)
        self._selection = SelectionWatch(self._selected)

    def finish_typing(self) -> None:
        """There is nothing to type."""

    def refresh(self, _checked: bool = False) -> None:
        self.fields.refresh()
        if self.outline.Source:
            source, elements = self.outline.Source
            self.source.setText(" ".join([source.Label, *elements]))
        else:
            self.source.setText(translate("Select a sketch, a wire or a face in the tree or the 3D view."))
        self.preview.show(self.outline)
        self.notes.setText(notes_of(self.outline))

    def release(self) -> None:
        """Stop listening to the selection; the panel closes."""
        self.fields.release()
        self._selection.remove()

    def _selected(self) -> None:
        found = selected_source() if self.pick.isChecked() else None
        if found is not None:
            self.outline.Source = found
            self.pick.setChecked(False)
            self.changed.emit()

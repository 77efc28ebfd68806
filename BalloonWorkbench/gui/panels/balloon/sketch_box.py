# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of the panel about a linked sketch, wire or face."""

from __future__ import annotations

from BalloonWorkbench.app.properties.property_table import properties_of
from BalloonWorkbench.core.options.drawing import ReadingOptions
from BalloonWorkbench.gui.panels.widgets.drawing_preview import Preview, notes_of
from BalloonWorkbench.gui.panels.widgets.fields import PropertyPage
from BalloonWorkbench.gui.qt import QtWidgets, translate
from BalloonWorkbench.gui.window.selection import SelectionWatch, selected_source


class SketchBox(PropertyPage):
    """Takes what the user selects as the source of an outline."""

    def __init__(self, outline):
        super().__init__(outline)
        self.source = QtWidgets.QLabel()
        self.source.setObjectName("Source")
        self.source.setWordWrap(True)
        self.pick = QtWidgets.QPushButton(translate("Select another"))
        self.pick.setObjectName("Pick")
        self.pick.setCheckable(True)
        self.pick.setChecked(not outline.Source)
        self.pick.setToolTip(translate("While this is pressed, what you select becomes the source"))
        self.preview = Preview()
        self.notes = QtWidgets.QLabel()
        self.notes.setWordWrap(True)
        self.form.addRow(self.source)
        self.form.addRow(self.pick)
        for item in properties_of(ReadingOptions):
            if item.label:
                self.form.add(item)
        self.form.addRow(self.preview)
        self.form.addRow(self.notes)
        self.pick.toggled.connect(self.refresh)
        self._selection = SelectionWatch(self._selected)

    def refresh(self, _checked: bool = False) -> None:
        super().refresh()
        if self.obj.Source:
            source, elements = self.obj.Source
            self.source.setText(" ".join([source.Label, *elements]))
        else:
            self.source.setText(translate("Select a sketch, a wire or a face in the tree or the 3D view."))
        self.preview.show(self.obj)
        self.notes.setText(notes_of(self.obj))

    def release(self) -> None:
        super().release()
        self._selection.remove()

    def _selected(self) -> None:
        selected = selected_source() if self.pick.isChecked() else None
        if selected is not None:
            self.obj.Source = selected
            self.pick.setChecked(False)
            self.changed.emit()

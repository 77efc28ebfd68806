# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of the panel about a linked sketch, wire or face."""

from __future__ import annotations

from BalloonWorkbench.app.properties.property_table import properties_of
from BalloonWorkbench.core.options.drawing import ReadingOptions
from BalloonWorkbench.gui.panels.widgets.drawing_preview import Preview, notes_of
from BalloonWorkbench.gui.panels.widgets.fields import PropertyPage
from BalloonWorkbench.gui.panels.widgets.narrow import WrappedLabel
from BalloonWorkbench.gui.panels.widgets.source_row import SourceRow
from BalloonWorkbench.gui.qt import translate


class SketchBox(PropertyPage):
    """Takes what the user selects as the source of an outline."""

    def __init__(self, outline):
        super().__init__(outline)
        self.source = SourceRow(
            outline, translate("Select a sketch, a wire or a face in the tree or the 3D view.")
        )
        self.preview = Preview()
        self.notes = WrappedLabel()
        self.form.addRow(self.source)
        for item in properties_of(ReadingOptions):
            if item.label:
                self.form.add(item)
        self.form.addRow(self.preview)
        self.form.addRow(self.notes)
        self.source.picked.connect(self.changed)

    def refresh(self) -> None:
        super().refresh()
        self.source.refresh()
        self.preview.show(self.obj)
        self.notes.setText(notes_of(self.obj))

    def release(self) -> None:
        super().release()
        self.source.release()

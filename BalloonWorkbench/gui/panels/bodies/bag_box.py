# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page about a bag: what its panels come from, its seams, where it is filled."""

from __future__ import annotations

from BalloonWorkbench.app.bag import PROPERTIES, set_file, set_panels
from BalloonWorkbench.app.document.parts import parts_of
from BalloonWorkbench.app.properties.ready_bodies import NONE
from BalloonWorkbench.gui.panels.bodies.seam_editor import SeamEditor
from BalloonWorkbench.gui.panels.widgets.file_page import FilePage
from BalloonWorkbench.gui.panels.widgets.file_row import FileRow
from BalloonWorkbench.gui.panels.widgets.narrow import WrappedLabel
from BalloonWorkbench.gui.qt import translate
from BalloonWorkbench.gui.window import file_dialogs
from BalloonWorkbench.gui.window.selection import selected_panels
from BalloonWorkbench.gui.window.sentences import translated
from BalloonWorkbench.gui.wrapping import PushButton

_MOST_PROBLEMS = 3  # of what does not fit: a bag without seams has many free edges


class BagBox(FilePage):
    """Edits a bag."""

    def __init__(self, bag_obj):
        file = FileRow(
            "PanelFile",
            translate("JSON"),
            translate("Panels and seams; a copy of them travels in the document"),
            lambda parent: file_dialogs.ask_for_lines(parent, "json"),
        )
        super().__init__(bag_obj, file, "PanelFile", set_file)
        self.panels, self.notes = WrappedLabel(), WrappedLabel()
        self.panels.setObjectName("PanelSources")
        self.notes.setObjectName("BagNotes")
        self.take = PushButton(translate("Take what is selected"))
        self.take.setObjectName("TakePanels")
        self.take.setToolTip(translate("The selected sketches, wires and flat faces become the panels"))
        parts = parts_of(bag_obj)
        self.seams = SeamEditor(bag_obj, parts.balloon if parts is not None else None)
        form = self.form
        form.addRow(self.panels)
        form.addRow(self.take)
        for item in PROPERTIES:
            if item.label:
                form.add(item)
            if item.name == "Ready":
                form.addRow(self.file)
        form.addRow(self.seams)
        form.addRow(self.notes)
        self.take.clicked.connect(self._take)
        self.seams.changed.connect(self.changed)

    def refresh(self) -> None:
        super().refresh()
        bag_obj = self.obj
        labels = [" ".join([source.Label, *filter(None, faces)]) for source, faces in bag_obj.Panels]
        self.panels.setText(
            ", ".join(labels) or translate("Select sketches or flat faces, or take a ready body or a file.")
        )
        self.file.setVisible(not bag_obj.Panels and bag_obj.Ready == NONE)
        self.seams.refresh()
        remarks = [*bag_obj.Problems[:_MOST_PROBLEMS], *bag_obj.Notes]
        self.notes.setText("\n".join(map(translated, remarks)))
        self.notes.setVisible(bool(remarks))

    def release(self) -> None:
        self.seams.release()
        super().release()

    def _take(self, _checked: bool = False) -> None:
        chosen = selected_panels()
        if not chosen:
            self.refused.emit(translate("Select sketches, wires or flat faces first."))
            return
        set_panels(self.obj, chosen)
        self.changed.emit()

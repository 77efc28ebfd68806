# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page about a closed body: what it comes from, and into how many panels it is divided."""

from __future__ import annotations

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document.parts import parts_of
from BalloonWorkbench.app.properties.quantities import cubic_metres
from BalloonWorkbench.app.target import PROPERTIES, set_body
from BalloonWorkbench.core.units import volume_text
from BalloonWorkbench.gui.panels.bodies.body_seams import BodySeams
from BalloonWorkbench.gui.panels.bodies.panel_curve_box import PanelCurveBox
from BalloonWorkbench.gui.panels.widgets.file_page import FilePage
from BalloonWorkbench.gui.panels.widgets.file_row import FileRow
from BalloonWorkbench.gui.panels.widgets.narrow import WrappedLabel
from BalloonWorkbench.gui.panels.widgets.source_row import SourceRow
from BalloonWorkbench.gui.qt import translate
from BalloonWorkbench.gui.window import file_dialogs
from BalloonWorkbench.gui.window.selection import selected_body
from BalloonWorkbench.gui.window.sentences import translated
from BalloonWorkbench.gui.window.user_units import length_text


class TargetBox(FilePage):
    """Edits a target; its panels show in the 3D view, as lines on the body."""

    def __init__(self, target):
        file = FileRow(
            "BodyFile",
            translate("STL, OBJ, PLY, 3MF or STEP"),
            translate("A closed body; a copy of it travels in the document"),
            file_dialogs.ask_for_body,
        )
        super().__init__(target, file, "BodyFile", set_body)
        self.source = SourceRow(
            target, translate("Select a solid or a mesh, or choose a file."), "Solid", selected_body
        )
        self.notes = WrappedLabel()
        self.notes.setObjectName("BodyNotes")
        self.form.addRow(self.source)
        self.form.addRow(self.file)
        for item in PROPERTIES:
            if item.label:
                self.form.add(item)
        balloon = parts_of(target).balloon if parts_of(target) is not None else None
        self.seams = BodySeams(target, balloon, self.changed.emit, self.refused.emit)
        self.curve = PanelCurveBox(target, balloon, self.changed.emit)
        self.form.addRow(self.notes)
        self.form.addRow(self.curve)
        self.form.addRow(self.seams)
        self.source.picked.connect(self.changed)

    def refresh(self) -> None:
        super().refresh()
        self.source.refresh()
        self.file.setVisible(not self.obj.Solid)
        known = bool(self.obj.TargetPoints) and status.is_ready(self.obj)
        self.notes.setText("\n".join([_size(self.obj), *map(translated, self.obj.Notes)]) if known else "")
        self.seams.refresh()
        self.curve.refresh()

    def release(self) -> None:
        self.source.release()
        self.seams.release()
        self.curve.release()
        super().release()


def _size(target) -> str:
    return translate("{} panels, {} of seams, {} inside").format(
        target.PanelCount, length_text(target.SeamLength.Value), volume_text(cubic_metres(target.BodyVolume))
    )

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page about a body of gores: its profile, how many gores, how its ends are closed."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.gored_body import FROM_FILE, PROPERTIES, set_profile
from BalloonWorkbench.core.units import percent_text
from BalloonWorkbench.gui.panels.bodies.profile_preview import ProfilePreview
from BalloonWorkbench.gui.panels.widgets.file_page import FilePage
from BalloonWorkbench.gui.panels.widgets.file_row import FileRow
from BalloonWorkbench.gui.panels.widgets.narrow import WrappedLabel
from BalloonWorkbench.gui.panels.widgets.source_row import SourceRow
from BalloonWorkbench.gui.qt import translate
from BalloonWorkbench.gui.window import file_dialogs
from BalloonWorkbench.gui.window.sentences import translated
from BalloonWorkbench.gui.window.user_units import length_text


class GoredBox(FilePage):
    """Edits a body of gores."""

    def __init__(self, body):
        file = FileRow(
            "ProfileFile",
            translate("SVG, DXF or JSON"),
            translate("Half the outline and its axis; a copy of it travels in the document"),
            file_dialogs.ask_for_lines,
        )
        super().__init__(body, file, "ProfileFile", set_profile)
        self.source = SourceRow(
            body, translate("Select a sketch of half the outline, or choose where the profile comes from.")
        )
        self.needed, self.notes = WrappedLabel(), WrappedLabel()
        self.needed.setObjectName("GoresNeeded")
        self.preview = ProfilePreview()
        form = self.form
        form.addRow(self.source)
        for item in PROPERTIES:
            if item.label:
                form.add(item)
            if item.name == "ProfileFrom":
                form.addRow(self.file)
            if item.name == "Accuracy":
                form.addRow(self.needed)
        form.addRow(self.preview)
        form.addRow(self.notes)
        self.source.picked.connect(self.changed)

    def refresh(self) -> None:
        super().refresh()
        body = self.obj
        self.source.refresh()
        self.file.setVisible(not body.Source and body.ProfileFrom == FROM_FILE)
        known = bool(body.ProfilePoints) and status.is_ready(body)
        self.needed.setText(_needed(body) if known else "")
        self.needed.setVisible(known)
        points = np.array([(at.x, at.z) for at in body.ProfilePoints]).reshape(-1, 2)
        self.preview.show_profile(points, body.Gores or body.GoresNeeded)
        self.notes.setText("\n".join([_size(body), *map(translated, body.Notes)]) if known else "")

    def release(self) -> None:
        self.source.release()
        super().release()


def _needed(body) -> str:
    """What the law says, before anything is inflated."""
    accuracy = percent_text(body.Accuracy)
    if not body.Gores:
        return translate("{} gores, as many as {} of the profile's diagonal need").format(
            body.GoresNeeded, accuracy
        )
    if body.Gores >= body.GoresNeeded:
        return translate("{} gores are enough for {} of the profile's diagonal").format(
            body.GoresNeeded, accuracy
        )
    return translate("{} of the profile's diagonal take {} gores").format(accuracy, body.GoresNeeded)


def _size(body) -> str:
    return translate("Diameter {}, height {}, gores {} long").format(
        *(length_text(each.Value) for each in (body.BodyDiameter, body.BodyHeight, body.MeridianLength))
    )

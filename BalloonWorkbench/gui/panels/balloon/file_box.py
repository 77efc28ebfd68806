# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of the panel about a drawing in a file: which one, how large, what was found in it."""

from __future__ import annotations

import os

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.drawings.drawing_file import place_in_picture
from BalloonWorkbench.app.outline import PROPERTIES, read_all, set_drawing
from BalloonWorkbench.core.tracing.segment import DRAWN_AS
from BalloonWorkbench.core.units import to_mm
from BalloonWorkbench.gui.panels.widgets.drawing_preview import Preview, notes_of
from BalloonWorkbench.gui.panels.widgets.fields import Fields, PropertyForm, ReturnKey
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate
from BalloonWorkbench.gui.window import file_dialogs as choose
from BalloonWorkbench.gui.window import macro_recorder


class FileBox(QtWidgets.QWidget):
    """Chooses the drawing of an outline. `changed` follows each edit, `refused` carries a message."""

    changed = QtCore.Signal()
    refused = QtCore.Signal(str)

    def __init__(self, outline):
        super().__init__()
        self.outline = outline
        self._placed = "", ""  # the drawing, and how it is read, for which _place holds
        self._place = None
        self.path = QtWidgets.QLineEdit(os.path.basename(outline.Drawing))
        self.path.setObjectName("Drawing")
        self.path.setMinimumWidth(60)
        self.path.setPlaceholderText(translate("Picture, SVG, DXF or JSON"))
        self.path.setToolTip(translate("The drawing; a copy of it travels in the document"))
        browse = QtWidgets.QToolButton()
        browse.setText("…")
        browse.setToolTip(translate("Choose a file"))
        row = QtWidgets.QHBoxLayout()
        row.addWidget(self.path)
        row.addWidget(browse)
        self.fields = Fields(outline, self)
        self.preview = Preview()
        self.notes = QtWidgets.QLabel()
        self.notes.setWordWrap(True)
        self.form = form = PropertyForm(self.fields, self)
        form.addRow(QtWidgets.QLabel(translate("File")))
        form.addRow(row)
        for item in PROPERTIES:
            if item.label:
                self.form.add(item, self._sizes().get(item.name))
        form.addRow(self.preview)
        form.addRow(self.notes)
        browse.clicked.connect(self._browse)
        self.path.editingFinished.connect(self._take_path)
        ReturnKey(self.path, self._take_path)
        self.fields.changed.connect(self._edited)

    def choose(self, path: str) -> None:
        """Take a file as the drawing."""
        try:
            set_drawing(self.outline, path)
        except OSError:
            self.refused.emit(translate("There is no file {}: check the name and the folder.").format(path))
            return
        macro_recorder.came_from(self.outline, path)
        self.path.setText(os.path.basename(path))
        self.path.setModified(False)
        self.changed.emit()

    def finish_typing(self) -> None:
        self.fields.finish_typing()
        self._take_path()

    def refresh(self) -> None:
        self.form.refresh()
        asked = self.outline.Drawing, DRAWN_AS[self.outline.DrawnAs]
        if asked != self._placed:
            self._placed = asked
            self._place = place_in_picture(*asked) if self.outline.Drawing else None
        self.preview.show(self.outline, self._place)
        self.notes.setText(notes_of(self.outline))

    def release(self) -> None:
        """The panel closes."""
        self.path.setModified(False)
        self.fields.release()

    def _sizes(self):
        """What a size of 0 comes to."""
        return {"Width": lambda: self._size()[0], "Height": lambda: self._size()[1]}

    def _size(self) -> tuple[float, float]:
        """Width and height of the whole drawing in mm; 0 while there is none."""
        outline = self.outline
        if not status.is_ready(outline):
            return 0.0, 0.0
        if any(getattr(other, "Leader", None) == outline for other in outline.InList):
            width, height = read_all(outline)[0].size
            return to_mm(width), to_mm(height)
        return outline.SizeX.Value, outline.SizeY.Value

    def _edited(self, name: str) -> None:
        """With the proportions kept, the side that was given last decides; without, both are given."""
        outline, driven = self.outline, dict(self.outline.ExpressionEngine)
        if outline.KeepAspect:
            for other in {"Width": ("Height",), "Height": ("Width",)}.get(name, ()):
                if getattr(outline, other).Value and other not in driven:
                    setattr(outline, other, 0.0)
        elif name == "KeepAspect":
            width, height = self._size()
            outline.Width, outline.Height = outline.Width.Value or width, outline.Height.Value or height
        self.changed.emit()

    def _browse(self) -> None:
        path = choose.ask_for_drawing(self)
        if path:
            self.choose(path)

    def _take_path(self) -> None:
        if self.path.isModified() and self.path.text().strip():
            self.path.setModified(False)
            self.choose(self.path.text().strip())

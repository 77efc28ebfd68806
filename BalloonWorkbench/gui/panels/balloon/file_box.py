# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of the panel about a drawing in a file: which one, how large, what was found in it."""

from __future__ import annotations

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.outline import PROPERTIES, read_all, set_drawing
from BalloonWorkbench.core.units import to_mm
from BalloonWorkbench.gui.panels.widgets.drawing_preview import Preview, notes_of
from BalloonWorkbench.gui.panels.widgets.file_page import FilePage
from BalloonWorkbench.gui.panels.widgets.file_row import FileRow
from BalloonWorkbench.gui.panels.widgets.narrow import WrappedLabel
from BalloonWorkbench.gui.qt import QtWidgets, translate
from BalloonWorkbench.gui.window import file_dialogs as choose
from BalloonWorkbench.gui.wrapping import PushButton


class FileBox(FilePage):
    """Chooses the drawing of an outline."""

    def __init__(self, outline):
        file = FileRow(
            "Drawing",
            translate("Picture, SVG, DXF or JSON"),
            translate("The drawing; a copy of it travels in the document"),
            choose.ask_for_drawing,
        )
        super().__init__(outline, file, "Drawing", set_drawing)
        self.preview = Preview()
        self.nodes = PushButton(translate("Edit outline ..."))
        self.nodes.setObjectName("EditNodes")
        self.nodes.setToolTip(
            translate("Move, add and remove nodes of the outline in a tab, over the picture")
        )
        self.nodes.clicked.connect(self._edit_nodes)
        self.notes = WrappedLabel()
        form, sizes = self.form, {"Width": lambda: self._size()[0], "Height": lambda: self._size()[1]}
        form.addRow(QtWidgets.QLabel(translate("File")))
        form.addRow(self.file)
        for item in PROPERTIES:
            if item.label:
                form.add(item, sizes.get(item.name))
        form.addRow(self.preview)
        form.addRow(self.nodes)
        form.addRow(self.notes)

    def refresh(self) -> None:
        super().refresh()
        canvas = read_all(self.obj)[0].canvas if status.is_ready(self.obj) and self.obj.Drawing else None
        self.preview.show(self.obj, canvas)
        self.nodes.setEnabled(bool(self.obj.Drawing) and bool(self.obj.LoopCounts))
        self.notes.setText(notes_of(self.obj))

    def _edit_nodes(self, _checked: bool = False) -> None:
        from BalloonWorkbench.gui.outline_editor.tab import open_tab

        open_tab(self.obj, self)

    def _size(self) -> tuple[float, float]:
        """Width and height of the whole drawing in mm; 0 while there is none."""
        outline = self.obj
        if not status.is_ready(outline):
            return 0.0, 0.0
        if any(getattr(other, "Leader", None) == outline for other in outline.InList):
            width, height = read_all(outline)[0].size
            return to_mm(width), to_mm(height)
        return outline.SizeX.Value, outline.SizeY.Value

    def edited(self, name: str) -> None:
        """With the proportions kept, the side that was given last decides; without, both are given."""
        outline, driven = self.obj, dict(self.obj.ExpressionEngine)
        if outline.KeepAspect:
            for other in {"Width": ("Height",), "Height": ("Width",)}.get(name, ()):
                if getattr(outline, other).Value and other not in driven:
                    setattr(outline, other, 0.0)
        elif name == "KeepAspect":
            width, height = self._size()
            outline.Width, outline.Height = outline.Width.Value or width, outline.Height.Value or height
        super().edited(name)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of an artwork: pictures for front and back, bleed, resolution, and the files to print."""

from __future__ import annotations

from pathlib import Path

import FreeCADGui as Gui

from BalloonWorkbench.app import artwork
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.properties import values
from BalloonWorkbench.app.properties.property_table import put_file
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.machines.machine import machines
from BalloonWorkbench.core.options.option import snake
from BalloonWorkbench.gui.accessible import sign_button
from BalloonWorkbench.gui.paint.preview.painting_display import MODE
from BalloonWorkbench.gui.panels import show
from BalloonWorkbench.gui.panels.widgets.fields import PropertyForm
from BalloonWorkbench.gui.panels.widgets.narrow import Message, NarrowCombo
from BalloonWorkbench.gui.panels.widgets.object_panel import ObjectPanel
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate
from BalloonWorkbench.gui.view3d.fit_view import fit_kept
from BalloonWorkbench.gui.window import macro_recorder
from BalloonWorkbench.gui.window.borders import undo_step
from BalloonWorkbench.gui.window.file_dialogs import ask_for_picture
from BalloonWorkbench.gui.window.sentences import translated
from BalloonWorkbench.gui.window.user_units import NOTHING, size_text
from BalloonWorkbench.gui.wrapping import PushButton


def show_panel(obj) -> None:
    """Open the panel on an artwork, in one undo step."""
    with undo_step(obj.Document, translate("Edit artwork")):
        show(ArtworkPanel(obj))


class ArtworkPanel(ObjectPanel):
    """Edits an artwork."""

    def __init__(self, obj):
        super().__init__(obj, "ArtworkPanel", translate("Artwork"), "artwork")
        self.files: dict[str, str] = {}  # pictures that were chosen, as Python text
        self.front = PictureRow("Picture", translate("That of the outline"))
        self.back = PictureRow("BackPicture", translate("That of the front"))
        self.write = PushButton(translate("Write files…"))
        self.write.setObjectName("WriteArtwork")
        self.write.setToolTip(
            translate("Front and back as PNG and PDF, and as DXF and SVG with the same marks for the cutter")
        )
        self.size = QtWidgets.QLabel()
        self.size.setObjectName("ArtworkSize")
        self.message = Message("ArtworkMessage")
        form = PropertyForm(self.fields, self.form)
        self.marks = NarrowCombo()
        self.marks.setObjectName("MarksFor")
        self.marks.setToolTip(
            translate("The machine that finds the print again by its registration marks, printed round it")
        )
        looking = [known for known in machines().values() if not known.marks.are_seen]
        self.known = {known.name: translated(known.title) for known in looking}
        self.known = {"": translate("Crosses, by eye"), **self.known}
        self.marks.addItems(list(self.known.values()))
        rows = {"Picture": self.front, "BackPicture": self.back, "MarksFor": self.marks}
        for item in artwork.PROPERTIES:
            if item.name in rows:
                form.addRow(QtWidgets.QLabel(translate(item.label)))
                form.addRow(rows[item.name])
            elif item.label:
                form.add(item)
        form.addRow(translate("Size"), self.size)
        form.addRow(self.write)
        form.addRow(self.message)
        for row in (self.front, self.back):
            row.chosen.connect(self.choose)
        self.marks.activated.connect(self.choose_marks)
        self.fields.changed.connect(lambda _name: self.update())
        self.write.clicked.connect(lambda _checked=False: self.write_files())
        self.update()

    def choose(self, name: str, path: str) -> None:
        """Take a picture for a side; an empty path takes it away."""
        try:
            put_file(self.obj, next(item for item in artwork.PROPERTIES if item.name == name), path)
        except OSError:
            self.message.setText(
                translate("There is no file {}: check the name and the folder.").format(path)
            )
            return
        self.files[snake(name)] = macro_recorder.text(path)
        self.update()

    def choose_marks(self, row: int) -> None:
        """Take the machine that the marks are for."""
        self.obj.MarksFor = list(self.known)[row]
        self.update()

    def update(self) -> None:
        """Bring the artwork up to date and show what it says."""
        with fit_kept(Gui.getDocument(self.doc.Name)):
            self.obj.recompute()
        self.fields.refresh()
        names = list(self.known)
        self.marks.setCurrentIndex(names.index(self.obj.MarksFor) if self.obj.MarksFor in names else -1)
        self.front.show_file(self.obj.Picture)
        self.back.show_file(self.obj.BackPicture)
        ready = status.is_ready(self.obj)
        if ready:
            self.obj.Pattern.Balloon.ViewObject.DisplayMode = MODE
        self.write.setEnabled(ready)
        self.message.setText(translated(status.problem(self.obj)))
        width, height = self.obj.PatternWidth.Value, self.obj.PatternHeight.Value
        self.size.setText(size_text(width, height) if ready else NOTHING)

    def write_files(self, folder: str = "") -> None:
        """Ask for a folder and write the files."""
        if not folder:
            document = self.doc.FileName
            start = str(Path(document).parent if document else Path.home())
            folder = QtWidgets.QFileDialog.getExistingDirectory(
                self.form, translate("Folder for the artwork"), start
            )
        if not folder:
            return
        self.fields.finish_typing()
        try:
            artwork.write(self.obj, folder)
        except BalloonError as error:
            self.message.setText(translated(str(error)))
        else:
            macro_recorder.call("export", macro_recorder.obj(self.obj), macro_recorder.text(folder))
            message = translate("Files written to {}").format(folder)
            self.message.setText(message)

    def accept(self):
        self.fields.finish_typing()
        self.update()
        self.keep()
        self.doc.recompute()
        arguments = values.texts_of(self.obj, artwork.PROPERTIES) | self.files
        macro_recorder.call(
            "artwork", macro_recorder.obj(self.obj.Pattern), result=self.obj, name="artwork", **arguments
        )
        return True


class PictureRow(QtWidgets.QWidget):
    """Name of a picture, a button to choose one and one to take it away. `chosen` carries property, path."""

    chosen = QtCore.Signal(str, str)

    def __init__(self, name: str, empty: str):
        super().__init__()
        self.name = name
        self.file = QtWidgets.QLineEdit()
        self.file.setObjectName(name)
        self.file.setPlaceholderText(empty)
        self.file.setMinimumWidth(60)
        browse = sign_button("…", translate("Choose a picture"))
        clear = sign_button("×", translate("Take the picture away"))
        row = QtWidgets.QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        for widget in (self.file, browse, clear):
            row.addWidget(widget)
        self.file.editingFinished.connect(self._typed)
        browse.clicked.connect(lambda _checked=False: self._browse())
        clear.clicked.connect(lambda _checked=False: self.chosen.emit(self.name, ""))

    def show_file(self, path: str) -> None:
        self.file.setText(Path(path).name if path else "")
        self.file.setModified(False)

    def _typed(self) -> None:
        if self.file.isModified():
            self.file.setModified(False)
            self.chosen.emit(self.name, self.file.text().strip())

    def _browse(self) -> None:
        path = ask_for_picture(self)
        if path:
            self.chosen.emit(self.name, path)

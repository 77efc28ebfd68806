# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of a sheet of film: which balloons, how many, on what film, and how much of it they take."""

from __future__ import annotations

from pathlib import Path

import FreeCADGui as Gui

from BalloonWorkbench.app import film_sheet
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document.parts import patterns
from BalloonWorkbench.app.properties import preferences, values
from BalloonWorkbench.app.properties.property_table import put_file
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.nesting.remnant import FILE
from BalloonWorkbench.core.options.making import MOST_BALLOONS
from BalloonWorkbench.core.units import percent_text
from BalloonWorkbench.gui.panels import show
from BalloonWorkbench.gui.panels.widgets.fields import PropertyForm
from BalloonWorkbench.gui.panels.widgets.file_row import FileRow
from BalloonWorkbench.gui.panels.widgets.narrow import FullList, Message, WrappedLabel
from BalloonWorkbench.gui.panels.widgets.object_panel import ObjectPanel
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate
from BalloonWorkbench.gui.view3d.fit_view import fit_all
from BalloonWorkbench.gui.window import macro_recorder
from BalloonWorkbench.gui.window.borders import undo_step
from BalloonWorkbench.gui.window.file_dialogs import ask_for_remnant, ask_where_to_write
from BalloonWorkbench.gui.window.sentences import translated
from BalloonWorkbench.gui.window.user_units import NOTHING, size_text
from BalloonWorkbench.gui.wrapping import PushButton

_HIGHEST = 160  # px, of the list of patterns


def show_panel(obj) -> None:
    """Open the panel on a sheet of film, in one undo step."""
    with undo_step(obj.Document, translate("Edit film")):
        show(NestPanel(obj))


class NestPanel(ObjectPanel):
    """Edits a sheet of film."""

    def __init__(self, obj):
        super().__init__(obj, "NestPanel", translate("Lay out on film"), "nest")
        self.is_new = not obj.LaidOutFor
        self.remnant_path = self.kept = None
        self.choice = FullList(_HIGHEST)
        self.choice.setObjectName("NestPatterns")
        for pattern in patterns(self.doc):
            entry = QtWidgets.QListWidgetItem(_name(pattern))
            entry.setData(QtCore.Qt.UserRole, pattern.Name)
            taken = pattern in obj.Patterns
            entry.setCheckState(QtCore.Qt.Checked if taken else QtCore.Qt.Unchecked)
            self.choice.addItem(entry)
        self.choice.fit()
        self.sheet_number = self.fields.whole("Shown", 1, MOST_BALLOONS)
        self.apply = PushButton(translate("Lay out"))
        self.apply.setObjectName("LayOut")
        self.apply.setToolTip(translate("Look for the closest layout; Esc takes the best one so far"))
        self.left = PushButton(translate("Keep what is left..."))
        self.left.setObjectName("KeepRemnant")
        self.left.setToolTip(translate("Write what is left of the film to a file, for another layout"))
        self.result = WrappedLabel()
        self.result.setObjectName("NestResult")
        self.message = Message("NestMessage")
        form = PropertyForm(self.fields, self.form)
        form.addRow(QtWidgets.QLabel(translate("Patterns")))
        form.addRow(self.choice)
        self.remnant = RemnantRow()
        for item in film_sheet.PROPERTIES:
            if item.name == "Remnant":
                form.addRow(QtWidgets.QLabel(translate(item.label)))
                form.addRow(self.remnant)
            elif item.label:
                form.add(item)
        form.addRow(translate("Shown sheet"), self.sheet_number)
        form.addRow(self.apply)
        form.addRow(translate("Used"), self.result)
        form.addRow(self.left)
        form.addRow(self.message)
        self.sheet_number.valueChanged.connect(lambda _value: self.lay_out() if obj.LaidOutFor else None)
        self.remnant.chosen.connect(self.take_remnant)
        self.apply.clicked.connect(lambda _checked=False: self.lay_out())
        self.left.clicked.connect(lambda _checked=False: self.keep_remnant())
        self.show_state()

    def take(self) -> None:
        """The values of the panel, into the object."""
        self.fields.finish_typing()
        names = [
            self.choice.item(row).data(QtCore.Qt.UserRole)
            for row in range(self.choice.count())
            if self.choice.item(row).checkState() == QtCore.Qt.Checked
        ]
        self.obj.Patterns = [self.doc.getObject(name) for name in names]

    def take_remnant(self, path: str) -> None:
        """Lay pieces onto what is left of another layout; an empty path takes it away."""
        try:
            put_file(self.obj, film_sheet.REMNANT, path)
        except OSError:
            self.message.setText(
                translate("There is no file {}: check the name and the folder.").format(path)
            )
            return
        self.remnant_path = path
        self.remnant.show_name(Path(path).name)

    def lay_out(self) -> None:
        """Bring the layout up to date."""
        self.take()
        self.apply.setEnabled(False)
        self.obj.recompute()
        if not self.is_open:  # the panel was closed meanwhile
            return
        self.apply.setEnabled(True)
        self.show_state()
        fit_all(Gui.getDocument(self.doc.Name))

    def keep_remnant(self) -> None:
        """Write what is left to a file that the user chooses."""
        name, ending = FILE.split(".")
        kinds = {ending: translate("Remnants")}
        try:
            path = ask_where_to_write(self.form, translate("Keep what is left"), self.doc, name, kinds)
            if path is None:
                return
            written = film_sheet.keep_remnant(self.obj, path)
        except BalloonError as error:
            self.fail(error)
            return
        preferences.put_export_folder(self.doc, written.parent)
        self.kept = written
        self.message.setText(translate("Written to {}").format(written))

    def fail(self, error) -> None:
        self.apply.setEnabled(True)
        super().fail(error)

    def show_state(self) -> None:
        """What the object says."""
        self.fields.refresh()
        self.remnant.show_name(Path(self.obj.Remnant).name if self.obj.Remnant else "")
        obj, figures = self.obj, NOTHING
        if obj.LaidOutFor:
            figures = translate("Pieces: {}, on {}, {} used").format(
                obj.Pieces,
                size_text(obj.UsedLength.Value, obj.Shape.BoundBox.YLength or obj.FilmWidth.Value),
                percent_text(0.01 * obj.Used),
            )
            if obj.Sheets > 1:
                figures += "\n" + translate("Sheet {} of {}").format(obj.Shown, obj.Sheets)
        self.result.setText(figures)
        self.left.setEnabled(bool(obj.LaidOutFor))
        problem = status.problem(obj) if obj.Status else ""
        self.message.setText("\n".join(translated(text) for text in [problem, *obj.Warnings] if text))

    def accept(self):
        self.take()
        self.obj.recompute()
        if not status.is_ready(self.obj):
            self.show_state()
            return False
        self.keep()
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(self.obj)  # what is exported next
        arguments = values.texts_of(self.obj, film_sheet.PROPERTIES)
        if self.remnant_path is not None:
            arguments["remnant"] = macro_recorder.text(self.remnant_path)
        if not self.is_new:
            arguments["sheet"] = macro_recorder.obj(self.obj)
        names = ", ".join(map(macro_recorder.obj, self.obj.Patterns))
        macro_recorder.call("nest", f"[{names}]", result=self.obj, name="sheet", **arguments)
        if self.kept is not None:
            macro_recorder.call("keep_remnant", macro_recorder.obj(self.obj), macro_recorder.text(self.kept))
        return True


class RemnantRow(FileRow):
    """The file of a remnant; an empty line takes it away."""

    def __init__(self):
        super().__init__(
            "Remnant",
            translate("None"),
            translate("The file of what is left of another layout: pieces are laid inside it first"),
            ask_for_remnant,
        )

    def take(self) -> None:
        if self.path.isModified():
            self.path.setModified(False)
            self.chosen.emit(self.path.text().strip())


def _name(pattern) -> str:
    group = pattern.getParentGroup()
    return f"{group.Label}: {pattern.Label}" if group else pattern.Label

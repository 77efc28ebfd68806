# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of a panel about the file that it writes: its name, its folder, and what is there already."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from BalloonWorkbench.app.document.kinds import is_panel
from BalloonWorkbench.app.properties import preferences
from BalloonWorkbench.core.files.write import safe_name
from BalloonWorkbench.gui.accessible import sign_button
from BalloonWorkbench.gui.panels.widgets.narrow import ElidedLabel
from BalloonWorkbench.gui.qt import QtWidgets, translate
from BalloonWorkbench.gui.wrapped_check import WrappedCheck


class TargetFile(QtWidgets.QWidget):
    """A line for the name, a button that looks for a file, and the folder below.

    A path may be typed into the line. Where a file is there already, a box asks whether to replace it.
    """

    def __init__(self, doc, object_name: str, title: str):
        super().__init__()
        self._doc, self._title = doc, title
        self._folder = preferences.export_folder(doc)
        self._suggested = self._ending = ""
        self.line = QtWidgets.QLineEdit()
        self.line.setObjectName(object_name)
        self.line.setMinimumWidth(60)
        browse = sign_button("…", translate("Choose a file"))
        self.place = ElidedLabel()
        self.place.setObjectName(f"{object_name}Folder")
        self.replace = WrappedCheck(translate("Replace the file"))
        self.replace.setObjectName(f"{object_name}Replace")
        self.replace.setToolTip(translate("A file of this name is there already"))
        below = QtWidgets.QHBoxLayout()
        below.addWidget(self.place)
        below.addWidget(browse)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.line)
        column.addLayout(below)
        column.addWidget(self.replace)
        self.line.editingFinished.connect(self._take)
        self.line.textEdited.connect(lambda _text: self.replace.setChecked(False))
        browse.clicked.connect(lambda _checked=False: self._browse())

    def suggest(self, name: str) -> None:
        """Take a name while the user has given none; his own keeps all but its ending."""
        self._take()
        self._ending = Path(name).suffix
        own = self.line.text().strip()
        if own and own != self._suggested:
            name = Path(own).with_suffix(self._ending).name
        else:
            self._suggested = name
        if name != own:
            self.replace.setChecked(False)
        self.line.setText(name)
        self.line.setCursorPosition(0)  # a long name is read from its beginning
        self._show()

    @property
    def path(self) -> Path:
        """The file."""
        self._take()
        name = self.line.text().strip() or self._suggested
        if not name.lower().endswith(self._ending):
            name += self._ending
        return self._folder / name

    def objection(self, files: Sequence[Path]) -> str:
        """What to say instead of writing files: empty where none is there or they may be replaced."""
        there = [file.name for file in files if file.exists()]
        self.replace.setVisible(bool(there))
        if not there or self.replace.isChecked():
            return ""
        return translate('{} is there already: tick "Replace the file", or give another name.').format(
            ", ".join(there)
        )

    def wrote(self) -> None:
        """The file was written: the next one goes into the same folder."""
        preferences.put_export_folder(self._doc, self._folder)

    def _take(self) -> None:
        """A path that was typed is a folder and a name."""
        typed = Path(self.line.text().strip()).expanduser()
        if typed.name and str(typed.parent) != ".":
            self._folder = self._folder / typed.parent
            self.line.setText(typed.name)
        self._show()

    def _show(self) -> None:
        name = self.line.text().strip()
        file = self._folder / name
        self.place.setText(translate("in {}").format(self._folder))
        for widget in (self.line, self.place):
            widget.setToolTip(str(file))
        there = bool(name) and file.is_file()
        if not there:
            self.replace.setChecked(False)
        self.replace.setVisible(there)

    def _browse(self) -> None:
        ending = self._ending.lstrip(".")
        path, _ = QtWidgets.QFileDialog.getSaveFileName(
            self, self._title, str(self.path), f"{ending.upper()} (*.{ending})"
        )
        if path:
            self.line.setText(path)
            self._take()
            self.replace.setChecked(self.path == Path(path))  # the dialog has asked about that name


def name_of(obj) -> str:
    """What files about an object are called, without ending: as its balloon in the tree, else as itself.

    A balloon that nobody has named is called as its document; a panel by its own name too.
    """
    if is_panel(obj) and obj.Pattern is not None:
        return safe_name(f"{name_of(obj.Pattern)} {obj.Label}")
    group, document = obj.getParentGroup(), obj.Document.FileName
    label = (group or obj).Label
    unnamed = label.rstrip("0123456789 ") in ("Balloon", translate("Painted balloon"))
    return safe_name(Path(document).stem if unnamed and document else label)

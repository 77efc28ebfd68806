# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel that writes a pattern to a file."""

from __future__ import annotations

from pathlib import Path

import FreeCADGui as Gui

from BalloonWorkbench.app import preferences
from BalloonWorkbench.app.export import export_for
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.gui import record
from BalloonWorkbench.gui.borders import Panel
from BalloonWorkbench.gui.panels.machine_box import MachineBox
from BalloonWorkbench.gui.panels.watch import Watch
from BalloonWorkbench.gui.qt import QtGui, QtWidgets, icon, translate
from BalloonWorkbench.gui.sentences import tell
from BalloonWorkbench.gui.user_units import length_text, size_text


class ExportPanel(Panel):
    """Chooses a pattern, a machine and a file."""

    def __init__(self, patterns, chosen=None):
        self.patterns = patterns
        self.form = QtWidgets.QWidget()
        self.form.setWindowTitle(translate("Export pattern"))
        self.form.setWindowIcon(QtGui.QIcon(icon("export_pattern")))
        self.choice = QtWidgets.QComboBox()
        self.choice.setObjectName("Pattern")
        self.choice.addItems([_name(pattern) for pattern in patterns])
        self.machine = MachineBox(patterns[0].Document.Name)
        self.machine.choose(preferences.get("Machine"))
        self.path = QtWidgets.QLineEdit()
        self.path.setMinimumWidth(60)
        self.path.setObjectName("File")
        browse = QtWidgets.QToolButton()
        browse.setText("…")
        row = QtWidgets.QHBoxLayout()
        row.addWidget(self.path)
        row.addWidget(browse)
        self.size = QtWidgets.QLabel()
        self.size.setObjectName("Size")
        self.size.setWordWrap(True)
        self.message = QtWidgets.QLabel()
        self.message.setObjectName("Message")
        self.message.setWordWrap(True)
        form = QtWidgets.QFormLayout(self.form)
        form.addRow(translate("Pattern"), self.choice)
        form.addRow(translate("Machine"), self.machine)
        form.addRow(translate("File"), row)
        form.addRow(translate("Size"), self.size)
        form.addRow(self.message)
        self.choice.currentIndexChanged.connect(self.show_pattern)
        self.machine.changed.connect(self.follow_machine)
        browse.clicked.connect(self.browse)
        self.choice.setCurrentIndex(patterns.index(chosen) if chosen in patterns else 0)
        self.show_pattern()
        self.suggested = self.suggestion()
        self.path.setText(str(self.suggested))
        self.watch = Watch(patterns, self.close)

    def pattern(self):
        """The chosen pattern object."""
        return self.patterns[self.choice.currentIndex()]

    def suggestion(self) -> Path:
        """A file in the preferred folder, else beside the document, else in the home folder."""
        document = self.pattern().Document.FileName
        folder = Path(document).parent if document else Path.home()
        folder = Path(preferences.get("ExportFolder") or folder)
        return folder / self.machine.machine.file_name

    def ending(self) -> str:
        """The ending of the file's name."""
        return Path(self.machine.machine.file_name).suffix[1:]

    def show_pattern(self, _index: int = 0) -> None:
        pattern = self.pattern()
        self.size.setText(
            translate("{}, seam {}").format(
                size_text(pattern.PatternWidth.Value, pattern.PatternHeight.Value),
                length_text(pattern.SeamLength.Value),
            )
        )

        self.machine.show_for(pattern)

    def follow_machine(self) -> None:
        """Check the pattern for the machine; a name that the user has given keeps all but its ending."""
        written = Path(self.path.text().strip() or self.suggested)
        name = self.suggestion().name
        if str(written.name) != self.suggested.name:
            name = written.with_suffix("." + self.ending()).name
        self.suggested = self.suggestion()
        self.path.setText(str(written.parent / name))
        self.machine.show_for(self.pattern())

    def browse(self, _checked: bool = False) -> None:
        ending = self.ending()
        path, _ = QtWidgets.QFileDialog.getSaveFileName(
            self.form, translate("Export pattern"), self.path.text(), f"{ending.upper()} (*.{ending})"
        )
        if path:
            self.path.setText(path)

    def accept(self):
        """Write the file; the panel stays with the reason when that fails."""
        path = self.path.text().strip() or str(self.suggestion())
        made_for = self.machine.machine
        if not path.lower().endswith("." + self.ending()):
            path += "." + self.ending()
        try:
            written = export_for(self.pattern(), made_for.name, path, self.machine.paper)
        except BalloonError as error:
            self.message.setText(tell(str(error)))
            return False
        chosen = {"machine": record.text(made_for.name)}
        if self.machine.paper:
            chosen["paper"] = record.text(self.machine.paper)
        record.call("export", record.obj(self.pattern()), record.text(written), **chosen)
        self.close()
        Gui.getMainWindow().statusBar().showMessage(translate("Pattern written to {}").format(written), 8000)
        return True

    def reject(self):
        self.close()
        return True

    def close(self) -> None:
        self.watch.remove()
        self.machine.release()
        Gui.Control.closeDialog()


def _name(pattern) -> str:
    """The pattern with the group it is in: several balloons have patterns of the same name."""
    group = pattern.getParentGroup()
    return f"{group.Label}: {pattern.Label}" if group else pattern.Label

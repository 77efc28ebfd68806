# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel that writes a pattern to a file."""

from __future__ import annotations

import tempfile

import FreeCADGui as Gui

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document.kinds import is_panel, leader
from BalloonWorkbench.app.document.parts import parts_of
from BalloonWorkbench.app.engine.cut_sheet import patterns_in
from BalloonWorkbench.app.engine.export import export_for, files_of
from BalloonWorkbench.app.machines import bed
from BalloonWorkbench.app.machines.tool_paths import add_jobs, job_file
from BalloonWorkbench.app.properties import preferences
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.options.making import REFUSE
from BalloonWorkbench.gui.panels.making.machine_box import MachineBox
from BalloonWorkbench.gui.panels.widgets.narrow import Message, NarrowCombo, NarrowForm, WrappedLabel
from BalloonWorkbench.gui.panels.widgets.target_file import TargetFile, name_of
from BalloonWorkbench.gui.panels.widgets.watch import Watch
from BalloonWorkbench.gui.qt import QtCore, QtGui, QtWidgets, icon, translate
from BalloonWorkbench.gui.window import macro_recorder
from BalloonWorkbench.gui.window.borders import TaskPanel, undo_step
from BalloonWorkbench.gui.window.sentences import translated
from BalloonWorkbench.gui.window.user_units import NOTHING, length_text, size_text
from BalloonWorkbench.gui.wrapped_check import WrappedCheck


class ExportPanel(TaskPanel):
    """Chooses a pattern, a machine and a file.

    preset  the machine that the program has set, which the document does not remember; "" for none
    """

    def __init__(self, patterns, chosen=None, preset=""):
        self.patterns, self.preset = patterns, preset
        self.is_open = True
        self.form = QtWidgets.QWidget()
        self.form.setWindowTitle(translate("Export pattern"))
        self.form.setWindowIcon(QtGui.QIcon(icon("export_pattern")))
        self.choice = NarrowCombo()
        self.choice.setObjectName("Pattern")
        self.choice.addItems([_name(pattern) for pattern in patterns])
        self.machine = MachineBox(patterns[0].Document.Name)
        self.machine.choose(preset or preferences.machine(patterns[0].Document))
        self.file = TargetFile(patterns[0].Document, "File", translate("Export pattern"))
        self.as_paths = WrappedCheck(translate("Tool paths, no file"))
        self.as_paths.setObjectName("AsToolPaths")
        self.as_paths.setToolTip(
            translate(
                "Put the same moves into the document, as objects of FreeCAD's workbench Path (CAM since"
                " 1.0), which can simulate them and write them with its post processors"
            )
        )
        self.size = WrappedLabel()
        self.size.setObjectName("Size")
        self.message = Message("Message")
        form = NarrowForm(self.form)
        for text, widget in (
            (translate("Pattern"), self.choice),
            (translate("Machine"), self.machine),
            (translate("File"), self.file),
        ):
            form.addRow(QtWidgets.QLabel(text))
            form.addRow(widget)
        form.addRow(self.as_paths)
        form.addRow(translate("Size"), self.size)
        form.addRow(self.message)
        self.choice.currentIndexChanged.connect(self.show_pattern)
        self.machine.changed.connect(self.show_pattern)
        self.machine.scaled.connect(self.scale_to_fit)
        self.machine.set_up.connect(self.set_up_machines)
        self.choice.setCurrentIndex(patterns.index(chosen) if chosen in patterns else 0)
        self.show_pattern()
        self.watch = Watch(patterns, self.close)

    def pattern(self):
        """The chosen pattern object."""
        return self.patterns[self.choice.currentIndex()]

    def show_pattern(self, _index: int = 0) -> None:
        """Check the chosen pattern for the machine, and name its file."""
        pattern = self.pattern()
        self.message.setText("")
        self.size.setText(_size(pattern) if status.is_ready(pattern) else NOTHING)
        self.file.suggest(self.machine.machine.file_of(name_of(pattern)))
        self.as_paths.setVisible(self.machine.machine.tool is not None)
        self.machine.show_for(pattern)

    def _remember(self, machine: str) -> None:
        """Export begins with it the next time, where the user has chosen it."""
        if machine != self.preset:
            preferences.put_machine(self.pattern().Document, machine)

    def set_up_machines(self) -> None:
        """Leave for the panel on the user's own machines."""
        self.close()
        QtCore.QTimer.singleShot(0, lambda: Gui.runCommand("BalloonWorkbench_Machines"))

    def scale_to_fit(self) -> None:
        """Make the balloon smaller until its pattern fits the bed, in one undo step."""
        pattern, doc = self.pattern(), self.pattern().Document
        outline = leader(patterns_in(pattern)[0].Balloon.Outline)
        parts, before = parts_of(outline), outline.SizeX.Value
        edit = macro_recorder.Edit(parts)
        self.form.setEnabled(False)
        try:
            with undo_step(doc, translate("Scale to fit")):
                bed.scale_to_bed(pattern, self.machine.machine.name, self.machine.own_bed)
                doc.commitTransaction()
        except BalloonError as error:
            if self.is_open:
                self.message.setText(translated(str(error)))
            return
        finally:
            if self.is_open:
                self.form.setEnabled(True)
        edit.write()
        if self.is_open:
            self.show_pattern()
            sentence = translate("Scaled to fit: {} wide instead of {}.")
            self.message.setText(sentence.format(length_text(outline.SizeX.Value), length_text(before)))

    def accept(self):
        """Write the file; the panel stays with the reason when that fails."""
        if self.as_paths.isVisibleTo(self.form) and self.as_paths.isChecked():
            return self._make_paths()
        made_for, paper, oversize = self.machine.machine, self.machine.paper, self.machine.oversize
        own_bed, tabs = self.machine.own_bed, self.machine.tabs.texts
        try:
            objection = self.file.objection(files_of(self.pattern(), self.file.path, oversize))
            if objection:
                self.message.setText(objection)
                return False
            pattern, path = self.pattern(), self.file.path
            written = export_for(pattern, made_for.name, path, paper, own_bed, oversize, *tabs)
        except BalloonError as error:
            self.message.setText(translated(str(error)))
            return False
        chosen = {"machine": made_for.name, "paper": paper, "bed": own_bed}
        chosen |= dict(zip(("tabs", "tabs_below"), tabs))
        if oversize != REFUSE:
            chosen["oversize"] = oversize
        options = {key: macro_recorder.text(value) for key, value in chosen.items() if value}
        macro_recorder.call(
            "export", macro_recorder.obj(self.pattern()), macro_recorder.text(written), **options
        )
        self.file.wrote()
        self._remember(made_for.name)
        self.close()
        Gui.getMainWindow().statusBar().showMessage(translate("Pattern written to {}").format(written), 8000)
        return True

    def _make_paths(self) -> bool:
        """Make tool paths in one undo step; the panel stays with the reason when that fails."""
        name, own_bed, oversize = self.machine.machine.name, self.machine.own_bed, self.machine.oversize
        pattern, tabs = self.pattern(), self.machine.tabs.texts
        chosen = {"bed": own_bed, **dict(zip(("tabs", "tabs_below"), tabs))}
        try:
            with tempfile.TemporaryDirectory() as folder:
                path = job_file(pattern, folder, name, own_bed, oversize, *tabs)
                with undo_step(pattern.Document, translate("Tool paths")):
                    jobs = add_jobs(pattern.Document, path)
                    pattern.Document.commitTransaction()
        except BalloonError as error:
            self.message.setText(translated(str(error)))
            return False
        if oversize != REFUSE:
            chosen["oversize"] = oversize
        options = {key: macro_recorder.text(value) for key, value in chosen.items() if value}
        words = macro_recorder.obj(pattern), macro_recorder.text(name)
        macro_recorder.call("tool_paths", *words, result=jobs, **options)
        self._remember(name)
        self.close()
        return True

    def reject(self):
        self.close()
        return True

    def close(self) -> None:
        self.is_open = False
        self.watch.remove()
        self.machine.release()
        Gui.Control.closeDialog()


def _size(pattern) -> str:
    return translate("{}, seam {}").format(
        size_text(pattern.PatternWidth.Value, pattern.PatternHeight.Value),
        length_text(pattern.SeamLength.Value),
    )


def _name(pattern) -> str:
    """The pattern with the group it is in: several balloons have patterns of the same name."""
    group = (pattern.Pattern if is_panel(pattern) else pattern).getParentGroup()
    return f"{group.Label}: {pattern.Label}" if group else pattern.Label

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of the assembly sheet: what it takes to make the balloon, will it float, and the page."""

from __future__ import annotations

import FreeCADGui as Gui

from BalloonWorkbench.app.engine import maker
from BalloonWorkbench.app.properties import preferences
from BalloonWorkbench.core.assembly_sheet.page import PAGES
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.pages.fonts import can_show
from BalloonWorkbench.gui.panels.making.maker_rows import MakerRows
from BalloonWorkbench.gui.panels.widgets.narrow import Message, NarrowForm
from BalloonWorkbench.gui.panels.widgets.target_file import TargetFile, name_of
from BalloonWorkbench.gui.panels.widgets.watch import Watch
from BalloonWorkbench.gui.qt import QtGui, QtWidgets, icon, translate
from BalloonWorkbench.gui.window import macro_recorder
from BalloonWorkbench.gui.window.borders import TaskPanel
from BalloonWorkbench.gui.window.sentences import translated


class AssemblyPanel(TaskPanel):
    """Shows a balloon's numbers and writes its page."""

    def __init__(self, parts):
        self.parts = parts
        self.form = QtWidgets.QWidget()
        self.form.setObjectName("AssemblyPanel")
        self.form.setWindowTitle(translate("Assembly sheet"))
        self.form.setWindowIcon(QtGui.QIcon(icon("assembly_sheet")))
        self.paper = QtWidgets.QComboBox()
        self.paper.setObjectName("Paper")
        self.paper.addItems(list(PAGES))
        self.file = TargetFile(parts.balloon.Document, "AssemblyFile", translate("Assembly sheet"))
        self.file.suggest(f"{name_of(parts.balloon)}-assembly.pdf")
        self.message = Message("AssemblyMessage")
        form = NarrowForm(self.form)
        numbers = NarrowForm()
        self.numbers = MakerRows(numbers)
        self.numbers.show(parts)
        form.addRow(numbers)
        form.addRow(translate("Paper"), self.paper)
        form.addRow(QtWidgets.QLabel(translate("File")))
        form.addRow(self.file)
        form.addRow(self.message)
        self.message.setText(_remark())
        self.watch = Watch(parts, self.close)

    def accept(self):
        """Write the page; the panel stays with the reason when that fails."""
        objection = self.file.objection([self.file.path])
        if objection:
            self.message.setText(objection)
            return False
        try:
            machine = maker.told_of(preferences.machine(self.parts.balloon.Document))
            written = maker.write_assembly(self.parts, self.file.path, self.paper.currentText(), machine)
        except BalloonError as error:
            self.message.setText(translated(str(error)))
            return False
        balloon = f"BalloonWorkbench.parts({macro_recorder.obj(self.parts.balloon)})"
        macro_recorder.call(
            "assembly_sheet",
            balloon,
            macro_recorder.text(written),
            macro_recorder.text(self.paper.currentText()),
            **({} if machine is None else {"machine": macro_recorder.text(machine)}),
        )
        self.file.wrote()
        self.close()
        sentence = translate("Assembly sheet written to {}").format(written)
        Gui.getMainWindow().statusBar().showMessage(sentence, 8000)
        return True

    def reject(self):
        self.close()
        return True

    def close(self) -> None:
        self.watch.remove()
        self.numbers.release()
        Gui.Control.closeDialog()


def _remark() -> str:
    """Why the page will not be in the user's language, empty when it will."""
    if can_show(translate("Assembly sheet")):
        return ""
    return translate(
        "The page will be in English, as no font here has the letters of your language: install IPAexGothic"
        " or Noto Sans CJK JP, and open this panel again."
    )

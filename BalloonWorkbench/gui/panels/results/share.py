# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel that writes a balloon for others: a web page, a 3D model or a picture."""

from __future__ import annotations

import FreeCADGui as Gui

from BalloonWorkbench.app.sharing.share import GLB, PAGE, PICTURE, write_shared
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.gui.panels.results.ground_row import GroundRow
from BalloonWorkbench.gui.panels.widgets.narrow import Message, NarrowCombo, NarrowForm
from BalloonWorkbench.gui.panels.widgets.target_file import TargetFile, name_of
from BalloonWorkbench.gui.panels.widgets.watch import Watch
from BalloonWorkbench.gui.qt import QtGui, QtWidgets, icon, translate
from BalloonWorkbench.gui.window import macro_recorder
from BalloonWorkbench.gui.window.borders import TaskPanel
from BalloonWorkbench.gui.window.sentences import translated


class SharePanel(TaskPanel):
    """Chooses what is written of one balloon, and the file."""

    def __init__(self, parts):
        self.parts = parts
        self.is_open = True
        self.form = QtWidgets.QWidget()
        self.form.setObjectName("SharePanel")
        self.form.setWindowTitle(translate("Export for the web"))
        self.form.setWindowIcon(QtGui.QIcon(icon("share")))
        self.kind = NarrowCombo()
        self.kind.setObjectName("SharedKind")
        for text, kind in (
            (translate("Web page that turns the balloon (HTML)"), PAGE),
            (translate("3D model (GLB)"), GLB),
            (translate("Picture (PNG)"), PICTURE),
        ):
            self.kind.addItem(text, kind)
        self.ground = GroundRow()
        self.ground_name = QtWidgets.QLabel(translate("Ground"))
        self.file = TargetFile(parts.balloon.Document, "SharedFile", translate("Export for the web"))
        self.message = Message("ShareMessage")
        form = NarrowForm(self.form)
        for text, widget in ((translate("What"), self.kind), (translate("File"), self.file)):
            form.addRow(QtWidgets.QLabel(text))
            form.addRow(widget)
        form.addRow(self.ground_name)
        form.addRow(self.ground)
        form.addRow(self.message)
        self.kind.currentIndexChanged.connect(self.show_kind)
        self.ground.changed.connect(lambda: self.message.setText(""))
        self.show_kind()
        self.watch = Watch(parts, self.close)

    def show_kind(self, _index: int = 0) -> None:
        """Name the file of what is chosen."""
        kind = self.kind.currentData()
        for widget in (self.ground_name, self.ground):
            widget.setVisible(kind != GLB)
        usual = translate("White") if kind == PICTURE else translate("That of the page")
        self.ground.offer(usual, transparent=kind == PICTURE)
        self.message.setText("")
        self.file.suggest(f"{name_of(self.parts.balloon)}.{kind}")

    def accept(self):
        """Write the file; the panel stays with the reason when that fails."""
        kind = self.kind.currentData()
        objection = self.file.objection([self.file.path]) or (kind != GLB and self.ground.objection())
        if objection:
            self.message.setText(objection)
            return False
        ground = None if kind == GLB else self.ground.text()
        self.form.setEnabled(False)
        try:
            written = write_shared(self.parts, self.file.path, ground=ground)
        except BalloonError as error:
            if self.is_open:
                self.message.setText(translated(str(error)))
            return False
        finally:
            if self.is_open:
                self.form.setEnabled(True)
        balloon = f"BalloonWorkbench.parts({macro_recorder.obj(self.parts.balloon)})"
        options = {} if ground is None else {"ground": macro_recorder.text(ground)}
        macro_recorder.call("share", balloon, macro_recorder.text(written), **options)
        self.file.wrote()
        self.close()
        Gui.getMainWindow().statusBar().showMessage(translate("Written to {}").format(written), 8000)
        return True

    def reject(self):
        self.close()
        return True

    def close(self) -> None:
        self.is_open = False
        self.watch.remove()
        Gui.Control.closeDialog()

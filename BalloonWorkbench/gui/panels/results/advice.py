# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of advice: the findings about a balloon, where, and a button that mends it.

Choosing a finding marks its place in the 3D view. Each repair is one undo step of its own.
"""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui

from BalloonWorkbench.app.balloon import asks_for_many_panels
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.border.guard import Guarded
from BalloonWorkbench.app.engine import advice, repairs
from BalloonWorkbench.core.advice.as_data import repair_text
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.units import number_text, percent_text, to_mm
from BalloonWorkbench.gui.panels.widgets.narrow import FullList, WrappedLabel
from BalloonWorkbench.gui.panels.widgets.watch import Watch
from BalloonWorkbench.gui.qt import QtCore, QtGui, QtWidgets, drawn_icon, number_of, translate
from BalloonWorkbench.gui.view3d.marks import COLOURS, PlaceMarks
from BalloonWorkbench.gui.window import macro_recorder
from BalloonWorkbench.gui.window.borders import TaskPanel, undo_step
from BalloonWorkbench.gui.window.sentences import translated
from BalloonWorkbench.gui.window.user_units import length_text
from BalloonWorkbench.gui.wrapped_check import WrappedCheck

_DOT = 12  # px
_HIGHEST = 260  # px, of the list of findings


class AdvicePanel(TaskPanel):
    """Lists the findings about one balloon."""

    def __init__(self, parts):
        self.parts = parts
        self.doc = parts.balloon.Document
        self.listed: list = []
        self.is_open = True
        self.overlay = PlaceMarks(self.doc.Name)
        self.form = QtWidgets.QWidget()
        self.form.setObjectName("Advice")
        self.form.setWindowTitle(translate("Advice"))
        self.form.setWindowIcon(drawn_icon("advice"))
        self.source = WrappedLabel()
        self.source.setObjectName("AdviceSource")
        self.list = FullList(_HIGHEST)
        self.list.setObjectName("Findings")
        self.list.setAccessibleName(translate("Findings"))
        self.repair = QtWidgets.QPushButton()
        self.repair.setObjectName("Repair")
        self.map = WrappedCheck(translate("Expected thickness"))
        self.map.setObjectName("ThicknessMap")
        self.legend = WrappedLabel()
        self.legend.setObjectName("Legend")
        self.message = WrappedLabel()
        self.message.setObjectName("AdviceMessage")
        column = QtWidgets.QVBoxLayout(self.form)
        for widget in (self.source, self.list, self.repair, self.map, self.legend, self.message):
            column.addWidget(widget)
        self.list.currentRowChanged.connect(self.choose)
        self.map.setVisible(not asks_for_many_panels(parts.balloon))
        self.map.toggled.connect(lambda _checked: self.show_map())
        self.repair.clicked.connect(lambda _checked=False: self.make_repair())
        self.watch = Watch(parts, self.close)
        self.follow = _UndoWatch(self.doc.Name, self.refresh)
        App.addDocumentObserver(self.follow)
        self.refresh()

    # the dialog

    def getStandardButtons(self):
        return number_of(QtWidgets.QDialogButtonBox.Close)

    def isAllowedAlterDocument(self):
        return True

    def isAllowedAlterSelection(self):
        return True

    def isAllowedAlterView(self):
        return True

    def reject(self):
        self.close()
        return False

    def close(self):
        """Leave the document as it is."""
        self.is_open = False
        self.watch.remove()
        App.removeDocumentObserver(self.follow)
        self.overlay.clear()
        Gui.Control.closeDialog()

    # the work

    def refresh(self):
        """Look for findings again."""
        if not self.is_open:
            return
        self.overlay.clear()
        self.message.setText("")
        try:
            self.listed = advice.findings(self.parts)
            measured = status.is_ready(self.parts.balloon) and advice.is_solved(self.parts.balloon)
        except BalloonError as error:
            self.listed, measured = [], False
            self.message.setText(translated(str(error)))
        self.source.setText(self._source(measured))
        items = []
        for finding in self.listed:
            items.append(QtWidgets.QListWidgetItem(_dot(finding.severity.value), translated(finding.text)))
            items[-1].setToolTip(translated(finding.severity.value))
        self.list.blockSignals(True)
        self.list.clear()
        for item in items:
            self.list.addItem(item)
        self.list.blockSignals(False)
        self.list.fit()
        self.list.setVisible(bool(self.listed))
        self.repair.setVisible(bool(self.listed) and not asks_for_many_panels(self.parts.balloon))
        if not self.listed and not self.message.text():
            problem = status.problem(self.parts.outline)
            self.message.setText(translated(problem) or translate("Nothing to improve."))
        self.choose(self.list.currentRow())
        self.show_map()

    def _source(self, measured: bool) -> str:
        """Where the findings come from, and how full the shape becomes."""
        if measured:
            text, volume_share = translate("Measured on the inflated balloon."), self.parts.balloon.Puffiness
        elif self.message.text() or not status.is_ready(self.parts.outline):
            return ""
        else:
            text = translate("Predicted from the outline; not inflated yet.")
            volume_share = advice.advice_before(self.parts).relative_volume
        return f"{text} " + translate(
            "It holds {} of the air that a round balloon of as much film would."
        ).format(percent_text(volume_share))

    def show_map(self):
        """Colour the shape by the thickness predicted from its outline, or stop that."""
        self.overlay.clear("map")
        self.legend.setVisible(self.map.isChecked())
        if not self.map.isChecked() or not status.is_ready(self.parts.outline):
            return
        try:
            prediction = advice.advice_before(self.parts).map
        except BalloonError as error:
            self.legend.setText(translated(str(error)))
            return
        self.legend.setText(
            translate("Blue 0, green {}, red {}").format(
                *(length_text(to_mm(share * float(prediction.thickness.max())), 3) for share in (0.5, 1.0))
            )
        )
        self.overlay.map(prediction, self.parts.outline.Placement, self._height())

    def _height(self) -> float:
        """Of the balloon over its plane [mm]."""
        return 0.5 * self.parts.balloon.InflatedThickness.Value

    def choose(self, row: int):
        """Mark the place of a finding and offer its repair."""
        finding = self.listed[row] if 0 <= row < len(self.listed) else None
        repair = None if finding is None else finding.repair
        self.repair.setEnabled(repair is not None)
        self.repair.setText(translate("Repair") if repair is None else translated(repair_text(repair)))
        if finding is None:
            self.overlay.clear("mark")
            return
        if asks_for_many_panels(self.parts.balloon):
            balloon = self.parts.balloon
            self.overlay.mark(finding, balloon.Placement, 0.5 * balloon.Mesh.BoundBox.DiagonalLength, 0.0)
            return
        outline = self.parts.outline
        size = max(outline.SizeX.Value, outline.SizeY.Value)
        self.overlay.mark(finding, outline.Placement, size, self._height())

    def make_repair(self):
        """Make the edit and let the document follow, in one undo step."""
        finding = self.listed[self.list.currentRow()]
        repair = finding.repair
        self.overlay.clear()
        with undo_step(self.doc, translated(repair_text(repair))):
            repairs.take(self.parts, repair)
            self.doc.recompute()
            self.doc.commitTransaction()
        near = "({}, {})".format(*(number_text(to_mm(value), 4) for value in finding.place))
        balloon = f"BalloonWorkbench.parts({macro_recorder.obj(self.parts.balloon)})"
        macro_recorder.call("repair", balloon, macro_recorder.text(finding.rule), near=near)
        self.refresh()
        trouble = next((status.problem(obj) for obj in self.parts if not status.is_ready(obj)), "")
        if trouble:
            self.message.setText(translated(trouble))


class _UndoWatch(Guarded):
    """Calls `changed` after undo and redo in a document."""

    def __init__(self, name: str, changed):
        self._name = name
        self._changed = changed

    def slotUndoDocument(self, doc):
        self._later(doc)

    def slotRedoDocument(self, doc):
        self._later(doc)

    def _later(self, doc):
        if doc.Name == self._name:
            QtCore.QTimer.singleShot(0, self._changed)  # the document is amid its change


def _dot(severity: str):
    """A round icon in the colour of a severity."""
    picture = QtGui.QPixmap(_DOT, _DOT)
    picture.fill(QtCore.Qt.transparent)
    painter = QtGui.QPainter(picture)
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    painter.setPen(QtCore.Qt.NoPen)
    painter.setBrush(QtGui.QColor.fromRgbF(*COLOURS[severity]))
    painter.drawEllipse(1, 1, _DOT - 2, _DOT - 2)
    painter.end()
    return QtGui.QIcon(picture)

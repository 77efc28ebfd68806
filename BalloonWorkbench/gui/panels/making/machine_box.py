# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of the export panel about the machine: which one, its bed or paper, what it may find wrong.

Where the pattern is larger than the bed, it offers the ways on.
"""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace

import FreeCAD as App

from BalloonWorkbench.app.engine.export import check_for
from BalloonWorkbench.app.machines import bed
from BalloonWorkbench.app.properties import preferences
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.machines.contour.tabs import leaves_tabs
from BalloonWorkbench.core.machines.machine import NO_LIMIT, bed_text, left_out, machines, parse_bed
from BalloonWorkbench.core.machines.preflight import ERROR
from BalloonWorkbench.core.machines.writers.pdf import TILES
from BalloonWorkbench.core.options.making import REFUSE, SPLIT, WRITE
from BalloonWorkbench.core.units import LENGTH_UNITS
from BalloonWorkbench.gui.accessible import sign_button
from BalloonWorkbench.gui.panels.making.tab_row import TabRow
from BalloonWorkbench.gui.panels.widgets.fields import ReturnKey
from BalloonWorkbench.gui.panels.widgets.narrow import FullList, NarrowCombo, WrappedLabel
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate
from BalloonWorkbench.gui.view3d.marks import PlaceMarks
from BalloonWorkbench.gui.window.sentences import translated
from BalloonWorkbench.gui.window.user_units import bed_size_text, user_unit
from BalloonWorkbench.gui.wrapped_check import WrappedCheck

_HIGHEST = 160  # px, of the list of findings


class MachineBox(QtWidgets.QWidget):
    """Chooses a machine and its bed.

    `changed` follows each choice, `scaled` is the wish for a balloon that fits, `set_up` the one for other
    machines.
    """

    changed = QtCore.Signal()
    scaled = QtCore.Signal()
    set_up = QtCore.Signal()

    def __init__(self, document_name: str):
        super().__init__()
        for sentence in left_out():
            App.Console.PrintMessage(f"Film Balloon: {translated(sentence)}\n")
        self.known = list(machines().values())
        self.overlay = PlaceMarks(document_name)
        self.findings: tuple = ()
        self.pattern = None
        self.choice = NarrowCombo()
        self.choice.setObjectName("Machine")
        for known in self.known:
            self.choice.addItem(translated(known.title))
            self.choice.setItemData(self.choice.count() - 1, translated(known.note), QtCore.Qt.ToolTipRole)
        self.pages = QtWidgets.QComboBox()
        self.pages.setObjectName("Pages")
        self.pages.setAccessibleName(translate("Pages"))
        self.pages.addItems([translate("One large page"), *TILES])
        self.note = WrappedLabel()
        self.note.setObjectName("MachineNote")
        self.list = FullList(_HIGHEST)
        self.list.setObjectName("Preflight")
        self.list.setAccessibleName(translate("Before it is written"))
        self.bed = QtWidgets.QLineEdit()
        self.bed.setObjectName("Bed")
        self.bed.setMinimumWidth(60)
        self.bed.setPlaceholderText(translate("No limit"))
        self.bed.setToolTip(
            translate(
                "What this machine can work on, such as 600 x 400 mm, or 600 mm for a roll; empty where there"
                " is no limit. It is kept for this machine"
            )
        )
        bed_row = QtWidgets.QHBoxLayout()
        label = QtWidgets.QLabel(translate("Bed"))
        label.setBuddy(self.bed)
        bed_row.addWidget(label)
        bed_row.addWidget(self.bed, 1)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addLayout(self._choosing())
        for widget in (self.pages, self.note):
            column.addWidget(widget)
        column.addLayout(bed_row)
        self.tabs = TabRow()
        column.addWidget(self.tabs)
        column.addWidget(self.list)
        column.addWidget(self._ways_on())
        self.choice.currentIndexChanged.connect(lambda _index: self.changed.emit())
        self.bed.editingFinished.connect(self._take_bed)
        ReturnKey(self.bed, self._take_bed)
        self.tabs.changed.connect(self.changed.emit)
        self.tabs.refused.connect(self._refuse)
        self.list.currentRowChanged.connect(self.mark)
        self.show_for(None)

    def _choosing(self):
        """The choice, and a button beside it for machines that are not in it."""
        own = sign_button("…", translate("Set up machines of your own"))
        own.setObjectName("SetUpMachines")
        own.clicked.connect(lambda _checked=False: self.set_up.emit())
        row = QtWidgets.QHBoxLayout()
        row.addWidget(self.choice, 1)
        row.addWidget(own)
        return row

    def _ways_on(self):
        """What may be done about a pattern that is larger than the bed."""
        self.scale = QtWidgets.QPushButton(translate("Scale to fit"))
        self.scale.setObjectName("ScaleToFit")
        self.scale.setToolTip(
            translate(
                "Make the balloon smaller and inflate it again, until its pattern fits the bed. Weld and"
                " allowance keep their widths; one undo takes it back"
            )
        )
        self.write = WrappedCheck(translate("Write anyway"))
        self.write.setObjectName("WriteAnyway")
        self.write.setToolTip(translate("Write the file although it is larger than the bed"))
        self.split = WrappedCheck(translate("Split over beds"))
        self.split.setObjectName("SplitOverBeds")
        self.split.setToolTip(
            translate(
                "Write several files, each as large as the bed. Crosses in waste film tell how the film"
                " is laid on anew for the next one"
            )
        )
        self.write.toggled.connect(lambda on: on and self.split.setChecked(False))
        self.split.toggled.connect(lambda on: on and self.write.setChecked(False))
        self.why_not = WrappedLabel()
        self.why_not.setObjectName("WhyNotScaled")
        self.scale.clicked.connect(lambda _checked=False: self.scaled.emit())
        self.ways = QtWidgets.QWidget()
        column = QtWidgets.QVBoxLayout(self.ways)
        column.setContentsMargins(0, 0, 0, 0)
        for widget in (self.scale, self.why_not, self.split, self.write):
            column.addWidget(widget)
        return self.ways

    @property
    def machine(self):
        """The chosen machine, with the bed that the user has given it."""
        chosen = self.known[self.choice.currentIndex()]
        return replace(chosen, bed=preferences.bed(chosen))

    @property
    def own_bed(self) -> str | None:
        """The bed where it is another one than in the machine's file, as text; else None."""
        size = self.machine.bed
        return None if size == self.known[self.choice.currentIndex()].bed else bed_text(size)

    @property
    def oversize(self) -> str:
        """What becomes of a pattern that is larger than the bed."""
        if self.split.isChecked():
            return SPLIT
        return WRITE if self.write.isChecked() else REFUSE

    @property
    def paper(self) -> str | None:
        """The paper to divide the pattern on, or None for one page."""
        divided = self.pages.isVisibleTo(self) and self.pages.currentIndex() > 0
        return self.pages.currentText() if divided else None

    def choose(self, name: str, paper: str | None = None) -> None:
        """Take a machine by its name and, where it prints, the paper to divide the pattern on."""
        self.choice.setCurrentIndex([known.name for known in self.known].index(name))
        if paper is not None:
            self.pages.setCurrentText(paper)

    def show_for(self, pattern) -> None:
        """What the chosen machine makes of a pattern object."""
        self.pattern = pattern
        self.overlay.clear()
        self.list.clear()
        chosen = self.machine
        self.pages.setVisible(chosen.format == "pdf")
        self.bed.setText(bed_size_text(chosen.bed))
        self.tabs.setVisible(leaves_tabs(chosen))
        self.tabs.show_for(chosen.name)
        self.ways.hide()
        self.write.setChecked(False)
        self.split.setChecked(False)
        if pattern is None:
            return
        self.note.setText(translated(chosen.note))
        try:
            self.findings = check_for(pattern, chosen.name, self.own_bed, REFUSE, *self.tabs.texts)
        except BalloonError as error:
            self.findings = ()
            self.list.addItem(translated(str(error)))
            self.list.fit()
            return
        for finding in self.findings:
            word = translate("Not possible") if finding.severity == ERROR else translate("Mind")
            self.list.addItem(f"{word}: {translated(finding.text)}")
        if not self.findings:
            self.list.addItem(translate("Checked: ready to make."))
        self.list.fit()
        if any(finding.oversize for finding in self.findings):
            why_not = bed.hindrance(pattern)
            self.why_not.setText(translated(why_not))
            self.why_not.setVisible(bool(why_not))
            self.scale.setVisible(not why_not)
            self.ways.show()

    def mark(self, row: int) -> None:
        """Mark the place of a finding in the 3D view."""
        self.overlay.clear()
        if not 0 <= row < len(self.findings) or self.findings[row].place is None:
            return
        finding = self.findings[row]
        marked = SimpleNamespace(
            severity=SimpleNamespace(value="serious" if finding.severity == ERROR else "warning"),
            place=finding.place,
            extent=(),
        )
        size = max(self.pattern.PatternWidth.Value, self.pattern.PatternHeight.Value)
        self.overlay.mark(marked, self.pattern.Placement, size, 0.0)

    def _take_bed(self) -> None:
        """Keep a bed that was typed, for this machine."""
        if not self.bed.isModified():
            return
        self.bed.setModified(False)
        text = self.bed.text().replace(",", ".").strip()
        unit = user_unit("mm", 100.0)[1]
        try:
            size = parse_bed(text or NO_LIMIT, unit if unit in LENGTH_UNITS else "mm")
        except BalloonError as error:
            self._refuse(str(error))
            return
        preferences.put_bed(self.known[self.choice.currentIndex()], size)
        self.changed.emit()

    def _refuse(self, text: str) -> None:
        """Say what is wrong with a text that was typed."""
        self.list.insertItem(0, translated(text))
        self.list.fit()

    def release(self) -> None:
        """The panel closes."""
        self.overlay.clear()
        self.pattern = None

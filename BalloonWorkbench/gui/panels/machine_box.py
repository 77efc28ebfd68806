# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of the export panel about the machine: which one, on which paper, and what it may find wrong."""

from __future__ import annotations

from types import SimpleNamespace

import FreeCAD as App

from BalloonWorkbench.app.export import check_for
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.export.machine import left_out, machines
from BalloonWorkbench.core.export.machine_pdf import TILES
from BalloonWorkbench.core.export.preflight import ERROR
from BalloonWorkbench.gui.marks import Overlay
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate
from BalloonWorkbench.gui.sentences import tell


class MachineBox(QtWidgets.QWidget):
    """Chooses a machine. `changed` follows each choice."""

    changed = QtCore.Signal()

    def __init__(self, document_name: str):
        super().__init__()
        for sentence in left_out():
            App.Console.PrintMessage(f"Film Balloon: {tell(sentence)}\n")
        self.known = list(machines().values())
        self.overlay = Overlay(document_name)
        self.findings: tuple = ()
        self.pattern = None
        self.choice = QtWidgets.QComboBox()
        self.choice.setObjectName("Machine")
        self.choice.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        for known in self.known:
            self.choice.addItem(tell(known.title))
            self.choice.setItemData(self.choice.count() - 1, tell(known.note), QtCore.Qt.ToolTipRole)
        self.pages = QtWidgets.QComboBox()
        self.pages.setObjectName("Pages")
        self.pages.addItems([translate("One large page"), *TILES])
        self.note = QtWidgets.QLabel()
        self.note.setObjectName("MachineNote")
        self.note.setWordWrap(True)
        self.list = QtWidgets.QListWidget()
        self.list.setObjectName("Preflight")
        self.list.setWordWrap(True)
        self.list.setMaximumHeight(120)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        for widget in (self.choice, self.pages, self.note, self.list):
            column.addWidget(widget)
        self.choice.currentIndexChanged.connect(lambda _index: self.changed.emit())
        self.list.currentRowChanged.connect(self.mark)
        self.show_for(None)

    @property
    def machine(self):
        """The chosen machine."""
        return self.known[self.choice.currentIndex()]

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
        if pattern is None:
            return
        self.note.setText(tell(chosen.note))
        try:
            self.findings = check_for(pattern, chosen.name)
        except BalloonError as error:
            self.findings = ()
            self.list.addItem(tell(str(error)))
            return
        for finding in self.findings:
            word = translate("Not possible") if finding.severity == ERROR else translate("Mind")
            self.list.addItem(f"{word}: {tell(finding.text)}")
        if not self.findings:
            self.list.addItem(translate("Checked: ready to make."))

    def mark(self, row: int) -> None:
        """Mark the place of a finding in the 3D view."""
        self.overlay.clear()
        if not 0 <= row < len(self.findings) or self.findings[row].place is None:
            return
        finding = self.findings[row]
        shown = SimpleNamespace(
            severity=SimpleNamespace(value="serious" if finding.severity == ERROR else "warning"),
            place=finding.place,
            extent=(),
        )
        size = max(self.pattern.PatternWidth.Value, self.pattern.PatternHeight.Value)
        self.overlay.mark(shown, self.pattern.Placement, size, 0.0)

    def release(self) -> None:
        """The panel closes."""
        self.overlay.clear()
        self.pattern = None

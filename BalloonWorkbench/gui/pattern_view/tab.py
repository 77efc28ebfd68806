# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tab with the pieces of an object: follows its recomputes, and goes with it and with its document."""

from __future__ import annotations

import math
from functools import partial

import FreeCAD as App
import FreeCADGui as Gui

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.border.guard import Guarded
from BalloonWorkbench.app.document.kinds import is_pattern
from BalloonWorkbench.app.document.parts import panels_of
from BalloonWorkbench.app.engine.cut_sheet import pieces
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.geometry.polyline import length
from BalloonWorkbench.core.units import to_mm
from BalloonWorkbench.gui.pattern_view.piece_view import PieceView
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, drawn_icon, translate
from BalloonWorkbench.gui.window.selection import select_behind
from BalloonWorkbench.gui.window.sentences import translated
from BalloonWorkbench.gui.window.user_units import length_text

#: What has changed when the pieces have, or what is said of them.
_TELLING = ("Shape", "Status", "Label")
_PATIENCE = 100  # ms between two looks at a document that is being recomputed
_tabs: list[PatternTab] = []
_watching: list[_DocumentWatch] = []


def open_tab(obj) -> PatternTab:
    """The tab of a pattern or a sheet of film, in front; made where there is none."""
    if not _watching:
        _watching.append(_DocumentWatch())
        App.addDocumentObserver(_watching[0])
    area = Gui.getMainWindow().findChild(QtWidgets.QMdiArea)
    tab = next((each for each in _tabs if each.obj == obj), None)
    if tab is None:
        tab = PatternTab(obj)
        _tabs.append(tab)
        frame = area.addSubWindow(tab)
        frame.setAttribute(QtCore.Qt.WA_DeleteOnClose)
        frame.setWindowIcon(drawn_icon("pattern_view"))
        frame.showMaximized()
    area.setActiveSubWindow(tab.parentWidget())
    tab.view.setFocus()
    return tab


class PatternTab(QtWidgets.QWidget):
    """The pieces, a bar above them, and a line that tells what is picked or measured."""

    def __init__(self, obj):
        super().__init__()
        self.setObjectName("PatternTab")
        self.obj = obj  # None: it is gone
        self.view = PieceView()
        self.view.picked.connect(self.pick)
        self.view.measured.connect(self._tell_measure)
        self.view.measuring_changed.connect(self._tell_tool)
        self.line = QtWidgets.QLabel()
        self.line.setObjectName("PatternLine")
        self.line.setWordWrap(True)
        self.line.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self._bar())
        column.addWidget(self.view, 1)
        column.addWidget(self.line)
        self._soon = QtCore.QTimer(self)
        self._soon.setSingleShot(True)
        self._soon.timeout.connect(self.follow)
        self.follow()

    def _bar(self):
        bar = QtWidgets.QToolBar()
        fit = bar.addAction(drawn_icon("paint_fit"), translate("Show all pieces (0)"))
        fit.setObjectName("FitPieces")
        fit.triggered.connect(lambda _checked=False: self.view.fit())
        self.measuring = bar.addAction(drawn_icon("pattern_measure"), translate("Measure (M)"))
        self.measuring.setObjectName("MeasurePieces")
        self.measuring.setCheckable(True)
        self.measuring.toggled.connect(self.view.set_measuring)
        self.view.measuring_changed.connect(self.measuring.setChecked)
        return bar

    # the document

    def changed(self) -> None:
        """The object is another one now: it is looked at when FreeCAD is done with it."""
        self._soon.start(0)

    def follow(self) -> None:
        """Show the pieces as they are now; the old ones stay where there are none, and it is told why."""
        if self.obj is None:
            return
        if self.obj.Document.Recomputing:
            self._soon.start(_PATIENCE)
            return
        self.setWindowTitle(translate("{}: {}, flat").format(self.obj.Document.Label, self.obj.Label))
        problem = status.problem(self.obj)
        try:
            drawn = None if problem else pieces(self.obj)
        except BalloonError as error:
            drawn, problem = None, str(error)
        if self.obj is None:
            return  # deleted while they were drawn
        if drawn is not None and drawn is not self.view.pieces:
            self.view.show_pieces(drawn)
        if problem:
            self.line.setText(translated(problem))
        else:
            self._tell_tool(self.view.measuring)

    def leave(self) -> None:
        """The object is being deleted: the tab closes when FreeCAD is done with that."""
        self.obj = None
        self._soon.stop()
        QtCore.QTimer.singleShot(0, partial(_close, self))

    def closeEvent(self, event):
        self.obj = None
        if self in _tabs:
            _tabs.remove(self)
        super().closeEvent(event)

    # what is picked and measured

    def pick(self, number: int | None) -> None:
        """Light an edge and its partner, and tell of them; None: nothing.

        In the active document the piece is selected too: in others FreeCAD would show their 3D view.
        """
        if self.obj is None or self.view.pieces is None:
            return
        if number is None:
            self.view.scene().light([])
            self._tell_tool(self.view.measuring)
            return
        partner = self.view.pieces.partner(number)
        self.view.scene().light([number] if partner is None else [number, partner])
        self.line.setText(self._text_of(number, partner))
        if self.obj.Document == App.ActiveDocument:
            select_behind(_object_of(self.obj, self.view.pieces.edges[number].piece + 1))

    def _text_of(self, number: int, partner: int | None) -> str:
        own = self._named(number)
        if partner is not None:
            seam = self.view.pieces.edges[number].seam
            return translate("Seam {}: {}; {}").format(seam, own, self._named(partner))
        seam = self.view.pieces.edges[number].seam
        return translate("Open edge: {}").format(own) if seam else translate("Weld: {}").format(own)

    def _named(self, number: int) -> str:
        edge = self.view.pieces.edges[number]
        name = translated(self.view.pieces.pieces[edge.piece].name)
        return f"{name}, {length_text(to_mm(length(edge.line)))}"

    def _tell_measure(self, places) -> None:
        across, up = to_mm(abs(places[1] - places[0])).tolist()
        texts = map(length_text, (math.hypot(across, up), across, up))
        self.line.setText(translate("Distance {}, across {}, up {}").format(*texts))

    def _tell_tool(self, measuring: bool) -> None:
        if measuring:
            self.line.setText(translate("Click two points to measure between them."))
        else:
            self.line.setText(translate("Click an edge to see what it is sealed to."))


def _object_of(obj, number: int):
    """The document object of a piece by its number from 1: its Panel, else the object that has them all."""
    panels = panels_of(obj) if is_pattern(obj) else []
    return next((panel for panel in panels if panel.Number == number), obj)


def _close(tab: PatternTab) -> None:
    frame = tab.parentWidget() if tab in _tabs else None
    if frame is not None:
        frame.close()


class _DocumentWatch(Guarded):
    """Told by FreeCAD what changes and what goes."""

    def slotChangedObject(self, obj, name) -> None:
        for tab in _of(obj) if name in _TELLING else ():
            tab.changed()

    def slotDeletedObject(self, obj) -> None:
        for tab in _of(obj):
            tab.leave()

    def slotDeletedDocument(self, document) -> None:
        for tab in [each for each in _tabs if each.obj is not None and each.obj.Document == document]:
            tab.leave()


def _of(obj) -> list[PatternTab]:
    return [tab for tab in _tabs if tab.obj == obj]

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tab with the pieces of an object: follows its recomputes, and goes with it and with its document."""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.border.guard import Guarded
from BalloonWorkbench.app.document.kinds import is_artwork, is_panel, is_pattern
from BalloonWorkbench.app.document.parts import panels_of
from BalloonWorkbench.app.engine.export import print_pieces
from BalloonWorkbench.app.shapes import piece_places
from BalloonWorkbench.core.arrangement.arrangement import LaidPieces
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.gui.paint.painting.lengths import is_imperial
from BalloonWorkbench.gui.pattern_view import arranging, texts
from BalloonWorkbench.gui.pattern_view.looks import PieceLooks
from BalloonWorkbench.gui.pattern_view.picks import Pick, pick_at
from BalloonWorkbench.gui.pattern_view.piece_view import PieceView
from BalloonWorkbench.gui.pattern_view.seam_lights import SeamLights
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, drawn_icon, translate
from BalloonWorkbench.gui.tabs.document_tab import DocumentTab, TabWatch, column_in, tab_of, telling_line
from BalloonWorkbench.gui.window import macro_recorder
from BalloonWorkbench.gui.window.file_dialogs import ask_where_to_write
from BalloonWorkbench.gui.window.selection import select_behind
from BalloonWorkbench.gui.window.sentences import translated

_SETTLES = 100  # ms until the lights of new pieces are prepared
_tabs: list[PatternTab] = []
_watching: list = []


def open_tab(obj) -> PatternTab:
    """The tab of a pattern or a sheet of film, in front; made where there is none."""
    if not _watching:
        _watching.extend((_PiecesWatch(_tabs), _PickWatch()))
        App.addDocumentObserver(_watching[0])
        Gui.Selection.addObserver(_watching[1])
    return tab_of(obj, _tabs, PatternTab, "pattern_view")


class PatternTab(DocumentTab):
    """The pieces, a bar above them, and a line that tells what is picked or measured."""

    SHOWN = (*DocumentTab.SHOWN, *piece_places.NAMES)

    def __init__(self, obj):
        super().__init__(obj, _tabs)
        self.setObjectName("PatternTab")
        self.lights = SeamLights(obj) if is_pattern(obj) else None
        self.view = PieceView()
        self.view.setAccessibleName(translate("Flat pieces"))
        self.view.picked.connect(self.pick)
        self.view.chosen.connect(self.choose)
        self.view.measured.connect(lambda places: self.say(texts.measure_text(places)))
        self.view.measuring_changed.connect(self._tell_tool)
        self.view.laid_out.connect(self._lay)
        self.view.undone.connect(self._undo)
        self.looks = PieceLooks(self.view.scene())
        self.looks.said.connect(self.say)
        self.line = telling_line("PatternLine")
        column = column_in(self)
        column.addWidget(self._bar())
        beside = QtWidgets.QHBoxLayout()
        beside.addWidget(self.view, 1)
        beside.addWidget(self.looks.legend)
        column.addLayout(beside, 1)
        column.addWidget(self.line)
        self._kept = None  # the Arrangement in which the pieces are shown
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
        self.reset = bar.addAction(translate("Lay out anew"))
        self.reset.setObjectName("ResetPieces")
        self.reset.setToolTip(translate("Let all pieces lie as the pattern lays them"))
        self.reset.triggered.connect(lambda _checked=False: arranging.reset(self.obj))
        self.reset.setVisible(is_pattern(self.obj))
        printing = bar.addAction(translate("Print"))
        printing.setObjectName("PrintPieces")
        printing.setToolTip(
            translate("Write the pieces as they lie, and the artwork if it is shown, to a PDF in real size")
        )
        printing.triggered.connect(lambda _checked=False: self._print())
        for action in bar.actions():
            bar.widgetForAction(action).setFocusPolicy(QtCore.Qt.TabFocus)
        bar.addSeparator()
        bar.addWidget(self.looks.list).setVisible(is_pattern(self.obj))
        return bar

    def _print(self) -> None:
        """Write the pieces as they lie to a PDF, in real size on pages that any printer takes."""
        if self.obj is None:
            return
        try:
            path = ask_where_to_write(
                self, translate("Print the pieces"), self.obj.Document, "pieces", {"pdf": "PDF"}
            )
            if path is not None:
                paper = "Letter" if is_imperial() else "A4"
                artwork = self.looks.artwork
                print_pieces(self.obj, path, paper, artwork)
                macro_recorder.call(
                    "print_pieces",
                    macro_recorder.obj(self.obj),
                    macro_recorder.text(path),
                    macro_recorder.text(paper),
                    **({} if artwork is None else {"artwork": macro_recorder.obj(artwork)}),
                )
                self.say(
                    translate("Written to {}, in real size on {}: print it at 100 %.").format(path, paper)
                )
        except BalloonError as error:
            self.say(translated(str(error)))

    def say(self, text: str) -> None:
        """Say something in the line, also to those who do not see it."""
        self.line.setText(text)
        self.view.setAccessibleDescription(text)

    # the document

    def show_object(self) -> None:
        """Show the pieces as they are now; the old ones stay where there are none, and it is told why."""
        self.setWindowTitle(translate("{}: {}, flat").format(self.obj.Document.Label, self.obj.Label))
        problem = status.problem(self.obj)
        try:
            laid = None if problem else piece_places.laid(self.obj)
        except BalloonError as error:
            laid, problem = None, str(error)
        if self.obj is None:
            return  # deleted while they were drawn
        if laid is not None:
            self._show(laid)
        if problem:
            self.say(translated(problem))
        elif laid is not None and (changes := texts.changes_text(laid)):
            self.say(changes)
        else:
            self._tell_what_is_picked()

    def _show(self, laid: LaidPieces) -> None:
        kept = piece_places.kept(self.obj)
        others = self.view.laid is None or laid.base is not self.view.laid.base
        if others or kept != self._kept:
            self._kept = kept
            self.view.show_pieces(laid, arranging.grains(self.obj, laid), is_pattern(self.obj))
            self.reset.setEnabled(bool(kept.places))
        if others:
            self.looks.forget()
            QtCore.QTimer.singleShot(_SETTLES, self._prepare)
        if self.lights is not None:
            self.lights.clear()
            if self.view.edge is not None:  # the balloon may have another shape now
                self.lights.show(laid.base, self.view.edge)
        self.looks.follow(self.obj, laid.base)

    def _prepare(self) -> None:
        if self.obj is not None and self.lights is not None and not self.obj.Document.Recomputing:
            self.lights.prepare(self.view.laid.base)

    def let_go(self) -> None:
        """Nothing of the balloon is lit any longer."""
        if self.lights is not None:
            self.lights.clear()

    # what is picked, laid and measured

    def pick(self, number: int | None) -> None:
        """Light an edge, its partner and their place on the balloon, and tell of them; None: nothing."""
        if self._light(number):
            self._select()

    def choose(self, number: int) -> None:
        """Choose a piece, for keys and the handle."""
        if self._choose(number):
            self._select()

    def meant(self, pick: Pick) -> None:
        """Something is picked in the 3D view: the same is shown here."""
        if self.view.laid is None or not is_pattern(self.obj):
            return
        edge, piece = pick_at(self.obj, self.view.laid.base, self.lights, pick)
        if edge is not None:
            self._light(edge)
        elif piece is not None:
            self._choose(piece)

    def _light(self, number: int | None) -> bool:
        if self.obj is None or self.view.laid is None:
            return False
        if self.lights is not None:
            self.lights.clear()
        partner = None if number is None else self.view.pieces.partner(number)
        self.view.light([each for each in (number, partner) if each is not None])
        self.view.choose(None if number is None else self.view.pieces.edges[number].piece)
        if number is not None and self.lights is not None:
            self.lights.show(self.view.laid.base, number)
        self._tell_what_is_picked()
        return number is not None

    def _choose(self, number: int) -> bool:
        if not self._light(None) and self.view.laid is None:
            return False
        self.view.choose(number)
        self._tell_what_is_picked()
        return True

    def _select(self) -> None:
        """Select the piece in FreeCAD, in the active document: in others it would show their 3D view."""
        if self.obj.Document == App.ActiveDocument:
            _PickWatch.own = True
            select_behind(_object_of(self.obj, self.view.piece + 1))
            _PickWatch.own = False

    def _lay(self, number: int, place) -> None:
        if self.obj is not None and arranging.lay(self.obj, self.view.laid, number, place):
            self.follow()
        else:
            self.view.show_pieces(self.view.laid, self.view.grains, self.view.movable)

    def _undo(self, back: bool) -> None:
        if self.obj is not None:
            arranging.undo(self.obj.Document, back)

    def _tell_what_is_picked(self) -> None:
        view = self.view
        if view.measuring or view.laid is None or view.piece is None:
            self._tell_tool(view.measuring)
        elif view.edge is not None:
            self.say(texts.edge_text(view.laid, view.edge, view.pieces.partner(view.edge)))
        else:
            self.say(texts.piece_text(view.laid, view.piece, view.grains[view.piece]))

    def _tell_tool(self, measuring: bool) -> None:
        if measuring:
            self.say(translate("Click two points to measure between them."))
        elif is_pattern(self.obj):
            self.say(translate("Click an edge to see what it is sealed to, drag a piece to move it."))
        else:
            self.say(translate("Click an edge to see what it is sealed to."))


def _object_of(obj, number: int):
    """The document object of a piece by its number from 1: its Panel, else the object that has them all."""
    panels = panels_of(obj) if is_pattern(obj) else []
    return next((panel for panel in panels if panel.Number == number), obj)


class _PiecesWatch(TabWatch):
    """A pattern is shown with what is printed on it."""

    def slotChangedObject(self, obj, name) -> None:
        super().slotChangedObject(obj, name)
        self._print_changed(obj)

    def slotDeletedObject(self, obj) -> None:
        super().slotDeletedObject(obj)
        self._print_changed(obj)

    def _print_changed(self, obj) -> None:
        for tab in self.tabs if is_artwork(obj) else ():
            if tab.obj is not None and obj.Pattern == tab.obj:
                tab.looks.forget()
                tab.changed()


class _PickWatch(Guarded):
    """Told by FreeCAD what is picked in the 3D view."""

    own = False  # a tab selects what was picked in it

    def addSelection(self, document, name, element="", place=(0.0, 0.0, 0.0)) -> None:
        if _PickWatch.own or not _tabs:
            return
        obj = App.getDocument(document).getObject(name)
        for tab in [each for each in _tabs if each.obj is not None and obj is not None]:
            owner = obj.Pattern if is_panel(obj) else obj
            if owner in (tab.obj, getattr(tab.obj, "Balloon", None)):
                tab.meant(Pick(obj, element, tuple(place)))

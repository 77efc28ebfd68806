# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tab in which an outline is edited: each edit is one undo step of the document, which follows at once
as far as the outline, and with its balloon when the tab closes."""

from __future__ import annotations

from contextlib import suppress
from functools import partial

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document.parts import parts_of
from BalloonWorkbench.app.drawings.drawing_file import stretched
from BalloonWorkbench.app.outline import edited, read_plain, reading_of, trace
from BalloonWorkbench.app.properties.property_table import write_options
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.options.drawing import TracingOptions
from BalloonWorkbench.core.outline.drawing import Drawing
from BalloonWorkbench.core.outline_edits.apply_edits import (
    EditedDrawing,
    EditFrame,
    appended,
    axes_of,
    edits_of_nodes,
    node_edit,
    unchecked,
    with_edit,
)
from BalloonWorkbench.core.outline_edits.edit import ADD, MOVE, REMOVE, ROUND, SHARP, edit_text, edits_of
from BalloonWorkbench.core.outline_edits.nodes import CORNER
from BalloonWorkbench.gui.outline_editor.node_view import NodeView
from BalloonWorkbench.gui.outline_editor.retracing import Retracing
from BalloonWorkbench.gui.outline_editor.tracing_sliders import TracingSliders
from BalloonWorkbench.gui.panels.widgets.drawing_preview import notes_of
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, drawn_icon, translate
from BalloonWorkbench.gui.tabs.document_tab import DocumentTab, TabWatch, column_in, tab_of, telling_line
from BalloonWorkbench.gui.window import macro_recorder
from BalloonWorkbench.gui.window.sentences import translated

_NOWHERE = np.zeros(2)
_tabs: list[OutlineTab] = []
_watching: list[TabWatch] = []


def open_tab(obj, page=None) -> OutlineTab:
    """The tab of an outline that has a drawing, in front; made where there is none.

    page  of an open task panel, whose undo step the edits are part of: its `changed` is emitted after each
    """
    if not _watching:
        _watching.append(TabWatch(_tabs))
        App.addDocumentObserver(_watching[0])
    tab = tab_of(obj, _tabs, OutlineTab, "edit_outline")
    if page is not None:
        tab.join(page)
    return tab


class OutlineTab(DocumentTab):
    """The nodes over the picture, a bar above them, and a line that tells what can be done or went wrong."""

    SHOWN = (*DocumentTab.SHOWN, "OutlineEdits")

    def __init__(self, obj):
        super().__init__(obj, _tabs)
        self.setObjectName("OutlineTab")
        self._page = None  # of the open task panel that edits are part of
        self.state: EditedDrawing | None = None
        self._drawing: Drawing | None = None  # before its edits
        self._edit = macro_recorder.Edit(parts_of(obj)) if parts_of(obj) else None
        self._past: list[tuple] = []  # what was before each step that is part of an open panel's
        self._future: list[tuple] = []
        self.view = NodeView()
        self.line = telling_line("OutlineLine")
        column = column_in(self)
        column.addWidget(self._bar())
        self.sliders = TracingSliders()
        self.retracing = Retracing(self)
        row = QtWidgets.QHBoxLayout()
        row.setSpacing(0)
        row.addWidget(self.sliders)
        row.addWidget(self.view, 1)
        column.addLayout(row, 1)
        column.addWidget(self.line)
        self._connect()
        self.follow()

    def _bar(self):
        bar = QtWidgets.QToolBar()
        bar.setToolButtonStyle(QtCore.Qt.ToolButtonTextBesideIcon)
        for name, icon, text, act in (
            ("FitOutline", "paint_fit", translate("Show all (0)"), self.view.fit),
            ("UndoNodes", "paint_undo", translate("Undo"), self.undo),
            ("RedoNodes", "paint_redo", translate("Redo"), self.redo),
            ("RemoveNodes", "node_remove", translate("Remove (Del)"), lambda: self._chosen(self.remove)),
            ("ToggleNodes", "node_sharp", translate("Sharp or round (S)"), lambda: self._chosen(self.toggle)),
        ):
            action = bar.addAction(drawn_icon(icon), text)
            action.setObjectName(name)
            action.triggered.connect(partial(_call, act))
        self.both = bar.addAction(drawn_icon("paint_mirror"), translate("Both sides"))
        self.both.setObjectName("BothSides")
        self.both.setCheckable(True)
        self.both.setChecked(True)
        self.both.setToolTip(translate("Of a symmetric outline the other side is edited, too"))
        done = bar.addAction(drawn_icon("edit_outline"), translate("Done (Esc)"))
        done.setObjectName("DoneNodes")
        done.triggered.connect(lambda _checked=False: self.close_tab())
        for action in bar.actions():
            bar.widgetForAction(action).setFocusPolicy(QtCore.Qt.TabFocus)
        return bar

    def _connect(self) -> None:
        view = self.view
        view.moved.connect(self.move)
        view.dragged.connect(self._show_dragged)
        view.added.connect(self.add)
        view.removed.connect(self.remove)
        view.toggled.connect(self.toggle)
        view.undone.connect(self.undo)
        view.redone.connect(self.redo)
        view.left.connect(self.close_tab)
        self.sliders.asked.connect(self.retrace)
        self.retracing.ended.connect(self._traced)

    # the document

    def show_object(self) -> None:
        """Show the outline as it is now; the old one stays where there is none, and it is told why."""
        self.setWindowTitle(translate("{}: {}, nodes").format(self.obj.Document.Label, self.obj.Label))
        try:
            trace(self.obj)
            drawing, _ = read_plain(self.obj)
            state = edited(self.obj, drawing)
        except BalloonError as error:
            self.fail(error)
            return
        if self.obj is None:
            return
        self.sliders.show_values(reading_of(self.obj)[2])
        self.view.show_picture("" if drawing.canvas is None else self.obj.Drawing, drawing.canvas)
        if state is self.state and self.view.is_settled:
            return
        self.sliders.setVisible(drawing.canvas is not None)
        self.state, self._drawing = state, drawing
        self.both.setEnabled(bool(axes_of(drawing)))
        self.view.show_nodes(state.nodes, [np.array(each) for each in self.view.chosen])
        self._show_line()

    def _show_line(self) -> None:
        problem = status.problem(self.obj)
        sentences = [translated(each) for each in (*self.state.left_out, problem) if each]
        hint = translate("Click the line for a new node; drag nodes; Delete removes them; S: sharp or round.")
        self.line.setText("\n".join(sentences or [hint]))
        self.line.setToolTip(notes_of(self.obj))

    def fail(self, error: BalloonError) -> None:
        """Say what went wrong; the outline stays."""
        self.line.setText(translated(str(error)))

    def let_go(self) -> None:
        """Nothing is traced any longer."""
        self.retracing.stop()

    def closed(self, obj) -> None:
        """The balloon follows when the tab is gone."""
        QtCore.QTimer.singleShot(0, partial(_finish, obj.Document.Name, obj.Name, self._edit))

    def join(self, page) -> None:
        """Edits are part of what is done in the task panel of a page."""
        if self._page is not page:
            self._leave_panel()
            self._page = page
            page.destroyed.connect(self._leave_panel)

    def _leave_panel(self, *_page) -> None:
        self._page = None
        self._past.clear()
        self._future.clear()

    # edits

    def move(self, places, by) -> None:
        """Nodes go by a vector."""
        self._do(lambda: self._of_nodes(MOVE, places, by), [place + by for place in places])

    def add(self, place) -> None:
        """A new node on the line."""
        self._do(lambda: (node_edit(self.state.nodes, ADD, place, mirrored=self._mirrored),), [place])

    def remove(self, places) -> None:
        """Nodes go; a hole that keeps too few is filled."""
        self._do(lambda: self._of_nodes(REMOVE, places, _NOWHERE), [])

    def toggle(self, places) -> None:
        """Nodes become sharp; where all are, round."""
        kinds = [kind for loop in self.state.nodes.loops for kind in loop.kinds[loop.nodes]]
        points = np.concatenate([loop.points[loop.nodes] for loop in self.state.nodes.loops])
        own = [kinds[int(np.argmin(np.linalg.norm(points - place, axis=1)))] for place in places]
        kind = ROUND if all(each == CORNER for each in own) else SHARP
        self._do(lambda: self._of_nodes(kind, places, _NOWHERE), places)

    def undo(self) -> None:
        """Take the last step back: FreeCAD's own, or of an open task panel the last edit."""
        self._step(self._past, self._future, "undo")

    def redo(self) -> None:
        """Do it once more."""
        self._step(self._future, self._past, "redo")

    def _chosen(self, act) -> None:
        if self.view.chosen:
            act([np.array(each) for each in self.view.chosen])
        self.view.setFocus()

    @property
    def _mirrored(self) -> bool:
        return self.both.isChecked() and self.both.isEnabled()

    def _of_nodes(self, kind: str, places, by):
        return edits_of_nodes(self.state.nodes, kind, places, by, axes_of(self._drawing), self._mirrored)

    def _show_dragged(self, places, by) -> None:
        nodes = self.state.nodes
        with suppress(BalloonError):
            for edit in self._of_nodes(MOVE, places, by):
                nodes = unchecked(nodes, edit, axes_of(self._drawing))
        self.view.show_dragged(nodes)

    def _do(self, make, chosen) -> None:
        """Make edits and keep them, if they leave an outline; then these places are picked."""
        if self.obj is None or self.state is None:
            return
        nodes, frame, kept = self.state.nodes, EditFrame.of(self._drawing), edits_of(self.obj.OutlineEdits)
        try:
            edits = make()
            for edit in edits:
                nodes = with_edit(nodes, edit, axes_of(self._drawing))
                kept = appended(kept, frame.kept(edit))
        except BalloonError as error:
            self.view.show_nodes(self.state.nodes, [np.array(each) for each in self.view.chosen])
            self.fail(error)
            return
        self.view.chosen = [(float(place[0]), float(place[1])) for place in chosen]
        if edits:
            self._write([edit_text(edit) for edit in kept], self._now()[1])

    def retrace(self, tracing, keep: bool) -> None:
        """Trace the picture in another way: to look at, or to keep."""
        if self.obj is not None:
            self.retracing.ask(self.obj, tracing, keep)

    def _traced(self, worker) -> None:
        if self.obj is None:
            return
        if worker.error is not None:
            self.fail(worker.error)
        elif worker.request.keep:
            if worker.request.tracing != self._now()[1]:
                self._write(list(self.obj.OutlineEdits), worker.request.tracing)
        else:
            drawing = worker.design[0]
            drawing = drawing if self.obj.KeepAspect else stretched(drawing, worker.request.size)
            self.view.show_dragged(edited(self.obj, drawing).nodes)

    def _now(self) -> tuple:
        """The edits, and how the picture is traced."""
        return list(self.obj.OutlineEdits), reading_of(self.obj)[2]

    def _write(self, texts: list[str], tracing) -> None:
        doc, in_panel = self.obj.Document, Gui.Control.activeDialog()
        if in_panel:
            self._past.append(self._now())
            self._future.clear()
        else:
            self._leave_panel()
            doc.openTransaction(translate("Edit outline"))
        self._put(texts, tracing)
        if not in_panel and self.obj is not None:
            doc.commitTransaction()

    def _put(self, texts: list[str], tracing) -> None:
        """Give the outline its edits and how it is traced, and show what comes of it."""
        self.obj.OutlineEdits = texts
        write_options(self.obj, tracing, TracingOptions)
        others = (each for each in self.obj.InList if getattr(each, "Leader", None) == self.obj)
        self.obj.Document.recompute([self.obj, *others])
        self.follow()
        if Gui.Control.activeDialog() and self._page is not None:
            self._page.changed.emit()

    def _step(self, back: list, on: list, action: str) -> None:
        if self.obj is None:
            return
        if not Gui.Control.activeDialog():
            self._leave_panel()
            getattr(self.obj.Document, action)()
            self.changed()
        elif back:
            on.append(self._now())
            self._put(*back.pop())


def _call(act, _checked: bool = False) -> None:
    act()


def _finish(document: str, name: str, edit) -> None:
    """The tab was closed: what follows the outline is brought up to date, unless a panel does that."""
    doc = App.listDocuments().get(document)
    obj = doc.getObject(name) if doc is not None else None
    if obj is None or Gui.Control.activeDialog():
        return
    if edit is not None:
        edit.write()
    if any("Touched" in each.State for each in doc.Objects):
        doc.openTransaction(translate("Edit outline"))
        doc.recompute()
        doc.commitTransaction()

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of a balloon: drawing, film and pressure, pattern, simulation, result.

The objects exist while the panel is open, inside one undo step: OK keeps it, Cancel takes it back.
The engine works in a thread; the document is touched in the main thread alone.
"""

from __future__ import annotations

from contextlib import contextmanager
from functools import partial
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui

from BalloonWorkbench.app import balloon as balloon_object
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.document.kinds import is_bag, is_gored_body, is_target, leader
from BalloonWorkbench.app.document.parts import Parts, companions
from BalloonWorkbench.app.engine.solve import Request
from BalloonWorkbench.app.group import name_group
from BalloonWorkbench.app.properties.property_table import QT_TRANSLATE_NOOP
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.gui.long_work.blocking import breathe
from BalloonWorkbench.gui.long_work.worker import Worker
from BalloonWorkbench.gui.panels.balloon.draft import DraftView
from BalloonWorkbench.gui.panels.balloon.file_box import FileBox
from BalloonWorkbench.gui.panels.balloon.film_box import FilmBox
from BalloonWorkbench.gui.panels.balloon.pattern_box import PatternBox
from BalloonWorkbench.gui.panels.balloon.result_box import ResultBox, file_of, has_source
from BalloonWorkbench.gui.panels.balloon.simulation_box import SimulationBox
from BalloonWorkbench.gui.panels.balloon.sketch_box import SketchBox
from BalloonWorkbench.gui.panels.bodies.bag_box import BagBox
from BalloonWorkbench.gui.panels.bodies.gored_box import GoredBox
from BalloonWorkbench.gui.panels.bodies.target_box import TargetBox
from BalloonWorkbench.gui.panels.widgets.narrow import fit_heights
from BalloonWorkbench.gui.panels.widgets.pages import AfterPages, Pages
from BalloonWorkbench.gui.panels.widgets.watch import Watch
from BalloonWorkbench.gui.qt import QtCore, drawn_icon, translate
from BalloonWorkbench.gui.view3d.fit_view import fit_all, is_whole
from BalloonWorkbench.gui.window.borders import TaskPanel
from BalloonWorkbench.gui.window.macro_recorder import Edit

#: The page about what the balloon is to be, and its title.
_SOURCES = {
    FileBox: QT_TRANSLATE_NOOP("BalloonWorkbench", "Outline"),
    SketchBox: QT_TRANSLATE_NOOP("BalloonWorkbench", "Outline"),
    GoredBox: QT_TRANSLATE_NOOP("BalloonWorkbench", "Profile"),
    TargetBox: QT_TRANSLATE_NOOP("BalloonWorkbench", "Body"),
    BagBox: QT_TRANSLATE_NOOP("BalloonWorkbench", "Panels"),
}
_REST = 400  # ms without an edit, then a live balloon follows
_AGAIN = 50  # ms until a result is offered once more to a document that was busy


class BalloonPanel(TaskPanel):
    """Edits one balloon.

    sketch        the outline follows a sketch, not a file
    new_document  the document was made for this balloon and goes with it on Cancel
    edit          of a new balloon, what goes into the macro
    start         the object of `parts` whose page is in front
    """

    def __init__(
        self,
        parts: Parts,
        *,
        sketch: bool = False,
        new_document: bool = False,
        edit: Edit | None = None,
        start=None,
    ):
        self.parts = parts
        self.edit = edit or Edit(parts)
        self.doc = parts.balloon.Document
        self.new_document = new_document
        self.is_new = self.was_new = not parts.balloon.SolvedFor
        self.worker: Worker | None = None
        self.closing = False
        self.again = False  # values have changed while the worker was at it
        self.busy = 0  # the document follows, and the window lives on meanwhile: timers and workers wait
        self.was_whole = False  # all was in the view before a change
        self.then = ""
        outline = leader(parts.outline)
        drawing = _page_of(outline, sketch)
        self.result = ResultBox(parts.balloon)
        self.pages = Pages(
            (
                (translate(_SOURCES[drawing]), partial(self._box, drawing, outline, self.drawing_changed)),
                (translate("Film"), partial(self._box, FilmBox, parts.balloon, self.values_changed)),
                (translate("Pattern"), partial(self._box, PatternBox, parts.pattern, self.pattern_changed)),
                # four tabs in a narrow panel: a short word
                (translate("Solver"), partial(self._box, SimulationBox, parts.balloon, self.values_changed)),
            )
        )
        self.pages.setWindowTitle(translate("Balloon"))
        self.pages.setWindowIcon(drawn_icon("balloon"))
        self.form = [self.pages, AfterPages(self.pages, self.result)]
        self.soon = QtCore.QTimer(self.result)
        self.soon.setSingleShot(True)
        self.soon.setInterval(_REST)
        self.soon.timeout.connect(self.follow)
        self.result.requested.connect(self.apply)
        self.result.stopped.connect(self.stop)
        self.result.live_changed.connect(self.values_changed)
        self.result.asked_for.connect(self.accept_and_go)
        self.draft = DraftView(parts, self.result)
        self.draft.drawn.connect(self.show_draft)
        self.watch = Watch(parts, self.abandon)
        self.pages.setCurrentIndex(parts.index(start) if start in parts else 0)
        self.show_state()
        if self.is_new and has_source(parts.outline) and not getattr(parts.outline, "Drawing", ""):
            QtCore.QTimer.singleShot(0, self.apply)

    def _box(self, kind, obj, changed):
        """The box of a page, with its values: a field that is shown without writes what it has."""
        with self._doing():
            box = kind(obj)
            box.refresh()
        box.changed.connect(changed)
        if hasattr(box, "refused"):
            box.refused.connect(lambda text: self.result.show_message(text, warning=True))
        return box

    def begin_with(self, path: str):
        """Take a file as the drawing of a new balloon."""
        self.pages.boxes[0].choose(path)

    # the dialog

    def accept(self):
        """Compute what is not up to date yet, then keep everything and close."""
        self.closing = True
        if self.apply():
            self.close(keep=True)
        return False  # `close` does it, now or when the worker is done

    def accept_and_go(self, command: str):
        """OK, then a command about this balloon."""
        self.then = command
        self.accept()

    def reject(self):
        self.close(keep=False)
        return False

    def close(self, keep: bool):
        """End the undo step and the panel."""
        self.abandon()
        if keep:
            self.doc.commitTransaction()
            self.edit.write()
            if self.then:
                QtCore.QTimer.singleShot(0, partial(_run, self.then, self.doc.Name, self.parts.balloon.Name))
        else:
            self.doc.abortTransaction()
            if self.new_document:
                App.closeDocument(self.doc.Name)
            else:
                self.doc.recompute()

    def abandon(self):
        """Close the panel without touching the document: its objects may be about to go."""
        self.watch.remove()
        self.soon.stop()
        if self.worker is not None:
            self.worker.abandon()
            self.worker = None
        self.draft.clear()
        for box in (*self.pages.boxes, self.result):
            box.release()
        Gui.Control.closeDialog()

    # the work

    def trace(self) -> bool:
        """Find the outline anew where something changed; True when there is one."""
        if self.is_new and file_of(self.parts.outline):
            name_group(self.parts.balloon.getParentGroup(), Path(file_of(self.parts.outline)).stem)
        self.was_whole = self.was_whole or is_whole(Gui.getDocument(self.doc.Name))
        with self._doing():
            for outline in (leader(self.parts.outline), self.parts.outline):
                if "Touched" in outline.State or not status.is_ready(outline):
                    self.doc.recompute([outline])
        self.show_state()
        if (
            self.is_new
            and (is_bag(self.parts.outline) or is_target(self.parts.outline))
            and not self.was_whole
        ):
            fit_all(Gui.getDocument(self.doc.Name))  # its seams may be picked in the view
        return status.is_ready(self.parts.outline)

    def drawing_changed(self):
        self.trace()
        self.follow_soon()

    def values_changed(self):
        self.show_state()
        self.follow_soon()

    def follow_soon(self):
        """A live balloon follows when the edits pause."""
        if self.parts.balloon.Live and not self.closing:
            self.soon.start()

    def follow(self):
        """Inflate with the values as they are, those half typed left alone."""
        if self.busy:
            self.soon.start()
        elif self.worker is None:
            self.bring_up_to_date()
        elif not self._is_current(self.worker.request):
            self.again = True
            self.worker.stop()

    def _is_current(self, request) -> bool:
        try:
            return balloon_object.request(self.parts.balloon).key() == request.key()
        except BalloonError:
            return False

    def pattern_changed(self):
        if status.is_ready(self.parts.balloon):
            with self._doing():
                self.parts.pattern.recompute()
        self.show_state()

    def apply(self) -> bool:
        """Bring everything up to date; True when that is done, False when it takes a while or fails."""
        if self.worker is not None:
            return False
        for box in self.pages.boxes:
            box.finish_typing()
        self.soon.stop()
        return self.bring_up_to_date()

    def bring_up_to_date(self) -> bool:
        """As `apply`, with what is typed already."""
        if not self.trace():
            self.closing = False
            return False
        try:
            current = balloon_object.request(self.parts.balloon)
        except BalloonError as error:
            self.fail(error)
            return False
        if current.key() == self.parts.balloon.SolvedFor:
            return self.settle()
        self.worker = Worker(current, self.result, translate("Inflating"))
        self.worker.progressed.connect(self.result.show_progress)
        self.worker.ended.connect(self.work_done)
        self.result.start()
        fit_heights()
        self.worker.start()
        if not self.parts.balloon.SolvedFor and isinstance(current, Request):
            self.draft.begin(current)
        return False

    def stop(self):
        """Stop the engine; what was shown stays."""
        self.closing = self.again = False
        self.soon.stop()
        if self.worker is not None:
            self.worker.stop()

    def work_done(self):
        """The worker is finished: take over its design or tell why there is none."""
        if self.busy:
            QtCore.QTimer.singleShot(_AGAIN, self.work_done)
            return
        if self.worker is None:  # the panel was closed meanwhile
            return
        worker, self.worker = self.worker, None
        self.result.finish()
        if self.again:
            self.again = False
            if worker.design is None:
                self._go_on()
                return
        if worker.design is None:
            self.fail(worker.error)
            return
        self.draft.clear()
        try:
            balloon_object.show(self.parts.balloon, worker.request, *worker.design)
        except BalloonError as error:
            self.fail(error)
            return
        self._go_on()

    def _go_on(self):
        """Work once more when values were changed meanwhile; else an OK that waits has come to its end."""
        done = self.apply() if self.closing else self.bring_up_to_date()
        if done and self.closing:
            self.close(keep=True)

    def settle(self) -> bool:
        """Let the document follow the new values; True when the pattern is there."""
        with self._doing():
            self._follow_document()
        self.show_state()
        done = status.is_ready(self.parts.pattern)
        self.closing = self.closing and done
        return done

    def _follow_document(self):
        if self.was_new and leader(self.parts.outline) == self.parts.outline:
            create.match_companions(self.parts)  # the other shapes of the drawing
        for other in companions(self.parts):  # Apply is meant for all of them
            other.outline.recompute()
            if not other.balloon.Live and status.is_ready(other.outline):
                balloon_object.inflate_now(other.balloon)
        breathe()
        self.doc.recompute([self.parts.balloon])
        breathe()
        self.doc.recompute()
        if status.is_ready(self.parts.pattern):
            window = Gui.getDocument(self.doc.Name)
            if self.is_new or (self.was_whole and not is_whole(window)):
                fit_all(window)
            self.is_new = self.was_whole = False

    @contextmanager
    def _doing(self):
        """The document is being changed or recomputed."""
        self.busy += 1
        try:
            yield
        finally:
            self.busy -= 1

    def show_draft(self, draft):
        """Its measures, while the engine looks for the balloon."""
        self.result.show_draft(draft.inflation)
        fit_heights()
        fit_all(Gui.getDocument(self.doc.Name))

    def fail(self, error: BalloonError):
        self.closing = False
        self.draft.clear()
        self.show_state()
        self.result.show_message(str(error), warning=True)

    def show_state(self):
        """Show what the objects say."""
        for box in self.pages.boxes:
            box.refresh()
        self.result.show_result(self.parts)
        fit_heights()


def _page_of(outline, sketch: bool) -> type:
    """The page about what the balloon is to be."""
    if is_gored_body(outline):
        return GoredBox
    if is_bag(outline):
        return BagBox
    if is_target(outline):
        return TargetBox
    return SketchBox if sketch or outline.Source else FileBox


def _run(command: str, document_name: str, balloon_name: str) -> None:
    """Start a command for a balloon."""
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(document_name, balloon_name)
    Gui.runCommand(f"BalloonWorkbench_{command}")

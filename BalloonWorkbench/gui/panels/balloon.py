# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of a balloon: drawing, film and pressure, pattern, simulation, result.

The objects exist while the panel is open, inside one undo step: OK keeps it, Cancel takes it back.
The engine works in a thread; the document is touched in the main thread alone.
"""

from __future__ import annotations

from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui

from BalloonWorkbench.app import balloon as balloon_object
from BalloonWorkbench.app import create, status
from BalloonWorkbench.app.create import Parts
from BalloonWorkbench.app.outline import leader
from BalloonWorkbench.core.errors import BalloonError, Cancelled
from BalloonWorkbench.gui.panels.file_box import FileBox
from BalloonWorkbench.gui.panels.film_box import FilmBox
from BalloonWorkbench.gui.panels.pattern_box import PatternBox
from BalloonWorkbench.gui.panels.result_box import ResultBox
from BalloonWorkbench.gui.panels.simulation_box import SimulationBox
from BalloonWorkbench.gui.panels.sketch_box import SketchBox
from BalloonWorkbench.gui.panels.watch import Watch
from BalloonWorkbench.gui.qt import QtCore, QtGui, QtWidgets, icon, translate
from BalloonWorkbench.gui.record import Edit
from BalloonWorkbench.gui.worker import Worker


class BalloonPanel:
    """Edits one balloon.

    sketch        the outline follows a sketch, not a file
    new_document  the document was made for this balloon and goes with it on Cancel
    edit          of a new balloon, what goes into the macro
    """

    def __init__(
        self, parts: Parts, *, sketch: bool = False, new_document: bool = False, edit: Edit | None = None
    ):
        self.parts = parts
        self.edit = edit or Edit(parts)
        self.doc = parts.balloon.Document
        self.new_document = new_document
        self.is_new = self.was_new = not parts.balloon.SolvedFor
        self.worker: Worker | None = None
        self.closing = False
        outline = leader(parts.outline)
        self.drawing = (SketchBox if sketch or outline.Source else FileBox)(outline)
        self.film = FilmBox(parts.balloon)
        self.simulation = SimulationBox(parts.balloon)
        self.pattern = PatternBox(parts.pattern)
        self.result = ResultBox()
        self.boxes = (self.drawing, self.film, self.pattern, self.simulation)
        self.form = [_tabs(*self.boxes), self.result]
        self.drawing.changed.connect(self.trace)
        for box in (self.drawing, self.film):
            box.refused.connect(lambda text: self.result.show_message(text, warning=True))
        self.film.changed.connect(self.values_changed)
        self.simulation.changed.connect(self.values_changed)
        self.pattern.changed.connect(self.pattern_changed)
        self.result.wanted.connect(self.apply)
        self.result.stopped.connect(self.stop)
        self.watch = Watch(parts, self.abandon)
        self.show_state()
        if parts.outline.Source and self.is_new:
            QtCore.QTimer.singleShot(0, self.apply)

    # the dialog

    def accept(self):
        """Compute what is not up to date yet, then keep everything and close."""
        self.closing = True
        if self.apply():
            self.close(keep=True)
        return False  # `close` does it, now or when the worker is done

    def reject(self):
        self.close(keep=False)
        return False

    def close(self, keep: bool):
        """End the undo step and the panel."""
        self.abandon()
        if keep:
            self.doc.commitTransaction()
            self.edit.write()
        else:
            self.doc.abortTransaction()
            if self.new_document:
                App.closeDocument(self.doc.Name)
            else:
                self.doc.recompute()

    def abandon(self):
        """Close the panel without touching the document: its objects may be about to go."""
        self.watch.remove()
        if self.worker is not None:
            self.worker.finished.disconnect()
            self.worker.stop()
            self.worker.wait()
            self.worker = None
        for box in self.boxes:
            box.release()
        Gui.Control.closeDialog()

    # the work

    def trace(self) -> bool:
        """Find the outline anew; True when there is one."""
        if self.is_new and self.parts.outline.Drawing:
            self.parts.balloon.getParentGroup().Label = Path(self.parts.outline.Drawing).stem
        leader(self.parts.outline).recompute()
        self.parts.outline.recompute()
        self.show_state()
        return status.is_ready(self.parts.outline)

    def values_changed(self):
        self.show_state()

    def pattern_changed(self):
        if status.is_ready(self.parts.balloon):
            self.parts.pattern.recompute()
        self.show_state()

    def apply(self) -> bool:
        """Bring everything up to date; True when that is done, False when it takes a while or fails."""
        if self.worker is not None:
            return False
        for box in self.boxes:
            box.finish_typing()
        if not self.trace():
            self.closing = False
            return False
        try:
            wanted = balloon_object.request(self.parts.balloon)
        except BalloonError as error:
            self.fail(error)
            return False
        if wanted.key() == self.parts.balloon.SolvedFor:
            return self.settle()
        self.worker = Worker(wanted, self.result, translate("Inflating"))
        self.worker.progressed.connect(self.result.show_progress)
        self.worker.finished.connect(self.work_done)
        self.result.start()
        self.worker.start()
        return False

    def stop(self):
        """Stop the engine; what was shown stays."""
        self.closing = False
        if self.worker is not None:
            self.worker.stop()

    def work_done(self):
        """The worker is finished: take over its design or tell why there is none."""
        worker, self.worker = self.worker, None
        self.result.finish()
        if worker.design is None:
            self.fail(worker.error or Cancelled(translate("The solver stopped; the report view tells why.")))
            return
        try:
            balloon_object.show(self.parts.balloon, worker.request, worker.design)
        except BalloonError as error:
            self.fail(error)
            return
        if self.apply() and self.closing:  # works once more when values were changed meanwhile
            self.close(keep=True)

    def settle(self) -> bool:
        """Let the document follow the new values; True when the pattern is there."""
        if self.was_new and not self.parts.outline.Leader:
            create.match_companions(self.parts)  # the other shapes of the drawing
        self.doc.recompute()
        if self.is_new and status.is_ready(self.parts.pattern):
            ready = [other for other in create.companions(self.parts) if status.is_ready(other.pattern)]
            create.place_beside(self.parts, *ready)
            self.doc.recompute()
            self.is_new = False
            Gui.SendMsgToActiveView("ViewFit")
        self.show_state()
        done = status.is_ready(self.parts.pattern)
        self.closing = self.closing and done
        return done

    def fail(self, error: BalloonError):
        self.closing = False
        self.show_state()
        self.result.show_message(str(error), warning=True)

    def show_state(self):
        """Show what the objects say."""
        for box in self.boxes:
            box.refresh()
        self.result.show_result(self.parts)


def _tabs(*boxes):
    """The boxes behind one another: a task panel is narrow and low."""
    tabs = QtWidgets.QTabWidget()
    tabs.setObjectName("Steps")
    tabs.setWindowTitle(translate("Balloon"))
    tabs.setWindowIcon(QtGui.QIcon(icon("balloon")))
    for box in boxes:
        tabs.addTab(box, box.windowTitle())
    return tabs

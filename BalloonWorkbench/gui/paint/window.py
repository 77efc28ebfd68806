# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paint window: a wide canvas beside the 3D view in which the balloon grows.

The document is untouched until "Make it!"; that is one undo step.
"""

from __future__ import annotations

from functools import partial

import FreeCAD as App
import FreeCADGui as Gui

from BalloonWorkbench.app.document.kinds import leader
from BalloonWorkbench.app.document.parts import parts_of
from BalloonWorkbench.app.drawings.drawing_file import is_painting
from BalloonWorkbench.core import faults
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.tracing.segment import KEEP_HOLES
from BalloonWorkbench.gui.long_work.blocking import breathe
from BalloonWorkbench.gui.long_work.status_progress import StatusProgress
from BalloonWorkbench.gui.paint import print_out
from BalloonWorkbench.gui.paint.bars import ActionBar, ToolBox
from BalloonWorkbench.gui.paint.canvas.canvas_widget import Canvas
from BalloonWorkbench.gui.paint.dock import PaintDock
from BalloonWorkbench.gui.paint.documents import follow_documents
from BalloonWorkbench.gui.paint.extras import Extras
from BalloonWorkbench.gui.paint.form import PaintForm
from BalloonWorkbench.gui.paint.keep import keep, show, values_of
from BalloonWorkbench.gui.paint.painting.lengths import short
from BalloonWorkbench.gui.paint.painting.painted import Painting
from BalloonWorkbench.gui.paint.painting.pictures import Pictures
from BalloonWorkbench.gui.paint.painting.pieces import Clear
from BalloonWorkbench.gui.paint.painting.tools import MORE_TOOLS, TOOLS
from BalloonWorkbench.gui.paint.preview.live_preview import LivePreview
from BalloonWorkbench.gui.paint.preview.preload import load
from BalloonWorkbench.gui.paint.preview.scene import Scene
from BalloonWorkbench.gui.paint.size_card import SizeCard
from BalloonWorkbench.gui.panels import is_free
from BalloonWorkbench.gui.panels.widgets.watch import Watch
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate
from BalloonWorkbench.gui.view3d.fit_view import fit_all
from BalloonWorkbench.gui.window import borders

_SETTLED = 50  # ms, in which the 3D view takes the room of a window that has closed
_open: list[PaintWindow] = []  # each with its painting, the last used first; one at most is on the screen


def open_for(doc, parts=None) -> PaintWindow:
    """The paint window on a new balloon of a document, or on a painted one; others keep their paintings."""
    follow_documents(_open)
    window = next((each for each in _open if each.belongs_to(doc) and each.parts == parts), None)
    if window is None:
        load()
        window = PaintWindow(doc, parts)
        borders.speaks(window)
    else:
        _open.remove(window)
    for other in _open:
        if other.isVisible():
            other.put_aside()
            other.is_aside = not other.belongs_to(doc)
    _open.insert(0, window)
    window.reveal()
    return window


def paint_again(outline) -> bool:
    """Open the paint window on a painted outline; False for any other one."""
    first = leader(outline)
    parts = parts_of(first)
    if first.Source or not is_painting(first.Drawing) or parts is None:
        return False
    if is_free():
        open_for(first.Document, parts)
    return True


def _fit(document_name: str) -> None:
    """Show what is in a document, which may be closed by now."""
    if document_name in App.listDocuments():
        fit_all(Gui.getDocument(document_name))


class PaintWindow(PaintDock):
    """Paints one balloon; parts: None until there is one."""

    def __init__(self, doc, parts=None):
        super().__init__(translate("Paint a balloon"))
        self.doc, self.parts = doc, parts
        self.making = self._is_refused = False  # refused: the last words say why there is no balloon
        self._is_sized = parts is not None  # the width was asked for
        self.is_aside = False  # it comes back with its document
        self._hidden: tuple[str, ...] = ()
        self._waiting: StatusProgress | None = None
        self.painting = Painting(self)
        self.canvas = Canvas(self.painting)
        self.hand = self.canvas.hand
        self.live = LivePreview(self.painting, self)
        self.scene, self.pictures = Scene(doc.Name, parts), Pictures(self.painting, self.hand, self)
        self.tools, self.actions = ToolBox(), ActionBar()
        self.extras = Extras(self.canvas, self.tools, self.actions, self.pictures)
        self.form, self.card = PaintForm(self.live.width), SizeCard(self.canvas)
        self.fill(self.extras.widget, self.tools, self.canvas, self.form)
        self._connect()
        self.watch = Watch(parts or (), self.finish, doc)
        if parts is not None:
            self._take_over(parts)
        self.refresh()

    def reveal(self) -> None:
        """Take the left half of the window, with the painting as it was left."""
        self.is_aside = False
        super().reveal()
        show(self.scene.document(), self._hidden, False)
        self.canvas.setFocus()
        if not self.painting.is_empty():
            self.live.changed()

    def belongs_to(self, doc) -> bool:
        """The document is the one that is painted for."""
        return doc.Name == self.scene.document_name

    def put_aside(self) -> None:
        """Another document is in front: the painting waits for its own."""
        if self.making:
            self._stop_making()
        self.close()
        self.is_aside = True

    def finish(self) -> None:
        """Close for good."""
        self.watch.remove()
        self.leave()
        self.pictures.stop()
        super().finish()
        if self in _open:
            _open.remove(self)

    def leave(self) -> None:
        """Closed, now or for good."""
        self._not_making()
        self.extras.close()
        self.live.stop()
        if self.scene.is_shown():  # the camera has followed it
            QtCore.QTimer.singleShot(_SETTLED, partial(_fit, self.scene.document_name))
        self.scene.clear()
        show(self.scene.document(), self._hidden, True)

    def _connect(self) -> None:
        self.tools.chosen.connect(self.choose)
        self.extras.chosen.connect(self.choose)
        self.extras.message.connect(self.form.show_message)
        self.actions.thickened.connect(self.hand.set_thickness)
        self.actions.acted.connect(self.act)
        self.canvas.chosen.connect(self._key)
        self.canvas.accepted.connect(self.widen)
        self.hand.message.connect(self.form.show_message)
        self.pictures.message.connect(self.form.show_message)
        self.hand.growing.connect(self.live.drawing)
        self.painting.changed.connect(self._painted)
        self.live.shown.connect(self._show)
        self.live.refused.connect(self._refused)
        self.live.empty.connect(self._emptied)
        self.live.progressed.connect(self.form.show_progress)
        self.form.made.connect(self.make)
        self.form.widened.connect(self.set_width)
        self.form.read_as.connect(self.live.read_as)
        self.card.changed.connect(self.set_width)
        self.card.answered.connect(self._sized)
        application = QtWidgets.QApplication.instance()
        application.focusChanged.connect(self._focus_moved)
        application.aboutToQuit.connect(self.live.stop)

    def _take_over(self, parts) -> None:
        """The painting, width and values of a balloon that was made before."""
        before = values_of(parts)
        self.painting.load(before.file)
        self.live.width, self.live.settings = before.width, before.settings
        self.form.show_width(before.width)
        self.form.show_drawn_as(before.settings.drawn_as)
        self._hidden = before.visible

    # what the user does

    def choose(self, tool) -> None:
        self.hand.cancel()
        self.extras.begin(tool)
        self.hand.tool = tool
        self.tools.show_chosen(tool)
        if self.live.latest is None:
            self.form.show_message("")
        self.canvas.update()

    def act(self, name: str) -> None:
        """One of the buttons over the canvas."""
        if name == "undo" and self.canvas.floating.is_there():
            self.canvas.cancel()
            return
        self.hand.cancel()
        self.canvas.finish()
        if name in ("undo", "redo"):
            getattr(self.painting, name)()
        elif name == "clear":
            if not self.painting.is_empty():
                self.painting.do(Clear())
        elif name == "fit":
            self.canvas.paper.fit()
        elif name == "backdrop" and self.painting.backdrop is not None:
            self.painting.set_backdrop(None)
        else:
            self.pictures.choose(as_paint=name == "picture")

    def widen(self, number: int) -> None:
        """Repair a thin place, and those that are painted with it."""
        step = self.canvas.thin.remarks[number].step
        step.symmetry = self.hand.symmetry
        self.canvas.thin.show(())
        self.painting.do(step)
        self.form.show_message(translate("It is wider now. Ctrl+Z takes that back."))

    def set_width(self, width: float) -> None:
        """Of the balloon in mm."""
        self.form.show_width(width)
        self.card.show_width(width)
        if self.live.latest is not None:
            self.canvas.scale.fit(self.live.latest, width)
        self.live.set_width(width)
        self.canvas.update()

    def make(self) -> None:
        """Put the balloon into the document, as soon as it is solved."""
        if self.making or not is_free():
            return
        self.canvas.finish()
        if self.painting.is_empty():
            self.form.show_message(translate("Paint something first: a closed line is enough."))
            return
        if self.card.isVisible():
            self.card.answer()
        self.making = True
        self.refresh()
        if self.live.is_settled():
            self._keep(self.live.latest)
        else:
            self.form.show_message(translate("The pattern is being fitted to the painting ..."))
            self._waiting = StatusProgress(translate("Fitting the pattern"), self._stop_making)
            self.live.progressed.connect(self._waiting.show_part)
            self.live.begin_full_design(awaited=True)

    def _stop_making(self) -> None:
        """The painting stays as it is, and nothing is made of it."""
        self.live.drop_full_design()
        self._not_making()
        self._is_refused = False  # a state that is still on its way leaves the words
        self.form.show_message(translate("Stopped. Your painting is still here."))

    def _not_making(self) -> None:
        """Made, or given up."""
        self.making = False
        if self._waiting is not None:
            self._waiting.close()
            self._waiting = None
        self.refresh()

    def _keep(self, state) -> None:
        """Take a full design over into the document, in one undo step."""
        is_new = self.parts is None
        self._not_making()
        self.doc.openTransaction(translate("Paint a balloon"))
        try:
            parts = keep(self.doc, self.parts, state, self.live.width, breathe)
        except faults.UNFORESEEN as error:
            self.doc.abortTransaction()
            self.form.show_message(
                str(faults.as_balloon_error(error, "putting a painting into the document"))
            )
            return
        self.doc.commitTransaction()
        self.finish()
        if is_new:
            print_out.offer(parts)

    def _key(self, letter: str) -> None:
        if letter == "M":
            self.actions.buttons["mirror"].toggle()
        elif letter in ("[", "]"):
            self.actions.thicken(1 if letter == "]" else -1)
        elif not self.extras.key(letter):
            self.choose(next(tool for tool in (*TOOLS, *MORE_TOOLS) if tool.key == letter))

    def _sized(self, width: float) -> None:
        self._is_sized = True
        self.set_width(width)
        self.canvas.scale.is_visible = False
        self.canvas.setFocus()

    def _focus_moved(self, before, now) -> None:
        """The hand lies beside the shape as long as its width is being typed."""
        typing = now is not None and self.form.width_field.isAncestorOf(now)
        self.canvas.scale.is_visible = typing or now is self.form.width_field or self.card.isVisible()
        self.canvas.update()

    # what comes of it

    def _painted(self) -> None:
        self.scene.paint(self.painting.image)
        self.live.changed()
        self.refresh()

    def _show(self, state) -> None:
        self.canvas.overlay.show(state, short(self.live.width))
        self.canvas.scale.fit(state, self.live.width)
        if not self._is_sized and not self.card.isVisible() and self.hand.stroke is None:
            self.canvas.scale.is_visible = True
            self.card.ask(self.live.width)
        self.scene.show(state, self.painting.image)
        self.form.show_state(state)
        if self._is_refused or self.form.says_first:
            self._is_refused = False
            self.form.show_message(translate("The pattern is being fitted to the painting ..."))
        if state.solved is not None or state.remarks:
            self._advised(state.remarks)
        self.canvas.update()
        if self.making and self.live.is_settled():
            self._keep(state)

    def _advised(self, remarks) -> None:
        """Thin places turn orange; the worst thing is said."""
        self.canvas.thin.show(remarks)
        serious = [remark.text for remark in remarks if remark.severity != "hint"]
        fine = translate("Ready to make. Paint on, or press Make it!")
        state = self.live.latest
        filled = [note for note in (state.drawing.notes if state else ()) if KEEP_HOLES in note]
        self.form.show_message((*serious, *filled, fine)[0])
        self.canvas.update()

    def _refused(self, text: str) -> None:
        self._nothing()
        self._is_refused = True
        self.form.show_message(text)

    def is_shown(self) -> bool:
        return self in _open and self.isVisible()

    def fail(self, error: BalloonError) -> None:
        """Something went wrong in the window itself; the painting is as it is."""
        self._not_making()
        self.form.show_message(str(error))

    def _nothing(self) -> None:
        """There is no balloon to show."""
        self._not_making()
        self.canvas.overlay.clear()
        self.canvas.thin.show(())
        self.canvas.update()
        self.scene.clear()
        self.form.show_state(None)

    def _emptied(self) -> None:
        """Nothing is painted, so there is nothing to say but what to do first."""
        self._nothing()
        self._is_refused = False
        self.form.show_message("")

    def refresh(self) -> None:
        """Buttons that would do nothing are off."""
        self.actions.buttons["undo"].setEnabled(self.painting.can_undo())
        self.actions.buttons["redo"].setEnabled(self.painting.can_redo())
        self.form.make_button.setEnabled(not self.making)

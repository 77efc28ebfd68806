# SPDX-License-Identifier: LGPL-2.1-or-later
"""The border between the window and us: a fault ends what was asked for and is told, the window lives on.

Qt gives what slots, timers and event handlers raise to `sys.excepthook`; commands and panels are called by
FreeCAD itself. What was open says what happened, or else a box that leaves the window alone.
"""

from __future__ import annotations

import sys
import threading
import time
import traceback
from contextlib import contextmanager
from functools import partial, wraps
from weakref import ref

import FreeCAD as App
import FreeCADGui as Gui

from BalloonWorkbench.app.border import hooks
from BalloonWorkbench.core import faults
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate
from BalloonWorkbench.gui.window.sentences import translated

faults.surroundings["Qt"] = QtCore.qVersion()

_ONCE = 1.0  # s in which the same sentence is told once: a picture is painted many times
_last = ["", 0.0]  # the sentence that was told last, and when
_surfaces: list = []  # what may be open and can say something, the newest last


def watch() -> None:
    """From now on what our slots, timers and event handlers raise is told; the others' goes on as before."""
    sys.excepthook = partial(_unforeseen, sys.excepthook)


def speaks(surface) -> None:
    """From now on, as long as `surface.is_shown()`, `surface.fail(error)` says what went wrong."""
    _surfaces[:] = [other for other in _surfaces if other() is not None]
    _surfaces.append(ref(surface))


def show_error(error: BalloonError) -> None:
    """Say what went wrong: in the report view, and where the user looks."""
    text, now = str(error), time.monotonic()
    if text == _last[0] and now < _last[1] + _ONCE:
        return
    _last[:] = text, now
    hooks.report(error)
    if threading.current_thread() is threading.main_thread():
        QtCore.QTimer.singleShot(0, partial(_show, error))  # Qt may be amid painting or deleting


def command(name: str, activated):
    """The border of a command: `Activated`."""

    @wraps(activated)
    def call(*arguments):
        try:
            return activated(*arguments)
        except faults.UNFORESEEN as error:
            return show_error(faults.as_balloon_error(error, f"running {name}"))

    return call


def offered(name: str, is_active):
    """The border of `IsActive`, which FreeCAD asks all the time: a command in doubt is off."""

    @wraps(is_active)
    def call():
        try:
            return is_active()
        except faults.UNFORESEEN as error:
            show_error(faults.as_balloon_error(error, f"offering {name}"))
            return False

    return call


@contextmanager
def undo_step(doc, title: str):
    """Opens an undo step and leaves it open for a panel to end; takes it back when that does not come."""
    doc.openTransaction(title)
    try:
        yield
    except BaseException:
        doc.abortTransaction()
        raise


class TaskPanel:
    """Base of all task panels. A fault in OK leaves the panel open, and says so in its `message`; Cancel
    closes it in any case."""

    def __init_subclass__(cls, **options):
        super().__init_subclass__(**options)
        for name, answer in (("accept", _stay), ("reject", _close)):
            if name in vars(cls):
                setattr(cls, name, _bordered(vars(cls)[name], answer))

    def fail(self, error: BalloonError) -> None:
        """Say what went wrong."""
        self.message.setText(translated(str(error)))

    def is_shown(self) -> bool:
        """The user can see it."""
        forms = self.form if isinstance(self.form, list) else [self.form]
        return any(form.isVisible() for form in forms)

    def abandon(self) -> None:
        """Close without touching the document."""
        self.close()


def _bordered(method, answer):
    @wraps(method)
    def call(self):
        try:
            return method(self)
        except faults.UNFORESEEN as error:
            known = faults.as_balloon_error(error, f"in {type(self).__name__}.{method.__name__}")
            return answer(self, known)

    return call


def _stay(panel, error: BalloonError) -> bool:
    show_error(error)
    return False


def _close(panel, error: BalloonError) -> bool:
    """Cancel: nothing is kept, whatever went wrong on the way."""
    show_error(error)
    doc = getattr(panel, "doc", None)
    try:
        panel.abandon()
    except faults.UNFORESEEN as another:
        Gui.Control.closeDialog()
        show_error(faults.as_balloon_error(another, f"closing {type(panel).__name__}"))
    if doc is not None and doc in App.listDocuments().values():
        doc.abortTransaction()
    return False


def _unforeseen(others, kind, error, trace) -> None:
    """What nobody caught: ours is told, anything else goes to `others`."""
    modules = (frame.f_globals.get("__name__", "") for frame, _ in traceback.walk_tb(trace))
    ours = any(name.partition(".")[0] == "BalloonWorkbench" for name in modules)
    if not ours or not isinstance(error, faults.UNFORESEEN):
        others(kind, error, trace)
        return
    known = faults.as_balloon_error(error, "answering the window")
    # Python keeps the last trace: a painter in it would outlive what it paints on
    traceback.clear_frames(trace)
    show_error(known)


def _show(error: BalloonError) -> None:
    for surface in reversed(_surfaces):
        here = surface()
        try:
            if here is not None and here.is_shown():
                here.fail(error)
                return
        except faults.UNFORESEEN:  # Qt has deleted it, or it cannot even say so
            continue
    _box(translated(str(error)))


def _box(text: str) -> None:
    """A box with a sentence; nobody has to close it before going on."""
    window = Gui.getMainWindow()
    box = window.findChild(QtWidgets.QMessageBox, "BalloonFault")
    if box is None:
        box = QtWidgets.QMessageBox(window)
        box.setObjectName("BalloonFault")
        box.setIcon(QtWidgets.QMessageBox.Warning)
        box.setWindowTitle(translate("Film Balloon", "Workbench"))
        box.setModal(False)
        box.setAttribute(QtCore.Qt.WA_DeleteOnClose)
        box.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
    box.setText(text)
    box.show()

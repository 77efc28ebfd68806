# SPDX-License-Identifier: LGPL-2.1-or-later
"""The offer to fetch the native solver where the workbench came without it: nothing is fetched before a yes,
and after a no it is not offered again, but in "What works here"."""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui

from BalloonWorkbench.app.properties import preferences
from BalloonWorkbench.core.errors import Cancelled, FetchError
from BalloonWorkbench.core.solver.native import library
from BalloonWorkbench.core.units import number_text
from BalloonWorkbench.gui.long_work.worker import Worker
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate
from BalloonWorkbench.gui.window.sentences import translated

KEY = "OfferSolver"
_SHOWN = 15000  # ms that a sentence stays in the status bar

_worker: Worker | None = None


class _Fetch:
    """What the thread does."""

    def __init__(self, wheel):
        self._wheel = wheel

    def solve(self, progress):
        """Fetch it; the path of the library."""
        from BalloonWorkbench.core.solver.native import native_wheel

        return native_wheel.fetch(self._wheel, progress)


def offer() -> None:
    """Offer it once the window stands, where it is missing and the user has not said no; loads no library."""
    if preferences.get(KEY) and library.is_lacking():
        QtCore.QTimer.singleShot(0, _offer)


def _offer() -> None:
    try:
        ask()
    except FetchError as error:  # nobody asked for it: no box
        App.Console.PrintMessage(f"Film Balloon: {translated(str(error))}\n")


def ask() -> None:
    """Say what would be fetched, from where, into which folder, and ask. FetchError where nothing can be."""
    from BalloonWorkbench.core.solver.native import native_wheel

    if _worker is not None or is_asking():
        return
    wheel, folder = native_wheel.wheel(), native_wheel.place()
    box = _box("BalloonOffer", QtWidgets.QMessageBox.Question)
    box.setText(
        translate(
            "The native solver is not installed. Everything works without it, but simulations take 20 to 30 "
            "times longer. Fetch it now?"
        )
    )
    box.setInformativeText(
        translate("{} MB from {}; the file is checked before it is used, and nothing is sent.").format(
            number_text(wheel.size / 1e6, 2), wheel.host
        )
    )
    box.setDetailedText(f"{wheel.address}\nSHA-256 {wheel.sha256}\n{folder}")
    yes = box.addButton(translate("Fetch"), QtWidgets.QMessageBox.AcceptRole)
    no = box.addButton(translate("No, use NumPy"), QtWidgets.QMessageBox.RejectRole)
    box.setDefaultButton(yes)
    box.setEscapeButton(no)
    box.finished.connect(lambda _code: _fetch(wheel) if box.clickedButton() is yes else _refuse())
    box.show()


def _refuse() -> None:
    preferences.put(KEY, False)
    _note(translate('Simulations use NumPy. "What works here" in the menu fetches the native solver later.'))


def _fetch(wheel) -> None:
    global _worker  # noqa: PLW0603 - one at a time
    _worker = Worker(
        _Fetch(wheel), QtWidgets.QApplication.instance(), title=translate("Fetching the native solver")
    )
    QtWidgets.QApplication.instance().aboutToQuit.connect(_stop)
    _worker.ended.connect(_fetched)
    _worker.start()


def _stop() -> None:
    """FreeCAD ends: a thread that still runs would end it with an error."""
    if _worker is not None:
        _worker.abandon()


def _fetched() -> None:
    global _worker
    worker, _worker = _worker, None
    QtWidgets.QApplication.instance().aboutToQuit.disconnect(_stop)
    worker.deleteLater()
    worker.fault()
    if worker.error is None:
        preferences.put(KEY, True)
        _note(translate("The native solver is in use now."))
    elif isinstance(worker.error, Cancelled):
        _note(translated(str(worker.error)))
    else:
        box = _box("BalloonNotFetched", QtWidgets.QMessageBox.Information)
        box.setText(translated(str(worker.error)))
        box.show()


def _note(text: str) -> None:
    Gui.getMainWindow().statusBar().showMessage(text, _SHOWN)


def is_asking() -> bool:
    """The user has not answered yet."""
    boxes = Gui.getMainWindow().findChildren(QtWidgets.QMessageBox, "BalloonOffer")
    return any(box.isVisible() for box in boxes)


def _box(name: str, icon):
    """A box that leaves the window alone."""
    box = QtWidgets.QMessageBox(Gui.getMainWindow())
    box.setObjectName(name)
    box.setIcon(icon)
    box.setWindowTitle(translate("Film Balloon", "Workbench"))
    box.setModal(False)
    box.setAttribute(QtCore.Qt.WA_DeleteOnClose)
    box.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
    return box

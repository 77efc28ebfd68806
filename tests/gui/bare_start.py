# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run by a FreeCAD of its own, see test_absence.py: what the workbench does where nothing is installed.

Writes what it saw as JSON to the file in BALLOON_SEEN, and ends FreeCAD.
"""

import ctypes
import json
import os
import sys
import time
import traceback
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from BalloonWorkbench.core.packages import ABSENCES

sys.path.append("tests/gui")

import startup

try:
    from PySide import QtWidgets
except ImportError:  # FreeCAD 0.20 keeps the widgets in QtGui
    QtWidgets = QtGui

HEAVY = set(ABSENCES) - {"numpy"}
seen = {"loaded at start": sorted(set(ABSENCES) & set(sys.modules))}


def hide(*names):
    """Packages that are not there: Python imports nothing under a name that stands for None."""
    for name in [*names, *sys.modules]:
        if name.partition(".")[0] in names:
            sys.modules[name] = None


def message():
    labels = Gui.getMainWindow().findChildren(QtWidgets.QLabel)
    return [label.text() for label in labels if label.objectName() in ("Message", "Equipment")]


def wait(seconds=0.3):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        QtWidgets.QApplication.processEvents()
        time.sleep(0.01)


def from_picture(document):
    from BalloonWorkbench.app.document import create

    create.balloon_from_picture(document, "resources/examples/pictures/star.png", width=90)


def from_sketch(document):
    from BalloonWorkbench.app.document import create

    create.balloon_from_sketch(document, document.Rectangle)


def look():
    seen["rooms"], seen["packages"] = map(sorted, startup.imported())
    hide(*HEAVY)
    from BalloonWorkbench.core.errors import BalloonError
    from BalloonWorkbench.core.solver.native import load

    load._FOLDER = Path(os.environ["BALLOON_SEEN"]).parent
    Gui.activateWorkbench("BalloonWorkbench")
    seen["active"] = Gui.activeWorkbench().name()
    wait()
    Gui.runCommand("BalloonWorkbench_Equipment")
    wait()
    seen["equipment"] = message()
    Gui.Control.closeDialog()
    document = App.openDocument(os.environ["BALLOON_DOCUMENT"])
    wait()
    seen["shapes"] = {
        "outline": document.Outline.Shape.Area,
        "facets": document.Balloon.Mesh.CountFacets,
        "pattern": document.Pattern.Shape.Length,
        "proxies": [
            type(document.getObject(name).Proxy).__name__ for name in ("Outline", "Balloon", "Pattern")
        ],
    }
    document.Pattern.touch()
    document.recompute()
    seen["pattern"] = document.Pattern.Status
    seen["refused"] = []
    for work in (from_sketch, from_picture):
        try:
            work(document)
        except BalloonError as error:
            seen["refused"].append(str(error))


def run():
    try:
        look()
    finally:
        if sys.exc_info()[0] is not None:
            seen["failed"] = traceback.format_exc()
        Path(os.environ["BALLOON_SEEN"]).write_text(json.dumps(seen), encoding="utf-8")
        ctypes.CDLL(None).fflush(None)  # what FreeCAD itself has printed
        os._exit(0)


QtCore.QTimer.singleShot(0, run)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run by a FreeCAD of its own, see tools/install_check.py: what a new user does with what was installed.

The task is the JSON file in BALLOON_TASK; what was seen is written beside it, and FreeCAD's window closed.

    activate  whether the workbench is chosen at all
    answer    the button of the offer of the native solver that is pressed; empty where none may be offered
    save      the document that a balloon is kept in, or what FreeCAD itself makes without the workbench
"""

import json
import os
import sys
import time
import traceback
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

try:
    from PySide import QtWidgets
except ImportError:  # FreeCAD 0.20 keeps the widgets in QtGui
    QtWidgets = QtGui

sys.path.append(os.environ["BALLOON_SITE"])  # packages that the Addon Manager installs from the network

TASK = Path(os.environ["BALLOON_TASK"])
task, seen = json.loads(TASK.read_text(encoding="utf-8")), {}


def wait(condition, seconds=40.0):
    end = time.monotonic() + seconds
    while not condition() and time.monotonic() < end:
        QtWidgets.QApplication.processEvents()
        time.sleep(0.02)
    return condition()


def offers():
    boxes = Gui.getMainWindow().findChildren(QtWidgets.QMessageBox, "BalloonOffer")
    return [box for box in boxes if box.isVisible()]


def answer(text):
    wait(offers)
    (box,) = offers()
    seen["offered"] = f"{box.text()} {box.informativeText()} {box.detailedText()}"
    next(button for button in box.buttons() if button.text().replace("&", "") == text).click()
    from BalloonWorkbench.gui.window import native_offer

    wait(lambda: native_offer._worker is None)
    seen["said"] = Gui.getMainWindow().statusBar().currentMessage()


def drawn():
    """A new document with a rectangle."""
    document = App.newDocument("First")
    sketch = document.addObject("Sketcher::SketchObject", "Rectangle")
    import Part

    corners = [App.Vector(*each, 0) for each in ((0, 0), (120, 0), (120, 80), (0, 80))]
    for start, end in zip(corners, corners[1:] + corners[:1]):
        sketch.addGeometry(Part.LineSegment(start, end), False)
    return document, sketch


def others():
    """The same with FreeCAD's own workbenches, which keep settings of their own."""
    Gui.activateWorkbench("PartWorkbench")
    import Mesh

    document, _ = drawn()
    document.addObject("Mesh::Feature", "Box").Mesh = Mesh.createBox(10, 10, 10)
    keep(document)


def keep(document):
    document.recompute()
    wait(lambda: False, 0.5)
    document.saveAs(task["save"])
    App.closeDocument(document.Name)
    wait(lambda: False, 0.5)


def look():
    wait(lambda: False, 0.5)
    if not task["activate"]:
        seen["known"] = "BalloonWorkbench" in Gui.listWorkbenches()
        others()
        return
    Gui.activateWorkbench("BalloonWorkbench")
    seen["active"] = Gui.activeWorkbench().name()
    wait(lambda: False, 1.0)
    if task["answer"]:
        answer(task["answer"])
    seen["asks"] = bool(offers())
    document, sketch = drawn()
    from BalloonWorkbench.app.document import create

    parts = create.balloon_from_sketch(document, sketch, mesh_size=16, correct=False)
    seen["solver"], seen["status"] = parts.balloon.ActiveBackend, parts.balloon.Status
    seen["facets"] = parts.balloon.Mesh.CountFacets
    keep(document)


def run():
    try:
        look()
    finally:
        if sys.exc_info()[0] is not None:
            seen["failed"] = traceback.format_exc()
        TASK.with_name("seen.json").write_text(json.dumps(seen), encoding="utf-8")
        Gui.getMainWindow().close()


QtCore.QTimer.singleShot(0, run)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of what the code of the guide makes, in docs/images; runs in FreeCAD's window.

tools/in-window.sh build/pages tools/page_pictures.py; PAGES=engineers or PAGES=examples makes those alone.
"""

import os
import sys
import time
import traceback
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui

sys.path.append(str(Path(__file__).resolve().parent))
sys.path.insert(0, os.path.join(App.getUserAppDataDir(), "AdditionalPythonPackages"))

import page_code

from BalloonWorkbench.gui.qt import QtCore, QtWidgets

SIZE = 1100, 700  # px
EXAMPLE = 640  # px, width
_COLOURS = 64


def wait(seconds):
    """Let the window work for a while."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        QtWidgets.QApplication.processEvents(QtCore.QEventLoop.AllEvents, 20)


def keep(image, name):
    """An image of Qt as a small file."""
    from PIL import Image

    path = page_code.IMAGES / f"{name}.png"
    image.save(str(path), "PNG")
    with Image.open(path) as shown:
        small = shown.convert("RGB").quantize(_COLOURS)
    small.save(path, optimize=True)


def window(name):
    """The whole window as it is now."""
    Gui.getMainWindow().statusBar().clearMessage()
    wait(0.5)
    keep(QtWidgets.QApplication.primaryScreen().grabWindow(0, 0, 0, *SIZE).toImage(), name)


def seen(name, *hidden, direction="viewTop"):
    """The 3D view with all of the document but what is named."""
    from BalloonWorkbench.gui.view3d.fit_view import fit_all

    for obj in App.ActiveDocument.Objects:
        if obj.Name in hidden or obj.TypeId == "Sketcher::SketchObject":
            obj.ViewObject.Visibility = False
    Gui.Selection.clearSelection()
    getattr(Gui.activeDocument().activeView(), direction)()
    fit_all()
    window(name)


def engineers():
    """The tutorial for engineers: a picture after a block."""
    known = {}
    code = page_code.blocks("tutorial-engineers.md")

    def run(number):
        page_code.run(code[number], f"block {number}", known)
        wait(0.5)

    run(0)
    doc = known["doc"]
    doc.Sizes.ViewObject.doubleClicked()
    window("tutorial-engineers-sizes")
    run(1)
    tabs = Gui.getMainWindow().findChild(QtWidgets.QMdiArea)
    for tab in tabs.subWindowList():
        if "Sizes" in tab.windowTitle():
            tab.close()
    Gui.activeDocument().setEdit("HalfOutline")
    wait(0.5)
    Gui.SendMsgToActiveView("ViewFit")
    window("tutorial-engineers-sketch")
    Gui.activeDocument().resetEdit()
    Gui.activateWorkbench("BalloonWorkbench")
    run(2)
    seen("tutorial-engineers-float")
    run(3)
    seen("tutorial-engineers-wider")
    run(4)
    Gui.Selection.addSelection(known["study"])
    Gui.runCommand("BalloonWorkbench_Study")
    wait(3.0)
    window("tutorial-engineers-study")
    Gui.Control.closeDialog()
    run(5)
    seen("tutorial-engineers-pattern", "Balloon")
    App.closeDocument(doc.Name)


#: Which show more from the front and above than from above.
_SOLID = ("sphere", "airship", "pumpkin", "pouch", "housing", "cow", "letter")


def examples():
    """The scripts of the examples: what each has made."""
    from PIL import Image

    from BalloonWorkbench.gui.view3d.fit_view import fit_all

    for script in sorted((page_code.EXAMPLES / "scripts").glob("*.py")):
        known = {}
        page_code.run(script.read_text(encoding="utf-8"), script.name, known)
        view = Gui.activeDocument().activeView()
        view.viewIsometric() if script.stem in _SOLID else view.viewTop()
        fit_all()
        wait(0.5)
        path = page_code.IMAGES / f"example-{script.stem}.png"
        view.saveImage(str(path), *view.getSize(), "White")  # in other proportions it would be cut off
        with Image.open(path) as shown:
            width, height = EXAMPLE, round(EXAMPLE * shown.height / shown.width)
            small = shown.convert("RGB").resize((width, height)).quantize(_COLOURS)
        small.save(path, optimize=True)
        sys.stderr.write(f"{script.stem}: {[obj.Status for obj in known['made']]}\n")
        App.closeDocument(known["doc"].Name)


def run():
    """Make the pages that are asked for, and end the program."""
    code = 1
    try:
        os.makedirs("build/pages/files", exist_ok=True)
        os.chdir("build/pages/files")
        Gui.activateWorkbench("BalloonWorkbench")
        main = Gui.getMainWindow()
        main.showNormal()
        main.setGeometry(0, 0, *SIZE)
        wait(0.5)
        for name in os.environ.get("PAGES", "engineers examples").split():
            globals()[name]()
        code = 0
    finally:
        if code:
            traceback.print_exc()
        sys.stderr.flush()
        os._exit(code)


QtCore.QTimer.singleShot(0, run)

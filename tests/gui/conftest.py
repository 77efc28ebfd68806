# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench is active, each test has its own document, and no dialog may stand in front of the window."""

import importlib
import pkgutil
import shutil
import sys
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import pytest

sys.path += [
    str(Path(__file__).resolve().parents[1] / room) for room in ("app", "core")
]  # sketches, counting

import hands
import sketches
from remembered import remembered

from BalloonWorkbench import app, gui
from BalloonWorkbench.app.document import create
from BalloonWorkbench.core import faults
from BalloonWorkbench.core.nesting import nest
from BalloonWorkbench.gui.panels.balloon import body_rows
from BalloonWorkbench.gui.window import file_dialogs


@pytest.fixture(autouse=True)
def workbench():
    """Our workbench, and a clean window afterwards."""
    Gui.activateWorkbench("BalloonWorkbench")
    Gui.Selection.clearSelection()
    hands.QtGui.QCursor.setPos(0, 0)  # not over a 3D view, where what is below it lights up
    yield Gui.activeWorkbench()
    if hands.panel_is_open():
        hands.leave()
    for name in list(App.listDocuments()):
        App.closeDocument(name)
    hands.wait(0.05)
    assert not hands.panel_is_open()


@pytest.fixture(autouse=True)
def known(request):
    """What tests before have worked out, but for those that look at the work itself."""
    with remembered(request.node):
        yield


@pytest.fixture
def stand_in(monkeypatch):
    """Puts something in the place of what the window asks for; results stay what they are, and known."""
    return monkeypatch


@pytest.fixture
def without_figures(monkeypatch):
    """The panel of a body tells nothing that a thread has to count: bodies/test_figures.py looks at that."""
    monkeypatch.setattr(body_rows, "body_figures", lambda *_given: None)


@pytest.fixture(autouse=True, scope="session")
def short_layouts():
    """How closely panels can lie is looked at in tests of the engine."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(nest, "_LIMIT", 8)  # s
        yield


@pytest.fixture(autouse=True)
def no_file_chosen(monkeypatch):
    """A new balloon from a picture begins without a file: the tests type one. test_choose.py chooses them."""
    monkeypatch.setattr(file_dialogs, "ask_for_drawing", lambda _parent: "")


@pytest.fixture(autouse=True)
def no_fault(monkeypatch):
    """Nothing told of a fault of the program, which leaves a box in the window and goes on."""
    told, report = [], faults.report_fault

    def reported(error, doing):
        told.append(f"{doing}: {error!r}")
        return report(error, doing)

    monkeypatch.setattr(faults, "report_fault", reported)
    yield
    hands.wait(0.02)
    for box in hands.visible(hands.QtWidgets.QMessageBox):
        if box.objectName() == "BalloonFault":
            box.close()
    assert not told


@pytest.fixture
def doc():
    document = App.newDocument("Test")
    hands.wait(0.05)
    return document


@pytest.fixture(scope="session")
def rectangle_file(tmp_path_factory):
    """A finished balloon of 90 x 60 mm as drawn, from a sketch, in a file: opening it takes no time."""
    return _saved(tmp_path_factory.mktemp("drawn"), correct=False)


@pytest.fixture(scope="session")
def fitted_file(tmp_path_factory):
    """The same one, fitted to its drawing."""
    return _saved(tmp_path_factory.mktemp("fitted"), correct=True)


def _saved(folder, correct):
    document = App.newDocument("Test")
    create.balloon_from_sketch(document, sketches.rectangle(document, 90, 60), mesh_size=10, correct=correct)
    document.saveAs(str(folder / "Test.FCStd"))
    App.closeDocument(document.Name)
    return folder / "Test.FCStd"


@pytest.fixture
def made(rectangle_file, tmp_path_factory):
    """The parts of that balloon in a document of its own, with nothing to undo."""
    return _opened(rectangle_file, tmp_path_factory.mktemp("document"))


@pytest.fixture
def fitted(fitted_file, tmp_path_factory):
    """The parts of the fitted one."""
    return _opened(fitted_file, tmp_path_factory.mktemp("document"))


def _opened(path, folder):
    document = App.openDocument(str(shutil.copy(path, folder)))
    document.clearUndos()
    hands.wait(0.1)
    return create.Parts(document.Outline, document.Balloon, document.Pattern)


@pytest.fixture
def opened(made):
    """The panel of a finished balloon."""
    made.balloon.ViewObject.Proxy.doubleClicked(made.balloon.ViewObject)
    hands.wait_until(hands.panel_is_seen)
    return made


@pytest.fixture(autouse=True)
def no_dialog():
    """Close a modal dialog that nobody expected, and fail: the test would hang."""
    seen = []

    def look():
        dialog = hands.QtWidgets.QApplication.activeModalWidget()
        if dialog is not None:
            seen.append(f"{dialog.metaObject().className()}: {dialog.windowTitle()}")
            dialog.close()

    timer = hands.QtCore.QTimer()
    timer.timeout.connect(look)
    timer.start(500)
    yield
    timer.stop()
    assert not seen


def _warm_up():
    """Every module is loaded: none takes over what a test has put in another one's place."""
    for package in (app, gui):
        for module in pkgutil.walk_packages(package.__path__, f"{package.__name__}."):
            importlib.import_module(module.name)
    hands.QtWidgets.QApplication.setEffectEnabled(hands.QtCore.Qt.UI_AnimateCombo, False)
    # the camera is where it was sent: FreeCAD from 1.0 on has it fly there
    App.ParamGet("User parameter:BaseApp/Preferences/View").SetBool("UseNavigationAnimations", False)


_warm_up()

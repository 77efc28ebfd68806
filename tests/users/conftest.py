# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's window fills the screen, and a user with hands of flesh sits in front of it."""

import sys
import time
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import pytest

sys.path.append(str(Path(__file__).resolve().parents[1] / "gui"))
sys.path.append(str(Path(__file__).resolve().parents[1] / "app"))
sys.path.append(str(Path(__file__).resolve().parents[1] / "core"))
sys.path.append(str(Path(__file__).resolve().parents[2] / "tools"))

import hands
from brush import close_window
from promises import sentences
from story import Story
from user import User

from BalloonWorkbench.core import faults

_ANSWERED = 15.0  # s, a modal box


@pytest.fixture(scope="session", autouse=True)
def window():
    main, size = Gui.getMainWindow(), hands.QtWidgets.QApplication.primaryScreen().size()
    hands.QtWidgets.QApplication.setEffectEnabled(hands.QtCore.Qt.UI_AnimateCombo, False)
    main.statusBar().clearMessage()
    main.showNormal()
    main.setGeometry(0, 0, size.width(), size.height())
    hands.wait(0.5)
    assert main.size() == size, "FreeCAD's window does not fit the screen"
    return main


@pytest.fixture(autouse=True)
def workbench(monkeypatch):
    """Our workbench, a clean window afterwards, and no fault of the program."""
    told, report = [], faults.report_fault

    def reported(error, doing):
        told.append(f"{doing}: {error!r}")
        return report(error, doing)

    monkeypatch.setattr(faults, "report_fault", reported)
    Gui.activateWorkbench("BalloonWorkbench")
    hands.wait(0.5)
    yield
    close_window()
    if hands.panel_is_open():
        hands.leave()
    for document in list(App.listDocuments()):
        App.closeDocument(document)
    for dock in hands.visible(hands.QtWidgets.QDockWidget):
        if dock.objectName() == "Report view":
            dock.hide()
    hands.wait(0.2)
    assert not told


@pytest.fixture
def user():
    someone = User()
    yield someone
    someone.close()


@pytest.fixture(autouse=True)
def no_box_forever():
    """A modal box that nobody answers would hold the test for good: it is closed, and the test fails."""
    left, since = [], {}

    def look():
        box = hands.QtWidgets.QApplication.activeModalWidget()
        if box is None:
            since.clear()
            return
        told = f"{box.metaObject().className()}: {box.windowTitle()}"
        if time.monotonic() > since.setdefault(told, hands.at_latest(_ANSWERED)):
            left.append(told)
            box.close()

    timer = hands.QtCore.QTimer()
    timer.timeout.connect(look)
    timer.start(1000)
    yield
    timer.stop()
    assert not left, f"nobody answers {left}"


@pytest.fixture
def story(request):
    """Named after its test; its end tells all faults."""
    told = Story(request.node.name.removeprefix("test_"))
    yield told
    told.end()


@pytest.fixture
def says(story):
    """Hold the tutorial to a sentence."""

    def hold(sentence, so):
        assert sentence in sentences(), f"the tutorial does not say: {sentence}"
        story.expect(so, f"not true: {sentence}")

    return hold

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Painting while documents come, go and change places: each painting stays with its document."""

import FreeCAD as App
import FreeCADGui as Gui
import hands
import pytest
from brush import close_window, draw, ellipse, fish_body, is_closed, open_window, press
from hands import QtCore, QtGui, QtWidgets

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.properties import preferences
from BalloonWorkbench.core.job import Settings
from BalloonWorkbench.gui.paint import window as paint_window


@pytest.fixture(autouse=True)
def nothing_left(monkeypatch):
    """Every balloon is made in a moment: whose it is does not depend on its mesh."""
    monkeypatch.setattr(preferences, "settings", lambda: Settings(correct=False, mesh_size=0.02))
    yield
    while paint_window._open:
        close_window()


def new_document_by_keys():
    """Ctrl+N, as the window has it."""
    before = set(App.listDocuments())
    main, key, ctrl = Gui.getMainWindow(), QtCore.Qt.Key_N, QtCore.Qt.ControlModifier
    main.activateWindow()
    target = QtWidgets.QApplication.focusWidget() or main
    for kind in (QtCore.QEvent.ShortcutOverride, QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
        QtWidgets.QApplication.sendEvent(
            target.window().windowHandle(), QtGui.QKeyEvent(kind, key, ctrl, "\x0e")
        )
    hands.wait(0.3)
    if (
        set(App.listDocuments()) == before
    ):  # without a window manager no window is active, and no key a shortcut
        Gui.runCommand("Std_New")
    hands.wait_until(lambda: set(App.listDocuments()) != before)
    hands.wait(0.3)
    return App.ActiveDocument


def in_front():
    shown = [window for window in paint_window._open if window.isVisible()]
    assert len(shown) <= 1
    return shown[0] if shown else None


def activate(doc):
    """A click on the document's tab."""
    area = Gui.getMainWindow().findChild(QtWidgets.QMdiArea)
    (view,) = Gui.getDocument(doc.Name).mdiViewsOfType("Gui::View3DInventor")
    window = view.graphicsView()
    sub = next(each for each in area.subWindowList() if each.isAncestorOf(window))
    area.setActiveSubWindow(sub)
    hands.wait_until(lambda: App.ActiveDocument == doc)
    hands.wait(0.3)


@pytest.mark.slow
def test_a_new_document_while_painting(doc):
    first = open_window()
    fish_body(first)
    hands.wait_until(first.scene.is_shown, 30)
    other = new_document_by_keys()
    assert in_front() is None
    assert not first.scene.is_shown()
    assert len(first.painting.steps) == 1
    second = open_window()
    assert second is not first
    assert second.doc == other
    assert second.painting.is_empty()
    draw(second.canvas, ellipse(0.5, 0.5, 0.2, 0.3))
    draw(second.canvas, ellipse(0.5, 0.5, 0.1, 0.1))
    hands.wait_until(second.scene.is_shown, 30)
    activate(doc)
    assert in_front() is first
    hands.wait_until(first.scene.is_shown, 30)
    assert not second.scene.is_shown()
    activate(other)
    assert in_front() is second
    assert len(second.painting.steps) == 2
    App.closeDocument(other.Name)
    hands.wait_until(lambda: in_front() is first, 10)
    assert paint_window._open == [first]
    press("PaintSizeDone") if first.card.isVisible() else None
    press("PaintMake")
    hands.wait_until(is_closed, 60)
    assert [doc.getObject(name).Status for name in ("Outline", "Balloon", "Pattern")] == [status.READY] * 3


def test_one_that_was_closed_by_hand_stays_closed(doc):
    first = open_window()
    fish_body(first)
    first.close()
    other = new_document_by_keys()
    activate(doc)
    assert in_front() is None
    activate(other)
    activate(doc)
    Gui.runCommand("BalloonWorkbench_Paint")
    assert in_front() is first
    assert len(first.painting.steps) == 1


@pytest.mark.works_out
def test_a_new_document_while_the_balloon_is_being_made(doc):
    window = open_window()
    window.live.settings = Settings(mesh_size=0.008)  # takes longer than a new document
    fish_body(window)
    press("PaintMake")
    assert window.making
    other = new_document_by_keys()
    assert not window.making
    assert other.Objects == doc.Objects == []
    activate(doc)
    assert in_front() is window
    assert len(window.painting.steps) == 1
    assert "Stopped" in window.form.hint.text() or window.live.is_busy()


@pytest.mark.slow
def test_another_painting_in_the_same_document_is_kept_too(doc):
    window = open_window()
    fish_body(window)
    hands.wait_until(window.live.is_settled, 60)
    if window.card.isVisible():
        press("PaintSizeDone")
    press("PaintMake")
    hands.wait_until(is_closed, 60)
    if hands.panel_is_open():
        hands.leave()
    unfinished = open_window()
    draw(unfinished.canvas, ellipse(0.5, 0.5, 0.2, 0.3))
    doc.Outline.ViewObject.Proxy.doubleClicked(doc.Outline.ViewObject)
    again = in_front()
    assert again is not unfinished
    assert again.parts is not None
    again.close()
    hands.wait(0.1)
    assert open_window() is unfinished
    assert len(unfinished.painting.steps) == 1
    App.closeDocument(doc.Name)
    hands.wait_until(is_closed, 30)

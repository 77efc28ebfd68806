# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a user does: look, wait, click and type; with real events, in the real window."""

import os
import threading
import time
from contextlib import contextmanager
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui

from BalloonWorkbench.app.host import qt
from BalloonWorkbench.gui.long_work import blocking
from BalloonWorkbench.gui.long_work.worker import Worker
from BalloonWorkbench.gui.panels.widgets.fields import Fields
from BalloonWorkbench.gui.panels.widgets.pages import Pages
from BalloonWorkbench.gui.qt import widgets_of

QtCore, QtGui, QtWidgets = qt()

_PATIENCE = 3.0  # the load is a mean of the last minute
_LARGE = 90  # of 100: a picture that is hardly packed takes a tenth of the time
SCREENSHOTS = Path(f"build/screenshots{os.environ.get('SUITE', '')}")


def wait(seconds=0.1):
    """Let the window live."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        QtWidgets.QApplication.processEvents()
        time.sleep(0.005)


def patience(seconds):
    """What these seconds of a machine without other work may take here at most.

    A test that passes never waits for it: it ends what will not come.
    """
    others = os.getloadavg()[0] / (os.cpu_count() or 1)  # programs for each core
    return _PATIENCE * seconds * max(others, 1.0)


def at_latest(seconds):
    """When they have passed, by time.monotonic()."""
    return time.monotonic() + patience(seconds)


def wait_until(condition, seconds=60.0, otherwise="it never happened"):
    """Let the window live until something is so."""
    end, pause = at_latest(seconds), 0.01
    while not condition():
        assert time.monotonic() < end, otherwise
        wait(pause)
        pause = min(1.5 * pause, 0.1)  # a look takes time from the work that is waited for
    wait(0.02)


@contextmanager
def work_held():
    """What threads begin meanwhile waits for the end of this, or to be stopped: so long it can be seen at
    work, however quick it is and however slow the window. But for what the window itself waits for.
    """
    go, run = threading.Event(), Worker.run

    def held(worker):
        while not (go.is_set() or worker._stop or isinstance(worker.request, blocking._Job)):
            time.sleep(0.005)
        run(worker)

    Worker.run = held
    try:
        yield
    finally:
        go.set()
        Worker.run = run


def can_be_used(widget):
    """It is on the screen and takes clicks: a panel comes there a moment after it was opened."""
    return widget.isVisible() and widget.isEnabled()


def reach(widget):
    """Wait until a widget can be used, as a hand does."""
    if not can_be_used(widget):
        wait_until(lambda: can_be_used(widget), 5, f"{widget.objectName()} cannot be used")


def turn_to(widget):
    """The same for one that may be on a page that is behind."""
    if not widget.isVisible() and panel_is_open():
        wait_until(panel_is_seen)
    if not widget.isVisible() and visible(Pages):
        show_tab(widget)
    reach(widget)


def visible(kind):
    """The widgets of a kind that can be seen.

    Not by findChildren of the main window: it would keep the Python shells of widgets that are deleted later.
    """
    return [widget for widget in widgets_of(kind) if widget.isVisible()]


def find(name):
    """The widget of this name in the open panel; its page is turned to when it is not there yet."""
    widget = _there(name)
    for pages in visible(Pages) if widget is None else ():
        for index in range(pages.count()):
            if widget is None:
                pages.setCurrentIndex(index)
                widget = _there(name)
    assert widget is not None, f"no widget {name}"
    return widget


def _there(name):
    window = Gui.getMainWindow()
    for fields in window.findChildren(Fields):
        if fields.has(name):
            return fields.widget(name)
    found = window.findChildren(QtWidgets.QWidget, name)
    return found[-1] if found else None


def open_flat(obj, command, tabs):
    """The tab that a command of ours opens on an object, among the open ones of its kind."""
    App.setActiveDocument(obj.Document.Name)
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(obj)
    wait(0.3)  # from FreeCAD 1.0 on that brings the 3D view to the front
    Gui.runCommand(f"BalloonWorkbench_{command}")
    return flat_tab(obj.Document, tabs)


def flat_tab(document, tabs):
    """The tab of a document that is in front, once it has its size."""
    (tab,) = [each for each in tabs if each.obj.Document == document]
    wait_until(lambda: tab.isVisible() and tab.frame.isMaximized(), 5)
    size = None
    while size != tab.view.size():
        size = tab.view.size()
        wait(0.1)
    return tab


def show_tab(widget):
    """Bring the tab that holds a widget to the front."""
    tabs = find("Steps")
    for index in range(tabs.count()):
        if tabs.widget(index) is not None and tabs.widget(index).isAncestorOf(widget):
            tabs.setCurrentIndex(index)
    wait(0.02)


def click(widget, x=None):
    """Press and release the left button in the middle of a widget, or x pixels from its left."""
    wait(0.02)
    reach(widget)
    middle = widget.rect().center()
    at = QtCore.QPointF(middle if x is None else QtCore.QPoint(x, middle.y()))
    there = QtCore.QPointF(widget.mapToGlobal(at.toPoint()))
    left, none = QtCore.Qt.LeftButton, QtCore.Qt.NoModifier
    for kind, buttons in (
        (QtCore.QEvent.MouseButtonPress, left),
        (QtCore.QEvent.MouseButtonRelease, QtCore.Qt.NoButton),
    ):
        event = QtGui.QMouseEvent(kind, at, at, there, left, buttons, none)
        QtWidgets.QApplication.sendEvent(widget, event)
    wait(0.05)


def key(widget, code, text="", held=QtCore.Qt.NoModifier):
    for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
        event = QtGui.QKeyEvent(kind, code, held, text)
        try:
            QtWidgets.QApplication.sendEvent(widget, event)
        except RuntimeError:  # the key has closed its panel
            assert kind == QtCore.QEvent.KeyRelease


def type_into(widget, text, confirm=True):
    """Replace what a line edit or spin box holds, letter by letter."""
    if widget.parent() is not None:
        turn_to(widget)
    line = widget if isinstance(widget, QtWidgets.QLineEdit) else widget.findChild(QtWidgets.QLineEdit)
    line.setFocus()
    line.selectAll()
    for letter in text:
        key(line, 0, letter)
    if confirm:
        key(line, QtCore.Qt.Key_Return, "\r")
    wait(0.05)


def choose(combo, text):
    """Take an entry of a combo box with the keyboard."""
    turn_to(combo)
    combo.setFocus()
    for _ in range(combo.count()):
        if combo.currentText() == text:
            break
        code = QtCore.Qt.Key_Down if combo.findText(text) > combo.currentIndex() else QtCore.Qt.Key_Up
        key(combo, code)
    wait(0.02)
    assert combo.currentText() == text


def tick(box):
    turn_to(box)
    click(box, x=8)


def panel_buttons():
    """The rows of buttons of panels, not of a box with a message."""
    rows = visible(QtWidgets.QDialogButtonBox)
    return [row for row in rows if not isinstance(row.window(), QtWidgets.QMessageBox)]


def press(name):
    """OK or Cancel of the open panel."""
    if panel_is_open() and not panel_is_seen():
        wait_until(panel_is_seen)
    boxes = panel_buttons()
    assert boxes, "no panel is open"
    click(boxes[0].button(getattr(QtWidgets.QDialogButtonBox, name)))


def leave():
    """Cancel the open panel, or close one that has nothing to take back."""
    wait_until(panel_is_seen)
    close_panel()


def close_panel():
    """The same for a panel that is on the screen."""
    box = panel_buttons()[0]
    press("Cancel" if box.button(QtWidgets.QDialogButtonBox.Cancel) else "Close")


def drag(widget, start, end, steps=6):
    """Press the left button at a point (x, y) of a widget, move to another one and let go."""
    left, none = QtCore.Qt.LeftButton, QtCore.Qt.NoModifier
    places = [
        QtCore.QPointF(*(a + (b - a) * step / steps for a, b in zip(start, end))) for step in range(steps + 1)
    ]
    kinds = [QtCore.QEvent.MouseButtonPress, *[QtCore.QEvent.MouseMove] * steps]
    for kind, at in [*zip(kinds, places), (QtCore.QEvent.MouseButtonRelease, places[-1])]:
        there = QtCore.QPointF(widget.mapToGlobal(at.toPoint()))
        button = QtCore.Qt.NoButton if kind == QtCore.QEvent.MouseMove else left
        held = QtCore.Qt.NoButton if kind == QtCore.QEvent.MouseButtonRelease else left
        QtWidgets.QApplication.sendEvent(widget, QtGui.QMouseEvent(kind, at, at, there, button, held, none))
        wait(0.02)


def panel_is_open():
    return bool(Gui.Control.activeDialog())


def panel_is_seen():
    """The open panel is on the screen: after its preferences, FreeCAD 1.1 brings it there a moment later."""
    return panel_is_open() and bool(panel_buttons())


def panel_is_closed():
    return not panel_is_open()


def message():
    """What the panel says."""
    return find("Message").text()


def screenshot(name):
    """Save the screen and return it."""
    SCREENSHOTS.mkdir(parents=True, exist_ok=True)
    wait(0.1)
    picture = QtWidgets.QApplication.primaryScreen().grabWindow(0)
    assert picture.save(str(SCREENSHOTS / f"{name}.png"), "PNG", _LARGE)
    return picture.toImage()

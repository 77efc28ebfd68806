# SPDX-License-Identifier: LGPL-2.1-or-later
"""Someone in front of the screen: every click and letter goes through the X server, as from a hand."""

import time
from contextlib import contextmanager
from functools import partial

import FreeCAD as App
import FreeCADGui as Gui
import hands
from pointer import LEFT, WHEEL_DOWN, WHEEL_UP, Pointer

from BalloonWorkbench.gui.paint import window as paint_window
from BalloonWorkbench.gui.paint.painting.layers import SIDE

QtCore, QtGui, QtWidgets = hands.QtCore, hands.QtGui, hands.QtWidgets
_OBJECT = 1001  # kind of the tree's items that are objects, in FreeCAD
_TRIES = 4
_LOOKS = 50  # at a widget that moves
_ANSWER = 10.0  # s in which the pointer has to arrive


class User:
    """One pair of hands; places are Qt's pixels of the screen."""

    def __init__(self):
        self.pointer = Pointer()

    def close(self):
        self.pointer.close()

    # mouse

    def go(self, place):
        """Move the pointer there and let the window see it."""
        self._move(place)
        end = time.monotonic() + _ANSWER
        while (QtGui.QCursor.pos() - place).manhattanLength() > 1:
            assert time.monotonic() < end, "the pointer never came"
            hands.wait(0.005)
        hands.wait(0.02)

    def click(self, what, button=LEFT, times=1):
        """Click into the middle of a widget, once it rests, or at a place."""
        place = what if isinstance(what, QtCore.QPoint) else _resting(what)
        self.go(place - QtCore.QPoint(1, 1))
        self.go(place)
        for _ in range(times):
            self.pointer.press(button)
            self.pointer.release(button)
            hands.wait(0.08)  # between two clicks of a hand
        hands.wait(0.1)

    def double_click(self, what):
        self.click(what, times=2)

    def drag(self, places, button=LEFT):
        """Press at the first place, move through the others and let go; each place may be a function."""
        self.go(places[0]() if callable(places[0]) else places[0])
        self.pointer.press(button)
        hands.wait(0.02)
        for place in places[1:]:
            self._move(place() if callable(place) else place)
            hands.wait(0.008)
        self.pointer.release(button)
        hands.wait(0.05)

    def turn_wheel(self, what, notches):
        """Turn the wheel over a widget, away from the hand when notches > 0."""
        self.go(middle(what))
        for _ in range(abs(notches)):
            self.pointer.press(WHEEL_UP if notches > 0 else WHEEL_DOWN)
            self.pointer.release(WHEEL_UP if notches > 0 else WHEEL_DOWN)
            hands.wait(0.05)

    def _move(self, place):
        ratio = QtWidgets.QApplication.primaryScreen().devicePixelRatio()
        self.pointer.move(place.x() * ratio, place.y() * ratio)

    # keyboard

    def key(self, *names):
        self.pointer.key(*names)
        hands.wait(0.1)

    def write(self, text):
        for letter in text:
            self.pointer.key(letter)
            hands.wait(0.01)
        hands.wait(0.05)

    def replace(self, field, text, confirm=True):
        """What is in a field or number box becomes another text."""
        show(field)
        line = field if isinstance(field, QtWidgets.QLineEdit) else field.findChild(QtWidgets.QLineEdit)
        _resting(line)
        self.click(line.mapToGlobal(QtCore.QPoint(12, line.height() // 2)))
        self.key("Ctrl", "a")
        self.write(text)
        if confirm:
            self.key("Return")

    # what FreeCAD offers

    def button(self, name):
        """Press one of our buttons by its object name."""
        self.click(shown(name))

    def choose(self, combo, text):
        """An entry of a combo box."""
        show(combo)
        self.click(combo)
        number = next(n for n in range(combo.count()) if text in combo.itemText(n))
        self.key("Home")
        for _ in range(number):
            self.key("Down")
        self.key("Return")
        hands.wait_until(lambda: text in combo.currentText(), 10)

    def command(self, name):
        """A command of ours: its button, or where the window is too narrow for it, its line in the menu."""
        for bar in hands.visible(QtWidgets.QToolBar):
            for action in bar.actions():
                button = bar.widgetForAction(action) if action.objectName() == name else None
                if button is not None and not button.visibleRegion().isEmpty():
                    hands.wait_until(button.isEnabled, 10)
                    self.click(button)
                    return
        self.menu(name)

    def menu(self, *names):
        """A command in our menu, through the menus on the way."""
        bar = Gui.getMainWindow().menuBar()
        action = next(a for a in bar.actions() if "Balloon" in a.text().replace("&", ""))
        self.click(bar.mapToGlobal(bar.actionGeometry(action).center()))
        for name in names:
            hands.wait_until(lambda name=name: _entry(name) is not None, 10)
            hands.wait(0.1)
            self.click(_entry(name))

    def open_in_tree(self, obj):
        """Double-click an object in the tree, which may still be moving: something opens."""
        for _ in range(_TRIES):
            self.double_click(self.in_tree(obj))
            hands.wait(1.0)
            if hands.panel_is_open() or any(window.isVisible() for window in paint_window._open):
                return
        raise AssertionError(f"{obj.Label} cannot be opened from the tree")

    def select(self, obj):
        """Click an object in the tree, which may still be moving."""
        for _ in range(_TRIES):
            self.click(self.in_tree(obj))
            if obj in Gui.Selection.getSelection():
                return
            hands.wait(0.6)
        raise AssertionError(f"{obj.Label} cannot be selected in the tree")

    def in_tree(self, obj):
        """Where an object is in the tree, on the screen."""
        found = []
        hands.wait_until(lambda: found.append(self._place_in_tree(obj)) or found[-1] is not None, 10)
        return found[-1]

    def _place_in_tree(self, obj):
        trees = [
            tree for tree in hands.visible(QtWidgets.QTreeWidget) if "Tree" in tree.metaObject().className()
        ]
        for tree in trees:
            for item in _items(tree.invisibleRootItem()):
                # a document may be called like what is in it
                if item.text(0) == obj.Label and item.type() == _OBJECT:
                    parent = item.parent()
                    while parent is not None:
                        parent.setExpanded(True)
                        parent = parent.parent()
                    tree.scrollToItem(item)
                    hands.wait(0.2)
                    box = tree.visualItemRect(item)
                    at = QtCore.QPoint(box.left() + min(60, box.width() - 6), box.center().y())
                    return tree.viewport().mapToGlobal(at)
        return None

    def panel(self, name):
        """A button of the open panel's row: "Ok", "Cancel", "Close"."""
        hands.wait_until(hands.panel_is_seen)
        row = hands.panel_buttons()[0]  # kept: its buttons go with what Python knows of it
        button = row.button(getattr(QtWidgets.QDialogButtonBox, name))
        assert button is not None, f"the panel has no {name}"
        show(button)  # FreeCAD 0.20 scrolls the row away with the rest
        self.click(button)

    # on the paper

    def paint(self, canvas, places):
        """One stroke through places of the paper, 0 to 1, y down, with the tool that is chosen."""
        steps = len(canvas.painting.steps)
        self.drag([partial(on_paper, canvas, place) for place in places])  # where the paper is by then
        hands.wait_until(lambda: len(canvas.painting.steps) != steps, 10)

    @contextmanager
    def answering(self, text, kind="FileDialog", then=lambda: None, expected=True):
        """Type a text into the next box of FreeCAD or Qt whose class or name is so, and confirm it.

        The list is empty until then. The box may keep whoever opened it until it is closed.
        then  what is done between typing and confirming
        """
        done = []

        def look():
            dialogs = hands.visible(QtWidgets.QDialog)
            boxes = [d for d in dialogs if kind in f"{d.metaObject().className()} {d.objectName()}"]
            if boxes and not done:
                done.append(True)
                hands.wait(0.3)
                self.key("Ctrl", "a")
                self.write(str(text))
                hands.wait(0.3)
                then()
                self.key("Return")

        timer = QtCore.QTimer()
        timer.timeout.connect(look)
        timer.start(300)
        yield done
        timer.stop()
        assert done or not expected, f"no {kind} came"


def _entry(name):
    """Where an entry of the open menus is on the screen, by its name or its text; None without one."""
    for menu in hands.visible(QtWidgets.QMenu):
        for action in menu.actions():
            if name in (action.objectName(), action.text().replace("&", "")):
                return menu.mapToGlobal(menu.actionGeometry(action).center())
    return None


def _items(item):
    for number in range(item.childCount()):
        yield item.child(number)
        yield from _items(item.child(number))


def middle(widget):
    assert widget.isVisible(), f"{widget.objectName()} cannot be seen"
    hands.wait_until(widget.isEnabled, 20)
    return widget.mapToGlobal(widget.visibleRegion().boundingRect().center())


def _resting(widget):
    """The middle of a widget that a panel may be laying out anew."""
    places = [None]
    while len(places) < 2 or places[-1] != places[-2]:
        places.append(middle(widget))
        hands.wait(0.06)
        assert len(places) < _LOOKS, f"{widget.objectName()} never rests"
    return places[-1]


def shown(name):
    """The widget of ours with this name, scrolled to."""
    widget = hands.find(name)
    show(widget)
    return widget


def show(widget):
    """Turn to the page of a widget in the balloon's panel, and scroll to it."""
    if not widget.isVisible():
        hands.show_tab(widget)
    for area in hands.visible(QtWidgets.QScrollArea):
        if area.isAncestorOf(widget):
            area.ensureWidgetVisible(widget)
    hands.wait(0.05)


def on_paper(canvas, place):
    at = canvas.paper.to_screen(QtCore.QPointF(place[0] * SIDE, place[1] * SIDE))
    return canvas.mapToGlobal(at.toPoint())


def label(name):
    """The object of the active document with this label."""
    (obj,) = App.ActiveDocument.getObjectsByLabel(name)
    return obj

# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is wrong with an open panel for those who cannot see it or do not use a mouse.

Names are those that Qt gives a screen reader; an order is that of the Tab key.
"""

import gc
import re
from collections import Counter
from itertools import pairwise

import hands

QtCore, QtGui, QtWidgets = hands.QtCore, hands.QtGui, hands.QtWidgets
Qt = QtCore.Qt

_INTERACTIVE = (
    QtWidgets.QAbstractButton,
    QtWidgets.QLineEdit,
    QtWidgets.QComboBox,
    QtWidgets.QAbstractSpinBox,
    QtWidgets.QAbstractSlider,
    QtWidgets.QAbstractItemView,
    QtWidgets.QTextEdit,
    QtWidgets.QPlainTextEdit,
)
#: What is in them is theirs, as the line in a spin box; the buttons of a panel are FreeCAD's.
_HOLDERS = (
    QtWidgets.QComboBox,
    QtWidgets.QAbstractSpinBox,
    QtWidgets.QAbstractItemView,
    QtWidgets.QDialogButtonBox,
)
_MNEMONIC = re.compile(r"(?<!&)&(?!&)(\w)")
_KEY = re.compile(r"\((\w+\+)*\w+\)$")
_MOST_STOPS = 200  # of the whole window
_OURS = "BalloonWorkbench."


def faults(top):
    """A line for each fault of the widgets in a panel that are on the screen."""
    gc.disable()  # Python would delete widgets of the panel before amid the look at them
    try:
        widgets = interactive(top)
        reach = [*_without_keys(widgets), *_out_of_order(top, widgets)]
        return [*_nameless(widgets), *reach, *_doubled(widgets)]
    finally:
        gc.enable()


def interactive(top):
    """What users work with in it: not the parts of a widget, nor what FreeCAD puts around a panel."""
    inside = _inside(top)
    holders = [each for each in inside if isinstance(each, _HOLDERS)]
    return [
        each
        for each in inside
        if _is_interactive(each)
        and not _is_part(each)
        and not any(box is not each and box.isAncestorOf(each) for box in holders)
    ]


def _inside(top):
    """Python must not learn of their parents: it would keep the shells of widgets that are deleted later."""
    return [each for each in hands.visible(QtWidgets.QWidget) if top is each or top.isAncestorOf(each)]


def _is_interactive(widget):
    return isinstance(widget, _INTERACTIVE) or _has_own(widget, "mousePressEvent")


def _has_own(widget, handler):
    """A class of ours handles these events: a widget that is drawn, and clicked into."""
    ours = [kind for kind in type(widget).__mro__ if kind.__module__.startswith(_OURS)]
    return any(handler in vars(kind) for kind in ours)


def _is_part(widget):
    """Of what Qt and FreeCAD put around a panel and into a widget."""
    kind = widget.metaObject().className()
    if widget.objectName().startswith(("qt_", "OBTN ")) or isinstance(widget, QtWidgets.QScrollBar):
        return True
    return kind.startswith(("QSint::", "Gui::TaskView", "Gui::ExpressionLabel", "QDockWidget"))


def described(widget):
    """For the reader of a fault."""
    text = widget.text()[:40] if hasattr(widget, "text") else ""
    return f"{type(widget).__name__} {widget.objectName()} {text!r}"


def name_of(widget):
    """What a screen reader says first of a widget: not what it holds, "Helium" does not say of what."""
    name = QtGui.QAccessible.queryAccessibleInterface(widget).text(QtGui.QAccessible.Name)
    held = widget.currentText() if isinstance(widget, QtWidgets.QComboBox) else ""
    return widget.accessibleName() or ("" if name == held else name)


def _nameless(widgets):
    for widget in widgets:
        if not any(letter.isalnum() for letter in name_of(widget)):
            yield f"{described(widget)} has no name"


def _without_keys(widgets):
    """A group of buttons of which one is chosen is one stop: arrows go on from there. A tool of a canvas may
    have a key of its own instead, which stands in its tip.
    """
    for widget in widgets:
        reached = widget.focusPolicy() & Qt.TabFocus or _is_shared(widget) or _KEY.search(widget.toolTip())
        if not reached:
            yield f"{described(widget)} cannot be reached with Tab"
        if _has_own(widget, "mousePressEvent") and not _has_own(widget, "keyPressEvent"):
            yield f"{described(widget)} takes the mouse and no keys"


def _is_shared(widget):
    group = widget.group() if isinstance(widget, QtWidgets.QAbstractButton) else None
    return group is not None and any(each.focusPolicy() & Qt.TabFocus for each in group.buttons())


def tab_order(widgets):
    """Widgets in the order in which the Tab key comes to them, from the first one of the panel.

    By the key itself: by nextInFocusChain, Python holds the next widget for a part of the one before.
    """
    first = next((each for each in widgets if each.focusPolicy() & Qt.TabFocus and each.isEnabled()), None)
    if first is None:
        return []
    first.setFocus()
    hands.wait_until(lambda: QtWidgets.QApplication.focusWidget() is not None, 5)
    order, stops = [first], 0
    while stops < _MOST_STOPS:
        hands.key(QtWidgets.QApplication.focusWidget(), Qt.Key_Tab, "\t")
        reached, stops = QtWidgets.QApplication.focusWidget(), stops + 1
        if reached in order:
            break
        if reached in widgets:
            order.append(reached)
    return order


def _out_of_order(top, widgets):
    """Lines from the top, and within a line from where reading begins."""
    order = tab_order(sorted(widgets, key=lambda each: (_place(top, each).top(), _place(top, each).left())))
    for one, other in pairwise(order):
        before, after = _place(top, one), _place(top, other)
        beside = before.top() < after.bottom() and after.top() < before.bottom()
        back = after.right() <= before.left()
        if top.layoutDirection() == Qt.RightToLeft:
            back = after.left() >= before.right()
        if (beside and back) or after.bottom() <= before.top():
            yield f"Tab goes back from {described(one)} to {described(other)}"


def _place(top, widget):
    return QtCore.QRect(widget.mapTo(top, QtCore.QPoint(0, 0)), widget.size())


def _doubled(widgets):
    """Two widgets for one key with Alt."""
    letters = Counter(
        match.group(1).lower()
        for widget in widgets
        if isinstance(widget, QtWidgets.QAbstractButton)
        for match in _MNEMONIC.finditer(widget.text())
    )
    for letter, count in letters.items():
        if count > 1:
            yield f"Alt+{letter} is there {count} times"

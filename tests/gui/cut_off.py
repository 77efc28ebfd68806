# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is wrong with the looks of an open panel: what is cut off, and scroll bars that nobody can follow."""

import re

import hands

from BalloonWorkbench.gui.panels.widgets.narrow import ElidedCombo

QtCore, QtGui, QtWidgets = hands.QtCore, hands.QtGui, hands.QtWidgets

_SLACK = 2  # px
_READ = 0.8  # of the entry of a choice that shows an ellipsis in place of its end
_QTS_OWN = ("qt_dockwidget_floatbutton", "qt_dockwidget_closebutton", "ScrollLeftButton", "ScrollRightButton")


def faults(top):
    """A line for each fault of the widgets of a panel, as they are on the screen."""
    widgets = [widget for widget in hands.visible(QtWidgets.QWidget) if top.isAncestorOf(widget)]
    areas = [widget for widget in widgets if isinstance(widget, QtWidgets.QScrollArea)]
    return [
        line
        for widget in widgets
        for line in (*_narrow(widget), *_outside(widget, areas), *_scrolls(widget, areas), *_address(widget))
    ]


def _name(widget):
    text = widget.text()[:40] if hasattr(widget, "text") else ""
    return f"{widget.metaObject().className()} {widget.objectName()} {text!r}"


def _narrow(widget):
    """Texts and signs for which there is no room."""
    if isinstance(widget, QtWidgets.QTabBar):
        yield from _tabs(widget)
        return
    room = widget.width() + _SLACK
    if isinstance(widget, QtWidgets.QLabel) and widget.text():
        if widget.wordWrap():
            if widget.heightForWidth(widget.width()) > widget.height() + _SLACK:
                yield f"{_name(widget)} is too low: {widget.height()} px"
            room_of_words = widget.minimumSizeHint().width()
            if room_of_words > room:
                yield f"{_name(widget)} has a word that is cut off: {widget.width()} px of {room_of_words}"
        elif widget.sizeHint().width() > room and not hasattr(widget, "elided_text"):
            yield f"{_name(widget)} is cut off: {widget.width()} px of {widget.sizeHint().width()}"
    elif isinstance(widget, QtWidgets.QAbstractButton):
        needed = widget.minimumSizeHint().width()
        own = widget.metaObject().className().startswith("Gui::") or widget.objectName() in _QTS_OWN
        if needed > room and not own:
            yield f"{_name(widget)} is cut off: {widget.width()} px of {needed}"
    elif isinstance(widget, QtWidgets.QComboBox):
        needed = widget.fontMetrics().boundingRect(widget.currentText()).width() + 24
        if isinstance(widget, ElidedCombo):
            needed *= _READ
        if needed > room:
            yield f"{_name(widget)} {widget.currentText()!r} is cut off: {widget.width()} px of {needed}"
    elif isinstance(widget, QtWidgets.QListWidget) and widget.count():
        last = widget.visualItemRect(widget.item(widget.count() - 1)).bottom()
        if last > widget.viewport().height() + _SLACK and not widget.verticalScrollBar().isVisible():
            yield f"{_name(widget)} is too low: {widget.viewport().height()} px of {last}"
    elif isinstance(widget, QtWidgets.QLineEdit):
        needed = widget.fontMetrics().boundingRect(widget.text() or widget.placeholderText()).width() + 6
        if needed > room:
            yield f"{_name(widget)} is cut off: {widget.width()} px of {needed}"


def _address(widget):
    """Tooltips that show where a file of the program is."""
    if isinstance(widget, QtWidgets.QAbstractButton) and re.search(r"file:|(^|\s)/\w+/", widget.toolTip()):
        yield f"{_name(widget)} has a file address as its tooltip: {widget.toolTip()!r}"


def _tabs(bar):
    for index in range(bar.count()):
        place, text = bar.tabRect(index), bar.tabText(index)
        if place.right() > bar.width() + _SLACK or place.left() < -_SLACK:
            yield f"tab {text!r} is off its bar"
        if bar.fontMetrics().boundingRect(text).width() > place.width() - 8:
            yield f"tab {text!r} is cut off: {place.width()} px"
    for button in bar.findChildren(QtWidgets.QToolButton):
        if button.isVisible():
            yield "tabs have to be scrolled"
            return


def _outside(widget, areas):
    """Sideways out of what scrolls."""
    for area in areas:
        port = area.viewport()
        if not port.isAncestorOf(widget):
            continue
        left = widget.mapTo(port, QtCore.QPoint(0, 0)).x()
        if left < -_SLACK or left + widget.width() > port.width() + _SLACK:
            yield f"{_name(widget)} reaches out of its area: {left} + {widget.width()} px of {port.width()}"
            return


def _scrolls(widget, areas):
    """Bars across, and bars within bars."""
    if not isinstance(widget, QtWidgets.QAbstractScrollArea):
        return
    if widget.horizontalScrollBar().isVisible():
        yield f"{_name(widget)} scrolls sideways"
    outer = [
        area
        for area in areas
        if area is not widget and area.isAncestorOf(widget) and area.verticalScrollBar().isVisible()
    ]
    if widget.verticalScrollBar().isVisible() and outer:
        yield f"{_name(widget)} scrolls inside what scrolls"


def buttons_off_screen(window):
    """OK and Cancel of a panel that cannot be reached."""
    for row in hands.panel_buttons():
        for button in row.buttons():
            low = button.mapTo(window, QtCore.QPoint(0, 0))
            if not window.rect().contains(QtCore.QRect(low, button.size())):
                yield f"{_name(button)} is off the window"

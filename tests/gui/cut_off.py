# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is wrong with the looks of an open panel: what is cut off, and scroll bars that nobody can follow."""

import re

import hands

from BalloonWorkbench.gui.panels.widgets.narrow import ElidedCombo
from BalloonWorkbench.gui.wrapping import CheckBox, PictureButton, PushButton

QtCore, QtGui, QtWidgets = hands.QtCore, hands.QtGui, hands.QtWidgets

WRAPPING = (CheckBox, PushButton, PictureButton)
_SLACK = 2  # px
_READ = 0.8  # of the entry of a choice that shows an ellipsis in place of its end
_LONGER = 1.4  # times, than it is in any language: what pseudo.py adds to a text, at its end
_QTS_OWN = ("qt_dockwidget_floatbutton", "qt_dockwidget_closebutton", "ScrollLeftButton", "ScrollRightButton")


def faults(top):
    """A line for each fault of the widgets of a panel, as they are on the screen."""
    widgets = [widget for widget in hands.visible(QtWidgets.QWidget) if top.isAncestorOf(widget)]
    areas = [widget for widget in widgets if isinstance(widget, QtWidgets.QScrollArea)]
    return [
        line
        for widget in widgets
        for line in (
            *_narrow(widget),
            *_outside(widget, areas),
            *_scrolls(widget, areas),
            *_address(widget),
            *_below(widget, widgets, areas),
        )
    ]


def _name(widget):
    text = widget.text()[:40] if hasattr(widget, "text") else ""
    return f"{widget.metaObject().className()} {widget.objectName()} {text!r}"


def _narrow(widget):
    """Texts and signs for which there is no room."""
    for kind, check in _NARROW.items():
        if isinstance(widget, kind):
            yield from check(widget)
            return


def _narrow_label(label):
    if not label.text():
        return
    room = label.width() + _SLACK
    if not label.wordWrap():
        if label.sizeHint().width() > room and not hasattr(label, "elided_text"):
            yield f"{_name(label)} is cut off: {label.width()} px of {label.sizeHint().width()}"
        return
    if label.heightForWidth(label.width()) > label.height() + _SLACK:
        yield f"{_name(label)} is too low: {label.height()} px"
    room_of_words = label.minimumSizeHint().width()
    if room_of_words > room:
        yield f"{_name(label)} has a word that is cut off: {label.width()} px of {room_of_words}"


def _narrow_button(button):
    needed = button.minimumSizeHint().width()
    own = button.metaObject().className().startswith("Gui::") or button.objectName() in _QTS_OWN
    if needed > button.width() + _SLACK and not own:
        yield f"{_name(button)} is cut off: {button.width()} px of {needed}"
    if isinstance(button, WRAPPING) and button.sizeHint().height() > button.height() + _SLACK:
        yield f"{_name(button)} is too low: {button.height()} px of {button.sizeHint().height()}"


def _narrow_combo(combo):
    needed = combo.fontMetrics().boundingRect(combo.currentText()).width() + 24
    if isinstance(combo, ElidedCombo):
        needed *= _READ / _longer(combo.currentText())
    if needed > combo.width() + _SLACK:
        yield f"{_name(combo)} {combo.currentText()!r} is cut off: {combo.width()} px of {needed}"


def _low_list(rows):
    if not rows.count():
        return
    last = rows.visualItemRect(rows.item(rows.count() - 1)).bottom()
    if last > rows.viewport().height() + _SLACK and not rows.verticalScrollBar().isVisible():
        yield f"{_name(rows)} is too low: {rows.viewport().height()} px of {last}"


def _narrow_field(field):
    """Its tip may have the whole text."""
    if field.text() and field.text() in field.toolTip():
        return
    needed = field.fontMetrics().boundingRect(field.text() or field.placeholderText()).width() + 6
    if not field.text():  # Qt shows an ellipsis in place of the end of a hint
        needed /= _longer(field.placeholderText())
    if needed > field.width() + _SLACK:
        yield f"{_name(field)} is cut off: {field.width()} px of {needed}"


def _longer(text):
    return _LONGER if text.startswith("[") and text.endswith("]") else 1.0


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


_NARROW = {
    QtWidgets.QTabBar: _tabs,
    QtWidgets.QLabel: _narrow_label,
    QtWidgets.QAbstractButton: _narrow_button,
    QtWidgets.QComboBox: _narrow_combo,
    QtWidgets.QListWidget: _low_list,
    QtWidgets.QLineEdit: _narrow_field,
}


def _outside(widget, areas):
    """Sideways out of what scrolls. FreeCAD's frames are as wide as their title: what is in them counts."""
    if widget.metaObject().className().startswith("Gui::TaskView::"):
        return
    for area in areas:
        port = area.viewport()
        if not port.isAncestorOf(widget):
            continue
        left = widget.mapTo(port, QtCore.QPoint(0, 0)).x()
        if left < -_SLACK or left + widget.width() > port.width() + _SLACK:
            yield f"{_name(widget)} reaches out of its area: {left} + {widget.width()} px of {port.width()}"
            return


def _below(widget, widgets, areas):
    """Lower than what it is in, which cuts it off without a bar that scrolls."""
    if not isinstance(widget, (QtWidgets.QAbstractButton, QtWidgets.QLabel, QtWidgets.QLineEdit)):
        return
    for around in widgets:
        inner = any(around.isAncestorOf(area) and area.isAncestorOf(widget) for area in areas)
        if not around.isAncestorOf(widget) or inner or around.objectName() == "qt_scrollarea_viewport":
            continue
        low = widget.mapTo(around, QtCore.QPoint(0, widget.height())).y()
        if low > around.height() + _SLACK and around not in areas:
            yield f"{_name(widget)} is cut off below: {around.height()} px of {low}"
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

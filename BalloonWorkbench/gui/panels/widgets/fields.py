# SPDX-License-Identifier: LGPL-2.1-or-later
"""Widgets tied to properties: they show the value, write it back and take expressions."""

from __future__ import annotations

from collections.abc import Callable

import FreeCAD as App
import FreeCADGui as Gui

from BalloonWorkbench.app.properties.property_table import Property
from BalloonWorkbench.gui.panels.widgets.narrow import ElidedCombo, NarrowForm
from BalloonWorkbench.gui.panels.widgets.whole_box import WholeBox
from BalloonWorkbench.gui.qt import QtCore, QtGui, QtWidgets, translate
from BalloonWorkbench.gui.window.sentences import translated
from BalloonWorkbench.gui.wrapped_check import WrappedCheck

_SEEN = 0.01  # mm, between what is shown and its rounded text
_MOST = 1000  # of a whole number that is no option
_MIN_WIDTH, _MAX_WIDTH = 120, 170  # px; a task panel may be 190 px wide
_BESIDE = 64  # px of a number box for its arrows, the sign of its expression and its frame


#: Of a quantity property: the unit for plain numbers, and the usual step, in FreeCAD's own units.
UNITS = {
    "Length": ("mm", 1.0),
    "Angle": ("deg", 5.0),
    "Pressure": ("kPa", 0.1),
    "Volume": ("l", 1e5),
}


class ReturnKey(QtCore.QObject):
    """Lets Return confirm what was typed; with nothing typed it is the panel's OK."""

    def __init__(self, widget, confirm):
        super().__init__(widget)
        self._confirm = confirm
        widget.installEventFilter(self)

    def eventFilter(self, widget, event):
        is_return = event.type() == QtCore.QEvent.KeyPress and event.key() in (
            QtCore.Qt.Key_Return,
            QtCore.Qt.Key_Enter,
        )
        if not is_return:
            return False
        line = widget if isinstance(widget, QtWidgets.QLineEdit) else widget.findChild(QtWidgets.QLineEdit)
        typed = line.isModified()
        if typed:
            self._confirm()
            line.setModified(False)
        return typed


class Fields(QtCore.QObject):
    """The fields of one object. `changed` carries the name of a property that the user has edited."""

    changed = QtCore.Signal(str)

    def __init__(self, obj, parent=None):
        super().__init__(parent)
        self.obj = obj
        self._widgets: dict[str, tuple] = {}
        self._bound: set[str] = set()
        self._free: dict[str, Callable[[], float]] = {}

    def of(self, item: Property, free: Callable[[], float] | None = None):
        """The field of a property; free: see `quantity`."""
        option = item.option
        if item.type in UNITS:
            unit, step = UNITS[item.type]
            own = option.step if option is not None else None
            return self.quantity(item.name, unit, own or step, free)
        if item.type in ("Float", "FloatConstraint"):
            return self.number(item.name, option.step, option.decimals, option.most)
        if item.type == "Integer":
            least, most = (option.least, option.most) if option is not None else (0, _MOST)
            return self.whole(item.name, int(least), int(most))
        if item.type == "Bool":
            return self.check(item.name, translate(item.label))
        return self.choice(item.name) if item.type == "Enumeration" else self.text(item.name)

    def quantity(self, name: str, unit: str, step: float = 1.0, free: Callable[[], float] | None = None):
        """A spin box for a quantity property; `unit` is the one for plain numbers.

        free  what a value of 0 comes to, which is shown in its place
        """
        if free is not None:
            self._free[name] = free
        widget = new_quantity_box()
        widget.setProperty("unit", unit)
        self._add_number(name, widget, step, lambda value: value.Value)
        return widget

    def number(self, name: str, step: float, decimals: int, most: float):
        """A spin box for a plain number from 0 on."""
        widget = new_quantity_box()
        widget.setProperty("decimals", decimals)  # heard by newer FreeCADs only
        widget.setProperty("minimum", 0.0)
        widget.setProperty("maximum", most)
        self._add_number(name, widget, step, float)
        return widget

    def whole(self, name: str, least: int, most: int):
        """A spin box for a whole number."""
        widget = WholeBox(lambda expression: self._express(name, expression))
        widget.setRange(least, most)
        widget.setKeyboardTracking(False)
        self._bound.add(name)
        self._add(name, widget, widget.setValue)
        widget.valueChanged.connect(lambda value: self._write(name, value))
        return widget

    def text(self, name: str):
        """A line of text."""
        widget = QtWidgets.QLineEdit()
        self._add(name, widget, widget.setText)
        widget.editingFinished.connect(lambda: self._write(name, widget.text()))
        ReturnKey(widget, widget.editingFinished.emit)
        return widget

    def check(self, name: str, text: str):
        """A check box for a Boolean."""
        widget = WrappedCheck(text)
        self._add(name, widget, widget.setChecked)
        widget.toggled.connect(lambda value: self._write(name, value))
        return widget

    def choice(self, name: str):
        """A combo box for an enumeration."""
        widget = ElidedCombo()
        for entry in self.obj.getEnumerationsOfProperty(name):
            widget.addItem(translated(entry), entry)
        self._add(name, widget, lambda value: widget.setCurrentIndex(widget.findData(value)))
        widget.activated.connect(lambda index: self._write(name, widget.itemData(index)))
        return widget

    def has(self, name: str) -> bool:
        """There is a field of this property."""
        return name in self._widgets

    def widget(self, name: str):
        """The field of a property."""
        return self._widgets[name][0]

    def refresh(self) -> None:
        """Show the present values, and which of them can be edited."""
        driven = dict(self.obj.ExpressionEngine)
        for name, (widget, show) in self._widgets.items():
            blocked = widget.blockSignals(True)
            show(getattr(self.obj, name))
            if self._is_free(name):
                widget.setProperty("rawValue", self._free[name]())
            widget.blockSignals(blocked)
            _give_room(widget)
            if isinstance(widget, WholeBox):
                widget.show_expression(driven.get(name, ""))
            # a field with an expression shows it by its sign f(x), behind which it can be changed
            free = name not in driven or name in self._bound
            widget.setEnabled("ReadOnly" not in self.obj.getEditorMode(name) and free)

    def finish_typing(self) -> None:
        """Take over a number that is still being typed."""
        for widget, _ in self._widgets.values():
            if isinstance(widget, QtWidgets.QAbstractSpinBox):
                _confirm(widget)
            elif isinstance(widget, QtWidgets.QLineEdit):
                widget.editingFinished.emit()

    def _add_number(self, name: str, widget, step: float, as_number) -> None:
        """Tie a spin box to a property; as_number turns its value into a number."""
        widget.setProperty("singleStep", step)
        Gui.ExpressionBinding(widget).bind(self.obj, name)
        self._bound.add(name)
        widget.setKeyboardTracking(False)
        self._add(name, widget, lambda value: widget.setProperty("rawValue", as_number(value)))
        QtCore.QObject.connect(
            widget, QtCore.SIGNAL("valueChanged(double)"), lambda value: self._write(name, value)
        )

    def _add(self, name: str, widget, show) -> None:
        widget.setObjectName(name)
        if not isinstance(widget, QtWidgets.QCheckBox):
            widget.setMinimumWidth(_MIN_WIDTH)
        widget.setToolTip(translate(self.obj.getDocumentationOfProperty(name), "App::Property"))
        self._widgets[name] = widget, show
        if isinstance(widget, QtWidgets.QAbstractSpinBox):
            ReturnKey(widget, lambda: _confirm(widget))

    def release(self) -> None:
        """The object may be gone from now on: a field that loses the focus writes once more."""
        self.obj = None
        self._widgets.clear()  # see new_quantity_box

    def _express(self, name: str, expression: str) -> None:
        """Let an expression give a whole number; ValueError when it gives none."""
        if not expression:
            self.obj.setExpression(name, None)
            self.refresh()
            return
        try:
            value = round(float(self.obj.evalExpression(expression)))
            self.obj.setExpression(name, expression)
        except (App.Base.FreeCADError, ArithmeticError, RuntimeError, TypeError, ValueError) as error:
            raise ValueError(translate("This gives no whole number: {}").format(error)) from error
        setattr(self.obj, name, value)
        self.refresh()
        self.changed.emit(name)

    def _is_free(self, name: str) -> bool:
        return name in self._free and not getattr(self.obj, name).Value

    def _write(self, name: str, value) -> None:
        if self.obj is None:
            return
        if self._is_free(name) and abs(value - self._free[name]()) < _SEEN:
            return  # what was shown in place of 0
        present = getattr(self.obj, name)
        if getattr(present, "Value", present) != value:
            setattr(self.obj, name, value)
            self.changed.emit(name)


class PropertyForm(NarrowForm):
    """A form with a row for each property that has a label; those that have no effect are hidden."""

    def __init__(self, fields: Fields, *parent):
        super().__init__(*parent)
        self.fields = fields
        self._rows: dict[str, tuple] = {}

    def add(
        self, item: Property, free: Callable[[], float] | None = None, describe: Callable | None = None
    ) -> None:
        """The row of a property; free: see `Fields.quantity`; describe gives its field other texts."""
        field = self.fields.of(item, free)
        if describe is not None:
            describe(field)
        if item.type == "Bool":
            self._rows[item.name] = (field,)
            self.addRow(field)
            return
        label = QtWidgets.QLabel(translate(item.label))
        label.setBuddy(field)
        self._rows[item.name] = label, field
        self.addRow(label, field)

    def refresh(self) -> None:
        """Show the values, and only those that have an effect."""
        self.fields.refresh()
        for name in self._rows:
            self.show_row(name, "Hidden" not in self.fields.obj.getEditorMode(name))

    def show_row(self, name: str, visible: bool) -> None:
        """Show a row or hide it."""
        for widget in self._rows[name]:
            self.show_widget(widget, visible)


class PropertyPage(QtWidgets.QWidget):
    """A page of a panel that edits an object: `changed` follows each edit, `refused` carries a message."""

    changed = QtCore.Signal()
    refused = QtCore.Signal(str)

    def __init__(self, obj):
        super().__init__()
        self.obj = obj
        self.fields = Fields(obj, self)
        self.form = PropertyForm(self.fields, self)
        self.fields.changed.connect(self.edited)

    def edited(self, _name: str) -> None:
        """The user has edited a property."""
        self.changed.emit()

    def finish_typing(self) -> None:
        """Take over what is still being typed."""
        self.fields.finish_typing()

    def refresh(self) -> None:
        """Show the values."""
        self.form.refresh()

    def release(self) -> None:
        """The panel closes."""
        self.fields.release()


def _give_room(widget) -> None:
    """Let what a field says be seen whole: fonts differ, and themes give fields least widths of their own."""
    widget.ensurePolished()  # a theme gives it a font and a least width only then
    if isinstance(widget, QtWidgets.QAbstractSpinBox):
        width = widget.fontMetrics().horizontalAdvance(widget.text()) + _BESIDE
    elif isinstance(widget, QtWidgets.QComboBox):
        width = widget.sizeHint().width()
    else:
        return
    widget.setMinimumWidth(min(max(width, _MIN_WIDTH), _MAX_WIDTH))


def new_quantity_box():
    """FreeCAD's spin box for quantities, which takes expressions; also for numbers without a unit.

    Python is not told when Qt deletes what FreeCAD has made. As long as anything holds the shell of such a
    widget, a new one at the same address gets that shell, dead or of another kind. The next lies elsewhere.
    """
    unusable = []
    while True:
        box = Gui.UiLoader().createWidget("Gui::QuantitySpinBox")
        try:
            box.objectName()
            usable = isinstance(box, QtWidgets.QAbstractSpinBox)
        except RuntimeError:
            usable = False
        if usable:
            return box
        unusable.append(box)


def _confirm(spin_box) -> None:
    """Let a spin box take its text: as Return does, but heard by nobody else."""
    spin_box.event(QtGui.QKeyEvent(QtCore.QEvent.KeyPress, QtCore.Qt.Key_Return, QtCore.Qt.NoModifier))

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Widgets for a panel that may be narrow: nothing in them is cut off, nothing scrolls inside the panel."""

from __future__ import annotations

from BalloonWorkbench.gui.accessible import name_field
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, number_of, painter_on, widgets_of

_ANY = 1_000_000  # px
_ROOM = 180  # px, for a name and its field in a panel as FreeCAD opens it
_VALUE = 60  # px, for a value beside its name: it may have several lines
_ARROW = 24  # px, and the frame, beside an entry
_LEVELS = 8  # of widgets from a row of a page to what scrolls
_BESIDE = 4  # px, that themes leave free at the sides of an entry


def fit_heights() -> None:
    """Let all that is open take its height now: Qt hands it up by a level in each turn of the event loop, and
    until it is at the top the rows of a page lie on each other.
    """
    for _ in range(_LEVELS):
        QtCore.QCoreApplication.sendPostedEvents(None, number_of(QtCore.QEvent.LayoutRequest))


class NarrowForm(QtWidgets.QFormLayout):
    """A form whose fields go below their names where there is no room beside them.

    Rows that are hidden are emptied: Qt 5 would leave a gap for each.
    """

    def __init__(self, *parent):
        super().__init__(*parent)
        self._all: list[tuple] = []  # the widgets of each row, shown or not
        self._out: set[int] = set()  # numbers of those that are empty
        self._heading = ""  # the label that is a row of its own, above the field that it names
        self.setRowWrapPolicy(QtWidgets.QFormLayout.WrapLongRows)
        self.setFieldGrowthPolicy(QtWidgets.QFormLayout.AllNonFixedFieldsGrow)

    def addRow(self, *row):
        """Qt would rather cut off an entry of a choice than put it below its name, and a long name takes the
        width of the values beside all others."""
        self._name(row)
        if len(row) == 2 and isinstance(row[1], (QtWidgets.QComboBox, WrappedLabel)):
            name, field = row
            label = QtWidgets.QLabel(name) if isinstance(name, str) else name
            least = _VALUE if isinstance(field, WrappedLabel) else _whole_width(field)
            if label.sizeHint().width() + least + self.horizontalSpacing() > _ROOM:
                self._append(label)
                self._append(field)
                return
            row = label, field
        self._append(*row)

    def clear(self) -> None:
        """Take all rows away, with what is in them."""
        while self.rowCount():
            self.removeRow(0)
        self._all.clear()
        self._out.clear()

    def show_widget(self, widget, visible: bool) -> None:
        """Show the row of a widget or empty it."""
        number = next(number for number, row in enumerate(self._all) if widget in row)
        row, form = self._all[number], QtWidgets.QFormLayout
        if visible and number in self._out:
            self._out.remove(number)
            roles = (form.LabelRole, form.FieldRole) if len(row) == 2 else (form.SpanningRole,)
            for role, each in zip(roles, row):
                self.setWidget(number, role, each)
        elif not visible and number not in self._out:
            self._out.add(number)
            for each in row:
                self.removeWidget(each)  # Qt ignores the empty row that is left
        for each in row:
            each.setVisible(visible)

    def _name(self, row) -> None:
        """Let screen readers say of a field what stands beside or above it."""
        heading, self._heading = self._heading, ""
        if isinstance(row[0], QtWidgets.QLabel) and len(row) == 1:
            self._heading = row[0].text()
        elif len(row) == 2:
            name_field(row[1], row[0] if isinstance(row[0], str) else row[0].text())
        elif heading:
            name_field(row[0], heading)

    def _append(self, *row) -> None:
        self._all.append(row)
        super().addRow(*row)
        if isinstance(row[-1], WrappedLabel) and not row[-1].isWindow():
            # in a form that is seen Qt would show it a turn of the event loop later
            for each in filter(None, (row[-1], self.labelForField(row[-1]))):
                if not each.testAttribute(QtCore.Qt.WA_WState_ExplicitShowHide):
                    each.show()


def _whole_width(choice) -> int:
    """What the longest entry of a choice needs, in px, also where its end may be left out."""
    measure = choice.fontMetrics()
    texts = [measure.boundingRect(choice.itemText(number)).width() for number in range(choice.count())]
    return max([choice.sizeHint().width(), *(width + _ARROW for width in texts)])


class ElidedCombo(QtWidgets.QComboBox):
    """A choice that leaves out the end of an entry where there is no room; its tooltip has the whole."""

    _is_elided = False

    def event(self, event):
        if event.type() != QtCore.QEvent.ToolTip or not self._is_elided:
            return super().event(event)
        text = "\n".join(dict.fromkeys((self.currentText(), self.toolTip())))
        QtWidgets.QToolTip.showText(event.globalPos(), text.strip(), self)
        return True

    def paintEvent(self, event):
        option = QtWidgets.QStyleOptionComboBox()
        self.initStyleOption(option)
        room = self.style().subControlRect(
            QtWidgets.QStyle.CC_ComboBox, option, QtWidgets.QStyle.SC_ComboBoxEditField, self
        )
        option.currentText = self.fontMetrics().elidedText(
            option.currentText, QtCore.Qt.ElideRight, room.width() - _BESIDE
        )
        self._is_elided = option.currentText != self.currentText()
        painter = QtWidgets.QStylePainter(self)
        painter.drawComplexControl(QtWidgets.QStyle.CC_ComboBox, option)
        painter.drawControl(QtWidgets.QStyle.CE_ComboBoxLabel, option)
        painter.end()  # now, not when Python forgets it


class NarrowCombo(ElidedCombo):
    """A choice that may be narrower than its entries; what is chosen can be read as its tooltip then."""

    def __init__(self):
        super().__init__()
        self.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        self.setMinimumContentsLength(8)
        self.currentTextChanged.connect(self.setToolTip)


class ElidedLabel(QtWidgets.QLabel):
    """A line of text of which the middle is left out where there is no room for it."""

    def __init__(self):
        super().__init__()
        self.setSizePolicy(QtWidgets.QSizePolicy.Ignored, QtWidgets.QSizePolicy.Preferred)

    @property
    def elided_text(self) -> str:
        """What can be read."""
        return self.fontMetrics().elidedText(self.text(), QtCore.Qt.ElideMiddle, self.width())

    def paintEvent(self, event):
        with painter_on(self) as painter:
            painter.drawText(self.rect(), QtCore.Qt.AlignVCenter | QtCore.Qt.AlignLeft, self.elided_text)


class WrappedLabel(QtWidgets.QLabel):
    """A text in as many lines as it takes: in a form, Qt gives some rows less than their heights."""

    def __init__(self, text: str = ""):
        super().__init__(text)
        self.setWordWrap(True)

    def setText(self, text: str) -> None:
        """Another text in as many lines."""
        super().setText(text)
        self._fit()

    def resizeEvent(self, event):
        super().resizeEvent(event)
        if event.size().width() != event.oldSize().width():
            self._fit()

    def _fit(self) -> None:
        self.setMinimumHeight(max(self.heightForWidth(self.width()), 0))


class Message(WrappedLabel):
    """What comes of what the user has just done: it is scrolled to where it would not be seen."""

    def __init__(self, name: str, text: str = ""):
        super().__init__(text)
        self.setObjectName(name)
        self._soon = QtCore.QTimer(self)
        self._soon.setSingleShot(True)
        self._soon.timeout.connect(self._be_seen)

    def setText(self, text: str) -> None:
        """Tell something else."""
        if text and text != self.text():
            self._soon.start(0)
        super().setText(text)

    def _be_seen(self) -> None:
        fit_heights()
        for area in widgets_of(QtWidgets.QScrollArea) if self.isVisible() else ():
            if area.isAncestorOf(self):
                area.ensureWidgetVisible(self)


class FullList(QtWidgets.QListWidget):
    """A list that is as high as its rows, up to a limit where there is one: else the panel scrolls."""

    def __init__(self, highest: int = _ANY):
        super().__init__()
        self._highest = highest
        self._soon = QtCore.QTimer(self)
        self._soon.setSingleShot(True)
        self._soon.timeout.connect(self.fit)
        self.setWordWrap(True)
        self.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOff)
        self.setVerticalScrollMode(QtWidgets.QAbstractItemView.ScrollPerPixel)

    def fit(self) -> None:
        """Take the height of the rows, as wide as they are now."""
        self.doItemsLayout()
        rows = self.visualItemRect(self.item(self.count() - 1)).bottom() + self.verticalScrollBar().value()
        height = max(rows, self.fontMetrics().height()) + 2 * self.frameWidth() + 4
        scrolls = height > self._highest
        policy = QtCore.Qt.ScrollBarAsNeeded if scrolls else QtCore.Qt.ScrollBarAlwaysOff
        self.setVerticalScrollBarPolicy(policy)
        self.setFixedHeight(min(height, self._highest))

    def resizeEvent(self, event):
        super().resizeEvent(event)
        if event.size().width() != event.oldSize().width():
            self._soon.start(0)

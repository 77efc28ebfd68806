# SPDX-License-Identifier: LGPL-2.1-or-later
"""What stands under the canvas: how far the work is, a hint, the width, the numbers, and "Make it!"."""

from __future__ import annotations

import math

import FreeCAD as App

from BalloonWorkbench.app.outline import DRAWN_AS
from BalloonWorkbench.app.properties.quantities import cubic_millimetres
from BalloonWorkbench.core.units import number_text
from BalloonWorkbench.gui.panels.widgets.fields import new_quantity_box
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, drawn_icon, translate
from BalloonWorkbench.gui.window import sentences

_AROUND = 60  # px of a number's arrows, its sign for expressions and its frame


class PaintForm(QtWidgets.QWidget):
    """`widened` carries the width in mm that was typed, `read_as` how it is read, `made` the wish for
    the balloon.
    """

    widened = QtCore.Signal(float)
    read_as = QtCore.Signal(str)
    made = QtCore.Signal()

    def __init__(self, width: float, parent=None):
        super().__init__(parent)
        self.width_field = new_quantity_box()
        self.width_field.setObjectName("PaintWidth")
        self.width_field.setProperty("unit", "mm")
        self.width_field.setProperty("minimum", 1.0)
        self.width_field.setProperty("singleStep", 10.0)
        self.width_field.setProperty("rawValue", width)
        self.width_field.setKeyboardTracking(False)
        self.width_field.setAccessibleName(translate("Width"))
        self.width_field.setToolTip(translate("Width of the balloon when it is inflated"))
        QtCore.QObject.connect(self.width_field, QtCore.SIGNAL("valueChanged(double)"), self.widened.emit)
        self.drawn_as = QtWidgets.QComboBox()
        self.drawn_as.setObjectName("PaintDrawnAs")
        for title, choice in DRAWN_AS.items():
            self.drawn_as.addItem(sentences.translated(title), choice)
        self.drawn_as.setAccessibleName(translate("Drawn as"))
        self.drawn_as.setToolTip(
            translate("The holes of a filled shape stay, the lines of a pen drawing are filled inside")
        )
        self.drawn_as.activated.connect(lambda index: self.read_as.emit(self.drawn_as.itemData(index)))
        # the numbers take what is left, in two lines at need: they leave the fields and the paper as they are
        self.width_field.setMaximumWidth(self.fontMetrics().horizontalAdvance("12345.67 mm") + _AROUND)
        self.numbers = _label("PaintNumbers")
        self.numbers.setWordWrap(True)
        self.numbers.setSizePolicy(QtWidgets.QSizePolicy.Ignored, QtWidgets.QSizePolicy.Ignored)
        self.hint = _label("PaintHint")
        self.hint.setWordWrap(True)
        self.hint.setSizePolicy(QtWidgets.QSizePolicy.Ignored, QtWidgets.QSizePolicy.Preferred)
        self.bar = QtWidgets.QProgressBar()
        self.bar.setTextVisible(False)
        self.bar.setMaximumHeight(4)
        self.bar.setRange(0, 1000)
        self.make_button = QtWidgets.QPushButton(translate("Make it!"))
        self.make_button.setObjectName("PaintMake")
        self.make_button.setIcon(drawn_icon("balloon"))
        self.make_button.setIconSize(QtCore.QSize(24, 24))
        self.make_button.setToolTip(
            translate("Put outline, balloon and pattern into the document, and print the pattern")
        )
        font = self.make_button.font()
        font.setBold(True)
        self.make_button.setFont(font)
        self.make_button.clicked.connect(lambda _checked=False: self.made.emit())
        below = QtWidgets.QHBoxLayout()
        below.addWidget(QtWidgets.QLabel(translate("Width")))
        below.addWidget(self.width_field)
        below.addWidget(self.drawn_as)
        below.addWidget(self.numbers, 1)
        below.addWidget(self.make_button)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.bar)
        column.addWidget(self.hint)
        column.addLayout(below)
        self.show_message("")

    def showEvent(self, event):
        """Themes give fields least widths that cut off what is in them."""
        super().showEvent(event)
        for field in (self.width_field, self.drawn_as):
            field.setMinimumWidth(field.sizeHint().width())

    def show_width(self, width: float) -> None:
        """Show a width in mm that came from elsewhere."""
        blocked = self.width_field.blockSignals(True)
        self.width_field.setProperty("rawValue", width)
        self.width_field.blockSignals(blocked)

    def show_drawn_as(self, choice: str) -> None:
        """Show how the painting is read."""
        self.drawn_as.setCurrentIndex(self.drawn_as.findData(choice))

    def show_state(self, state) -> None:
        """The numbers of a state, rounded before it is fitted; None: there is nothing to measure."""
        if state is None:
            self.numbers.setText("")
            return
        lengths = [_said(value, App.Units.Length, state.fitted) for value in state.size]
        volume = _said(cubic_millimetres(state.volume), App.Units.Volume, state.fitted)
        fitted, draft = translate("{} x {}, {} thick, {}"), translate("about {} x {}, {} thick, {}")
        self.numbers.setText((fitted if state.fitted else draft).format(*lengths, volume))

    def show_progress(self, part: float) -> None:
        """How far the full design is; 1 is done."""
        self.bar.setValue(round(1000 * part) % 1000)

    def show_message(self, text: str) -> None:
        """One sentence; without one, what to do first."""
        self.says_first = not text
        self.hint.setText(
            sentences.translated(text)
            or translate("Draw a closed line, or paint an area: it becomes a balloon.")
        )


def _said(value: float, unit, fitted: bool) -> str:
    """Three digits of a value in the user's unit, all of a large one; two where it is not fitted yet."""
    _, factor, symbol = App.Units.Quantity(value, unit).getUserPreferred()
    number = value / factor
    if fitted:
        return f"{number_text(number)} {symbol}"
    size = math.floor(math.log10(number)) if number > 0.0 else 0
    return f"{number_text(round(number, 1 - size), 2)} {symbol}"


def _label(name: str):
    label = QtWidgets.QLabel()
    label.setObjectName(name)
    return label

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one question of the paint window: how wide shall it be? With a hand beside the shape, for scale."""

from __future__ import annotations

from BalloonWorkbench.gui.paint.painting.lengths import large
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate

_GAP = 10  # px to the edges of the canvas
#: Lies on white paper in every theme: some make frames transparent, and words as light as the paper.
_LOOK = """
#PaintSize { background: #fff6ea; border: 1px solid #b0a590; border-radius: 4px; }
#PaintSize QLabel { background: transparent; color: #3a2a10; }
"""


class SizeCard(QtWidgets.QFrame):
    """Lies on a canvas until it is answered. Signals carry the width in mm."""

    changed = QtCore.Signal(float)
    answered = QtCore.Signal(float)

    def __init__(self, canvas):
        super().__init__(canvas)
        self._canvas = canvas
        self._unit = large()
        self.setObjectName("PaintSize")
        self.setStyleSheet(_LOOK)
        self.setCursor(QtCore.Qt.ArrowCursor)
        question = QtWidgets.QLabel(translate("How wide shall it be?"))
        question.setToolTip(translate("The hand beside the shape is as large as a grown-up's"))
        self.field = QtWidgets.QDoubleSpinBox()
        self.field.setObjectName("PaintSizeField")
        self.field.setDecimals(0 if self._unit.mm == 10.0 else 1)
        self.field.setRange(1.0, 1000.0)
        self.field.setSuffix(f" {self._unit.name}")
        self.field.setKeyboardTracking(False)
        self.field.valueChanged.connect(lambda value: self.changed.emit(value * self._unit.mm))
        done = QtWidgets.QPushButton(translate("That wide"))
        done.setObjectName("PaintSizeDone")
        done.clicked.connect(lambda _checked=False: self.answer())
        row = QtWidgets.QHBoxLayout(self)
        row.setContentsMargins(8, 5, 8, 5)
        for widget in (question, self.field, done):
            row.addWidget(widget)
        canvas.resized.connect(self.place)
        self.hide()

    def ask(self, width: float) -> None:
        """Show the question with a width in mm."""
        self.show_width(width)
        self.show()
        self.place()

    def show_width(self, width: float) -> None:
        """A width in mm that came from elsewhere."""
        blocked = self.field.blockSignals(True)
        self.field.setValue(width / self._unit.mm)
        self.field.blockSignals(blocked)

    def answer(self) -> None:
        """What the field says is the answer."""
        self.hide()
        self.field.interpretText()
        self.answered.emit(self.field.value() * self._unit.mm)

    def place(self) -> None:
        """In the corner of the canvas that the hand leaves free."""
        self.adjustSize()
        canvas = self._canvas
        self.move(canvas.width() - self.width() - _GAP, canvas.height() - self.height() - _GAP)
        self.raise_()

# SPDX-License-Identifier: LGPL-2.1-or-later
"""A spin box for a whole number that takes expressions, as FreeCAD's own takes them for quantities only."""

from __future__ import annotations

from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate

#: On a ground of its own: it can be read in every theme.
_REFUSED = "color: #ffffff; background: #c01020"


class WholeBox(QtWidgets.QSpinBox):
    """`=` opens a line for an expression; an empty one takes it away. While there is one, it gives the value.

    take  a function of the expression; raises ValueError, saying why, where it gives no number
    """

    def __init__(self, take):
        super().__init__()
        self._take = take
        self._expression = ""
        self._line = _Line(self)
        self._line.setObjectName("Expression")
        self._line.setPlaceholderText(translate("Expression"))
        self._line.ended.connect(self._answer)
        self._line.hide()

    def show_expression(self, expression: str) -> None:
        """What gives the value; nothing while the user does."""
        self._expression = expression
        self.setReadOnly(bool(expression))
        self.setPrefix("= " if expression else "")
        self.setStatusTip(f"= {expression}" if expression else translate("Type = for an expression"))

    def keyPressEvent(self, event):
        if event.text() == "=":
            self._ask()
        else:
            super().keyPressEvent(event)

    def _ask(self) -> None:
        self._line.setText(self._expression)
        self._line.setStyleSheet("")
        self._line.setToolTip("")
        self._line.setGeometry(self.rect())
        self._line.show()
        self._line.setFocus()

    def _answer(self, confirmed: bool) -> None:
        if confirmed:
            try:
                self._take(self._line.text().strip())
            except ValueError as error:
                self._line.setStyleSheet(_REFUSED)
                self._line.setToolTip(str(error))
                return
        self._line.hide()
        self.setFocus()


class _Line(QtWidgets.QLineEdit):
    """`ended` tells whether Return or Esc was pressed."""

    ended = QtCore.Signal(bool)

    def keyPressEvent(self, event):
        if event.key() in (QtCore.Qt.Key_Return, QtCore.Qt.Key_Enter, QtCore.Qt.Key_Escape):
            self.ended.emit(event.key() != QtCore.Qt.Key_Escape)
            event.accept()
        else:
            super().keyPressEvent(event)

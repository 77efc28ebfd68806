# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is behind a balloon that is shown to others: its usual ground, nothing, a colour or a photograph."""

from __future__ import annotations

from BalloonWorkbench.core.options.making import TRANSPARENT
from BalloonWorkbench.gui.panels.widgets.file_row import FileRow
from BalloonWorkbench.gui.panels.widgets.narrow import NarrowCombo
from BalloonWorkbench.gui.qt import QtCore, QtGui, QtWidgets, translate
from BalloonWorkbench.gui.window.file_dialogs import ask_for_picture
from BalloonWorkbench.gui.wrapping import PushButton

_USUAL, _COLOUR, _PHOTOGRAPH = "", "colour", "photograph"
_SWATCH = 16  # px
_FIRST = "#9cc4e4"


class GroundRow(QtWidgets.QWidget):
    """A choice, and below it the button of its colour or the file of its picture.

    `changed` comes when another ground was chosen.
    """

    changed = QtCore.Signal()

    def __init__(self):
        super().__init__()
        self._path = ""
        self._colour = QtGui.QColor(_FIRST)
        self.kind = NarrowCombo()
        self.kind.setObjectName("Ground")
        self.kind.setAccessibleName(translate("Ground"))
        self.kind.setToolTip(translate("What is behind the balloon"))
        self.colour = PushButton()
        self.colour.setObjectName("GroundColour")
        self.colour.setToolTip(translate("Choose a colour"))
        self.picture = FileRow(
            "GroundPicture",
            translate("Choose a picture"),
            translate("A picture that covers what is behind the balloon, such as a photograph of a room"),
            ask_for_picture,
        )
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        for widget in (self.kind, self.colour, self.picture):
            column.addWidget(widget)
        self.kind.currentIndexChanged.connect(lambda _index: self._changed())
        self.colour.clicked.connect(lambda _checked=False: self._choose_colour())
        self.picture.chosen.connect(self._take)
        self.offer(translate("White"), transparent=True)

    def offer(self, usual: str, *, transparent: bool) -> None:
        """Name the usual ground of what is written; what was chosen stays where it can be had."""
        before = self.kind.currentData()
        self.kind.blockSignals(True)
        self.kind.clear()
        self.kind.addItem(usual, _USUAL)
        if transparent:
            self.kind.addItem(translate("Transparent"), TRANSPARENT)
        self.kind.addItem(translate("A colour"), _COLOUR)
        self.kind.addItem(translate("A photograph"), _PHOTOGRAPH)
        self.kind.setCurrentIndex(max(self.kind.findData(before), 0))
        self.kind.blockSignals(False)
        self._show()

    def text(self) -> str | None:
        """The ground as the option `ground` of the core has it."""
        self.picture.take()
        chosen = {_COLOUR: self._colour.name(), _PHOTOGRAPH: self._path, TRANSPARENT: TRANSPARENT}
        return chosen.get(self.kind.currentData()) or None

    def objection(self) -> str:
        """Why nothing can be written yet; empty where it can."""
        if self.kind.currentData() == _PHOTOGRAPH and self.text() is None:
            return translate("Choose the photograph that is behind the balloon.")
        return ""

    def _take(self, path: str) -> None:
        self._path = path
        self.picture.show_name(path)
        self.changed.emit()

    def _choose_colour(self) -> None:
        chosen = QtWidgets.QColorDialog.getColor(self._colour, self, translate("Choose a colour"))
        if chosen.isValid():
            self._colour = chosen
            self._changed()

    def _changed(self) -> None:
        self._show()
        self.changed.emit()

    def _show(self) -> None:
        kind = self.kind.currentData()
        self.colour.setVisible(kind == _COLOUR)
        self.picture.setVisible(kind == _PHOTOGRAPH)
        swatch = QtGui.QPixmap(_SWATCH, _SWATCH)
        swatch.fill(self._colour)
        self.colour.setIcon(QtGui.QIcon(swatch))
        self.colour.setText(self._colour.name())

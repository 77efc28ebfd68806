# SPDX-License-Identifier: LGPL-2.1-or-later
"""Buttons of the paint window: tools at the left, colours and the rest above the canvas."""

from __future__ import annotations

from BalloonWorkbench.app.properties.property_table import QT_TRANSLATE_NOOP
from BalloonWorkbench.gui.paint.painting.tools import COLOURS, THICKEST, THINNEST, TOOLS, USUAL
from BalloonWorkbench.gui.qt import QtCore, QtGui, QtWidgets, drawn_icon, translate

_TOOL, _ACTION, _COLOUR = 40, 26, 24  # px
_THICKER = 3  # px, for one press of a key
#: What is chosen is seen in every theme: some have no look for it.
_CHOSEN = """
QToolButton:checked { background: rgba(127, 140, 160, 90); border: 2px solid #1f9ade; border-radius: 5px; }
"""


class Buttons(QtWidgets.QWidget):
    """A row or column of buttons."""

    def __init__(self, upright: bool, parent=None):
        super().__init__(parent)
        self.room = QtWidgets.QBoxLayout(
            QtWidgets.QBoxLayout.TopToBottom if upright else QtWidgets.QBoxLayout.LeftToRight, self
        )
        self.room.setContentsMargins(2, 2, 2, 2)
        self.room.setSpacing(2)
        self.setStyleSheet(_CHOSEN)

    def add(self, name: str, picture, tooltip: str, size: int, checkable: bool = False):
        """A button; name: of the widget."""
        button = QtWidgets.QToolButton()
        button.setObjectName(name)
        button.setIcon(picture)
        button.setIconSize(QtCore.QSize(size, size))
        button.setAutoRaise(True)
        button.setCheckable(checkable)
        button.setToolTip(tooltip)
        button.setAccessibleName(tooltip)
        button.setFocusPolicy(QtCore.Qt.NoFocus)  # keys stay with the canvas
        self.room.addWidget(button)
        return button


class ToolBox(Buttons):
    """The tools, one of them down."""

    chosen = QtCore.Signal(object)

    def __init__(self, parent=None):
        super().__init__(True, parent)
        self._group = QtWidgets.QButtonGroup(self)
        self._buttons = {}
        for tool in TOOLS:
            tooltip = f"{translate(tool.text)} ({tool.key})\n{translate(tool.tooltip)}"
            button = self.add(
                f"Paint{tool.name.title()}", drawn_icon(f"paint_{tool.name}"), tooltip, _TOOL, checkable=True
            )
            button.clicked.connect(lambda checked=False, tool=tool: self.chosen.emit(tool))
            self._group.addButton(button)
            self._buttons[tool.name] = button
        self.room.addStretch()
        self.show_chosen(TOOLS[0])

    def show_chosen(self, tool) -> None:
        self._buttons[tool.name].setChecked(True)


class ActionBar(Buttons):
    """Colours, thickness and what is done to the whole painting; signals carry what was chosen."""

    coloured = QtCore.Signal(str)
    thickened = QtCore.Signal(int)
    mirrored = QtCore.Signal(bool)
    acted = QtCore.Signal(str)

    _ACTIONS = (
        ("undo", QT_TRANSLATE_NOOP("BalloonWorkbench", "Undo (Ctrl+Z)")),
        ("redo", QT_TRANSLATE_NOOP("BalloonWorkbench", "Redo (Ctrl+Y)")),
        ("clear", QT_TRANSLATE_NOOP("BalloonWorkbench", "Take everything off the paper")),
        (
            "picture",
            QT_TRANSLATE_NOOP("BalloonWorkbench", "Put a picture on the paper, without its background"),
        ),
        (
            "backdrop",
            QT_TRANSLATE_NOOP(
                "BalloonWorkbench", "Lay a picture under the paper for tracing; press again to take it away"
            ),
        ),
        ("fit", QT_TRANSLATE_NOOP("BalloonWorkbench", "Show the whole paper (0)")),
    )

    def __init__(self, parent=None):
        super().__init__(False, parent)
        self.buttons = {}
        self._colours = QtWidgets.QButtonGroup(self)
        for value, name in COLOURS:
            button = self.add(f"PaintColour{value}", _dab(value), translate(name), _COLOUR, checkable=True)
            button.clicked.connect(lambda checked=False, value=value: self.coloured.emit(value))
            self._colours.addButton(button)
        self._colours.buttons()[0].setChecked(True)
        self.thickness = QtWidgets.QSlider(QtCore.Qt.Horizontal)
        self.thickness.setObjectName("PaintThickness")
        self.thickness.setRange(THINNEST, THICKEST)
        self.thickness.setValue(USUAL)
        self.thickness.setMinimumWidth(60)
        self.thickness.setMaximumWidth(140)
        self.thickness.setFocusPolicy(QtCore.Qt.NoFocus)
        self.thickness.setToolTip(translate("Thickness of the pen ([ thinner, ] thicker)"))
        self.thickness.valueChanged.connect(self.thickened)
        self.room.addSpacing(6)
        self.room.addWidget(self.thickness)
        self.room.addSpacing(6)
        mirror = self.add(
            "PaintMirror",
            drawn_icon("paint_mirror"),
            translate("Paint both sides at once, mirrored (M)"),
            _ACTION,
            checkable=True,
        )
        mirror.toggled.connect(self.mirrored)
        self.buttons["mirror"] = mirror
        for name, tooltip in self._ACTIONS:
            button = self.add(
                f"Paint{name.title()}", drawn_icon(f"paint_{name}"), translate(tooltip), _ACTION
            )
            button.clicked.connect(lambda checked=False, name=name: self.acted.emit(name))
            self.buttons[name] = button
        self.room.addStretch()

    def thicken(self, steps: int) -> None:
        """A thicker pen, or a thinner one; the slider knows its ends."""
        self.thickness.setValue(self.thickness.value() + steps * _THICKER)


def _dab(colour: str):
    """A dab of paint."""
    pixmap = QtGui.QPixmap(_COLOUR, _COLOUR)
    pixmap.fill(QtCore.Qt.transparent)
    painter = QtGui.QPainter(pixmap)
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    painter.setPen(QtGui.QPen(QtGui.QColor("#50565e"), 1.2))
    painter.setBrush(QtGui.QColor(colour))
    painter.drawEllipse(QtCore.QRectF(2, 2, _COLOUR - 4, _COLOUR - 4))
    painter.end()
    return QtGui.QIcon(pixmap)

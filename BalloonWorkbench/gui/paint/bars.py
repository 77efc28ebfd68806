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
        button.setFocusPolicy(QtCore.Qt.TabFocus)  # after a click, keys stay with the canvas
        self.room.addWidget(button)
        return button


class ToolButtons(Buttons):
    """Tools, one of a group down."""

    chosen = QtCore.Signal(object)

    def __init__(self, upright: bool, group, parent=None):
        super().__init__(upright, parent)
        self._group = group

    def add_tools(self, tools, size: int) -> None:
        """A button for each of the tools."""
        for tool in tools:
            tooltip = f"{translate(tool.text)} ({tool.key})\n{translate(tool.tooltip)}"
            button = self.add(
                f"Paint{tool.name.title()}", drawn_icon(f"paint_{tool.name}"), tooltip, size, checkable=True
            )
            button.setAccessibleName(translate(tool.text))
            button.setAccessibleDescription(translate(tool.tooltip))
            button.clicked.connect(lambda checked=False, tool=tool: self.chosen.emit(tool))
            self._group.addButton(button)

    def show_chosen(self, tool) -> None:
        """The button of a tool is down, here or in another bar of the group; the key Tab goes to it."""
        for button in self._group.buttons():
            is_chosen = button.objectName() == f"Paint{tool.name.title()}"
            button.setChecked(is_chosen)
            button.setFocusPolicy(QtCore.Qt.TabFocus if is_chosen else QtCore.Qt.NoFocus)


class ToolBox(ToolButtons):
    """The tools at the left; group: where those of the second row are, too."""

    def __init__(self, parent=None):
        self.group = QtWidgets.QButtonGroup()
        super().__init__(True, self.group, parent)
        self.add_tools(TOOLS, _TOOL)
        self.room.addStretch()
        self.show_chosen(TOOLS[0])


class ActionBar(Buttons):
    """Colours, thickness and what is done to the whole painting; signals carry what was chosen."""

    coloured = QtCore.Signal(str)
    thickened = QtCore.Signal(int)
    mirrored = QtCore.Signal(bool)
    acted = QtCore.Signal(str)
    extended = QtCore.Signal(bool)

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
        for number, (value, name) in enumerate(COLOURS, 1):
            tooltip = f"{translate(name)} ({number})"
            button = self.add(f"PaintColour{value}", dab(value), tooltip, _COLOUR, checkable=True)
            button.setAccessibleName(translate(name))
            button.clicked.connect(lambda checked=False, value=value: self.coloured.emit(value))
            self._colours.addButton(button)
        self._colours.buttons()[0].setChecked(True)
        self.thickness = QtWidgets.QSlider(QtCore.Qt.Horizontal)
        self.thickness.setObjectName("PaintThickness")
        self.thickness.setRange(THINNEST, THICKEST)
        self.thickness.setValue(USUAL)
        self.thickness.setMinimumWidth(60)
        self.thickness.setMaximumWidth(140)
        self.thickness.setFocusPolicy(QtCore.Qt.TabFocus)
        self.thickness.setToolTip(translate("Thickness of the pen ([ thinner, ] thicker)"))
        self.thickness.setAccessibleName(self.thickness.toolTip())
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
        more = self.add(
            "PaintMore",
            drawn_icon("paint_more"),
            translate("More: text, stamps, layers, symmetry, any colour (Q)"),
            _ACTION,
            checkable=True,
        )
        more.toggled.connect(self.extended)
        self.buttons["more"] = more
        self.room.addStretch()

    def show_colour(self, value: str) -> None:
        """The colour that is painted with, which may be none of the eight."""
        self._colours.setExclusive(False)  # at most one of them is down
        for button in self._colours.buttons():
            button.setChecked(button.objectName() == f"PaintColour{value}")
        self._colours.setExclusive(True)

    def thicken(self, steps: int) -> None:
        """A thicker pen, or a thinner one; the slider knows its ends."""
        self.thickness.setValue(self.thickness.value() + steps * _THICKER)


def dab(colour):
    """A dab of paint; colour: a name, or what Qt fills with."""
    pixmap = QtGui.QPixmap(_COLOUR, _COLOUR)
    pixmap.fill(QtCore.Qt.transparent)
    painter = QtGui.QPainter(pixmap)
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    painter.setPen(QtGui.QPen(QtGui.QColor("#50565e"), 1.2))
    painter.setBrush(QtGui.QColor(colour) if isinstance(colour, str) else colour)
    painter.drawEllipse(QtCore.QRectF(2, 2, _COLOUR - 4, _COLOUR - 4))
    painter.end()
    return QtGui.QIcon(pixmap)

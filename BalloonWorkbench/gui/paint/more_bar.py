# SPDX-License-Identifier: LGPL-2.1-or-later
"""The second row of the paint window: more tools, the layers, any colour, symmetry; below it what the tool
has to choose."""

from __future__ import annotations

from collections import deque

from BalloonWorkbench.app.properties.property_table import QT_TRANSLATE_NOOP
from BalloonWorkbench.gui.paint.bars import Buttons, ToolButtons, dab
from BalloonWorkbench.gui.paint.painting.layers import DECORATION, SHAPE
from BalloonWorkbench.gui.paint.painting.stamps import stamps
from BalloonWorkbench.gui.paint.painting.symmetry import MOST_FOLDS
from BalloonWorkbench.gui.paint.painting.tools import MORE_TOOLS, SELECT, STAMP, TEXT
from BalloonWorkbench.gui.paint.painting.words import MOST_LETTERS
from BalloonWorkbench.gui.qt import QtCore, QtGui, QtWidgets, drawn_icon, translate
from BalloonWorkbench.gui.window import sentences

_SMALL = 24  # px
_RECENT = 3  # colours
LAYER_TITLES = {
    SHAPE: QT_TRANSLATE_NOOP("BalloonWorkbench", "Shape"),
    DECORATION: QT_TRANSLATE_NOOP("BalloonWorkbench", "Decoration"),
}


class MoreBar(ToolButtons):
    """Signals carry what was chosen; `asked` comes when any colour is to be chosen."""

    layered = QtCore.Signal(str)
    coloured = QtCore.Signal(str)
    folded = QtCore.Signal(int)
    asked = QtCore.Signal()

    def __init__(self, group, parent=None):
        super().__init__(False, group, parent)
        self.add_tools(MORE_TOOLS, _SMALL)
        self.room.addSpacing(6)
        tooltips = {
            SHAPE: translate("Paint what becomes the outline (D)"),
            DECORATION: translate("Paint what is printed on the film and leaves the outline as it is (D)"),
        }
        self._layers = QtWidgets.QButtonGroup(self)
        for name, title in LAYER_TITLES.items():
            button = self.add(f"PaintLayer{name.title()}", QtGui.QIcon(), tooltips[name], _SMALL, True)
            button.setText(translate(title))
            button.setAccessibleName(translate(title))
            button.setAccessibleDescription(tooltips[name])
            button.setToolButtonStyle(QtCore.Qt.ToolButtonTextOnly)
            button.clicked.connect(lambda checked=False, name=name: self.layered.emit(name))
            self._layers.addButton(button)
        self.show_layer(SHAPE)
        self.room.addSpacing(6)
        self._add_colours()
        self.room.addSpacing(6)
        turns = QtWidgets.QLabel()
        turns.setPixmap(drawn_icon("paint_turns").pixmap(_SMALL, _SMALL))
        self.fold = QtWidgets.QSpinBox()
        self.fold.setObjectName("PaintFold")
        self.fold.setRange(1, MOST_FOLDS)
        self.fold.setFocusPolicy(QtCore.Qt.StrongFocus)
        self.fold.setToolTip(translate("Paint so many times around a centre ( , fewer, . more)"))
        self.fold.setAccessibleName(self.fold.toolTip())
        self.fold.valueChanged.connect(self.folded)
        self.room.addWidget(turns)
        self.room.addWidget(self.fold)
        self.room.addStretch()

    def _add_colours(self) -> None:
        rainbow = QtGui.QConicalGradient(0.5 * _SMALL, 0.5 * _SMALL, 90.0)
        for number in range(7):
            rainbow.setColorAt(number / 6, QtGui.QColor.fromHsvF(number % 6 / 6, 0.8, 0.95))
        button = self.add("PaintAnyColour", dab(QtGui.QBrush(rainbow)), translate("Any colour (K)"), _SMALL)
        button.clicked.connect(lambda checked=False: self.asked.emit())
        self._colours: deque[str] = deque(maxlen=_RECENT)
        self._dabs = []
        for number in range(_RECENT):
            button = self.add(f"PaintRecent{number + 1}", QtGui.QIcon(), "", _SMALL)
            button.clicked.connect(lambda checked=False, number=number: self._take(number))
            button.hide()
            self._dabs.append(button)

    def _take(self, number: int) -> None:
        self.coloured.emit(self._colours[number])

    def remember(self, colour: str) -> None:
        """One more colour that was used, the last first."""
        if colour not in self._colours:
            self._colours.appendleft(colour)
        for button, value in zip(self._dabs, self._colours):
            button.setIcon(dab(value))
            button.setToolTip(translate("Colour {}").format(value))
            button.setAccessibleName(button.toolTip())
            button.show()

    def show_layer(self, name: str) -> None:
        """The layer that is painted on."""
        for button in self._layers.buttons():
            button.setChecked(button.objectName() == f"PaintLayer{name.title()}")


class PaintChoices(QtWidgets.QStackedWidget):
    """What text, stamps and the selection have to choose; hidden for other tools.

    `written` comes when words, font or their ground have changed, `ended` with Enter (True) or Esc.
    """

    written = QtCore.Signal()
    ended = QtCore.Signal(bool)
    stamped = QtCore.Signal(object)
    clipped = QtCore.Signal(str)

    def __init__(self, parent=None):
        super().__init__(parent)
        self._pages = {TEXT: self._text(), STAMP: self._stamps(), SELECT: self._clips()}
        for page in self._pages.values():
            self.addWidget(page)
        self.setSizePolicy(QtWidgets.QSizePolicy.Preferred, QtWidgets.QSizePolicy.Fixed)
        self.hide()

    def show_for(self, tool) -> None:
        """Show what belongs to a tool."""
        page = self._pages.get(tool.name)
        self.setVisible(page is not None)
        if page is not None:
            self.setCurrentWidget(page)

    def _text(self):
        page = QtWidgets.QWidget()
        self.words = WordsField()
        self.words.setObjectName("PaintWords")
        self.words.setMaxLength(MOST_LETTERS)
        self.words.setPlaceholderText(translate("Click on the paper, then type"))
        self.words.setAccessibleName(translate("Text"))
        self.words.textChanged.connect(lambda _text: self.written.emit())
        self.words.ended.connect(self.ended)
        self.font_box = QtWidgets.QFontComboBox()
        self.font_box.setObjectName("PaintFont")
        self.font_box.setToolTip(translate("Font"))
        self.font_box.setAccessibleName(self.font_box.toolTip())
        self.font_box.setMinimumWidth(80)
        self.font_box.setMaximumWidth(180)
        self.font_box.currentFontChanged.connect(lambda _font: self.written.emit())
        self.joined = QtWidgets.QCheckBox(translate("Joined"))
        self.joined.setObjectName("PaintJoined")
        self.joined.setToolTip(translate("Letters on a ground that makes one balloon of them"))
        self.joined.toggled.connect(lambda _on: self.written.emit())
        row = QtWidgets.QHBoxLayout(page)
        row.setContentsMargins(2, 2, 2, 2)
        row.addWidget(self.words, 1)
        row.addWidget(self.font_box)
        row.addWidget(self.joined)
        return page

    def _stamps(self):
        page = Buttons(False)
        group = QtWidgets.QButtonGroup(page)
        for stamp in stamps():
            title = sentences.translated(stamp.title)
            button = page.add(f"PaintStamp{stamp.name.title()}", _picture(stamp), title, _SMALL, True)
            button.clicked.connect(lambda checked=False, stamp=stamp: self.stamped.emit(stamp))
            group.addButton(button)
        group.buttons()[0].setChecked(True)
        page.room.addStretch()
        return page

    def _clips(self):
        page = Buttons(False)
        for name, tooltip in (
            ("copy", translate("Copy (Ctrl+C)")),
            ("cut", translate("Cut (Ctrl+X)")),
            ("paste", translate("Paste (Ctrl+V)")),
            ("all", translate("Select all (Ctrl+A)")),
        ):
            button = page.add(f"PaintClip{name.title()}", drawn_icon(f"paint_{name}"), tooltip, _SMALL)
            button.clicked.connect(lambda checked=False, name=name: self.clipped.emit(name))
        page.room.addStretch()
        return page


class WordsField(QtWidgets.QLineEdit):
    """A line to type in; `ended` comes with Enter (True) and Esc."""

    ended = QtCore.Signal(bool)

    def keyPressEvent(self, event):
        if event.key() in (QtCore.Qt.Key_Return, QtCore.Qt.Key_Enter, QtCore.Qt.Key_Escape):
            self.ended.emit(event.key() != QtCore.Qt.Key_Escape)
        else:
            super().keyPressEvent(event)


def _picture(stamp):
    """A small picture of a stamp."""
    pixmap = QtGui.QPixmap(2 * _SMALL, 2 * _SMALL)
    pixmap.fill(QtCore.Qt.transparent)
    painter = QtGui.QPainter(pixmap)
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    painter.setPen(QtGui.QPen(QtGui.QColor("#50565e"), 2.0))
    painter.setBrush(QtGui.QColor("#f5567d"))
    corners = [QtCore.QPointF(x, y) for x, y in stamp.at((_SMALL, _SMALL), 0.85 * _SMALL, 0.0)]
    painter.drawPolygon(QtGui.QPolygonF(corners))
    painter.end()
    return QtGui.QIcon(pixmap)

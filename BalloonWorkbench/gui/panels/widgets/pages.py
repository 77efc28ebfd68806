# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pages of a panel behind one another: each is as high as it has to be, and only the panel scrolls."""

from __future__ import annotations

from BalloonWorkbench.gui.panels.widgets.narrow import fit_heights
from BalloonWorkbench.gui.qt import QtCore, QtWidgets

#: The page in front is marked in every theme, and its title stays as readable as the others.
_CHOSEN = "QToolButton:checked { border: 2px solid #1b8ac9; border-radius: 4px; padding: 2px; }"


class Pages(QtWidgets.QWidget):
    """A button for each (title, function that makes its box): side by side, in two rows in a narrow panel.

    A box is made when its page is looked at: all at once would keep the window busy.
    """

    currentChanged = QtCore.Signal(int)
    made = QtCore.Signal()  # a box that was not there before

    def __init__(self, kinds):
        super().__init__()
        self.setObjectName("Steps")
        self._makers = [make for _, make in kinds]
        self._boxes: dict[int, QtWidgets.QWidget] = {}
        self._index = -1
        self._group = QtWidgets.QButtonGroup(self)
        self._buttons = []
        self._tabs = QtWidgets.QGridLayout()
        self._tabs.setSpacing(2)
        for index, (title, _) in enumerate(kinds):
            button = QtWidgets.QToolButton()
            button.setObjectName(f"Step{index}")
            button.setText(title)
            button.setCheckable(True)
            button.setStyleSheet(_CHOSEN)
            button.setSizePolicy(QtWidgets.QSizePolicy.Expanding, QtWidgets.QSizePolicy.Fixed)
            button.clicked.connect(lambda _checked=False, chosen=index: self.setCurrentIndex(chosen))
            self._group.addButton(button, index)
            self._buttons.append(button)
        self._column = QtWidgets.QVBoxLayout(self)
        self._column.setContentsMargins(0, 0, 0, 0)
        self._column.addLayout(self._tabs)
        self._in_a_row = 0
        self._arrange()

    @property
    def boxes(self) -> tuple:
        """Those that there are."""
        return tuple(self._boxes.values())

    def count(self) -> int:
        """How many pages there are."""
        return len(self._makers)

    def tabText(self, index: int) -> str:
        """The title of a page."""
        return self._buttons[index].text()

    def currentIndex(self) -> int:
        """The page in front."""
        return self._index

    def currentWidget(self):
        """Its box."""
        return self._boxes.get(self._index)

    def widget(self, index: int):
        """The box of a page, None while it was not looked at."""
        return self._boxes.get(index)

    def setCurrentIndex(self, index: int) -> None:
        """Turn to a page."""
        if index == self._index:
            return
        is_new = index not in self._boxes
        if is_new:
            self._boxes[index] = box = self._makers[index]()
            margins = box.layout().contentsMargins()
            box.layout().setContentsMargins(0, margins.top(), 0, margins.bottom())
            self._column.addWidget(box)
        self._index = index
        self._buttons[index].setChecked(True)
        for number, box in self._boxes.items():
            box.setVisible(number == index)
        if is_new:
            self.made.emit()
        fit_heights()
        self.currentChanged.emit(index)

    def resizeEvent(self, event):
        super().resizeEvent(event)
        self._arrange()

    def minimumSizeHint(self):
        """As narrow as the titles in two rows."""
        least = super().minimumSizeHint()
        return QtCore.QSize(min(least.width(), self._widest(self._half)), least.height())

    @property
    def _half(self) -> int:
        """How many titles there are in a row where there are two rows."""
        return (len(self._buttons) + 1) // 2

    def _widest(self, in_a_row: int) -> int:
        widths = [button.sizeHint().width() for button in self._buttons]
        return max(
            sum(widths[first : first + in_a_row]) + self._tabs.spacing() * (in_a_row - 1)
            for first in range(0, len(widths), in_a_row)
        )

    def _arrange(self) -> None:
        """The titles side by side where there is room, else in two rows."""
        whole = len(self._buttons)
        in_a_row = whole if self._widest(whole) <= self.width() else self._half
        if in_a_row == self._in_a_row:
            return
        self._in_a_row = in_a_row
        for number, button in enumerate(self._buttons):
            self._tabs.removeWidget(button)
            self._tabs.addWidget(button, number // in_a_row, number % in_a_row)


class AfterPages(QtWidgets.QWidget):
    """Holds the box below the pages: the Tab key comes to it after them, also after those made later.

    Qt appends what comes into a window to its order of Tab; the box leaves the window and comes in again.
    QWidget.setTabOrder on the widgets of a page would end FreeCAD 1.1.
    """

    def __init__(self, pages: Pages, box: QtWidgets.QWidget):
        super().__init__()
        self._box = box
        self.setWindowTitle(box.windowTitle())
        self.setWindowIcon(box.windowIcon())
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(box)
        pages.made.connect(self._come_last)

    def _come_last(self) -> None:
        focus = QtWidgets.QApplication.focusWidget()
        is_inside = focus is not None and self._box.isAncestorOf(focus)
        self._box.setParent(None)
        self.layout().addWidget(self._box)
        self._box.show()
        if is_inside:
            focus.setFocus()

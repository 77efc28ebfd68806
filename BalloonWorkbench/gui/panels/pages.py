# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pages of a panel behind one another, only as high as the one in front: the result stays in view."""

from __future__ import annotations

from BalloonWorkbench.gui.qt import QtCore, QtWidgets

_HIGHEST = 320  # px; a longer page scrolls
_FRAME = 10  # px above and below it


class Pages(QtWidgets.QTabWidget):
    """A tab for each (title, function that makes its box).

    A box is made when its page is looked at: all at once would keep the window busy.
    """

    def __init__(self, kinds):
        super().__init__()
        self.setObjectName("Steps")
        self._makers = [make for _, make in kinds]
        self._boxes: dict[int, QtWidgets.QWidget] = {}
        self._soon = QtCore.QTimer(self)
        self._soon.setSingleShot(True)
        self._soon.timeout.connect(self.fit)
        for title, _ in kinds:
            page = QtWidgets.QScrollArea()
            page.setFrameShape(QtWidgets.QFrame.NoFrame)
            page.setWidgetResizable(True)
            page.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOff)
            self.addTab(page, title)
        self.currentChanged.connect(self._turned)

    @property
    def boxes(self) -> tuple:
        """Those that there are."""
        return tuple(self._boxes.values())

    def begin(self, index: int) -> None:
        """Show this page first."""
        self.setCurrentIndex(index)
        self._turned(index)

    def _turned(self, index: int) -> None:
        if index not in self._boxes:
            box, page = self._makers[index](), self.widget(index)
            self._boxes[index] = box
            box.installEventFilter(self)
            page.setWidget(box)
            page.setMinimumWidth(box.minimumSizeHint().width())
        self.fit()

    def fit(self) -> None:
        """Take the height of the page in front, once that is made."""
        box = self._boxes.get(self.currentIndex())
        if box is None:
            return
        wanted = box.sizeHint().height()
        if box.hasHeightForWidth():
            wanted = max(wanted, box.heightForWidth(self.currentWidget().viewport().width()))
        self.setFixedHeight(min(wanted, _HIGHEST) + self.tabBar().sizeHint().height() + _FRAME)

    def eventFilter(self, box, event):
        if event.type() == QtCore.QEvent.LayoutRequest:
            self._soon.start(0)
        return False

    def resizeEvent(self, event):
        super().resizeEvent(event)
        if event.size().width() != event.oldSize().width():
            self.fit()

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pages of a panel behind one another, only as high as the one in front: the result stays in view."""

from __future__ import annotations

from BalloonWorkbench.gui.qt import QtCore, QtWidgets

_HIGHEST = 320  # px; a longer page scrolls


class Pages(QtWidgets.QTabWidget):
    """A tab for each box, named by its window title."""

    def __init__(self, boxes):
        super().__init__()
        self.setObjectName("Steps")
        self._boxes = list(boxes)
        self._soon = QtCore.QTimer(self)
        self._soon.setSingleShot(True)
        self._soon.timeout.connect(self.fit)
        for box in boxes:
            box.installEventFilter(self)
            page = QtWidgets.QScrollArea()
            page.setFrameShape(QtWidgets.QFrame.NoFrame)
            page.setWidgetResizable(True)
            page.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOff)
            page.setWidget(box)
            page.setMinimumWidth(box.minimumSizeHint().width())
            self.addTab(page, box.windowTitle())
        self.currentChanged.connect(lambda _index: self.fit())

    def show_box(self, box) -> None:
        """Bring a box to the front."""
        self.setCurrentIndex(self._boxes.index(box))

    def fit(self) -> None:
        """Take the height of the page in front."""
        box = self._boxes[self.currentIndex()]
        wanted = box.sizeHint().height()
        if box.hasHeightForWidth():
            wanted = max(wanted, box.heightForWidth(self.currentWidget().viewport().width()))
        around = self.sizeHint().height() - self.currentWidget().sizeHint().height()
        self.setFixedHeight(min(wanted, _HIGHEST) + max(around, self.tabBar().sizeHint().height() + 8))

    def eventFilter(self, box, event):
        if event.type() == QtCore.QEvent.LayoutRequest:
            self._soon.start(0)
        return False

    def resizeEvent(self, event):
        super().resizeEvent(event)
        if event.size().width() != event.oldSize().width():
            self.fit()

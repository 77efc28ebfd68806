# SPDX-License-Identifier: LGPL-2.1-or-later
"""Widgets for a panel that may be narrow: nothing in them is cut off, nothing scrolls inside the panel."""

from __future__ import annotations

from BalloonWorkbench.gui.qt import QtCore, QtGui, QtWidgets


def narrow_form(parent=None):
    """A form whose fields go below their names where there is no room beside them."""
    form = QtWidgets.QFormLayout() if parent is None else QtWidgets.QFormLayout(parent)
    form.setRowWrapPolicy(QtWidgets.QFormLayout.WrapLongRows)
    form.setFieldGrowthPolicy(QtWidgets.QFormLayout.AllNonFixedFieldsGrow)
    return form


class NarrowCombo(QtWidgets.QComboBox):
    """A choice that may be narrower than its entries; what is chosen can be read as its tooltip then."""

    def __init__(self):
        super().__init__()
        self.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        self.setMinimumContentsLength(8)
        self.currentTextChanged.connect(self.setToolTip)


class ElidedLabel(QtWidgets.QLabel):
    """A line of text of which the middle is left out where there is no room for it."""

    def __init__(self):
        super().__init__()
        self.setSizePolicy(QtWidgets.QSizePolicy.Ignored, QtWidgets.QSizePolicy.Preferred)

    @property
    def elided_text(self) -> str:
        """What can be read."""
        return self.fontMetrics().elidedText(self.text(), QtCore.Qt.ElideMiddle, self.width())

    def paintEvent(self, event):
        painter = QtGui.QPainter(self)
        painter.drawText(self.rect(), QtCore.Qt.AlignVCenter | QtCore.Qt.AlignLeft, self.elided_text)
        painter.end()  # now, not when Python forgets it


class FullList(QtWidgets.QListWidget):
    """A list that is as high as its rows, up to a limit."""

    def __init__(self, highest: int):
        super().__init__()
        self._highest = highest
        self.setWordWrap(True)
        self.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOff)
        self.setVerticalScrollMode(QtWidgets.QAbstractItemView.ScrollPerPixel)

    def fit(self) -> None:
        """Take the height of the rows, as wide as they are now."""
        self.doItemsLayout()
        rows = sum(self.sizeHintForRow(row) for row in range(self.count()))
        spare = 2 * self.frameWidth() + 4
        self.setFixedHeight(min(max(rows, self.fontMetrics().height()) + spare, self._highest))

    def resizeEvent(self, event):
        super().resizeEvent(event)
        if event.size().width() != event.oldSize().width():
            QtCore.QTimer.singleShot(0, self.fit)

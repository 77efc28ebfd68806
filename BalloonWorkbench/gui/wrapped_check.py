# SPDX-License-Identifier: LGPL-2.1-or-later
"""A check box whose text takes as many lines as it needs: Qt's own one cuts it off or widens the panel."""

from __future__ import annotations

from BalloonWorkbench.gui.qt import QtCore, QtWidgets, number_of

_HIGH = 10000  # px, more than any text
_CONTENTS = QtWidgets.QStyle.SE_CheckBoxContents


class WrappedCheck(QtWidgets.QCheckBox):
    """As narrow as the longest word of its text."""

    def __init__(self, text: str = ""):
        super().__init__(text)
        policy = QtWidgets.QSizePolicy(QtWidgets.QSizePolicy.Preferred, QtWidgets.QSizePolicy.Preferred)
        policy.setHeightForWidth(True)
        self.setSizePolicy(policy)

    def setText(self, text: str) -> None:
        """Another text in as many lines."""
        super().setText(text)
        self._fit()

    def hasHeightForWidth(self) -> bool:
        """Its text wraps."""
        return True

    def heightForWidth(self, width: int) -> int:
        """Of its lines in px, or of the box where that is higher."""
        whole = QtWidgets.QCheckBox.sizeHint(self)
        room = QtCore.QRect(0, 0, max(width - self._beside(), 1), _HIGH)
        return max(self.fontMetrics().boundingRect(room, self._flags(), self.text()).height(), whole.height())

    def minimumSizeHint(self):
        """A line, as wide as the longest word."""
        words = [self.fontMetrics().boundingRect(word).width() for word in self.text().split()]
        return QtCore.QSize(self._beside() + max(words, default=0), super().minimumSizeHint().height())

    def resizeEvent(self, event):
        super().resizeEvent(event)
        if event.size().width() != event.oldSize().width():
            self._fit()

    def hitButton(self, place) -> bool:
        """A click on any of its lines counts."""
        return self.rect().contains(place)

    def paintEvent(self, event):
        option, style, kind = QtWidgets.QStyleOptionButton(), self.style(), QtWidgets.QStyle
        self.initStyleOption(option)
        painter = QtWidgets.QStylePainter(self)
        text = style.subElementRect(kind.SE_CheckBoxContents, option, self)
        palette, shown = option.palette, self.isEnabled()
        style.drawItemText(painter, text, self._flags(), palette, shown, self.text(), self.foregroundRole())
        if self.hasFocus():
            around = QtWidgets.QStyleOptionFocusRect()
            around.initFrom(self)
            around.rect = text
            painter.drawPrimitive(kind.PE_FrameFocusRect, around)
        option.rect = style.subElementRect(kind.SE_CheckBoxIndicator, option, self)
        painter.drawPrimitive(kind.PE_IndicatorCheckBox, option)
        painter.end()  # now, not when Python forgets it

    def _fit(self) -> None:
        self.setMinimumHeight(self.heightForWidth(self.width()))

    def _beside(self) -> int:
        """The box and the gap in px."""
        option = QtWidgets.QStyleOptionButton()
        self.initStyleOption(option)
        return self.width() - self.style().subElementRect(_CONTENTS, option, self).width() + 2

    def _flags(self) -> int:
        right = self.layoutDirection() == QtCore.Qt.RightToLeft
        side = QtCore.Qt.AlignRight if right else QtCore.Qt.AlignLeft
        kinds = (side, QtCore.Qt.AlignVCenter, QtCore.Qt.TextWordWrap, QtCore.Qt.TextShowMnemonic)
        return sum(map(number_of, kinds))

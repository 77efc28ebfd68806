# SPDX-License-Identifier: LGPL-2.1-or-later
"""Check boxes and buttons whose text takes as many lines as it needs: Qt would cut it off."""

from __future__ import annotations

from BalloonWorkbench.gui.qt import QtCore, QtWidgets

_CHANGES = (QtCore.QEvent.FontChange, QtCore.QEvent.StyleChange)


class _Wrapping:
    """Breaks the text between words where the button is narrower; `text` is the whole of it."""

    _whole = ""

    def text(self) -> str:
        """The whole text, whatever its lines are."""
        return self._whole

    def setText(self, text: str) -> None:
        """Another text in as many lines as it takes."""
        self._whole = text
        self.setAccessibleName(" ".join(text.split()))
        super().setText(text)
        self._wrap()

    def resizeEvent(self, event):
        super().resizeEvent(event)
        if event.size().width() != event.oldSize().width():
            self._wrap()

    def changeEvent(self, event):
        super().changeEvent(event)
        if event.type() in _CHANGES and self._whole:
            self._wrap()

    def sizeHint(self):
        """As wide as without new lines, as high as with them."""
        return self._size_for(self._whole.split("\n"))

    def minimumSizeHint(self):
        """As wide as the longest word."""
        return self._size_for(self._whole.split())

    def _size_for(self, lines):
        return QtCore.QSize(self._beside() + self._widest(lines), super().sizeHint().height())

    def _wrap(self) -> None:
        """Lines as long as there is room, words whole."""
        room, lines = self.width() - self._beside(), []
        for line in self._whole.split("\n"):
            lines.append("")
            for word in line.split(" "):
                longer = f"{lines[-1]} {word}".strip()
                if lines[-1] and self._widest([longer]) > room:
                    lines.append(word)
                else:
                    lines[-1] = longer
        shown = "\n".join(lines)
        if shown != super().text():
            super().setText(shown)
        self.setMinimumHeight(super().sizeHint().height())  # Qt 6 does not ask for the hint again

    def _beside(self) -> int:
        """What there is beside the text, px."""
        return super().sizeHint().width() - self._widest(super().text().split("\n"))

    def _widest(self, lines) -> int:
        measure = self.fontMetrics()
        return max((measure.size(QtCore.Qt.TextShowMnemonic, line).width() for line in lines), default=0)


class CheckBox(_Wrapping, QtWidgets.QCheckBox):
    """A check box that may be narrow."""

    def __init__(self, text: str = ""):
        super().__init__()
        self.setSizePolicy(QtWidgets.QSizePolicy.Preferred, QtWidgets.QSizePolicy.Fixed)
        self.setText(text)


class PushButton(_Wrapping, QtWidgets.QPushButton):
    """A button that may be narrow."""

    def __init__(self, text: str = ""):
        super().__init__()
        self.setSizePolicy(QtWidgets.QSizePolicy.Preferred, QtWidgets.QSizePolicy.Fixed)
        self.setText(text)


class PictureButton(_Wrapping, QtWidgets.QToolButton):
    """A picture with its title below it."""

    def __init__(self, text: str = ""):
        super().__init__()
        self.setToolButtonStyle(QtCore.Qt.ToolButtonTextUnderIcon)
        self.setSizePolicy(QtWidgets.QSizePolicy.Expanding, QtWidgets.QSizePolicy.Fixed)
        self.setText(text)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long work in the status bar: what is done, how far it is, and a button that stops it. So does Esc."""

from __future__ import annotations

import FreeCADGui as Gui

from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate
from BalloonWorkbench.gui.window.sentences import translated

_WIDTH = 180  # px of the bar
_PATIENCE = 200  # ms; shorter work is over before anybody would read it
_KEYS = (QtCore.QEvent.ShortcutOverride, QtCore.QEvent.KeyPress)


class StatusProgress(QtCore.QObject):
    """Shows one work until `close`; `stop` is called when the user wants no more of it."""

    def __init__(self, title: str, stop):
        super().__init__(Gui.getMainWindow())
        self._title, self._stop = title, stop
        self._text = QtWidgets.QLabel(translated(title))
        self._bar = QtWidgets.QProgressBar()
        self._bar.setObjectName("BalloonProgress")
        self._bar.setMaximumWidth(_WIDTH)
        self._bar.setRange(0, 1000)
        self.button = QtWidgets.QPushButton(translate("Stop (Esc)"))
        self.button.setObjectName("BalloonStop")
        self._room = QtWidgets.QWidget()
        row = QtWidgets.QHBoxLayout(self._room)
        row.setContentsMargins(0, 0, 0, 0)
        for widget in (self._text, self._bar, self.button):
            row.addWidget(widget)
        self._soon = QtCore.QTimer(self)
        self._soon.setSingleShot(True)
        self._soon.timeout.connect(self._appear)
        self._soon.start(_PATIENCE)
        QtWidgets.QApplication.instance().installEventFilter(self)

    def show_part(self, part: float, text: str = "") -> None:
        """How far it is, 0 to 1, and what it is at."""
        self._bar.setValue(round(1000 * part))
        title = translated(self._title)
        self._text.setText(translate("{}: {}").format(title, translated(text)) if text else title)

    def stop(self) -> None:
        """The user wants no more of it."""
        self.button.setEnabled(False)
        self._text.setText(translate("Stopping ..."))
        self._stop()

    def close(self) -> None:
        """The work is over."""
        QtWidgets.QApplication.instance().removeEventFilter(self)
        self._soon.stop()
        if self._room.parent() is not None:
            place = _place()
            place.layout().removeWidget(self._room)
            place.setVisible(place.layout().count() > 0)
        self._room.hide()
        self._room.deleteLater()
        self.deleteLater()

    def _appear(self) -> None:
        place = _place()
        place.layout().addWidget(self._room)
        place.show()
        self._room.show()

    def _is_on_button(self, event) -> bool:
        place = event.globalPosition().toPoint() if hasattr(event, "globalPosition") else event.globalPos()
        return self.button.isVisible() and self.button.rect().contains(self.button.mapFromGlobal(place))

    def eventFilter(self, watched, event):
        if not self.button.isEnabled():
            return False
        # FreeCAD keeps clicks away from every widget while it recomputes: seen here, before it does
        if event.type() == QtCore.QEvent.MouseButtonPress and self._is_on_button(event):
            self.stop()
            return True
        # Esc belongs to the work before it belongs to a panel or a tool
        if event.type() in _KEYS and event.key() == QtCore.Qt.Key_Escape:
            if event.type() == QtCore.QEvent.ShortcutOverride:
                event.accept()
            else:
                self.stop()
            return True
        return False


def _place():
    """Where works are in the status bar. It stays: when something is added there or taken away, Qt shows the
    labels again that a message hides, and both are drawn over each other.
    """
    bar = Gui.getMainWindow().statusBar()
    place = bar.findChild(QtWidgets.QWidget, "BalloonWorks")
    if place is None:
        place = QtWidgets.QWidget()
        place.setObjectName("BalloonWorks")
        QtWidgets.QHBoxLayout(place).setContentsMargins(0, 0, 0, 0)
        bar.addPermanentWidget(place)
    return place

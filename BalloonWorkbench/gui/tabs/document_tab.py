# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tabs that show an object of a document: one for each object, with a line that says what goes on."""

from __future__ import annotations

from collections.abc import Callable

import FreeCADGui as Gui

from BalloonWorkbench.app.border.guard import Guarded
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, drawn_icon
from BalloonWorkbench.gui.window.overlays import EmptyTasks, covered

_PATIENCE = 100  # ms between two looks at a document that is being recomputed
_LEAST = 200  # px of a tab, that overlays leave free


def tab_of(obj, tabs: list, make: Callable, icon: str):
    """The tab of an object among `tabs`, in front; made where there is none."""
    area = Gui.getMainWindow().findChild(QtWidgets.QMdiArea)
    tab = next((each for each in tabs if each.obj == obj), None)
    if tab is None:
        tab = make(obj)
        tabs.append(tab)
        tab.frame = area.addSubWindow(tab)
        tab.frame.setAttribute(QtCore.Qt.WA_DeleteOnClose)
        tab.frame.setWindowIcon(drawn_icon(icon))
        tab.frame.showMaximized()
    area.setActiveSubWindow(tab.frame)
    tab.view.setFocus()
    return tab


class DocumentTab(QtWidgets.QWidget):
    """Follows the recomputes of an object, goes with it and with its document, and lies beside the overlays.

    A kind of tab has a `view`, and shows the object in `show_object`.

    tabs  the open ones of its kind
    """

    #: Properties of the object that are shown.
    SHOWN: tuple[str, ...] = ("Shape", "Status", "Label")

    def __init__(self, obj, tabs: list):
        super().__init__()
        self.obj = obj  # None: it is gone
        self.frame = None  # the QMdiSubWindow
        self._tabs = tabs
        self._soon = QtCore.QTimer(self)
        self._soon.setSingleShot(True)
        self._soon.timeout.connect(self.follow)
        self._tasks = EmptyTasks(self, self._is_in_front)
        self._tasks.looked.connect(self._lie_beside)

    def show_object(self) -> None:
        """Show the object as it is now."""
        raise NotImplementedError

    def let_go(self) -> None:
        """The object is shown no longer: it is deleted, or the tab closes."""

    def closed(self, obj) -> None:
        """The tab was closed, and the object is still there."""

    def changed(self) -> None:
        """The object is another one now: it is looked at when FreeCAD is done with it."""
        self._soon.start(0)

    def follow(self) -> None:
        """Show the object, as soon as its document is recomputed."""
        if self.obj is None:
            return
        if self.obj.Document.Recomputing:
            self._soon.start(_PATIENCE)
        else:
            self.show_object()

    def leave(self) -> None:
        """The object is being deleted: the tab closes when FreeCAD is done with that."""
        self.let_go()
        self.obj = None
        self._soon.stop()
        QtCore.QTimer.singleShot(0, self.close_tab)

    def close_tab(self) -> None:
        """The work is done."""
        if self in self._tabs:
            self.frame.close()

    def showEvent(self, event):
        super().showEvent(event)
        self._tasks.start()

    def hideEvent(self, event):
        self._tasks.stop()
        super().hideEvent(event)

    def closeEvent(self, event):
        obj = self.obj
        if obj is not None:
            self.let_go()
        self.obj = None
        self._soon.stop()
        if self in self._tabs:
            self._tabs.remove(self)
            if obj is not None:
                self.closed(obj)
        super().closeEvent(event)

    def _is_in_front(self) -> bool:
        return not self.visibleRegion().isEmpty()

    def _lie_beside(self) -> None:
        """What overlays cover is left free: they would take the mouse there."""
        if not self._is_in_front():
            return
        left, top, right, bottom = covered(self)
        is_narrow = self.width() - left - right < _LEAST or self.height() - top - bottom < _LEAST
        self.layout().setContentsMargins(*((0, 0, 0, 0) if is_narrow else (left, top, right, bottom)))


class TabWatch(Guarded):
    """What FreeCAD calls when objects of the tabs of one kind change and go."""

    def __init__(self, tabs: list):
        self.tabs = tabs

    def slotChangedObject(self, obj, name) -> None:
        for tab in self._of(obj):
            if name in tab.SHOWN:
                tab.changed()

    def slotDeletedObject(self, obj) -> None:
        for tab in self._of(obj):
            tab.leave()

    def slotDeletedDocument(self, document) -> None:
        for tab in [each for each in self.tabs if each.obj is not None and each.obj.Document == document]:
            tab.leave()

    def _of(self, obj) -> list[DocumentTab]:
        return [tab for tab in self.tabs if tab.obj == obj]


def telling_line(name: str):
    """A line of text below a tab that can be copied."""
    line = QtWidgets.QLabel()
    line.setObjectName(name)
    line.setWordWrap(True)
    line.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
    return line


def column_in(tab):
    """The rows of a tab, without gaps between them."""
    column = QtWidgets.QVBoxLayout(tab)
    column.setContentsMargins(0, 0, 0, 0)
    column.setSpacing(0)
    return column

# SPDX-License-Identifier: LGPL-2.1-or-later
"""A window with a picture that can be zoomed, in which two points may be marked: a click each."""

from __future__ import annotations

import math

import FreeCADGui as Gui

from BalloonWorkbench.gui.qt import QtCore, QtGui, QtWidgets, position, translate
from BalloonWorkbench.gui.tabs.zoom_keys import wheel_zoom
from BalloonWorkbench.gui.wrapping import PushButton

_ARM, _WIDTH = 14, 2  # px
_COLOUR = "#ff2d95"
_SHARE = 0.8  # of the main window


class PictureWindow(QtWidgets.QDialog):
    """`marked` carries how far both points are apart, in pixels of the picture; the picture is only shown
    where marks is False."""

    marked = QtCore.Signal(float)

    def __init__(self, pixmap, title: str, marks: bool):
        super().__init__(Gui.getMainWindow())
        self.setObjectName("PictureWindow")
        self.setWindowTitle(title)
        self.setAttribute(QtCore.Qt.WA_DeleteOnClose)
        self.view = _MarkedView(pixmap, marks)
        self.view.setObjectName("MarkedPicture")
        self.view.points_changed.connect(self._measure)
        column = QtWidgets.QVBoxLayout(self)
        if marks:
            hint = QtWidgets.QLabel(
                translate("Click both ends of a length that you know; a third click moves the nearer mark.")
            )
            hint.setWordWrap(True)
            column.addWidget(hint)
        column.addWidget(self.view)
        done = PushButton(translate("Done") if marks else translate("Close"))
        done.setObjectName("PictureDone")
        done.clicked.connect(lambda _checked=False: self.close())
        column.addWidget(done)
        self.resize(Gui.getMainWindow().size() * _SHARE)

    def showEvent(self, event):
        super().showEvent(event)
        self.view.fit()

    def _measure(self) -> None:
        if len(self.view.points) == 2:
            (ax, ay), (bx, by) = self.view.points
            self.marked.emit(math.hypot(bx - ax, by - ay))


class _MarkedView(QtWidgets.QGraphicsView):
    """The picture: the wheel zooms, dragging moves it, a click marks."""

    points_changed = QtCore.Signal()

    def __init__(self, pixmap, marks: bool):
        super().__init__()
        self.points: list[tuple[float, float]] = []  # in pixels of the picture
        self._marks, self._pressed = marks, None
        self._items: list = []
        self._scene = QtWidgets.QGraphicsScene(self)
        self._picture = self._scene.addPixmap(pixmap)
        self._picture.setTransformationMode(QtCore.Qt.SmoothTransformation)
        self._scene.setSceneRect(self._picture.boundingRect())
        self.setScene(self._scene)
        self.setDragMode(QtWidgets.QGraphicsView.ScrollHandDrag)
        self.setTransformationAnchor(QtWidgets.QGraphicsView.AnchorUnderMouse)
        if marks:
            self.viewport().setCursor(QtCore.Qt.CrossCursor)

    def fit(self) -> None:
        """Show all of the picture."""
        self.fitInView(self._picture, QtCore.Qt.KeepAspectRatio)

    def wheelEvent(self, event):
        factor = wheel_zoom(event)
        self.scale(factor, factor)

    def mousePressEvent(self, event):
        self._pressed = position(event).toPoint()
        super().mousePressEvent(event)

    def mouseReleaseEvent(self, event):
        super().mouseReleaseEvent(event)
        start, self._pressed, end = self._pressed, None, position(event).toPoint()
        near = QtWidgets.QApplication.startDragDistance()
        if not self._marks or start is None or (end - start).manhattanLength() >= near:
            return
        self.viewport().setCursor(QtCore.Qt.CrossCursor)
        at = self.mapToScene(end)
        if self._picture.contains(at):
            self._mark(at.x(), at.y())

    def _mark(self, x: float, y: float) -> None:
        if len(self.points) == 2:
            apart = [math.hypot(x - ax, y - ay) for ax, ay in self.points]
            self.points.pop(apart.index(min(apart)))
        self.points.append((x, y))
        for item in self._items:
            self._scene.removeItem(item)
        self._items = [item for point in self.points for item in self._cross(*point)]
        self.points_changed.emit()

    def _cross(self, x: float, y: float):
        """A cross at a point, as large at every zoom."""
        pen = QtGui.QPen(QtGui.QColor(_COLOUR), _WIDTH)
        for line in ((-_ARM, 0, _ARM, 0), (0, -_ARM, 0, _ARM)):
            item = self._scene.addLine(*line, pen)
            item.setFlag(QtWidgets.QGraphicsItem.ItemIgnoresTransformations)
            item.setPos(x, y)
            yield item

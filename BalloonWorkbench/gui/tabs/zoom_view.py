# SPDX-License-Identifier: LGPL-2.1-or-later
"""A flat view in mm, y up, that is zoomed by the wheel and by keys, and pulled."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.units import from_mm, to_mm
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, position
from BalloonWorkbench.gui.tabs.zoom_keys import OwnKeys, wheel_zoom

_AROUND = 0.03  # of what is shown, left free beside it
_FARTHEST, _NEAREST = 0.1, 400.0  # of the zoom that shows everything


class ZoomView(OwnKeys, QtWidgets.QGraphicsView):
    """Shows what lies in `whole`, a rectangle in mm, and what those who paint it add."""

    def __init__(self, parent=None):
        super().__init__(parent)
        self.whole = QtCore.QRectF()
        self._fitted = True  # until it is zoomed or pulled
        self._fit_zoom = 1.0
        self.setScene(QtWidgets.QGraphicsScene(self))
        self.setTransformationAnchor(QtWidgets.QGraphicsView.NoAnchor)
        self.setResizeAnchor(QtWidgets.QGraphicsView.NoAnchor)
        self.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOff)
        self.setVerticalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOff)
        self.setFrameShape(QtWidgets.QFrame.NoFrame)
        self.setFocusPolicy(QtCore.Qt.StrongFocus)
        self.setMouseTracking(True)
        self.setBackgroundBrush(self.palette().base())
        self.scale(1.0, -1.0)

    def set_whole(self, whole) -> None:
        """What is there is as large as that now; at first all of it is seen."""
        room = max(whole.width(), whole.height())
        self.scene().setSceneRect(whole.adjusted(-room, -room, room, room))  # as far as it can be pulled
        is_first, self.whole = self.whole.isEmpty(), whole
        if is_first:
            self.fit()

    @property
    def zoom(self) -> float:
        """Pixels of a mm."""
        return abs(float(self.transform().m11()))

    def place_of(self, place: np.ndarray):
        """Where a place (2,) m is in the view, in px."""
        return self.mapFromScene(QtCore.QPointF(*to_mm(np.asarray(place)).tolist()))

    def place_at(self, at) -> np.ndarray:
        """The place (2,) m at a point of the view."""
        back, _ = self.viewportTransform().inverted()
        there = back.map(QtCore.QPointF(at))
        return from_mm(np.array([there.x(), there.y()]))

    def fit(self) -> None:
        """Show all of it."""
        if self.whole.isEmpty():
            return
        room = _AROUND * max(self.whole.width(), self.whole.height())
        self.fitInView(self.whole.adjusted(-room, -room, room, room), QtCore.Qt.KeepAspectRatio)
        self._fitted, self._fit_zoom = True, self.zoom

    def zoom_by(self, factor: float, about=None) -> None:
        """Larger or smaller; the place at a point of the view stays, without one the middle."""
        about = self.viewport().rect().center() if about is None else about.toPoint()
        fixed = self.mapToScene(about)
        goal = min(max(self.zoom * factor, _FARTHEST * self._fit_zoom), _NEAREST * self._fit_zoom)
        factor = goal / self.zoom
        self.scale(factor, factor)
        moved = self.mapToScene(about) - fixed
        self.translate(moved.x(), moved.y())
        self._fitted = False

    def pull(self, by) -> None:
        """Move all of it by so many pixels."""
        for bar, pixels in ((self.horizontalScrollBar(), by.x()), (self.verticalScrollBar(), by.y())):
            bar.setValue(bar.value() - pixels)
        self._fitted = False

    def resizeEvent(self, event):
        super().resizeEvent(event)
        if self._fitted:
            self.fit()

    def wheelEvent(self, event):
        self.zoom_by(wheel_zoom(event), position(event))
        event.accept()

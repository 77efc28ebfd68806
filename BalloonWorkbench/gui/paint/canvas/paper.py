# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the paper lies in its widget, and how large: zooming and pulling."""

from __future__ import annotations

from BalloonWorkbench.gui.paint.painting.layers import SIDE
from BalloonWorkbench.gui.qt import QtCore

_NEAREST, _FARTHEST = 16.0, 0.1  # zoom
_FITTING = 0.94  # of the widget, for the whole paper


class Paper:
    """The paper in a widget: as large as fits, until it is zoomed or pulled."""

    def __init__(self, widget):
        self._widget = widget
        self._zoom, self._origin = 0.0, QtCore.QPointF()  # 0: as large as fits

    @property
    def zoom(self) -> float:
        """Screen pixels for one pixel of the painting."""
        return self._zoom or _FITTING * min(self._widget.width(), self._widget.height()) / SIDE

    def origin(self):
        """Where the upper left corner of the paper is."""
        if self._zoom:
            return self._origin
        across = self.zoom * SIDE
        return 0.5 * QtCore.QPointF(self._widget.width() - across, self._widget.height() - across)

    def to_paper(self, point):
        return (point - self.origin()) / self.zoom

    def to_screen(self, point):
        return self.origin() + self.zoom * point

    def zoom_by(self, factor: float, about=None) -> None:
        """Larger or smaller; the place under the pointer stays, without one the middle."""
        about = about or QtCore.QPointF(self._widget.rect().center())
        fixed = self.to_paper(about)
        self._zoom = min(max(self.zoom * factor, _FARTHEST), _NEAREST)
        self._origin = about - self._zoom * fixed
        self._widget.update()

    def pull(self, by) -> None:
        """Move the paper by so many screen pixels."""
        self._origin, self._zoom = self.origin() + by, self.zoom
        self._widget.update()

    def fit(self) -> None:
        """Show all of it."""
        self._zoom = 0.0
        self._widget.update()

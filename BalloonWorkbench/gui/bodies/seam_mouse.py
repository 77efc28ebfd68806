# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mouse on a body whose seams are edited: a seam is picked or dragged, a cut runs from place to place."""

from __future__ import annotations

import math
from enum import Enum

import FreeCADGui as Gui
import numpy as np

from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.gui.bodies.body_scene import BodyScene
from BalloonWorkbench.gui.bodies.body_surface import BodySurface
from BalloonWorkbench.gui.qt import QtCore
from BalloonWorkbench.gui.window.ray import pixel_of, pixel_size, ray

_NEAR = 9.0  # px within which a seam is meant
_STILL = 4.0  # px that a click may move
_REST = 30  # ms until the path follows the mouse
_KEYS = (QtCore.Qt.Key_Escape, QtCore.Qt.Key_Z)


class SeamTool(Enum):
    """What a click on the body does."""

    MERGE = "merge"
    CUT = "cut"
    MOVE = "move"


class SeamMouse(QtCore.QObject):
    """Takes the left button over a Target object before the view does, with one tool, until `remove`.

    `merged` carries the number of a seam, `cut` two places (3,) mm, `moved` a seam, the place (3,) mm by
    which it was held and that to which it was dragged; `chosen` a seam that was clicked; `left` follows Esc
    with nothing begun, `took_back` Ctrl+Z.

    preview  gives the lines (k, 3) mm of a cut between two places, or of a seam that is dragged so
    """

    merged = QtCore.Signal(int)
    cut = QtCore.Signal(object, object)
    moved = QtCore.Signal(int, object, object)
    chosen = QtCore.Signal(int)
    progressed = QtCore.Signal()
    left = QtCore.Signal()
    took_back = QtCore.Signal()

    def __init__(self, target, balloon, tool: SeamTool, preview):
        super().__init__()
        self.tool = tool
        self._preview = preview
        self._target = target
        self._view = Gui.getDocument(target.Document.Name).activeView()
        self._scene = BodyScene(target, balloon)
        self._window = self._view.graphicsView()
        self._main = Gui.getMainWindow()
        self._surface: BodySurface | None = None
        self._start: Floats | None = None  # of a cut
        self._seam: int | None = None  # under the mouse, or held
        self._held: tuple[int, int] | None = None  # the pixel at which the button went down
        self._grip: Floats | None = None  # the place on the body there
        self._at: Floats | None = None
        self._near = 0.0  # mm that _NEAR px are
        self._soon = QtCore.QTimer(self)
        self._soon.setSingleShot(True)
        self._soon.setInterval(_REST)
        self._soon.timeout.connect(self._show)
        self._window.viewport().setMouseTracking(True)
        self._window.viewport().installEventFilter(self)
        self._main.installEventFilter(self)

    @property
    def is_begun(self) -> bool:
        """A cut has its first place, or a seam is held."""
        return self._start is not None or self._held is not None

    def follow(self, surface: BodySurface) -> None:
        """The body as it is divided now."""
        self._surface = surface
        self._seam = self._held = self._start = self._at = None
        self._scene.show_body(surface)
        self._show()

    def remove(self) -> None:
        """Leave the view to FreeCAD."""
        self._soon.stop()
        self._main.removeEventFilter(self)
        if self._scene.is_open():
            self._window.viewport().removeEventFilter(self)
            self._window.viewport().unsetCursor()
            self._scene.remove()

    def mean(self, seam: int | None) -> None:
        """Highlight a seam."""
        self._seam = seam
        self._show()

    def give_up(self) -> None:
        """Forget what is begun."""
        self._start = self._held = None
        self._show()
        self.progressed.emit()

    def eventFilter(self, watched, event):
        kind = event.type()
        if kind in (QtCore.QEvent.ShortcutOverride, QtCore.QEvent.KeyPress):
            return self._key(event)
        if watched is self._main or self._surface is None:
            return False
        if kind == QtCore.QEvent.MouseMove:
            self._point_at(pixel_of(event, self._window))
            return self._held is not None
        if kind not in (QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseButtonRelease):
            return False
        if event.button() != QtCore.Qt.LeftButton:
            return False
        pixel = pixel_of(event, self._window)
        self._point_at(pixel)
        return self._pressed(pixel) if kind == QtCore.QEvent.MouseButtonPress else self._released(pixel)

    def _key(self, event) -> bool:
        """Esc and Ctrl+Z belong to the seams while a tool is in the hand."""
        undo = event.key() == QtCore.Qt.Key_Z and event.modifiers() == QtCore.Qt.ControlModifier
        if event.key() not in _KEYS or (event.key() == QtCore.Qt.Key_Z and not undo):
            return False
        if event.type() == QtCore.QEvent.ShortcutOverride:
            event.accept()  # the key comes once more, to us
            return True
        if self.is_begun:
            self.give_up()
        elif undo:
            self.took_back.emit()
        else:
            self.left.emit()
        return True

    def _point_at(self, pixel: tuple[int, int]) -> None:
        """What is under the mouse now."""
        place = self._target.getGlobalPlacement()
        at = self._surface.hit(*ray(self._view, pixel, place))
        if self._held is None:
            self._near = 0.0 if at is None else _NEAR * pixel_size(self._view, pixel, at, place)
            no_seam = at is None or self.tool is SeamTool.CUT
            self._seam = None if no_seam else self._surface.seam_near(at, self._near)
        self._at = at if at is not None or self._held is None else self._at
        over = self._seam is not None or (self.tool is SeamTool.CUT and at is not None)
        self._window.viewport().setCursor(QtCore.Qt.PointingHandCursor if over else QtCore.Qt.ArrowCursor)
        if not self._soon.isActive():
            self._soon.start()

    def _pressed(self, pixel: tuple[int, int]) -> bool:
        if self._at is None or (self._seam is None and self.tool is not SeamTool.CUT):
            return False
        self._held, self._grip = pixel, self._at
        return True

    def _released(self, pixel: tuple[int, int]) -> bool:
        if self._held is None:
            return False
        still = math.dist(self._held, pixel) < _STILL
        self._held = None
        if self.tool is SeamTool.CUT:
            self._pick(self._at)
        elif self.tool is SeamTool.MOVE and not still:
            self.moved.emit(self._seam, self._grip, self._at)
        elif still:
            self.chosen.emit(self._seam)
            if self.tool is SeamTool.MERGE:
                self.merged.emit(self._seam)
        self._show()
        self.progressed.emit()
        return True

    def _pick(self, at: Floats) -> None:
        """The first place of a cut, or its second."""
        start, self._start = self._start, None
        if start is None:
            self._start = at
        else:
            self.cut.emit(start, at)

    def _show(self) -> None:
        """The seam that is meant, and the new ones as they would be."""
        if self._surface is None:
            return
        seam, lines = None if self._seam is None else self._surface.line(self._seam), []
        begun = self._start if self._start is not None else self._grip if self._held is not None else None
        if begun is not None and self._at is not None and np.linalg.norm(self._at - begun) > self._near:
            if self._start is not None:
                lines = self._preview(None, [begun, self._at])
            elif self.tool is SeamTool.MOVE:
                lines = self._preview(self._seam, [begun, self._at])
        self._scene.show_marks(seam, lines, [] if self._start is None else [self._start])

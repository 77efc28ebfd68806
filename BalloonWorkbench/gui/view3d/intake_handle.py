# SPDX-License-Identifier: LGPL-2.1-or-later
"""A handle in the 3D view: the intake of a pattern is dragged along its outline with the mouse."""

from __future__ import annotations

import math

import FreeCAD as App
import FreeCADGui as Gui

from BalloonWorkbench.app.shapes import part_shapes
from BalloonWorkbench.core.design.fairing import faired
from BalloonWorkbench.core.pattern.intake.rim import Rim
from BalloonWorkbench.core.units import from_mm, to_mm
from BalloonWorkbench.gui.qt import QtCore
from BalloonWorkbench.gui.window.ray import pixel_of, ray

_NEAR = 14.0  # px at which the mouse catches the handle
_COLOUR, _CAUGHT = (0.10, 0.55, 0.95), (1.00, 0.55, 0.00)
_RING = 0.03  # radius, of the size of the pattern
_EDGE_ON = 1e-6  # sine of the angle between the line of sight and the plane
_ABOVE = 0.002  # the handle hovers over the pattern, of its size


class IntakeHandle(QtCore.QObject):
    """The handle of one pattern object; `dropped` is called with a place along the seam [mm] after a drag.

    It takes the mouse before the view does: there, a release over a line selects it and goes no further.
    """

    def __init__(self, pattern, dropped):
        super().__init__()
        self.pattern = pattern
        self._dropped = dropped
        self._rim = Rim(faired(part_shapes.stored(pattern.Balloon, "Seam").outer))
        self._along = from_mm(pattern.IntakeAlong.Value)
        self._held = False
        self._document = pattern.Document.Name
        self._view = Gui.getDocument(self._document).activeView()
        self._node = None
        if not hasattr(self._view, "graphicsView"):
            return
        self._node = self._made()
        self._draw()
        self._view.getSceneGraph().addChild(self._node)
        self._window = self._view.graphicsView()
        self._surface = self._window.viewport()
        self._surface.installEventFilter(self)

    def remove(self) -> None:
        """Take the handle out of the view."""
        if self._node is None or not self._is_open():
            return
        self._surface.removeEventFilter(self)
        self._view.getSceneGraph().removeChild(self._node)
        self._node = None

    def eventFilter(self, _surface, event):
        kind = event.type()
        if kind == QtCore.QEvent.MouseButtonPress and event.button() == QtCore.Qt.LeftButton:
            return self._pressed(pixel_of(event, self._window))
        if self._held and kind == QtCore.QEvent.MouseMove:
            self._moved(pixel_of(event, self._window))
            return True
        if self._held and kind == QtCore.QEvent.MouseButtonRelease and event.button() == QtCore.Qt.LeftButton:
            self._held = False
            self._draw()
            self._dropped(to_mm(self._along))
            return True
        return False

    def _is_open(self) -> bool:
        try:
            return Gui.getDocument(self._document) is not None
        except NameError:
            return False

    def follow(self) -> None:
        """Show the place that the pattern has now."""
        if self._node is not None and not self._held:
            self._along = from_mm(self.pattern.IntakeAlong.Value)
            self._draw()

    def _pressed(self, pixel: tuple[int, int]) -> bool:
        """Take hold where the handle is; whether that was so."""
        at = self._view.getPointOnScreen(self._global(self._along))
        self._held = math.dist(at, pixel) < _NEAR
        self._draw()
        return self._held

    def _moved(self, pixel: tuple[int, int]) -> None:
        place = self._on_plane(pixel)
        if place is not None:
            self._along = self._rim.nearest(place)
            self._draw()

    def _on_plane(self, pixel):
        """The point (2,) m of the pattern's plane under a pixel; None where it is seen from its edge."""
        start, ahead = ray(self._view, pixel, self.pattern.Placement)
        if abs(ahead[2]) < _EDGE_ON:
            return None
        return from_mm((start - ahead * (start[2] / ahead[2]))[:2])

    def _global(self, along: float):
        x, y = to_mm(self._rim.at(along)).tolist()
        return self.pattern.Placement.multVec(App.Vector(x, y, 0.0))

    def _draw(self) -> None:
        """A ring on the rim, and the sides of a neck."""
        size = to_mm(float(max(self._rim.points.max(axis=0) - self._rim.points.min(axis=0))))
        x, y = to_mm(self._rim.at(self._along)).tolist()
        turn = self._rim.outward(self._along, 0.5 * from_mm(self.pattern.IntakeWidth.Value))
        ahead, side = (math.cos(turn), math.sin(turn)), (-math.sin(turn), math.cos(turn))
        half, length = 0.5 * self.pattern.IntakeWidth.Value, 0.12 * size

        def beside(across: float, along: float):
            return tuple(at + across * s + along * a for at, s, a in zip((x, y), side, ahead))

        circle = [2.0 * math.pi * k / 32 for k in range(33)]
        lines = [
            [(x + _RING * size * math.cos(k), y + _RING * size * math.sin(k)) for k in circle],
            [beside(half, 0.0), beside(half, length)],
            [beside(-half, 0.0), beside(-half, length)],
        ]
        places = [
            self.pattern.Placement.multVec(App.Vector(*point, _ABOVE * size))
            for line in lines
            for point in line
        ]
        self._points.point.setValues(0, len(places), [(at.x, at.y, at.z) for at in places])
        self._lines.numVertices.setValues(0, len(lines), [len(line) for line in lines])
        self._colour.rgb.setValue(*(_CAUGHT if self._held else _COLOUR))

    def _made(self):
        """The node of the handle, still without its place: the scene stays as it is while the mouse moves."""
        from pivy import coin

        node, light, pick, style = (
            kind() for kind in (coin.SoSeparator, coin.SoLightModel, coin.SoPickStyle, coin.SoDrawStyle)
        )
        light.model.setValue(coin.SoLightModel.BASE_COLOR)
        pick.style.setValue(coin.SoPickStyle.UNPICKABLE)
        style.lineWidth.setValue(4.0)
        self._colour, self._points, self._lines = coin.SoBaseColor(), coin.SoCoordinate3(), coin.SoLineSet()
        for child in (light, pick, style, self._colour, self._points, self._lines):
            node.addChild(child)
        return node

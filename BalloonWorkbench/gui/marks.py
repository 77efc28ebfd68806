# SPDX-License-Identifier: LGPL-2.1-or-later
"""Marks in the 3D view: lines over the shape and a ring round a place, coloured by how much it matters."""

from __future__ import annotations

import math

import FreeCADGui as Gui

from BalloonWorkbench.core.units import to_mm

COLOURS = {"hint": (0.10, 0.55, 0.95), "warning": (1.00, 0.55, 0.00), "serious": (0.90, 0.05, 0.05)}
_RING = 0.03  # radius, of the size of the shape
_ABOVE = 0.002  # the marks hover over the shape, of its size


class Marks:
    """What is marked on one balloon; `clear` takes it away."""

    def __init__(self, document_name: str):
        self._document_name = document_name
        self._root = None
        self._node = None

    def show(self, finding, placement, size: float, height: float) -> None:
        """Mark a finding of the core instead of the last one.

        placement  of the outline; size of the shape and height over its plane [mm]
        """
        from pivy import coin

        self.clear()
        document = Gui.getDocument(self._document_name)
        view = document.activeView() if document is not None else None
        if view is None or not hasattr(view, "getSceneGraph"):
            return
        node = coin.SoSeparator()
        material = coin.SoBaseColor()
        material.rgb.setValue(*COLOURS[finding.severity.value])
        style = coin.SoDrawStyle()
        style.lineWidth.setValue(4.0)
        light = coin.SoLightModel()
        light.model.setValue(coin.SoLightModel.BASE_COLOR)
        pick = coin.SoPickStyle()
        pick.style.setValue(coin.SoPickStyle.UNPICKABLE)
        for child in (light, material, style, pick):
            node.addChild(child)
        x, y = (to_mm(value) for value in finding.place)
        radius = _RING * size
        turn = [2.0 * math.pi * k / 48 for k in range(49)]
        ring = [(x + radius * math.cos(angle), y + radius * math.sin(angle)) for angle in turn]
        for line in (ring, *(to_mm(line).tolist() for line in finding.extent)):
            node.addChild(_line(coin, line, placement, height + _ABOVE * size))
        self._root, self._node = view.getSceneGraph(), node
        self._root.addChild(node)

    def clear(self) -> None:
        """Take the mark away."""
        if self._root is not None and Gui.getDocument(self._document_name) is not None:
            self._root.removeChild(self._node)
        self._root = self._node = None


def _line(coin, points, placement, height: float):
    import FreeCAD as App

    node = coin.SoSeparator()
    places = [placement.multVec(App.Vector(x, y, height)) for x, y in points]
    coordinates = coin.SoCoordinate3()
    coordinates.point.setValues(0, len(places), [(place.x, place.y, place.z) for place in places])
    line = coin.SoLineSet()
    line.numVertices.setValue(len(places))
    for child in (coordinates, line):
        node.addChild(child)
    return node

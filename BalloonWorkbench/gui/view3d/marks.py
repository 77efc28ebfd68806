# SPDX-License-Identifier: LGPL-2.1-or-later
"""In the 3D view: marks on places, coloured by how much they matter, and a map of the thickness."""

from __future__ import annotations

import math

import FreeCAD as App
import FreeCADGui as Gui

from BalloonWorkbench.core.units import to_mm

COLOURS = {"hint": (0.10, 0.55, 0.95), "warning": (1.00, 0.55, 0.00), "serious": (0.90, 0.05, 0.05)}
_RING = 0.03  # radius, of the size of the shape
_ABOVE = 0.002  # the marks hover over the shape, of its size


class PlaceMarks:
    """A mark and a map over one balloon; `clear` takes them away."""

    def __init__(self, document_name: str):
        self._document_name = document_name
        self._nodes: dict[str, tuple] = {}  # root and node by what it is

    def mark(self, finding, placement, size: float, height: float) -> None:
        """Mark a finding of the core instead of the last one.

        placement  of the outline, or of a balloon of many panels; size of the shape and height over its plane
                   [mm]
        """
        from pivy import coin

        material = coin.SoBaseColor()
        material.rgb.setValue(*COLOURS[finding.severity.value])
        style = coin.SoDrawStyle()
        style.lineWidth.setValue(4.0)
        x, y, *z = (to_mm(value) for value in finding.place)
        radius = _RING * size
        turn = [2.0 * math.pi * k / 48 for k in range(49)]
        ring = [(x + radius * math.cos(angle), y + radius * math.sin(angle)) for angle in turn]
        lines = [ring, *(to_mm(line).tolist() for line in finding.extent)]
        above = height + _ABOVE * size + sum(z)
        self._show("mark", [material, style, *(_line(coin, line, placement, above) for line in lines)])

    def map(self, thickness_map, placement, height: float) -> None:
        """Colour the shape by a thickness map of the core, from blue for nothing to red for the most."""
        from pivy import coin

        share = thickness_map.thickness / thickness_map.thickness.max()
        colours = coin.SoMaterial()
        colours.diffuseColor.setValues(0, len(share), [_colour(value) for value in share.tolist()])
        binding = coin.SoMaterialBinding()
        binding.value.setValue(coin.SoMaterialBinding.PER_VERTEX_INDEXED)
        corners = _coordinates(coin, to_mm(thickness_map.points).tolist(), placement, height)
        faces = coin.SoIndexedFaceSet()
        numbers = [number for triangle in thickness_map.triangles.tolist() for number in (*triangle, -1)]
        faces.coordIndex.setValues(0, len(numbers), numbers)
        self._show("map", [colours, binding, corners, faces])

    def clear(self, what: str = "") -> None:
        """Take the mark or the map away, or both."""
        for name in [name for name in self._nodes if what in ("", name)]:
            root, node = self._nodes.pop(name)
            if self._document() is not None:
                root.removeChild(node)

    def _document(self):
        """The document in the window; None when it is being closed."""
        try:
            return Gui.getDocument(self._document_name)
        except NameError:
            return None

    def _show(self, what: str, children) -> None:
        from pivy import coin

        self.clear(what)
        document = self._document()
        view = document.activeView() if document is not None else None
        if view is None or not hasattr(view, "getSceneGraph"):
            return
        node = coin.SoSeparator()
        light = coin.SoLightModel()
        light.model.setValue(coin.SoLightModel.BASE_COLOR)
        pick = coin.SoPickStyle()
        pick.style.setValue(coin.SoPickStyle.UNPICKABLE)
        for child in (light, pick, *children):
            node.addChild(child)
        root = view.getSceneGraph()
        root.addChild(node)
        self._nodes[what] = root, node


def _line(coin, points, placement, height: float):
    node = coin.SoSeparator()
    line = coin.SoLineSet()
    line.numVertices.setValue(len(points))
    for child in (_coordinates(coin, points, placement, height), line):
        node.addChild(child)
    return node


def _coordinates(coin, points, placement, height: float):
    places = [placement.multVec(App.Vector(x, y, height)) for x, y in points]
    coordinates = coin.SoCoordinate3()
    coordinates.point.setValues(0, len(places), [(place.x, place.y, place.z) for place in places])
    return coordinates


def _colour(share: float) -> tuple[float, float, float]:
    """Blue, cyan, green, yellow, red for 0 to 1."""
    return tuple(min(max(1.5 - abs(4.0 * share - peak), 0.0), 1.0) for peak in (3.0, 2.0, 1.0))

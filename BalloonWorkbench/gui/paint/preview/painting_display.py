# SPDX-License-Identifier: LGPL-2.1-or-later
"""The display mode of a balloon that shows what is painted on it."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.app.artwork import on_balloon, on_panels
from BalloonWorkbench.app.document.kinds import is_outline, leader
from BalloonWorkbench.app.drawings.painting import artwork
from BalloonWorkbench.gui.paint.preview.scene import film_nodes, painted_texture
from BalloonWorkbench.gui.qt import QtGui

MODE = "Painted"
_SLACK = 0.01  # of the thickness, by which two panels may reach over the plane between them


class PaintedFilm:
    """The balloon's mesh with its artwork, else with the painting of its outline, seen from the front."""

    def __init__(self, vobj):
        from pivy import coin

        self._node = coin.SoGroup()
        vobj.addDisplayMode(self._node, MODE)

    def follow(self, obj) -> None:
        """Show the balloon as it is now; bare film where its outline is not painted."""
        from pivy import coin

        self._node.removeAllChildren()
        points, facets = obj.Mesh.Topology
        if not points:
            return
        panels = on_panels(obj)
        if panels is not None:
            for node in _wrapped(coin, panels):
                self._node.addChild(node)
            return
        positions = np.array([(point.x, point.y, point.z) for point in points])
        both = on_balloon(obj)
        if both is None:
            drawn = obj.Outline is not None and is_outline(leader(obj.Outline))
            both = (artwork(obj.Outline) if drawn else None,) * 2
        for art, side in zip(both, _sides(positions, np.array(facets))):
            self._node.addChild(_painted(coin, positions, side, art))


def _sides(positions: np.ndarray, facets: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The facets that are seen from the front, and those from behind.

    Of two equal panels those of the front come first, then as many of the back.
    """
    half = len(facets) // 2
    heights = positions[facets, 2]
    slack = _SLACK * float(np.ptp(heights))
    if heights[:half].min() >= -slack and heights[half:].max() <= slack:
        return facets[:half], facets[half:]
    a, b, c = (positions[facets[:, k]] for k in range(3))
    front = np.cross(b - a, c - a)[:, 2] >= 0.0
    return facets[front], facets[~front]


def _painted(coin, positions: np.ndarray, facets: np.ndarray, art):
    """A node of one side with its artwork, seen from the front."""
    rgba = np.zeros((1, 1, 4), np.uint8) if art is None else art.rgba
    places = np.zeros((len(positions), 2)) if art is None else art.places(positions)
    return _textured(coin, positions, facets, rgba, places, facets)


def _wrapped(coin, panels) -> list:
    """A node for each picture, with all panels that carry it."""
    nodes = []
    for art in {id(panel[2]): panel[2] for panel in panels}.values():
        own = [panel for panel in panels if panel[2] is art]
        starts = np.cumsum([0, *(len(places) for places, *_ in own)])
        facets = np.concatenate([triangles + at for (_, triangles, *_), at in zip(own, starts)])
        corners = art.places(np.concatenate([corners for *_, corners in own]).reshape(-1, 2))
        positions = np.concatenate([places for places, *_ in own])
        each = np.arange(len(corners)).reshape(-1, 3)
        nodes.append(_textured(coin, positions, facets, art.rgba, corners, each))
    return nodes


def _textured(coin, positions, facets, rgba, places, corners):
    """A node of facets (m, 3) whose corners (m, 3) are at some of the places (k, 2) of a picture."""
    height, width = rgba.shape[:2]
    picture = QtGui.QImage(rgba.tobytes(), width, height, 4 * width, QtGui.QImage.Format_RGBA8888)
    film, mesh = coin.SoSeparator(), coin.SoIndexedFaceSet()
    points, painted = coin.SoCoordinate3(), coin.SoTextureCoordinate2()
    points.point.setValues(0, len(positions), positions.tolist())
    painted.point.setValues(0, len(places), places.tolist())
    for field, numbers in ((mesh.coordIndex, facets), (mesh.textureCoordIndex, corners)):
        ended = np.column_stack([numbers, np.full(len(numbers), -1)]).ravel().tolist()
        field.setValues(0, len(ended), ended)
    for child in (*film_nodes(coin, painted_texture(coin, picture)), points, painted, mesh):
        film.addChild(child)
    return film

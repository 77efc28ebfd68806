# SPDX-License-Identifier: LGPL-2.1-or-later
"""The display mode of a balloon that shows what is painted on it."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.app.artwork import on_balloon
from BalloonWorkbench.app.drawings.painting import artwork
from BalloonWorkbench.gui.paint.preview.scene import film_nodes, painted_texture
from BalloonWorkbench.gui.qt import QtGui

MODE = "Painted"


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
        positions = np.array([(point.x, point.y, point.z) for point in points])
        both = on_balloon(obj)
        if both is None:
            both = (artwork(obj.Outline) if obj.Outline else None,) * 2
        # the facets of the front come first, then as many of the back
        sides = np.split(np.array(facets), [len(facets) // 2])
        for art, side in zip(both, sides):
            self._node.addChild(_painted(coin, positions, side, art))


def _painted(coin, positions: np.ndarray, facets: np.ndarray, art):
    """A node of one side with its artwork, seen from the front."""
    rgba = np.zeros((1, 1, 4), np.uint8) if art is None else art.rgba
    places = np.zeros((len(positions), 2)) if art is None else art.places(positions)
    height, width = rgba.shape[:2]
    picture = QtGui.QImage(rgba.tobytes(), width, height, 4 * width, QtGui.QImage.Format_RGBA8888)
    film, mesh = coin.SoSeparator(), coin.SoIndexedFaceSet()
    corners, painted = coin.SoCoordinate3(), coin.SoTextureCoordinate2()
    corners.point.setValues(0, len(positions), positions.tolist())
    painted.point.setValues(0, len(places), places.tolist())
    faces = np.column_stack([facets, np.full(len(facets), -1)]).ravel().tolist()
    mesh.coordIndex.setValues(0, len(faces), faces)
    for child in (*film_nodes(coin, painted_texture(coin, picture)), corners, painted, mesh):
        film.addChild(child)
    return film

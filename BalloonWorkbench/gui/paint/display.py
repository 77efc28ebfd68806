# SPDX-License-Identifier: LGPL-2.1-or-later
"""The display mode of a balloon that shows what is painted on it."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.app.outline import leader
from BalloonWorkbench.app.painting import is_painting
from BalloonWorkbench.app.qt_picture import pixels
from BalloonWorkbench.gui.paint.scene import film_nodes
from BalloonWorkbench.gui.qt import QtGui

MODE = "Painted"


class PaintedFilm:
    """The balloon's mesh with the painting of its outline, seen from the front."""

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
        positions = np.array([tuple(point) for point in points])
        picture = QtGui.QImage(1, 1, QtGui.QImage.Format_ARGB32)
        picture.fill(0)
        places = np.zeros((len(positions), 2))
        drawing = leader(obj.Outline) if obj.Outline else None
        if drawing is not None and is_painting(drawing.Drawing):
            picture = QtGui.QImage(drawing.Drawing)
            places = _places(positions, drawing, picture)
        film, mesh = coin.SoSeparator(), coin.SoIndexedFaceSet()
        corners, painted = coin.SoCoordinate3(), coin.SoTextureCoordinate2()
        corners.point.setValues(0, len(positions), positions.tolist())
        painted.point.setValues(0, len(places), places.tolist())
        faces = np.column_stack([np.array(facets), np.full(len(facets), -1)]).ravel().tolist()
        mesh.coordIndex.setValues(0, len(faces), faces)
        for child in (*film_nodes(coin, picture), corners, painted, mesh):
            film.addChild(child)
        self._node.addChild(film)


def _places(positions, drawing, picture) -> np.ndarray:
    """Where each point (n, 3) mm of the balloon is in the picture (n, 2), 0 to 1, y up."""
    rows, columns = np.nonzero(pixels(picture)[..., 3] > 127)
    width, height = columns.max() + 1 - columns.min(), rows.max() + 1 - rows.min()
    scale = width / drawing.Width.Value if drawing.Width.Value else height / drawing.Height.Value
    corner = columns.min(), picture.height() - 1 - rows.max()
    return (corner + scale * positions[:, :2]) / (picture.width(), picture.height())

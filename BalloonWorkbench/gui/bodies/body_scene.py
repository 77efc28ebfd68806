# SPDX-License-Identifier: LGPL-2.1-or-later
"""The body while its seams are edited: its panels in their tints, the seam that is meant, the path to be."""

from __future__ import annotations

import FreeCADGui as Gui
import numpy as np

from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.gui.bags.panel_display import line_node
from BalloonWorkbench.gui.bags.seam_colours import panel_tint
from BalloonWorkbench.gui.bodies.body_surface import BodySurface

PATH, POINT = (0.90, 0.05, 0.05), (1.00, 0.55, 0.00)
_THICK = 7.0  # px, of a seam that is meant
_PATH = 4.0  # px
_DOT = 10.0  # px


class BodyScene:
    """Nodes over a Target object; its balloon is out of the way as long as they are there."""

    def __init__(self, target, balloon):
        from pivy import coin

        self._target, self._balloon = target, balloon
        self._document = target.Document.Name
        self._root, self._body, self._marks = coin.SoSeparator(), coin.SoSeparator(), coin.SoAnnotation()
        self._root.addChild(self._body)
        self._root.addChild(self._marks)
        target.ViewObject.RootNode.addChild(self._root)
        self._hidden = [obj for obj in (balloon,) if obj is not None and obj.ViewObject.Visibility]
        for obj in self._hidden:
            obj.ViewObject.Visibility = False

    def is_open(self) -> bool:
        """The document is still in the window."""
        try:
            return Gui.getDocument(self._document) is not None
        except NameError:
            return False

    def remove(self) -> None:
        """Take everything away, and show the balloon again."""
        self._target.ViewObject.RootNode.removeChild(self._root)
        for obj in self._hidden:
            obj.ViewObject.Visibility = True

    def show_body(self, surface: BodySurface) -> None:
        """The surface, each panel in its tint."""
        from pivy import coin

        self._body.removeAllChildren()
        hints, pick, film, binding = (
            kind() for kind in (coin.SoShapeHints, coin.SoPickStyle, coin.SoMaterial, coin.SoMaterialBinding)
        )
        hints.vertexOrdering.setValue(coin.SoShapeHints.COUNTERCLOCKWISE)
        hints.shapeType.setValue(coin.SoShapeHints.SOLID)
        pick.style.setValue(coin.SoPickStyle.UNPICKABLE)
        tints = [panel_tint(number) for number in range(int(surface.panels.max(initial=0)) + 1)]
        film.diffuseColor.setValues(0, len(surface.panels), [tints[k] for k in surface.panels.tolist()])
        binding.value.setValue(coin.SoMaterialBinding.PER_FACE)
        back, places, faces = coin.SoPolygonOffset(), coin.SoCoordinate3(), coin.SoIndexedFaceSet()
        places.point.setValues(0, len(surface.points), surface.points.tolist())
        corners = np.column_stack([surface.triangles, np.full(len(surface.triangles), -1)]).ravel().tolist()
        faces.coordIndex.setValues(0, len(corners), corners)
        for child in (hints, pick, back, film, binding, places, faces):
            self._body.addChild(child)

    def show_marks(self, seam: Floats | None, lines: list[Floats], places: list[Floats]) -> None:
        """The seam (k, 3) mm that is meant, the seams (k, 3) that a tool would draw, picked places (3,)."""
        self._marks.removeAllChildren()
        if seam is not None:
            self._marks.addChild(line_node(seam, POINT, _THICK))
        for line in lines:
            self._marks.addChild(line_node(line, PATH, _PATH))
        if places:
            self._marks.addChild(_dots(places))


def _dots(places: list[Floats]):
    from pivy import coin

    node, light, style, colour, points, dots = (
        kind()
        for kind in (
            *(coin.SoSeparator, coin.SoLightModel, coin.SoDrawStyle),
            *(coin.SoBaseColor, coin.SoCoordinate3, coin.SoPointSet),
        )
    )
    light.model.setValue(coin.SoLightModel.BASE_COLOR)
    style.pointSize.setValue(_DOT)
    colour.rgb.setValue(*POINT)
    points.point.setValues(0, len(places), [place.tolist() for place in places])
    for child in (light, style, colour, points, dots):
        node.addChild(child)
    return node

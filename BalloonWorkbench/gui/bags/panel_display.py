# SPDX-License-Identifier: LGPL-2.1-or-later
"""The display mode of a balloon that tells its panels apart: a tint for each, and each seam in its colour."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.gui.bags.seam_colours import panel_tint, seam_colour
from BalloonWorkbench.gui.view3d.skin import Skin, SkinNodes, skin_of

PANELS = "Panels"
_WIDTH = 3.0  # px, of a seam


class PanelDisplay:
    """Nodes of the mode PANELS; they are made when they are looked at."""

    def __init__(self, vobj):
        from pivy import coin

        self._node = coin.SoGroup()
        vobj.addDisplayMode(self._node, PANELS)

    def follow(self, obj) -> None:
        """Show the balloon as it is now."""
        self._node.removeAllChildren()
        skin = skin_of(obj)
        if skin is None:
            return
        self._node.addChild(_panels(skin))
        for number, line in enumerate(skin.lines):
            self._node.addChild(line_node(skin.positions[line], seam_colour(number), _WIDTH))


def _panels(skin: Skin):
    from pivy import coin

    panels = np.zeros(len(skin.triangles), dtype=int) if skin.panels is None else skin.panels
    shape, film, binding = coin.SoSeparator(), coin.SoMaterial(), coin.SoMaterialBinding()
    tints = [panel_tint(number) for number in range(int(panels.max(initial=0)) + 1)]
    film.diffuseColor.setValues(0, len(panels), [tints[number] for number in panels.tolist()])
    binding.value.setValue(coin.SoMaterialBinding.PER_FACE)
    for child in (film, binding, SkinNodes(skin).film):
        shape.addChild(child)
    return shape


def line_node(points: np.ndarray, rgb: tuple[float, float, float], width: float):
    """A line through points (n, 3) mm, in one colour, `width` px wide; the mouse goes through it."""
    from pivy import coin

    node, light, style, pick = (
        kind() for kind in (coin.SoSeparator, coin.SoLightModel, coin.SoDrawStyle, coin.SoPickStyle)
    )
    light.model.setValue(coin.SoLightModel.BASE_COLOR)
    pick.style.setValue(coin.SoPickStyle.UNPICKABLE)
    style.lineWidth.setValue(width)
    colour, places, line = coin.SoBaseColor(), coin.SoCoordinate3(), coin.SoLineSet()
    colour.rgb.setValue(*rgb)
    places.point.setValues(0, len(points), points.tolist())
    line.numVertices.setValue(len(points))
    for child in (light, pick, style, colour, places, line):
        node.addChild(child)
    return node

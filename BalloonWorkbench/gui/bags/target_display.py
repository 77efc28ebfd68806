# SPDX-License-Identifier: LGPL-2.1-or-later
"""The seams of a target as they are seen on the body: each in its colour, with its number beside it."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.app.properties.property_table import is_complete
from BalloonWorkbench.app.target import PROPERTIES, division
from BalloonWorkbench.core.geometry.polyline import line_lengths, point_on
from BalloonWorkbench.core.geometry.vectors import unit
from BalloonWorkbench.core.targets.target import Division
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import to_mm
from BalloonWorkbench.gui.bags.seam_colours import seam_colour

_ABOVE = 0.02  # of the diagonal, over which a number stands: film bulges beside its seam
_FONT = 15.0  # px


class TargetDisplay:
    """Numbers beside the seams of a Target object; its lines are FreeCAD's own, in our colours."""

    def __init__(self, vobj):
        from pivy import coin

        self._vobj = vobj
        self._switch = coin.SoSwitch()
        vobj.RootNode.addChild(self._switch)

    def follow(self) -> None:
        """Show the seams as they are."""
        obj = self._vobj.Object
        self._switch.removeAllChildren()
        if not is_complete(obj, PROPERTIES) or not obj.TargetPoints:
            return
        made = division(obj)
        edges = [seam_colour(number) for number, seam in enumerate(made.seams) for _ in seam.vertices[1:]]
        self._vobj.LineColorArray = edges
        for number, place in enumerate(number_places(made)):
            self._switch.addChild(_number_node(to_mm(place), number))
        self.follow_visibility()

    def follow_visibility(self) -> None:
        """Numbers come and go with the lines."""
        from pivy import coin

        shown = self._vobj.Visibility
        self._switch.whichChild.setValue(coin.SO_SWITCH_ALL if shown else coin.SO_SWITCH_NONE)


def number_places(made: Division) -> Floats:
    """Where the number of each seam stands (seams, 3) m: outside of its middle."""
    target = made.target
    corners = target.triangles.ravel()
    sums = np.zeros((len(target.points), 3))
    np.add.at(sums, corners, np.repeat(target.area_vectors, 3, axis=0))
    outward = unit(sums)
    places = []
    for number, seam in enumerate(made.seams):
        line = target.points[seam.vertices]
        middle = middle_of(made, number)
        nearest = seam.vertices[int(np.argmin(np.linalg.norm(line - middle, axis=1)))]
        places.append(middle + _ABOVE * target.diagonal * outward[nearest])
    return np.array(places).reshape(-1, 3)


def middle_of(made: Division, seam: int) -> Floats:
    """The place (3,) m in the middle of a seam."""
    line = made.target.points[made.seams[seam].vertices]
    lengths = line_lengths(line)
    return np.asarray(point_on(line, lengths, np.array([0.5 * lengths[-1]]))[0])


def _number_node(place: Floats, number: int):
    from pivy import coin

    node, light, pick, colour, font, at, text = (
        kind()
        for kind in (
            *(coin.SoSeparator, coin.SoLightModel, coin.SoPickStyle, coin.SoBaseColor),
            *(coin.SoFont, coin.SoTranslation, coin.SoText2),
        )
    )
    light.model.setValue(coin.SoLightModel.BASE_COLOR)
    pick.style.setValue(coin.SoPickStyle.UNPICKABLE)
    colour.rgb.setValue(*seam_colour(number))
    font.size.setValue(_FONT)
    at.translation.setValue(*place.tolist())
    text.string.setValue(str(number + 1))
    text.justification.setValue(coin.SoText2.CENTER)
    for child in (light, pick, colour, font, at, text):
        node.addChild(child)
    return node

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which edge or piece of the flat ones is meant by what is picked in the 3D view."""

from __future__ import annotations

from typing import NamedTuple

import FreeCAD as App
import numpy as np

from BalloonWorkbench.app.document.kinds import is_balloon, is_panel
from BalloonWorkbench.core.geometry.crossings import inside
from BalloonWorkbench.core.pattern.pattern import Role
from BalloonWorkbench.core.pattern.pieces import PatternPieces
from BalloonWorkbench.core.units import from_mm
from BalloonWorkbench.gui.pattern_view.seam_lights import SeamLights


class Pick(NamedTuple):
    """A document object, the element of it and the place (x, y, z) mm that were picked: in the tree the
    element is empty and the place the origin."""

    obj: object
    element: str
    place: tuple[float, float, float]


def pick_at(pattern, pieces: PatternPieces, lights: SeamLights, pick: Pick) -> tuple[int | None, int | None]:
    """The edge of the pieces, as the pattern lays them, that is meant, else the piece; None each for none."""
    in_tree = not pick.element and not any(pick.place)
    if in_tree:
        return None, pick.obj.Number - 1 if is_panel(pick.obj) else None
    local = pick.obj.getGlobalPlacement().inverse().multVec(App.Vector(*pick.place))
    if is_balloon(pick.obj):
        return lights.meant(pieces, np.array([*local]))
    place = from_mm(np.array([local.x, local.y]))
    nearest = pieces.nearest_edge(place)
    if pick.element.startswith("Edge") and nearest is not None:
        return nearest[0], None
    return None, _piece_at(pieces, place)


def _piece_at(pieces: PatternPieces, place: np.ndarray) -> int | None:
    """The piece on whose film a place (2,) m is."""
    for number, piece in enumerate(pieces.pieces):
        cuts = [cut.points for cut in piece.pattern.of(Role.CUT) if cut.closed]
        if cuts and inside(cuts, place[None])[0]:
            return number
    return None

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the user has laid the flat pieces of a Pattern object: in its properties, by the names of the pieces.

It is how they lie in the view of flat pieces and in print; files for machines have them as the pattern does.
"""

from __future__ import annotations

import math

import FreeCAD as App

from BalloonWorkbench.app.document.kinds import is_pattern
from BalloonWorkbench.app.engine.cut_sheet import pieces
from BalloonWorkbench.app.properties.property_table import result
from BalloonWorkbench.core.errors import InputError

PROPERTIES = (
    result("StringList", "ArrangedPieces", "Names of the pieces that have been arranged", hidden=True),
    result("PlacementList", "PiecePlaces", "Where the middle of each lies, turned and mirrored", hidden=True),
    result("FloatList", "PieceSizes", "How large each was then [mm]", hidden=True),
)
NAMES = tuple(item.name for item in PROPERTIES)

_OVER = App.Rotation(App.Vector(0.0, 1.0, 0.0), 180.0)


def kept(obj):
    """The core's Arrangement that an object keeps; an empty one of what cannot be arranged."""
    from BalloonWorkbench.core.arrangement.arrangement import Arrangement
    from BalloonWorkbench.core.units import from_mm

    if not is_pattern(obj):
        return Arrangement()
    names = list(obj.ArrangedPieces)
    return Arrangement(
        dict(zip(names, map(_place, obj.PiecePlaces))),
        {name: from_mm(size) for name, size in zip(names, obj.PieceSizes)},
    )


def laid(obj):
    """The pieces of an object as they lie, the core's LaidPieces. Raises what `pieces` raises."""
    from BalloonWorkbench.core.arrangement.arrangement import laid_pieces

    return laid_pieces(pieces(obj), kept(obj))


def keep(obj, arrangement) -> None:
    """Let a pattern keep another arrangement; an empty one lays the pieces as the pattern does."""
    from BalloonWorkbench.core.units import to_mm

    obj.ArrangedPieces = list(arrangement.places)
    obj.PiecePlaces = [_placement(place) for place in arrangement.places.values()]
    obj.PieceSizes = [to_mm(arrangement.sizes[name]) for name in arrangement.places]


def lay(obj, name: str | None, at, angle: float, mirrored: bool) -> None:
    """Lay a piece by its name, its middle at (x, y) mm, turned by degrees; all others stay where they are.
    Without a name all lie as the pattern lays them.

    Raises InputError where there is no such piece.
    """
    from BalloonWorkbench.core.arrangement.arrangement import (
        Arrangement,
        PiecePlace,
        arrangement_of,
        names_of,
    )
    from BalloonWorkbench.core.units import from_mm

    if name is None:
        keep(obj, Arrangement())
        return
    now = laid(obj)
    names = names_of(now.base)
    if name not in names:
        raise InputError(f"{obj.Label} has no piece {name}: its pieces are {', '.join(names)}.")
    x, y = at
    place = PiecePlace((from_mm(x), from_mm(y)), math.radians(angle), mirrored)
    places = [place if each == name else own for each, own in zip(names, now.places, strict=True)]
    keep(obj, arrangement_of(now.base, places))


def _place(placement: App.Placement):
    from BalloonWorkbench.core.arrangement.arrangement import PiecePlace
    from BalloonWorkbench.core.units import from_mm

    up, front = (placement.Rotation.multVec(axis) for axis in (App.Vector(0, 1, 0), App.Vector(0, 0, 1)))
    middle = (from_mm(placement.Base.x), from_mm(placement.Base.y))
    return PiecePlace(middle, math.atan2(-up.x, up.y), front.z < 0.0)


def _placement(place) -> App.Placement:
    from BalloonWorkbench.core.units import to_mm

    turn = App.Rotation(App.Vector(0.0, 0.0, 1.0), math.degrees(place.angle))
    middle = App.Vector(*map(to_mm, place.middle), 0.0)
    return App.Placement(middle, turn.multiply(_OVER) if place.mirrored else turn)

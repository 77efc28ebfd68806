# SPDX-License-Identifier: LGPL-2.1-or-later
"""What artwork adds to the pattern: the border of the print, and marks by which a cutter finds it again."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.areas import parts
from BalloonWorkbench.core.geometry.vectors import direction
from BalloonWorkbench.core.options.making import ArtworkOptions
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role
from BalloonWorkbench.core.pattern.shapes import closed_loop
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import from_mm, length_text

#: The print goes that far past the cut, unless told otherwise [m].
BLEED = ArtworkOptions.bleed
_MOST_BLEED = from_mm(50.0)
#: A mark is a cross in a circle: half the length of its lines, radius, and room to the print [m].
_ARM, _RADIUS, _ROOM = from_mm(5.0), from_mm(2.5), from_mm(3.0)


def bordered(pattern: Pattern, bleed: float = BLEED) -> Pattern:
    """The pattern with the border of its print (PRINT), so far past the cut [m], into holes too.

    InputError for a bleed that makes no sense.
    """
    if not 0.0 <= bleed <= _MOST_BLEED:
        raise InputError(f"The bleed must be from 0 to {length_text(_MOST_BLEED)}, not {length_text(bleed)}.")
    package = shapely()
    films = [package.Polygon(cut.points) for cut in pattern.of(Role.CUT)]
    holes = [package.Polygon(cut.points) for cut in pattern.of(Role.CUT_INNER) if not cut.front]
    area = package.union_all(films)
    if holes:
        area = area.difference(package.union_all(holes))
    printed = [
        Contour(Role.PRINT, closed_loop(ring, outer), True)
        for piece in parts(area.buffer(bleed, quad_segs=8))
        for outer, rings in ((True, [piece.exterior]), (False, piece.interiors))
        for ring in rings
    ]
    return replace(pattern, contours=(*printed, *pattern.contours))


def marked(sheet: Pattern) -> Pattern:
    """The sheet with three marks round it (REGISTRATION).

    At three corners: neither a turned nor a mirrored sheet fits them.
    """
    low, high = sheet.bounds
    away = _ARM + _ROOM
    (left, bottom), (right, top) = low - away, high + away
    corners = ((left, bottom), (right, bottom), (left, top))
    marks = [contour for x, y in corners for contour in _mark(np.array([x, y]))]
    return replace(sheet, contours=(*marks, *sheet.contours))


def _mark(at: Floats) -> list[Contour]:
    circle = at + _RADIUS * direction(2.0 * np.pi * np.arange(48) / 48)
    lines = [np.array([at - arm, at + arm]) for arm in ((_ARM, 0.0), (0.0, _ARM))]
    return [
        *(Contour(Role.REGISTRATION, line, False) for line in lines),
        Contour(Role.REGISTRATION, circle, True),
    ]

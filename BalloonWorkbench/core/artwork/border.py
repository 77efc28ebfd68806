# SPDX-License-Identifier: LGPL-2.1-or-later
"""What artwork adds to the pattern: the border of the print."""

from __future__ import annotations

from dataclasses import replace

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.areas import parts
from BalloonWorkbench.core.options.making import ArtworkOptions
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role
from BalloonWorkbench.core.pattern.shapes import closed_loop
from BalloonWorkbench.core.units import from_mm, length_text

#: The print goes that far past the cut, unless told otherwise [m].
BLEED = ArtworkOptions.bleed
_MOST_BLEED = from_mm(50.0)


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

# SPDX-License-Identifier: LGPL-2.1-or-later
"""A seam without the scatter that a correction leaves: as few arcs as pass a tenth of a millimetre beside it.

What is offset from arcs is arcs again, so weld and cut take hardly more of them than the seam.

How many arcs a smooth curve takes goes with the cube root of the tolerance (Meek and Walton, Approximating
smooth planar curves by arc splines, J. Comput. Appl. Math. 59, 1995, 221-231). A loop that takes far fewer
when it may be passed farther away is scattered; every other stays exactly as it is.
"""

from __future__ import annotations

from dataclasses import replace

from BalloonWorkbench.core.arcs.fit_arcs import TOLERANCE, fit_curve
from BalloonWorkbench.core.geometry.nearest import nearest_places
from BalloonWorkbench.core.geometry.polyline import extent
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import from_mm

#: How far the line may move: less than a cut is exact [m]; a small balloon's only by a part of its size.
LIMIT = from_mm(0.1)
_PART = 1.0 / 3000.0
#: A loop is scattered when it takes fewer arcs than that share of what a smooth one would.
_SCATTERED = 0.9
#: How far the points may lie apart: their chords are so near to the arcs [m].
_CHORD = from_mm(0.002)


def faired_seam(seam: Outline) -> Outline:
    """A seam with its loops faired; welds and spots as they are."""
    return replace(seam, outer=faired(seam.outer), holes=tuple(map(faired, seam.holes)))


def faired_points(loop: Floats) -> Floats:
    """The points of a loop (n, 2) m, each where it comes to lie on the faired one."""
    line = faired(loop)
    return loop if line is loop else nearest_places([line], loop)


def faired(loop: Floats) -> Floats:
    """The loop (n, 2) m as points of few arcs no farther than LIMIT from it, or itself where it is smooth.

    Corners and straight edges stay where they are. Where sides of a narrow tip would cross, it moves less.
    """
    limit = min(LIMIT, _PART * extent(loop))
    plain = len(fit_curve(loop, True))
    for share in (1.0, 0.4):
        tolerance = share * limit
        if tolerance <= TOLERANCE:
            break
        curve = fit_curve(loop, True, tolerance)
        if len(curve) > _SCATTERED * plain * (TOLERANCE / tolerance) ** (1.0 / 3.0):
            break
        moved = curve.flattened(_CHORD)
        if shapely().Polygon(moved).is_valid:
            return moved
    return loop

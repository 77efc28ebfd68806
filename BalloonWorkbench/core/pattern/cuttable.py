# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a blade or a beam can cut: no gap and no notch narrower than it can follow.

Between two edges of the cut there is a strip of waste at least twice LEAST_RADIUS wide; where they come
nearer, between two arms or towards the apex of a notch, the film goes on. A notch ends in a round of that
radius, where a tear would begin at a point. Outer corners stay sharp: there the tool runs straight on, and a
round would take film away that the weld below it needs. The weld keeps all its corners, so what is seen of
the drawing does not change.

This is the closing of the film by a disc (Serra, Image Analysis and Mathematical Morphology, 1982), for holes
the opening; both leave everything else as it is.
"""

from __future__ import annotations

from typing import Any

from BalloonWorkbench.core.geometry.areas import parts
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.pattern.shapes import TOLERANCE
from BalloonWorkbench.core.units import from_mm

#: Of notches in the cut; the narrowest gap is twice as wide [m].
LEAST_RADIUS = from_mm(0.5)
_EXACT = from_mm(0.02)
_SHARPEST = 100.0  # mitre limit: corners down to a degree keep their points
_STEPS = 8  # of a quarter circle: 0.0024 mm off at LEAST_RADIUS


def closed_gaps(film: Any, radius: float = LEAST_RADIUS) -> Any:
    """A polygon of shapely with film in the gaps narrower than two radii [m], notches rounded.

    A bay whose mouth closes leaves a hole.
    """
    grown = film.buffer(radius, join_style="mitre", mitre_limit=_SHARPEST)
    added = _sizeable(grown.buffer(-radius, quad_segs=_STEPS).difference(film))
    if not added:
        return film
    return max(parts(film.union(_wider(added))), key=lambda piece: float(piece.area))


def opened_hole(hole: Any, radius: float = LEAST_RADIUS) -> list[Any]:
    """What a hole of the film, a polygon of shapely, keeps when the film closes: none or some polygons."""
    shrunk = hole.buffer(-radius, join_style="mitre", mitre_limit=_SHARPEST)
    remaining = shrunk.buffer(radius, quad_segs=_STEPS)
    lost = _sizeable(hole.difference(remaining))
    return parts(hole.difference(_wider(lost))) if lost else [hole]


def _wider(pieces: list[Any]) -> Any:
    """All pieces a hair wider, so that no crack stays beside them where they are joined or taken off."""
    hair = 1e-3 * TOLERANCE
    return shapely().union_all([piece.buffer(hair, join_style="mitre") for piece in pieces])


def _sizeable(pieces: Any) -> list[Any]:
    """The pieces that are thicker than a tool is exact; blunt notches have no others."""
    return [piece for piece in parts(pieces) if not piece.buffer(-0.5 * _EXACT).is_empty]

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The edges of a panel: weld and cut round its film and in its holes."""

from __future__ import annotations

from typing import Any

import numpy as np

from BalloonWorkbench.core.geometry.areas import parts
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.pattern.cuttable import closed_gaps, opened_hole
from BalloonWorkbench.core.pattern.pattern import Contour, Role
from BalloonWorkbench.core.pattern.shapes import SHORTEST, closed_loop, offset, open_line, relieved
from BalloonWorkbench.core.units import length_text, place_text


def outer_edges(
    whole: Any, mouths: list[Any], seal_width: float, allowance: float, corner_radius: float
) -> list[Contour]:
    """Weld and cut round the balloon. Where the weld closes a bay of the outline, the rest of the bay is cut
    out like a hole.
    """
    sealed = _largest(offset(whole, 0.5 * seal_width))
    # from the weld, also round its tips
    cut = _largest(offset(sealed, seal_width + allowance - 0.5 * seal_width))
    cut = relieved(closed_gaps(cut), sealed.boundary, 0.5 * seal_width, corner_radius)
    bays = ((Role.SEAL, sealed.interiors), (Role.CUT_INNER, cut.interiors))
    inner = [
        Contour(role, closed_loop(ring, False), True) for role, rings in bays for ring in _sizeable(rings)
    ]
    seals = _outer_seal(sealed, mouths)
    for mouth in mouths:
        cut = _largest(cut.difference(mouth))
    return [*inner, *seals, Contour(Role.CUT, closed_loop(cut.exterior, True), True)]


def hole_edges(
    hole: Any, seal_width: float, margin: float, corner_radius: float, warnings: list[str]
) -> list[Contour]:
    """Weld and cut of a hole, as far as it has room for them."""
    welds = parts(offset(hole, -0.5 * seal_width))
    walls = shapely().union_all([weld.exterior for weld in welds])
    wells = [well for piece in parts(offset(hole, -margin)) for well in opened_hole(piece)]
    cuts = [relieved(well, walls, 0.5 * seal_width, corner_radius) for well in wells]
    middle = np.asarray(hole.centroid.coords[0])
    radius = float(shapely().maximum_inscribed_circle(hole).length)
    if not welds:
        # The nearest line that is still inside the hole; the weld then reaches into the balloon a little.
        welds = parts(offset(hole, -0.5 * radius))
        warnings.append(
            f"The hole at {place_text(middle)} is too small for a {length_text(seal_width)} seal, and its"
            " weld"
            f" reaches {length_text(0.5 * (seal_width - radius))} into the balloon: make the hole at least"
            f" {length_text(2.0 * margin)} wide, or the seal narrower."
        )
    elif not cuts:
        warnings.append(
            f"The hole at {place_text(middle)} is welded but not cut out: for that, make it wider than two"
            f" seals with their allowances, {length_text(2.0 * margin)}."
        )
    return [
        Contour(role, closed_loop(piece.exterior, False), True)
        for role, pieces in ((Role.SEAL, welds), (Role.CUT_INNER, cuts))
        for piece in pieces
        if _sizeable([piece.exterior])
    ]


def _outer_seal(sealed: Any, mouths: list[Any]) -> list[Contour]:
    """The weld round the balloon, open at the mouths of its necks."""
    if not mouths:
        return [Contour(Role.SEAL, closed_loop(sealed.exterior, True), True)]
    package = shapely()
    line = package.line_merge(sealed.exterior.difference(package.union_all(mouths)))
    pieces = sorted(package.get_parts(line), key=lambda piece: -piece.length)[: len(mouths)]
    return [Contour(Role.SEAL, open_line(piece), False) for piece in pieces]


def _largest(area: Any) -> Any:
    return parts(area)[0]


def _sizeable(rings: Any) -> list[Any]:
    """Rings that are more than a rounding error."""
    return [ring for ring in rings if shapely().Polygon(ring).area > SHORTEST * ring.length]

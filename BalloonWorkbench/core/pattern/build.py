# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the seam of a panel to what is cut and welded.

Outward from the seam, which is the inner edge of the weld:
    seam + seal width / 2              SEAL, the middle of the weld
    seam + seal width + allowance      CUT; so the film ends half a seal width and the allowance past SEAL
Holes the same way, into the hole. Welds inside the balloon lie where the panel has them:
    WELD, the line along which the films stay together, closed round a spot
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.pattern.fairing import faired
from BalloonWorkbench.core.pattern.intake import Neck, place_neck
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role
from BalloonWorkbench.core.pattern.shapes import (
    SHORTEST,
    closed_loop,
    offset,
    open_line,
    parts,
    polygon,
)
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import mm_text, to_mm


def build_pattern(
    seam: Outline,
    seal_width: float,
    *,
    allowance: float = 0.002,
    intake_width: float = 0.010,
    intake_length: float | None = None,
    intake_angle: float | None = None,
    intake: bool = True,
) -> Pattern:
    """The pattern of a panel whose free film is bounded by `seam` [m], faired within 0.05 mm.

    seal_width    of the weld [m]
    allowance     film left outside the weld [m]
    intake_width  of the air path between the welds [m]; it points from the pattern's centre of area to the
                  farthest point of the seam, or along intake_angle [rad], and is intake_length [m] long
    Raises InputError for senseless values, OutlineError where the seam crosses itself.
    """
    if not (np.isfinite(seal_width) and seal_width > 0.0 and np.isfinite(allowance) and allowance >= 0.0):
        raise InputError("The seal width must be above 0 and the allowance not below 0.")
    margin = seal_width + allowance
    seam = replace(seam, outer=faired(seam.outer), holes=tuple(faired(hole) for hole in seam.holes))
    whole, holes = polygon(seam.outer), [polygon(hole) for hole in seam.holes]
    warnings: list[str] = []
    neck = None
    if intake:
        film = whole.difference(shapely().unary_union(holes)) if holes else whole
        neck = place_neck(film, margin, intake_width, intake_length, intake_angle)
        whole = shapely().unary_union([whole, neck.area])
        if neck.narrow:
            warnings.append(
                f"The balloon is nowhere {mm_text(intake_width)} wide behind its intake: choose another"
                " intake angle or a narrower intake, else air enters slowly."
            )
    contours = [Contour(Role.WELD, open_line(shapely().LineString(weld)), False) for weld in seam.welds] + [
        Contour(Role.WELD, closed_loop(polygon(spot).exterior, False), True) for spot in seam.spots
    ]
    for hole in holes:
        contours += _inner(hole, seal_width, margin, warnings)
    # Where the weld closes a bay of the outline, the rest of the bay is cut out like a hole.
    sealed, cut = _largest(offset(whole, 0.5 * seal_width)), _largest(offset(whole, margin))
    contours += [Contour(Role.SEAL, closed_loop(ring, False), True) for ring in _sizeable(sealed.interiors)]
    contours += [Contour(Role.CUT_INNER, closed_loop(ring, False), True) for ring in _sizeable(cut.interiors)]
    contours.append(_outer_seal(sealed, neck))
    if neck is not None:
        cut = _largest(cut.difference(neck.beyond))
    contours.append(Contour(Role.CUT, closed_loop(cut.exterior, True), True))
    welds = [contour for contour in contours if contour.role is Role.SEAL]
    return Pattern(
        tuple(contours),
        None if neck is None else neck.intake,
        seal_width,
        sum(_length(weld.points, weld.closed) for weld in welds),
        tuple(warnings),
    )


def usual_pattern(seam: Outline, film: Film, intake: bool = True) -> Pattern:
    """The pattern as it is made unless told otherwise: for its weight. Without an intake that has no room."""
    try:
        return build_pattern(seam, film.seal_width, intake=intake)
    except InputError:
        if not intake:
            raise
        return build_pattern(seam, film.seal_width, intake=False)


def _inner(hole: Any, seal_width: float, margin: float, warnings: list[str]) -> list[Contour]:
    """Weld and cut of a hole, as far as it has room for them."""
    welds = parts(offset(hole, -0.5 * seal_width))
    cuts = parts(offset(hole, -margin))
    x, y = to_mm(np.asarray(hole.centroid.coords[0]))
    radius = float(shapely().maximum_inscribed_circle(hole).length)
    if not welds:
        # The nearest line that is still inside the hole; the weld then reaches into the balloon a little.
        welds = parts(offset(hole, -0.5 * radius))
        warnings.append(
            f"The hole at ({x:.1f}, {y:.1f}) mm is too small for a {mm_text(seal_width)} seal, and its weld"
            f" reaches {mm_text(0.5 * (seal_width - radius))} into the balloon: make the hole at least"
            f" {mm_text(2.0 * margin)} wide, or the seal narrower."
        )
    elif not cuts:
        warnings.append(
            f"The hole at ({x:.1f}, {y:.1f}) mm is welded but not cut out: for that, make it wider than two"
            f" seals with their allowances, {mm_text(2.0 * margin)}."
        )
    return [
        Contour(role, closed_loop(piece.exterior, False), True)
        for role, pieces in ((Role.SEAL, welds), (Role.CUT_INNER, cuts))
        for piece in pieces
        if _sizeable([piece.exterior])
    ]


def _outer_seal(sealed: Any, neck: Neck | None) -> Contour:
    """The weld round the balloon, open at the mouth of the intake."""
    if neck is None:
        return Contour(Role.SEAL, closed_loop(sealed.exterior, True), True)
    line = sealed.exterior.difference(neck.beyond)
    if line.geom_type != "LineString":
        line = shapely().line_merge(line)
    longest = max(getattr(line, "geoms", [line]), key=lambda piece: piece.length)
    return Contour(Role.SEAL, open_line(longest), False)


def _largest(area: Any) -> Any:
    return parts(area)[0]


def _sizeable(rings: Any) -> list[Any]:
    """Rings that are more than a rounding error."""
    return [ring for ring in rings if shapely().Polygon(ring).area > SHORTEST * ring.length]


def _length(points: Floats, closed: bool) -> float:
    steps = np.diff(np.concatenate([points, points[:1]]) if closed else points, axis=0)
    return float(np.linalg.norm(steps, axis=1).sum())

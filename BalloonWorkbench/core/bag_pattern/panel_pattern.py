# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a flat panel of a bag to what is cut and welded: as for two panels, but no seam is faired.

Both sides of a seam stay as long as they were simulated. Where the panel beside is not cut, the end stays
open: there is no weld.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from BalloonWorkbench.core.bag_pattern.marks import (
    MarkedSide,
    end_lines,
    grain_line,
    notches,
    numbers_and_arrows,
)
from BalloonWorkbench.core.bags.bag import BagPanel
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.areas import parts
from BalloonWorkbench.core.geometry.polyline import length
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.pattern.build import intake_remarks
from BalloonWorkbench.core.pattern.edges import hole_edges, outer_edges
from BalloonWorkbench.core.pattern.intake.neck import Neck
from BalloonWorkbench.core.pattern.intake.places import film_of
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role
from BalloonWorkbench.core.pattern.shapes import TOLERANCE, offset, open_line, polygon
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import length_text, place_text


def panel_edges(
    panel: BagPanel,
    necks: Sequence[Neck],
    left_open: Sequence[Floats],
    options: PatternOptions,
    seal_width: float,
) -> Pattern:
    """Weld and cut of a panel, with its intakes, without marks.

    left_open  lines (k, 2) m of its boundary along which it is not welded
    Raises InputError where a loop crosses itself or a corner relief is too large.
    """
    allowance, radius = options.allowance, options.corner_radius
    warnings: list[str] = []
    try:
        film = film_of(Outline(panel.outer, panel.holes))
        whole, holes = polygon(panel.outer), [polygon(hole) for hole in panel.holes]
        if not film.buffer(-TOLERANCE).area > 0.0:
            raise InputError("it is thinner than any film. Make it wider.")
        _warn_of_bays(whole, seal_width, warnings)
        whole = shapely().unary_union([whole, *(neck.area for neck in necks if neck.area is not None)])
        warnings += intake_remarks(list(necks), film.union(whole), seal_width)
        contours = [line for neck in necks for line in neck.lines]
        for hole in holes:
            contours += hole_edges(hole, seal_width, seal_width + allowance, radius, warnings)
        mouths = [neck.beyond for neck in necks if neck.beyond is not None]
        contours += outer_edges(whole, mouths, seal_width, allowance, radius)
    except InputError as error:
        raise type(error)(f"Panel {panel.name}: {error}") from error
    contours = _unsealed(contours, left_open, seal_width)
    intakes = [neck.intake for neck in necks]
    return Pattern(
        tuple(contours),
        intakes[0] if intakes else None,
        seal_width,
        sum(length(contour.line) for contour in contours if contour.role is Role.SEAL),
        tuple(f"Panel {panel.name}: {warning}" for warning in warnings),
    )


def seam_marks_on(
    panel: BagPanel,
    pattern: Pattern,
    sides: Sequence[MarkedSide],
    options: PatternOptions,
    grain: float | None,
) -> tuple[list[Contour], list[int]]:
    """What is drawn and cut on a panel so that its edges find their partners.

    grain  direction of the film's grain [rad], None without one
    And the numbers of the seams for which there is no room.
    """
    package = shapely()
    film = film_of(Outline(panel.outer, panel.holes))
    fittings = [polygon(line.points) for line in pattern.contours if line.front and line.closed]
    film = film.difference(package.unary_union(fittings))
    edges = package.MultiLineString(
        [cut.line for role in (Role.CUT, Role.CUT_INNER) for cut in pattern.of(role)]
    )
    drawn, left_out = numbers_and_arrows(sides, film)
    drawn += [] if grain is None else grain_line(film, drawn, grain)
    welds = package.MultiLineString([seal.line for seal in pattern.of(Role.SEAL)])
    cuts = [
        notch
        for side in sides
        for notch in notches(side, edges, options.notch_depth, options.allowance, options.notches)
        if package.LineString(notch.points).distance(welds) > 0.5 * pattern.seal_width - TOLERANCE
    ]
    ends = end_lines(panel.loops, {end for side in sides for end in side.ends}, pattern.seal_width)
    return [*drawn, *ends, *cuts], left_out


def _unsealed(contours: list[Contour], left_open: Sequence[Floats], seal_width: float) -> list[Contour]:
    """The contours without welds along lines of the boundary."""
    if not left_open:
        return contours
    package = shapely()
    beside = package.union_all(
        [package.LineString(line).buffer(0.6 * seal_width, cap_style="flat") for line in left_open]
    )
    kept = []
    for contour in contours:
        line = package.LineString(contour.line) if contour.role is Role.SEAL else None
        if line is None or not line.intersects(beside):
            kept.append(contour)
            continue
        rest = line.difference(beside)
        merged = package.line_merge(rest) if rest.geom_type == "MultiLineString" else rest
        pieces = [piece for piece in package.get_parts(merged) if piece.length > seal_width]
        kept += [Contour(Role.SEAL, open_line(piece), False) for piece in pieces]
    return kept


def _warn_of_bays(whole: Any, seal_width: float, warnings: list[str]) -> None:
    """Where two edges of a panel face each other outside the film, closer than their welds."""
    grown = offset(whole, 0.5 * seal_width)
    back = offset(grown, -0.5 * seal_width)
    for bay in parts(back.difference(whole)):
        if bay.area > (0.2 * seal_width) ** 2:
            at = bay.representative_point()
            warnings.append(
                f"near {place_text(shapely().get_coordinates(at)[0])} two of its edges are closer than"
                f" {length_text(seal_width)}, and their welds run into each other: make the balloon larger or"
                " the seal narrower."
            )
            return

# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the seam of a panel to what is cut and welded.

Outward from the seam, which is the inner edge of the weld:
    seam + seal width / 2              SEAL, the middle of the weld
    seam + seal width + allowance      CUT; so the film ends half a seal width and the allowance past SEAL
Holes the same way, into the hole. Welds inside the balloon lie where the panel has them:
    WELD, the line along which the films stay together, closed round a spot
"""

from __future__ import annotations

from typing import Any

from BalloonWorkbench.core.design.fairing import faired_seam
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.geometry.polyline import length
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.outline.chambers import joined_welds
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.pattern.edges import hole_edges, outer_edges
from BalloonWorkbench.core.pattern.intake.neck import Neck, place_neck
from BalloonWorkbench.core.pattern.intake.places import Wish, film_of, intake_of, wishes
from BalloonWorkbench.core.pattern.intake.rim import Rim
from BalloonWorkbench.core.pattern.intake.valve import closed_channel
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role
from BalloonWorkbench.core.pattern.shapes import closed_loop, open_line, polygon
from BalloonWorkbench.core.units import length_text


def build_pattern(
    seam: Outline, seal_width: float, options: PatternOptions | None = None, fair: bool = True
) -> Pattern:
    """The pattern of a panel whose free film is bounded by `seam` [m], without its scatter (`faired`), and
    without tie tab, label and notches, second panel and copies.

    seal_width  of the film's weld [m], where the options have no other
    fair        False keeps the scatter of the seam, which takes most of the time to find: for a quick look
    Each chamber that the welds cut off gets an intake, where the options have one. It points from the
    pattern's centre of area to the farthest point of the seam, or sits low on the balloon, or points along
    intake_angle, or sits at intake_along on the seam, counter-clockwise from its rightmost point.
    Raises InputError for senseless values, OutlineError where the seam crosses itself.
    """
    options = options or PatternOptions()
    seal_width = seal_width if options.seal_width is None else options.seal_width
    allowance = options.allowance
    if not (1e-5 <= seal_width <= 1.0 and 0.0 <= allowance <= 1.0):
        raise InputError("The seal width must be between 0.01 mm and 1 m, the allowance between 0 and 1 m.")
    seam = faired_seam(seam) if fair else seam
    whole, holes = polygon(seam.outer), [polygon(hole) for hole in seam.holes]
    warnings: list[str] = []
    necks: list[Neck] = []
    if options.intake:
        necks = _necks(seam, film_of(seam), intake_of(options), seal_width, allowance)
        whole = shapely().unary_union([whole, *(neck.area for neck in necks if neck.area is not None)])
        warnings += intake_remarks(necks, _between_welds(whole, holes, seam, seal_width), seal_width)
    contours = [*_welds_inside(seam, seal_width), *(line for neck in necks for line in neck.lines)]
    for hole in holes:
        contours += hole_edges(hole, seal_width, seal_width + allowance, options.corner_radius, warnings)
    mouths = [neck.beyond for neck in necks if neck.beyond is not None]
    contours += outer_edges(whole, mouths, seal_width, allowance, options.corner_radius)
    welds = [contour for contour in contours if contour.role is Role.SEAL]
    intakes = [neck.intake for neck in necks]
    return Pattern(
        tuple(contours),
        intakes[0] if intakes else None,
        seal_width,
        sum(length(weld.line) for weld in welds),
        tuple(warnings),
        tuple(intakes[1:]),
    )


def _welds_inside(seam: Outline, seal_width: float) -> list[Contour]:
    """Lines and spots; lines that reach the rim end in the middle of the weld round it."""
    lines = [open_line(shapely().LineString(weld)) for weld in joined_welds(seam, 0.5 * seal_width)]
    spots = [closed_loop(polygon(spot).exterior, False) for spot in seam.spots]
    return [
        *(Contour(Role.WELD, line, False) for line in lines),
        *(Contour(Role.WELD, spot, True) for spot in spots),
    ]


def intake_remarks(necks: list[Neck], free: Any, seal_width: float) -> list[str]:
    """What is to be said of the intakes, in the free film."""
    closed = [closed_channel(neck.intake, free, seal_width) for neck in necks]
    narrow = [_advice(neck) for neck in necks if neck.way is not None]
    return [*narrow, *(text for text in closed if text is not None)]


def default_pattern(seam: Outline, film: Film, intake: bool = True) -> Pattern:
    """The pattern as it is made unless told otherwise: for its weight. Without an intake that has no room."""
    try:
        return build_pattern(seam, film.seal_width, PatternOptions(intake=intake))
    except InputError:
        if not intake:
            raise
        return build_pattern(seam, film.seal_width, PatternOptions(intake=False))


def _necks(seam: Outline, film: Any, wish: Wish, seal_width: float, allowance: float) -> list[Neck]:
    """An intake for each chamber; what is wished of the place holds for the chamber that is nearest to it."""
    rim = Rim(seam.outer)
    necks = [
        place_neck(film, room, rim, each, seal_width, allowance)
        for room, each in wishes(seam, film, rim, wish, seal_width + allowance)
    ]
    areas = [neck.area for neck in necks if neck.area is not None]
    for k, area in enumerate(areas):
        if any(area.distance(other) < 2.0 * (seal_width + allowance) for other in areas[:k]):
            raise InputError(
                "The intakes of two chambers run into each other: leave a gap in the weld between them, or"
                " choose another place for the first."
            )
    return necks


def _between_welds(whole: Any, holes: list[Any], seam: Outline, seal_width: float) -> Any:
    """The film that no weld touches, as an area of shapely."""
    package = shapely()
    inside = [package.LineString(weld).buffer(0.5 * seal_width) for weld in seam.welds]
    spots = [polygon(spot) for spot in seam.spots]
    return whole.difference(package.union_all([*holes, *inside, *spots]))


def _advice(neck: Neck) -> str:
    """What to do about an intake into a narrow place."""
    width = length_text(neck.intake.width)
    if neck.way == 0.0:
        return (
            f"The balloon is nowhere {width} wide behind its intake: choose another intake angle or a"
            " narrower intake, else air enters slowly."
        )
    return (
        f"The way from the intake into the balloon narrows to {length_text(neck.way or 0.0)}, and the"
        " intake is"
        f" {width} wide: put it where the balloon is wider, else air enters slowly."
    )

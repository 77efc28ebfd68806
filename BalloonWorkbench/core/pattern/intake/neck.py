# SPDX-License-Identifier: LGPL-2.1-or-later
"""The air intake: where it sits, and the film that it adds."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.areas import parts
from BalloonWorkbench.core.geometry.vectors import perpendicular
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.pattern.intake.kinds import FILM, placed
from BalloonWorkbench.core.pattern.intake.places import Wish, before_mouth, place_of, rectangle
from BalloonWorkbench.core.pattern.intake.rim import Rim
from BalloonWorkbench.core.pattern.pattern import Contour, Intake
from BalloonWorkbench.core.pattern.shapes import offset
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import from_mm, length_text

#: Film left between a nozzle's flange and the weld [m].
_BESIDE_FLANGE = from_mm(3.0)


@dataclass(frozen=True)
class Neck:
    """An intake as areas of shapely.

    area   the film between the welds, from within the balloon to beyond the mouth; None for a nozzle
    beyond everything past the mouth
    way    width of the narrowest place on the way into the chamber [m], None where air enters freely
    lines  the lines of its kind, in place
    """

    intake: Intake
    area: Any
    beyond: Any
    way: float | None
    lines: tuple[Contour, ...]


def place_neck(film: Any, chamber: Any, rim: Rim, wish: Wish, seal_width: float, allowance: float) -> Neck:
    """The intake of a chamber of a film, both polygons (holes included); the rim is the film's.

    seal_width, allowance [m]. A length that is not given is 30 mm and three widths at least, more where the
    neck leaves aslant. Raises InputError for senseless values and where there is no room.
    """
    width, margin = wish.width, seal_width + allowance
    if not (1e-5 <= width <= 10.0):
        raise InputError("The intake's width must be between 0.01 mm and 10 m: give it about 10 mm.")
    sizes = {"W": width, "S": seal_width, "A": allowance}
    length = wish.length if wish.length is not None else wish.kind.default_length(sizes)
    at, direction = place_of(film, chamber, rim, wish, margin)
    turn = float(np.arctan2(direction[1], direction[0]))
    if wish.kind.place == FILM:
        return _fitting(chamber, rim, wish, at, turn, length, sizes)
    least = margin + 0.5 * width
    lengths = max(from_mm(30.0), 3.0 * width, least) * np.array([1.0, 1.4, 2.0, 2.8, 4.0])
    if length is not None:
        lengths = np.array([length])
    if not ((lengths > 0.0) & (lengths <= 100.0)).all():
        raise InputError("The intake's length must be above 0, up to 100 m: give it about 30 mm.")
    if lengths[0] < least:
        raise InputError(
            f"An intake of {length_text(lengths[0])} does not reach past the cut:"
            f" give it at least {length_text(least)}."
        )
    chosen = _free_length(film, at, direction, lengths.tolist(), width, margin)
    start = _roomy(chamber, at, width)
    beyond = before_mouth(at, direction, chosen, width, margin)
    area = _air(at if start is None else start, at, direction, chosen, margin, width, wish.kind.taper)
    return Neck(
        Intake(at, turn, width, chosen, rim.nearest(at), wish.kind.name),
        area,
        beyond,
        0.0 if start is None else _narrow_way(chamber, start, width),
        _lines(wish, at, turn, {**sizes, "L": chosen}),
    )


def _fitting(
    chamber: Any, rim: Rim, wish: Wish, at: Floats, turn: float, flange: float | None, sizes: dict[str, float]
) -> Neck:
    """A nozzle, as near to the rim as its flange has room."""
    if flange is None or not wish.width < flange < np.inf:
        raise InputError("The nozzle's flange must be wider than its bore.")
    middle = _roomy(chamber, at, flange + 2.0 * _BESIDE_FLANGE)
    if middle is None:
        raise InputError(
            f"There is no room for a flange of {length_text(flange)} there: choose another place or a smaller"
            " one."
        )
    return _fitting_at(chamber, rim, wish, (at, middle, turn), flange, sizes)


def fitting_in_middle(film: Any, rim: Rim, wish: Wish, seal_width: float, allowance: float) -> Neck:
    """A nozzle where a film, an area of shapely, has most room; arguments and errors as of `place_neck`."""
    sizes = {"W": wish.width, "S": seal_width, "A": allowance}
    flange = wish.length if wish.length is not None else wish.kind.default_length(sizes)
    if flange is None or not 1e-5 <= wish.width < flange < np.inf:
        raise InputError("The nozzle's flange must be wider than its bore.")
    circle = shapely().maximum_inscribed_circle(film)
    middle = np.asarray(circle.coords[0])
    if 2.0 * float(circle.length) < flange + 2.0 * _BESIDE_FLANGE + seal_width:
        raise InputError(
            f"There is no room for a flange of {length_text(flange)} in its middle: choose another panel or a"
            " smaller one."
        )
    return _fitting_at(film, rim, wish, (middle, middle, 0.0), flange, sizes)


def _fitting_at(
    chamber: Any,
    rim: Rim,
    wish: Wish,
    place: tuple[Floats, Floats, float],
    flange: float,
    sizes: dict[str, float],
) -> Neck:
    """A nozzle at a place: what it belongs to on the rim, its middle (2,), its direction [rad]."""
    at, middle, turn = place
    intake = Intake(middle, turn, wish.width, flange, rim.nearest(at), wish.kind.name)
    lines = tuple(replace(line, front=True) for line in _lines(wish, middle, turn, {**sizes, "L": flange}))
    return Neck(intake, None, None, _narrow_way(chamber, middle, wish.width), lines)


def _lines(wish: Wish, at: Floats, turn: float, sizes: dict[str, float]) -> tuple[Contour, ...]:
    return tuple(placed(stroke.drawn(sizes), at, turn) for stroke in wish.kind.strokes)


def _air(
    start: Floats, at: Floats, direction: Floats, length: float, margin: float, width: float, taper: float
) -> Any:
    """The film between the welds of a neck, from `start` in the balloon to past its mouth."""
    package = shapely()
    past = length + 2.0 * margin
    if taper == 1.0:
        return package.LineString([start, at, at + past * direction]).buffer(0.5 * width, quad_segs=16)
    inner = package.LineString([start, at]) if not np.array_equal(start, at) else package.Point(at)
    side = perpendicular(direction)
    end = 0.5 * width * (1.0 - (1.0 - taper) * past / length)
    far = at + past * direction
    tail = package.Polygon(
        [at - 0.5 * width * side, far - end * side, far + end * side, at + 0.5 * width * side]
    )
    return package.unary_union([inner.buffer(0.5 * width, quad_segs=16), tail])


def _narrow_way(chamber: Any, start: Floats, width: float) -> float | None:
    """Width of the narrowest place between a place and the roomiest one [m]; None if not below `width`."""
    package = shapely()
    begin, middle = package.Point(start), package.Point(package.maximum_inscribed_circle(chamber).coords[0])

    def passes(wide: float) -> bool:
        rooms = parts(chamber.buffer(-0.5 * wide))
        reached = [room for room in rooms if room.distance(begin) < 0.05 * wide]
        return any(room.distance(middle) < 0.05 * wide for room in reached)

    if passes(0.99 * width):
        return None
    low, high = 0.0, width
    for _ in range(6):
        tried = 0.5 * (low + high)
        low, high = (tried, high) if passes(tried) else (low, tried)
    return low


def _roomy(film: Any, at: Floats, width: float) -> Floats | None:
    """The nearest place straight inside from `at` where a disc of the intake's width fits into the film."""
    package = shapely()
    fitting = package.segmentize(film.buffer(-0.5 * width).boundary, 0.1 * width)
    places = package.get_coordinates(fitting)
    if not len(places):
        return None
    nearest = places[np.argsort(np.linalg.norm(places - at, axis=1), kind="stable")]
    sight = package.linestrings(np.stack([np.broadcast_to(at, nearest.shape), nearest], axis=1))
    inside = film.buffer(1e-3 * width)  # the line starts on the rim
    package.prepare(inside)
    seen = np.flatnonzero(package.covers(inside, sight))
    return nearest[seen[0]] if len(seen) else None


def _free_length(
    film: Any, at: Floats, direction: Floats, lengths: list[float], width: float, margin: float
) -> float:
    """The first length at which the neck meets the film at its root only and ends outside all that is cut."""
    cut = offset(film, margin)
    beside = width + margin  # closer than that, two welds become one
    root = rectangle(at, direction, -1e-6 * width, 1e-6 * width, beside)
    for length in lengths:
        strip = rectangle(at, direction, 0.0, length, beside)
        pieces = shapely().get_parts(film.intersection(strip))
        stray = any(piece.area > 1e-9 * strip.area and not piece.intersects(root) for piece in pieces)
        if not stray and not cut.intersects(before_mouth(at, direction, length, width, margin)):
            return length
    raise InputError(
        "The intake would run into another part of the balloon: choose another angle or length for it."
    )

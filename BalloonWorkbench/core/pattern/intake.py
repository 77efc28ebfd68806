# SPDX-License-Identifier: LGPL-2.1-or-later
"""The air intake: where it sits, and the film that it adds."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.pattern.pattern import Intake
from BalloonWorkbench.core.pattern.shapes import offset
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import from_mm, mm_text

#: Farthest points within this share of each other count as equally far; the lowest is taken.
_EQUALLY_FAR = 1e-3


@dataclass(frozen=True)
class Neck:
    """An intake as areas of shapely.

    area   the film between the welds, from within the balloon to beyond the mouth
    beyond everything past the mouth
    narrow the balloon is narrower than the intake where they meet
    """

    intake: Intake
    area: Any
    beyond: Any
    narrow: bool


def place_neck(film: Any, margin: float, width: float, length: float | None, angle: float | None) -> Neck:
    """The neck of a balloon whose film is a polygon (holes included).

    margin  from the seam to the cut [m]
    width   between the welds [m]
    length  from the seam outward [m]; by default 30 mm and three widths at least, more where it leaves aslant
    angle   direction [rad]; by default from the centre of area to the farthest point of the outline
    """
    least = margin + 0.5 * width
    lengths = max(from_mm(30.0), 3.0 * width, least) * np.array([1.0, 1.4, 2.0, 2.8, 4.0])
    if length is not None:
        lengths = np.array([length])
    if not (np.isfinite(width) and width > 0.0 and np.isfinite(lengths).all()):
        raise InputError("The intake's width and length must be above 0.")
    if lengths[0] < least:
        raise InputError(
            f"An intake of {mm_text(lengths[0])} does not reach past the cut:"
            f" give it at least {mm_text(least)}."
        )
    rim = np.asarray(film.exterior.coords, dtype=np.float64)[:-1]
    centre = np.asarray(film.centroid.coords[0])
    at, direction = _farthest(rim, centre) if angle is None else _hit(film, centre, angle)
    chosen = _free_length(film, at, direction, lengths.tolist(), width, margin)
    past = chosen + 2.0 * margin
    start = _roomy(film, at, width)
    path = [at if start is None else start, at, at + past * direction]
    turn = float(np.arctan2(direction[1], direction[0]))
    return Neck(
        Intake(at, turn, width, chosen),
        shapely().LineString(path).buffer(0.5 * width, quad_segs=16),
        _before_mouth(at, direction, chosen, width, margin),
        start is None,
    )


def _farthest(rim: Floats, centre: Floats) -> tuple[Floats, Floats]:
    away = np.linalg.norm(rim - centre, axis=1)
    far = np.flatnonzero(away > (1.0 - _EQUALLY_FAR) * away.max())
    lowest = np.lexsort((rim[far, 0], np.round(rim[far, 1] / away.max(), 6)))[0]
    at = rim[far[lowest]]
    return at, (at - centre) / away[far[lowest]]


def _hit(film: Any, centre: Floats, angle: float) -> tuple[Floats, Floats]:
    if not np.isfinite(angle):
        raise InputError("The intake's angle must be a number.")
    direction = np.array([np.cos(angle), np.sin(angle)])
    low_x, low_y, high_x, high_y = film.bounds
    reach = 2.0 * float(np.hypot(high_x - low_x, high_y - low_y))
    met = shapely().LineString([centre, centre + reach * direction]).intersection(film.exterior)
    points = shapely().get_coordinates(met)
    if not len(points):
        raise InputError(
            f"There is no outline at {np.degrees(angle):.0f} degrees from the centre:"
            " choose another intake angle."
        )
    return points[np.argmax((points - centre) @ direction)], direction


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
    root = _rectangle(at, direction, -1e-6 * width, 1e-6 * width, beside)
    for length in lengths:
        strip = _rectangle(at, direction, 0.0, length, beside)
        pieces = shapely().get_parts(film.intersection(strip))
        stray = any(piece.area > 1e-9 * strip.area and not piece.intersects(root) for piece in pieces)
        if not stray and not cut.intersects(_before_mouth(at, direction, length, width, margin)):
            return length
    raise InputError(
        "The intake would run into another part of the balloon: choose another angle or length for it."
    )


def _before_mouth(at: Floats, direction: Floats, length: float, width: float, margin: float) -> Any:
    """A little more than the neck's whole breadth, from the mouth onward."""
    return _rectangle(at, direction, length, length + 4.0 * margin + width, width + 2.2 * margin)


def _rectangle(at: Floats, direction: Floats, start: float, end: float, width: float) -> Any:
    side = 0.5 * width * np.array([-direction[1], direction[0]])
    near, far = at + start * direction, at + end * direction
    return shapely().Polygon([near - side, far - side, far + side, near + side])

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Chambers: the parts into which welds divide a balloon, and the ways left open between them."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.areas import parts
from BalloonWorkbench.core.geometry.polyline import line_lengths, part_of, point_on
from BalloonWorkbench.core.geometry.vectors import perpendicular, unit
from BalloonWorkbench.core.options.drawing import ReadingOptions
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import length_text, place_text

PASSAGE = ReadingOptions.passage
"""Usual width of a passage [m]."""
#: A weld that ends this near to a loop reaches it, and a thin wall; relative to the size.
_AT_RIM, _HAIR = 7e-3, 1e-6
#: A passage keeps so many of its widths from the ends of its weld and from everything else.
_CLEAR = 1.0
#: Chambers below this share of the film are rounding errors where a weld meets the rim.
_CHAMBER = 1e-4


def chambers(outline: Outline) -> list[Any]:
    """The parts between which the welds leave no way for air, as polygons of shapely, the largest first."""
    package = shapely()
    film = package.Polygon(outline.outer, [*outline.holes, *outline.spots])
    if not outline.welds:
        return [film]
    size = max(outline.size)
    rim = film.boundary
    walls = [package.LineString(to_rim(weld, rim, _AT_RIM * size, _HAIR * size)) for weld in outline.welds]
    rooms = parts(film.difference(package.union_all(walls).buffer(_HAIR * size)))
    return [room for room in rooms if room.area > _CHAMBER * film.area]


def linked(outline: Outline, width: float = PASSAGE) -> Outline:
    """The outline with a passage in the welds for each chamber that air would not reach, and a note for each.

    Each chamber gets one from a neighbour that is reached before it, the largest being the first, where the
    weld between them has most room. A chamber whose welds are too short for it stays as it is; so do all for
    a width of 0.
    """
    if not (np.isfinite(width) and width >= 0.0):
        raise InputError("The width of the passages must be 0 or above.")
    if width == 0.0 or not outline.welds:
        return outline
    notes = list(outline.notes)
    while True:
        rooms = chambers(outline)
        best = _best_passage(outline, rooms, width) if len(rooms) > 1 else None
        if best is None:
            return replace(outline, notes=tuple(notes))
        number, along = best
        weld = outline.welds[number]
        lengths = line_lengths(weld)
        middle = np.round(point_on(weld, lengths, np.array([along]))[0], 6) + 0.0
        pieces = [
            part_of(weld, 0.0, along - 0.5 * width),
            part_of(weld, along + 0.5 * width, float(lengths[-1])),
        ]
        welds = (*outline.welds[:number], *pieces, *outline.welds[number + 1 :])
        outline = replace(outline, welds=welds)
        notes.append(
            f"A passage of {length_text(width)} is left open in the weld at {place_text(middle)}, so that air"
            " reaches both sides."
        )


def _best_passage(outline: Outline, rooms: list[Any], width: float) -> tuple[int, float] | None:
    """The weld, and the place along it [m], of the roomiest passage between a chamber and a larger one."""
    package = shapely()
    size = max(outline.size)
    rim = package.Polygon(outline.outer, [*outline.holes, *outline.spots]).boundary
    best: tuple[float, float, int, float] | None = None
    for number, weld in enumerate(outline.welds):
        lengths = line_lengths(weld)
        clear = (0.5 + _CLEAR) * width
        if lengths[-1] < 2.0 * clear:
            continue
        count = max(3, int(np.ceil(4.0 * lengths[-1] / width)) | 1)
        places = np.linspace(clear, lengths[-1] - clear, count)
        points = point_on(weld, lengths, places)
        ahead = point_on(weld, lengths, places + 0.1 * width) - point_on(weld, lengths, places - 0.1 * width)
        side = unit(perpendicular(ahead))
        beside = [_room_at(rooms, points + sign * 1e-3 * size * side) for sign in (1.0, -1.0)]
        others = [package.LineString(other) for k, other in enumerate(outline.welds) if k != number]
        free = package.distance(package.union_all([rim, *others]), package.points(points))
        ends = np.minimum(places, lengths[-1] - places)
        room = np.minimum(free, ends)
        apart = (beside[0] != beside[1]) & (np.minimum(*beside) >= 0) & (free >= _CLEAR * width)
        for k in np.flatnonzero(apart):
            # the larger chambers first; then the roomiest place, of nearly equal ones the middle
            rank = (
                -float(min(beside[0][k], beside[1][k])),
                round(float(room[k]) / (0.2 * width)) + 1e-3 * float(ends[k]) / size,
            )
            if best is None or rank > best[:2]:
                best = *rank, number, float(places[k])
    return None if best is None else best[2:]


def _room_at(rooms: list[Any], points: Floats) -> Any:
    """The number (n,) of the chamber in which each point lies, -1 for none."""
    package = shapely()
    where = np.full(len(points), -1)
    for number, room in enumerate(rooms):
        where[package.contains_xy(room, points[:, 0], points[:, 1])] = number
    return where


def joined_welds(outline: Outline, past: float) -> list[Floats]:
    """The welds, those that begin at a loop drawn on past it by a length [m], as far as the weld round it."""
    rim = shapely().Polygon(outline.outer, [*outline.holes, *outline.spots]).boundary
    return [to_rim(weld, rim, _AT_RIM * max(outline.size), past) for weld in outline.welds]


def to_rim(weld: Floats, rim: Any, reach: float, past: float) -> Floats:
    """A weld with ends within `reach` of the rim drawn on to `past` it [m]."""
    package = shapely()
    line = weld
    for end in (0, -1):
        point = package.Point(line[end])
        if rim.distance(point) < reach:
            foot = np.asarray(package.shortest_line(rim, point).coords[0])
            ahead = foot - line[end]
            on = foot + past * ahead / max(float(np.hypot(*ahead)), 1e-12)
            line = np.concatenate([on[None], line]) if end == 0 else np.concatenate([line, on[None]])
    return line

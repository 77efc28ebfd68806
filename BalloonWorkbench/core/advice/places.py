# SPDX-License-Identifier: LGPL-2.1-or-later
"""The places of an outline that a rule may speak of: thin parts, notches and the area as a whole."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum
from typing import Any

import numpy as np

from BalloonWorkbench.core.advice.sections import Sections, chained, sections
from BalloonWorkbench.core.geometry.areas import parts
from BalloonWorkbench.core.geometry.normals import turns_at
from BalloonWorkbench.core.geometry.polyline import arc_lengths, length, point_at, ring
from BalloonWorkbench.core.geometry.vectors import turn
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.types import Floats

#: Shorter than this, in the width looked for, what a disc cannot reach is a rounded-off corner.
_SHORTEST = 0.5
#: A piece behind a neck that holds less of the area is the end of an arm.
LEAST_BEHIND = 0.03
#: A tip is so much narrower in its outer than in its inner half; an arm is not.
_TAPER = 0.72
#: Notches turn by more than this over the reach on both sides.
_NOTCH_TURN = np.radians(22.0)
NOTCH_REACH = 1.0 / 60.0  # of the size
_ARC = 24  # segments of a quarter circle


class PlaceKind(Enum):
    """What a thin part is."""

    ARM = "arm"  # leads to a free end, or is one of several ways
    NECK = "neck"  # everything behind it is filled through it
    TIP = "tip"  # narrows to a point


@dataclass(frozen=True)
class ThinPart:
    """A part of the film into which a disc of the width looked for does not fit.

    area      polygon of shapely
    sections  across it, at least one
    middle    (k, 2) m, its middle line; an arm's and a tip's begins at the free end
    length    m, of the middle line
    behind    part of the whole area on the smaller side of a neck
    """

    kind: PlaceKind
    area: Any
    sections: Sections
    middle: Floats
    length: float
    behind: float = 0.0

    @property
    def narrowest(self) -> tuple[Floats, Floats]:
        """The ends (2,) of its shortest section."""
        k = int(np.argmin(self.sections.widths))
        return self.sections.starts[k], self.sections.ends[k]


@dataclass(frozen=True)
class Notch:
    """A concave place of the rim.

    turn    by which the rim turns there [rad]
    radius  m, of the rim there, 0 for a corner
    """

    place: Floats
    turn: float
    radius: float
    extent: Floats


def whole(outline: Outline) -> Any:
    """The free film as a polygon of shapely."""
    return shapely().Polygon(outline.outer, list(outline.loops[1:])).buffer(0.0)


def thin_parts(outline: Outline, width: float) -> list[ThinPart]:
    """The parts narrower than `width` [m]: what is lost when the area is opened with a disc (Serra 1982)."""
    area = whole(outline)
    width = min(width, max(outline.size))  # wider discs see no more
    around = outline.perimeter
    across = sections(outline, max(width / 6.0, around / 4000.0))
    rooms = bodies(area, width)
    if not rooms:
        return [_part(PlaceKind.ARM, area, across, None)]
    slack = 0.01 * width
    left = area.difference(shapely().union_all(rooms).buffer(slack))
    thin = []
    for piece in parts(left):
        touched = [room for room in rooms if room.distance(piece) < 2.0 * slack]
        reach = max(_farthest(piece, body)[1] for body in touched) if touched else np.inf
        if len(touched) < 2 and reach < _SHORTEST * width:
            continue
        inside = across.of(_within(piece, across.middles))
        if not len(inside.widths):
            continue
        thin.append(_judged(area, piece, touched, inside, slack))
    return thin


def bodies(area: Any, width: float) -> list[Any]:
    """The parts of an area that a disc of a width reaches without leaving it."""
    cores = parts(area.buffer(-0.5 * width, quad_segs=_ARC))
    return [core.buffer(0.5 * width, quad_segs=_ARC) for core in cores]


def _judged(area: Any, piece: Any, touched: list[Any], inside: Sections, slack: float) -> ThinPart:
    if len(touched) > 1:
        rest = [part.area for part in parts(area.difference(piece.buffer(2.0 * slack)))]
        behind = sorted(rest)[-2] / area.area if len(rest) > 1 else 0.0
        if behind > LEAST_BEHIND:
            return _part(PlaceKind.NECK, piece, inside, touched[0], behind)
        return _part(PlaceKind.ARM, piece, inside, touched[0])
    body = touched[0] if touched else None
    part = _part(PlaceKind.ARM, piece, inside, body)
    if body is None:
        return part
    apex, reach = _farthest(piece, body)
    away = np.linalg.norm(inside.middles - apex, axis=1)
    outer, inner = inside.widths[away < 0.5 * reach], inside.widths[away >= 0.5 * reach]
    tapers = not len(outer) or (len(inner) > 0 and outer.mean() < _TAPER * inner.mean())
    if tapers:
        middle = np.vstack([apex, part.middle])
        return ThinPart(PlaceKind.TIP, piece, inside, middle, length(middle))
    return part


def _part(kind: PlaceKind, piece: Any, inside: Sections, body: Any, behind: float = 0.0) -> ThinPart:
    middles = inside.middles
    if body is None:
        start = int(np.argmax(np.linalg.norm(middles - middles.mean(axis=0), axis=1)))
    else:
        start = int(np.argmax(shapely().distance(shapely().points(middles), body)))
    line = chained(middles, start)
    return ThinPart(kind, piece, inside, line, length(line), behind)


def _farthest(piece: Any, body: Any) -> tuple[Floats, float]:
    """The point (2,) of a piece farthest from a body, and how far it is."""
    rim = shapely().get_coordinates(piece.exterior)
    away = shapely().distance(shapely().points(rim), body)
    k = int(np.argmax(away))
    return rim[k], float(away[k])


def _within(piece: Any, points: Floats) -> Any:
    return shapely().contains_xy(piece, points[:, 0], points[:, 1])


def rim_near(outline: Outline, area: Any, reach: float) -> tuple[Floats, ...]:
    """The stretches (k, 2) of the outline that bound an area, or come within `reach` [m] of it."""
    package = shapely()
    loops = package.MultiLineString([ring(loop) for loop in outline.loops])
    lines = package.line_merge(loops.intersection(area.buffer(reach)))
    return tuple(
        package.get_coordinates(line)
        for line in package.get_parts(lines)
        if line.geom_type == "LineString" and line.length > 0.0
    )


def notches(outline: Outline) -> Iterator[Notch]:
    """Concave corners and tight concave bends of all loops."""
    size = max(outline.size)
    reach = NOTCH_REACH * size
    for loop in outline.loops:
        lengths = arc_lengths(loop)
        count = max(24, int(np.ceil(6.0 * lengths[-1] / reach)))
        at = np.arange(count) * lengths[-1] / count
        points = point_at(loop, lengths, at)
        turns = -turns_at(loop, lengths, at, reach)
        taken = np.zeros(count, dtype=bool)
        # a round hole turns everywhere; its corners turn more
        least = _NOTCH_TURN + (0.0 if loop is outline.outer else 3.0 * np.pi * reach / float(lengths[-1]))
        spread = int(np.ceil(1.5 * reach / (lengths[-1] / count)))
        for k in np.argsort(-turns, kind="stable"):
            if turns[k] < least:
                break
            if taken[k]:
                continue
            taken[(k + np.arange(-spread, spread + 1)) % count] = True
            # the middle of a bend that turns evenly
            same = [j for j in range(-spread, spread + 1) if turns[(k + j) % count] > turns[k] - 0.03]
            middle = (k + same[len(same) // 2]) % count
            place = points[middle]
            extent = point_at(loop, lengths, at[middle] + np.linspace(-reach, reach, 13))
            yield Notch(place, float(turns[middle]), _radius(loop, lengths, at[middle], reach), extent)


def _radius(loop: Floats, lengths: Floats, at: float, reach: float) -> float:
    """Radius of the bend at an arc length: arc over turn, within growing stretches; 0 for a corner [m]."""
    best = 0.0
    for share in (0.25, 0.5, 1.0):
        step = share * reach
        places = point_at(loop, lengths, at + step * np.array([-1.0, -0.5, 0.5, 1.0]))
        bend = abs(float(turn(places[1] - places[0], places[3] - places[2])))
        radius = 1.5 * step / max(bend, 1e-9)
        if share == 0.25 and bend > np.radians(60.0):
            return 0.0
        best = radius
    return best


def simple_line(points: Floats, tolerance: float) -> Floats:
    """An open line (k, 2) with so few points that it stays within a tolerance."""
    if len(points) < 3:
        return points
    line = shapely().LineString(points).simplify(tolerance)
    return np.asarray(line.coords, dtype=np.float64)

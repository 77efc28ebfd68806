# SPDX-License-Identifier: LGPL-2.1-or-later
"""Marks that match: on both edges of a seam its number, an arrow, notches in groups of one, two, three.

All but notches and tabs are drawn (PEN): the number and the arrow on the film beside the weld, to be read
with the seam below, and across the weld a line where each seam ends.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from BalloonWorkbench.core.bag_pattern.digits import arrow_strokes, number_strokes, number_width
from BalloonWorkbench.core.bag_pattern.seams import Station, station
from BalloonWorkbench.core.geometry.areas import parts
from BalloonWorkbench.core.geometry.polyline import length, line_lengths, point_on
from BalloonWorkbench.core.geometry.vectors import direction, perpendicular, unit
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.pattern.pattern import Contour, Role
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import from_mm

#: Heights of numbers, and how far above the seam they stand [m].
_SMALLEST, _HIGHEST, _ABOVE = from_mm(1.5), from_mm(6.0), from_mm(1.0)
#: Between the notches of a group; way along a seam for each group; the shortest seam with one [m].
_BESIDE, _GROUP, _SHORT = from_mm(3.0), from_mm(150.0), from_mm(30.0)
#: A notch leaves that much film before the weld [m]; a shorter one is none.
_LEFT, _LEAST = from_mm(0.1), from_mm(0.2)
_MOST_GROUPS = 60
#: Where a number stands, of its edge's length, and how high, of what is usual: the first that has room.
_SHARES = (0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8)
_PARTS = (1.0, 0.6, 0.35)
#: Without a corner, the ends of a stretch are that far apart, of its length.
_STRAIGHT = 0.97


@dataclass(frozen=True)
class MarkedSide:
    """One side of a seam on its panel.

    number   of the seam
    line     (k, 2) m in the direction of the seam
    forward  1.0 where that is the direction of the panel's loop, else -1.0
    ends     loop of the panel and number of the point at both ends
    tabs     shares of its length at which the allowance is cut into tabs (k,)
    mouth    share at which a neck leaves, None without one; and how much of it is kept free on both sides [m]
    """

    number: int
    line: Floats
    forward: float
    ends: tuple[tuple[int, int], tuple[int, int]]
    tabs: Floats
    mouth: float | None = None
    free: float = 0.0

    @property
    def length(self) -> float:
        """[m]."""
        return length(self.line)

    def at(self, share: float, reach: float) -> Station:
        """A place on it, see `station`."""
        return station(self.line, share, reach, self.forward)

    def is_straight(self, share: float, reach: float) -> bool:
        """Whether it has no corner within so much on both sides of a place [m]."""
        lengths = line_lengths(self.line)
        middle = share * lengths[-1]
        ends = point_on(self.line, lengths, np.clip([middle - reach, middle + reach], 0.0, lengths[-1]))
        way = min(middle + reach, lengths[-1]) - max(middle - reach, 0.0)
        return float(np.linalg.norm(ends[1] - ends[0])) > _STRAIGHT * way

    def is_free(self, share: float) -> bool:
        """Whether no neck is there."""
        return self.mouth is None or abs(share - self.mouth) * self.length > self.free


def groups_of(length: float, count: int) -> list[tuple[float, int]]:
    """Shares of a seam's length [m] with how many notches are at each: 1, 2, 3 and again.

    count  of groups; 0 takes as many as the length needs
    """
    if count == 0:
        count = 0 if length < _SHORT else min(max(3, int(length / _GROUP)), _MOST_GROUPS)
        count = 1 if count > 0 and length < 4.0 * _SHORT else count
    return [((k + 1.0) / (count + 1.0), k % 3 + 1) for k in range(count)]


def numbers_and_arrows(sides: Sequence[MarkedSide], film: Any) -> tuple[list[Contour], list[int]]:
    """On each edge the number of its seam and an arrow in its direction; film an area of shapely.

    And the numbers of the seams for which an edge has no room.
    """
    package = shapely()
    package.prepare(film)
    lines: list[Contour] = []
    taken: list[Any] = []
    left_out: list[int] = []
    for side in sides:
        height = _height(side, film)
        heights = dict.fromkeys(max(height * part, _SMALLEST) for part in _PARTS)
        places = [(share, high) for high in heights for share in _SHARES if side.is_free(share)]
        places.sort(key=lambda place: not side.is_straight(place[0], 2.0 * place[1]))
        tried = [_number_at(side, *place) for place in places]
        hulls = [package.MultiPoint(np.concatenate(strokes)).convex_hull for strokes in tried]
        fitting = [k for k, hull in enumerate(hulls) if film.contains(hull)]
        alone = [k for k in fitting if not any(hulls[k].intersects(other) for other in taken)]
        if not alone:  # or a neck takes the whole edge
            left_out += [side.number] if tried else []
            continue
        best = alone[0]
        taken.append(hulls[best])
        lines += [Contour(Role.PEN, line, False) for line in tried[best]]
    return lines, left_out


def _height(side: MarkedSide, film: Any) -> float:
    """How high a number stands where there is room at the middle of its edge [m]."""
    package = shapely()
    place = side.at(0.5, 0.05 * side.length)
    inward = -place.outward
    across = package.LineString([place.at + 1e-6 * inward, place.at + 100.0 * inward]).intersection(film)
    width = float(package.get_parts(across)[0].length) if not across.is_empty else 0.0
    room = min(0.2 * width, 0.6 * side.length / (number_width(side.number) + 2.0))
    return float(np.clip(room, _SMALLEST, _HIGHEST))


def _number_at(side: MarkedSide, share: float, height: float) -> list[Floats]:
    """Lines (k, 2) m of the number and its arrow above a place of the edge."""
    wide = number_width(side.number)
    place = side.at(share, height)
    inward = -place.outward
    arrow = [line * (side.forward, 1.0) for line in arrow_strokes()]
    shift = np.array([wide + (0.4 if side.forward > 0.0 else 1.4), 0.5])
    lines = [*number_strokes(side.number), *(line + shift for line in arrow)]
    foot = place.at + min(_ABOVE, 0.25 * height) * inward
    start = foot - 0.5 * height * (wide + 1.4) * place.along
    axes = height * np.stack([place.along, inward])
    return [line @ axes + start for line in lines]


def notches(side: MarkedSide, cut: Any, depth: float, allowance: float, count: int) -> list[Contour]:
    """Cuts into the allowance from the edge: groups to match, tabs where the edge must turn.

    cut  the outer edge or that of a hole, as a line of shapely
    """
    deep = min(depth, allowance - _LEFT)
    if deep < _LEAST:
        return []
    groups = groups_of(side.length, count)
    matching = [
        share + (k - 0.5 * (many - 1)) * _BESIDE / side.length
        for share, many in groups
        if side.is_free(share)
        for k in range(many)
    ]
    kept = 2.0 * _BESIDE / side.length
    tabs = [
        share
        for share in side.tabs.tolist()
        if side.is_free(share) and all(abs(share - other) > kept for other in matching)
    ]
    cuts = [*((share, deep) for share in matching), *((share, allowance - _LEFT) for share in tabs)]
    lines = [_cut_in(side.at(share, 0.5 * _BESIDE), cut, long) for share, long in cuts]
    return [Contour(Role.NOTCH, line, False) for line in lines if line is not None]


def _cut_in(place: Station, cut: Any, depth: float) -> Floats | None:
    """From the cut straight toward the seam (2, 2); None where no cut is before the seam."""
    package = shapely()
    ray = package.LineString([place.at, place.at + 10.0 * place.outward])
    met = package.get_coordinates(ray.intersection(cut))
    if not len(met):
        return None
    edge = met[np.argmin((met - place.at) @ place.outward)]
    return np.stack([edge, edge - depth * place.outward])


def end_lines(loops: tuple[Floats, ...], ends: set[tuple[int, int]], seal_width: float) -> list[Contour]:
    """Lines from each end of a seam, a point of a loop, to the middle of the weld."""
    lines = []
    for number, point in sorted(ends):
        loop = loops[number]
        before, at, after = (loop[(point + k) % len(loop)] for k in (-1, 0, 1))
        one, other = -perpendicular(unit(at - before)), -perpendicular(unit(after - at))
        middle = unit(one + other)
        reach = 0.5 * seal_width / max(float(middle @ one), 0.5)
        lines.append(Contour(Role.PEN, np.stack([at, at + reach * middle]), False))
    return lines


def grain_line(film: Any, drawn: Sequence[Contour], angle: float) -> list[Contour]:
    """An arrow with two heads along the grain [rad], where the film, an area of shapely, has most room beside
    what is drawn.
    """
    package = shapely()
    marks = package.MultiLineString([line.points for line in drawn]).buffer(_ABOVE)
    room = parts(film.difference(marks)) or [film]
    circle = package.maximum_inscribed_circle(room[0])
    middle, radius = np.asarray(circle.coords[0]), float(circle.length)
    half = min(0.9 * radius, from_mm(40.0))
    ahead = direction(angle)
    head = min(0.3 * half, from_mm(4.0)) * np.array([[-1.0, 0.4], [0.0, 0.0], [-1.0, -0.4]])
    lines = [np.stack([middle - half * ahead, middle + half * ahead])]
    for sense in (1.0, -1.0):
        axes = np.stack([sense * ahead, perpendicular(ahead)])
        lines.append(head @ axes + middle + sense * half * ahead)
    return [Contour(Role.PEN, line, False) for line in lines]

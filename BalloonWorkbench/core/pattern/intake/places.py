# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where an intake sits: at a place that is given, at the farthest point of the seam, or low."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.polyline import extent
from BalloonWorkbench.core.geometry.vectors import direction, perpendicular
from BalloonWorkbench.core.options.pattern import FARTHEST, LOW, PatternOptions
from BalloonWorkbench.core.outline.chambers import chambers
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.pattern.intake.kinds import IntakeKind, intake_kind
from BalloonWorkbench.core.pattern.intake.rim import Rim
from BalloonWorkbench.core.pattern.shapes import offset, polygon
from BalloonWorkbench.core.types import Bools, Floats, Ints
from BalloonWorkbench.core.units import from_mm, length_text, number_text, place_text

PLACES = (FARTHEST, LOW)
#: Ends of a balloon that are that much less far than the farthest one count as well; the lowest is taken.
_ABOUT_AS_FAR = 0.04
#: A stretch of them longer than this share of the rim is round, and no end.
_ROUND = 0.2
#: Points of one end within this share of each other count as equally far.
_EQUALLY_FAR = 1e-3
#: Places no higher than that over the lowest one count as low, too; of the size.
_EQUALLY_LOW = 0.02
#: The middle of a disc in a tip of an angle a is width / (2 sin(a / 2)) away from it; here for 34 degrees.
_NEAR = 1.7
#: How much farther away welds may push that disc, of its width.
_BESIDE_WELD = 0.05
#: A low neck points downward by at least that much of its length.
_DOWNWARD = 0.5
#: Places that differ by less, of the size, are equally low: a symmetric drawing has so much scatter.
_SAME = 1e-3
#: Places on the rim among which a chamber finds its own.
_ON_RIM = 720
#: Where no place is as wide as the intake, a narrower one will do: these shares of its width.
_NARROWER = (1.0, 0.5, 0.25)


@dataclass(frozen=True)
class Wish:
    """An intake as it is wanted; lengths [m], angle [rad], None where it is found.

    length  of the neck, or diameter of the flange
    angle   direction from the centre of area, where the rim is met
    along   place on the rim instead, as in `Rim`; a neck then leaves square to it, or along the angle
    place   FARTHEST or LOW, where neither is given
    """

    kind: IntakeKind
    width: float
    length: float | None = None
    angle: float | None = None
    along: float | None = None
    place: str = FARTHEST

    @property
    def is_automatic(self) -> bool:
        """Whether the pattern finds the place."""
        return self.angle is None and self.along is None


def intake_of(options: PatternOptions) -> Wish:
    """The intake of a pattern; InputError for a kind that is not known."""
    kind = intake_kind(options.intake_kind)
    width = kind.width if options.intake_width is None else options.intake_width
    return Wish(
        kind, width, options.intake_length, options.intake_angle, options.intake_along, options.intake_place
    )


def wishes(seam: Outline, film: Any, rim: Rim, wish: Wish, margin: float) -> list[tuple[Any, Wish]]:
    """Each chamber of a seam with its intake as it is wanted: the one at the given place is the first, the
    others find their own.

    film, rim  of the seam; margin: seal width and allowance [m]
    """
    rooms = chambers(seam)
    if len(rooms) == 1:
        return [(rooms[0] if seam.welds else film, wish)]
    if not wish.is_automatic:
        at = shapely().Point(place_of(film, film, rim, wish, margin)[0])
        rooms.sort(key=lambda room: room.distance(at))
    pairs = []
    for k, room in enumerate(rooms):
        each = wish
        if k > 0 or wish.is_automatic:
            free = replace(wish, angle=None, along=None)
            others = [*rooms[:k], *rooms[k + 1 :]]
            each = free if wish.place == LOW else replace(free, along=_freest(rim, room, others))
        pairs.append((room, each))
    return pairs


class Places:
    """Where intakes sit on a seam (`faired`), as its pattern has them; margin: seal width and allowance [m].

    Raises OutlineError where the seam crosses itself.
    """

    def __init__(self, seam: Outline, margin: float) -> None:
        self._seam, self._film, self._rim, self._margin = seam, film_of(seam), Rim(seam.outer), margin

    def of(self, wish: Wish) -> list[Floats]:
        """The place (2,) [m] of the intake of each chamber; InputError where there is none."""
        pairs = wishes(self._seam, self._film, self._rim, wish, self._margin)
        return [place_of(self._film, room, self._rim, each, self._margin)[0] for room, each in pairs]


def film_of(seam: Outline) -> Any:
    """The film inside a seam as a polygon of shapely; OutlineError where a loop crosses itself."""
    whole, holes = polygon(seam.outer), [polygon(hole) for hole in seam.holes]
    return whole.difference(shapely().unary_union(holes)) if holes else whole


def place_of(film: Any, chamber: Any, rim: Rim, wish: Wish, margin: float) -> tuple[Floats, Floats]:
    """The point of the rim and the direction (2,) outward."""
    if wish.place not in PLACES:
        raise InputError(f'The intake\'s place cannot be "{wish.place}": choose {" or ".join(PLACES)}.')
    along, turn = wish.along, wish.angle
    if wish.is_automatic and wish.place == LOW:
        along = _lowest(film, chamber, rim, wish, margin)
    if along is not None:
        if not np.isfinite(along):
            raise InputError("The intake's place along the seam must be a length.")
        turn = _square(rim, along, wish) if turn is None else turn
        return rim.at(along), direction(turn)
    centre = np.asarray(chamber.centroid.coords[0])
    return _farthest(rim, centre) if turn is None else _hit(film, centre, turn)


def _square(rim: Rim, along: float, wish: Wish) -> float:
    """The direction [rad] of a neck square to the rim at a place."""
    return rim.outward(along, 0.5 * wish.width)


def _lowest(film: Any, chamber: Any, rim: Rim, wish: Wish, margin: float) -> float:
    """The lowest place on the rim of a chamber that is wide enough for the intake, in no notch and clear of
    the welds [m]; of all that are about as low the one nearest to below the centre, where a tied balloon
    hangs straight. Raises InputError where there is none.
    """
    places = np.linspace(0.0, rim.length, _ON_RIM, endpoint=False)
    points = rim.points_at(places)
    free = _is_free(film, rim, places, wish, margin)
    for share in _NARROWER:
        fits = free & _is_wide(film, chamber, points, share * wish.width)
        if fits.any():
            break
    else:
        raise InputError(
            f"Nowhere on the seam is room for an intake of {length_text(wish.width)}: choose a narrower"
            " one, or"
            " a place for it."
        )
    low = fits & (points[:, 1] < points[fits, 1].min() + _EQUALLY_LOW * extent(rim.points))
    middle = float(chamber.centroid.x)
    step = rim.length / _ON_RIM
    lowest = [_nearest_below(step * run, points[run % _ON_RIM, 0], middle) for run in _runs(low, low)]
    across = rim.points_at(np.array(lowest))[:, 0]
    return lowest[_first(np.abs(across - middle), across, 2.0 * step)] % rim.length


def _is_wide(film: Any, chamber: Any, points: Floats, width: float) -> Bools:
    """Whether a disc of a width that lies in the chamber is near to each point (n, 2) of the rim: no farther
    than in a blunt tip, and not kept away by welds.
    """
    package = shapely()
    away, without_welds = (
        package.distance(area.buffer(-0.5 * width, quad_segs=16), package.points(points))
        for area in (chamber, film)
    )
    return np.asarray((away < _NEAR * width) & (away < without_welds + _BESIDE_WELD * width))  # none: nan


def _is_free(film: Any, rim: Rim, places: Floats, wish: Wish, margin: float) -> Bools:
    """Whether a neck square to the rim at each place (n,) points downward, with room beside and before it."""
    package = shapely()
    width, length = wish.width, max(from_mm(30.0), 3.0 * wish.width)
    turns = np.array([_square(rim, place, wish) for place in places.tolist()])
    ahead, points = direction(turns), rim.points_at(places)
    sides = rectangle(points, ahead, margin, margin + length, width + margin)
    mouths = before_mouth(points, ahead, length, width, margin)
    cut = offset(film, margin)
    for area in (film, cut):
        package.prepare(area)
    met = package.intersects(film, sides) | package.intersects(cut, mouths)
    return np.asarray((ahead[:, 1] < -_DOWNWARD) & ~met)


def _nearest_below(run: Floats, across: Floats, middle: float) -> float:
    """Of a run of places (n,) with x (n,), the one at the x of the middle, else the middle of the run."""
    passed = np.flatnonzero((across[:-1] - middle) * (across[1:] - middle) <= 0.0)
    if not len(passed):
        return 0.5 * float(run[0] + run[-1])
    k = int(passed[0])
    share = (middle - across[k]) / (across[k + 1] - across[k]) if across[k + 1] != across[k] else 0.5
    return float(run[k] + share * (run[k + 1] - run[k]))


def _runs(taken: Bools, joined: Bools) -> list[Ints]:
    """Numbers of the places of a loop (n,) that are taken, in runs; those past the end go on from n.

    joined  whether the way from each place to the next belongs to the run
    """
    count = len(taken)
    ends = np.flatnonzero(taken & ~(joined & np.roll(taken, -1)))
    if not len(ends):
        return [np.arange(count, dtype=np.int32)] if taken.all() else []
    runs = []
    for end in ends.tolist():
        start = end
        while taken[start - 1] and joined[start - 1] and end - start < count - 1:
            start -= 1
        shift = count if start < 0 else 0
        runs.append(np.arange(start + shift, end + shift + 1, dtype=np.int32))
    return runs


def _freest(rim: Rim, chamber: Any, others: list[Any]) -> float:
    """The place on the rim of a chamber that is farthest from the other chambers [m].

    Raises InputError for a chamber that has nothing of the rim.
    """
    package = shapely()
    places = np.linspace(0.0, rim.length, _ON_RIM, endpoint=False)
    points = package.points(rim.points_at(places))
    mine = package.distance(chamber, points) < 1e-3 * rim.length
    room = np.where(mine, package.distance(package.union_all(others), points), 0.0)
    if not room.any():
        raise InputError(
            f"The part round {place_text(np.asarray(chamber.centroid.coords[0]))} has no rim for an intake:"
            " leave a gap in the welds round it."
        )
    return float(places[int(np.argmax(np.round(room / rim.length, 4)))])


def _farthest(rim: Rim, centre: Floats) -> tuple[Floats, Floats]:
    """The point farthest from a centre: of several that are about equally far the lowest, then the leftmost.

    A small change of the seam, such as from a first look to the fitted balloon, must not make it wander.
    """
    points = rim.points
    between = 0.5 * (points + np.roll(points, -1, axis=0))
    away, halfway = (np.linalg.norm(places - centre, axis=1) for places in (points, between))
    limit = (1.0 - _ABOUT_AS_FAR) * float(away.max())
    places = np.array([_end_of(rim, run, away, halfway) for run in _runs(away > limit, halfway > limit)])
    at = places[_first(places[:, 1], places[:, 0], _ABOUT_AS_FAR * float(away.max()))]
    return at, (at - centre) / np.linalg.norm(at - centre)


def _end_of(rim: Rim, run: Ints, away: Floats, halfway: Floats) -> Floats:
    """The point (2,) that stands for a stretch of the rim, points `run`, that is about equally far.

    Of a round one it is the lowest; else the middle of what is farthest in it, of several the lowest.
    """
    count = len(rim.points)
    closed = np.append(rim.along[:-1], rim.along[:-1] + rim.length)
    if len(run) == count or closed[run[-1]] - closed[run[0]] > _ROUND * rim.length:
        points = rim.points[run % count]
        return np.asarray(points[np.lexsort((points[:, 0], points[:, 1]))[0]])
    mine = np.zeros(count, dtype=np.bool_)
    mine[run % count] = True
    limit = (1.0 - _EQUALLY_FAR) * float(away[mine].max())
    tops = _runs(mine & (away > limit), halfway > limit)
    places = rim.points_at(np.array([0.5 * (closed[top[0]] + closed[top[-1]]) for top in tops]))
    return np.asarray(places[_first(places[:, 1], places[:, 0], _SAME * float(away.max()))])


def _first(values: Floats, others: Floats, equal: float) -> int:
    """Number of the smallest value (n,); of all that are at most `equal` larger, of the smallest other."""
    same = np.flatnonzero(values <= values.min() + equal)
    return int(same[np.argmin(others[same])])


def _hit(film: Any, centre: Floats, angle: float) -> tuple[Floats, Floats]:
    if not np.isfinite(angle):
        raise InputError("The intake's angle must be a number.")
    ahead = direction(angle)
    low_x, low_y, high_x, high_y = film.bounds
    reach = 2.0 * float(np.hypot(high_x - low_x, high_y - low_y))
    met = shapely().LineString([centre, centre + reach * ahead]).intersection(film.exterior)
    points = shapely().get_coordinates(met)
    if not len(points):
        raise InputError(
            f"There is no outline at {number_text(float(np.degrees(angle)))} degrees from the centre:"
            " choose another intake angle."
        )
    return points[np.argmax((points - centre) @ ahead)], ahead


def before_mouth(at: Floats, ahead: Floats, length: float, width: float, margin: float) -> Any:
    """A little more than the neck's whole breadth, from the mouth onward."""
    return rectangle(at, ahead, length, length + 4.0 * margin + width, width + 2.2 * margin)


def rectangle(at: Floats, ahead: Floats, start: float, end: float, width: float) -> Any:
    """A strip across a direction `ahead` (2,), from `start` to `end` along it [m]; for (n, 2) many."""
    side = 0.5 * width * perpendicular(ahead)
    near, far = at + start * ahead, at + end * ahead
    return shapely().polygons(np.stack([near - side, far - side, far + side, near + side], axis=-2))

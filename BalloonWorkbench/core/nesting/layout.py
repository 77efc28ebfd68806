# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is laid out, on what film, and how it comes to lie."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from enum import Enum
from typing import Any

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.nesting.remnant import Remnant, usable
from BalloonWorkbench.core.options.making import SheetOptions
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.pattern.pattern import Pattern, Role
from BalloonWorkbench.core.pattern.placement import back_of, turned
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import length_text

#: One piece of a kind: number of the piece, and whether it is the back.
Unit = tuple[int, bool]

SPACING = SheetOptions.spacing
_MOST_COPIES = 200
_MOST_FILM = 20.0  # m


class GrainRule(Enum):
    """How the grain of the film may lie in a piece, relative to the length of the roll or sheet."""

    ALONG = "along"
    ACROSS = "across"
    ANY = "any"


@dataclass(frozen=True)
class Stock:
    """The film: it lies along x, its width along y.

    width    of the roll or sheet [m]
    length   of a sheet [m]; None for a roll
    spacing  between pieces, and to the edges [m]
    grain    how pieces lie whose film has one
    remnant  the shape of the film where it is no rectangle; width and length are those of its box
    """

    width: float
    length: float | None = None
    spacing: float = SPACING
    grain: GrainRule = GrainRule.ALONG
    remnant: Remnant | None = None

    @property
    def film(self) -> Any:
        """The film as a polygon of shapely [m]; of a roll there is none."""
        if self.remnant is not None:
            return self.remnant.area
        return shapely().box(0.0, 0.0, np.inf if self.length is None else self.length, self.width)

    @property
    def room(self) -> float:
        """Width that pieces may take [m]."""
        return self.width - 2.0 * self.spacing


@dataclass(frozen=True)
class Piece:
    """A pattern to be cut.

    count     how often the front is cut
    backs     how often the back is, mirrored: a film that seals on one side needs that
    grain     direction of the film's grain in the pattern, from x [rad]; None for a film without one
    """

    pattern: Pattern
    count: int = 1
    backs: int = 0
    grain: float | None = 0.0

    def panel(self, mirrored: bool) -> Pattern:
        """The front, or the back."""
        return back_of(self.pattern) if mirrored else self.pattern

    def angles(self, mirrored: bool, grain: GrainRule) -> list[float]:
        """Angles by which it may be turned [degrees], from -180 to 180."""
        if grain is GrainRule.ANY or self.grain is None:
            return [float(angle) for angle in range(-165, 181, 15)]
        own = np.degrees(np.pi - self.grain if mirrored else self.grain)
        first = (90.0 if grain is GrainRule.ACROSS else 0.0) - own
        return sorted(float(-((180.0 - angle) % 360.0) + 180.0) for angle in (first, first + 180.0))


@dataclass(frozen=True)
class Place:
    """Where a piece lies: which one, front or mirrored back, turned by an angle [rad], moved by (2,) m."""

    piece: int
    mirrored: bool
    angle: float
    shift: Floats


@dataclass(frozen=True)
class Layout:
    """A stretch of roll, or a sheet, with its pieces.

    length       of film that is used [m]
    utilisation  area of the pieces relative to that of the film used
    """

    stock: Stock
    places: tuple[Place, ...]
    length: float
    utilisation: float

    def pattern(self, pieces: Sequence[Piece]) -> Pattern:
        """All pieces as one pattern, lower left corner of the film at the origin; it has no intake of its
        own, and knows the film."""
        laid = [
            turned(pieces[place.piece].panel(place.mirrored), place.angle, place.shift)
            for place in self.places
        ]
        return replace(
            laid[0],
            contours=tuple(contour for pattern in laid for contour in pattern.contours),
            intake=None,
            more_intakes=(),
            seam_length=sum(pattern.seam_length for pattern in laid),
            warnings=tuple(dict.fromkeys(warning for pattern in laid for warning in pattern.warnings)),
            film=(self.length, self.stock.width),
        )


def layout_of(stock: Stock, pieces: Sequence[Piece], places: Sequence[Place]) -> Layout:
    """The layout of pieces in their places, in reading order."""
    ordered = sorted(places, key=lambda place: (place.piece, place.mirrored, *np.round(place.shift, 6)))
    ends = [_laid(pieces, place).bounds[1][0] for place in ordered]
    length = max(ends) + stock.spacing if stock.length is None else stock.length
    area = sum(pieces[place.piece].pattern.film_area for place in ordered)
    film = stock.width * length if stock.remnant is None else stock.remnant.area.area
    return Layout(stock, tuple(ordered), float(length), float(area / film))


def of_remnant(remnant: Remnant, like: Stock) -> Stock:
    """A remnant as film, with spacing and grain of another."""
    length, width = remnant.size
    return Stock(width, length, like.spacing, like.grain, remnant)


def left_of(layout: Layout, pieces: Sequence[Piece]) -> list[Remnant]:
    """What is left of the film of a layout and can be used again: of a roll, of the stretch that is used."""
    package = shapely()
    film = replace(layout.stock, length=layout.length).film
    taken = package.union_all([outline_of(_laid(pieces, place)) for place in layout.places])
    (stock,) = {pieces[place.piece].pattern.stocks[0] for place in layout.places}
    return usable(film.difference(taken), stock)


def _laid(pieces: Sequence[Piece], place: Place) -> Pattern:
    return turned(pieces[place.piece].panel(place.mirrored), place.angle, place.shift)


def outline_of(pattern: Pattern) -> Any:
    """What a piece takes of the film: a polygon of shapely without holes; the hull of separate parts."""
    package = shapely()
    cuts = [*pattern.of(Role.CUT), *pattern.of(Role.PRINT)]
    area = package.union_all([package.Polygon(cut.points) for cut in cuts])
    if area.geom_type != "Polygon":
        area = area.convex_hull
    return package.Polygon(area.exterior)


def check_count(pieces: Sequence[Piece]) -> None:
    """Raise InputError for too many pieces, or none."""
    count = sum(piece.count + piece.backs for piece in pieces)
    if not 0 < count <= _MOST_COPIES or any(min(piece.count, piece.backs) < 0 for piece in pieces):
        raise InputError(f"1 to {_MOST_COPIES} pieces can be laid out, not {count}.")


def check(pieces: Sequence[Piece], stock: Stock) -> None:
    """Raise InputError for film that makes no sense, and for pieces that do not fit on it."""
    numbers = (stock.width, stock.spacing, *(() if stock.length is None else (stock.length,)))
    if not (np.isfinite(numbers).all() and stock.spacing >= 0.0 and stock.room > 0.0):
        raise InputError("The film needs a width of more than two spacings, and no spacing below 0.")
    if max(stock.width, stock.length or 0.0) > _MOST_FILM:
        raise InputError(
            f"Film {length_text(max(stock.width, stock.length or 0.0))} large is too much: write 500mm."
        )
    room = np.inf if stock.length is None else stock.length - 2.0 * stock.spacing
    for piece in pieces:
        sizes = [
            turned(piece.pattern, float(np.radians(angle)), np.zeros(2)).size
            for angle in piece.angles(False, stock.grain)
        ]
        if not any(width <= room and height <= stock.room for width, height in sizes):
            width, height = min(sizes, key=lambda size: size[1])
            needed = length_text(height + 2.0 * stock.spacing)
            where = "" if stock.length is None else f" x {length_text(stock.length)}"
            raise InputError(
                f"A piece of {length_text(width)} x {length_text(height)} does not fit on film of"
                f" {length_text(stock.width)}{where}: take film at least {needed} wide, or let the grain"
                " lie in"
                " another direction."
            )

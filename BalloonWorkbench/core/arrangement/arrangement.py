# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where each piece lies, by its name: it is kept while the pieces change their size, number and order."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from BalloonWorkbench.core.geometry.polyline import bounds
from BalloonWorkbench.core.geometry.vectors import rotation, wrapped
from BalloonWorkbench.core.pattern.layout import SPACING, in_rows
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role
from BalloonWorkbench.core.pattern.pieces import FlatPiece, PatternPieces
from BalloonWorkbench.core.pattern.placement import reversed_points
from BalloonWorkbench.core.types import Floats

_SAME = 1e-6  # of a piece's size: it has not changed


@dataclass(frozen=True)
class PiecePlace:
    """How a piece lies.

    middle    (x, y) m, of its bounds as the pattern has it; that is where it is turned and mirrored
    angle     counter-clockwise [rad]
    mirrored  turned over about its upright axis, before it is turned
    """

    middle: tuple[float, float]
    angle: float = 0.0
    mirrored: bool = False

    @property
    def matrix(self) -> Floats:
        """(2, 2), by which rows of points about the middle are multiplied."""
        flip = np.diag([-1.0 if self.mirrored else 1.0, 1.0])
        return np.asarray(flip @ rotation(self.angle))

    def moved(self, shift: Floats) -> PiecePlace:
        """Elsewhere, by a shift (2,) [m]."""
        return replace(self, middle=(self.middle[0] + float(shift[0]), self.middle[1] + float(shift[1])))

    def turned(self, angle: float) -> PiecePlace:
        """Turned by an angle [rad] besides."""
        return replace(self, angle=_within_a_turn(self.angle + angle))

    def turned_over(self) -> PiecePlace:
        """Left and right changed, as it lies."""
        return replace(self, angle=_within_a_turn(-self.angle), mirrored=not self.mirrored)

    def grain(self, own: float) -> float:
        """Direction [rad] of the grain of a piece that has it in this direction in the pattern, below pi."""
        return float(((np.pi - own if self.mirrored else own) + self.angle) % np.pi)


@dataclass(frozen=True)
class Arrangement:
    """What is kept of where pieces lie, by their names; sizes [m]: the diagonals of their bounds then."""

    places: Mapping[str, PiecePlace] = field(default_factory=dict)
    sizes: Mapping[str, float] = field(default_factory=dict)


@dataclass(frozen=True)
class LaidPieces:
    """Pieces as they lie.

    pieces  moved; base: as the pattern lays them
    places  of each piece
    gone    names of those that were arranged and are not in the pattern any more
    new     names of those that are in it since
    """

    pieces: PatternPieces
    base: PatternPieces
    places: tuple[PiecePlace, ...]
    gone: tuple[str, ...] = ()
    new: tuple[str, ...] = ()


def names_of(pieces: PatternPieces) -> list[str]:
    """A name for each piece, none twice."""
    seen: Counter[str] = Counter()
    names = []
    for piece in pieces.pieces:
        seen[piece.name] += 1
        names.append(piece.name if seen[piece.name] == 1 else f"{piece.name} ({seen[piece.name]})")
    return names


def arrangement_of(pieces: PatternPieces, places: Sequence[PiecePlace]) -> Arrangement:
    """What is to be kept of pieces, as the pattern lays them, in these places."""
    names = names_of(pieces)
    return Arrangement(
        dict(zip(names, places, strict=True)), dict(zip(names, _sizes(pieces).tolist(), strict=True))
    )


def laid_pieces(pieces: PatternPieces, kept: Arrangement) -> LaidPieces:
    """Pieces as they are arranged: all together as much farther apart as they have grown since; what is new
    beside them. As the pattern lays them where nothing is kept."""
    own = [PiecePlace(_middle(piece)) for piece in pieces.pieces]
    names = names_of(pieces)
    known = [name for name in names if name in kept.places]
    gone = tuple(name for name in kept.places if name not in names)
    if not known:
        return LaidPieces(pieces, pieces, tuple(own), gone)
    growth = _growth(dict(zip(names, _sizes(pieces).tolist(), strict=True)), kept.sizes)
    scaled = {name: _scaled(kept.places[name], growth) for name in known}
    places = [scaled.get(name, place) for name, place in zip(names, own, strict=True)]
    new = [number for number, name in enumerate(names) if name not in scaled]
    if new:
        _lay_beside(pieces, places, new)
    laid = laid_at(pieces, places)
    return LaidPieces(laid, pieces, tuple(places), gone, tuple(names[number] for number in new))


def laid_at(pieces: PatternPieces, places: Sequence[PiecePlace]) -> PatternPieces:
    """Pieces, as the pattern lays them, taken to places of each."""
    ways = [
        _PieceMove(np.array(_middle(piece)), place)
        for piece, place in zip(pieces.pieces, places, strict=True)
    ]
    return PatternPieces(
        tuple(
            FlatPiece(piece.name, way.pattern(piece.pattern))
            for piece, way in zip(pieces.pieces, ways, strict=True)
        ),
        tuple(replace(edge, line=ways[edge.piece].points(edge.line)) for edge in pieces.edges),
    )


def places_of(laid: LaidPieces, number: int, points: Floats) -> Floats:
    """Where points (n, 2) m of a piece, as the pattern lays it, come to lie."""
    piece = laid.base.pieces[number]
    return _PieceMove(np.array(_middle(piece)), laid.places[number]).points(points)


def as_one(pieces: PatternPieces) -> Pattern:
    """All that is drawn on pieces as one pattern, whatever film they are of: for paper."""
    contours = [replace(contour, stock="") for piece in pieces.pieces for contour in piece.pattern.contours]
    ranks = {role: rank for rank, role in enumerate(Role)}
    return replace(
        pieces.pieces[0].pattern,
        contours=tuple(sorted(contours, key=lambda contour: ranks[contour.role])),
        intake=None,
        more_intakes=(),
        warnings=(),
    )


class _PieceMove:
    """How the points of a piece go from where the pattern lays it to its place."""

    def __init__(self, middle: Floats, place: PiecePlace):
        self._middle, self._place = middle, place
        self._matrix = place.matrix

    def points(self, points: Floats) -> Floats:
        return np.asarray((points - self._middle) @ self._matrix + np.array(self._place.middle))

    def pattern(self, pattern: Pattern) -> Pattern:
        contours = tuple(self._contour(contour) for contour in pattern.contours)
        return replace(pattern, contours=contours, intake=None, more_intakes=(), film=None, page=None)

    def _contour(self, contour: Contour) -> Contour:
        """Closed loops keep their sense."""
        points = self.points(contour.points)
        return replace(contour, points=reversed_points(contour, points) if self._place.mirrored else points)


def _middle(piece: FlatPiece) -> tuple[float, float]:
    low, high = piece.pattern.bounds
    x, y = (0.5 * (low + high)).tolist()
    return x, y


def _sizes(pieces: PatternPieces) -> Floats:
    """(n,) m."""
    return np.array([float(np.hypot(*piece.pattern.size)) for piece in pieces.pieces])


def _growth(now: Mapping[str, float], before: Mapping[str, float]) -> float:
    """How much larger pieces are now than they were, in the median."""
    ratios = [size / before[name] for name, size in now.items() if before.get(name, 0.0) > 0.0]
    growth = float(np.median(ratios)) if ratios else 1.0
    return 1.0 if abs(growth - 1.0) < _SAME else growth


def _scaled(place: PiecePlace, growth: float) -> PiecePlace:
    return replace(place, middle=(growth * place.middle[0], growth * place.middle[1]))


def _lay_beside(pieces: PatternPieces, places: list[PiecePlace], new: Sequence[int]) -> None:
    """Give new pieces places in rows at the right of the others."""
    laid = laid_at(pieces, places).pieces
    others = [laid[number].pattern.bounds for number in range(len(laid)) if number not in new]
    low, high = bounds(np.concatenate([np.array(box) for box in others]))
    corner = np.array([high[0] + SPACING, low[1]])
    for number, shift in zip(new, in_rows([laid[each].pattern.bounds for each in new]), strict=True):
        places[number] = places[number].moved(shift + corner)


def _within_a_turn(angle: float) -> float:
    """From -pi up to pi; as good as none is 0."""
    turned = float(wrapped(np.asarray(angle)))
    return 0.0 if abs(turned) < 1e-12 else turned

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pieces of one balloon beside each other, and which edge of which piece is sealed to which."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise

import numpy as np

from BalloonWorkbench.core.design.fairing import faired_seam
from BalloonWorkbench.core.geometry.nearest import Indices, nearest_edges
from BalloonWorkbench.core.geometry.normals import corners
from BalloonWorkbench.core.geometry.polyline import perimeter, ring
from BalloonWorkbench.core.memoize import memoized
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.pattern.layout import in_rows
from BalloonWorkbench.core.pattern.make import make_pattern
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role
from BalloonWorkbench.core.pattern.placement import back_of, split
from BalloonWorkbench.core.pattern.sheet import intake_pieces
from BalloonWorkbench.core.types import Floats

#: A turn that ends an edge [rad], within that part of the way round.
_CORNER, _REACH = float(np.radians(30.0)), 1.0 / 200.0


@dataclass(frozen=True)
class FlatPiece:
    """One piece of film where it lies; the lines of its pattern, and what it is called."""

    name: str
    pattern: Pattern


@dataclass(frozen=True)
class PieceEdge:
    """An edge of a piece.

    piece  number of its piece, from 0
    line   (k, 2) m, where the free film ends and the weld begins; both edges of a seam run the same way
    seam   number of the seam, from 1: the edge of the same number is sealed to it; 0 where that is not known
    """

    piece: int
    line: Floats
    seam: int = 0


@dataclass(frozen=True)
class PatternPieces:
    """All pieces of one balloon, or on a sheet of film, and their edges."""

    pieces: tuple[FlatPiece, ...]
    edges: tuple[PieceEdge, ...]

    def partner(self, number: int) -> int | None:
        """The number of the edge that is sealed to an edge; None for one that stays open, or is not known."""
        seam = self.edges[number].seam
        both = [other for other, edge in enumerate(self.edges) if edge.seam == seam != 0]
        return next((other for other in both if other != number), None)

    def nearest_edge(self, place: Floats) -> tuple[int, float] | None:
        """The edge that is nearest to a place (2,) [m], and how far it is; None where there is no edge."""
        if not self.edges:
            return None
        starts, ends, owner = self._edge_lines
        nearest = nearest_edges(place[None], starts, ends)
        return int(owner[nearest.edge[0]]), float(nearest.distance[0])

    def nearest_point(self, place: Floats, reach: float) -> Floats:
        """The point of a line that is nearest to a place (2,): a corner within reach [m], else a place on the
        line within reach, else the place itself."""
        starts, ends = self._lines
        away = np.hypot(*(starts - place).T)
        corner = int(np.argmin(away))
        if away[corner] <= reach:
            return np.asarray(starts[corner])
        nearest = nearest_edges(place[None], starts, ends)
        number = int(nearest.edge[0])
        if nearest.distance[0] > reach:
            return place
        return np.asarray(starts[number] + nearest.share[0] * (ends[number] - starts[number]))

    @cached_property
    def _edge_lines(self) -> tuple[Floats, Floats, Indices]:
        lines = [edge.line for edge in self.edges]
        owner = np.repeat(np.arange(len(lines)), [len(line) - 1 for line in lines])
        return (*_straight_pieces(lines), owner)

    @cached_property
    def _lines(self) -> tuple[Floats, Floats]:
        """Of all lines of all pieces but letters, and of the edges; the last point is a start as well."""
        contours = [contour for piece in self.pieces for contour in piece.pattern.contours]
        lines = [contour.line for contour in contours if contour.role is not Role.ENGRAVE]
        lines += [edge.line for edge in self.edges]
        return _straight_pieces([np.concatenate([line, line[-1:]]) for line in lines])


def _straight_pieces(lines: Sequence[Floats]) -> tuple[Floats, Floats]:
    return np.concatenate([line[:-1] for line in lines]), np.concatenate([line[1:] for line in lines])


@memoized(most=8)
def two_panel_pieces(seam: Outline, seal_width: float, options: PatternOptions) -> PatternPieces:
    """Front and back of a balloon of two equal panels, and the pieces of its intake; one balloon, whatever
    is cut of it. An edge goes from corner to corner; its partner is the same one of the other panel.

    Raises what `make_pattern` raises.
    """
    front = make_pattern(seam, seal_width, options)
    laid = [front, back_of(front), *(_of_lines(front, lines) for lines in intake_pieces(front))]
    shifts = in_rows([each.bounds for each in laid])
    shifts = [shift - shifts[0] for shift in shifts]  # the front stays where the pattern is
    faired = faired_seam(seam)
    lines = [line for loop in (faired.outer, *faired.holes) for line in _edges_of(loop)]
    mirrored = [line * (-1.0, 1.0) + shifts[1] for line in lines]
    edges = [
        PieceEdge(piece, line, number)
        for piece, its in enumerate((lines, mirrored))
        for number, line in enumerate(its, 1)
    ]
    names = ("front", "back", *(f"intake piece {number}" for number in range(1, len(laid) - 1)))
    pieces = [
        FlatPiece(name, each.moved(shift)) for name, each, shift in zip(names, laid, shifts, strict=True)
    ]
    return PatternPieces(tuple(pieces), tuple(edges))


def sheet_pieces(pattern: Pattern) -> PatternPieces:
    """The pieces of what is laid out anywhere; their edges are the middles of their welds."""
    pieces = tuple(FlatPiece(f"piece {number}", each) for number, each in enumerate(split(pattern), 1))
    edges = [
        PieceEdge(number, weld.line)
        for number, piece in enumerate(pieces)
        for weld in piece.pattern.of(Role.SEAL)
    ]
    return PatternPieces(pieces, tuple(edges))


def _of_lines(pattern: Pattern, lines: Sequence[Contour]) -> Pattern:
    """Lines as a piece of their own beside a pattern."""
    return replace(pattern, contours=tuple(lines), intake=None, more_intakes=(), seam_length=0.0, warnings=())


def _edges_of(loop: Floats) -> list[Floats]:
    """A closed loop (n, 2) as lines from corner to corner; one that has less than two corners is one line."""
    at = corners(loop, _CORNER, _REACH * perimeter(loop)).tolist()
    if len(at) < 2:
        return [ring(loop)]
    points = ring(np.roll(loop, -at[0], axis=0))
    stops = [number - at[0] for number in at] + [len(loop)]
    return [points[start : end + 1] for start, end in pairwise(stops)]

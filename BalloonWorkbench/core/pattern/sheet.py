# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the pattern of one panel to all that lies on the sheet: pieces of the intake, second panel, copies."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.polyline import bounds
from BalloonWorkbench.core.geometry.vectors import perpendicular
from BalloonWorkbench.core.options.pattern import MOST_COPIES
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.pattern.intake.kinds import IntakePiece, intake_kind, measure, placed
from BalloonWorkbench.core.pattern.label import lettering
from BalloonWorkbench.core.pattern.layout import SPACING, in_rows
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role
from BalloonWorkbench.core.pattern.placement import back_of
from BalloonWorkbench.core.pattern.shapes import closed_loop
from BalloonWorkbench.core.units import from_mm

#: Height of the label on a piece [m].
_LETTERS = from_mm(3.0)


def on_sheet(pattern: Pattern, mirror: bool, copies: int) -> Pattern:
    """A panel with all that is cut beside it, as often as it is wanted.

    mirror  the second panel beside the first, mirrored; else the sheet is cut twice. Where the front panel
            has lines of its own, as for a nozzle, both are always there
    Pieces on another film lie beside all panels, those of every balloon.
    Raises InputError for a number of copies that makes no sense.
    """
    if not 1 <= copies <= MOST_COPIES:
        raise InputError(f"There can be 1 to {MOST_COPIES} copies, not {copies}.")
    front = [contour for contour in pattern.contours if contour.front]
    both = mirror or bool(front)
    pieces = intake_pieces(pattern)
    made = _with_pieces(pattern, [piece for piece in pieces if not piece[0].stock])
    if both:
        made = _beside(made, _mirrored(pattern))
    if front and not mirror:
        remark = "Both panels are on the sheet: only the front one gets the hole of the nozzle. Cut it once."
        made = replace(made, warnings=(*made.warnings, remark))
    if copies > 1:
        made = repeated(made, copies)
    if any(piece[0].stock for piece in pieces):
        made = replace(made, warnings=(*made.warnings, *of_other_film(pattern)))
    others = [piece for piece in pieces if piece[0].stock] * copies
    return _beside(made, _in_rows(pattern, others)) if others else made


def repeated(pattern: Pattern, copies: int) -> Pattern:
    """So many of it in rows; the first one stays in its place."""
    shifts = in_rows([pattern.bounds] * copies)
    contours = [contour for shift in shifts for contour in pattern.moved(shift - shifts[0]).contours]
    sheet = replace(pattern, contours=tuple(contours), seam_length=copies * pattern.seam_length)
    return _in_order(sheet)


def _with_pieces(pattern: Pattern, pieces: Sequence[list[Contour]]) -> Pattern:
    """The panel, and to its right pieces of the same film, one above the other."""
    low, high = pattern.bounds
    x, y = float(high[0]) + SPACING, float(low[1])
    laid: list[Contour] = []
    for piece in pieces:
        points = np.concatenate([line.points for line in piece])
        shift = np.array([x, y]) - points.min(axis=0)
        laid += [replace(line, points=line.points + shift) for line in piece]
        y += float(np.ptp(points[:, 1])) + SPACING
    return replace(pattern, contours=(*laid, *pattern.contours))


def of_other_film(pattern: Pattern) -> list[str]:
    """What to say about pieces that are not cut from the balloon's film."""
    kinds = {intake.kind: intake_kind(intake.kind) for intake in pattern.intakes}
    return [
        f'The pieces of the intake "{kind.title}" are cut from {kind.stock.title}: they have a file of their'
        " own, with all of them for each balloon."
        for kind in kinds.values()
        if kind.stock is not None
    ]


def _in_rows(pattern: Pattern, pieces: Sequence[list[Contour]]) -> Pattern:
    """Pieces of another film than the pattern's, as a pattern of their own."""
    points = [np.concatenate([line.points for line in piece]) for piece in pieces]
    shifts = in_rows([bounds(each) for each in points])
    laid = [
        replace(line, points=line.points + shift)
        for piece, shift in zip(pieces, shifts, strict=True)
        for line in piece
    ]
    return replace(pattern, contours=tuple(laid), intake=None, more_intakes=(), seam_length=0.0)


def intake_pieces(pattern: Pattern) -> list[list[Contour]]:
    """The lines of each piece that the pattern's intakes need beside the panels."""
    pieces = []
    for intake in pattern.intakes:
        kind = intake_kind(intake.kind)
        sizes = {"L": intake.length, "W": intake.width, "S": pattern.seal_width}
        stock = "" if kind.stock is None else kind.stock.name
        for piece in kind.pieces:
            pieces.append([replace(line, stock=stock) for line in _drawn(piece, sizes)])
    return pieces


def _drawn(piece: IntakePiece, sizes: Mapping[str, float]) -> list[Contour]:
    """A piece with its label, its axis upward."""
    upward = 0.5 * np.pi
    lines = [_begun(placed(stroke.drawn(sizes), np.zeros(2), upward)) for stroke in piece.strokes]
    at = np.array([measure(text, sizes) for text in piece.label_at])
    middle = perpendicular(at)
    text = lettering(piece.label, _LETTERS, middle)
    long = np.ptp(lines[-1].points, axis=0)
    if long[1] > 2.0 * long[0]:  # a strip: the text runs along it
        text = tuple(placed(replace(line, points=line.points - middle), middle, upward) for line in text)
    return [*text, *lines]


def _begun(line: Contour) -> Contour:
    """A closed line begun amid an edge, where a machine may begin."""
    if not line.closed:
        return line
    return replace(line, points=closed_loop(shapely().LinearRing(line.points), line.role is Role.CUT))


def _mirrored(pattern: Pattern) -> Pattern:
    """The back panel, turned over in its place."""
    low, high = pattern.bounds
    return back_of(pattern).moved(np.array([low[0] + high[0], 0.0]))


def _beside(first: Pattern, second: Pattern) -> Pattern:
    """Two panels side by side, as one pattern with the first one's intakes."""
    shift = np.array([first.bounds[1][0] + SPACING - second.bounds[0][0], 0.0])
    contours = (*first.contours, *second.moved(shift).contours)
    return _in_order(replace(first, contours=contours))


def _in_order(pattern: Pattern) -> Pattern:
    """Inner lines before the outer cuts."""
    ranks = {role: rank for rank, role in enumerate(Role)}
    return replace(pattern, contours=tuple(sorted(pattern.contours, key=lambda contour: ranks[contour.role])))

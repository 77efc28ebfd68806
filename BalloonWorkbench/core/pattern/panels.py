# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the pattern of one panel to all that lies on the sheet: pieces of the intake, second panel, copies."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.pattern.intake_kinds import Piece, intake_kind, measure, placed
from BalloonWorkbench.core.pattern.label import lettering
from BalloonWorkbench.core.pattern.layout import SPACING, in_rows
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role
from BalloonWorkbench.core.pattern.shapes import closed_loop
from BalloonWorkbench.core.units import from_mm

MOST_COPIES = 100
#: Height of the label on a piece [m].
_LETTERS = from_mm(3.0)
#: Lines on which a second panel is measured and mirrored but not turned over: text stays readable.
_TEXT = (Role.ENGRAVE, Role.PRINT)


def on_sheet(pattern: Pattern, allowance: float, mirror: bool, copies: int) -> Pattern:
    """A panel with all that is cut beside it, as often as it is wanted.

    allowance  the one with which the pattern was built [m]
    mirror     the second panel beside the first, mirrored; else the sheet is cut twice. Where the front panel
               has lines of its own, as for a nozzle, both are always there
    Raises InputError for a number of copies that makes no sense.
    """
    if not 1 <= copies <= MOST_COPIES:
        raise InputError(f"There can be 1 to {MOST_COPIES} copies, not {copies}.")
    front = [contour for contour in pattern.contours if contour.front]
    both = mirror or bool(front)
    made = _with_pieces(pattern, allowance, second=False)
    if both:
        made = _beside(made, _with_pieces(_mirrored(pattern), allowance, second=True))
    if front and not mirror:
        told = "Both panels are on the sheet: only the front one gets the hole of the nozzle. Cut it once."
        made = replace(made, warnings=(*made.warnings, told))
    return made if copies == 1 else _repeated(made, copies)


def _repeated(pattern: Pattern, copies: int) -> Pattern:
    """So many of it in rows; the first one stays in its place."""
    shifts = in_rows([pattern.bounds] * copies)
    contours = [contour for shift in shifts for contour in pattern.moved(shift - shifts[0]).contours]
    sheet = replace(pattern, contours=tuple(contours), seam_length=copies * pattern.seam_length)
    return _in_order(sheet)


def _with_pieces(pattern: Pattern, allowance: float, second: bool) -> Pattern:
    """The panel, and to its right the pieces of its intakes; beside a second one none of the front's."""
    pieces: list[Contour] = []
    low, high = pattern.bounds
    x, y = float(high[0]) + SPACING, float(low[1])
    for intake in pattern.intakes:
        sizes = {"L": intake.length, "W": intake.width, "S": pattern.seal_width, "A": allowance}
        for piece in intake_kind(intake.kind).pieces:
            if second and not piece.each_panel:
                continue
            drawn = _drawn(piece, sizes)
            points = np.concatenate([line.points for line in drawn])
            shift = np.array([x, y]) - points.min(axis=0)
            pieces += [replace(line, points=line.points + shift) for line in drawn]
            y += float(np.ptp(points[:, 1])) + SPACING
    return replace(pattern, contours=(*pieces, *pattern.contours))


def _drawn(piece: Piece, sizes: Mapping[str, float]) -> list[Contour]:
    """A piece with its label, its axis upward."""
    upward = 0.5 * np.pi
    lines = [_begun(placed(stroke.drawn(sizes), np.zeros(2), upward)) for stroke in piece.strokes]
    at = np.array([measure(text, sizes) for text in piece.label_at])
    middle = np.array([-at[1], at[0]])
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
    """The back panel: without what only the front has, turned over left to right; text keeps its sense."""
    axis = float(0.5 * (pattern.bounds[0][0] + pattern.bounds[1][0]))
    text = [contour.points for contour in pattern.contours if contour.role in _TEXT]
    ends = np.concatenate(text)[:, 0] if text else np.array([axis])
    shift = np.array([2.0 * axis - ends.min() - ends.max(), 0.0])

    def turned(contour: Contour) -> Contour:
        if contour.role in _TEXT:
            return replace(contour, points=contour.points + shift)
        points = np.stack([2.0 * axis - contour.points[:, 0], contour.points[:, 1]], axis=1)
        # closed lines keep their sense of turning
        return replace(contour, points=points[::-1] if contour.closed else points)

    return replace(
        pattern, contours=tuple(turned(contour) for contour in pattern.contours if not contour.front)
    )


def _beside(first: Pattern, second: Pattern) -> Pattern:
    """Two panels side by side, as one pattern with the first one's intakes."""
    shift = np.array([first.bounds[1][0] + SPACING - second.bounds[0][0], 0.0])
    contours = (*first.contours, *second.moved(shift).contours)
    return _in_order(replace(first, contours=contours))


def _in_order(pattern: Pattern) -> Pattern:
    """Inner lines before the outer cuts."""
    ranks = {role: rank for rank, role in enumerate(Role)}
    return replace(pattern, contours=tuple(sorted(pattern.contours, key=lambda contour: ranks[contour.role])))

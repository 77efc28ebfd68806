# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pattern laid elsewhere: mirrored, turned, moved."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from BalloonWorkbench.core.geometry.polyline import bounds, length
from BalloonWorkbench.core.geometry.vectors import rotation
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.pattern.pattern import Contour, Intake, Pattern, Role
from BalloonWorkbench.core.types import Floats

_HAIR = 1e-6  # m; a cut lies on its own film


def back_of(pattern: Pattern) -> Pattern:
    """The back panel: mirrored about the y axis, without what only the front has.

    Closed loops keep their sense, and a label stays readable.
    """
    flip = np.array([-1.0, 1.0])
    text = [contour.points[:, 0] for contour in pattern.contours if contour.role is Role.ENGRAVE]
    ends = np.concatenate(text) if text else np.zeros(1)
    beside = np.array([-float(ends.min() + ends.max()), 0.0])

    def laid(contour: Contour) -> Contour:
        if contour.role is Role.ENGRAVE:
            return replace(contour, points=contour.points + beside)
        return replace(contour, points=reversed_points(contour, contour.points * flip))

    return replace(
        pattern,
        contours=tuple(laid(contour) for contour in pattern.contours if not contour.front),
        intake=None if pattern.intake is None else _mirrored(pattern.intake),
        more_intakes=tuple(_mirrored(intake) for intake in pattern.more_intakes),
        film=None,
        page=None if pattern.page is None else bounds(np.array(pattern.page) * flip),
    )


def reversed_points(contour: Contour, points: Floats) -> Floats:
    """Run through the other way; a closed one from the same point on."""
    return np.concatenate([points[:1], points[:0:-1]]) if contour.closed else points[::-1]


def _mirrored(intake: Intake) -> Intake:
    return replace(intake, at=intake.at * (-1.0, 1.0), angle=float(np.pi - intake.angle))


def split(pattern: Pattern) -> list[Pattern]:
    """The pieces of film that a pattern consists of: each outer cut with all lines inside it."""
    package = shapely()
    films = [package.Polygon(cut.points).buffer(_HAIR) for cut in pattern.of(Role.CUT)]
    owned: list[list[Contour]] = [[] for _ in films]
    for contour in pattern.contours:
        at = package.Point(contour.points[len(contour.points) // 2])
        for film, lines in zip(films, owned):
            if film.contains(at):
                lines.append(contour)
                break
    return [
        replace(
            pattern,
            contours=tuple(lines),
            intake=None,
            more_intakes=(),
            seam_length=_seams(lines),
            film=None,
            page=None,
        )
        for lines in owned
    ]


def _seams(lines: list[Contour]) -> float:
    return float(sum(length(seal.line) for seal in lines if seal.role is Role.SEAL))


def turned(pattern: Pattern, angle: float, shift: Floats) -> Pattern:
    """The pattern turned about the origin by an angle [rad], then moved by a shift (2,) m."""
    turn = rotation(angle)

    def moved(intake: Intake) -> Intake:
        return replace(intake, at=intake.at @ turn + shift, angle=intake.angle + angle)

    return replace(
        pattern,
        contours=tuple(
            replace(contour, points=contour.points @ turn + shift) for contour in pattern.contours
        ),
        intake=None if pattern.intake is None else moved(pattern.intake),
        more_intakes=tuple(moved(intake) for intake in pattern.more_intakes),
        film=None,
        page=None if pattern.page is None else bounds(_corners(pattern.page) @ turn + shift),
    )


def _corners(page: tuple[Floats, Floats]) -> Floats:
    """All four corners of a page (4, 2) m."""
    (left, bottom), (right, top) = page
    return np.array([(left, bottom), (right, bottom), (right, top), (left, top)])

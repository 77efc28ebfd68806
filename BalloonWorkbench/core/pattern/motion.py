# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pattern laid elsewhere: mirrored, turned, moved."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from BalloonWorkbench.core.pattern.pattern import Contour, Intake, Pattern
from BalloonWorkbench.core.types import Floats


def back_of(pattern: Pattern) -> Pattern:
    """The back panel: mirrored about the y axis, without what only the front has; closed loops keep their
    sense."""
    flip = np.array([-1.0, 1.0])
    return replace(
        pattern,
        contours=tuple(
            replace(contour, points=_kept_sense(contour, contour.points * flip))
            for contour in pattern.contours
            if not contour.front
        ),
        intake=None if pattern.intake is None else _mirrored(pattern.intake),
        more_intakes=tuple(_mirrored(intake) for intake in pattern.more_intakes),
    )


def _kept_sense(contour: Contour, points: Floats) -> Floats:
    """Run through the other way; a closed one from the same point on."""
    return np.concatenate([points[:1], points[:0:-1]]) if contour.closed else points[::-1]


def _mirrored(intake: Intake) -> Intake:
    return replace(intake, at=intake.at * (-1.0, 1.0), angle=float(np.pi - intake.angle))


def turned(pattern: Pattern, angle: float, shift: Floats) -> Pattern:
    """The pattern turned about the origin by an angle [rad], counter-clockwise, then moved by a shift (2,) m.

    Quarter turns are exact.
    """
    quarters = angle / (0.5 * np.pi)
    if abs(quarters - round(quarters)) < 1e-9:
        cosine, sine = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[round(quarters) % 4]
    else:
        cosine, sine = float(np.cos(angle)), float(np.sin(angle))
    turn = np.array([[cosine, sine], [-sine, cosine]])

    def moved(intake: Intake) -> Intake:
        return replace(intake, at=intake.at @ turn + shift, angle=intake.angle + angle)

    return replace(
        pattern,
        contours=tuple(
            replace(contour, points=contour.points @ turn + shift) for contour in pattern.contours
        ),
        intake=None if pattern.intake is None else moved(pattern.intake),
        more_intakes=tuple(moved(intake) for intake in pattern.more_intakes),
    )

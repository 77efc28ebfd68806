# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pattern: contours with a meaning, ready for a cutter."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from BalloonWorkbench.core.types import Floats


class Role(str, Enum):
    """What a machine does along a contour; the value is the layer's name."""

    CUT = "CUT"
    CUT_INNER = "CUT_INNER"
    SEAL = "SEAL"


@dataclass(frozen=True)
class Contour:
    """A polyline with a role: points (n, 2) m, the first point not repeated when closed."""

    role: Role
    points: Floats
    closed: bool


@dataclass(frozen=True)
class Intake:
    """The neck through which the balloon is filled.

    at     (2,) m, the middle of its root on the seam
    angle  direction in which it points, counter-clockwise from +x [rad]
    width  inner width [m]
    length from the seam outward [m]
    """

    at: Floats
    angle: float
    width: float
    length: float


@dataclass(frozen=True)
class Pattern:
    """One panel of the balloon as contours; cut two.

    contours      inner ones (holes) first, the outer CUT last
    seam_length   m, length of the weld of all loops, intake mouth excluded
    """

    contours: tuple[Contour, ...]
    intake: Intake | None
    seal_width: float
    seam_length: float

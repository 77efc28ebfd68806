# SPDX-License-Identifier: LGPL-2.1-or-later
"""Advice: findings with a place, a sentence, a severity and perhaps a repair."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from BalloonWorkbench.core.types import Floats, Ints


class Severity(str, Enum):
    """How much a finding matters, in rising order."""

    HINT = "hint"  # looks a little different
    WARNING = "warning"  # a part does not do what was drawn
    SERIOUS = "serious"  # the balloon may not fill or not hold

    @property
    def rank(self) -> int:
        """0 for a hint, 2 for the worst."""
        return list(Severity).index(self)


class RepairKind(str, Enum):
    """What a repair does."""

    ROUND = "round"  # a corner or notch, with a radius
    WIDEN = "widen"  # an arm or neck, to a width
    MOVE_INTAKE = "move intake"  # to another place of the outline
    LOWER_INTAKE = "lower intake"  # to the lowest place that has room for it

    @property
    def is_of_intake(self) -> bool:
        """It changes the pattern, not the outline."""
        return self in (RepairKind.MOVE_INTAKE, RepairKind.LOWER_INTAKE)


@dataclass(frozen=True)
class Repair:
    """An edit that would help.

    points  (k, 2) m: the corner; the middle line of the part to be widened; where the intake shall sit
    size    m, radius or wanted width; for an intake to be moved its direction from the centre [rad]
    was     m, present width of a part to be widened
    """

    kind: RepairKind
    points: Floats
    size: float
    was: float = 0.0


@dataclass(frozen=True)
class Finding:
    """One piece of advice.

    rule      its name in resources/advice/rules.json; of many panels that in bag_advice.py
    place     (x, y) m, in the drawing; of many panels (x, y, z) m, on the balloon
    extent    stretches (k, 2) m of the outline, or lines across the shape, that it is about
    measured  what was found on the balloon, and `limit` what it was compared with, in the rule's own unit
    """

    rule: str
    severity: Severity
    text: str
    place: tuple[float, ...]
    extent: tuple[Floats, ...]
    measured: float
    limit: float
    repair: Repair | None = None


@dataclass(frozen=True)
class ThicknessMap:
    """Thickness of the balloon over the drawing.

    points     (n, 2) m, in the drawing
    triangles  (m, 3) between them
    thickness  (n,) m
    """

    points: Floats
    triangles: Ints
    thickness: Floats


@dataclass(frozen=True)
class Advice:
    """All findings about a shape.

    relative_volume  V / A^1.5 relative to a disc's, A the area of one panel: 1 is as round as film can be
    findings   the worst first
    inflated   measured on the finished balloon; else on a coarse one of the first pattern
    """

    relative_volume: float
    findings: tuple[Finding, ...]
    map: ThicknessMap
    inflated: bool

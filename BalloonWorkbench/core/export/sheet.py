# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sheet that a cutter gets: millimetres, origin at the lower left, a colour for each layer."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.pattern.pattern import Pattern, Role
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import to_mm

#: Finer than any machine, coarse enough for short and repeatable numbers [digits after the millimetre].
DIGITS = 4


@dataclass(frozen=True)
class Layer:
    """How a role is drawn: AutoCAD colour index and RGB. Cutters go by the name or by one of the colours."""

    aci: int
    rgb: str


LAYERS = {
    Role.CUT: Layer(1, "#ff0000"),
    Role.CUT_INNER: Layer(5, "#0000ff"),
    Role.SEAL: Layer(6, "#ff00ff"),
    Role.WELD: Layer(3, "#00a000"),
    Role.MARK: Layer(30, "#ff8000"),
    Role.ENGRAVE: Layer(7, "#000000"),
    Role.PRINT: Layer(8, "#808080"),
    Role.REGISTRATION: Layer(4, "#00ffff"),
}


@dataclass(frozen=True)
class Path:
    """A polyline on the sheet: points (n, 2) mm, the first not repeated when closed."""

    role: Role
    points: Floats
    closed: bool


@dataclass(frozen=True)
class Sheet:
    """Paths in the order in which they are to be cut, and the sheet's size [mm]."""

    paths: tuple[Path, ...]
    width: float
    height: float

    def of(self, role: Role) -> tuple[Path, ...]:
        """The paths of one role."""
        return tuple(path for path in self.paths if path.role is role)


def lay_out(pattern: Pattern) -> Sheet:
    """The pattern with its lower left corner at the origin."""
    low, _ = pattern.bounds
    paths = tuple(
        Path(contour.role, np.round(to_mm(contour.points - low), DIGITS) + 0.0, contour.closed)
        for role in pattern.roles
        for contour in pattern.of(role)
    )
    width, height = np.concatenate([path.points for path in paths]).max(axis=0)
    return Sheet(paths, float(width), float(height))

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hydrostatic pressure: in a tall balloon whose gas is lighter than the air the overpressure grows upwards.

Over the height of the vertices that hold the balloon it is the pressure p of the solve plus gradient times
the height. Its energy is - (integral over the inside of p + gradient (z - z_held)), so it has a potential as
an even pressure has, and pulls at what holds the balloon with gradient times the volume.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.panels.assembly import Assembly
from BalloonWorkbench.core.solver.problem import FilmProblem
from BalloonWorkbench.core.solver.split_along_welds import SplitFilm
from BalloonWorkbench.core.types import Floats, Ints


@dataclass(frozen=True)
class Lift:
    """How the pressure grows upwards, along z, and what holds the balloon.

    gradient  [Pa/m], of the overpressure: that of the densities times g
    held      (k,) vertices of the assembly that stay where the start has them, usually at the lower end
    """

    gradient: float
    held: Ints

    def check(self, assembly: Assembly) -> None:
        """Raises InputError where it does not suit an assembly."""
        if assembly.mirror:
            raise InputError("Two equal panels lie flat and have no lower end. Give lift to a standing body.")
        if not np.isfinite(self.gradient) or self.gradient < 0.0:
            raise InputError("The pressure must grow upwards: give a gradient of 0 or more.")
        known = np.isin(self.held, np.arange(assembly.offsets[-1]))
        if not len(self.held) or not known.all():
            raise InputError("Lift needs vertices of the balloon that hold it. Give those of its lower end.")

    def places(self, split: SplitFilm) -> Ints:
        """All vertices of the split film that share a place with one that is held."""
        own = split.own[self.held]
        if split.tied is None:
            return np.unique(own)
        return np.flatnonzero(np.isin(split.tied, split.tied[own])).astype(np.int32)


def characteristic_pressure(pressure: float, lift: Lift | None, size: float) -> float:
    """The pressure [Pa] that makes the problem of a body of a size [m] dimensionless."""
    return pressure + (0.0 if lift is None else lift.gradient * size)


def with_lift(
    problem: FilmProblem, split: SplitFilm, pressure: float, lift: Lift, positions: Floats
) -> FilmProblem:
    """The problem with hydrostatic pressure, held where it is at positions (n, 3) in units of the size."""
    size = split.assembly.size
    scale = characteristic_pressure(pressure, lift, size)
    held = lift.places(split)
    fixed = problem.fixed.copy()
    fixed[held, :3] = True
    gradient = lift.gradient * size / scale
    below = float(positions[held, 2].mean())
    return replace(problem, fixed=fixed, pressure=pressure / scale - gradient * below, gradient=gradient)


def upright(positions: Floats, held: Ints) -> Floats:
    """Positions (n, 3) turned so that what is held is straight below the middle of the rest."""
    foot = positions[held].mean(axis=0)
    up = positions.mean(axis=0) - foot
    height = np.linalg.norm(up)
    if not height > 0.0:
        return positions
    across = np.eye(3)[np.argmin(np.abs(up))]
    third = up / height
    first = np.cross(across, third)
    first /= np.linalg.norm(first)
    return np.asarray((positions - foot) @ np.stack([first, np.cross(third, first), third], axis=1))

# SPDX-License-Identifier: LGPL-2.1-or-later
"""What both solvers are given and what they give back.

The numbers are dimensionless: lengths in units of the panel's size L, the pressure (where there is one)
is 1, energies are in units of p L^3. The material is then k = E t / (p L), D / (p L^3) and, for the sealed
band, E I / (p L^4).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.solver.element.membrane import (
    MembraneResponse,
    plane_stress,
    tension_field,
    without_wrinkles,
)
from BalloonWorkbench.core.solver.element.orthotropic import Grain, orthotropic_tension_field
from BalloonWorkbench.core.types import Bools, Floats, Ints


@dataclass(frozen=True)
class FilmProblem:
    """A film with its supports and loads.

    rest_positions (n, 2), triangles (m, 3); fixed (n, 5) True where x, y, z or one of the two turns of the
    director is held; loads (n, 3) or None; hinges (h, 3) of the sealed band, see seam_band.py, with its E I
    at each of them; in_space: the seams do not stay in one plane, see space_band.py. A grain makes the film
    orthotropic; tension_field False makes it a plain shell, which carries compression. tied (n,): the vertex,
    itself or one before it, whose position a vertex shares; each keeps its own director, so that the film can
    fold there. The pressure at z is pressure + gradient z.
    """

    rest_positions: Floats
    triangles: Ints
    fixed: Bools
    membrane_stiffness: float
    poisson_ratio: float
    flexural_rigidity: float
    pressure: float = 1.0
    loads: Floats | None = None
    hinges: Ints | None = None
    hinge_rigidities: Floats | None = None
    grain: Grain | None = None
    tension_field: bool = True
    tied: Ints | None = None
    in_space: bool = False
    gradient: float = 0.0

    def membrane(self, strain: Floats) -> MembraneResponse:
        """Response of the film to Green strains (m, 3)."""
        if not self.tension_field:
            return without_wrinkles(strain, self.taut_stiffness)
        if self.grain is None:
            return tension_field(strain, self.poisson_ratio)
        return orthotropic_tension_field(strain, self.grain)

    @property
    def taut_stiffness(self) -> Floats:
        """Stiffness (3, 3) of taut film from E11, E22, 2 E12 to S11, S22, S12, in units of E t."""
        if self.grain is None:
            return plane_stress(self.poisson_ratio)
        turn = self.grain.turn
        return np.asarray(turn.T @ self.grain.stiffness @ turn)


@dataclass(frozen=True)
class Energies:
    """Parts of the total energy."""

    membrane: float
    bending: float
    pressure: float  # - the integral of the pressure over the inside
    load: float
    seam: float

    @property
    def total(self) -> float:
        """What the film minimises."""
        return self.membrane + self.bending + self.pressure + self.load + self.seam


@dataclass(frozen=True)
class Start:
    """Where a solve begins: positions (n, 3), directors (n, 3).

    levels  membrane stiffnesses that it goes through, the film's own last
    """

    positions: Floats
    directors: Floats
    levels: tuple[float, ...]


@dataclass(frozen=True)
class NewtonSettings:
    """When Newton's method stops.

    tolerance   converged when a step would lower the energy by less than this part of it, or when two steps
    in a row left its outline and its volume as they were; less for a stiff film (convergence.py)
    max_steps   over all stiffness levels; the best state is kept when they are used up
    """

    tolerance: float = 1e-5
    max_steps: int = 150


@dataclass(frozen=True)
class Equilibrium:
    """Where the solver came to rest: positions (n, 3), directors (n, 3)."""

    positions: Floats
    directors: Floats
    steps: int
    factorisations: int
    converged: bool


@dataclass(frozen=True)
class TangentSolution:
    """How a film at rest gives way to small loads: the changes (n, 3, k) of its positions.

    exact  with the exact Hessian; else with the one that Newton's method takes, which is definite
    """

    changes: Floats
    exact: bool

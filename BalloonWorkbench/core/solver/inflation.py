# SPDX-License-Identifier: LGPL-2.1-or-later
"""The inflated balloon: the result of the simulation."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.panels.assembly import Assembly
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.solver.lift import Lift, characteristic_pressure
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.types import Floats

#: The lower half is the upper one mirrored in the plane of the seam.
MIRROR = np.array([1.0, 1.0, -1.0])


@dataclass(frozen=True)
class SolveReport:
    """What was solved and how it went."""

    backend: str  # "native", "numpy" or "newmark"
    newton_steps: int
    factorisations: int
    seconds: float
    converged: bool
    stiffness_k: float  # E t / (p L), L the larger dimension of the largest panel
    flexural_rigidity: float  # used in the simulation [N m]; the film's own where that is above the floor
    bending_share: float  # energy of bending, relative to the work of the pressure
    pressure: float  # [Pa]; with lift that at the height of what holds the balloon
    model: Model
    banded: bool = False  # the seams carried the stiffness of a sealed band
    lift: Lift | None = None  # what makes the pressure grow upwards


@dataclass(frozen=True)
class Inflation:
    """An inflated balloon; of a mirrored panel the upper half.

    The lower half is the upper one mirrored in z = 0, unless it is given.

    positions  (n, 3) m, one per vertex of the panels in a row; seams of a mirrored panel lie in z = 0
    directors  (n, 3) unit normals of the film at the vertices
    tensions   (m, 2) N/m, larger and smaller principal membrane tension of each triangle
    volume     m3, of the whole balloon; a little more than its facets enclose (kinematics.film_volume)
    lower      (n, 3) m, positions of the lower panel where both were simulated
    """

    assembly: Assembly
    positions: Floats
    directors: Floats
    tensions: Floats
    volume: float
    report: SolveReport
    lower: Floats | None = None

    @property
    def panel(self) -> Panel:
        """The panel that was mirrored; the first one of others."""
        return self.assembly.panels[0]

    @property
    def foot(self) -> float:
        """Height [m] at which the pressure is that of the report: of what holds the balloon, else 0."""
        lift = self.report.lift
        return 0.0 if lift is None or not len(lift.held) else float(self.positions[lift.held, 2].mean())

    def pressures(self, heights: Floats) -> Floats:
        """The overpressure [Pa] at heights (k,) [m]."""
        lift = self.report.lift
        growth = 0.0 if lift is None else lift.gradient * (heights - self.foot)
        return np.asarray(self.report.pressure + growth + np.zeros_like(heights))

    @property
    def largest_pressure(self) -> float:
        """The overpressure [Pa] where it is largest: at the top where it grows upwards."""
        return float(self.pressures(self.positions[:, 2]).max())

    @property
    def characteristic_pressure(self) -> float:
        """What made the problem dimensionless [Pa]: the pressure, and with lift what it grows by."""
        return characteristic_pressure(self.report.pressure, self.report.lift, self.assembly.size)

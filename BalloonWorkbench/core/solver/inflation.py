# SPDX-License-Identifier: LGPL-2.1-or-later
"""The inflated balloon: the result of the simulation."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.panels.assembly import Assembly
from BalloonWorkbench.core.panels.panel import Panel
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
    pressure: float  # [Pa]
    model: Model
    banded: bool = False  # the seams carried the stiffness of a sealed band


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

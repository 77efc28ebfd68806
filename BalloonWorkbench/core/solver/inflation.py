# SPDX-License-Identifier: LGPL-2.1-or-later
"""The inflated balloon: the result of the simulation."""

from __future__ import annotations

from dataclasses import dataclass

from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.types import Floats


@dataclass(frozen=True)
class SolveReport:
    """What was solved and how it went."""

    backend: str  # "native", "numpy" or "newmark"
    newton_steps: int
    factorisations: int
    seconds: float
    converged: bool
    stiffness_k: float  # E t / (p L), L the larger dimension of the panel
    flexural_rigidity: float  # used in the simulation [N m]; the film's own where that is above the floor
    bending_share: float  # energy of bending, relative to the work of the pressure
    pressure: float  # [Pa]
    model: Model


@dataclass(frozen=True)
class Inflation:
    """The upper half of an inflated balloon; the lower half is its mirror image in z = 0, unless it is given.

    positions  (n, 3) m, one per vertex of the panel; the seams lie in z = 0
    directors  (n, 3) unit normals of the film at the vertices
    tensions   (m, 2) N/m, larger and smaller principal membrane tension of each triangle
    volume     m3, of the whole balloon; a little more than its facets enclose (kinematics.film_volume)
    lower      (n, 3) m, positions of the lower panel where both were simulated
    """

    panel: Panel
    positions: Floats
    directors: Floats
    tensions: Floats
    volume: float
    report: SolveReport
    lower: Floats | None = None

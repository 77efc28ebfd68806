# SPDX-License-Identifier: LGPL-2.1-or-later
"""One iterate of a divided target: its panels are meshed, inflated and laid over the target."""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from BalloonWorkbench.core.bags.bag import Bag
from BalloonWorkbench.core.bags.mesh_bag import MeshedBag, mesh_bag
from BalloonWorkbench.core.design.design import Residual
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.flattening.bag_of import FlatBody
from BalloonWorkbench.core.geometry.triangulation import Located
from BalloonWorkbench.core.mesh.quality import flipped, worn
from BalloonWorkbench.core.panels.surface import Surface
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.target_design.aim import Aim
from BalloonWorkbench.core.target_design.curved_film import curved_film
from BalloonWorkbench.core.target_design.off_target import (
    OffTarget,
    TargetSurface,
    target_residual,
    vertex_areas,
)
from BalloonWorkbench.core.types import Floats, Progress, no_progress


@dataclass(frozen=True)
class TargetSimulation:
    """How the panels of a divided target are simulated, and what their balloon is compared with.

    pressure [Pa]
    """

    body: FlatBody
    surface: TargetSurface
    film: Film
    pressure: float
    backend: str | None = None
    model: Model | None = None
    progress: Progress = no_progress


@dataclass(frozen=True)
class TargetIterate:
    """A pattern and its balloon, laid over the target.

    weights  (n,) roots of the areas of the vertices, in parts of the whole
    off      how far they are from the target
    """

    meshed: MeshedBag
    inflation: Inflation
    weights: Floats
    off: OffTarget

    @property
    def bag(self) -> Bag:
        """The pattern."""
        return self.meshed.bag

    @property
    def positions(self) -> Floats:
        """Those of the balloon (n, 3) m."""
        return self.inflation.positions

    def error(self, aim: Aim) -> float:
        """Mean distance from the surface that is wanted [m], as the aim counts it."""
        return aim.cost(self.weights, self.off.distances)

    def residual(self, surface: TargetSurface) -> Residual:
        """How far the film is from the target [m]."""
        inflation = self.inflation
        return target_residual(surface, *curved_film(self.positions, inflation.directors, self.surface))

    @property
    def surface(self) -> Surface:
        """The panels' triangles, and which of their vertices are one."""
        return self.meshed.assembly.surface


def make_target_iterate(
    simulation: TargetSimulation, meshed: MeshedBag, start: Floats | None = None
) -> TargetIterate:
    """The balloon of a mesh, from places (n, 3) m of its vertices, or from the target. Raises as inflate."""
    inflation = inflate(
        meshed.assembly,
        simulation.film,
        simulation.pressure,
        start=simulation.body.on_target(meshed) if start is None else start,
        backend=simulation.backend,
        model=simulation.model,
        progress=simulation.progress,
    )
    areas = vertex_areas(inflation.positions, meshed.assembly.surface.triangles)
    weights = np.sqrt(areas / areas.sum())
    positions, turn, off = simulation.surface.laid_over(inflation.positions, weights)
    inflation = replace(inflation, positions=positions, directors=inflation.directors @ turn)
    return TargetIterate(meshed, inflation, weights, off)


def next_iterate(simulation: TargetSimulation, last: TargetIterate, bag: Bag, edge: float) -> TargetIterate:
    """The balloon of a pattern whose points have moved, on the moved mesh as long as its triangles are good.

    edge  [m] of a mesh made anew. Raises as mesh_bag and inflate do.
    """
    moved = last.meshed.with_bag(bag)
    if not any((flipped(panel) | worn(panel)).any() for panel in moved.assembly.panels):
        return make_target_iterate(simulation, moved, last.positions)
    meshed = mesh_bag(bag, edge)
    return make_target_iterate(simulation, meshed, _carried(last, meshed))


def _carried(last: TargetIterate, meshed: MeshedBag) -> Floats:
    """Positions (n, 3) m of the last balloon at the vertices of the mesh of a bag whose points have moved."""
    parts = []
    for number, (low, high) in enumerate(pairwise(last.meshed.assembly.offsets)):
        before = last.meshed.assembly.panels[number]
        places = meshed.weights[number] @ np.concatenate(last.bag.panels[number].loops)
        parts.append(
            Located(before.rest_positions, before.triangles).values(last.positions[low:high], places)
        )
    return np.concatenate(parts)

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
from BalloonWorkbench.core.target_design.curved_film import curved_film, sides
from BalloonWorkbench.core.target_design.off_target import (
    FilmAway,
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

    areas      (n,) of the vertices, in parts of the whole
    off        how far they are from the target
    film_away  how far the film is from some samples of the target
    parts      (k,) of the target's whole area round these
    """

    meshed: MeshedBag
    inflation: Inflation
    areas: Floats
    off: OffTarget
    film_away: FilmAway
    parts: Floats

    @property
    def distances(self) -> Floats:
        """Both ways (n + k,) m: of the film from the target, and of samples of the target from the film."""
        return np.concatenate([self.off.distances, self.film_away.off.distances])

    @property
    def weights(self) -> Floats:
        """Roots (n + k,) of the parts that the distances have in their mean; each way has one half."""
        return np.sqrt(0.5 * np.concatenate([self.areas, self.parts]))

    def follow(self, changes: Floats) -> Floats:
        """How the distances (n + k, size) follow values, for changes (n, 3, size) of the positions."""
        film = np.einsum("ni,nij->nj", self.off.directions, changes)
        return np.concatenate([film, self.film_away.follow(changes)])

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
        return aim.cost(self.weights, self.distances)

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
    film, surface = meshed.assembly.surface, simulation.surface
    areas = vertex_areas(inflation.positions, film.triangles)
    areas = areas / areas.sum()
    positions, turn, off = surface.laid_over(inflation.positions, np.sqrt(areas))
    inflation = replace(inflation, positions=positions, directors=inflation.directors @ turn)
    own = np.arange(len(positions), dtype=np.int32)
    ends = np.concatenate([np.column_stack([own, own]), sides(film)[0]])
    film_away = surface.film_away(*curved_film(positions, inflation.directors, film), ends)
    return TargetIterate(meshed, inflation, areas, off, film_away, surface.few_samples[1])


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

# SPDX-License-Identifier: LGPL-2.1-or-later
"""One iterate of the pattern correction: a pattern is meshed, inflated and laid over the drawing."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from BalloonWorkbench.core.correction.seam_map import SeamMap, SeamNodes, seam_nodes
from BalloonWorkbench.core.correction.transfer import transferred
from BalloonWorkbench.core.design.compare import Misfit, laid_on, laid_over, misfit
from BalloonWorkbench.core.design.silhouette import silhouette
from BalloonWorkbench.core.design.visible_seam import trimmed
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.mesh.halves import triangulate_mirrored
from BalloonWorkbench.core.mesh.reuse import move_rim
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.outline.symmetry import Mirror
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.solver.problem import NewtonSettings
from BalloonWorkbench.core.types import Progress, no_progress

_SLID = 0.5  # of the distance from the drawing


@dataclass(frozen=True)
class Simulation:
    """How a pattern is simulated, and what its balloon is compared with.

    edge         [m] of the mesh
    mirror       of a symmetric pattern
    newton       when the film is at rest; None: as usual
    """

    target: Outline
    film: Film
    pressure: float
    backend: str | None
    model: Model | None
    edge: float = 0.0
    mirror: Mirror | None = None
    newton: NewtonSettings | None = None
    progress: Progress = no_progress


@dataclass(frozen=True)
class Iterate:
    """A pattern and what it inflates to, placed over the drawing.

    nodes       the seam vertices along each loop of the seam map
    silhouette  the silhouette of the film that the facets stand for; misfit: how far it is from the drawing
    """

    seam_map: SeamMap
    panel: Panel
    nodes: tuple[SeamNodes, ...]
    inflation: Inflation
    silhouette: Outline
    misfit: Misfit


def make_iterate(
    simulation: Simulation, seam_map: SeamMap, last: Iterate | None = None, keep_mesh: bool = False
) -> Iterate:
    """Inflate the pattern of a seam map, starting from the last balloon.

    keep_mesh  on the last mesh, where that still serves; else the last balloon is transferred to a new one
    Raises as triangulate and inflate do.
    """
    panel = _moved(last, seam_map) if last is not None and keep_mesh else None
    start: Inflation | None
    if last is not None and panel is not None:
        nodes, start = last.nodes, last.inflation
    else:
        panel = _meshed(seam_map.outline, simulation)
        nodes = seam_nodes(seam_map, panel)
        start = None if last is None else transferred(last.inflation, panel)
    inflation = inflate(
        panel,
        simulation.film,
        simulation.pressure,
        start=start,
        backend=simulation.backend,
        model=simulation.model,
        progress=simulation.progress,
        settings=simulation.newton,
    )
    placed = _aligned(seam_map, nodes, inflation)
    return _as_seen(simulation.target, Iterate(seam_map, panel, nodes, *_compared(simulation.target, placed)))


def _compared(target: Outline, placed: Inflation) -> tuple[Inflation, Outline, Misfit]:
    """A balloon, its silhouette and how far that is from the drawing."""
    visible = silhouette(trimmed(placed))
    return placed, visible, misfit(target, visible)


def _as_seen(target: Outline, iterate: Iterate) -> Iterate:
    """The iterate with its balloon laid on the drawing by what is seen, where that is much nearer.

    Film that crumples at the rim may slide along it, from one side of a small hole to the other; then the
    places where the seam should be tell nothing of where the outline is.
    """
    seen = _compared(target, laid_on(iterate.inflation, iterate.silhouette, target))
    if seen[2].residual.mean >= _SLID * iterate.misfit.residual.mean:
        return iterate
    return replace(iterate, inflation=seen[0], silhouette=seen[1], misfit=seen[2])


def _meshed(pattern: Outline, simulation: Simulation) -> Panel:
    edge, mirror = simulation.edge, simulation.mirror
    mirrored = None if mirror is None else triangulate_mirrored(pattern, edge, mirror)
    return mirrored or triangulate(pattern, edge)


def weld_error(current: Iterate) -> float:
    """Largest mean distance of a weld from where it was drawn, of the balloon's size; 0 without welds."""
    positions = current.inflation.positions[:, :2]
    lines = zip(current.seam_map.lines, current.panel.welds, strict=True)
    error = max((line.mean_distance(positions[weld]) for line, weld in lines), default=0.0)
    return error / max(current.silhouette.size)


def _moved(last: Iterate, seam_map: SeamMap) -> Panel | None:
    """The panel of the last iterate with its rim on the new pattern; None when it has to be meshed anew."""
    loops = zip(last.nodes, seam_map.pattern, strict=True)
    welds = [
        line.at(before.along(last.panel.rest_positions[weld]))
        for line, before, weld in zip(seam_map.lines, last.seam_map.lines, last.panel.welds, strict=True)
    ]
    return move_rim(last.panel, [node.placed_on(loop) for node, loop in loops], welds)


def _aligned(seam_map: SeamMap, nodes: tuple[SeamNodes, ...], inflation: Inflation) -> Inflation:
    """The balloon moved in its plane of symmetry to where the drawing is."""
    drawn = [node.placed_on(loop) for node, loop in zip(nodes, seam_map.drawing, strict=True)]
    return laid_over(inflation, np.concatenate(drawn))

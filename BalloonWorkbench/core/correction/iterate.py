# SPDX-License-Identifier: LGPL-2.1-or-later
"""One pass of the pattern correction: a pattern is meshed, inflated and laid over the drawing."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from BalloonWorkbench.core.correction.seam_map import Course, SeamNodes, seam_nodes
from BalloonWorkbench.core.correction.transfer import carried
from BalloonWorkbench.core.design.compare import Misfit, alignment, loop_weights, misfit
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
from BalloonWorkbench.core.types import Bools, Progress


@dataclass(frozen=True)
class Work:
    """What stays the same from pass to pass, but for edge, lost and settings.

    edge [m] of the mesh; lost: points of the course that are given up; mirror: of a symmetric
    pattern; settings: when the film is at rest
    """

    target: Outline
    film: Film
    pressure: float
    edge: float
    backend: str | None
    model: Model | None
    progress: Progress
    lost: tuple[Bools, ...]
    mirror: Mirror | None = None
    settings: NewtonSettings | None = None


@dataclass(frozen=True)
class Pass:
    """A pattern and what it inflates to, placed over the drawing.

    nodes   the seam vertices along each loop of the course
    shown   the silhouette of the film that the facets stand for; misfit: how far it is from the drawing
    """

    course: Course
    panel: Panel
    nodes: tuple[SeamNodes, ...]
    inflation: Inflation
    shown: Outline
    misfit: Misfit


def attempt(work: Work, course: Course, previous: Pass | None, last: Pass | None) -> Pass:
    """Inflate the pattern of a course, on the mesh of the previous pass where that still serves.

    Where it does not, the last balloon is carried over to a new mesh. Raises as triangulate and inflate do.
    """
    panel = None if previous is None else _moved(previous, course)
    start: Inflation | None
    if previous is not None and panel is not None:
        nodes, start = previous.nodes, previous.inflation
    else:
        panel = _meshed(course.outline, work)
        nodes = seam_nodes(course, panel)
        start = None if last is None else carried(last.inflation, panel)
    inflation = inflate(
        panel,
        work.film,
        work.pressure,
        start=start,
        backend=work.backend,
        model=work.model,
        progress=work.progress,
        settings=work.settings,
    )
    placed = _aligned(course, nodes, inflation, work.lost)
    shown = silhouette(trimmed(placed))
    return Pass(course, panel, nodes, placed, shown, misfit(work.target, shown))


def _meshed(pattern: Outline, work: Work) -> Panel:
    found = None if work.mirror is None else triangulate_mirrored(pattern, work.edge, work.mirror)
    return found or triangulate(pattern, work.edge)


def weld_error(current: Pass) -> float:
    """Largest mean distance of a weld of the balloon from where it was drawn [m]; 0 without welds."""
    positions = current.inflation.positions[:, :2]
    lines = zip(current.course.lines, current.panel.welds, strict=True)
    return max((line.mean_distance(positions[weld]) for line, weld in lines), default=0.0)


def _moved(previous: Pass, course: Course) -> Panel | None:
    """The panel of the previous pass with its rim on the new pattern; None when it has to be meshed anew."""
    loops = zip(previous.nodes, course.pattern, strict=True)
    welds = [
        line.at(before.along(previous.panel.rest_positions[weld]))
        for line, before, weld in zip(course.lines, previous.course.lines, previous.panel.welds, strict=True)
    ]
    return move_rim(previous.panel, [node.placed_on(loop) for node, loop in loops], welds)


def _aligned(
    course: Course, nodes: tuple[SeamNodes, ...], inflation: Inflation, lost: tuple[Bools, ...]
) -> Inflation:
    """The balloon moved in its plane of symmetry to where the drawing is, by what is not given up."""
    seams = inflation.panel.seams
    wanted = np.concatenate([node.placed_on(loop) for node, loop in zip(nodes, course.drawing, strict=True)])
    seam = np.concatenate([inflation.positions[loop, :2] for loop in seams])
    weights = loop_weights([inflation.panel.rest_positions[loop] for loop in seams])
    sure = np.concatenate(
        [
            ~gone[np.rint(node.index).astype(np.int64) % len(gone)]
            for node, gone in zip(nodes, lost, strict=True)
        ]
    )
    if sure.any():
        weights = weights * sure
    rotation, shift = alignment(seam, wanted, weights)
    positions, directors = inflation.positions.copy(), inflation.directors.copy()
    positions[:, :2] = positions[:, :2] @ rotation.T + shift
    directors[:, :2] = directors[:, :2] @ rotation.T
    lower = inflation.lower
    if lower is not None:
        lower = np.column_stack([lower[:, :2] @ rotation.T + shift, lower[:, 2]])
    return replace(inflation, positions=positions, directors=directors, lower=lower)

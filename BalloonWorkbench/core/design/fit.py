# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pattern correction of Furuta et al. 2010: repeat until the inflated silhouette is the drawing.

    1. inflate the panel
    2. align its seam with the drawing: barycentre, then least-squares rotation
    3. v = drawing - inflated, from each seam vertex to its goal
    4. smooth v along the seam, mix it with what the last passes taught, clamp it in proportion to the balloon
    5. add it to the pattern, which grows where the balloon is too small

Smoothing the correction rather than the pattern leaves the corners of the drawing alone and still lets no
mesh-scale noise in: what is left of v at rest is shorter than the smoothing.
"""

from __future__ import annotations

import time
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from BalloonWorkbench.core.design.compare import alignment, loop_weights, residual
from BalloonWorkbench.core.design.correspondence import goals
from BalloonWorkbench.core.design.course import Course, SeamNodes, seam_nodes
from BalloonWorkbench.core.design.design import Design, Residual
from BalloonWorkbench.core.design.mixing import AndersonMixing
from BalloonWorkbench.core.design.silhouette import silhouette
from BalloonWorkbench.core.design.twins import nearer, twinned
from BalloonWorkbench.core.design.weld_lines import weld_lines
from BalloonWorkbench.core.errors import MeshError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.mesh.panel import Panel
from BalloonWorkbench.core.mesh.reuse import move_rim
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.loops import check
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.outline.sampling import arc_lengths
from BalloonWorkbench.core.outline.symmetry import exact_mirror, mirrored
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.types import Floats, Progress, no_progress

VERTICES = 1500  # of an automatic mesh
MOST_PASSES = 14
FIRST_GROWTH = 1.22  # of the drawing, for the first pattern
GAIN = 1.3  # a pattern of a disc must grow by 1.311 for a silhouette that grows by 1
CLAMP = 0.05  # of the larger dimension, for one pass
SMOOTHING = 1.0  # mesh sizes
ENOUGH = 1e-3  # mean error, of the larger dimension, at which nothing more is gained
COARSENING = 1.8  # of the mesh for the first passes
WORTHWHILE = 700.0  # squares of the mesh size in the area, from which a coarser mesh saves time
CLOSE = 3e-3  # mean error, of the larger dimension, at which the wanted mesh takes over
REACHED = 1e-2
STALLED = 0.9  # a pass that leaves more than this part of the best error brings nothing
PATIENCE = 2  # such passes in a row
MOST_HALVINGS = 8  # of a step that leads to a pattern without a mesh


@dataclass(frozen=True)
class _Pass:
    course: Course
    panel: Panel
    nodes: tuple[SeamNodes, ...]
    inflation: Inflation
    shown: Outline
    error: Residual


def fit(
    target: Outline,
    film: Film,
    pressure: float,
    *,
    mesh_size: float | None = None,
    backend: str | None = None,
    model: Model | None = None,
    symmetric: bool = True,
    start: Design | None = None,
    progress: Progress = no_progress,
) -> Design:
    """The pattern whose inflated silhouette is the target, as nearly as film allows.

    pressure [Pa]; mesh_size [m] of the pattern, None for about VERTICES vertices; symmetric: a symmetric
    target gets a symmetric pattern, unless the balloon buckles and another comes nearer; start: a design of
    the same drawing at another size, from whose pattern the correction sets out. Raises what check,
    triangulate and inflate raise; Cancelled when progress returns False.
    """
    began = time.perf_counter()
    target = check(target)
    # a film with a grain aslant makes no symmetric balloon
    mirror = exact_mirror(target) if symmetric and film.young_modulus_across is None else None
    if target.welds or target.spots:  # which need not lie as the outline does
        mirror = None
    if mirror is not None:
        target = mirrored(target, mirror)
    size = max(target.size)
    centre = target.outer.mean(axis=0)

    def grow(loop: Floats) -> Floats:
        return centre + FIRST_GROWTH * (loop - centre)

    fine = mesh_size or size_for(target.map(grow), VERTICES)
    edge = COARSENING * fine if target.map(grow).area > WORTHWHILE * fine**2 else fine
    course = Course.begun(target, grow, min(0.25 * fine, size / 400.0))
    course, twins = twinned(course, mirror)
    if start is not None and (known := course.resized(start.pattern, size / max(start.target.size))):
        course, edge = known, fine
    mixing = AndersonMixing(GAIN)
    best: _Pass | None = None
    last: _Pass | None = None
    previous: _Pass | None = None  # whose mesh may still serve
    stalled = passes = meshes = halvings = 0
    while passes < MOST_PASSES and stalled <= PATIENCE:
        course = twins.matched(course, None if last is None else last.course)
        try:
            share = _part(progress, passes)
            current = _try(target, course, previous, film, pressure, edge, backend, model, share)
        except MeshError as error:
            if edge == fine and last is None:
                raise
            # a part is too thin for the coarse mesh, or the step made it so: take half of the step back there
            if edge > fine:
                edge, previous = fine, None
            halvings += 1
            if last is not None:
                course = course.taken_back(last.course, error.place, (2.0 + halvings) * edge)
            if halvings > MOST_HALVINGS:
                break
            continue
        halvings = 0
        passes += 1
        meshes += previous is None or current.panel.triangles is not previous.panel.triangles
        if best is not None and current.error.mean > STALLED * best.error.mean:
            stalled += 1
        else:
            stalled = 0
        if best is None or current.error.mean < best.error.mean:
            best = current
        if edge == fine and current.error.mean <= ENOUGH * size and _weld_error(current) <= CLOSE * size:
            break
        course = _corrected(current, mixing, edge, size)
        last = previous = current
        if edge > fine and (current.error.mean <= CLOSE * size or stalled):
            edge, previous, best, stalled, mixing = fine, None, None, 0, AndersonMixing(GAIN)
    if best is None:
        raise MeshError(
            "The pattern becomes too thin for its mesh. Widen the thin parts, or use a finer mesh."
        )
    design = _design(target, best, passes, meshes, time.perf_counter() - began)
    if mirror is None or design.reached:
        return design
    again = partial(fit, mesh_size=mesh_size, backend=backend, model=model, symmetric=False)
    return nearer(design, again(target, film, pressure, progress=_later(progress, passes)))


def inflate_outline(
    pattern: Outline,
    film: Film,
    pressure: float,
    *,
    mesh_size: float | None = None,
    backend: str | None = None,
    model: Model | None = None,
    progress: Progress = no_progress,
) -> Design:
    """The balloon that a given pattern makes, without correction; the target is the pattern itself."""
    began = time.perf_counter()
    pattern = check(pattern)
    edge = mesh_size or size_for(pattern, VERTICES)
    lines = weld_lines(pattern, pattern.loops, 0.25 * edge)
    course = Course(pattern.loops, pattern.loops, len(pattern.spots), lines)
    only = _try(pattern, course, None, film, pressure, edge, backend, model, progress)
    return _design(pattern, only, 0, 1, time.perf_counter() - began)


def _try(
    target: Outline,
    course: Course,
    previous: _Pass | None,
    film: Film,
    pressure: float,
    edge: float,
    backend: str | None,
    model: Model | None,
    progress: Progress,
) -> _Pass:
    """Inflate the pattern of a course, on the mesh of the previous pass where that still serves."""
    panel = None if previous is None else _moved(previous, course)
    if previous is not None and panel is not None:
        nodes, start = previous.nodes, previous.inflation
    else:
        panel = triangulate(course.outline, edge)
        nodes, start = seam_nodes(course, panel), None
    inflation = inflate(panel, film, pressure, start=start, backend=backend, model=model, progress=progress)
    placed = _aligned(course, nodes, inflation)
    shown = silhouette(placed)
    return _Pass(course, panel, nodes, placed, shown, residual(target, shown))


def _weld_error(current: _Pass) -> float:
    """Largest mean distance of a weld of the balloon from where it was drawn [m]; 0 without welds."""
    positions = current.inflation.positions[:, :2]
    lines = zip(current.course.lines, current.panel.welds, strict=True)
    return max((line.mean_distance(positions[weld]) for line, weld in lines), default=0.0)


def _moved(previous: _Pass, course: Course) -> Panel | None:
    """The panel of the previous pass with its rim on the new pattern; None when it has to be meshed anew."""
    loops = zip(previous.nodes, course.pattern, strict=True)
    welds = [
        line.at(before.along(previous.panel.rest_positions[weld]))
        for line, before, weld in zip(course.lines, previous.course.lines, previous.panel.welds, strict=True)
    ]
    return move_rim(previous.panel, [node.placed_on(loop) for node, loop in loops], welds)


def _aligned(course: Course, nodes: tuple[SeamNodes, ...], inflation: Inflation) -> Inflation:
    """The balloon moved in its plane of symmetry to where the drawing is."""
    seams = inflation.panel.seams
    wanted = np.concatenate([node.placed_on(loop) for node, loop in zip(nodes, course.drawing, strict=True)])
    seam = np.concatenate([inflation.positions[loop, :2] for loop in seams])
    weights = loop_weights([inflation.panel.rest_positions[loop] for loop in seams])
    rotation, shift = alignment(seam, wanted, weights)
    positions, directors = inflation.positions.copy(), inflation.directors.copy()
    positions[:, :2] = positions[:, :2] @ rotation.T + shift
    directors[:, :2] = directors[:, :2] @ rotation.T
    lower = inflation.lower
    if lower is not None:
        lower = np.column_stack([lower[:, :2] @ rotation.T + shift, lower[:, 2]])
    return replace(inflation, positions=positions, directors=directors, lower=lower)


def _corrected(current: _Pass, mixing: AndersonMixing, edge: float, size: float) -> Course:
    """The course with its pattern moved by the smoothed, mixed and clamped differences."""
    course = current.course
    differences = []
    for drawing, node, seam in zip(course.drawing, current.nodes, current.panel.seams, strict=True):
        points = current.inflation.positions[seam, :2]
        expected = node.placed_on(drawing)
        reach = 2.0 * edge + np.linalg.norm(points - expected, axis=1)
        v = goals(drawing, points, node.lengths, node.corner_nodes, node.corners, reach) - points
        around = float(arc_lengths(drawing)[-1])
        differences.append(node.spread(node.smoothed(v, around, SMOOTHING * edge), len(drawing)))
    step = mixing.step(np.concatenate(course.pattern).ravel(), np.concatenate(differences).ravel()).reshape(
        -1, 2
    )
    length = np.linalg.norm(step, axis=1, keepdims=True)
    step *= np.minimum(1.0, CLAMP * size / np.maximum(length, 1e-300))
    panel, positions = current.panel, current.inflation.positions[:, :2]
    lines = [
        line.corrected(panel.rest_positions[weld], positions[weld], edge, CLAMP * size)
        for line, weld in zip(course.lines, panel.welds, strict=True)
    ]
    course = replace(course, lines=tuple(lines))
    return course.moved(tuple(np.split(step, np.cumsum([len(loop) for loop in course.pattern])[:-1])))


def _design(target: Outline, best: _Pass, passes: int, meshes: int, seconds: float) -> Design:
    size = max(target.size)
    warnings = []
    if not best.inflation.report.converged:
        warnings.append(
            "The simulation did not come to rest; the shape shown is its last good state. Try a coarser mesh."
        )
    reached = best.error.mean <= REACHED * size
    if passes and not reached:
        warnings.append(
            f"The inflated outline stays {1e3 * best.error.mean:.1f} mm from the drawing on average:"
            " film cannot follow this shape everywhere. Round off notches and widen thin parts."
        )
    return Design(
        target,
        best.course.outline,
        best.inflation,
        best.shown,
        best.error,
        passes,
        meshes,
        seconds,
        reached,
        (*target.notes, *warnings),
    )


def _part(progress: Progress, number: int) -> Progress:
    """Progress of one pass within the whole correction, which seldom needs all its passes."""

    def report(fraction: float, text: str) -> bool:
        # an exception would be lost in the native solver: the answer alone goes through it
        return progress(1.0 - 0.7 ** (number + fraction), f"pass {number + 1}: {text}")

    return report


def _later(progress: Progress, passes: int) -> Progress:
    """Progress of a second correction, after so many passes of the first."""
    before: float = 1.0 - 0.7**passes
    return lambda fraction, text: progress(before + (1.0 - before) * fraction, text)

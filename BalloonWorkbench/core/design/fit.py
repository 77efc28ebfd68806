# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pattern correction of Furuta et al. 2010: repeat until the inflated silhouette is the drawing.

    1. inflate the panel
    2. align its seam with the drawing: barycentre, then least-squares rotation
    3. v = drawing - inflated, from each seam vertex to its goal, turned back with the film around it
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

from BalloonWorkbench.core.design.carry import carried
from BalloonWorkbench.core.design.compare import Misfit, alignment, loop_weights, misfit
from BalloonWorkbench.core.design.correspondence import goals
from BalloonWorkbench.core.design.course import Course, SeamNodes, seam_nodes
from BalloonWorkbench.core.design.design import Design, Stretch
from BalloonWorkbench.core.design.growth import grown
from BalloonWorkbench.core.design.mixing import AndersonMixing
from BalloonWorkbench.core.design.reach import Hopes, stretches
from BalloonWorkbench.core.design.room import CUT_ROOM
from BalloonWorkbench.core.design.silhouette import silhouette
from BalloonWorkbench.core.design.turning import seam_turns, turned_back
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
from BalloonWorkbench.core.outline.symmetry import exact_mirror, mirrored
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.types import Bools, Progress, no_progress
from BalloonWorkbench.core.units import mm_text, to_mm

VERTICES = 1500  # of an automatic mesh
MOST_PASSES = 14
GUESS_VERTICES = 300  # of the mesh for the first pattern
SAMPLES = 400  # of the drawing and the pattern along the larger dimension
GAIN = 1.3  # a pattern of a disc must grow by 1.311 for a silhouette that grows by 1
CLAMP = 0.05  # of the larger dimension, for one pass
SMOOTHING = 1.0  # mesh sizes
TURNING = 4.0  # mesh sizes over which the film's turning is averaged
DRIFT = 2.0  # mesh sizes that seam vertices may slide along the drawing
TIP = 2.0  # mesh sizes from a tip to where its sides are film and not mesh
ENOUGH = 1e-3  # mean error, of the larger dimension, at which nothing more is gained
COARSENING = 1.8  # of the mesh for the first passes
WORTHWHILE = 700.0  # squares of the mesh size in the area, from which a coarser mesh saves time
CLOSE = 3e-3  # mean error, of the larger dimension, at which the wanted mesh takes over
REACHED = 1e-2
STALLED = 0.9  # a pass that leaves more than this part of the best error brings nothing
PATIENCE = 2  # such passes in a row
SHORTER = 0.5  # gain after such a pass
MOST_SENTENCES = 3  # about single stretches that are not reached
MOST_HALVINGS = 8  # of a step that leads to a pattern without a mesh


@dataclass(frozen=True)
class _Work:
    target: Outline
    film: Film
    pressure: float
    edge: float
    backend: str | None
    model: Model | None
    progress: Progress
    lost: tuple[Bools, ...]  # points of the course that are given up


@dataclass(frozen=True)
class _Pass:
    course: Course
    panel: Panel
    nodes: tuple[SeamNodes, ...]
    inflation: Inflation
    shown: Outline
    misfit: Misfit


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
    room = 2.0 * film.seal_width + CUT_ROOM
    drawn, twins = twinned(Course.begun(target, size / SAMPLES), mirror)
    known = None if start is None else drawn.resized(start.pattern, size / max(start.target.size))
    course = twins.matched(known or _first(drawn, target, mesh_size, room))
    fine = mesh_size or size_for(course.outline, VERTICES)
    edge = COARSENING * fine if known is None and course.outline.area > WORTHWHILE * fine**2 else fine
    mixing, hopes = AndersonMixing(GAIN), Hopes(course, size)
    best: _Pass | None = None
    last: _Pass | None = None
    previous: _Pass | None = None  # whose mesh may still serve
    stalled = passes = meshes = halvings = 0
    while passes < MOST_PASSES and stalled <= PATIENCE:
        work = _Work(target, film, pressure, edge, backend, model, _part(progress, passes), hopes.lost)
        course = twins.matched(course, None if last is None else last.course)
        try:
            current = _try(work, course, previous, last)
        except MeshError as error:
            if last is None and (error.place is None or halvings == MOST_HALVINGS):
                raise
            # a part is too thin for the coarse mesh, or the step made it so: take half of the step back there
            if edge > fine:
                edge, previous, hopes = fine, None, Hopes(course, size)
            halvings += 1
            earlier = drawn if last is None else last.course
            course = course.taken_back(earlier, error.place, (2.0 + halvings) * edge)
            if halvings > MOST_HALVINGS:
                break
            continue
        halvings = 0
        passes += 1
        meshes += previous is None or current.panel.triangles is not previous.panel.triangles
        found, least = (hopes.mean(one.misfit) if one else np.inf for one in (current, best))
        stalled = stalled + 1 if found > STALLED * least else 0
        last = current
        if best is None or found < least:
            best = current
        else:  # the step went too far: a shorter one from where it began
            mixing, last = AndersonMixing(GAIN * SHORTER**stalled), best
        if edge == fine and found <= ENOUGH * size and _weld_error(current) <= CLOSE * size:
            break
        course = _corrected(last, mixing, hopes, edge, size, room)
        previous = last
        if edge > fine and (found <= CLOSE * size or stalled):
            edge, previous, best, stalled = fine, None, None, 0
            mixing, hopes = AndersonMixing(GAIN), Hopes(course, size)
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
    lost = tuple(np.zeros(len(loop), dtype=np.bool_) for loop in pattern.loops)
    work = _Work(pattern, film, pressure, edge, backend, model, progress, lost)
    return _design(pattern, _try(work, course, None, None), 0, 1, time.perf_counter() - began)


def _first(course: Course, target: Outline, mesh_size: float | None, room: float) -> Course:
    """The course of a drawing with the first pattern for it."""
    edge = min(float(np.sqrt(target.area / (0.87 * GUESS_VERTICES))), mesh_size or np.inf)
    panel = _meshed(target, edge)
    shift = grown(panel)
    shift -= shift[np.concatenate(panel.seams)].mean(axis=0)
    fields = tuple(
        node.field(shift[seam], drawing, SMOOTHING * edge)
        for node, seam, drawing in zip(seam_nodes(course, panel), panel.seams, course.drawing, strict=True)
    )
    flat = panel.rest_positions
    lines = [
        line.corrected(flat[weld], flat[weld] - shift[weld], edge, max(target.size))
        for line, weld in zip(course.lines, panel.welds, strict=True)
    ]
    return replace(course, lines=tuple(lines)).moved(fields, TIP * edge, room)


def _meshed(outline: Outline, edge: float) -> Panel:
    """A mesh of the drawing, finer where it is too thin: the pattern will be wider."""
    for finer in (1.0, 0.5, 0.25):
        try:
            return triangulate(outline, finer * edge)
        except MeshError:
            pass
    return triangulate(outline, 0.125 * edge)


def _try(work: _Work, course: Course, previous: _Pass | None, last: _Pass | None) -> _Pass:
    """Inflate the pattern of a course, on the mesh of the previous pass where that still serves.

    Where it does not, the last balloon is carried over to a new mesh.
    """
    panel = None if previous is None else _moved(previous, course)
    start: Inflation | None
    if previous is not None and panel is not None:
        nodes, start = previous.nodes, previous.inflation
    else:
        panel = triangulate(course.outline, work.edge)
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
    )
    placed = _aligned(course, nodes, inflation, work.lost)
    shown = silhouette(placed)
    return _Pass(course, panel, nodes, placed, shown, misfit(work.target, shown))


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


def _corrected(
    current: _Pass, mixing: AndersonMixing, hopes: Hopes, edge: float, size: float, room: float
) -> Course:
    """The course with its pattern moved by the smoothed, mixed and clamped differences."""
    course = current.course
    differences = []
    for drawing, node, seam in zip(course.drawing, current.nodes, current.panel.seams, strict=True):
        points = current.inflation.positions[seam, :2]
        reach = np.full(len(points), DRIFT * edge)
        v = goals(drawing, points, node.lengths, node.corner_nodes, node.corners, reach) - points
        smooth = node.field(v, drawing, SMOOTHING * edge)
        turn = seam_turns(current.panel.rest_positions[seam], points)
        differences.append(turned_back(smooth, node.field(turn, drawing, TURNING * edge)))
    wanted = hopes.weighed(course, tuple(differences), 2.0 * edge)
    step = mixing.step(np.concatenate(course.pattern).ravel(), np.concatenate(wanted).ravel()).reshape(-1, 2)
    # the whole step becomes smaller: parts cut off singly would bend the pattern where it should turn
    step *= min(1.0, CLAMP * size / max(float(np.linalg.norm(step, axis=1).max()), 1e-300))
    panel, positions = current.panel, current.inflation.positions[:, :2]
    lines = [
        line.corrected(panel.rest_positions[weld], positions[weld], edge, CLAMP * size)
        for line, weld in zip(course.lines, panel.welds, strict=True)
    ]
    course = replace(course, lines=tuple(lines))
    stops = np.cumsum([len(loop) for loop in course.pattern])[:-1]
    return course.moved(tuple(np.split(step, stops)), TIP * edge, room)


def _design(target: Outline, best: _Pass, passes: int, meshes: int, seconds: float) -> Design:
    size = max(target.size)
    error = best.misfit.over()
    warnings = []
    if not best.inflation.report.converged:
        warnings.append(
            "The simulation did not come to rest; the shape shown is its last good state. Try a coarser mesh."
        )
    reached = error.mean <= REACHED * size
    if passes and not reached:
        warnings.append(
            f"The inflated outline stays {mm_text(error.mean)} from the drawing on average:"
            " film cannot follow this shape everywhere. Round off notches and widen thin parts."
        )
    unreached = stretches(target, best.misfit) if passes else ()
    warnings += [_sentence(stretch) for stretch in unreached[:MOST_SENTENCES]]
    return Design(
        target,
        best.course.outline,
        best.inflation,
        best.shown,
        error,
        passes,
        meshes,
        seconds,
        reached,
        (*target.notes, *warnings),
        unreached,
    )


def _sentence(stretch: Stretch) -> str:
    x, y = to_mm(stretch.middle)
    return (
        f"Near ({x:.0f}, {y:.0f}) mm the inflated outline stays up to {mm_text(stretch.max)} from the"
        f" drawing, along {mm_text(stretch.end - stretch.start)}: film cannot follow it there. Round it off"
        " or widen it."
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

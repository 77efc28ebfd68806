# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pattern correction of Furuta et al. 2010: repeat until the inflated silhouette is the drawing.

    1. inflate the panel
    2. align its seam with the drawing: barycentre, then least-squares rotation
    3. v = drawing - inflated, from where each seam vertex is seen to its goal, turned back with the film
       around it
    4. smooth v along the seam, mix it with what the last passes taught, clamp it in proportion to the balloon
    5. add it to the pattern, which grows where the balloon is too small

The last balloon is brought to rest more exactly than the ones before. Where it moves on, so does the
correction.

Smoothing the correction rather than the pattern leaves the corners of the drawing alone and still lets no
mesh-scale noise in: what is left of v at rest is shorter than the smoothing.
"""

from __future__ import annotations

import time
from dataclasses import replace
from functools import partial

import numpy as np

from BalloonWorkbench.core.correction.clearance import CUT_ROOM
from BalloonWorkbench.core.correction.iterate import Pass, Work, attempt, weld_error
from BalloonWorkbench.core.correction.mixing import AndersonMixing
from BalloonWorkbench.core.correction.seam_map import Course, seam_nodes
from BalloonWorkbench.core.correction.seam_rotation import seam_turns, turned_back
from BalloonWorkbench.core.correction.summary import verdict
from BalloonWorkbench.core.correction.symmetric_pattern import nearer, twinned
from BalloonWorkbench.core.correction.unreachable import Hopes
from BalloonWorkbench.core.correction.weld_lines import weld_lines
from BalloonWorkbench.core.design.correspondence import goals
from BalloonWorkbench.core.design.design import Design
from BalloonWorkbench.core.design.initial_pattern import grown
from BalloonWorkbench.core.design.visible_seam import seen
from BalloonWorkbench.core.errors import MeshError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.outline.sampling import arc_lengths
from BalloonWorkbench.core.outline.symmetry import exact_mirror, mirrored
from BalloonWorkbench.core.outline.validity import check
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.solver.problem import NewtonSettings
from BalloonWorkbench.core.types import Progress, no_progress

VERTICES = 1500  # of an automatic mesh
MOST_PASSES = 12
GUESS_VERTICES = 300  # of the mesh for the first pattern
SAMPLES = 400  # of the drawing and the pattern along the larger dimension
GAIN = 1.3  # a pattern of a disc must grow by 1.311 for a silhouette that grows by 1
CLAMP = 0.05  # of the larger dimension, for one pass
SMOOTHING, UNSEALED = 1.0, 4.0  # mesh sizes; a rim without a sealed band crumples, and no pattern undoes that
TURNING = 16.0  # mesh sizes over which the film's turning is averaged: of arms, not of folds
DRIFT = 2.0  # mesh sizes that seam vertices may slide along the drawing,
DRIFT_ROUND = 1.0 / 12.0  # but no more of the way round a small hole, which else closes
TIP = 2.0  # mesh sizes from a tip to where its sides are film and not mesh
ENOUGH = 5e-4  # mean error, of the breadth, at which nothing more is gained
GOOD = 1e-3  # and at which a pass that brings nothing is the last one
AT_REST = NewtonSettings(tolerance=1e-6)  # of the balloon that is shown
SAME = 1.1  # so much more error at rest is none
OVERHANG = 0.0075  # of the larger dimension, that the silhouette may lie beside the seam
COARSENING = 1.8  # of the mesh for the first passes
WORTHWHILE = 700.0  # squares of the mesh size in the area, from which a coarser mesh saves time
CLOSE = 3e-3  # mean error, of the larger dimension, at which the wanted mesh takes over
STALLED = 0.9  # a pass that leaves more than this part of the best error brings nothing
PATIENCE = 2  # such passes in a row
MOST_STEPS = 180  # of Newton on the wanted mesh, about ten times a cold inflation: then the best is shown
SHORTER = 0.5  # gain after such a pass
MOST_HALVINGS = 8  # of a step that leads to a pattern without a mesh


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
    smoothing = SMOOTHING if film.seal_width > 0.0 else UNSEALED
    breadth = min(size, 2.0 * target.area / size)  # less than the size only for slender shapes
    room = 2.0 * film.seal_width + CUT_ROOM
    drawn, twins = twinned(Course.begun(target, size / SAMPLES), mirror)
    known = None if start is None else drawn.resized(start.pattern, size / max(start.target.size))
    course = twins.matched(known or _first(drawn, target, mesh_size, room))
    fine = mesh_size or size_for(course.outline, VERTICES)
    edge = COARSENING * fine if known is None and course.outline.area > WORTHWHILE * (fine * fine) else fine
    mixing, hopes = AndersonMixing(GAIN), Hopes(course, size)
    best: Pass | None = None
    last: Pass | None = None
    previous: Pass | None = None  # whose mesh may still serve
    settings = None
    stalled = passes = meshes = halvings = steps = 0
    while True:
        shown = _part(progress, passes)
        work = Work(target, film, pressure, edge, backend, model, shown, hopes.lost, mirror, settings)
        course = twins.matched(course, None if last is None else last.course)
        try:
            current = attempt(work, course, previous, last)
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
        steps += current.inflation.report.newton_steps * (edge == fine)
        meshes += previous is None or current.panel.triangles is not previous.panel.triangles
        found, least = (hopes.mean(one.misfit) if one else np.inf for one in (current, best))
        stalled = stalled + 1 if found > STALLED * least else 0
        last = current
        if best is None or found < least:
            best = current
        else:  # the step went too far: a shorter one from where it began
            mixing, last = AndersonMixing(GAIN * SHORTER**stalled), best
        over = passes >= MOST_PASSES or steps >= MOST_STEPS or stalled > PATIENCE
        if over or (edge == fine and _good(best, hopes.mean(best.misfit) / breadth, stalled)):
            if settings is not None:
                break
            settings, least = AT_REST, hopes.mean(best.misfit)
            work = replace(work, settings=settings, progress=_part(progress, passes))
            best = last = attempt(work, best.course, best, best)
            passes += 1
            found = hopes.mean(best.misfit)
            if passes > MOST_PASSES or found <= max(SAME * least, ENOUGH * breadth):
                break
            mixing, stalled = AndersonMixing(GAIN), 0
        given_up = hopes.given_up
        course = _corrected(last, mixing, hopes, edge, smoothing * edge, size, room)
        if hopes.given_up > given_up:  # the rest has its chance now
            stalled = 0
        previous = last
        if edge > fine and (found <= CLOSE * size or stalled):
            edge, previous, best, stalled = fine, None, None, 0
            mixing, hopes = AndersonMixing(GAIN), Hopes(course, size)
        elif settings is None and target.holes and (found <= CLOSE * size or stalled):
            settings, best, stalled = AT_REST, None, 0  # round holes film may fold this way or that
    if best is None:
        raise MeshError(
            "The pattern becomes too thin for its mesh. Widen the thin parts, or use a finer mesh."
        )
    design = verdict(target, best, passes, meshes, time.perf_counter() - began)
    if mirror is None or design.reached:
        return design
    again = partial(fit, mesh_size=mesh_size, backend=backend, model=model, symmetric=False)
    return nearer(design, again(target, film, pressure, progress=_later(progress, passes)))


def _good(best: Pass, error: float, stalled: int) -> bool:
    """Whether a correction with a mean error relative to its breadth is at its aim."""
    if error > (GOOD if stalled else ENOUGH):
        return False
    return weld_error(best) <= CLOSE * max(best.shown.size)


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
    work = Work(pattern, film, pressure, edge, backend, model, progress, lost)
    return verdict(pattern, attempt(work, course, None, None), 0, 1, time.perf_counter() - began)


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


def _corrected(
    current: Pass,
    mixing: AndersonMixing,
    hopes: Hopes,
    edge: float,
    width: float,
    size: float,
    room: float,
) -> Course:
    """The course with its pattern moved by the mixed and clamped differences, smoothed over a width [m]."""
    course = current.course
    differences = []
    for drawing, node, seam in zip(course.drawing, current.nodes, current.panel.seams, strict=True):
        points = current.inflation.positions[seam, :2]
        reach = np.full(len(points), min(DRIFT * edge, DRIFT_ROUND * float(arc_lengths(drawing)[-1])))
        places = seen(points, current.shown, OVERHANG * size)
        places[node.corner_nodes] = points[node.corner_nodes]
        v = goals(drawing, places, node.lengths, node.corner_nodes, node.corners, reach) - places
        smooth = node.field(v, drawing, width)
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

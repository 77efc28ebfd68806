# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pattern correction of Furuta et al. 2010: repeat until the inflated silhouette is the drawing.

    1. inflate the panel                                                            iterate.py
    2. align its seam with the drawing: barycentre, then least-squares rotation
    3. v = drawing - inflated, from where each seam vertex is seen to its goal,     step.py
       turned back with the film around it
    4. smooth v along the seam, mix it with what the last iterates taught, clamp    mixing.py
       it in proportion to the balloon
    5. add it to the pattern, which grows where the balloon is too small            seam_map.py

The stages of the iteration, and when it is over: stages.py.

Smoothing the correction rather than the pattern leaves the corners of the drawing alone and still lets no
mesh-scale noise in: what is left of v at rest is shorter than the smoothing.
"""

from __future__ import annotations

import time
from dataclasses import dataclass, field, replace

import numpy as np

from BalloonWorkbench.core.correction.clearance import CUT_CLEARANCE
from BalloonWorkbench.core.correction.iterate import Iterate, Simulation, make_iterate, weld_error
from BalloonWorkbench.core.correction.mixing import AndersonMixing, RuleOfGain, UpdateRule
from BalloonWorkbench.core.correction.seam_map import SeamMap, seam_nodes
from BalloonWorkbench.core.correction.stages import LIMITS, History, Stage, finished, first_stage, hands_over
from BalloonWorkbench.core.correction.step import TIP, Scales, next_seam_map
from BalloonWorkbench.core.correction.summary import summary
from BalloonWorkbench.core.correction.symmetric_pattern import MirrorPairs, better_design, mirror_pairs
from BalloonWorkbench.core.correction.unreachable import StallTracker
from BalloonWorkbench.core.correction.weld_lines import weld_lines
from BalloonWorkbench.core.design.design import Design
from BalloonWorkbench.core.design.initial_pattern import initial_displacements
from BalloonWorkbench.core.errors import MeshError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.outline.symmetry import Mirror, exact_mirror, mirrored
from BalloonWorkbench.core.outline.validity import check
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.types import Progress, no_progress

VERTICES = 1500  # of an automatic mesh
INITIAL_VERTICES = 300  # of the mesh for the first pattern
SAMPLES = 400  # of the drawing and the pattern along the larger dimension
GAIN = 1.3  # a pattern of a disc must grow by 1.311 for a silhouette that grows by 1
SHORTER = 0.5  # gain after an iterate that is no better
STALLED = 0.9  # an iterate that leaves more than this part of the best error brings nothing
SAME = 1.1  # so much more error at rest is none
SMOOTHING, UNSEALED = 1.0, 4.0  # mesh sizes; a rim without a sealed band crumples, and no pattern undoes that
WORTHWHILE = 700.0  # squares of the mesh size in the area, from which a coarser mesh saves time
MOST_HALVINGS = 8  # of a step that leads to a pattern without a mesh


@dataclass(frozen=True)
class Method:
    """How a pattern is corrected.

    symmetric    a symmetric target gets a symmetric pattern, unless the balloon buckles and another comes
                 nearer
    start        a design of the same drawing at another size, from whose pattern the correction sets out
    update_rule  leads from one iterate to the next
    """

    symmetric: bool = True
    start: Design | None = None
    update_rule: RuleOfGain = AndersonMixing


def fit(
    target: Outline,
    film: Film,
    pressure: float,
    *,
    mesh_size: float | None = None,
    backend: str | None = None,
    model: Model | None = None,
    method: Method = Method(),
    progress: Progress = no_progress,
) -> Design:
    """The pattern whose inflated silhouette is the target, as nearly as film allows.

    pressure [Pa]; mesh_size [m] of the pattern, None for about VERTICES vertices. Raises what check,
    triangulate and inflate raise; Cancelled when progress returns False.
    """
    began = time.perf_counter()
    target = check(target)
    mirror = _mirror(target, film) if method.symmetric else None
    if mirror is not None:
        target = mirrored(target, mirror)
    simulation = Simulation(target, film, pressure, backend, model, 0.0, mirror, progress=progress)
    best, history = _iterated(*_begun(simulation, mesh_size, method))
    design = summary(target, best, history.iterates, history.meshes, time.perf_counter() - began)
    if mirror is None or design.reached:
        return design
    again = fit(
        target,
        film,
        pressure,
        mesh_size=mesh_size,
        backend=backend,
        model=model,
        method=replace(method, symmetric=False, start=None),
        progress=_later(progress, history.iterates),
    )
    return better_design(design, again)


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
    seam_map = SeamMap(pattern.loops, pattern.loops, len(pattern.spots), lines)
    reachable = StallTracker(seam_map, max(pattern.size)).unreachable
    simulation = Simulation(
        pattern, film, pressure, backend, model, edge, unreachable=reachable, progress=progress
    )
    return summary(pattern, make_iterate(simulation, seam_map), 0, 1, time.perf_counter() - began)


def _mirror(target: Outline, film: Film) -> Mirror | None:
    """The axis that the pattern may keep."""
    if film.young_modulus_across is not None:  # a film with a grain aslant makes no symmetric balloon
        return None
    if target.welds or target.spots:  # which need not lie as the outline does
        return None
    return exact_mirror(target)


@dataclass(frozen=True)
class _Task:
    """What stays the same in a correction.

    drawn    the seam map whose pattern is the drawing; pairs: its symmetry
    scales   on the wanted mesh
    breadth  less than the size only for slender shapes [m]
    """

    simulation: Simulation
    drawn: SeamMap
    pairs: MirrorPairs
    scales: Scales
    breadth: float
    method: Method

    def scales_in(self, stage: Stage) -> Scales:
        """The scales on the mesh of a stage."""
        scales, coarsening = self.scales, stage.coarsening
        return replace(scales, edge=coarsening * scales.edge, smoothing=coarsening * scales.smoothing)


@dataclass
class _State:
    """Where the iteration is.

    seam_map   of the next iterate
    rule       that leads to it; stalls: what is not reached
    last       the iterate from which it sets out; best: the nearest one of this stage
    keep_mesh  the last mesh may still serve
    halvings   of the step to it, which led to patterns without a mesh
    """

    stage: Stage
    seam_map: SeamMap
    rule: UpdateRule
    stalls: StallTracker
    last: Iterate | None = None
    best: Iterate | None = None
    keep_mesh: bool = False
    halvings: int = 0
    history: History = field(default_factory=History)


def _begun(simulation: Simulation, mesh_size: float | None, method: Method) -> tuple[_Task, _State]:
    """The correction of a target, before its first iterate."""
    target, film, start = simulation.target, simulation.film, method.start
    size = max(target.size)
    clearance = 2.0 * film.seal_width + CUT_CLEARANCE
    drawn, pairs = mirror_pairs(SeamMap.identity(target, size / SAMPLES), simulation.mirror)
    known = None if start is None else drawn.resized(start.pattern, size / max(start.target.size))
    seam_map = pairs.symmetrised(known or _initial(drawn, target, mesh_size, clearance))
    fine = mesh_size or size_for(seam_map.outline, VERTICES)
    coarse = known is None and seam_map.outline.area > WORTHWHILE * (fine * fine)
    smoothing = SMOOTHING if film.seal_width > 0.0 else UNSEALED
    scales = Scales(size, fine, smoothing * fine, clearance)
    task = _Task(simulation, drawn, pairs, scales, min(size, 2.0 * target.area / size), method)
    stage = first_stage(bool(target.holes), coarse)
    return task, _State(stage, seam_map, method.update_rule(GAIN), StallTracker(seam_map, size))


def _iterated(task: _Task, state: _State) -> tuple[Iterate, History]:
    """The best iterate, and how it was reached."""
    while state.halvings <= MOST_HALVINGS:
        try:
            current = _inflated(task, state)
        except MeshError as error:
            _step_back(task, state, error)
            continue
        _record(task, state, current)
        if finished(state.stage, state.history) and _settled(task, state):
            break
        assert state.last is not None
        given_up = state.stalls.given_up
        state.seam_map = next_seam_map(state.last, state.rule, state.stalls, task.scales_in(state.stage))
        if state.stalls.given_up > given_up:  # the rest has its chance now
            state.history.stalled = 0
        state.keep_mesh = True
        if hands_over(state.stage, state.history):
            _hand_over(task, state)
    if state.best is None:
        raise MeshError(
            "The pattern becomes too thin for its mesh. Widen the thin parts, or use a finer mesh."
        )
    return state.best, state.history


def _simulation(task: _Task, state: _State) -> Simulation:
    return replace(
        task.simulation,
        edge=task.scales_in(state.stage).edge,
        newton=state.stage.newton,
        unreachable=state.stalls.unreachable,
        progress=_part(task.simulation.progress, state.history.iterates),
    )


def _inflated(task: _Task, state: _State) -> Iterate:
    """The next iterate."""
    last = state.last
    state.seam_map = task.pairs.symmetrised(state.seam_map, None if last is None else last.seam_map)
    return make_iterate(_simulation(task, state), state.seam_map, last, state.keep_mesh)


def _step_back(task: _Task, state: _State, error: MeshError) -> None:
    """Take half of the step back: a part is too thin for the coarse mesh, or the step made it so.

    Raises the error where nothing is left to take back.
    """
    if state.last is None and (error.place is None or state.halvings == MOST_HALVINGS):
        raise error
    if state.stage.coarsening > 1.0 and state.stage.following is not None:
        state.stage, state.keep_mesh = state.stage.following, False
        state.stalls = StallTracker(state.seam_map, task.scales.size)
    state.halvings += 1
    earlier = task.drawn if state.last is None else state.last.seam_map
    reach = (2.0 + state.halvings) * task.scales_in(state.stage).edge
    state.seam_map = state.seam_map.half_back(earlier, error.place, reach)


def _record(task: _Task, state: _State, current: Iterate) -> None:
    """Take note of an iterate, and choose the one from which the next step sets out."""
    history, mean_error = state.history, state.stalls.mean_error
    before = state.last if state.keep_mesh else None
    state.halvings = 0
    history.iterates += 1
    history.meshes += before is None or current.panel.triangles is not before.panel.triangles
    if state.stage.coarsening == 1.0:
        history.newton_steps += current.inflation.report.newton_steps
    error = mean_error(current.misfit)
    least = np.inf if state.best is None else mean_error(state.best.misfit)
    history.stalled = history.stalled + 1 if error > STALLED * least else 0
    if state.best is None or error < least:
        state.best = current
    else:  # the step went too far: a shorter one from where it began
        state.rule = task.method.update_rule(GAIN * SHORTER**history.stalled)
    state.last = state.best
    history.error = error / task.scales.size
    history.best_error = min(error, least) / task.breadth
    history.weld_error = weld_error(state.best)


def _settled(task: _Task, state: _State) -> bool:
    """Whether the best balloon stays as it is when it is brought to rest, or has no time to change."""
    if state.stage.newton is not None:
        return True
    history, best = state.history, state.best
    assert best is not None
    state.stage = state.stage.at_rest
    state.best = state.last = make_iterate(_simulation(task, state), best.seam_map, best, keep_mesh=True)
    history.iterates += 1
    error = state.stalls.mean_error(state.best.misfit)
    if history.iterates > LIMITS.iterates:
        return True
    if error / task.breadth <= max(SAME * history.best_error, LIMITS.enough):
        return True
    state.rule, history.stalled = task.method.update_rule(GAIN), 0
    history.error = error / task.scales.size
    return False


def _hand_over(task: _Task, state: _State) -> None:
    """Begin the following stage; another mesh has another best, and nothing learnt on the last one counts."""
    assert state.stage.following is not None
    if state.stage.following.coarsening != state.stage.coarsening:
        state.keep_mesh = False
        state.rule = task.method.update_rule(GAIN)
        state.stalls = StallTracker(state.seam_map, task.scales.size)
    state.stage, state.best, state.history.stalled = state.stage.following, None, 0


def _initial(drawn: SeamMap, target: Outline, mesh_size: float | None, clearance: float) -> SeamMap:
    """The seam map of a drawing with the first pattern for it."""
    edge = min(float(np.sqrt(target.area / (0.87 * INITIAL_VERTICES))), mesh_size or np.inf)
    panel = _meshed(target, edge)
    shift = initial_displacements(panel)
    shift -= shift[np.concatenate(panel.seams)].mean(axis=0)
    fields = tuple(
        node.field(shift[seam], drawing, SMOOTHING * edge)
        for node, seam, drawing in zip(seam_nodes(drawn, panel), panel.seams, drawn.drawing, strict=True)
    )
    flat = panel.rest_positions
    lines = [
        line.corrected(flat[weld], flat[weld] - shift[weld], edge, max(target.size))
        for line, weld in zip(drawn.lines, panel.welds, strict=True)
    ]
    return replace(drawn, lines=tuple(lines)).moved(fields, TIP * edge, clearance)


def _meshed(outline: Outline, edge: float) -> Panel:
    """A mesh of the drawing, finer where it is too thin: the pattern will be wider."""
    for finer in (1.0, 0.5, 0.25):
        try:
            return triangulate(outline, finer * edge)
        except MeshError:
            pass
    return triangulate(outline, 0.125 * edge)


def _part(progress: Progress, number: int) -> Progress:
    """Progress of one iterate within the whole correction, which seldom needs all of them."""

    def report(fraction: float, text: str) -> bool:
        # an exception would be lost in the native solver: the answer alone goes through it
        return progress(1.0 - 0.7 ** (number + fraction), f"pass {number + 1}: {text}")

    return report


def _later(progress: Progress, passes: int) -> Progress:
    """Progress of a second correction, after so many iterates of the first."""
    before: float = 1.0 - 0.7**passes
    return lambda fraction, text: progress(before + (1.0 - before) * fraction, text)

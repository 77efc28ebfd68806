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
from contextlib import suppress
from dataclasses import dataclass, field, replace

import numpy as np

from BalloonWorkbench.core.correction.clearance import CUT_CLEARANCE
from BalloonWorkbench.core.correction.iterate import Iterate, Simulation, make_iterate, weld_error
from BalloonWorkbench.core.correction.mixing import AndersonMixing, RuleOfGain, UpdateRule
from BalloonWorkbench.core.correction.seam_map import SeamMap, seam_nodes
from BalloonWorkbench.core.correction.stages import (
    AT_REST,
    BROAD,
    LIMITS,
    History,
    Stage,
    finished,
    first_stage,
    hands_over,
)
from BalloonWorkbench.core.correction.step import TIP, Scales, next_seam_map
from BalloonWorkbench.core.correction.summary import summary
from BalloonWorkbench.core.correction.symmetric_pattern import NO_SYMMETRY, PatternSymmetry, pattern_symmetry
from BalloonWorkbench.core.correction.weld_lines import weld_lines
from BalloonWorkbench.core.design.design import Design
from BalloonWorkbench.core.design.fairing import faired_points
from BalloonWorkbench.core.design.initial_pattern import initial_displacements
from BalloonWorkbench.core.errors import MeshError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.outline.symmetry import exact_mirror, mirrored
from BalloonWorkbench.core.outline.validity import check
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.rounded import rounded_outline
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.solver.problem import NewtonSettings
from BalloonWorkbench.core.types import Progress, no_progress

VERTICES = 1500  # of an automatic mesh
INITIAL_VERTICES = 300  # of the mesh for the first pattern
SAMPLES = 400  # of the drawing and the pattern along the larger dimension
GAIN = 1.3  # a pattern of a disc must grow by 1.311 for a silhouette that grows by 1
SHORTER = 0.5  # gain after an iterate that is no better
STALLED = 0.9  # an iterate that leaves more than this part of the best error brings nothing
SAME = 1.1  # so much more error of the balloon that was blown up anew is none,
PROMISED = 6e-4  # nor is an error up to this, of the larger dimension
SMOOTHING, UNSEALED = 1.0, 4.0  # mesh sizes; a rim without a sealed band crumples, and no pattern undoes that
WORTHWHILE = 700.0  # squares of the mesh size in the area, from which a coarser mesh saves time
#: Two meshes for each proof of a pattern, in mesh sizes of its correction: other ones, and no coarser ones.
PROOF_MESHES = ((0.94, 0.86), (0.97, 0.83), (0.91, 0.8))
MOST_HALVINGS = 8  # of a step that leads to a pattern without a mesh


@dataclass(frozen=True)
class Method:
    """How a pattern is corrected."""

    symmetric: bool = True  # as a symmetric target is
    start: Design | None = None  # of the same drawing at another size: its pattern is where it sets out
    update_rule: RuleOfGain = AndersonMixing  # leads from one iterate to the next
    smoothing: float = SMOOTHING  # of the corrections near the drawing, in mesh sizes;
    broad: float = BROAD  # far from it, in units of that


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
    mirror = exact_mirror(target) if method.symmetric and _even(target, film) else None
    if mirror is not None:
        target = mirrored(target, mirror)
    simulation = Simulation(target, film, pressure, backend, model, mirror=mirror, progress=progress)
    best, history = _begun(simulation, mesh_size, method).run()
    return summary(target, best, history.iterates, history.meshes, time.perf_counter() - began)


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
    simulation = Simulation(pattern, film, pressure, backend, model, edge, progress=progress)
    return summary(pattern, make_iterate(simulation, seam_map), 0, 1, time.perf_counter() - began)


def _even(target: Outline, film: Film) -> bool:
    """Whether a pattern may keep a symmetry: a grain aslant and welds need not lie as the outline does."""
    return film.young_modulus_across is None and not target.welds and not target.spots


@dataclass
class _Correction:
    """The state of the iteration, below what stays the same."""

    simulation: Simulation
    drawn: SeamMap  # whose pattern is the drawing
    symmetry: PatternSymmetry
    scales: Scales  # on the wanted mesh
    breadth: float  # of the drawing: less than its size only for slender shapes [m]
    new_rule: RuleOfGain

    stage: Stage
    seam_map: SeamMap  # of the next iterate
    rule: UpdateRule
    last: Iterate | None = None  # from which the next one sets out
    best: Iterate | None = None  # of this stage
    proof: Iterate | None = None  # of the best pattern that was blown up anew
    keep_mesh: bool = False  # of the last iterate, where it serves
    halvings: int = 0  # of the step to the next iterate
    history: History = field(default_factory=History)

    def run(self) -> tuple[Iterate, History]:
        """The best iterate, and how it was reached."""
        while self.halvings <= MOST_HALVINGS:
            try:
                current = self._next_iterate()
            except MeshError as error:
                self._step_back(error)
                continue
            self._record(current)
            if finished(self.stage, self.history) and self._holds():
                break
            self._correct()
            if hands_over(self.stage, self.history):
                self._hand_over()
        if self.proof is None:
            self._holds()
        if self.proof is None:
            raise MeshError(
                "The pattern becomes too thin for its mesh. Widen the thin parts, or use a finer mesh."
            )
        return self._as_cut(self.proof), self.history

    @property
    def _scales(self) -> Scales:
        """On the mesh of this stage."""
        edge, smoothing = self.stage.coarsening, self.stage.coarsening * self.stage.smoothing
        return replace(self.scales, edge=edge * self.scales.edge, smoothing=smoothing * self.scales.smoothing)

    def _simulation(self, edge: float, newton: NewtonSettings | None, trial: bool = False) -> Simulation:
        """That of the next balloon, of an iterate or of a trial of the pattern."""
        self.history.balloons += 1
        progress = _part(self.simulation.progress, self.history, trial)
        return replace(self.simulation, edge=edge, newton=newton, progress=progress)

    def _next_iterate(self) -> Iterate:
        earlier = None if self.last is None else self.last.seam_map
        self.seam_map = self.symmetry.symmetrised(self.seam_map, earlier)
        simulation = self._simulation(self._scales.edge, self.stage.newton)
        return make_iterate(simulation, self.seam_map, self.last, self.keep_mesh)

    def _step_back(self, error: MeshError) -> None:
        """Take half of the step back: a part is too thin for the coarse mesh, or the step made it so.

        Raises the error where nothing is left to take back.
        """
        if self.last is None and (error.place is None or self.halvings == MOST_HALVINGS):
            raise error
        if self.stage.coarsening > 1.0 and self.stage.following is not None:
            self.stage, self.keep_mesh = self.stage.following, False
        self.halvings += 1
        earlier = self.drawn if self.last is None else self.last.seam_map
        reach = (2.0 + self.halvings) * self._scales.edge
        self.seam_map = self.seam_map.half_back(earlier, error.place, reach)

    def _record(self, current: Iterate) -> None:
        """Take note of an iterate, and choose the one from which the next step sets out."""
        history, before = self.history, self.last if self.keep_mesh else None
        self.halvings = 0
        history.iterates += 1
        history.meshes += before is None or current.panel.triangles is not before.panel.triangles
        if self.stage.coarsening == 1.0:
            history.newton_steps += current.inflation.report.newton_steps
        error = current.misfit.residual.mean
        least = np.inf if self.best is None else self.best.misfit.residual.mean
        history.stalled = history.stalled + 1 if error > STALLED * least else 0
        if self.best is None or error < least:
            self.best = current
        else:  # the step went too far: a shorter one from where it began
            self.rule = self.new_rule(GAIN * SHORTER**history.stalled)
        self.last = self.best
        history.error, history.best_error = error / self.scales.size, min(error, least) / self.breadth
        history.weld_error = weld_error(self.best)

    def _holds(self) -> bool:
        """Whether the best pattern makes the same balloon when it is blown up anew, or has no time to change.

        Else the correction goes on from what came out.
        """
        history, best = self.history, self.best
        if best is None:
            return True
        anew = self._anew(best.seam_map, best)
        error = anew.misfit.residual.mean
        history.proofs += 1
        if self.proof is None or error < self.proof.misfit.residual.mean:
            self.proof = anew
        same = error <= max(SAME * history.best_error * self.breadth, PROMISED * self.scales.size)
        if same or history.proofs >= len(PROOF_MESHES) or history.iterates >= LIMITS.iterates:
            return True
        self.stage, self.best, self.last = AT_REST, anew, anew
        self.rule, history.stalled = self.new_rule(GAIN), 0
        history.error, history.best_error = error / self.scales.size, error / self.breadth
        return False

    def _anew(self, seam_map: SeamMap, best: Iterate) -> Iterate:
        """The worse of two balloons of a pattern, from the flat film on other meshes; best where it has none.

        These are not symmetric, so that a balloon that buckles to one side does.
        """
        balloons = []
        for share in PROOF_MESHES[min(self.history.proofs, len(PROOF_MESHES) - 1)]:
            simulation = self._simulation(share * self.scales.edge, AT_REST.newton, trial=True)
            with suppress(MeshError):  # too thin for this one: the other tells
                balloons.append(make_iterate(replace(simulation, mirror=None), seam_map))
        return max(balloons or [best], key=lambda balloon: balloon.misfit.residual.mean)

    def _as_cut(self, proof: Iterate) -> Iterate:
        """The balloon of the pattern as it is cut: the same, unless its seam is scattered and is faired."""
        # as documents keep it: what is worked out for its curves here is known from here on
        drawn = rounded_outline(proof.seam_map.outline).loops
        cut = tuple(map(faired_points, drawn))
        if all(new is old for new, old in zip(cut, drawn, strict=True)):
            return proof
        made = self._anew(replace(proof.seam_map, pattern=cut), proof)
        return replace(made, seam_map=proof.seam_map)

    def _correct(self) -> None:
        """Move the pattern of the last iterate."""
        assert self.last is not None
        self.seam_map = next_seam_map(self.last, self.rule, self._scales)
        self.keep_mesh = True

    def _hand_over(self) -> None:
        """Begin the following stage; another mesh has another best, and nothing learnt on the last counts."""
        stage, following = self.stage, self.stage.following
        assert following is not None
        if following.coarsening != stage.coarsening:
            self.keep_mesh, self.rule = False, self.new_rule(GAIN)
        if replace(following, smoothing=stage.smoothing, following=following) != stage:
            self.best = None
        self.stage, self.history.stalled = following, 0


def _begun(simulation: Simulation, mesh_size: float | None, method: Method) -> _Correction:
    """The correction of a target, before its first iterate."""
    target, film, start = simulation.target, simulation.film, method.start
    size = max(target.size)
    clearance = 2.0 * film.seal_width + CUT_CLEARANCE
    drawn, symmetry = SeamMap.identity(target, size / SAMPLES), NO_SYMMETRY
    if method.symmetric and _even(target, film):
        drawn, symmetry = pattern_symmetry(drawn, simulation.mirror)
    known = None if start is None else drawn.resized(start.pattern, size / max(start.target.size))
    seam_map = symmetry.symmetrised(known or _initial(drawn, target, mesh_size, clearance))
    fine = mesh_size or size_for(seam_map.outline, VERTICES)
    coarse = known is None and seam_map.outline.area > WORTHWHILE * (fine * fine)
    smoothing = method.smoothing if film.seal_width > 0.0 else UNSEALED
    return _Correction(
        simulation,
        drawn,
        symmetry,
        Scales(size, fine, smoothing * fine, clearance),
        min(size, 2.0 * target.area / size),
        method.update_rule,
        first_stage(bool(target.holes), coarse, method.broad),
        seam_map,
        method.update_rule(GAIN),
    )


def _initial(drawn: SeamMap, target: Outline, mesh_size: float | None, clearance: float) -> SeamMap:
    """The seam map of a drawing with the first pattern for it."""
    edge = min(float(np.sqrt(target.area / (0.87 * INITIAL_VERTICES))), mesh_size or np.inf)
    panel = _meshed(target, edge)
    shift = initial_displacements(panel)
    shift -= shift[np.concatenate(panel.loops)].mean(axis=0)
    fields = tuple(
        node.field(shift[seam], drawing, SMOOTHING * edge)
        for node, seam, drawing in zip(seam_nodes(drawn, panel), panel.loops, drawn.drawing, strict=True)
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


def _part(progress: Progress, history: History, trial: bool) -> Progress:
    """Progress of the next balloon within the whole correction, which seldom needs all of them."""
    before, number = history.balloons - 1, history.iterates + 1

    def report(fraction: float, text: str) -> bool:
        # an exception would be lost in the native solver: the answer alone goes through it
        share = 1.0 - 0.8 ** (before + fraction)
        if trial:
            return progress(share, f"trial of the pattern: {text}")
        return progress(share, f"pass {number}: {text}")

    return report

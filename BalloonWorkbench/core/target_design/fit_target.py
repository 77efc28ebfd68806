# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panels of a divided target are corrected until their balloon lies on it, as nearly as film can.

Between its seams a flat panel cannot bend both ways: the film bulges there, whatever its edges are. What a
pattern can change are the curves of its seams. Their corners and a few places of each side are found by least
squares of the distances, by area, of the film from the target and of the target from the film, which else
could leave out a horn or a tail; with the derivatives that the solver has of its balloon (Gauss and Newton;
damped after Levenberg and Marquardt). Both sides of a seam stay equally long.
"""

from __future__ import annotations

import time
from dataclasses import dataclass, field, replace

import numpy as np

from BalloonWorkbench.core.bag_design.bag_design import BagDesign
from BalloonWorkbench.core.bags.mesh_bag import default_size, mesh_bag
from BalloonWorkbench.core.correction.summary import NOT_AT_REST
from BalloonWorkbench.core.errors import MeshError, SolverError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.flattening.bag_of import flat_body
from BalloonWorkbench.core.options.body import ENCLOSE, FOLLOW, INSIDE
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.target_design.aim import Aim
from BalloonWorkbench.core.target_design.curved_film import curved_film
from BalloonWorkbench.core.target_design.iterate import (
    TargetIterate,
    TargetSimulation,
    make_target_iterate,
    next_iterate,
)
from BalloonWorkbench.core.target_design.linear_step import LinearStep
from BalloonWorkbench.core.target_design.mirrored_panels import NOT_MIRRORED, MirroredPanels
from BalloonWorkbench.core.target_design.off_target import TargetSurface, clearances
from BalloonWorkbench.core.target_design.seam_unknowns import SeamUnknowns, spans_of
from BalloonWorkbench.core.targets.nearest_surface import NearestSurface
from BalloonWorkbench.core.targets.target import Division
from BalloonWorkbench.core.types import Progress, no_progress, part_of
from BalloonWorkbench.core.units import length_text, percent_text, place_text

VERTICES = 1500  # of an automatic mesh, all panels together
STEPS = 12  # balloons of a correction at most
MORE_STEPS = 2  # for a balloon that shall enclose the target, or lie inside
PROOF_MESH = 0.86  # mesh size of the proof, of that of the correction
STALLED = 0.025  # a step that brings less than this part of the error brings nothing
#: The damping at first, and how it changes by the part of a hoped for gain that a step brought.
DAMPING = 0.1
GOOD, SOFTER = 0.75, 0.3
POOR, STIFFER = 0.3, 5.0
#: Film may be so much nearer to a target than its margin, of the diagonal; how often it is aimed farther.
HELD, ROUNDS = 2e-4, 5
NEAR = 1.5  # means of the first distances, up to about which distances count by their squares
#: A mean distance, of the diagonal, at which the balloon has the shape of the target.
REACHED = 5e-3
#: A place that stays farther away, of the diagonal, is told.
FAR = 0.02


@dataclass(frozen=True)
class TargetMode:
    """What the balloon shall do with the target: FOLLOW or ENCLOSE it, or stay INSIDE.

    margin    [m], so far outside or inside of it at least
    accuracy  a mean distance, in parts of the diagonal, from which on more panels are advised
    """

    kind: str = FOLLOW
    margin: float = 0.0
    accuracy: float = REACHED

    @property
    def side(self) -> float:
        """1 outside, -1 inside, 0 on it."""
        return {FOLLOW: 0.0, ENCLOSE: 1.0, INSIDE: -1.0}[self.kind]


FOLLOWING = TargetMode()


def fit_target(
    division: Division,
    film: Film,
    pressure: float,
    *,
    mode: TargetMode = FOLLOWING,
    mesh_size: float | None = None,
    backend: str | None = None,
    model: Model | None = None,
    progress: Progress = no_progress,
) -> BagDesign:
    """The balloon of the panels of a divided target that lies on the target as nearly as film can.

    pressure [Pa]; mesh_size [m], None for about VERTICES vertices. The error of the design is that of its
    pattern meshed anew. Raises what flatten, mesh_bag and inflate raise; Cancelled when progress returns
    False.
    """
    correction = begun(division, film, pressure, mesh_size, backend, model, progress)
    best = correction.run(correction.first(), mode.side * mode.margin, STEPS, mode.side)
    if mode.side:
        return _beside(correction, best, mode)
    return _design(correction, correction.proof(best), mode.accuracy)


def _beside(correction: TargetCorrection, best: TargetIterate, mode: TargetMode) -> BagDesign:
    """The balloon on one side of the target: while it is short of the margin, it is aimed farther."""
    aimed, held = mode.margin, HELD * correction.size
    kept, clear = None, -np.inf
    for _ in range(ROUNDS):
        proof = correction.proof(best)
        least = correction.clearance(proof, mode.side)
        if least <= clear:
            break
        kept, clear = proof, least
        if mode.margin - clear <= held:
            break
        aimed += mode.margin - clear + held
        best = correction.run(best, mode.side * aimed, MORE_STEPS, mode.side)
    assert kept is not None
    design = _design(correction, kept, np.inf)
    if mode.margin - clear <= held:
        return design
    return replace(design, reached=False, warnings=(*design.warnings, _short(mode, clear)))


def _short(mode: TargetMode, clear: float) -> str:
    """About film that lies on the wrong side of the target, or too near to it."""
    margin = length_text(mode.margin, 3)
    if clear >= 0.0:
        return (
            f"The film comes as near as {length_text(clear, 3)} to the body, and a margin of {margin} was"
            " asked for. Take more panels, or a larger margin."
        )
    return (
        f"At worst the film lies {length_text(-clear, 3)} on the wrong side of the body, and a margin of"
        f" {margin} was asked for. Take more panels, or a larger margin."
    )


def inflate_target(
    division: Division,
    film: Film,
    pressure: float,
    *,
    mesh_size: float | None = None,
    backend: str | None = None,
    model: Model | None = None,
    progress: Progress = no_progress,
) -> BagDesign:
    """The balloon of the panels as they are laid flat, without correction; see fit_target."""
    correction = begun(division, film, pressure, mesh_size, backend, model, progress, exact=True)
    return _design(correction, correction.first(), np.inf)


def begun(
    division: Division,
    film: Film,
    pressure: float,
    mesh_size: float | None,
    backend: str | None,
    model: Model | None,
    progress: Progress,
    *,
    exact: bool = False,
) -> TargetCorrection:
    """The correction of a divided target before its first balloon; exact: as bag_of."""
    body = flat_body(division, exact=exact)
    surface = TargetSurface(division.target)
    simulation = TargetSimulation(body, surface, film, pressure, backend, model, progress)
    as_it_is = exact or film.young_modulus_across is not None
    mirrored = NOT_MIRRORED if as_it_is else MirroredPanels.of(body)
    return TargetCorrection(simulation, mesh_size or default_size(body.bag, VERTICES), mirrored)


@dataclass
class TargetCorrection:
    """The state of the iteration.

    edge      of the wanted mesh [m]
    mirrored  which panels stay mirror images of each other
    """

    simulation: TargetSimulation
    edge: float
    mirrored: MirroredPanels = NOT_MIRRORED
    balloons: int = 0
    started: float = field(default_factory=time.perf_counter)

    @property
    def size(self) -> float:
        """The diagonal of the target's box [m]."""
        return self.simulation.surface.target.diagonal

    def first(self) -> TargetIterate:
        """The balloon of the panels as they are laid flat."""
        return make_target_iterate(
            self._next(), mesh_bag(self.mirrored.alike(self.simulation.body.bag), self.edge)
        )

    def proof(self, best: TargetIterate) -> TargetIterate:
        """The balloon of the same pattern on another mesh, from the target."""
        return make_target_iterate(self._next(), mesh_bag(best.bag, PROOF_MESH * self.edge))

    def clearance(self, made: TargetIterate, side: float) -> float:
        """How far on that side of the target the film lies at least [m]."""
        inflation, surface = made.inflation, made.meshed.assembly.surface
        film = curved_film(made.positions, inflation.directors, surface)
        least, most = clearances(self.simulation.surface, *film)
        return least if side > 0.0 else -most

    def run(self, best: TargetIterate, margin: float, most: int, side: float = 0.0) -> TargetIterate:
        """The best of the corrected patterns; margin: so far [m] outside of the target, side as in Aim."""
        near = NEAR * float(best.weights**2 @ np.abs(best.distances - margin))
        aim = Aim(margin, near, side)
        damping, step = DAMPING, self._step(best)
        for _ in range(most):
            try:
                bag, values, left = step.unfolded(aim, damping, self.mirrored)
                current = next_iterate(self._next(), best, bag, self.edge)
            except (MeshError, SolverError):
                damping *= STIFFER
                continue
            gain = best.error(aim) - current.error(aim)
            brought = gain / max(best.error(aim) - left, 1e-300)
            damping *= SOFTER if brought > GOOD else STIFFER if brought < POOR else 1.0
            if gain <= 0.0:
                if not step.fresh:
                    step = self._step(best)
                continue
            stalled = gain < STALLED * best.error(aim)
            if stalled and step.fresh:
                return current
            best = current
            same = len(current.positions) == len(step.matrix)
            step = step.followed(values, current) if same and not stalled else self._step(current)
        return best

    def _step(self, current: TargetIterate) -> LinearStep:
        """How the balloon of an iterate follows its pattern."""
        spans = spans_of(current.bag, self.size, self.mirrored.share)
        unknowns = SeamUnknowns.of(current.bag, spans, self.mirrored)
        return LinearStep.of(current, unknowns, self.simulation.film, self.simulation.backend)

    def _next(self) -> TargetSimulation:
        """That of the next balloon, which tells its part of the whole progress."""
        self.balloons += 1
        begin, end = (1.0 - 0.8 ** (self.balloons - k) for k in (1, 0))
        return replace(self.simulation, progress=part_of(self.simulation.progress, begin, end))


def _design(correction: TargetCorrection, proof: TargetIterate, asked: float) -> BagDesign:
    """The design, with what is to be said about it; asked: the mean distance that is none."""
    simulation, size = correction.simulation, correction.size
    division = simulation.body.division
    residual = proof.residual(simulation.surface)
    warnings = [*division.target.notes]
    if not proof.inflation.report.converged:
        warnings.append(NOT_AT_REST)
    if not (reached := residual.mean <= asked * size):
        warnings.append(
            f"The balloon stays {length_text(residual.mean)} from the body on average,"
            f" {percent_text(residual.mean / size)} of its diagonal: flat panels bulge between their seams."
            f" Take more than {len(division.names)} panels."
        )
    if np.isfinite(asked):
        warnings += _far(correction, proof)
    return BagDesign(
        division,
        proof.bag,
        proof.meshed,
        proof.inflation,
        size,
        residual,
        passes=correction.balloons,
        seconds=time.perf_counter() - correction.started,
        reached=reached,
        warnings=tuple(warnings),
    )


def _far(correction: TargetCorrection, proof: TargetIterate) -> list[str]:
    """About the place of the body from which the film stays farthest away."""
    target = correction.simulation.surface.target
    film = NearestSurface(proof.positions, proof.meshed.assembly.surface.triangles)
    away = np.abs(film.query(target.points).distances)
    worst = int(np.argmax(away))
    if away[worst] <= FAR * correction.size:
        return []
    place, far = place_text(target.points[worst]), length_text(float(away[worst]), 3)
    return [
        f"Near {place} the film stays {far} from the body, which is too thin or too sharp there for panels."
        " Cut such a part off, or divide the body along it."
    ]

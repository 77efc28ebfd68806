# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gores are corrected until their film lies on the profile in the mean of their middle lines and seams.

Between its seams a flat gore cannot bend both ways, so a balloon of few gores is no body of revolution: its
seams stand out, its middle lines lie inside. What a pattern can do is to have the profile between both.
From the middle to the seam the film rises nearly straight, and half way between them is that mean. What lies
on the profile there has half of its film inside and half outside, and no other pattern is nearer on average.

A smooth factor of the half width and the length of the gore are found by least squares, with the derivatives
that the solver has of its balloon (Gauss and Newton; damped after Levenberg).
"""

from __future__ import annotations

import time
from dataclasses import dataclass, field, replace

import numpy as np

from BalloonWorkbench.core.bag_design.bag_design import BagDesign
from BalloonWorkbench.core.bag_design.gore_sections import (
    STATIONS,
    across_gores,
    beside_axis,
    gore_residual,
    moves_off,
    off_profile,
    profile_ends,
)
from BalloonWorkbench.core.bag_design.gore_start import lower_end, on_profile
from BalloonWorkbench.core.bag_design.gore_unknowns import GoreUnknowns
from BalloonWorkbench.core.bag_design.inflate_bag import within_open_ends
from BalloonWorkbench.core.bags.mesh_bag import MeshedBag, default_size, mesh_bag
from BalloonWorkbench.core.bodies.gores import Gores, plain_gores
from BalloonWorkbench.core.bodies.profile import Profile
from BalloonWorkbench.core.correction.summary import NOT_AT_REST
from BalloonWorkbench.core.errors import AssemblyError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.lift import Lift
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.solver.sensitivity import position_changes
from BalloonWorkbench.core.types import Floats, Progress, no_progress, part_of
from BalloonWorkbench.core.units import length_text

VERTICES = 2000  # of an automatic mesh, all panels together
STEPS = 5  # corrections at most
PROOF_MESH = 0.86  # mesh size of the proof, of that of the correction
ENOUGH = 3e-4  # error, of the size, at which nothing more is gained
#: Such an error, of the size, and the film has taken the shape of the profile.
REACHED = 5e-3
STALLED = 0.95  # a step that leaves more than this part of the error brings nothing
#: Weights of the bends of the factor of the width, in parts of the size, of changes, in parts of the error;
#: and the largest change of a factor in one step.
BENDS, DAMPING, LARGEST = 1e-3, 1.5, 0.3
RIM = 2.0  # what a rim that is not at the profile's end counts beside a place along the gores


@dataclass(frozen=True)
class RisingPressure:
    """A pressure that grows with the height: [Pa] at the lower end, and [Pa/m]."""

    lower: float
    gradient: float


def fit_gores(
    profile: Profile,
    count: int,
    film: Film,
    pressure: float | RisingPressure,
    *,
    mesh_size: float | None = None,
    backend: str | None = None,
    model: Model | None = None,
    progress: Progress = no_progress,
) -> BagDesign:
    """The balloon of so many gores whose middle lines and seams have the profile in their mean.

    pressure [Pa]; mesh_size [m], None for about VERTICES vertices. The error of the design is that of its
    pattern meshed anew: the distance of the gores' film from the body of revolution. Raises what gored_bag,
    mesh_bag and inflate raise; Cancelled when progress returns False.
    """
    correction = GoreCorrection.of(profile, count, film, pressure, mesh_size)
    correction = replace(correction, backend=backend, model=model, progress=progress)
    return _design(correction, correction.proof(correction.run()))


def inflate_gores(
    profile: Profile,
    count: int,
    film: Film,
    pressure: float | RisingPressure,
    *,
    mesh_size: float | None = None,
    backend: str | None = None,
    model: Model | None = None,
    progress: Progress = no_progress,
) -> BagDesign:
    """The balloon of so many gores as wide as the body is around, without correction; see fit_gores."""
    correction = GoreCorrection.of(profile, count, film, pressure, mesh_size)
    correction = replace(correction, backend=backend, model=model, progress=progress)
    return _design(correction, correction.begun(), np.inf)


@dataclass(frozen=True)
class GoreIterate:
    """A pattern and its balloon.

    away   [m], how far the film half way between middle lines and seams is from the profile, along the gores;
           then how far rims of discs are from its ends along it, times RIM
    apart  how far middle lines and seams are apart at most [m]
    """

    values: Floats
    meshed: MeshedBag
    inflation: Inflation
    away: Floats
    apart: float

    @property
    def error(self) -> float:
        """Distance from the profile half way between middle lines and seams, root of its mean square [m]."""
        return float(np.linalg.norm(self.away) / np.sqrt(STATIONS))


@dataclass
class GoreCorrection:
    """The state of the iteration."""

    unknowns: GoreUnknowns
    film: Film
    pressure: float | RisingPressure
    edge: float
    backend: str | None = None
    model: Model | None = None
    progress: Progress = no_progress
    balloons: int = 0
    started: float = field(default_factory=time.perf_counter)

    @classmethod
    def of(
        cls,
        profile: Profile,
        count: int,
        film: Film,
        pressure: float | RisingPressure,
        mesh_size: float | None,
    ) -> GoreCorrection:
        """That of a profile, before its first balloon."""
        unknowns = GoreUnknowns.of(profile, count, plain_gores(profile, count))
        edge = mesh_size or default_size(unknowns.bag(np.zeros(unknowns.size)), VERTICES)
        return cls(unknowns, film, pressure, edge)

    @property
    def size(self) -> float:
        """The diagonal of the body's box [m]."""
        return body_size(self.unknowns.profile)

    def run(self) -> GoreIterate:
        """The best of the corrected patterns."""
        best = self.begun()
        step = self._step(best)
        for _ in range(STEPS):
            current = self._stepped(best, step)
            if current is None or current.error >= best.error:
                step = 0.5 * step
                continue
            stalled = current.error > STALLED * best.error
            best = current
            if stalled or best.error < ENOUGH * self.size:
                break
            step = self._step(best)
        return best

    def _stepped(self, best: GoreIterate, step: Floats) -> GoreIterate | None:
        """The balloon after a step from the best one; None where that folds its mesh over."""
        values = best.values + step
        try:
            meshed = best.meshed.with_bag(self.unknowns.bag(values))
        except AssemblyError:
            return None
        return self._inflated(values, meshed, best.inflation)

    def begun(self) -> GoreIterate:
        """The balloon of plain gores."""
        nothing = np.zeros(self.unknowns.size)
        return self._inflated(nothing, mesh_bag(self.unknowns.bag(nothing), self.edge), None)

    def proof(self, best: GoreIterate) -> GoreIterate:
        """The balloon of the same pattern on another mesh, from the body of revolution."""
        return self._inflated(best.values, mesh_bag(best.meshed.bag, PROOF_MESH * self.edge), None)

    def _inflated(self, values: Floats, meshed: MeshedBag, earlier: Inflation | None) -> GoreIterate:
        profile, count, gores = self.unknowns.profile, self.unknowns.count, self.unknowns.gores(values)
        self.balloons += 1
        begin, end = (1.0 - 0.8 ** (self.balloons - k) for k in (1, 0))
        pressure, lift = self.pressure, None
        if isinstance(pressure, RisingPressure):
            lift = Lift(pressure.gradient, lower_end(meshed, profile, count))
            pressure = pressure.lower
        inflation = inflate(
            meshed.assembly,
            self.film,
            pressure,
            lift=lift,
            start=on_profile(meshed, profile, gores, count) if earlier is None else earlier.positions,
            backend=self.backend,
            model=self.model,
            progress=part_of(self.progress, begin, end),
        )
        if lift is None:
            inflation = replace(inflation, positions=self._at_height(meshed, gores, inflation.positions))
        away, apart, _ = self._off(meshed, gores, inflation.positions)
        return GoreIterate(values, meshed, inflation, away, apart)

    def _off(
        self, meshed: MeshedBag, gores: Gores, positions: Floats, changes: Floats | None = None
    ) -> tuple[Floats, float, Floats]:
        """GoreIterate.away and apart of a balloon, and how `away` (m,) follows changes (n, 3, k): (m, k).

        changes  None: of its height alone
        """
        profile, points = self.unknowns.profile, beside_axis(positions)
        if changes is None:
            changes = np.broadcast_to([[[0.0], [0.0], [1.0]]], (len(positions), 3, 1))
        away, normals = off_profile(profile, points)
        fields = [np.column_stack([away, moves_off(positions, normals, changes)])]
        for _, place, ahead in profile_ends(profile):
            along = np.broadcast_to(ahead, points.shape)
            fields.append(
                RIM * np.column_stack([(points - place) @ ahead, moves_off(positions, along, changes)])
            )
        lines = across_gores(meshed, gores, self.unknowns.count, np.concatenate(fields, axis=1))
        width = fields[0].shape[1]
        between = [lines[1, :, :width]]
        for number, (station, _, _) in enumerate(profile_ends(profile), start=1):
            between.append(lines[1, [station], number * width : (number + 1) * width])
        rows = np.concatenate(between)
        return rows[:, 0], float(np.abs(lines[0, :, 0] - lines[2, :, 0]).max()), rows[:, 1:]

    def _at_height(self, meshed: MeshedBag, gores: Gores, positions: Floats) -> Floats:
        """The balloon moved up or down to where its gores are nearest to the profile half way."""
        heights = np.zeros(3)
        for _ in range(3):
            off, _, upwards = self._off(meshed, gores, positions + heights)
            heights[2] -= float(off @ upwards[:, 0]) / max(float(np.sum(upwards**2)), 1e-12)
        return positions + heights

    def _step(self, current: GoreIterate) -> Floats:
        """The change of the unknowns that brings what is half way to the profile, as far as it is linear."""
        unknowns, meshed, positions = self.unknowns, current.meshed, current.inflation.positions
        moves = meshed.rest_moves(unknowns.point_moves(current.values))
        changes = position_changes(current.inflation, self.film, moves, self.backend).changes
        free = float(current.inflation.report.lift is None)  # to move up as a whole
        upwards = np.broadcast_to([[[0.0], [0.0], [free]]], (len(positions), 3, 1))
        changes = np.concatenate([changes, upwards], axis=2)
        _, _, matrix = self._off(meshed, unknowns.gores(current.values), positions, changes)
        per_part = np.sqrt(STATIONS)
        bends = BENDS * self.size * per_part * unknowns.bends
        small = DAMPING * current.error * per_part * np.eye(unknowns.size)
        rows = [matrix, *(np.pad(part, ((0, 0), (0, 1))) for part in (bends, small))]
        goals = [-current.away, -bends @ current.values, np.zeros(len(small))]
        step = np.linalg.lstsq(np.concatenate(rows), np.concatenate(goals), rcond=None)[0][:-1]
        return np.asarray(step * min(1.0, LARGEST / max(float(np.abs(step).max()), 1e-12)))


def body_size(profile: Profile) -> float:
    """The diagonal of the box round the body of a profile [m]."""
    width, height = 2.0 * float(profile.points[:, 0].max()), float(np.ptp(profile.points[:, 1]))
    return float(np.sqrt(2.0 * width * width + height * height))


def _design(correction: GoreCorrection, proof: GoreIterate, asked: float = REACHED) -> BagDesign:
    """The design, with what is to be said about it; asked: the error that is none, in parts of the size."""
    profile, size = correction.unknowns.profile, correction.size
    count, assembly = correction.unknowns.count, proof.meshed.assembly
    residual = gore_residual(profile, assembly, proof.inflation.positions, count)
    warnings = [*profile.notes]
    if not proof.inflation.report.converged:
        warnings.append(NOT_AT_REST)
    if not (reached := proof.error <= asked * size):
        most = float(np.abs(proof.away[:STATIONS]).max())
        warnings.append(
            f"The film stays up to {length_text(most, 3)} away from the profile,"
            " even half way between the seams and the middle of the gores: it cannot take this shape. Round"
            " the profile where it is flat, hollow or sharp."
        )
    return BagDesign(
        profile,
        proof.meshed.bag,
        proof.meshed,
        within_open_ends(proof.meshed, proof.inflation),
        size,
        residual,
        proof.apart,
        profile.points,
        correction.balloons,
        time.perf_counter() - correction.started,
        reached,
        tuple(warnings),
    )

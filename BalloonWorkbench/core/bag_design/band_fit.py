# SPDX-License-Identifier: LGPL-2.1-or-later
"""Letters with a side band: front and back are corrected until the balloon looks like the drawing.

The unknown is the seam of the front, which is also that of the back, mirrored; the band keeps its width and
follows the length of that seam. What is seen is mostly the middle of the band, which bulges out between both
seams: the distance from silhouette to drawing is what the seam is moved by.
"""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from BalloonWorkbench.core.bag_design.bag_design import BagDesign
from BalloonWorkbench.core.bag_design.band_iterate import (
    BandIterate,
    BandSimulation,
    make_band_iterate,
    missing,
    smooth_moves,
)
from BalloonWorkbench.core.bag_design.band_start import first_pattern
from BalloonWorkbench.core.bags.mesh_bag import default_size
from BalloonWorkbench.core.bodies.banded import SideBand, band_joints, banded_bag, evenly_joined
from BalloonWorkbench.core.correction.clearance import CUT_CLEARANCE
from BalloonWorkbench.core.correction.mixing import AndersonMixing
from BalloonWorkbench.core.correction.seam_map import SeamMap
from BalloonWorkbench.core.correction.stages import COARSENING
from BalloonWorkbench.core.correction.step import CLAMP
from BalloonWorkbench.core.correction.summary import MOST_SENTENCES, NOT_AT_REST, REACHED, far_sentence
from BalloonWorkbench.core.correction.symmetric_pattern import NO_SYMMETRY, PatternSymmetry, pattern_symmetry
from BalloonWorkbench.core.design.compare import far_stretches, misfit
from BalloonWorkbench.core.errors import InputError, MeshError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.geometry.normals import corners
from BalloonWorkbench.core.geometry.polyline import point_at
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.outline.symmetry import find_mirror, mirrored
from BalloonWorkbench.core.outline.validity import check
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.types import Ints, Progress, no_progress
from BalloonWorkbench.core.units import length_text

VERTICES = 2500  # of an automatic mesh, all panels together
SAMPLES = 200  # of the drawing and the pattern along the larger dimension
GAIN = 1.3  # a straight arm must change by pi / 2 for a silhouette that changes by 1, a disc by less
SMOOTHING = 1.0  # mesh sizes
COARSE, FINE = 9, 6  # balloons of each stage, at most
ENOUGH = 5e-4  # mean error, of the larger dimension, at which nothing more is gained
STALLED = 0.9  # an iterate that leaves more than this part of the best error brings nothing
PROOF_MESHES = (0.9, 0.83)  # mesh sizes of the proofs, of that of the correction
SAME, PROMISED = 1.5, 2e-3  # the proof is another balloon when its error is more than both say
PIECE = 0.96  # of the longest piece of the band at first: the correction may make it longer
HALVINGS = 6  # of a step that leads to a pattern without a mesh
SYMMETRIC = 5e-4  # of its size, a drawing and its mirrored or turned image are apart at most to be the same
WIDE = 1.1  # of the mean width of the drawing: a wider band leaves little of the faces of its arms


def fit_band(
    outline: Outline,
    band: SideBand,
    film: Film,
    pressure: float,
    *,
    mesh_size: float | None = None,
    backend: str | None = None,
    model: Model | None = None,
    progress: Progress = no_progress,
) -> BagDesign:
    """The letter with a side band whose inflated silhouette is the outline, as nearly as film allows.

    pressure [Pa]; mesh_size [m], None for about VERTICES vertices. Raises what banded_bag, check, mesh_bag
    and inflate raise; Cancelled when progress returns False.
    """
    began = time.perf_counter()
    target = check(outline)
    banded_bag(target, band.width, band.piece)
    _check(target, band.width)
    correction = begun(target, band, film, pressure, mesh_size)
    simulation = replace(correction.simulation, backend=backend, model=model, progress=progress)
    correction.simulation = simulation
    correction.run(COARSENING, COARSE)
    best = correction.run(1.0, FINE)
    proof, other = correction.proven(best)
    return _design(outline, correction, proof, other, time.perf_counter() - began)


def _check(target: Outline, band: float) -> None:
    """Raise InputError where the band is as long as half of the way round the widest part, or longer."""
    package = shapely()
    film = package.Polygon(target.outer, target.holes)
    widest = 2.0 * float(package.maximum_inscribed_circle(film).length)
    if band >= 0.5 * np.pi * widest:
        width = 2.0 * target.area / target.perimeter
        raise InputError(
            f"The side band of {length_text(band)} leaves nothing of the front, whose widest part is"
            f" {length_text(widest, 2)} wide: give it at most {length_text(WIDE * width, 2)}."
        )


@dataclass
class BandCorrection:
    """The state of the iteration."""

    simulation: BandSimulation
    symmetry: PatternSymmetry
    drawn: SeamMap  # whose pattern is the drawing
    seam_map: SeamMap  # of the next iterate
    edge: float  # of the wanted mesh [m]
    clearance: float  # between facing parts of the pattern [m]
    balloons: int = 0

    @property
    def size(self) -> float:
        """The larger dimension of the drawing [m]."""
        return max(self.simulation.target.size)

    def next_simulation(self) -> BandSimulation:
        """That of the next balloon, which tells its part of the whole progress."""
        self.balloons += 1
        return replace(self.simulation, progress=_part(self.simulation.progress, self.balloons))

    def run(self, coarsening: float, most: int, first: BandIterate | None = None) -> BandIterate:
        """Correct the pattern on a mesh so much coarser, with so many balloons at most; the best of them.

        first  the balloon to set out from, on its own mesh
        """
        edge, rule = coarsening * self.edge, AndersonMixing(GAIN)
        best, last = first, first
        if first is not None:
            self.seam_map = self._moved(first, rule, edge)
        for number in range(most):
            self.seam_map = self.symmetry.symmetrised(self.seam_map, None if last is None else last.seam_map)
            current = self._next(edge, last)
            stalled = best is not None and current.error > STALLED * best.error
            if best is None or current.error < best.error:
                best = current
            if best.error <= ENOUGH * self.size or (stalled and number > 2):
                break
            last = current
            self.seam_map = self._moved(current, rule, edge)
        assert best is not None
        self.seam_map = best.seam_map
        return best

    def proven(self, best: BandIterate) -> tuple[BandIterate, BandIterate]:
        """The pattern's balloon on another mesh, from the start shape, and the one that led to the pattern.

        Arms may lean to one side or the other. Where they do so on the other mesh, the correction goes on
        from there, once.
        """
        proof = self._as_cut(best, PROOF_MESHES[0])
        if self.same(proof, best):
            return proof, best
        better = self.run(PROOF_MESHES[0], FINE, proof)
        anew = self._as_cut(better, PROOF_MESHES[1])
        return (anew, better) if anew.error < proof.error else (proof, best)

    def _as_cut(self, best: BandIterate, share: float) -> BandIterate:
        """The balloon of the pattern with equal pieces of its band, on a mesh of this share of the size."""
        seam_map, joints = evenly_pieced(best.seam_map, self.simulation.joints)
        self.simulation = replace(self.simulation, joints=joints)
        return make_band_iterate(self.next_simulation(), seam_map, share * self.edge)

    def same(self, one: BandIterate, other: BandIterate) -> bool:
        """Whether two balloons of a pattern are about as near to the drawing."""
        return one.error <= max(SAME * other.error, PROMISED * self.size)

    def _next(self, edge: float, last: BandIterate | None) -> BandIterate:
        """The balloon of the next pattern, or of one that goes less far where that has no mesh."""
        earlier = self.drawn if last is None else last.seam_map
        for _ in range(HALVINGS):
            try:
                return make_band_iterate(self.next_simulation(), self.seam_map, edge, last)
            except MeshError as error:
                self.seam_map = self.seam_map.half_back(earlier, error.place, 2.0 * edge)
        return make_band_iterate(self.next_simulation(), self.seam_map, edge, last)

    def _moved(self, current: BandIterate, rule: AndersonMixing, edge: float) -> SeamMap:
        """The seam map of an iterate with its pattern moved by one step."""
        fields = missing(current, self.simulation.joints, edge, SMOOTHING * edge)
        point = np.concatenate(current.seam_map.pattern)
        step = rule.mixed(point.ravel(), np.concatenate(fields).ravel()).reshape(-1, 2)
        step *= min(1.0, CLAMP * self.size / max(float(np.linalg.norm(step, axis=1).max()), 1e-300))
        stops = np.cumsum([len(loop) for loop in current.seam_map.pattern])[:-1]
        return current.seam_map.moved(tuple(np.split(step, stops)), 0.0, self.clearance)


def evenly_pieced(seam_map: SeamMap, joints: Sequence[Ints]) -> tuple[SeamMap, tuple[Ints, ...]]:
    """The map with the points where pieces of the band meet moved along its loops, and their numbers.

    The pieces of the pattern are then equally long wherever no corner decides.
    """
    drawing, pattern, numbers = list(seam_map.drawing), list(seam_map.pattern), []
    for number, own in enumerate(joints):
        places, nearest = evenly_joined(pattern[number], own, corners(drawing[number]))
        counter = np.arange(len(pattern[number]) + 1, dtype=np.float64)
        for loops in (drawing, pattern):
            moved = loops[number].copy()
            moved[nearest] = point_at(moved, counter, places)
            loops[number] = moved
        numbers.append(nearest)
    return replace(seam_map, drawing=tuple(drawing), pattern=tuple(pattern)), tuple(numbers)


def begun(
    target: Outline, band: SideBand, film: Film, pressure: float, mesh_size: float | None
) -> BandCorrection:
    """The correction of a checked target, before its first iterate: the pattern is the drawing."""
    mirror = find_mirror(target) if film.young_modulus_across is None else None
    if mirror is not None and mirror.error > SYMMETRIC:
        mirror = None
    if mirror is not None:
        target = mirrored(target, mirror)
    drawn, symmetry = SeamMap.identity(target, max(target.size) / SAMPLES), NO_SYMMETRY
    if film.young_modulus_across is None:
        drawn, symmetry = pattern_symmetry(drawn, mirror, SYMMETRIC)
    clearance = 2.0 * film.seal_width + CUT_CLEARANCE
    first = symmetry.symmetrised(first_pattern(drawn, target, band.width, clearance))
    joints = band_joints(first.pattern, PIECE * band.piece)
    edge = mesh_size or default_size(banded_bag(first.outline, band.width, joints=joints), VERTICES)
    moves = [there - here for there, here in zip(first.pattern, drawn.drawing, strict=True)]
    first = drawn.moved(smooth_moves(drawn.drawing, moves, edge), 0.0, clearance)
    simulation = BandSimulation(target, film, pressure, band.width, joints)
    return BandCorrection(simulation, symmetry, drawn, symmetry.symmetrised(first), edge, clearance)


def _part(progress: Progress, number: int) -> Progress:
    """Progress of one balloon within the whole correction, which seldom needs all of them."""

    def report(fraction: float, text: str) -> bool:
        return progress(1.0 - 0.85 ** (number - 1 + fraction), f"pass {number}: {text}")

    return report


def _design(
    outline: Outline, correction: BandCorrection, proof: BandIterate, other: BandIterate, seconds: float
) -> BagDesign:
    """The design, with what is to be said about it: its error is that of the proof."""
    error = misfit(outline, proof.silhouette).residual
    reached = error.mean <= REACHED * correction.size
    return BagDesign(
        outline,
        proof.meshed.bag,
        proof.meshed,
        proof.inflation,
        correction.size,
        error,
        0.0,
        np.concatenate(outline.loops),
        correction.balloons,
        seconds,
        reached,
        (*outline.notes, *_warnings(correction, proof, other, reached)),
    )


def _warnings(correction: BandCorrection, proof: BandIterate, other: BandIterate, reached: bool) -> list[str]:
    """What is not as drawn, in one sentence each."""
    target, band = correction.simulation.target, correction.simulation.band
    error, width = proof.misfit.residual, 2.0 * target.area / target.perimeter
    warnings = []
    if not proof.inflation.report.converged:
        warnings.append(NOT_AT_REST)
    if not reached:
        warnings.append(
            f"The inflated outline stays {length_text(error.mean)} from the drawing on average:"
            " film cannot follow this shape everywhere. Round off notches and widen thin parts."
        )
    if not reached and band > WIDE * width:
        warnings.append(
            f"The side band is too wide for this drawing, whose parts are about {length_text(width, 2)} wide:"
            f" give it at most {length_text(WIDE * width, 2)}."
        )
    if not correction.same(proof, other):
        warnings.append(
            "Parts of the balloon may lean to one side or the other: the inflated outline is"
            f" {length_text(other.error, 2)} to {length_text(error.mean, 2)} from the drawing."
            " Another width of the side band may hold them."
        )
    unreached = far_stretches(target, proof.misfit)
    return warnings + [far_sentence(stretch, folds=False) for stretch in unreached[:MOST_SENTENCES]]

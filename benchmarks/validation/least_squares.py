# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pattern correction by least squares with the exact derivatives of the balloon at rest, for comparison.

Levenberg 1944, Marquardt 1963. The pattern moves by cubic splines along its seam, with kinks at the corners
of the drawing. What is to become small is how far the seam is seen from the drawing, across it, wherever the
balloon lies; far places count less (Huber 1964), and what is added is smooth where the film does not ask for
more.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.linalg import block_diag

from BalloonWorkbench.core.correction.clearance import CUT_CLEARANCE
from BalloonWorkbench.core.correction.fit import SAMPLES
from BalloonWorkbench.core.correction.iterate import Iterate, Simulation, make_iterate
from BalloonWorkbench.core.correction.seam_map import SeamMap, bridged
from BalloonWorkbench.core.correction.stages import AT_REST
from BalloonWorkbench.core.correction.step import CLAMP, DRIFT, DRIFT_ROUND, OVERHANG, TIP, Scales
from BalloonWorkbench.core.correction.symmetric_pattern import PatternSymmetry, pattern_symmetry
from BalloonWorkbench.core.design.correspondence import goals
from BalloonWorkbench.core.design.design import Design
from BalloonWorkbench.core.design.visible_seam import visible_places
from BalloonWorkbench.core.errors import MeshError, SolverError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.geometry.normals import corners, tangents
from BalloonWorkbench.core.geometry.polyline import arc_lengths, point_weights
from BalloonWorkbench.core.geometry.vectors import perpendicular, unit
from BalloonWorkbench.core.mesh.reuse import harmonic
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.outline.symmetry import exact_mirror
from BalloonWorkbench.core.solver.sensitivity import position_changes
from BalloonWorkbench.core.types import Floats, Ints

STEPS = 8
NODES = 4.0  # mesh sizes between the nodes of the splines
FAR, FAR_MEDIANS = 2e-3, 3.0  # of the size and of the median: from the larger one a distance counts less
ROUGHNESS = 4.0  # weight of a bend of what is added, over the length of an edge of the mesh
FIRST_DAMPING, LESS, MORE = 1e-3, 0.2, 8.0  # of the steps; after a good one, and after one that failed
GOOD = 0.7  # of the gain that was hoped for
TRIALS = 4  # of one step
LITTLE = 0.9  # a step that leaves more than this part of the cost is the last one
_CORNER = np.radians(30.0)


def to_the_end(design: Design, film: Film, pressure: float, vertices: int) -> Iterate:
    """The balloon whose seam is nearest to the drawing, sought from the pattern of a design.

    The pattern of a symmetric drawing stays symmetric, but not its mesh: a symmetric one makes a ring oval.
    """
    target, size = design.target, max(design.target.size)
    drawn, symmetry = pattern_symmetry(SeamMap.identity(target, size / SAMPLES), exact_mirror(target))
    begun = drawn.resized(design.pattern, 1.0)
    assert begun is not None
    edge = size_for(design.pattern, vertices)
    simulation = Simulation(target, film, pressure, None, None, edge, newton=AT_REST.newton)
    scales = Scales(size, edge, edge, 2.0 * film.seal_width + CUT_CLEARANCE)
    return _Search(simulation, scales, symmetry, make_iterate(simulation, begun)).run()


@dataclass(frozen=True)
class _Distances:
    """How far seam vertices are seen from the drawing.

    found       (r,) m, in directions (r, 2)
    vertices    (r,) of the panel
    weights     (r,), which add up to 1
    """

    found: Floats
    directions: Floats
    vertices: Ints
    weights: Floats

    def far(self, size: float) -> float:
        """From where on they count less [m]."""
        return max(FAR * size, FAR_MEDIANS * float(np.median(np.abs(self.found))))

    def cost(self, far: float) -> float:
        """Mean of their squares, of far ones less [m2]."""
        return float(self.weights @ (2.0 * far**2 * (np.sqrt(1.0 + (self.found / far) ** 2) - 1.0)))


def _distances(current: Iterate, scales: Scales) -> _Distances:
    """Across the drawing; of its corners along it, too."""
    parts = []
    for drawing, node, seam in zip(current.seam_map.drawing, current.nodes, current.panel.loops):
        points, sharp = current.inflation.positions[seam, :2], node.corner_nodes
        drift = min(DRIFT * scales.edge, DRIFT_ROUND * float(arc_lengths(drawing)[-1]))
        places = visible_places(points, current.silhouette, OVERHANG * scales.size)
        places[sharp] = points[sharp]
        reach = np.full(len(points), drift)
        off = places - goals(drawing, places, node.lengths, sharp, node.corners, reach)
        drawn = node.placed_on(drawing)
        along, weight = unit(tangents(drawn)), point_weights(drawn)
        directions = np.concatenate([perpendicular(along), along[sharp]])
        which = np.concatenate([np.arange(len(seam)), sharp])
        found = np.einsum("ij,ij->i", off[which], directions)
        parts.append((found, directions, seam[which], weight[which]))
    found, directions, vertices, weights = map(np.concatenate, zip(*parts))
    return _Distances(found, directions, vertices, weights / weights.sum())


@dataclass(frozen=True)
class _Answer:
    """What the film does when its seam moves by q splines along x and by the same along y.

    splines     (n, q) at the sampled points of all loops
    changes     (v, 3, 2 q) of the balloon
    smoothness  (2 q, 2 q) of what they add up to; mass: their mean square
    """

    splines: Floats
    changes: Floats
    smoothness: Floats
    mass: Floats


def _answer(current: Iterate, film: Film, scales: Scales) -> _Answer:
    loops, panel = current.seam_map.drawing, current.panel
    curves = [_splines(loop, NODES * scales.edge) for loop in loops]
    splines = block_diag(*(bridged(loop, one, TIP * scales.edge) for loop, (one, _) in zip(loops, curves)))
    bends = ROUGHNESS * scales.edge**2 * block_diag(*(bend for _, bend in curves))
    weights = np.concatenate([point_weights(loop) for loop in loops])[:, None]
    weights /= weights.sum()
    rim = np.zeros((len(panel.rest_positions), splines.shape[1]))
    for node, seam, own in zip(current.nodes, panel.loops, _by_loop(splines, loops)):
        rim[seam] = node.placed_on(own)
    free = np.setdiff1d(np.arange(len(rim)), panel.sealed)
    rim[free] = harmonic(panel, panel.sealed, free, rim[panel.sealed])
    moves = np.stack([np.kron(axis, rim) for axis in np.eye(2)], axis=1)
    changes = position_changes(current.inflation, film, moves).changes
    squares = (np.kron(np.eye(2), fields.T @ (weights * fields)) for fields in (bends, splines))
    return _Answer(splines, changes, *squares)


def _by_loop(fields: Floats, loops: Sequence[Floats]) -> tuple[Floats, ...]:
    """Fields (n, d) at the points of all loops, as one for each loop."""
    return tuple(np.split(fields, np.cumsum([len(loop) for loop in loops])[:-1]))


def _splines(loop: Floats, spacing: float) -> tuple[Floats, Floats]:
    """Splines with nodes about `spacing` [m] apart, and their second derivatives: (n, q) at the points."""
    lengths = arc_lengths(loop)
    here, around = lengths[:-1], float(lengths[-1])
    sharp = here[corners(loop, _CORNER, 0.5 * spacing)]
    if not len(sharp):
        eye = np.eye(max(4, round(around / spacing)))
        nodes = np.linspace(0.0, around, len(eye) + 1)
        spline = CubicSpline(nodes, np.vstack([eye, eye[:1]]), bc_type="periodic")
        return spline(here), spline(here, 2)
    ends = np.append(sharp[1:], sharp[0] + around)
    counts = [max(1, round((end - start) / spacing)) for start, end in zip(sharp, ends)]
    values, bends = np.zeros((2, len(here), sum(counts)))
    for first, start, end, count in zip(np.cumsum([0, *counts]), sharp, ends, counts):
        ahead = np.mod(here - start, around)
        rows = np.flatnonzero(ahead < end - start - 1e-12 * around)[:, None]
        columns = np.arange(first, first + count + 1) % sum(counts)
        spline = CubicSpline(np.linspace(0.0, end - start, count + 1), np.eye(count + 1), bc_type="natural")
        np.add.at(values, (rows, columns), spline(ahead[rows[:, 0]]))
        np.add.at(bends, (rows, columns), spline(ahead[rows[:, 0]], 2))
    return values, bends


@dataclass
class _Search:
    """The way from one balloon to the next."""

    simulation: Simulation
    scales: Scales
    symmetry: PatternSymmetry
    current: Iterate
    damping: float = FIRST_DAMPING
    added: Floats | float = 0.0  # (2 q,) how much of each spline, since the first balloon

    def run(self) -> Iterate:
        """The best balloon by its silhouette, which the seam only nearly is."""
        best = self.current
        for _ in range(STEPS):
            left = self._step()
            best = min(best, self.current, key=lambda balloon: balloon.misfit.residual.mean)
            if left > LITTLE:
                break
        return best

    def _step(self) -> float:
        """Go to a better balloon; what it leaves of the cost, or 1 where none is found."""
        answer = _answer(self.current, self.simulation.film, self.scales)
        distances = _distances(self.current, self.scales)
        far = distances.far(self.scales.size)
        added = self.added + np.zeros(len(answer.mass))
        cost = distances.cost(far) + float(added @ answer.smoothness @ added)
        for _ in range(TRIALS):
            share, hoped = self._solved(answer, distances, far, added)
            trial = self._trial(answer, share)
            if trial is not None:
                following = added + share
                left = _distances(trial, self.scales).cost(far) + following @ answer.smoothness @ following
                if left < cost:
                    self.current, self.added = trial, following
                    self.damping *= LESS if cost - left > GOOD * hoped else 1.0
                    return float(left / cost)
            self.damping *= MORE
        return 1.0

    def _solved(
        self, answer: _Answer, distances: _Distances, far: float, added: Floats
    ) -> tuple[Floats, float]:
        """How much (2 q,) of each spline is best added, and the gain that it promises.

        The balloon may move and turn as a whole, too.
        """
        places = self.current.inflation.positions[distances.vertices, :2]
        lever = perpendicular(places - places.mean(axis=0)) / self.scales.size
        seen = np.einsum("ri,rij->rj", distances.directions, answer.changes[distances.vertices, :2])
        turned = np.einsum("ri,ri->r", distances.directions, lever)
        rows, count = np.column_stack([seen, distances.directions, turned]), len(added)
        weights = distances.weights / np.sqrt(1.0 + (distances.found / far) ** 2)
        normal, right = rows.T @ (weights[:, None] * rows), -rows.T @ (weights * distances.found)
        normal[:count, :count] += answer.smoothness + self.damping * answer.mass
        right[:count] -= answer.smoothness @ added
        normal[np.diag_indices_from(normal)] += 1e-9 * normal.diagonal().mean()
        solution = np.linalg.solve(normal, right)
        share = solution[:count]
        undamped = solution @ normal @ solution - self.damping * (share @ answer.mass @ share)
        return share, float(2.0 * solution @ right - undamped)

    def _trial(self, answer: _Answer, share: Floats) -> Iterate | None:
        """The balloon of the pattern with so much of each spline; None where it is too far or none."""
        field = answer.splines @ share.reshape(2, -1).T
        if float(np.linalg.norm(field, axis=1).max()) > CLAMP * self.scales.size:
            return None
        before = self.current.seam_map
        fields = _by_loop(field, before.pattern)
        moved = before.moved(fields, TIP * self.scales.edge, self.scales.clearance)
        even = self.symmetry.symmetrised(moved, before)
        try:
            return make_iterate(self.simulation, even, self.current, keep_mesh=True)
        except (MeshError, SolverError):
            return None

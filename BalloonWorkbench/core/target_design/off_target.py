# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far a balloon is from its target, how that follows its moves, and the balloon laid over it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from BalloonWorkbench.core.design.design import Residual
from BalloonWorkbench.core.design.film_residual import film_residual
from BalloonWorkbench.core.geometry.vectors import unit
from BalloonWorkbench.core.targets.half_edges import area_vectors
from BalloonWorkbench.core.targets.nearest_surface import NearestSurface
from BalloonWorkbench.core.targets.refine import Split, refined
from BalloonWorkbench.core.targets.target import Target
from BalloonWorkbench.core.types import Floats, Ints

#: Edges of a target that is sampled, of the diagonal.
_FINE = 0.02
_HAIR = 1e-6  # of the diagonal: nearer points take the normal of the surface
#: The balloon is turned and moved onto the target in so many steps, or until one is no longer than this part
#: of the diagonal.
_STEPS, _STILL = 3, 1e-3


@dataclass(frozen=True)
class OffTarget:
    """Distances (n,) m of points from a target, positive outside; directions (n, 3) in which they grow."""

    distances: Floats
    directions: Floats


class TargetSurface:
    """A target to which distances are measured."""

    def __init__(self, target: Target) -> None:
        self.target = target
        self._nearest = NearestSurface(target.points, target.triangles)
        self._normals = unit(target.area_vectors)

    @cached_property
    def samples(self) -> Split:
        """The target in triangles so small that distances from film are linear on them."""
        return refined(self.target.points, self.target.triangles, _FINE * self.target.diagonal)

    def off(self, points: Floats) -> OffTarget:
        """Of points (n, 3)."""
        nearest = self._nearest.query(points)
        outward = (points - nearest.places) * np.sign(nearest.distances)[:, None]
        near = np.abs(nearest.distances) < _HAIR * self.target.diagonal
        directions = np.where(near[:, None], self._normals[nearest.triangles], unit(outward))
        return OffTarget(nearest.distances, directions)

    def laid_over(self, points: Floats, weights: Floats) -> tuple[Floats, Floats, OffTarget]:
        """Points (n, 3) turned and moved as a whole so that their weighted distances are least.

        Also the turn (3, 3), by which rows of vectors are multiplied from the right, and the distances.
        """
        whole, size = np.eye(3), self.target.diagonal
        off = self.off(points)
        for _ in range(_STEPS):
            middle = points.mean(axis=0)
            columns = rigid_moves((points - middle) / size, off.directions)
            matrix = weights[:, None] * columns
            step = np.linalg.lstsq(matrix, -weights * off.distances, rcond=1e-6)[0]
            turn = _turn(step[3:] / size).T
            points, whole = middle + (points - middle) @ turn + step[:3], whole @ turn
            off = self.off(points)
            if np.abs(step).max() < _STILL * size:
                break
        return points, whole, off


def rigid_moves(points: Floats, directions: Floats) -> Floats:
    """How distances follow three shifts and three turns about the origin: (n, 6)."""
    return np.column_stack([directions, np.cross(points, directions)])


def _turn(angles: Floats) -> Floats:
    """The rotation (3, 3) about an axis by as much as the vector (3,) is long [rad] (Rodrigues)."""
    angle = float(np.linalg.norm(angles))
    if angle < 1e-15:
        return np.eye(3)
    x, y, z = angles / angle
    skew = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.asarray(np.eye(3) + np.sin(angle) * skew + (1.0 - np.cos(angle)) * skew @ skew)


def vertex_areas(points: Floats, triangles: Ints) -> Floats:
    """A third of the areas of the triangles round each of points (n, 3): (n,) m2."""
    third = np.linalg.norm(area_vectors(points, triangles), axis=1) / 3.0
    return np.asarray(np.bincount(triangles.ravel(), np.repeat(third, 3), len(points)), dtype=np.float64)


def target_residual(surface: TargetSurface, points: Floats, triangles: Ints) -> Residual:
    """How far film of triangles between points (n, 3) and the target are from each other, by area [m].

    The larger of both ways: film that lies on the body all over may leave out a part of it. Film: as
    curved_film gives it.
    """
    there, back, _ = both_ways(surface, points, triangles)
    return Residual(max(there.mean, back.mean), max(there.p95, back.p95), max(there.max, back.max))


def both_ways(
    surface: TargetSurface, points: Floats, triangles: Ints
) -> tuple[Residual, Residual, tuple[float, float]]:
    """How far the film is from the target, and the target from the film, each by its area; clearances [m]."""
    there, back = _apart(surface, points, triangles)
    residuals = film_residual(there, points, triangles), film_residual(back, *surface.samples[:2])
    return *residuals, _clearances(there, back, triangles)


def clearances(surface: TargetSurface, points: Floats, triangles: Ints) -> tuple[float, float]:
    """How far outside of the target the film lies where that is least, and where it is most [m].

    Both ways, as in target_residual: a body that comes through the film between its vertices counts, too.
    """
    return _clearances(*_apart(surface, points, triangles), triangles)


def _apart(surface: TargetSurface, points: Floats, triangles: Ints) -> tuple[Floats, Floats]:
    """How far the film's points (n,) are from the target, and the target's samples (k,) from the film [m]."""
    film = NearestSurface(points, triangles)
    return surface.off(points).distances, film.query(surface.samples.points).distances


def _clearances(there: Floats, back: Floats, triangles: Ints) -> tuple[float, float]:
    away = np.concatenate([there[np.unique(triangles)], -back])
    return float(away.min()), float(away.max())

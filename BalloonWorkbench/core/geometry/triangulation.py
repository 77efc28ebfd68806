# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles of the plane: their areas, and values at any place between points."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from BalloonWorkbench.core.geometry.nearest import kd_tree
from BalloonWorkbench.core.geometry.vectors import cross, perpendicular
from BalloonWorkbench.core.packages import without_scipy
from BalloonWorkbench.core.types import Floats, Ints

_CHUNK = 500_000  # pairs of place and triangle looked at together


def signed_areas(points: Floats, triangles: Ints) -> Floats:
    """Areas (m,) of triangles, positive when counter-clockwise."""
    a, b, c = np.moveaxis(points[triangles], 1, 0)
    return 0.5 * cross(b - a, c - a)


def side_lengths(points: Floats, triangles: Ints) -> Floats:
    """Lengths (m, 3) of triangles' sides; column k is the side opposite to corner k."""
    corners = points[triangles]
    return np.linalg.norm(np.roll(corners, -2, axis=1) - np.roll(corners, -1, axis=1), axis=2)


def corner_angles(points: Floats, triangles: Ints) -> Floats:
    """Angles (m, 3) at the corners [rad]; 0 and pi for degenerate triangles."""
    a, b, c = side_lengths(points, triangles).T
    tiny = np.finfo(float).tiny
    cosines = np.stack(
        [
            (b * b + c * c - a * a) / np.maximum(2.0 * b * c, tiny),
            (c * c + a * a - b * b) / np.maximum(2.0 * c * a, tiny),
            (a * a + b * b - c * c) / np.maximum(2.0 * a * b, tiny),
        ],
        axis=1,
    )
    return np.arccos(np.clip(cosines, -1.0, 1.0))


class Located:
    """A triangulation of points (n, 2) in which places are looked up; triangles may overlap a little."""

    def __init__(self, points: Floats, triangles: Ints) -> None:
        self._triangles = triangles
        a, b, c = np.moveaxis(points[triangles], 1, 0)
        self._origin = c
        self._low, self._high = points[triangles].min(axis=1), points[triangles].max(axis=1)
        u, v = a - c, b - c
        area = cross(u, v)
        area = np.where(np.abs(area) < 1e-300, 1e-300, area)[:, None]
        # area coordinates of a place p are rows @ (p - c)
        self._rows = np.stack([-perpendicular(v) / area, perpendicular(u) / area], axis=1)

    def values(self, field: Floats, places: Floats) -> Floats:
        """A field (n, d) at places (k, 2): linear inside, that of the nearest edge for places outside."""
        best, weights = self._triangles_at(places)
        share = np.clip(weights, 0.0, 1.0)
        share /= share.sum(axis=1, keepdims=True)
        return np.asarray(np.einsum("ka,kad->kd", share, field[self._triangles[best]]))

    def under(self, places: Floats) -> Ints:
        """The triangles in which places (k, 2) lie, of those inside; that of the nearest where none is."""
        best, weights = self._enclosing(places)
        if (best >= 0).any():
            return np.asarray(best[best >= 0])
        best, weights = self._of_all(places)
        depth = weights.min(axis=1)
        return np.asarray(best[depth >= min(0.0, float(depth.max()))])

    def _triangles_at(self, places: Floats) -> tuple[Ints, Floats]:
        """Of each place (k, 2) the triangle, and its area coordinates there (k, 3), negative outside."""
        nearest, weights = self._enclosing(places)
        outside = np.flatnonzero(nearest < 0)  # or on a side, where rounding decides
        nearest[outside], weights[outside] = self._of_all(places[outside])
        return nearest, weights

    def _enclosing(self, places: Floats) -> tuple[Ints, Floats]:
        """The same for places inside a triangle, -1 for others: only triangles round a place are tried."""
        low, high = self._low, self._high
        tried = [
            np.stack(np.nonzero(((some[:, None] >= low) & (some[:, None] <= high)).all(axis=2)))
            + np.array([[first], [0]])
            for first, some in self._in_chunks(places)
        ]
        place, triangle = np.concatenate(tried, axis=1)
        share = np.einsum("kab,kb->ka", self._rows[triangle], places[place] - self._origin[triangle])
        each = np.concatenate([share, 1.0 - share.sum(axis=1, keepdims=True)], axis=1)
        depth = each.min(axis=1)
        order = np.lexsort(
            (-triangle, depth, place)
        )  # the deepest of each place is the last, as the first is
        order = order[depth[order] >= 0.0]
        nearest, weights = np.full(len(places), -1, dtype=np.int32), np.empty((len(places), 3))
        nearest[place[order]], weights[place[order]] = triangle[order], each[order]
        return nearest, weights

    def _in_chunks(self, places: Floats) -> Iterator[tuple[int, Floats]]:
        """Places, some after the other, each time with the number of the first."""
        step = max(1, _CHUNK // max(len(self._triangles), 1))
        for first in range(0, len(places), step):
            yield first, places[first : first + step]

    def _of_all(self, places: Floats) -> tuple[Ints, Floats]:
        """The same for any places, each tried with all triangles."""
        nearest, weights = np.empty(len(places), dtype=np.int32), np.empty((len(places), 3))
        for first, some in self._in_chunks(places):
            share = np.einsum("mab,kmb->kma", self._rows, some[:, None] - self._origin[None])
            each = np.concatenate([share, 1.0 - share.sum(axis=2, keepdims=True)], axis=2)
            best = np.argmax(each.min(axis=2), axis=1)
            nearest[first : first + len(some)] = best
            weights[first : first + len(some)] = each[np.arange(len(some)), best]
        return nearest, weights


def interpolated(points: Floats, values: Floats, places: Floats) -> Floats:
    """Values (n, d) at points (n, 2) carried to places (k, 2): linear between them, over their Delaunay
    triangles, and outside of these that of the nearest point. Raises MissingPackageError without scipy.
    """
    try:
        from scipy.spatial import Delaunay
    except ImportError as error:
        raise without_scipy("Pattern correction needs scipy: install it with pip install scipy.") from error
    cells = Delaunay(points)
    cell = cells.find_simplex(places)
    maps = cells.transform[cell]
    share = np.einsum("kij,kj->ki", maps[:, :2], places - maps[:, 2])
    share = np.column_stack([share, 1.0 - share.sum(axis=1)])
    between = np.einsum("ki,kij->kj", share, values[cells.simplices[cell]])
    outside = cell < 0
    if outside.any():
        between[outside] = values[kd_tree(points).query(places[outside])[1]]
    return np.asarray(between)

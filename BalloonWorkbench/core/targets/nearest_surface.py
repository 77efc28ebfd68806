# SPDX-License-Identifier: LGPL-2.1-or-later
"""The place of a surface in space that is nearest to a point, and on which side of it the point is."""

from __future__ import annotations

from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from BalloonWorkbench.core.checkpoint import checkpoint
from BalloonWorkbench.core.geometry.nearest import kd_tree
from BalloonWorkbench.core.geometry.vectors import unit
from BalloonWorkbench.core.targets.half_edges import Indices, area_vectors
from BalloonWorkbench.core.types import Floats, Ints

#: Triangles that are looked at first for each point, and points looked at together.
_FEW, _CHUNK = 8, 20_000
_TINY = 1e-300


class OnSurface(NamedTuple):
    """Of each of k points the nearest place of a surface.

    triangles  (k,) number of the triangle
    places     (k, 3) m
    shares     (k, 3) of the triangle's corners
    distances  (k,) m, positive outside
    """

    triangles: Indices
    places: Floats
    shares: Floats
    distances: Floats


class NearestSurface:
    """An index of triangles (m, 3) of points (n, 3), counter-clockwise seen from outside."""

    def __init__(self, points: Floats, triangles: Ints) -> None:
        self._points, self._triangles = points, triangles
        corners = points[triangles]
        centres = corners.mean(axis=1)
        radii = np.linalg.norm(corners - centres[:, None], axis=2).max(axis=1)
        # in classes of about equal size each triangle is near its centre
        classes = np.floor(np.log2(np.maximum(radii, _TINY))).astype(np.int64)
        self._classes: list[tuple[Indices, Any, float]] = []
        # the largest class first: most places find their triangle there
        sizes, counts = np.unique(classes, return_counts=True)
        for each in sizes[np.argsort(-counts, kind="stable")]:
            own = np.flatnonzero(classes == each)
            self._classes.append((own, kd_tree(centres[own]), float(radii[own].max())))

    @cached_property
    def _corner_normals(self) -> Floats:
        """Normals (n, 3) at the points, each triangle weighted with its angle there.

        They tell inside from outside for what is nearest to a corner (Baerentzen and Aanaes 2005).
        """
        corners = self._points[self._triangles]
        normals = unit(area_vectors(self._points, self._triangles))
        total = np.zeros_like(self._points)
        for k in range(3):
            one, other = (unit(corners[:, (k + step) % 3] - corners[:, k]) for step in (1, 2))
            angles = np.arccos(np.clip(np.einsum("ij,ij->i", one, other), -1.0, 1.0))
            np.add.at(total, self._triangles[:, k], angles[:, None] * normals)
        return unit(total)

    def query(self, places: Floats) -> OnSurface:
        """The nearest places of the surface to places (k, 3)."""
        parts = [self._some(places[first : first + _CHUNK]) for first in range(0, len(places), _CHUNK)]
        parts = parts or [self._some(places)]
        return OnSurface(*(np.concatenate(each) for each in zip(*parts)))

    def _some(self, places: Floats) -> OnSurface:
        best = np.full(len(places), np.inf)
        triangle = np.zeros(len(places), dtype=np.intp)
        for own, tree, radius in self._classes:
            waiting, count = np.arange(len(places)), _FEW
            if np.isfinite(best).all():
                waiting = np.flatnonzero(tree.query(places)[0] - radius < best)
            while len(waiting):
                checkpoint()
                count = min(count, len(own))
                away, near = tree.query(places[waiting], k=np.arange(1, count + 1))
                self._improve(places, waiting, own[near], best, triangle)
                if count == len(own):
                    break
                waiting = waiting[away[:, -1] - radius < best[waiting]]
                count *= 4
        corners = self._points[self._triangles[triangle]]
        shares = nearest_shares(places, corners)
        spots = np.einsum("kc,kcd->kd", shares, corners)
        offset = places - spots
        normals = np.einsum("kc,kcd->kd", shares, self._corner_normals[self._triangles[triangle]])
        inner = shares.min(axis=1) > 1e-9
        flat = area_vectors(self._points, self._triangles[triangle])
        sides = np.einsum("kd,kd->k", offset, np.where(inner[:, None], flat, normals))
        return OnSurface(triangle, spots, shares, np.copysign(np.linalg.norm(offset, axis=1), sides))

    def _improve(self, places: Floats, rows: Indices, near: Indices, best: Floats, triangle: Indices) -> None:
        """Take the nearest of the triangles near (r, c) for the places in rows (r,), where it is nearer."""
        count = near.shape[1]
        corners = self._points[self._triangles[near.ravel()]]
        some = np.repeat(places[rows], count, axis=0)
        spots = np.einsum("kc,kcd->kd", nearest_shares(some, corners), corners)
        away = np.linalg.norm(some - spots, axis=1).reshape(-1, count)
        least = np.argmin(away, axis=1)
        nearest = away[np.arange(len(rows)), least]
        better = nearest < best[rows]
        best[rows[better]] = nearest[better]
        triangle[rows[better]] = near[np.arange(len(rows)), least][better]


def nearest_shares(places: Floats, corners: Floats) -> Floats:
    """Shares (k, 3) of the corners (k, 3, 3) of a triangle each in its place nearest to places (k, 3)."""
    a, ab, ac = corners[:, 0], corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    offset = places - a
    d00, d01, d11 = (np.einsum("kd,kd->k", *pair) for pair in ((ab, ab), (ab, ac), (ac, ac)))
    d0, d1 = np.einsum("kd,kd->k", offset, ab), np.einsum("kd,kd->k", offset, ac)
    scale = np.maximum(d00 * d11 - d01 * d01, _TINY)
    v, w = (d11 * d0 - d01 * d1) / scale, (d00 * d1 - d01 * d0) / scale
    inside = np.column_stack([1.0 - v - w, v, w])
    least = np.full(len(places), np.inf)
    outside = (inside.min(axis=1) < 0.0) | (d00 * d11 - d01 * d01 <= 1e-24 * (d00 + d11) ** 2)
    shares = inside.copy()
    for k in range(3):
        start, ahead = corners[:, k], corners[:, (k + 1) % 3] - corners[:, k]
        along = np.einsum("kd,kd->k", places - start, ahead) / np.maximum((ahead**2).sum(axis=1), _TINY)
        along = np.clip(along, 0.0, 1.0)
        away = np.linalg.norm(places - start - along[:, None] * ahead, axis=1)
        better = outside & (away < least)
        least = np.where(better, away, least)
        edge = np.zeros((len(places), 3))
        edge[:, k], edge[:, (k + 1) % 3] = 1.0 - along, along
        shares[better] = edge[better]
    return shares

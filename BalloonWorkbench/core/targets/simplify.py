# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closed surfaces of too many triangles made simpler, edge by edge, where that changes least.

Each point knows the planes of the triangles that it has stood for; an edge becomes the point that is nearest
to those of both its ends (Garland and Heckbert 1997). In each round as many edges as do not touch each other.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.checkpoint import checkpoint
from BalloonWorkbench.core.geometry.vectors import unit
from BalloonWorkbench.core.packages import without_scipy
from BalloonWorkbench.core.targets.half_edges import Indices, area_vectors, half_edges
from BalloonWorkbench.core.types import Bools, Floats, Ints

#: What the length of an edge costs beside its distance from the planes, so that triangles stay even.
_EVEN = 1e-5
#: How much a point is held where it is, beside being pulled to its planes.
_HELD = 1e-3
#: A triangle may turn by the angle of this cosine.
_TURN = 0.3
#: It does not become lower than this part of its longest side, or if it is, than so much of what it was.
_LOW, _LOWER = 0.03, 0.6
_ROUNDS = 400
_SCATTER, _GOLDEN = 1.0, 0.6180339887498949
#: Part of all edges, the cheapest, that may become points in a round.
_CHEAP = 0.4
#: How often edges are looked for in a round.
_SWEEPS = 3


@dataclass
class _Surface:
    """points (n, 3), triangles (m, 3); planes (n, 4, 4) of each point; kept: edges (k, 2) that must
    stay."""

    points: Floats
    triangles: Ints
    planes: Floats
    kept: Indices


def simplified(points: Floats, triangles: Ints, most: int) -> tuple[Floats, Ints]:
    """A closed surface of at most so many triangles, as far as it can be without tearing."""
    areas = area_vectors(points, triangles)
    normals = unit(areas)
    level = -np.einsum("ij,ij->i", normals, points[triangles[:, 0]])
    plane = np.column_stack([normals, level])
    weights = np.linalg.norm(areas, axis=1)
    planes = np.zeros((len(points), 4, 4))
    for i in range(4):
        for j in range(4):
            each = np.repeat(weights * plane[:, i] * plane[:, j], 3)
            planes[:, i, j] = np.bincount(triangles.ravel(), each, len(points))
    surface = _Surface(points.copy(), triangles, planes, np.zeros((0, 2), dtype=np.int64))
    for _ in range(_ROUNDS):
        checkpoint()
        if len(surface.triangles) <= most or not _round(surface, (len(surface.triangles) - most) // 2):
            break
    return surface.points, surface.triangles


def _round(surface: _Surface, most: int) -> bool:
    """Collapse up to so many edges that do not touch each other; whether anything was tried."""
    ends = half_edges(surface.triangles)
    ends = ends[ends[:, 0] < ends[:, 1]].astype(np.int64)
    pair = (len(surface.points), 1)
    free = ~np.isin(ends @ pair, surface.kept @ pair)
    places, cost = _best_places(surface, ends)
    cost[~free] = np.inf
    chosen = _apart(ends, cost, len(surface.points))
    chosen = chosen[cost[chosen] <= np.quantile(cost[free], _CHEAP)][:most] if free.any() else chosen[:0]
    if not len(chosen):
        return False
    places = _on_planes(surface, ends[chosen], places[chosen])
    sound = _holds_together(surface, ends[chosen]) & _stays_flat(surface, ends[chosen], places)
    start, end = ends[chosen[sound]].T
    surface.points[start] = places[sound]
    surface.planes[start] += surface.planes[end]
    left = np.ones(len(surface.points), dtype=bool)
    left[end] = False
    number = np.cumsum(left) - 1
    number[end] = number[start]
    kept = np.concatenate([surface.kept, ends[chosen[~sound]]])
    surface.kept = number[kept[left[kept].all(axis=1)]]
    surface.kept.sort(axis=1)
    triangles = number[surface.triangles]
    whole = (triangles != np.roll(triangles, 1, axis=1)).all(axis=1)
    surface.triangles = triangles[whole].astype(np.int32)
    surface.points, surface.planes = surface.points[left], surface.planes[left]
    return True


def _best_places(surface: _Surface, ends: Indices) -> tuple[Floats, Floats]:
    """Of each edge (k, 2) the best of its ends and its middle (k, 3), and what it costs to be there (k,)."""
    one, other = surface.points[ends[:, 0]], surface.points[ends[:, 1]]
    planes = surface.planes[ends[:, 0]] + surface.planes[ends[:, 1]]
    first, second = (np.column_stack([at, np.ones(len(at))]) for at in (one, other))
    pulled = np.einsum("kij,kj->ki", planes, first)
    at_one, between = np.einsum("ki,ki->k", pulled, first), np.einsum("ki,ki->k", pulled, second)
    at_other = np.einsum("ki,kij,kj->k", second, planes, second)
    cost = np.stack([0.25 * (at_one + at_other) + 0.5 * between, at_one, at_other])
    which = np.argmin(cost, axis=0)
    share = np.array([0.5, 0.0, 1.0])[which][:, None]
    best, least = one + share * (other - one), cost[which, np.arange(len(ends))]
    length = ((one - other) ** 2).sum(axis=1)
    areas = np.einsum("kii->k", planes[:, :3, :3])
    # scattered, since edges whose costs rise in a row become points one after the other
    scattered = 1.0 + _SCATTER * (_GOLDEN * np.arange(len(ends)) % 1.0)
    return best, (np.maximum(least, 0.0) + _EVEN * areas * length) * scattered


def _on_planes(surface: _Surface, ends: Indices, places: Floats) -> Floats:
    """Places (k, 3) for the points that edges become, moved nearer to the planes of both ends of each."""
    planes = surface.planes[ends].sum(axis=1)
    own = planes[:, :3, :3]
    held = _HELD * np.einsum("kii->k", own)[:, None, None] * np.eye(3)
    off = np.einsum("kij,kj->ki", own, places) + planes[:, :3, 3]
    move = np.linalg.solve(own + held, -off[:, :, None])[:, :, 0]
    far = np.linalg.norm(move, axis=1) / np.linalg.norm(np.diff(surface.points[ends], axis=1)[:, 0], axis=1)
    return np.asarray(places + np.where(far < 1.0, 1.0, 0.0)[:, None] * move)


def _apart(ends: Indices, cost: Floats, count: int) -> Indices:
    """Edges of which no two have an end, or neighbours of their ends, in common; the cheapest first.

    An edge is taken that costs less than all others at its ends and at the neighbours of these.
    """
    rank = np.empty(len(cost), dtype=np.int64)
    rank[np.argsort(cost, kind="stable")] = np.arange(len(cost))
    none = len(cost)
    rank[~np.isfinite(cost)] = none
    order = np.argsort(ends.ravel(), kind="stable")
    starts = np.searchsorted(ends.ravel()[order], np.arange(count))
    other = order ^ 1
    taken = [rank[:0]]
    for _ in range(_SWEEPS):
        least = np.minimum.reduceat(rank[order // 2], starts)
        around = np.minimum(least, np.minimum.reduceat(least[ends.ravel()[other]], starts))
        first = np.flatnonzero((rank[:, None] == around[ends]).all(axis=1) & (rank < none))
        taken.append(first)
        # what has an end at their ends, or beside them, is left for the next round
        busy = np.zeros(count, dtype=bool)
        busy[ends[first]] = True
        busy[ends[busy[ends].any(axis=1)]] = True
        rank[busy[ends].any(axis=1)] = none
    chosen = np.concatenate(taken)
    return chosen[np.argsort(cost[chosen], kind="stable")]


def _holds_together(surface: _Surface, ends: Indices) -> Bools:
    """Whether both ends of each edge (k, 2) have two neighbours in common, and no more."""
    try:
        from scipy.sparse import coo_matrix
    except ImportError as error:
        raise without_scipy("Reading a mesh needs scipy: install it with pip install scipy.") from error
    edges = half_edges(surface.triangles)
    count = len(surface.points)
    graph = coo_matrix((np.ones(len(edges), dtype=np.int32), edges.T), shape=(count, count)).tocsr()
    common = graph[ends[:, 0]].multiply(graph[ends[:, 1]]).sum(axis=1)
    return np.asarray(common).ravel() == 2


def _stays_flat(surface: _Surface, ends: Indices, places: Floats) -> Bools:
    """Whether no triangle turns over or gets thin when each edge (k, 2) becomes a point (k, 3), none beside
    another."""
    owner = np.full(len(surface.points), -1)
    owner[ends] = np.arange(len(ends))[:, None]
    moved = surface.points.copy()
    moved[ends] = places[:, None]
    corners = owner[surface.triangles]
    touched = (corners >= 0).sum(axis=1) == 1
    triangles = surface.triangles[touched]
    before, after = area_vectors(surface.points, triangles), area_vectors(moved, triangles)
    wrong = np.einsum("ij,ij->i", unit(before), unit(after)) < _TURN
    low = _heights(after, moved[triangles])
    wrong |= low < np.minimum(_LOW, _LOWER * _heights(before, surface.points[triangles]))
    sound = np.ones(len(ends), dtype=bool)
    sound[corners[touched].max(axis=1)[wrong]] = False
    return sound


def _heights(areas: Floats, corners: Floats) -> Floats:
    """Of triangles (m, 3, 3) of these area vectors (m, 3), in parts of their longest sides (m,)."""
    longest = ((corners - np.roll(corners, 1, axis=1)) ** 2).sum(axis=2).max(axis=1)
    return np.asarray(2.0 * np.linalg.norm(areas, axis=1) / np.maximum(longest, 1e-300))

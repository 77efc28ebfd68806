# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges at which more than two triangles meet: walls and sheets are left out, touching bodies are parted."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from BalloonWorkbench.core.checkpoint import checkpoint
from BalloonWorkbench.core.geometry.vectors import unit
from BalloonWorkbench.core.panels.surface import first_of_each
from BalloonWorkbench.core.targets.half_edges import Indices, ahead, area_vectors, connected_parts, half_edges
from BalloonWorkbench.core.types import Bools, Floats, Ints

#: What is left out is at most this part of the area of all.
_MOST = 0.5
_ROUNDS = 50


class Junctions(NamedTuple):
    """The edges of a mesh: number (3 m,) of that of each half-edge, and how many half-edges (k,) are one."""

    edge: Indices
    counts: Indices

    @property
    def crowded(self) -> Bools:
        """Half-edges (3 m,) at which more than two triangles meet."""
        return np.asarray(self.counts[self.edge] > 2)


def junctions(triangles: Ints) -> Junctions:
    """The edges of triangles (m, 3)."""
    edges = np.sort(half_edges(triangles), axis=1).astype(np.int64)
    names = edges @ (int(triangles.max()) + 1 if len(triangles) else 1, 1)
    _, edge, count = np.unique(names, return_inverse=True, return_counts=True)
    return Junctions(edge.ravel(), count)


def without_walls(points: Floats, triangles: Ints) -> Bools:
    """Which triangles (m,) are left without sheets that stand on the surface, and walls inside it.

    Of the parts that meet in an edge the one goes that ends in the open, or else the smallest: of all that
    span the same rim a wall is the smallest. What is more than half of the surface stays.
    """
    areas = np.linalg.norm(area_vectors(points, triangles), axis=1)
    kept = np.ones(len(triangles), dtype=bool)
    for _ in range(_ROUNDS):
        checkpoint()
        own = np.flatnonzero(kept)
        known = junctions(triangles[own])
        gone = _walls(known, areas[own], _MOST * areas.sum())
        if not gone.any():
            break
        kept[own[gone]] = False
    return kept


def _walls(known: Junctions, areas: Floats, most: float) -> Bools:
    """Triangles (m,) of the parts to leave out next."""
    order = np.argsort(known.edge, kind="stable")
    start = np.cumsum(known.counts) - known.counts
    pairs = start[known.counts == 2]
    parts = connected_parts(len(areas), order[pairs] // 3, order[pairs + 1] // 3)
    size = np.bincount(parts, areas)
    half = np.repeat(parts, 3)
    is_open = np.zeros(len(size), dtype=bool)
    is_open[half[known.counts[known.edge] == 1]] = True
    # edges at which an odd number meet cannot be those of closed bodies, nor those of parts that end
    wrong = known.crowded & ((known.counts % 2 == 1)[known.edge] | is_open[half])
    worth = np.where(is_open, 0.0, size.max()) + size
    worth[size > most] = np.inf
    rank = np.full(len(known.counts), np.inf)
    np.minimum.at(rank, known.edge[wrong], worth[half[wrong]])
    chosen = wrong & (worth[half] == rank[known.edge]) & np.isfinite(worth[half])
    gone = np.zeros(len(size), dtype=bool)
    if chosen.any():
        gone[half[chosen][np.argmin(worth[half[chosen]])]] = True
        # all that end in the open can go at once
        gone[half[chosen & is_open[half]]] = True
    return np.asarray(gone[parts])


def parted(points: Floats, triangles: Ints) -> Ints:
    """For each corner (3 m,) of the triangles the first one that is the same point, where bodies touch.

    Bodies that touch along an edge, or in a point, get points of their own: round an edge each triangle is
    joined to the one beside it that bounds the same body. Where they run round it anyhow it stays one.
    """
    known, edges = junctions(triangles), half_edges(triangles)
    order = np.argsort(known.edge, kind="stable")
    start = np.cumsum(known.counts) - known.counts
    pairs = [np.column_stack([order[start[known.counts == 2]], order[start[known.counts == 2] + 1]])]
    for edge in np.flatnonzero(known.counts > 2).tolist():
        around = order[start[edge] : start[edge] + known.counts[edge]]
        pairs.append(_of_one_body(points, triangles, edges, around))
    one, other = np.concatenate(pairs).T
    turned = (edges[one, 0] != edges[other, 0])[:, None]
    first, second = (np.column_stack([each, ahead(each)]) for each in (one, other))
    second = np.where(turned, second[:, ::-1], second)
    return first_of_each(triangles.size, np.column_stack([first.ravel(), second.ravel()]))


def _of_one_body(points: Floats, triangles: Ints, edges: Ints, around: Indices) -> Indices:
    """Pairs (k, 2) of the half-edges around an edge that bound the same body; where none do, all with one."""
    start, end = np.sort(edges[around[0]])
    axis = unit(points[end] - points[start])
    flat = triangles.ravel()
    apexes = points[flat[around - around % 3 + (around + 2) % 3]] - points[start]
    apexes -= np.outer(apexes @ axis, axis)
    first = apexes[0]
    side = np.cross(axis, first)
    turn = np.arctan2(apexes @ side, apexes @ first)
    order = around[np.argsort(turn, kind="stable")]
    forward = edges[order, 0] == start
    # the body is behind a triangle that runs forward
    if len(around) % 2 or (forward == np.roll(forward, 1)).any():
        return np.column_stack([np.repeat(around[:1], len(around) - 1), around[1:]])
    return np.column_stack([order, np.roll(order, 1)])[forward]

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles in space split where edges are too long, or along a line on the surface."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from BalloonWorkbench.core.checkpoint import checkpoint
from BalloonWorkbench.core.targets.half_edges import Indices, half_edges
from BalloonWorkbench.core.types import Bools, Floats, Ints

#: A vertex so near to a line, as a part of the edges there, lies on it.
_ON = 0.03


class Split(NamedTuple):
    """Triangles after some edges got a point; what else the points carry is linear between them.

    points     (n + k, d), the new ones behind the old ones
    triangles  (m', 3)
    origin     (m',) number of the triangle that each is a part of
    """

    points: Floats
    triangles: Ints
    origin: Ints


def split_edges(points: Floats, triangles: Ints, marked: Bools, places: Floats) -> Split:
    """Split triangles at points of their edges.

    marked  (3 m,) half-edges that get a point; both of an edge, or none
    places  (3 m, d) the point of each, the same for both half-edges of an edge
    """
    edges = np.sort(half_edges(triangles), axis=1).astype(np.int64) @ (len(points), 1)
    _, first, number = np.unique(edges[marked], return_index=True, return_inverse=True)
    middle = np.full(len(edges), -1, dtype=np.int64)
    middle[marked] = len(points) + number
    middle = middle.reshape(-1, 3)
    kind = (middle >= 0) @ (1, 2, 4)
    parts, origins = [triangles[kind == 0]], [np.flatnonzero(kind == 0)]
    for case in range(1, 8):
        own = np.flatnonzero(kind == case)
        if len(own):
            pieces = _pieces(triangles[own], middle[own], case)
            parts += pieces
            origins += [own] * len(pieces)
    together = np.concatenate([points, places[marked][first]])
    origin = np.concatenate(origins)
    order = np.argsort(origin, kind="stable")
    return Split(together, np.concatenate(parts)[order].astype(np.int32), origin[order].astype(np.int32))


def _pieces(triangles: Ints, middle: Indices, case: int) -> list[Ints]:
    """The pieces of triangles of which the same edges are split; case: bit k stands for edge k."""
    if case == 7:
        (a, b, c), (p, q, r) = triangles.T, middle.T
        return [np.column_stack(each) for each in ((a, p, r), (b, q, p), (c, r, q), (p, q, r))]
    # turned so that edge 0 is split and edge 2 is not
    turn = next(k for k in range(3) if case >> k & 1 and not case >> (k + 2) % 3 & 1)
    a, b, c = np.roll(triangles, -turn, axis=1).T
    p, q, _ = np.roll(middle, -turn, axis=1).T
    if case in (1, 2, 4):
        return [np.column_stack(each) for each in ((a, p, c), (p, b, c))]
    return [np.column_stack(each) for each in ((p, b, q), (a, p, q), (a, q, c))]


def refined(points: Floats, triangles: Ints, size: float) -> Split:
    """Triangles without edges longer than size [m]; the surface stays what it is."""
    origin = np.arange(len(triangles), dtype=np.int32)
    while True:
        checkpoint()
        ends = points[half_edges(triangles)]
        marked = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1) > size
        if not marked.any():
            return Split(points, triangles, origin)
        points, triangles, parents = split_edges(points, triangles, marked, ends.mean(axis=1))
        origin = origin[parents]


def cut_where_zero(
    points: Floats,
    triangles: Ints,
    values: Floats,
    own: Bools | None = None,
    turn: float = np.inf,
    most: float = np.inf,
) -> Split:
    """Split triangles where values (n,) at their points (n, d), linear between, change sign.

    A point lies on the line where its value is less than a small part of the change along its edges,
    and no more than most.

    own   (m,) the triangles that are cut, with those beside their edges; None: all
    turn  values come round again after so much, so that along no edge they change by half of it
    """
    edges = half_edges(triangles)
    ends = values[edges]
    steps = np.abs(ends[:, 1] - ends[:, 0])
    inside = steps < 0.5 * turn
    if own is not None:
        inside &= np.repeat(own, 3)
    # only at edges that cross the line a point can be on it, and change anything
    near = np.zeros(len(points), dtype=bool)
    near[edges[inside & (ends[:, 0] * ends[:, 1] < 0.0)]] = True
    some = inside & near[edges].any(axis=1)
    change = np.zeros(len(points))
    np.maximum.at(change, edges[some].ravel(), np.repeat(steps[some], 2))
    on = np.abs(values) <= np.minimum(_ON * change, most)
    ends = np.where(on, 0.0, values)[edges]
    marked = inside & (ends[:, 0] * ends[:, 1] < 0.0)
    if own is not None:
        names = np.sort(edges, axis=1).astype(np.int64) @ (len(points), 1)
        marked = np.isin(names, names[marked])
    # from the lower vertex of an edge, so that both of its half-edges give the same point to the last bit
    low, high = np.sort(edges[marked], axis=1).T
    share = (values[low] / (values[low] - values[high]))[:, None]
    places = np.zeros((len(edges), points.shape[1]))
    places[marked] = points[low] + share * (points[high] - points[low])
    return split_edges(points, triangles, marked, places)

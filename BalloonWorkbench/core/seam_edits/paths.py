# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shortest paths between vertices of a surface of triangles, along its edges first and then through them.

The path along edges (Dijkstra 1959) is pulled straight: the triangles that it passes are laid flat, it
becomes the shortest one through them, and where it bends round a vertex it tries the other side of that,
until it is straight there from both sides.
"""

from __future__ import annotations

import itertools
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from BalloonWorkbench.core.geometry.vectors import unit
from BalloonWorkbench.core.packages import without_scipy
from BalloonWorkbench.core.seam_edits.sleeve import Corner, Laid, Sleeve, pulled
from BalloonWorkbench.core.targets.half_edges import Indices, ahead, half_edges, twins
from BalloonWorkbench.core.types import Floats, Ints

#: An angle that is less than half a turn by more than this can be made straight [rad].
_BENT = 1e-6
_MOST = 400  # times that a path tries other sides


class SurfacePath(NamedTuple):
    """Points of a line over a surface, each on an edge between two vertices, or in one vertex, given twice.

    ends    (k, 2) vertices
    shares  (k,) how far each point is from the first to the second
    """

    ends: Ints
    shares: Floats

    def places(self, points: Floats) -> Floats:
        """Its points (k, 3) m; points (n, 3) of the surface."""
        first, last = points[self.ends[:, 0]], points[self.ends[:, 1]]
        return np.asarray(first + self.shares[:, None] * (last - first))


class PathSurface:
    """A surface of points (n, 3) and triangles (m, 3) that paths run over; it may have a border."""

    def __init__(self, points: Floats, triangles: Ints) -> None:
        self.points, self.triangles = points, triangles
        self.edges = half_edges(triangles)
        self.twin = twins(triangles)

    @cached_property
    def _graph(self) -> Any:
        """Lengths of the edges, as a sparse matrix of scipy."""
        try:
            from scipy.sparse import coo_matrix
        except ImportError as error:
            raise without_scipy("Drawing seams needs scipy: install it with pip install scipy.") from error
        count = len(self.points)
        keys = np.unique(np.sort(self.edges, axis=1).astype(np.int64) @ (count, 1))
        one, other = keys // count, keys % count
        lengths = np.linalg.norm(self.points[one] - self.points[other], axis=1)
        # shorter ways between the same vertices come first, and are kept
        across, ends = self._across
        lengths = np.maximum(np.concatenate([lengths, across]), 1e-300)
        keys = np.concatenate([keys, np.sort(ends, axis=1).astype(np.int64) @ (count, 1)])
        order = np.lexsort([lengths, keys])
        kept = order[np.diff(keys[order], prepend=-1) != 0]
        one, other = keys[kept] // count, keys[kept] % count
        return coo_matrix((lengths[kept], (one, other)), shape=(count, count)).tocsr()

    @cached_property
    def _across(self) -> tuple[Floats, Ints]:
        """Lengths (k,) of straight ways over an edge from triangle to triangle, and their ends (k, 2)."""
        inner = np.flatnonzero(self.twin > np.arange(len(self.twin)))
        tops, twin = np.array(self.laid.tops), self.twin[inner]
        one, other = tops[inner], 1.0 - tops[twin]
        share = one.imag / np.maximum(one.imag - other.imag, 1e-300)
        crossing = one.real + share * (other.real - one.real)
        straight = (crossing > 0.0) & (crossing < 1.0)
        inner, twin = inner[straight], twin[straight]
        lengths = np.abs(one - other)[straight] * np.array(self.laid.lengths)[inner]
        ends = np.stack([self.edges[ahead(inner), 1], self.edges[ahead(twin), 1]], axis=1)
        return lengths, ends

    @cached_property
    def angles(self) -> list[float]:
        """Of each corner (3 m,) of the triangles [rad]."""
        corners = self.points[self.triangles]
        one = unit((np.roll(corners, -1, axis=1) - corners).reshape(-1, 3))
        other = unit((np.roll(corners, 1, axis=1) - corners).reshape(-1, 3))
        angles: list[float] = np.arccos(np.clip(np.einsum("ij,ij->i", one, other), -1.0, 1.0)).tolist()
        return angles

    @cached_property
    def _around(self) -> Floats:
        """Sum of the angles round each vertex (n,); not finite at the border."""
        total = np.bincount(self.triangles.ravel(), self.angles, len(self.points))
        total[self.edges[self.twin < 0]] = np.inf
        return np.asarray(total, dtype=np.float64)

    @cached_property
    def _between(self) -> dict[tuple[int, int], int]:
        """The half-edge from one vertex to another."""
        return {(one, other): k for k, (one, other) in enumerate(self.edges.tolist())}

    @cached_property
    def laid(self) -> Laid:
        """Its half-edges as they are laid flat."""
        starts, ends = self.points[self.edges[:, 0]], self.points[self.edges[:, 1]]
        tops = self.points[self.edges[ahead(np.arange(len(self.edges))), 1]]
        along, up = ends - starts, tops - starts
        square = np.maximum((along**2).sum(axis=1), 1e-300)
        share = np.einsum("ij,ij->i", along, up) / square
        height = np.linalg.norm(up - share[:, None] * along, axis=1) / np.sqrt(square)
        turns = (share + 1j * height).tolist()
        return Laid(self.edges.tolist(), self.twin.tolist(), turns, np.sqrt(square).tolist())

    def path(self, start: int, goal: int) -> SurfacePath | None:
        """A path from vertex to vertex that is nowhere longer than it need be; None where there is none."""
        along = self._along_edges(start, goal)
        if along is None:
            return None
        if len(along) < 3:
            ends = np.repeat(np.array(along, dtype=np.int32)[:, None], 2, axis=1)
            return SurfacePath(ends, np.zeros(len(along)))
        beside = self._beside(along)
        return None if beside is None else self._straight(Sleeve(beside), start, goal)

    def nearest_pair(self, ones: Indices, others: Indices) -> tuple[int, int]:
        """One of some vertices and one of others between which the path along edges is shortest."""
        from scipy.sparse.csgraph import dijkstra

        away, _, start = dijkstra(
            self._graph, directed=False, indices=ones, return_predecessors=True, min_only=True
        )
        goal = int(others[np.argmin(away[others])])
        return int(start[goal]), goal

    def _along_edges(self, start: int, goal: int) -> list[int] | None:
        """Vertices of about the shortest path, each on an edge with the next."""
        from scipy.sparse.csgraph import dijkstra

        away, before = dijkstra(self._graph, directed=False, indices=start, return_predecessors=True)
        if not np.isfinite(away[goal]):
            return None
        line = [goal]
        while line[-1] != start:
            line.append(int(before[line[-1]]))
        whole = [start]
        for one, other in itertools.pairwise(line[::-1]):
            if (one, other) not in self._between and (other, one) not in self._between:
                whole.append(self._beside_way(one, other))
            whole.append(other)
        return whole

    def _beside_way(self, one: int, other: int) -> int:
        """The vertex by which the way over an edge from vertex to vertex is least longer along edges."""
        triangles = [self.triangles[(self.triangles == end).any(axis=1)] for end in (one, other)]
        both = np.intersect1d(*triangles)
        detour = np.linalg.norm(self.points[both, None] - self.points[[one, other]], axis=2).sum(axis=1)
        return int(both[np.argmin(detour)])

    def _straight(self, sleeve: Sleeve, start: int, goal: int) -> SurfacePath:
        """The path through a sleeve pulled straight."""
        best = pulled(sleeve.without(start, goal, self.laid), start, goal, self.laid)
        for _ in range(_MOST):
            other = self._otherwise(best.sleeve, best.corners)
            if other is None:
                break
            made = pulled(other.without(start, goal, self.laid), start, goal, self.laid)
            if made.length >= best.length * (1.0 - 1e-12):
                break
            best = made
        ends = [(start, start), *best.crossed, (goal, goal)]
        return SurfacePath(np.array(ends, dtype=np.int32), np.array([0.0, *best.shares, 0.0]))

    def _beside(self, along: list[int]) -> list[int] | None:
        """Half-edges that are crossed by a path which leaves out the vertices of another: each on the side
        where the angle is less. None where the surface hangs together in one of them only."""
        steps = list(itertools.pairwise(along))
        crossed: list[int] = []
        before = None
        for (one, middle), (_, last) in itertools.pairwise(steps):
            fans = [fan for fan in (self._fan(one, middle, last, left) for left in (True, False)) if fan]
            if not fans:
                return None
            _, left, passed = min(fans)
            if before is not None and before != left:
                crossed.append(self._between[(one, middle) if before else (middle, one)])
            crossed += passed
            before = left
        return crossed

    def _fan(self, one: int, middle: int, last: int, left: bool) -> tuple[float, bool, list[int]] | None:
        """The angle at a vertex from the one before to the one after it, and the half-edges between them.

        None where the surface ends on that side.
        """
        twin, angles = self.laid.twin, self.angles
        edge = self._between.get((one, middle) if left else (middle, one), -1)
        goal = self._between.get((middle, last) if left else (last, middle), -1)
        total = 0.0
        passed: list[int] = []
        while edge >= 0:
            corner = _next(edge) if left else edge
            total += angles[corner]
            edge = corner if left else _previous(edge)
            if edge == goal:
                return total, left, passed
            passed.append(edge)
            edge = twin[edge]
        return None

    def _otherwise(self, sleeve: Sleeve, corners: list[Corner]) -> Sleeve | None:
        """The sleeve on the other side of the vertices where that is shorter; None where it nowhere is."""
        crossed, changed, free = list(sleeve.crossed), False, len(sleeve.crossed)
        for corner in reversed(corners):
            if corner.last >= free:
                continue
            inner = sum(self.angles[_corner(edge, corner.left)] for edge in self._inside(sleeve, corner))
            outer = self._around[corner.vertex] - inner - corner.beside
            if not outer < np.pi - _BENT:
                continue
            turned = self._other_way(crossed[corner.first], crossed[corner.last], corner.left)
            if turned is None:
                continue
            crossed[corner.first : corner.last + 1] = turned
            free, changed = corner.first, True
        return Sleeve(crossed) if changed else None

    def _inside(self, sleeve: Sleeve, corner: Corner) -> list[int]:
        """The half-edges over which the triangles between the first and the last one crossed are entered."""
        return [self.laid.twin[edge] for edge in sleeve.crossed[corner.first : corner.last]]

    def _other_way(self, first: int, last: int, left: bool) -> list[int] | None:
        """Half-edges crossed on the other side of a vertex; None where the surface ends there."""
        stop, edge, passed = self.laid.twin[last] // 3, first, []
        while edge // 3 != stop:
            edge = _next(edge) if left else _previous(edge)
            passed.append(edge)
            edge = self.laid.twin[edge]
            if edge < 0:
                return None
        return passed


def _next(edge: int) -> int:
    return edge - edge % 3 + (edge + 1) % 3


def _previous(edge: int) -> int:
    return edge - edge % 3 + (edge + 2) % 3


def _corner(entered: int, left: bool) -> int:
    """The corner of a triangle at the vertex that is passed: it is entered over a half-edge that starts there
    where the vertex is to the left."""
    return entered if left else _next(entered)

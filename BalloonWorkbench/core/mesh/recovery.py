# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges that a plain Delaunay triangulation lacks.

They are recovered by swapping the diagonals they cross (Sloan, Computers & Structures 47 (1993) 441-450),
then the swapped region is made Delaunay again.
"""

from __future__ import annotations

from collections import deque

import numpy as np

from BalloonWorkbench.core.errors import MeshError
from BalloonWorkbench.core.types import Bools, Floats, Ints

CROSSING = "The outline crosses or touches itself and cannot be meshed: separate the parts that meet."


def recovered(
    points: Floats, triangles: Ints, neighbours: Ints, segments: Ints, missing: Bools
) -> tuple[Ints, Ints]:
    """Triangles and neighbours (m, 3) in which the missing ones of the segments (k, 2) are edges too."""
    mesh = _Swapper(points, triangles, neighbours)
    ends = np.sort(segments, axis=1)
    fixed = set(map(tuple, ends.tolist()))
    for a, b in sorted(map(tuple, ends[missing].tolist())):
        mesh.recover(a, b, fixed)
    return np.asarray(mesh.triangles), np.asarray(mesh.neighbours)


class _Swapper:
    """Triangles with neighbours in plain lists: few edges are swapped, one at a time."""

    def __init__(self, points: Floats, triangles: Ints, neighbours: Ints) -> None:
        self.points: list[list[float]] = points.tolist()
        self.triangles: list[list[int]] = triangles.tolist()
        self.neighbours: list[list[int]] = neighbours.tolist()
        self.triangle_at = [0] * len(points)
        for index, triangle in enumerate(self.triangles):
            for vertex in triangle:
                self.triangle_at[vertex] = index

    def recover(self, a: int, b: int, fixed: set[tuple[int, int]]) -> None:
        """Make a-b an edge, unless an earlier swap did."""
        if self._pair(a, b) is not None:
            return
        crossing = deque(self._crossed(a, b))
        created: list[tuple[int, int]] = []
        patience = 50 * (len(crossing) + 2) ** 2
        while crossing:
            patience -= 1
            p, q = crossing.popleft()
            if patience < 0 or (min(p, q), max(p, q)) in fixed:
                raise MeshError(CROSSING)
            swapped = self._swap(p, q)
            if swapped is None:
                crossing.append((p, q))
                continue
            r, s = swapped
            if {r, s}.isdisjoint((a, b)) and self._side(a, b, r) * self._side(a, b, s) < 0.0:
                crossing.append((r, s))
            else:
                created.append((r, s))
        self._restore(created, fixed | {(min(a, b), max(a, b))})

    def _restore(self, edges: list[tuple[int, int]], fixed: set[tuple[int, int]]) -> None:
        """Swap back to Delaunay where the constraints allow it."""
        queue = deque(edges)
        patience = 200 * (len(edges) + 1)
        while queue and patience:
            patience -= 1
            p, q = queue.popleft()
            if (min(p, q), max(p, q)) in fixed:
                continue
            pair = self._pair(p, q)
            if pair is None or pair[1] < 0:
                continue
            r, s = self._opposite(pair[0], p, q), self._opposite(pair[1], p, q)
            if self._angle(r, p, q) + self._angle(s, p, q) > np.pi + 1e-9 and self._swap(p, q):
                queue.extend([(p, r), (r, q), (q, s), (s, p)])

    def _crossed(self, a: int, b: int) -> list[tuple[int, int]]:
        """Edges that the segment a-b runs through, in order."""
        for index in self._fan(a):
            triangle = self.triangles[index]
            k = triangle.index(a)
            p, q = triangle[k - 2], triangle[k - 1]  # counter-clockwise: a, p, q
            if self._side(a, b, p) < 0.0 < self._side(a, b, q):
                break
        else:
            raise MeshError(CROSSING)
        edges = [(p, q)]
        while True:
            index = self.neighbours[index][self.triangles[index].index(self._opposite(index, p, q))]
            if index < 0:
                raise MeshError(CROSSING)
            apex = self._opposite(index, p, q)
            if apex == b:
                return edges
            side = self._side(a, b, apex)
            if side == 0.0:
                raise MeshError(CROSSING)
            p, q = (apex, q) if side < 0.0 else (p, apex)
            edges.append((p, q))

    def _swap(self, p: int, q: int) -> tuple[int, int] | None:
        """Replace edge p-q by the other diagonal; None where the two triangles are not convex."""
        pair = self._pair(p, q)
        if pair is None or pair[1] < 0:
            return None
        first, second = pair
        triangle = self.triangles[first]
        k = next(k for k in range(3) if {triangle[k - 2], triangle[k - 1]} == {p, q})
        r, p, q = triangle[k], triangle[k - 2], triangle[k - 1]
        s = self._opposite(second, p, q)
        if self._side(r, s, p) >= 0.0 or self._side(r, s, q) <= 0.0:
            return None
        side = {
            frozenset((q, r)): first,
            frozenset((r, p)): first,
            frozenset((p, s)): second,
            frozenset((s, q)): second,
        }
        outer = {}
        for edge, index in side.items():
            row = self.triangles[index]
            outer[edge] = self.neighbours[index][next(k for k in range(3) if row[k] not in edge)]
        self.triangles[first], self.triangles[second] = [r, p, s], [s, q, r]
        self.neighbours[first] = [outer[frozenset((p, s))], second, outer[frozenset((r, p))]]
        self.neighbours[second] = [outer[frozenset((q, r))], first, outer[frozenset((s, q))]]
        for edge, index in ((frozenset((p, s)), first), (frozenset((q, r)), second)):
            if (other := outer[edge]) >= 0:
                row = self.triangles[other]
                self.neighbours[other][next(k for k in range(3) if row[k] not in edge)] = index
        for index in (first, second):
            for vertex in self.triangles[index]:
                self.triangle_at[vertex] = index
        return r, s

    def _pair(self, p: int, q: int) -> tuple[int, int] | None:
        """The two triangles at edge p-q, at least one end of which is not on the hull."""
        for start, end in ((p, q), (q, p)):
            for index in self._fan(start):
                triangle = self.triangles[index]
                if end in triangle:
                    return index, self.neighbours[index][triangle.index(self._opposite(index, p, q))]
        return None

    def _fan(self, vertex: int) -> list[int]:
        """Triangles around a vertex that is not on the hull."""
        fan = [self.triangle_at[vertex]]
        while True:
            k = self.triangles[fan[-1]].index(vertex)
            following = self.neighbours[fan[-1]][k - 2]
            if following < 0 or following == fan[0]:
                return fan
            fan.append(following)

    def _opposite(self, index: int, p: int, q: int) -> int:
        return next(vertex for vertex in self.triangles[index] if vertex not in (p, q))

    def _side(self, a: int, b: int, c: int) -> float:
        """Twice the signed area of a, b, c: positive when c lies to the left of a-b."""
        (ax, ay), (bx, by), (cx, cy) = self.points[a], self.points[b], self.points[c]
        return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)

    def _angle(self, apex: int, p: int, q: int) -> float:
        (x, y), (px, py), (qx, qy) = self.points[apex], self.points[p], self.points[q]
        ux, uy, vx, vy = px - x, py - y, qx - x, qy - y
        return float(np.arctan2(abs(ux * vy - uy * vx), ux * vx + uy * vy))

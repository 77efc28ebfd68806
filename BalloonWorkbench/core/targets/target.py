# SPDX-License-Identifier: LGPL-2.1-or-later
"""The target: one closed body of triangles, and its division into panels with the seams between them."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from BalloonWorkbench.core.targets.half_edges import (
    Indices,
    ahead,
    area_vectors,
    enclosed_volume,
    first_corners,
    half_edges,
    twins,
)
from BalloonWorkbench.core.types import Bools, Floats, Ints

#: Digits of metres to which points and flat places are kept.
_POINT_DIGITS, _DIGITS = 9, 12


@dataclass(frozen=True)
class Target:
    """A closed body that a balloon is to fill.

    points     (n, 3) m
    triangles  (m, 3) counter-clockwise seen from outside; each edge is one of exactly two of them
    source     name of the file or object that it comes from
    notes      one sentence each, for the user
    """

    points: Floats
    triangles: Ints
    source: str = ""
    notes: tuple[str, ...] = ()

    @cached_property
    def twins(self) -> Indices:
        """For each half-edge (3 m,) the one of the triangle beside it."""
        return twins(self.triangles)

    @cached_property
    def area_vectors(self) -> Floats:
        """Outward normals (m, 3) of the triangles, as long as their areas [m2]."""
        return area_vectors(self.points, self.triangles)

    @cached_property
    def areas(self) -> Floats:
        """Areas (m,) of the triangles [m2]."""
        return np.linalg.norm(self.area_vectors, axis=1)

    @property
    def volume(self) -> float:
        """What it encloses [m3]."""
        return enclosed_volume(self.points, self.triangles)

    @property
    def diagonal(self) -> float:
        """Of the box around it, along the axes [m]."""
        return float(np.linalg.norm(np.ptp(self.points, axis=0)))


@dataclass(frozen=True)
class SeamLine:
    """A line between two panels, or two edges of one panel, from node to node.

    vertices  (k,) numbers of the target's points along it, k >= 2
    panels    the panel to the left of it, seen from outside, and the one to its right
    sides     (k,) numbers of the same points on both panels as they are cut open: the first side runs along
              the boundary of its panel, counter-clockwise, the second one against that of its own
    """

    vertices: Ints
    panels: tuple[int, int]
    sides: tuple[Ints, Ints]


@dataclass(frozen=True)
class OpenedPanels:
    """The triangles of a division, cut open along all seams: no two panels share a vertex.

    vertices   (k,) the target's point of each vertex, panel by panel
    panels     (k,) the panel of each vertex
    triangles  (m, 3) the target's triangles in these vertices
    """

    vertices: Ints
    panels: Ints
    triangles: Ints


@dataclass(frozen=True)
class FaceFlats:
    """The faces of a solid that unroll, laid flat, each in its own plane.

    corners  (m, 3, 2) m where the corners of each triangle lie; NaN where its face does not unroll
    bent     (h,) half-edges that stand for a piece of a curve of the boundary of such a face
    between  (h, 3, 2) m where that curve lies at a quarter, a half and three quarters of its parameter
    """

    corners: Floats
    bent: Indices
    between: Floats

    def scaled(self, scale: float) -> FaceFlats:
        """The same of a body so many times as large."""
        return FaceFlats(self.corners * scale, self.bent, self.between * scale)

    def rounded(self) -> FaceFlats:
        """The same to the picometre, so that the same is read from a document as was written."""
        return FaceFlats(
            np.round(self.corners, _DIGITS) + 0.0, self.bent, np.round(self.between, _DIGITS) + 0.0
        )


@dataclass(frozen=True)
class Division:
    """Which panel each triangle of a target belongs to.

    panels  (m,) number of the panel of each triangle, 0 to p - 1
    names   of the p panels
    cuts    (k, 2) vertices of edges inside a panel that are seams too: they open it, so that it can be
            laid flat
    flats   where the target's triangles lie on the flat film, as far as that is known exactly
    """

    target: Target
    panels: Ints
    names: tuple[str, ...]
    cuts: Ints
    flats: FaceFlats | None = None

    def scaled(self, scale: float) -> Division:
        """The same of a body so many times as large."""
        target = replace(self.target, points=self.target.points * scale)
        return replace(self, target=target, flats=self.flats and self.flats.scaled(scale))

    def rounded(self) -> Division:
        """The same on the grid to which a document keeps it."""
        target = replace(self.target, points=np.round(self.target.points, _POINT_DIGITS) + 0.0)
        return replace(self, target=target, flats=self.flats and self.flats.rounded())

    @cached_property
    def seam_edges(self) -> Bools:
        """Whether each half-edge (3 m,) lies on a seam."""
        target = self.target
        apart = np.repeat(self.panels, 3) != self.panels[target.twins // 3]
        if len(self.cuts):
            count = len(target.points)
            edges = np.sort(half_edges(target.triangles), axis=1).astype(np.int64) @ (count, 1)
            apart |= np.isin(edges, np.sort(self.cuts, axis=1).astype(np.int64) @ (count, 1))
        return apart

    @cached_property
    def opened(self) -> OpenedPanels:
        """The panels' triangles, cut open."""
        triangles = self.target.triangles
        corners = first_corners(self.target.twins, ~self.seam_edges)
        order = np.lexsort([corners, triangles.ravel()[corners], np.repeat(self.panels, 3)[corners]])
        firsts = corners[order][np.diff(corners[order], prepend=-1) != 0]
        number = np.empty(triangles.size, dtype=np.int32)
        number[firsts] = np.arange(len(firsts), dtype=np.int32)
        return OpenedPanels(
            triangles.ravel()[firsts], self.panels[firsts // 3], number[corners].reshape(-1, 3)
        )

    @cached_property
    def nodes(self) -> Ints:
        """The target's points in which seams end, or three or more meet: (k,)."""
        starts = half_edges(self.target.triangles)[self.seam_edges, 0]
        vertices, counts = np.unique(starts, return_counts=True)
        return vertices[counts != 2]

    @cached_property
    def seams(self) -> tuple[SeamLine, ...]:
        """All seams, each from node to node; one that closes to a ring is broken into two.

        A ring without nodes starts at its first point.
        """
        lines = _lines(half_edges(self.target.triangles), self.seam_edges, self.target.twins, self.nodes)
        parts = [part for line in lines for part in self._parted(line)]
        return tuple(self._seam(part) for part in parts)

    def _parted(self, line: Indices) -> tuple[Indices, ...]:
        """The half-edges of a line; of a ring those of its two halves."""
        edges = half_edges(self.target.triangles)[line]
        if edges[0, 0] != edges[-1, 1]:
            return (line,)
        steps = np.linalg.norm(np.diff(self.target.points[edges], axis=1)[:, 0], axis=1)
        along = np.cumsum(steps)
        half = 1 + int(np.argmin(np.abs(along[:-1] - 0.5 * along[-1])))
        return line[:half], line[half:]

    def _seam(self, line: Indices) -> SeamLine:
        """The seam along half-edges (k - 1,), each of which goes on where the one before ends."""
        target = self.target
        twin = target.twins[line]
        vertices, opened = target.triangles.ravel(), self.opened.triangles.ravel()
        along = np.append(vertices[line], vertices[ahead(line[-1:])])
        left = np.append(opened[line], opened[ahead(line[-1:])])
        right = np.append(opened[ahead(twin)], opened[twin[-1:]])
        panels = int(self.panels[line[0] // 3]), int(self.panels[twin[0] // 3])
        return SeamLine(along.astype(np.int32), panels, (left, right))


def _lines(edges: Ints, on_seam: Bools, twin: Indices, nodes: Ints) -> list[Indices]:
    """Half-edges along seams in their order, from node to node or once round; each seam in one direction.

    edges  (3 m, 2) vertices of all half-edges
    """
    starting: dict[int, list[int]] = {}
    for edge in np.flatnonzero(on_seam).tolist():
        starting.setdefault(int(edges[edge, 0]), []).append(edge)
    ends = set(nodes.tolist())
    done = np.zeros(len(edges), dtype=bool)
    lines = []
    first = [edge for node in sorted(ends) for edge in starting[node]]
    rest = [edge for vertex in sorted(starting) for edge in starting[vertex]]
    for edge in first + rest:
        if done[edge]:
            continue
        line = [edge]
        while True:
            done[line[-1]] = done[twin[line[-1]]] = True
            end = int(edges[line[-1], 1])
            if end in ends or end == edges[edge, 0]:
                break
            line += [each for each in starting[end] if each != twin[line[-1]]]
        lines.append(np.array(line, dtype=np.intp))
    return lines

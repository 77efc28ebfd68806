# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sections: straight lines across an outline, and its middle line between them.

The edges of a triangulation that has its vertices on the rim alone run across the shape; those that meet
the rim squarely at both ends are sections (chordal axis: Prasad, Interval Methods, 1997).
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from BalloonWorkbench.core.geometry.normals import left_normals
from BalloonWorkbench.core.geometry.sampling import evenly
from BalloonWorkbench.core.geometry.vectors import unit
from BalloonWorkbench.core.mesh.delaunay import triangulate_points
from BalloonWorkbench.core.mesh.quality import interior_edges
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.types import Bools, Floats

_SQUARE = 0.75  # cosine between a section and the normal of the rim, at least


@dataclass(frozen=True)
class Sections:
    """Lines from `starts` (k, 2) to `ends` (k, 2) on the facing rim [m]."""

    starts: Floats
    ends: Floats

    @property
    def widths(self) -> Floats:
        """Lengths (k,) m."""
        return np.asarray(np.linalg.norm(self.ends - self.starts, axis=1))

    @property
    def middles(self) -> Floats:
        """Points (k, 2) m."""
        return 0.5 * (self.starts + self.ends)

    def of(self, some: Bools) -> Sections:
        """Those chosen (k,)."""
        return Sections(self.starts[some], self.ends[some])


def sections(outline: Outline, spacing: float) -> Sections:
    """The sections of an outline from points on its rim at most `spacing` [m] apart."""
    loops = [evenly(loop, spacing) for loop in outline.loops]
    points = np.concatenate(loops)
    starts = np.cumsum([0, *(len(loop) for loop in loops)])
    numbers = tuple(np.arange(first, last, dtype=np.int32) for first, last in pairwise(starts))
    edges, _ = interior_edges(triangulate_points(points, numbers))
    inward = np.concatenate([left_normals(loop) for loop in loops])
    across = unit(points[edges[:, 1]] - points[edges[:, 0]])
    square = (np.einsum("ij,ij->i", across, inward[edges[:, 0]]) > _SQUARE) & (
        np.einsum("ij,ij->i", across, inward[edges[:, 1]]) < -_SQUARE
    )
    return Sections(points[edges[square, 0]], points[edges[square, 1]])


def chained(points: Floats, start: int) -> Floats:
    """Points (k, 2) of a line in their order along it, from one of its ends."""
    left = np.ones(len(points), dtype=bool)
    order = [start]
    left[start] = False
    while left.any():
        away = np.where(left, np.linalg.norm(points - points[order[-1]], axis=1), np.inf)
        order.append(int(np.argmin(away)))
        left[order[-1]] = False
    return np.asarray(points[order])

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the surface of a body crosses itself: triangles that an edge of another one goes through."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from BalloonWorkbench.core.checkpoint import checkpoint
from BalloonWorkbench.core.geometry.nearest import kd_tree
from BalloonWorkbench.core.targets.half_edges import Indices
from BalloonWorkbench.core.types import Bools, Floats, Ints

#: Pairs of triangles looked at together, and all in all: slivers lie near to everything.
_CHUNK, _MOST = 200_000, 40_000_000
_PLACES = 4_000  # triangles whose neighbours are looked for together
#: An edge that goes through a triangle by less than this part of its size only touches it.
_TOUCHES = 1e-7


def crossing_triangles(points: Floats, triangles: Ints) -> Indices:
    """Numbers (k,) of the triangles (m, 3) that cross another one.

    Triangles that only touch, or that lie in one plane, do not count; those with a common edge neither.
    """
    crossed = np.zeros(len(triangles), dtype=bool)
    seen = 0
    for pairs in _close_pairs(points, triangles):
        checkpoint()
        seen += len(pairs[0])
        if seen > _MOST:
            break
        low, high = (points[triangles[each]] for each in pairs)
        apart = (low.min(axis=1) > high.max(axis=1)) | (high.min(axis=1) > low.max(axis=1))
        one, other = (each[~apart.any(axis=1)] for each in pairs)
        through = _goes_through(points, triangles[one], triangles[other])
        through |= _goes_through(points, triangles[other], triangles[one])
        crossed[one[through]] = crossed[other[through]] = True
    return np.flatnonzero(crossed)


def _close_pairs(points: Floats, triangles: Ints) -> Iterator[tuple[Indices, Indices]]:
    """Pairs of triangles whose circles round their middles meet, each pair once."""
    corners = points[triangles]
    centres = 0.5 * (corners.min(axis=1) + corners.max(axis=1))
    radii = np.linalg.norm(corners - centres[:, None], axis=2).max(axis=1)
    # in classes of about equal size, so that a large triangle does not make all seem near
    classes = np.floor(np.log2(np.maximum(radii, 1e-300))).astype(np.int64)
    groups = [np.flatnonzero(classes == each) for each in np.unique(classes)]
    for index, large in enumerate(groups):
        tree = kd_tree(centres[large])
        for small in groups[: index + 1]:
            reach = float(radii[large].max() + radii[small].max())
            for first in range(0, len(small), _PLACES):
                some = small[first : first + _PLACES]
                near = tree.query_ball_point(centres[some], reach, return_sorted=True)
                other = large[np.concatenate([*map(np.asarray, near), np.zeros(0)]).astype(np.intp)]
                one = np.repeat(some, [len(each) for each in near])
                kept = np.linalg.norm(centres[one] - centres[other], axis=1) <= radii[one] + radii[other]
                kept &= (one < other) if small is large else True
                one, other = one[kept], other[kept]
                for start in range(0, len(one), _CHUNK):
                    yield one[start : start + _CHUNK], other[start : start + _CHUNK]


def _goes_through(points: Floats, one: Ints, other: Ints) -> Bools:
    """Whether an edge of each triangle of one (k, 3) goes through the other one (k, 3)."""
    through = np.zeros(len(one), dtype=bool)
    if not len(one):
        return through
    a, b, c = (points[other[:, k]] for k in range(3))
    normal = np.cross(b - a, c - a)
    size = np.abs(np.concatenate([b - a, c - a], axis=1)).max(axis=1)
    for k in range(3):
        ends = one[:, [k, (k + 1) % 3]]
        shared = (ends[:, :, None] == other[:, None, :]).any(axis=(1, 2))
        p, q = points[ends[:, 0]], points[ends[:, 1]]
        above, below = (np.einsum("ij,ij->i", each - a, normal) for each in (p, q))
        flat = _TOUCHES * size * np.linalg.norm(normal, axis=1)
        cuts = ~shared & (np.minimum(above, below) < -flat) & (np.maximum(above, below) > flat)
        rows = np.flatnonzero(cuts)
        if not len(rows):
            continue
        share = (above[rows] / (above[rows] - below[rows]))[:, None]
        at = p[rows] + share * (q[rows] - p[rows])
        square = np.einsum("ij,ij->i", normal[rows], normal[rows])
        inside = np.ones(len(rows), dtype=bool)
        for start, end in ((a, b), (b, c), (c, a)):
            side = np.cross(end[rows] - start[rows], at - start[rows])
            inside &= np.einsum("ij,ij->i", side, normal[rows]) > _TOUCHES * square
        through[rows[inside]] = True
    return through

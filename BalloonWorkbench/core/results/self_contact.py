# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a balloon passes through itself: the film does not feel its own touch in the simulation.

Triangles that share no vertex and cut each other are looked for in cells of space about as large as they are.
Films at a seam or a crease lie close and cut each other a little by the coarseness of the mesh: triangles are
neighbours, too, while fewer than NEAR edges lie between them.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.results.stl import balloon_mesh
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.types import Bools, Floats, Ints
from BalloonWorkbench.core.units import place_text

NEAR = 2
_MOST_PAIRS = 200_000  # at a time


@dataclass(frozen=True)
class SelfContact:
    """Pairs of triangles of the film that cut each other: how many, and where most of them are (3,) [m]."""

    count: int
    place: Floats | None = None

    @property
    def is_there(self) -> bool:
        """Whether the film passes through itself."""
        return self.count > 0


def self_contact(inflation: Inflation) -> SelfContact:
    """Whether the surface of an inflated balloon passes through itself."""
    positions, triangles = balloon_mesh(inflation)
    pairs = _apart(triangles, _near_pairs(positions, triangles))
    corners = positions[triangles]
    cut = np.concatenate(
        [
            _cut_each_other(corners[part[:, 0]], corners[part[:, 1]])
            for part in np.array_split(pairs, len(pairs) // _MOST_PAIRS + 1)
        ]
    )
    if not cut.any():
        return SelfContact(0)
    middles = corners[pairs[cut]].mean(axis=(1, 2))
    away = np.sum((middles - np.median(middles, axis=0)) ** 2, axis=1)
    return SelfContact(int(cut.sum()), middles[int(np.argmin(away))])


def through_itself(place: Floats) -> str:
    """A sentence on a place (3,) [m] where it does."""
    return (
        f"The film passes through itself near {place_text(place)}, which the simulation does not"
        " feel: the balloon will look otherwise there. Move those parts away from each other."
    )


def _near_pairs(positions: Floats, triangles: Ints) -> Ints:
    """Pairs (k, 2) of triangles whose boxes meet, the first before the second."""
    corners = positions[triangles]
    low, high = corners.min(axis=1), corners.max(axis=1)
    cell = max(float(np.quantile((high - low).max(axis=1), 0.95)), 1e-12)
    start = low.min(axis=0)
    first, last = (np.floor((part - start) / cell).astype(np.int64) for part in (low, high))
    spans = last - first + 1
    counts = spans.prod(axis=1)
    owner = np.repeat(np.arange(len(triangles)), counts)
    place = np.arange(len(owner)) - np.repeat(np.cumsum(counts) - counts, counts)
    steps = np.empty((len(owner), 3), dtype=np.int64)
    for axis in (2, 1, 0):
        place, steps[:, axis] = np.divmod(place, spans[owner, axis])
    cells = first[owner] + steps
    size = cells.max(axis=0) + 1
    key = (cells[:, 0] * size[1] + cells[:, 1]) * size[2] + cells[:, 2]
    order = np.argsort(key, kind="stable")
    key, owner = key[order], owner[order]
    pairs = []
    for shift in range(1, int(np.unique(key, return_counts=True)[1].max())):
        same = key[shift:] == key[:-shift]
        pairs.append(np.column_stack([owner[:-shift][same], owner[shift:][same]]))
    if not pairs:
        return np.zeros((0, 2), dtype=np.int64)
    joined = np.concatenate(pairs)
    one, other = joined.min(axis=1), joined.max(axis=1)
    meet = np.all((low[one] <= high[other]) & (low[other] <= high[one]), axis=1)
    unique = np.unique(one[meet] * len(triangles) + other[meet])
    return np.stack(np.divmod(unique, len(triangles)), axis=1)


def _apart(triangles: Ints, pairs: Ints) -> Ints:
    """Those pairs whose triangles have at least NEAR edges between their nearest vertices."""
    from scipy import sparse

    count = int(triangles.max()) + 1
    ahead = np.concatenate([triangles[:, [k, (k + 1) % 3]] for k in range(3)])
    ones = np.ones(len(ahead), dtype=np.int32)
    edges = sparse.csr_matrix((ones, (ahead[:, 0], ahead[:, 1])), shape=(count, count))
    step = (edges + edges.T + sparse.identity(count, dtype=np.int32, format="csr")).sign()
    corner = sparse.csr_matrix(
        (
            np.ones(triangles.size, dtype=np.int32),
            (np.repeat(np.arange(len(triangles)), 3), triangles.ravel()),
        ),
        shape=(len(triangles), count),
    )
    reach = corner
    for _ in range(NEAR - 1):
        reach = (reach @ step).sign()
    one, other = pairs.T
    shared = np.asarray(reach[one].multiply(corner[other]).sum(axis=1)).ravel()
    return pairs[shared == 0]


def _cut_each_other(first: Floats, second: Floats) -> Bools:
    """Whether triangles (k, 3, 3) and (k, 3, 3) cut: an edge of one goes through the other."""
    cut = np.zeros(len(first), dtype=bool)
    for one, other in ((first, second), (second, first)):
        for corner in range(3):
            cut |= _goes_through(one[:, corner], one[:, (corner + 1) % 3], other)
    return cut


def _goes_through(start: Floats, end: Floats, triangle: Floats) -> Bools:
    """Whether the way from start to end (k, 3) passes triangles (k, 3, 3): by volumes of tetrahedra."""
    a, b, c = np.moveaxis(triangle, 1, 0)
    normal = np.cross(b - a, c - a)
    above = np.einsum("ki,ki->k", start - a, normal)
    below = np.einsum("ki,ki->k", end - a, normal)
    way = end - start
    sides = [np.einsum("ki,ki->k", way, np.cross(p - start, q - start)) for p, q in ((a, b), (b, c), (c, a))]
    inside = np.all(np.sign(sides) == np.sign(sides[0]), axis=0)
    return np.asarray((above * below < 0.0) & inside)

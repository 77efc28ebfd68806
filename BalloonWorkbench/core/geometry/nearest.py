# SPDX-License-Identifier: LGPL-2.1-or-later
"""The place of a line that is nearest to a point, and how far it is."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.errors import MissingPackageError
from BalloonWorkbench.core.geometry.polyline import arc_lengths, edge_vectors, point_at
from BalloonWorkbench.core.geometry.vectors import foot
from BalloonWorkbench.core.packages import shapely, without_scipy
from BalloonWorkbench.core.types import Floats

Indices = NDArray[np.intp]

#: Up to so many points or edges each is compared with all: that is quicker than to make an index.
_FEW = 200
# Pairs compared at once where there is no index: some 50 MB.
_CHUNK = 1_000_000


class Nearest(NamedTuple):
    """Of each of k points the nearest place: number (k,) of the edge, share (k,) of it, distance (k,)."""

    edge: Indices
    share: Floats
    distance: Floats


def nearest_edges(points: Floats, starts: Floats, ends: Floats) -> Nearest:
    """Of edges from starts (m, 2) to ends (m, 2) the one nearest to each of points (k, 2)."""
    edge = _nearest_of_many(points, starts, ends) if min(len(points), len(starts)) > _FEW else None
    edge = _nearest_of_all(points, starts, ends) if edge is None else edge
    offset, ahead = points - starts[edge], ends[edge] - starts[edge]
    return Nearest(edge, *foot(offset[:, 0], offset[:, 1], ahead[:, 0], ahead[:, 1]))


def _nearest_of_many(points: Floats, starts: Floats, ends: Floats) -> Indices | None:
    """By shapely's index, which takes a tenth of the time; None without shapely."""
    try:
        package = shapely()
    except MissingPackageError:
        return None
    index = package.STRtree(package.linestrings(np.stack([starts, ends], axis=1)))
    return np.asarray(index.query_nearest(package.points(points), all_matches=False)[1])


def _nearest_of_all(points: Floats, starts: Floats, ends: Floats) -> Indices:
    u, v = (ends - starts).T
    step = max(1, _CHUNK // len(starts))
    parts = [np.zeros(0, dtype=np.intp)]
    for first in range(0, len(points), step):
        some = points[first : first + step]
        _, away = foot(some[:, :1] - starts[:, 0], some[:, 1:] - starts[:, 1], u, v)
        parts.append(np.argmin(away, axis=1))
    return np.concatenate(parts)


def nearest_on_line(line: Floats, points: Floats) -> Nearest:
    """The places of an open line (n, 2), of a loop its `ring`, that are nearest to points (k, 2)."""
    return nearest_edges(points, line[:-1], line[1:])


def nearest_on_loops(loops: Sequence[Floats], points: Floats) -> Nearest:
    """The places of closed loops that are nearest to points (k, 2), edges numbered through all loops."""
    ends = np.concatenate([np.roll(loop, -1, axis=0) for loop in loops])
    return nearest_edges(points, np.concatenate(loops), ends)


def nearest_places(loops: Sequence[Floats], points: Floats) -> Floats:
    """The places (k, 2) of closed loops that are nearest to points (k, 2)."""
    edge, share, _ = nearest_on_loops(loops, points)
    ahead = np.concatenate([edge_vectors(loop) for loop in loops])
    return np.asarray(np.concatenate(loops)[edge] + share[:, None] * ahead[edge])


def way_round(loops: Sequence[Floats], nearest: Nearest) -> tuple[Indices, Floats]:
    """For the nearest places of closed loops: the loop (k,) of each, and how far round it, 0 to 1 (k,)."""
    owner = np.repeat(np.arange(len(loops)), [len(loop) for loop in loops])
    lengths = [along / along[-1] for along in map(arc_lengths, loops)]
    begin, end = (np.concatenate([each[part] for each in lengths]) for part in (slice(-1), slice(1, None)))
    edge = nearest.edge
    return owner[edge], begin[edge] + nearest.share * (end - begin)[edge]


def locate(loop: Floats, points: Floats) -> Floats:
    """Arc lengths (k,) along a closed loop (n, 2) of the places nearest to points (k, 2)."""
    lengths = arc_lengths(loop)
    edge, share, _ = nearest_on_loops([loop], points)
    return np.asarray(np.mod(lengths[edge] + share * np.diff(lengths)[edge], lengths[-1]))


def nearest_along(loop: Floats, points: Floats, around: Floats, reach: Floats) -> Floats:
    """Nearest points (k, 2) of a closed loop, at most `reach` (k,) along it from lengths `around` (k,)."""
    count = len(loop)
    lengths = arc_lengths(loop)
    total = lengths[-1]
    # the edges that are near enough, as many for each point
    starts = np.concatenate([lengths[:-1] - total, lengths[:-1], lengths[:-1] + total])
    first = np.searchsorted(starts, around - reach, side="right") - 1
    width = int((np.searchsorted(starts, around + reach) - first).max())
    edge = (first[:, None] + np.arange(min(max(width, 1), count))) % count
    offset, ahead = points[:, None, :] - loop[edge], edge_vectors(loop)[edge]
    share, away = foot(offset[..., 0], offset[..., 1], ahead[..., 0], ahead[..., 1])
    along = lengths[edge] + share * np.diff(lengths)[edge]
    drift = np.mod(along - around[:, None] + 0.5 * total, total) - 0.5 * total
    away[np.abs(drift) > reach[:, None]] = np.inf
    row, best = np.arange(len(points)), np.argmin(away, axis=1)
    return point_at(loop, lengths, np.where(np.isfinite(away[row, best]), along[row, best], around))


def away_from_line(line: Floats, place: Floats) -> float:
    """How far a place (3,) in space is from a line (k, 3)."""
    start, step = line[:-1], np.diff(line, axis=0)
    share = ((place - start) * step).sum(axis=1) / np.maximum((step * step).sum(axis=1), 1e-300)
    feet = start + np.clip(share, 0.0, 1.0)[:, None] * step
    return float(np.linalg.norm(place - feet, axis=1).min())


def kd_tree(points: Floats) -> Any:
    """scipy's k-d tree of points (n, d)."""
    try:
        from scipy.spatial import cKDTree
    except ImportError as error:
        raise without_scipy("Meshing needs scipy: install it with pip install scipy.") from error
    return cKDTree(points)

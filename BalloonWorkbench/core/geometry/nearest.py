# SPDX-License-Identifier: LGPL-2.1-or-later
"""The place of a line that is nearest to a point, and how far it is."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.geometry.polyline import arc_lengths, edge_vectors, point_at, ring
from BalloonWorkbench.core.geometry.sampling import divided
from BalloonWorkbench.core.geometry.vectors import foot
from BalloonWorkbench.core.packages import shapely, without_scipy
from BalloonWorkbench.core.types import Floats

# Pairs of point and edge looked at together: some 50 MB.
_CHUNK = 1_000_000
_CANDIDATES = 4  # points of a loop beside which its nearest place may be


class Nearest(NamedTuple):
    """Of each of k points the nearest place: number (k,) of the edge, share (k,) of it, distance (k,)."""

    edge: NDArray[np.intp]
    share: Floats
    distance: Floats


def nearest_edges(points: Floats, starts: Floats, ends: Floats) -> Nearest:
    """Of edges from starts (m, 2) to ends (m, 2) the one nearest to each of points (k, 2).

    Each point is compared with each edge: shapely's indices are slower below some thousand edges.
    """
    u, v = (ends - starts).T
    parts = []
    step = max(1, _CHUNK // max(len(starts), 1))
    for first in range(0, max(len(points), 1), step):
        some = points[first : first + step]
        share, away = foot(some[:, :1] - starts[:, 0], some[:, 1:] - starts[:, 1], u, v)
        row, edge = np.arange(len(some)), np.argmin(away, axis=1)
        parts.append((edge, share[row, edge], away[row, edge]))
    return Nearest(*(np.concatenate(each) for each in zip(*parts)))


def nearest_on_line(line: Floats, points: Floats) -> Nearest:
    """The places of an open line (n, 2), of a loop its `ring`, that are nearest to points (k, 2)."""
    return nearest_edges(points, line[:-1], line[1:])


def locate(loop: Floats, points: Floats) -> Floats:
    """Arc lengths (k,) along a closed loop (n, 2) of the places nearest to points (k, 2).

    By shapely, which is ten times as quick as each point with each edge.
    """
    package = shapely()
    return np.asarray(package.line_locate_point(package.LineString(ring(loop)), package.points(points)))


def nearest_places(loops: Sequence[Floats], points: Floats) -> Floats:
    """Nearest places (k, 2) of closed loops to points (k, 2). By shapely, as `locate`."""
    package = shapely()
    lines = package.MultiLineString([ring(loop) for loop in loops])
    package.prepare(lines)
    return np.asarray(package.get_coordinates(package.shortest_line(package.points(points), lines))[1::2])


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


def nearest_on_loops(
    loops: Sequence[Floats], points: Floats, spacing: float
) -> tuple[Floats, NDArray[np.intp], Floats]:
    """Distances (k,) from points (k, 2) to closed loops, the nearest loop (k,), and how far round it, 0 to 1.

    Looked for among the edges beside the nearest points of the loops, `spacing` apart or less: for many
    points and many edges.
    """
    dense = [divided(loop, spacing) for loop in loops]
    starts = np.concatenate(dense)
    ahead = np.concatenate([edge_vectors(loop) for loop in dense])
    lengths = [arc_lengths(loop) / arc_lengths(loop)[-1] for loop in dense]
    begin, end = (np.concatenate([each[part] for each in lengths]) for part in (slice(-1), slice(1, None)))
    owner = np.repeat(np.arange(len(loops)), [len(loop) for loop in dense])
    counts = np.cumsum([0, *(len(loop) for loop in dense)])
    before = np.concatenate([first + np.roll(np.arange(len(loop)), 1) for first, loop in zip(counts, dense)])
    near = kd_tree(starts).query(points, k=_CANDIDATES)[1]
    edge = np.concatenate([near, before[near]], axis=1)
    offset = points[:, None] - starts[edge]
    share, away = foot(offset[..., 0], offset[..., 1], ahead[edge, 0], ahead[edge, 1])
    row, best = np.arange(len(points)), np.argmin(away, axis=1)
    chosen, part = edge[row, best], share[row, best]
    return away[row, best], owner[chosen], np.asarray(begin[chosen] + part * (end - begin)[chosen])


def kd_tree(points: Floats) -> Any:
    """scipy's k-d tree of points (n, 2)."""
    try:
        from scipy.spatial import cKDTree
    except ImportError as error:
        raise without_scipy("Meshing needs scipy: install it with pip install scipy.") from error
    return cKDTree(points)

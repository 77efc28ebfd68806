# SPDX-License-Identifier: LGPL-2.1-or-later
"""The seam: evenly spaced vertices along each loop, corners kept."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.errors import MeshError
from BalloonWorkbench.core.mesh.sizing import SizeField, kd_tree
from BalloonWorkbench.core.types import Floats, Ints

#: A loop's vertex is a corner when the loop turns by more than this within one edge length [rad].
CORNER = np.radians(30.0)
_FEWEST = 8


def seam_points(loops: tuple[Floats, ...], field: SizeField) -> tuple[tuple[Floats, ...], SizeField]:
    """Resampled loops (k, 2), in the order and sense given, and the field refined where they would cross."""
    for _ in range(8):
        seams = tuple(_resampled(loop, field) for loop in loops)
        touching = crossings(seams)
        if not len(touching):
            return seams, field
        closer = 0.5 * field.at(touching)
        if closer.min() < 0.02 * field.size:
            break
        field = SizeField(field.size, (*field.groups, (float(closer.min()), touching)))
    x, y = 1e3 * touching[0]
    raise MeshError(
        f"The outline crosses or nearly touches itself near ({x:.1f}, {y:.1f}) mm: separate the parts that meet there."
    )


def corners(loop: Floats, sizes: Floats) -> Ints:
    """Indices of the vertices (n, 2) at which a loop turns sharply, seen at the scale sizes (n,)."""
    closed = np.concatenate([loop, loop[:1]])
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(closed, axis=0), axis=1))])
    window = np.minimum(0.6 * sizes, along[-1] / _FEWEST)
    here = along[:-1]

    def at(marks: Floats) -> Floats:
        return np.stack([np.interp(marks % along[-1], along, closed[:, k]) for k in range(2)], axis=1)

    before, after = loop - at(here - window), at(here + window) - loop
    cross = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]
    turn = np.abs(np.arctan2(cross, (before * after).sum(axis=1)))
    kept: list[int] = []
    for index in np.argsort(-turn, kind="stable"):  # the sharpest of a neighbourhood wins
        if turn[index] < CORNER:
            break
        apart = np.abs(here[kept] - here[index])
        if not len(kept) or np.all(np.minimum(apart, along[-1] - apart) > window[index]):
            kept.append(int(index))
    return np.sort(np.asarray(kept, dtype=np.int32))


def crossings(loops: tuple[Floats, ...]) -> Floats:
    """Middles (k, 2) of the segments that cross another one."""
    starts = np.concatenate(loops)
    ends = np.concatenate([np.roll(loop, -1, axis=0) for loop in loops])
    middles, half = 0.5 * (starts + ends), 0.5 * np.linalg.norm(ends - starts, axis=1)
    pairs = kd_tree()(middles).query_pairs(2.0 * float(half.max()), output_type="ndarray")
    i, j = pairs[np.linalg.norm(middles[pairs[:, 0]] - middles[pairs[:, 1]], axis=1) < half[pairs].sum(axis=1)].T
    neighbours = (starts[i] == ends[j]).all(axis=1) | (ends[i] == starts[j]).all(axis=1)
    i, j = i[~neighbours], j[~neighbours]

    def side(a: Floats, b: Floats, c: Floats) -> Floats:
        u, v = b - a, c - a
        result: Floats = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
        return result

    apart_i = side(starts[i], ends[i], starts[j]) * side(starts[i], ends[i], ends[j]) > 0.0
    apart_j = side(starts[j], ends[j], starts[i]) * side(starts[j], ends[j], ends[i]) > 0.0
    crossing = ~apart_i & ~apart_j
    found: Floats = middles[np.unique(np.concatenate([i[crossing], j[crossing]]))]
    return found


def _resampled(loop: Floats, field: SizeField) -> Floats:
    sizes = field.at(loop)
    fixed = corners(loop, sizes)
    first = int(fixed[0]) if len(fixed) else 0
    loop = np.roll(loop, -first, axis=0)
    closed = np.concatenate([loop, loop[:1]])
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(closed, axis=0), axis=1))])
    marks = along[np.append(fixed - first, len(loop)) if len(fixed) else [0, len(loop)]]
    # Number of edges along the loop: the integral of 1 / size.
    fine = np.union1d(np.linspace(0.0, along[-1], max(64, int(4.0 * along[-1] / field.smallest))), marks)
    places = np.stack([np.interp(fine, along, closed[:, k]) for k in range(2)], axis=1)
    density = 1.0 / field.at(places)
    count = np.concatenate([[0.0], np.cumsum(0.5 * (density[1:] + density[:-1]) * np.diff(fine))])
    pieces = []
    for start, end in zip(marks[:-1], marks[1:], strict=True):
        low, high = np.interp([start, end], fine, count)
        edges = max(round(high - low), 1 if len(fixed) > 2 else 3)
        pieces.append(np.interp(np.linspace(low, high, edges + 1)[:-1], count, fine))
    stops = np.concatenate(pieces)
    return np.stack([np.interp(stops, along, closed[:, k]) for k in range(2)], axis=1)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Relaxing a triangulation: move, add and drop interior vertices until the triangles are even."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.geometry.nearest import kd_tree
from BalloonWorkbench.core.geometry.triangulation import corner_angles, side_lengths, signed_areas
from BalloonWorkbench.core.geometry.vectors import cross, direction
from BalloonWorkbench.core.mesh.delaunay import triangulate_points
from BalloonWorkbench.core.mesh.sizing import SizeField
from BalloonWorkbench.core.types import Bools, Floats, Ints

#: A corner of the seam below this angle is a sharp tip: it keeps one triangle with all vertices on the seam.
SHARP = np.radians(40.0)
SWEEPS = 10
_EDITS = (1, 3, 5, 7)
_TINY = 1e-300


def relax(
    points: Floats,
    loops: tuple[Ints, ...],
    field: SizeField,
    lines: tuple[Ints, ...] = (),
    sweeps: int = SWEEPS,
) -> tuple[Floats, Ints]:
    """An even mesh of the vertices on loops and open lines (which come first and stay) and interior ones.

    Vertices move to the mean of the surrounding circumcentres, weighted by area: optimal Delaunay smoothing
    (Chen & Holst, Computer Methods in Applied Mechanics and Engineering 200 (2011) 967-984).
    Returns points and triangles.
    """
    fixed = _fixed(loops, lines)
    triangles = triangulate_points(points, loops, lines)
    for sweep in range(sweeps):
        points = _smoothed(points, fixed, triangles, field)
        if sweep in _EDITS:
            stays = _uncrowded(points, fixed, triangles, field)
            points = np.concatenate([points[stays], _missing(points, loops, triangles, field, lines)])
        triangles = triangulate_points(points, loops, lines)
    points, triangles = _repaired(*_unlocked(points, loops, triangles, field, lines), loops, lines)
    return _unlocked(points, loops, triangles, field, lines)


def _fixed(loops: tuple[Ints, ...], lines: tuple[Ints, ...]) -> int:
    """How many vertices lie on loops and lines."""
    return 1 + max(int(chain.max()) for chain in (*loops, *lines))


def chord_middles(
    points: Floats, loops: tuple[Ints, ...], triangles: Ints, lines: tuple[Ints, ...] = ()
) -> Floats:
    """Where to add vertices (k, 2) so that no inner edge joins two vertices of the seam, sharp tips excepted.

    Such an edge is held down at both ends and pinches the balloon, a triangle of three of them cannot rise.
    """
    fixed = _fixed(loops, lines)
    following = np.full((3, fixed), -1, dtype=np.int32)
    for loop in loops:
        following[0, loop] = np.roll(loop, -1)
    for line in lines:  # which has film on both sides
        following[1, line[:-1]], following[2, line[1:]] = line[1:], line[:-1]
    near = triangles[(triangles < fixed).sum(axis=1) >= 2]
    starts, ends = np.roll(near, -1, axis=1), np.roll(near, -2, axis=1)  # the edge opposite to each corner
    joins = (starts < fixed) & (ends < fixed)
    on_seam = joins & (following[:, np.where(joins, starts, 0)] == ends).any(axis=0)
    length = np.where(joins & ~on_seam, side_lengths(points, near), 0.0)
    longest, row = length.argmax(axis=1), np.arange(len(near))
    tip = (on_seam.sum(axis=1) == 2) & (corner_angles(points, near)[row, longest] < SHARP)
    chord = np.sort(np.stack([starts[row, longest], ends[row, longest]], axis=1), axis=1)
    # Each chord belongs to two triangles, and one of a tip may stay.
    allowed = set(map(tuple, chord[tip].tolist()))
    to_split = sorted(set(map(tuple, chord[length.max(axis=1, initial=0.0) > 0.0].tolist())) - allowed)
    return points[np.array(to_split, dtype=np.int32).reshape(-1, 2)].mean(axis=1)


def _unlocked(
    points: Floats, loops: tuple[Ints, ...], triangles: Ints, field: SizeField, lines: tuple[Ints, ...]
) -> tuple[Floats, Ints]:
    """With vertices added on the chords of the seam until there are none."""
    for _ in range(8):
        middles = _spread(chord_middles(points, loops, triangles, lines), field)
        if not len(middles):
            break
        points = np.concatenate([points, middles])
        triangles = triangulate_points(points, loops, lines)
    return points, triangles


def _smoothed(points: Floats, fixed: int, triangles: Ints, field: SizeField) -> Floats:
    areas = signed_areas(points, triangles)
    a, b, c = (points[triangles[:, k]] for k in range(3))
    middle = (a + b + c) / 3.0
    u, v = b - a, c - a
    uu, vv = (u * u).sum(axis=1), (v * v).sum(axis=1)
    offset = np.stack([v[:, 1] * uu - u[:, 1] * vv, u[:, 0] * vv - v[:, 0] * uu], axis=1)
    away = a + offset / (4.0 * np.maximum(areas, _TINY))[:, None] - middle
    # The circumcentre of an obtuse triangle lies outside it: keep the target near the middle.
    limit = 0.35 * np.sqrt(np.maximum(areas, 0.0))
    target = middle + away * np.minimum(1.0, limit / np.maximum(np.linalg.norm(away, axis=1), _TINY))[:, None]
    weight = areas / field.at(middle) ** 2 if field.groups else areas
    total = np.bincount(triangles.ravel(), np.repeat(weight, 3), len(points))
    moved = points.copy()
    for k in range(2):
        pull = np.bincount(triangles.ravel(), np.repeat(weight * target[:, k], 3), len(points))
        moved[fixed:, k] = pull[fixed:] / np.maximum(total[fixed:], _TINY)
    lost = np.flatnonzero(total[fixed:] <= 0.0) + fixed
    moved[lost] = points[lost]
    for _ in range(5):  # no triangle may turn over: the vertices of one that would stay
        bad = signed_areas(moved, triangles) < 0.05 * areas
        if not bad.any():
            break
        still = np.unique(triangles[bad])
        moved[still] = points[still]
    return moved


def _uncrowded(points: Floats, fixed: int, triangles: Ints, field: SizeField) -> Bools:
    """Which vertices to keep: all but one interior end of each edge that is much too short."""
    stays = np.bincount(triangles.ravel(), minlength=len(points)) > 0
    stays[:fixed] = True
    ends = np.sort(triangles[:, [1, 2, 2, 0, 0, 1]].reshape(-1, 2), axis=1)
    length = np.linalg.norm(points[ends[:, 0]] - points[ends[:, 1]], axis=1)
    sizes = field.at(points)[ends].min(axis=1)
    # Next to the seam vertices may be close: they keep narrow corners from locking.
    short = (ends[:, 1] >= fixed) & (length < np.where(ends[:, 0] < fixed, 0.3, 0.6) * sizes)
    busy = np.zeros(len(points), dtype=bool)
    for k in np.flatnonzero(short)[np.argsort(length[short], kind="stable")]:
        p, q = ends[k]
        if not busy[p] and not busy[q]:
            busy[[p, q]] = True
            stays[q] = False
    return stays


def _missing(
    points: Floats, loops: tuple[Ints, ...], triangles: Ints, field: SizeField, lines: tuple[Ints, ...]
) -> Floats:
    """Vertices to add: in triangles that are much too large, and where triangles would be locked."""
    fixed = _fixed(loops, lines)
    middle = points[triangles].mean(axis=1)
    areas = signed_areas(points, triangles)
    sizes = field.at(middle)
    circumradius = side_lengths(points, triangles).prod(axis=1) / (4.0 * np.maximum(areas, _TINY))
    wide = (circumradius > 0.95 * sizes) & (areas > 0.6 * sizes**2) & (triangles >= fixed).any(axis=1)
    return _spread(np.concatenate([chord_middles(points, loops, triangles, lines), middle[wide]]), field)


def _spread(points: Floats, field: SizeField) -> Floats:
    """The points without those too close to an earlier one."""
    if len(points) < 2:
        return points
    stays = np.ones(len(points), dtype=bool)
    sizes = field.at(points)
    for i, j in sorted(kd_tree(points).query_pairs(0.5 * field.size)):
        if stays[i] and stays[j] and np.linalg.norm(points[i] - points[j]) < 0.2 * sizes[j]:
            stays[j] = False
    return points[stays]


def _repaired(
    points: Floats, triangles: Ints, loops: tuple[Ints, ...], lines: tuple[Ints, ...]
) -> tuple[Floats, Ints]:
    """Move the vertices of the worst triangles, one by one, to where their smallest angle grows."""
    fixed = _fixed(loops, lines)
    compass = direction(np.radians(np.arange(0.0, 360.0, 30.0)))
    for _ in range(6):
        angles = corner_angles(points, triangles).min(axis=1)
        bad = np.flatnonzero(angles < np.radians(30.0))
        movable = np.unique(triangles[bad])
        movable = movable[movable >= fixed]
        if not len(movable):
            break
        points, improved = points.copy(), False
        order = np.argsort(triangles.ravel(), kind="stable")
        starts = np.searchsorted(triangles.ravel()[order], np.stack([movable, movable + 1]))
        for vertex, first, last in zip(movable, *starts, strict=True):
            ring = triangles[order[first:last] // 3]
            place = points[vertex]
            best = corner_angles(points, ring).min()
            reach = 0.3 * np.sqrt(np.abs(signed_areas(points, ring)).mean())
            for _ in range(4):
                trials = np.concatenate([place[None], place + reach * compass])
                score = _ring_scores(points, ring, vertex, trials)
                pick = int(score.argmax())
                if score[pick] > best + 1e-6:
                    place, best, improved = trials[pick], float(score[pick]), True
                else:
                    reach *= 0.5
            points[vertex] = place
        triangles = triangulate_points(points, loops, lines)
        if not improved:
            break
    return points, triangles


def _ring_scores(points: Floats, ring: Ints, vertex: int, trials: Floats) -> Floats:
    """Smallest angle (t,) of the triangles around a vertex for each place (t, 2) it could take."""
    corner = np.argmax(ring == vertex, axis=1)
    row = np.arange(len(ring))
    p, q = points[ring[row, corner - 2]], points[ring[row, corner - 1]]
    u, v, w = p - trials[:, None], q - trials[:, None], np.broadcast_to(q - p, (len(trials), *p.shape))
    area = cross(u, v)
    angles = np.stack(
        [
            np.arctan2(area, (u * v).sum(-1)),
            np.arctan2(area, -(u * w).sum(-1)),
            np.arctan2(area, (v * w).sum(-1)),
        ]
    )
    return angles.min(axis=(0, 2))

# SPDX-License-Identifier: LGPL-2.1-or-later
"""How loops and surfaces run and bend: normals, and the points that are corners."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.geometry.polyline import arc_lengths, edge_vectors, point_at
from BalloonWorkbench.core.geometry.vectors import perpendicular, turn, unit
from BalloonWorkbench.core.types import Floats, Ints

#: A turn sharper than this is a corner: well above the facets of a flattened curve, below an octagon's 45
#: degrees.
CORNER_ANGLE = np.radians(35.0)


def tangents(loop: Floats) -> Floats:
    """From the point before each point of the closed loop (n, 2) to the one after it: (n, 2)."""
    return np.asarray(np.roll(loop, -1, axis=0) - np.roll(loop, 1, axis=0))


def left_normals(loop: Floats, smoothed: int = 0) -> Floats:
    """Unit normals (n, 2) to the left at the points of a closed loop, square to the line between neighbours.

    smoothed  how often each direction is averaged with those beside it, for a loop that is crumpled
    """
    along: Floats = tangents(loop)
    for _ in range(smoothed):
        along = 2.0 * along + np.roll(along, -1, axis=0) + np.roll(along, 1, axis=0)
    return unit(perpendicular(along))


def vertex_normals(positions: Floats, triangles: Ints) -> Floats:
    """Unit normals (n, 3) of the vertices of a surface in space, weighted by area."""
    a, b, c = (positions[triangles[:, k]] for k in range(3))
    weighted = np.cross(b - a, c - a)
    normals: Floats = np.stack(
        [np.bincount(triangles.ravel(), np.repeat(weighted[:, k], 3), len(positions)) for k in range(3)],
        axis=1,
    )
    return unit(normals)


def turns(loop: Floats, reach: float = 0.0) -> Floats:
    """Angle (n,) by which the closed loop (n, 2) turns at each point, positive to the left [rad].

    reach  distance along the loop over which the directions before and after are taken; 0 compares
           neighbouring edges
    """
    if reach <= 0.0:
        after = edge_vectors(loop)
        return turn(np.roll(after, 1, axis=0), after)
    lengths = arc_lengths(loop)
    return turns_at(loop, lengths, lengths[:-1], reach)


def turns_at(loop: Floats, lengths: Floats, at: Floats, reach: float) -> Floats:
    """The same at arc lengths `at` (k,) along the loop, `lengths` being its `arc_lengths`: (k,) rad."""
    here = point_at(loop, lengths, at)
    return turn(here - point_at(loop, lengths, at - reach), point_at(loop, lengths, at + reach) - here)


def corners(loop: Floats, angle: float = CORNER_ANGLE, reach: float = 0.0) -> NDArray[np.intp]:
    """Indices of the corners of a closed loop (n, 2), in order.

    angle  turn that makes a corner [rad]
    reach  see `turns`: so that a corner cut off by the pixels of a picture is still one
    """
    if reach <= 0:
        return np.flatnonzero(np.abs(turns(loop)) > angle)
    lengths = arc_lengths(loop)
    away = np.abs(turns_at(loop, lengths, lengths[:-1], reach))
    sharp = np.flatnonzero(away > angle)
    # The sharpest first; whatever else turns within its reach is the same corner. Bins keep the search short.
    bins: dict[int, list[float]] = {}
    count = max(1, int(lengths[-1] // reach))
    chosen: list[int] = []
    for k in sharp[np.argsort(-away[sharp], kind="stable")]:
        at = float(lengths[k])
        own = int(at / lengths[-1] * count)
        near = [other for shift in (-1, 0, 1) for other in bins.get((own + shift) % count, ())]
        if all(reach < abs(at - other) < lengths[-1] - reach for other in near):
            chosen.append(int(k))
            bins.setdefault(own % count, []).append(at)
    return np.array(sorted(chosen), dtype=np.intp)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Free ends of pen strokes, and which two of them the hand meant to meet."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.geometry.vectors import direction, unit
from BalloonWorkbench.core.tracing.raster import distance, label
from BalloonWorkbench.core.types import Bools, Floats

# Seen from a point of a stroke's middle line, on a circle of 1.5 stroke widths around it: ...
_CIRCLE = 1.5
_DIRECTIONS = 48
# ... near a free end the stroke takes up one arc of the circle, no wider than this.
_WIDEST_ARC = np.radians(110.0)
# The angles by which both strokes have to bend to run into each other, added up: 180 degrees for two whiskers
# side by side, which are not to be joined.
_MOST_BEND = np.radians(135.0)
# More ends than this are a texture, not strokes.
_MOST_ENDS = 500


def free_ends(ink: Bools, width: float) -> tuple[Floats, Floats]:
    """Where strokes of about the given width [px] end: the middles (k, 2) of their round ends, as (x, y) px,
    and the unit directions (k, 2) in which they run out. None in a texture of very many."""
    y, x = np.nonzero(distance(ink) >= 0.4 * width)
    arcs = np.zeros(len(x), dtype=np.int32)
    covered = np.zeros(len(x), dtype=np.int32)
    outward = np.zeros((len(x), 2))
    before = None
    for angle in 2 * np.pi * np.arange(_DIRECTIONS + 1) / _DIRECTIONS:
        ray = direction(angle)
        to_x, to_y = np.rint(_CIRCLE * width * ray).astype(int)
        here = ink[np.clip(y + to_y, 0, ink.shape[0] - 1), np.clip(x + to_x, 0, ink.shape[1] - 1)]
        if before is not None:
            arcs += here & ~before
            covered += here
            outward -= here[:, None] * ray
        before = here
    # No arc at all is a dot, which has no end.
    near_end = (arcs == 1) & (covered <= _DIRECTIONS * _WIDEST_ARC / (2 * np.pi))
    x, y, outward = x[near_end], y[near_end], outward[near_end]
    outward = unit(outward)
    zone = np.zeros(ink.shape, dtype=np.bool_)
    zone[y, x] = True
    labels, count = label(zone)
    points, headings = [], []
    for name in range(1, count + 1 if count <= _MOST_ENDS else 1):
        own = np.flatnonzero(labels[y, x] == name)
        heading = outward[own].mean(axis=0)
        length = float(np.linalg.norm(heading))
        # A zone whose points do not agree on a direction is a blob.
        if length < 0.7:
            continue
        last = own[np.argmax(np.column_stack([x, y])[own] @ heading)]
        points.append((x[last], y[last]))
        headings.append(outward[last])
    return np.array(points, dtype=np.float64).reshape(-1, 2), np.array(headings).reshape(-1, 2)


def meeting_ends(ink: Bools, width: float, limit: float) -> list[tuple[Floats, Floats]]:
    """Pairs of free ends, each (x, y) px, that are each other's nearest and run towards each other across a
    gap of at most `limit` px."""
    points, headings = free_ends(ink, width)
    if len(points) < 2:
        return []
    way = points[None] - points[:, None]
    away = np.linalg.norm(way, axis=2)
    np.fill_diagonal(away, np.inf)
    towards = np.einsum("ijk,ik->ij", way, headings) / away
    bend = np.arccos(np.clip(towards, -1, 1))
    away = np.where((bend + bend.T <= _MOST_BEND) & (away - width <= limit), away, np.inf)
    nearest = np.argmin(away, axis=1)
    return [
        (points[i], points[j])
        for i, j in enumerate(nearest)
        if i < j and nearest[j] == i and np.isfinite(away[i, j])
    ]

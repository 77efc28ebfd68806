# SPDX-License-Identifier: LGPL-2.1-or-later
"""The strip of film outside the seams of a panel, where both films are welded, in two layers of triangles."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.geometry.normals import turns
from BalloonWorkbench.core.geometry.polyline import edge_vectors
from BalloonWorkbench.core.geometry.triangulation import signed_areas
from BalloonWorkbench.core.geometry.vectors import perpendicular, unit
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.types import Floats, Ints

LAYERS = 2
#: So far, in strip widths, it reaches at a sharp corner of the panel.
_MITRE = 2.0
#: It leaves so much of the room between seams that face each other.
_CLEAR = 0.1
#: A triangle counts as turned below this part of the area that it had if edges stayed as long farther out, as
#: in a narrow strip; then the strip becomes narrower there.
_LEAST_AREA, _NARROW, _NARROWER, _MOST_TRIES = 0.1, 1e-3, 0.8, 100


@dataclass(frozen=True)
class OuterStrip:
    """Film outside the seams of a panel.

    rim             (r,) vertices of the panel's loops in a row
    rest_positions  ((LAYERS + 1) r, 2) m: those of the rim, then of each layer farther out, beside the rim's
    triangles       (t, 3), counter-clockwise
    """

    rim: Ints
    rest_positions: Floats
    triangles: Ints


def strip_outside(panel: Panel, width: float) -> OuterStrip:
    """The strip of a width [m] outside the outer loop and inside the holes of a panel.

    It is narrower where there is less room: in notches, in small holes, between seams that face each other.
    """
    rim, ahead = np.concatenate(panel.loops), _next_along(panel)
    points = panel.rest_positions[rim]
    outward, reach = (
        np.concatenate(parts) for parts in zip(*(_outward(panel, loop) for loop in panel.loops))
    )
    reach = np.minimum(width * reach, (1.0 - _CLEAR) * _room(points, outward))
    triangles = _triangles(ahead)

    def places(share: float) -> Floats:
        layers = [share * layer / LAYERS * reach[:, None] * outward for layer in range(LAYERS + 1)]
        return np.concatenate([points + layer for layer in layers])

    for _ in range(_MOST_TRIES):
        areas = signed_areas(places(1.0), triangles)
        turned = areas < _LEAST_AREA * signed_areas(places(_NARROW), triangles) / _NARROW
        if not turned.any():
            break
        reach[np.unique(triangles[turned] % len(rim))] *= _NARROWER
    return OuterStrip(rim, places(1.0), triangles)


def _next_along(panel: Panel) -> Ints:
    """For each vertex of the rim the number of the next one of its loop: (r,)."""
    starts = np.cumsum([0, *map(len, panel.loops)])
    numbers = [np.roll(np.arange(len(loop)) + at, -1) for loop, at in zip(panel.loops, starts)]
    return np.concatenate(numbers).astype(np.int32)


def _outward(panel: Panel, loop: Ints) -> tuple[Floats, Floats]:
    """Unit vectors (k, 2) out of the panel, halfway between two edges, and how far an offset of 1 reaches."""
    points = panel.rest_positions[loop]
    along = unit(edge_vectors(points))
    half = 0.5 * turns(points)
    outward = -perpendicular(unit(along + np.roll(along, 1, axis=0)))
    return outward, np.minimum(1.0 / np.maximum(np.cos(half), 1e-9), _MITRE)


def _room(points: Floats, outward: Floats) -> Floats:
    """How far (r,) one may go out of each point and have none of the others nearer: to the medial axis."""
    room = np.full(len(points), np.inf)
    for number, (point, way) in enumerate(zip(points, outward)):
        others = points - point
        ahead = 2.0 * others @ way
        facing = ahead > 1e-12 * np.abs(ahead).max()
        room[number] = np.min((others[facing] ** 2).sum(axis=1) / ahead[facing], initial=np.inf)
    return room


def _triangles(ahead: Ints) -> Ints:
    """Two for each edge of the rim and each layer, with diagonals that alternate: (2 LAYERS r, 3)."""
    count = len(ahead)
    here, odd = np.arange(count), (np.arange(count) % 2 == 1)[:, None]
    parts = []
    for layer in range(LAYERS):
        a, b = here + layer * count, ahead + layer * count
        outer_a, outer_b = a + count, b + count
        parts += [
            np.where(odd, np.column_stack([b, a, outer_a]), np.column_stack([b, a, outer_b])),
            np.where(odd, np.column_stack([b, outer_a, outer_b]), np.column_stack([a, outer_a, outer_b])),
        ]
    return np.concatenate(parts).astype(np.int32)

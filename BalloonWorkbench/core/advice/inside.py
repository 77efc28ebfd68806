# SPDX-License-Identifier: LGPL-2.1-or-later
"""Values at any place of a triangulated area."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.types import Floats, Ints

_CHUNK = 500_000  # pairs of place and triangle looked at together


class Located:
    """A triangulation of points (n, 2) in which places are looked up; triangles may overlap a little."""

    def __init__(self, points: Floats, triangles: Ints) -> None:
        self._triangles = triangles
        a, b, c = np.moveaxis(points[triangles], 1, 0)
        self._origin = c
        u, v = a - c, b - c
        turn = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
        turn = np.where(np.abs(turn) < 1e-300, 1e-300, turn)
        # area coordinates of a place p are rows @ (p - c)
        first = np.stack([v[:, 1], -v[:, 0]], axis=1) / turn[:, None]
        second = np.stack([-u[:, 1], u[:, 0]], axis=1) / turn[:, None]
        self._rows = np.stack([first, second], axis=1)

    def values(self, field: Floats, places: Floats) -> Floats:
        """A field (n, d) at places (k, 2): linear inside, that of the nearest edge for places outside."""
        found = np.empty((len(places), field.shape[1]))
        step = max(1, _CHUNK // max(len(self._triangles), 1))
        for first in range(0, len(places), step):
            some = places[first : first + step]
            share = np.einsum("mab,kmb->kma", self._rows, some[:, None] - self._origin[None])
            weights = np.concatenate([share, 1.0 - share.sum(axis=2, keepdims=True)], axis=2)
            best = np.argmax(weights.min(axis=2), axis=1)
            chosen = np.clip(weights[np.arange(len(some)), best], 0.0, 1.0)
            chosen /= chosen.sum(axis=1, keepdims=True)
            corners = field[self._triangles[best]]
            found[first : first + step] = np.einsum("ka,kad->kd", chosen, corners)
        return found

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panels of a division whose place on the flat film is known exactly, with the curves of their edges."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np

from BalloonWorkbench.core.flattening.level import level_turn
from BalloonWorkbench.core.geometry.polyline import extent, line_lengths
from BalloonWorkbench.core.geometry.splines import through
from BalloonWorkbench.core.targets.half_edges import ahead
from BalloonWorkbench.core.targets.target import Division
from BalloonWorkbench.core.types import Floats, Ints

#: Corners so near to each other, as a part of the panel's extent, are one.
_SAME = 1e-7
#: Edges of the line that stands for a piece of a curve.
_FINE = 400
#: By how much the area of a panel may differ from that of the points round it, as a part of it.
EXACT_AREA = 6e-7


@dataclass(frozen=True)
class UnrolledPanel:
    """A panel that is laid flat exactly.

    places   (k, 2) m of its opened vertices
    between  for the ends (two opened vertices) of each edge that stands for a piece of a curve, three places
             (3, 2) m on the curve
    first    its first opened vertex
    """

    places: Floats
    between: dict[tuple[int, int], Floats]
    first: int

    def line(self, vertices: Ints) -> Floats:
        """A fine line (n, 2) m along opened vertices that follow each other round the panel."""
        places = self.places[vertices - self.first]
        parts = []
        for number, ends in enumerate(zip(vertices[:-1].tolist(), vertices[1:].tolist())):
            here, there = places[number], places[number + 1]
            middle = self.between.get(ends)
            if middle is None:
                parts.append(here[None])
            else:
                parts.append(_fine() @ np.vstack([here, middle, there]))
        return np.concatenate([*parts, places[-1:]])

    def edges_needed(self, vertices: Ints, area: float, sides: int) -> int:
        """Into how many even edges a side of so many is parted so that the area [m2] stays what it is."""
        line = self.line(vertices)
        steps = np.diff(line, axis=0)
        turns = np.angle((steps[1:, 0] + 1j * steps[1:, 1]) * np.conj(steps[:-1, 0] + 1j * steps[:-1, 1]))
        turned = float(np.abs(turns).sum())
        length = float(line_lengths(line)[-1])
        return int(np.ceil(length * np.sqrt(sides * turned / (12.0 * EXACT_AREA * area))))


@cache
def _fine() -> Floats:
    """Polynomials through five even places, at so many even places from the first on."""
    return through(np.arange(_FINE) / _FINE)


def unrolled_panels(division: Division) -> dict[int, UnrolledPanel]:
    """The panels that are laid flat exactly: all their triangles are, and hang together there."""
    flats, opened = division.flats, division.opened
    if flats is None:
        return {}
    corners = flats.corners.reshape(-1, 2)
    places = np.full((len(opened.vertices), 2), np.nan)
    places[opened.triangles.ravel()] = corners
    apart = np.linalg.norm(corners - places[opened.triangles.ravel()], axis=1).reshape(-1, 3).max(axis=1)
    unrolled = {}
    for number in range(len(division.names)):
        own = division.panels == number
        first, last = np.searchsorted(opened.panels, [number, number + 1])
        flat = places[first:last]
        if not np.isfinite(flats.corners[own]).all() or apart[own].max() > _SAME * extent(flat):
            continue
        turn = level_turn(flat)
        edges = flats.bent[own[flats.bent // 3]]
        between = flats.between[own[flats.bent // 3]] @ turn
        corner = opened.triangles.ravel()
        ends = zip(corner[edges].tolist(), corner[ahead(edges)].tolist())
        unrolled[number] = UnrolledPanel(flat @ turn, dict(zip(ends, between)), int(first))
    return unrolled

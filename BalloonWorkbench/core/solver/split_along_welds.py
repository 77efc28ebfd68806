# SPDX-License-Identifier: LGPL-2.1-or-later
"""Welds inside a panel: the film folds sharply there, so its two sides share the places but not the normals.

The panel is split along each weld: the vertices get copies for the triangles to the right of the line, tied
to the originals in place (problem.py). Free ends of a weld stay one vertex.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from BalloonWorkbench.core.panels.assembly import Assembly
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.panels.surface import outward_triangles
from BalloonWorkbench.core.types import Floats, Ints


def split_along_welds(panel: Panel) -> tuple[Panel, Ints]:
    """The panel split along its welds, and for each of its vertices (N,) the one of the panel that it is.

    The copies follow the panel's own vertices; triangles keep their order. Without welds it stays as it is.
    """
    if not panel.welds:
        return panel, np.arange(len(panel.rest_positions), dtype=np.int32)
    origin = list(range(len(panel.rest_positions)))
    triangles = panel.triangles.copy()
    on_rim = set(np.concatenate(panel.loops).tolist())
    fans = _fans(panel)
    lines = []
    for line in panel.welds:
        right = line.tolist()
        for place, vertex in enumerate(line.tolist()):
            before = int(line[place - 1]) if place > 0 else None
            after = int(line[place + 1]) if place + 1 < len(line) else None
            if vertex not in on_rim and (before is None or after is None):
                continue  # a free end
            right[place] = len(origin)
            origin.append(vertex)
            for triangle in _right_of(fans[vertex], before, after):
                row = triangles[triangle]
                row[panel.triangles[triangle] == vertex] = right[place]
        lines += [line, np.array(right, dtype=np.int32)]
    own = np.array(origin, dtype=np.int32)
    return replace(
        panel, rest_positions=panel.rest_positions[own], triangles=triangles, welds=tuple(lines)
    ), own


def _right_of(fan: list[tuple[int, int, int]], before: int | None, after: int | None) -> list[int]:
    """Triangles of a fan to the right of a line through its middle."""
    if before is not None:  # counter-clockwise: what follows the way back, up to the way ahead
        return _swept(fan, before, after)
    left = set(_swept(fan, after, None))
    return [triangle for triangle, _, _ in fan if triangle not in left]


def _fans(panel: Panel) -> dict[int, list[tuple[int, int, int]]]:
    """For each vertex of a weld the triangles around it, with their next two corners counter-clockwise."""
    at_welds = np.isin(panel.triangles, np.concatenate([np.empty(0, dtype=np.int32), *panel.welds]))
    fans: dict[int, list[tuple[int, int, int]]] = {}
    for triangle, corner in np.argwhere(at_welds).tolist():
        vertex, following, last = np.roll(panel.triangles[triangle], -corner).tolist()
        fans.setdefault(vertex, []).append((triangle, following, last))
    return fans


def _swept(fan: list[tuple[int, int, int]], start: int | None, stop: int | None) -> list[int]:
    """Triangles of a fan met counter-clockwise from the edge to `start` up to that to `stop` or the rim."""
    ahead = {following: (triangle, last) for triangle, following, last in fan}
    swept: list[int] = []
    at = start
    while at is not None and at != stop and at in ahead and len(swept) < len(fan):
        triangle, at = ahead[at]
        swept.append(triangle)
    return swept


@dataclass(frozen=True)
class SplitFilm:
    """All panels of an assembly, split along their welds and laid side by side.

    assembly        whose it is
    panels          split
    rest_positions  (n, 2) m
    triangles       (m, 3), counter-clockwise seen from outside
    origin          (n,) the vertex of the assembly that each one is
    own             which of them those of the assembly are
    tied            (n,) the first of those whose place a vertex shares; None where each has one of its own
    strip           how many of them, the last ones, are of a strip outside the seams (weld_strip.py)
    """

    assembly: Assembly
    panels: tuple[Panel, ...]
    rest_positions: Floats
    triangles: Ints
    origin: Ints
    own: Ints
    tied: Ints | None
    strip: int = 0


def split_assembly(assembly: Assembly) -> SplitFilm:
    """The film of an assembly, which folds at its seams and welds."""
    surface = assembly.surface
    panels, origins = zip(*map(split_along_welds, assembly.panels))
    origin = np.concatenate([own + at for own, at in zip(origins, assembly.offsets)])
    starts = np.cumsum([0, *map(len, origins)])
    blocks = [np.arange(len(panel.rest_positions)) + at for panel, at in zip(assembly.panels, starts)]
    return SplitFilm(
        assembly,
        panels,
        surface.rest_positions[origin],
        outward_triangles([panel.triangles for panel in panels], surface.turned, starts),
        origin,
        np.concatenate(blocks),
        _tied(surface.first[origin]),
    )


def _tied(place: Ints) -> Ints | None:
    """For each vertex (n,) the first with the same place, by their numbers (n,)."""
    if np.array_equal(place, np.arange(len(place))):
        return None
    _, earliest, number = np.unique(place, return_index=True, return_inverse=True)
    return earliest[number.ravel()].astype(np.int32)

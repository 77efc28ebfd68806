# SPDX-License-Identifier: LGPL-2.1-or-later
"""Welds inside a panel: the film folds sharply there, so its two sides share the places but not the normals.

The panel is slit along each weld: the vertices get copies for the triangles to the right of the line, tied to
the originals in place (problem.py). Free ends of a weld stay one vertex.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.types import Ints


def slit(panel: Panel) -> tuple[Panel, Ints]:
    """The panel slit along its welds, and for each of its vertices (N,) the one of the panel that it is.

    The copies follow the panel's own vertices; triangles keep their order. Without welds it stays as it is.
    """
    count = len(panel.rest_positions)
    origin = list(range(count))
    triangles = panel.triangles.copy()
    on_rim = set(np.concatenate(panel.seams).tolist())
    fans = _fans(panel)
    lines = []
    for line in panel.welds:
        right = line.tolist()
        for place, vertex in enumerate(line.tolist()):
            before = int(line[place - 1]) if place > 0 else None
            after = int(line[place + 1]) if place + 1 < len(line) else None
            if vertex not in on_rim and (before is None or after is None):
                continue  # a free end
            fan = fans[vertex]
            # counter-clockwise: what follows the way back, up to the way ahead, lies to the right
            if before is not None:
                side = _swept(fan, before, after)
            else:
                left = set(_swept(fan, after, None))
                side = [triangle for triangle, _, _ in fan if triangle not in left]
            right[place] = len(origin)
            origin.append(vertex)
            for triangle in side:
                row = triangles[triangle]
                row[panel.triangles[triangle] == vertex] = right[place]
        lines += [line, np.array(right, dtype=np.int32)]
    own = np.array(origin, dtype=np.int32)
    return replace(
        panel, rest_positions=panel.rest_positions[own], triangles=triangles, welds=tuple(lines)
    ), own


def _fans(panel: Panel) -> dict[int, list[tuple[int, int, int]]]:
    """For each vertex of a weld the triangles around it, with their next two corners counter-clockwise."""
    wanted = np.isin(panel.triangles, np.concatenate([np.empty(0, dtype=np.int32), *panel.welds]))
    fans: dict[int, list[tuple[int, int, int]]] = {}
    for triangle, corner in np.argwhere(wanted).tolist():
        vertex, following, last = np.roll(panel.triangles[triangle], -corner).tolist()
        fans.setdefault(vertex, []).append((triangle, following, last))
    return fans


def _swept(fan: list[tuple[int, int, int]], start: int | None, stop: int | None) -> list[int]:
    """Triangles of a fan met counter-clockwise from the edge to `start` up to that to `stop` or the rim."""
    ahead = {following: (triangle, last) for triangle, following, last in fan}
    found: list[int] = []
    at = start
    while at is not None and at != stop and at in ahead and len(found) < len(fan):
        triangle, at = ahead[at]
        found.append(triangle)
    return found

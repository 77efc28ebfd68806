# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which vertices of a balloon's mesh lie along an edge of a flat piece."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from BalloonWorkbench.core.geometry.nearest import Indices, nearest_on_line
from BalloonWorkbench.core.geometry.polyline import arc_lengths, line_lengths
from BalloonWorkbench.core.types import Floats

_NEAR = 0.25  # of the distance of two vertices: one that is nearer to an edge is on it


def along_edge(line: Floats, loops: Sequence[Indices], rest: Floats) -> Indices:
    """The vertices along an edge of one of two equal panels.

    line   (k, 2) m, in the frame of the panel; loops, of its mesh, each as vertices once round
    rest   (n, 2) m, where the vertices lie flat
    An edge that is a whole loop gives all of it, the first vertex twice.
    """
    middles = 0.5 * (line[:-1] + line[1:])
    loop = min(loops, key=lambda each: _off(middles, rest[each]))
    if np.allclose(line[0], line[-1]):
        return np.append(loop, loop[:1])
    off = nearest_on_line(line, rest[loop])
    spacing = float(arc_lengths(rest[loop])[-1]) / len(loop)
    on = off.distance < _NEAR * spacing
    along = line_lengths(line)[off.edge] + off.share * np.diff(line_lengths(line))[off.edge]
    chosen = np.flatnonzero(on)
    return np.asarray(loop[chosen[np.argsort(along[chosen], kind="stable")]])


def _off(points: Floats, loop: Floats) -> float:
    closed = np.append(loop, loop[:1], axis=0)
    return float(nearest_on_line(closed, points).distance.mean())

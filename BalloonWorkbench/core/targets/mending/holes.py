# SPDX-License-Identifier: LGPL-2.1-or-later
"""Holes in the surface of a mesh, closed where that is safe."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.targets.half_edges import half_edges, twins
from BalloonWorkbench.core.types import Floats, Ints
from BalloonWorkbench.core.units import number_text

#: A hole is closed if it is so long round, in parts of the body's size, or if it is flat: if its points are
#: so near to a plane, in parts of the hole's size.
_LONGEST, _FLATTEST = 0.4, 0.02


class Filled(NamedTuple):
    """A surface without holes: points (n, 3), triangles (m, 3), and how many holes there were."""

    points: Floats
    triangles: Ints
    closed: int


def filled_holes(points: Floats, triangles: Ints) -> Filled:
    """Close the holes of a surface on which each point has one fan of triangles.

    Raises InputError for a large one that is not flat.
    """
    rims = _rims(triangles)
    size = float(np.linalg.norm(np.ptp(points, axis=0)))
    centres, parts = [points], [triangles]
    for number, rim in enumerate(rims):
        line = points[rim]
        around = float(np.linalg.norm(line - np.roll(line, 1, axis=0), axis=1).sum())
        middle = line.mean(axis=0)
        off = np.linalg.svd(line - middle, compute_uv=False)
        if around > _LONGEST * size and off[2] > _FLATTEST * off[0]:
            raise InputError(
                f"The mesh is not closed: a hole is {number_text(100.0 * around / size)} % of its size long"
                " round. Close it in the program that the mesh comes from."
            )
        centres.append(middle[None])
        apex = np.full(len(rim), len(points) + number)
        # the hole runs against the edges of the surface
        parts.append(np.column_stack([np.roll(rim, -1), rim, apex]).astype(np.int32))
    return Filled(np.concatenate(centres), np.concatenate(parts), len(rims))


def _rims(triangles: Ints) -> list[Ints]:
    """The points round each hole, in the direction of the surface's own edges."""
    edges = half_edges(triangles)[twins(triangles) < 0]
    following = dict(edges.tolist())
    rims = []
    while following:
        start = next(iter(following))
        rim = [start]
        while (end := following.pop(rim[-1], start)) != start:
            rim.append(end)
        rims.append(np.array(rim, dtype=np.int32))
    return rims

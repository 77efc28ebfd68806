# SPDX-License-Identifier: LGPL-2.1-or-later
"""The film of two equal panels in space, with the weld round it: closed, a sharp seam between both sides."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.geometry.normals import left_normals, vertex_normals
from BalloonWorkbench.core.solver.inflation import MIRROR, Inflation
from BalloonWorkbench.core.solver.split_along_welds import split_along_welds
from BalloonWorkbench.core.types import Floats, Ints


@dataclass(frozen=True)
class SideSurface:
    """A part of the surface of one side.

    positions  (n, 3) m
    triangles  (m, 3), counter-clockwise seen from outside
    normals    (n, 3) unit, outward
    front      it faces the viewer, along z
    weld       it is the flat band outside of a seam
    """

    positions: Floats
    triangles: Ints
    normals: Floats
    front: bool
    weld: bool


def two_panel_surfaces(inflation: Inflation, seal_width: float) -> list[SideSurface]:
    """Front, back and the welds on both of them, `seal_width` wide [m].

    Together they are closed: edges of the film are those of the bands, whose outer edges are the same places.
    At a weld inside, the film on its two sides has vertices of its own, and so normals.
    """
    panel, origin = split_along_welds(inflation.panel)
    top = inflation.positions[origin]
    up = vertex_normals(top, panel.triangles)
    under = panel.triangles[:, ::-1]
    if inflation.lower is None:
        bottom, down = top * MIRROR, up * MIRROR
    else:
        bottom = inflation.lower[origin]
        down = vertex_normals(bottom, under)
    parts = [
        SideSurface(top, panel.triangles, up, front=True, weld=False),
        SideSurface(bottom, under, down, front=False, weld=False),
    ]
    for seam in panel.loops:
        parts += [_weld(top[seam], seal_width, front=front) for front in (False, True)]
    return parts


def _weld(rim: Floats, width: float, *, front: bool) -> SideSurface:
    """The flat band outside a rim (k, 3) m, seen from the front or from the back."""
    outward = np.zeros_like(rim)
    outward[:, :2] = -left_normals(rim[:, :2], smoothed=2)
    points = np.concatenate([rim, rim + width * outward])
    inner = np.arange(len(rim))
    following = np.roll(inner, -1)
    outer, outer_following = inner + len(rim), following + len(rim)
    quads = np.concatenate(
        [
            np.stack([inner, outer, outer_following], axis=1),
            np.stack([inner, outer_following, following], axis=1),
        ]
    )
    normals = np.tile([0.0, 0.0, 1.0 if front else -1.0], (len(points), 1))
    triangles = quads if front else quads[:, ::-1]
    return SideSurface(points, triangles.astype(np.int32), normals, front=front, weld=True)

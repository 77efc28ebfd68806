# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether air reaches all of a balloon: its welds must not cut it in two."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.errors import OutlineError
from BalloonWorkbench.core.mesh.panel import Panel
from BalloonWorkbench.core.mesh.quality import signed_areas
from BalloonWorkbench.core.types import Ints
from BalloonWorkbench.core.units import to_mm


def check_connected(panel: Panel) -> None:
    """OutlineError with the place of the smallest part where the welds leave no way between parts."""
    chamber = chambers(panel)
    if chamber.max() == 0:
        return
    areas = signed_areas(panel.rest_positions, panel.triangles)
    sizes = np.bincount(chamber, areas)
    smallest = chamber == int(np.argmin(sizes))
    middle = panel.rest_positions[panel.triangles[smallest]].mean(axis=1)
    x, y = to_mm(areas[smallest] @ middle / areas[smallest].sum())
    raise OutlineError(
        f"The welds cut off the part at ({x:.1f}, {y:.1f}) mm: no air gets there. Leave a gap in them, or"
        " draw two shapes."
    )


def chambers(panel: Panel) -> Ints:
    """The number (m,) of the chamber that each triangle belongs to; the welds are walls."""
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components

    count, triangles = len(panel.rest_positions), panel.triangles.astype(np.int64)
    ends = np.sort(np.stack([np.roll(triangles, -1, axis=1), np.roll(triangles, -2, axis=1)], axis=2), axis=2)
    edges = (ends[:, :, 0] * count + ends[:, :, 1]).ravel()
    walls = [
        np.sort(np.stack([line[:-1], line[1:]], axis=1).astype(np.int64), axis=1) for line in panel.welds
    ]
    closed = np.concatenate([wall[:, 0] * count + wall[:, 1] for wall in walls])
    owner = np.repeat(np.arange(len(triangles)), 3)
    order = np.argsort(edges, kind="stable")
    twin = np.flatnonzero((edges[order][1:] == edges[order][:-1]) & ~np.isin(edges[order][1:], closed))
    one, two = owner[order[twin]], owner[order[twin + 1]]
    graph = coo_matrix((np.ones(len(one)), (one, two)), shape=(len(triangles), len(triangles)))
    return np.asarray(connected_components(graph, directed=False)[1], dtype=np.int32)

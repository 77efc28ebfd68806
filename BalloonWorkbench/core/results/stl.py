# SPDX-License-Identifier: LGPL-2.1-or-later
"""Inflated balloons as closed meshes, and as a binary STL file."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from BalloonWorkbench.core.mesh.quality import locked
from BalloonWorkbench.core.panels.surface import Surface
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.split_along_welds import split_along_welds
from BalloonWorkbench.core.types import Floats, Ints
from BalloonWorkbench.core.units import to_mm

_HEADER = b"Inflated film balloon, both panels, millimetres"
_FACET = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def balloon_mesh(inflation: Inflation) -> tuple[Floats, Ints]:
    """Positions (N, 3) [m] and triangles (M, 3) of both halves, joined at the seam, outward orientation.

    Every edge belongs to two triangles. At a weld inside, the balloons on its two sides have vertices of
    their own in the same places. Triangles with all vertices on the seam (at sharp tips) lie flat in both
    halves, enclose nothing and are left out. Other panels are joined at all their seams.
    """
    if not inflation.assembly.mirror:
        return _joined(inflation.positions, inflation.assembly.surface)
    panel, origin = split_along_welds(inflation.panel)
    upper = panel.triangles[~locked(panel)]
    sealed = panel.sealed
    count = len(origin)
    mirror = np.arange(count, 2 * count)
    mirror[sealed] = sealed
    top = inflation.positions[origin]
    if inflation.lower is not None:
        positions = np.concatenate([top, inflation.lower[origin]])
    else:
        positions = np.concatenate([top, top * np.array([1.0, 1.0, -1.0])])
        positions[sealed, 2] = 0.0
    triangles = np.concatenate([upper, mirror[upper][:, ::-1]])
    used, renumbered = np.unique(triangles, return_inverse=True)
    return positions[used], renumbered.reshape(-1, 3).astype(np.int32)


def _joined(positions: Floats, surface: Surface) -> tuple[Floats, Ints]:
    used, renumbered = np.unique(surface.by_seams[surface.triangles], return_inverse=True)
    return positions[used], renumbered.reshape(-1, 3).astype(np.int32)


def enclosed_volume(positions: Floats, triangles: Ints) -> float:
    """Volume inside a closed mesh, positive when it is oriented outward."""
    a, b, c = (positions[triangles[:, k]] for k in range(3))
    return float(np.einsum("ij,ij->", a, np.cross(b, c))) / 6.0


def stl_bytes(inflations: Sequence[Inflation]) -> bytes:
    """A binary STL file of closed balloons in millimetres."""
    corners = [positions[triangles] for positions, triangles in map(balloon_mesh, inflations)]
    facets = np.zeros(sum(map(len, corners)), dtype=_FACET)
    facets["corners"] = to_mm(np.concatenate(corners))
    a, b, c = (facets["corners"][:, k].astype(np.float64) for k in range(3))
    normal = np.cross(b - a, c - a)
    length = np.linalg.norm(normal, axis=1, keepdims=True)
    facets["normal"] = normal / np.where(length > 0.0, length, 1.0)
    return _HEADER.ljust(80) + np.uint32(len(facets)).astype("<u4").tobytes() + facets.tobytes()

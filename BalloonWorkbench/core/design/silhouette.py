# SPDX-License-Identifier: LGPL-2.1-or-later
"""The silhouette: what one sees of the balloon from above."""

from __future__ import annotations

from typing import Any

import numpy as np

from BalloonWorkbench.core.errors import SolverError
from BalloonWorkbench.core.geometry.areas import loop_of, parts
from BalloonWorkbench.core.geometry.crossings import winding
from BalloonWorkbench.core.geometry.polyline import signed_area
from BalloonWorkbench.core.geometry.vectors import cross
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.types import Floats, Ints


def silhouette(inflation: Inflation) -> Outline:
    """Outline of the balloon's shadow, with as many holes as the panel has [m].

    What lies in the shadow lies below film that faces up, so the shadow is where the rim of that film winds
    round at least once: a few hundred edges instead of all triangles. Mirrored halves cast the same shadow,
    so the upper one is enough; other panels cast one together. Slivers between folds of the rim are no holes.
    """
    package = shapely()
    shadow = package.union_all([_shadow(*film) for film in _films(inflation)])
    bodies = parts(shadow)
    if not bodies:
        raise SolverError("The film folds up and nothing of it is seen from above: make the shape thicker.")
    holes = sorted((loop_of(ring) for ring in bodies[0].interiors), key=signed_area, reverse=True)
    count = len(inflation.panel.loops) - 1
    return Outline(loop_of(bodies[0].exterior), tuple(hole[::-1] for hole in holes[:count]))


def _films(inflation: Inflation) -> list[tuple[Floats, Ints]]:
    """Positions (n, 3) and triangles (m, 3) of what casts a shadow: either half, or all panels, glued."""
    panel, assembly = inflation.panel, inflation.assembly
    if len(assembly.panels) > 1:
        return [(inflation.positions, assembly.surface.first[assembly.surface.triangles])]
    halves = [inflation.positions] if inflation.lower is None else [inflation.positions, inflation.lower]
    return [(half, panel.triangles) for half in halves]


def _shadow(positions: Floats, triangles: Ints) -> Any:
    """The shadow (a polygon of shapely) of film whose triangles, seen from above, mostly turn one way."""
    package = shapely()
    starts, ends = _rim_of_upward_film(positions[:, :2], triangles)
    lines = package.union_all(package.linestrings(np.stack([starts, ends], axis=1)))
    faces = package.get_parts(package.polygonize(package.get_parts(lines)))
    inside = package.get_coordinates(package.point_on_surface(faces))
    return package.union_all(faces[winding(starts, ends, inside) > 0])


def _rim_of_upward_film(flat: Floats, triangles: Ints) -> tuple[Floats, Floats]:
    """Directed edges (k, 2), (k, 2) with film that faces up on their left and none on their right."""
    a, b, c = (flat[triangles[:, k]] for k in range(3))
    up = triangles[cross(b - a, c - a) > 0.0].astype(np.int64)
    edges = np.concatenate([up[:, [0, 1]], up[:, [1, 2]], up[:, [2, 0]]])
    count = len(flat)
    forth, back = edges @ (count, 1), edges @ (1, count)
    rim = edges[~np.isin(forth, back)]
    return flat[rim[:, 0]], flat[rim[:, 1]]

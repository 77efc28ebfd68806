# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where each place of the flat film is seen when the balloon is inflated.

Inside the seam the simulation tells it: a point of a triangle of the flat panel is the same point of the
inflated triangle, seen along z. Outside, the film is a flat fin round the balloon: the nearest point of the
seam, and from there as far outward as on the flat film.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.errors import MissingPackageError
from BalloonWorkbench.core.geometry.nearest import kd_tree
from BalloonWorkbench.core.geometry.normals import left_normals
from BalloonWorkbench.core.geometry.polyline import arc_lengths, point_at
from BalloonWorkbench.core.geometry.raster import covered
from BalloonWorkbench.core.geometry.triangulation import signed_areas
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.types import Bools, Floats, Ints
from BalloonWorkbench.core.units import from_mm

#: Grid on which the map is computed; between its points it is straight to a thousandth of that [m].
GRID = from_mm(0.5)
#: Points along the seam from which the fin is measured [m].
_ALONG = from_mm(0.25)
_BLOCK = 4_000_000  # distances looked at in one go


@dataclass(frozen=True)
class VisibleFilm:
    """The film of one side of a balloon, flat and as it is seen.

    flat       (n, 2) m, vertices of the panel
    seen       (n, 2) m, the same vertices of the inflated balloon in the drawing's plane
    triangles  (m, 3)
    loops      vertex indices of each boundary loop, film on the left
    """

    flat: Floats
    seen: Floats
    triangles: Ints
    loops: tuple[Ints, ...]


def front(inflation: Inflation) -> VisibleFilm:
    """The panel that faces the viewer."""
    panel = inflation.panel
    return VisibleFilm(panel.rest_positions, inflation.positions[:, :2], panel.triangles, panel.loops)


def back(inflation: Inflation) -> VisibleFilm:
    """The panel behind, seen through the front one: both are cut from one pattern."""
    panel = inflation.panel
    lower = inflation.positions if inflation.lower is None else inflation.lower
    return VisibleFilm(panel.rest_positions, lower[:, :2], panel.triangles, panel.loops)


def seen_from(film: VisibleFilm, x: Floats, y: Floats, needed: Bools) -> Floats:
    """Where the places of a grid of the flat film are seen: (len(y), len(x), 2) m in the drawing's plane.

    x, y    even columns and rows of the grid in the flat film [m]
    needed  (len(y), len(x)) the places that matter outside the seam; the others there are NaN
    """
    places = np.full((len(y), len(x), 2), np.nan)
    triangles = film.triangles[signed_areas(film.flat, film.triangles) > 0.0]
    for number, rows, columns, shares in covered(film.flat, triangles, x, y):
        places[rows, columns] = (shares[..., None] * film.seen[triangles[number]]).sum(axis=1)
    _add_fin(film, x, y, needed, places)
    return places


def _add_fin(film: VisibleFilm, x: Floats, y: Floats, needed: Bools, places: Floats) -> None:
    """Fill in what is wanted outside the seam."""
    at, image, outward = (np.concatenate(parts) for parts in zip(*_along_loops(film)))
    rows, columns = np.nonzero(needed & np.isnan(places[..., 0]))
    if len(rows):
        nearest, away = _nearest(np.stack([x[columns], y[rows]], axis=1), at)
        places[rows, columns] = image[nearest] + away[:, None] * outward[nearest]


def _along_loops(film: VisibleFilm) -> Iterator[tuple[Floats, Floats, Floats]]:
    """Points along each seam: flat, as seen, and the direction outward as seen."""
    for seam in film.loops:
        flat, seen = film.flat[seam], film.seen[seam]
        outward = -left_normals(seen, smoothed=2)  # a crumpled rim has no direction of its own at each vertex
        along = arc_lengths(flat)
        places = np.linspace(0.0, along[-1], max(8, int(np.ceil(along[-1] / _ALONG))), endpoint=False)
        yield (
            point_at(flat, along, places),
            point_at(seen, along, places),
            point_at(outward, along, places),
        )


def _nearest(points: Floats, at: Floats) -> tuple[Ints, Floats]:
    """For each of points (n, 2) the nearest of `at` (k, 2), and how far it is."""
    try:
        away, nearest = kd_tree(at).query(points)
    except MissingPackageError:
        indices, away = np.zeros(len(points), dtype=np.int32), np.zeros(len(points))
        block = max(1, _BLOCK // len(at))
        for start in range(0, len(points), block):
            part = slice(start, start + block)
            square = ((points[part, None] - at) ** 2).sum(axis=2)
            indices[part] = square.argmin(axis=1)
            away[part] = np.sqrt(square.min(axis=1))
        return indices, away
    return nearest.astype(np.int32), away

# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far regions of a surface are from developable: from a cylinder or a cone, by their normals.

The normals of a developable strip lie on a circle of the unit sphere: a great one for a cylinder, a smaller
one for a cone (Julius, Kraevoy, Sheffer, D-Charts, 2005).
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from BalloonWorkbench.core.geometry.vectors import unit
from BalloonWorkbench.core.types import Floats, Ints

#: What a normal away from the mean one costs beside what one away from the circle costs: it keeps regions
#: compact. A ball in strips by these costs has strips some five times as long as wide.
_COMPACT = 0.04
#: The same beside how far normals are off the circle, where regions are judged.
_BENT = 0.002
#: Length of the mean of normals round a circle that do not go all round it, in radii.
_ARC = 0.5
#: Mean distance of an arc from the line nearest to it, beside how much its direction and its places spread.
_BULGE = 0.385
#: Square of the sine of a circle's angle below which it is a point: the normals of a plane.
_FLAT = 1e-8
_EMPTY = 1e-300  # area of a region without triangles
#: What the width of a region counts where directions are equal, and what counts as equal.
_BY_WIDTH, _EQUAL = 1e-5, 1e-7


class Faces(NamedTuple):
    """Triangles as the regions see them.

    normals  (m, 3) of length 1; areas (m,) with the sum 1; centres (m, 3) in parts of the body's size
    """

    normals: Floats
    areas: Floats
    centres: Floats


class Moments(NamedTuple):
    """Sums over each of p regions, weighted with the areas.

    areas             (p,)
    normals, centres  (p, 3); turns, spreads: the products of their coordinates (p, 3, 3)
    """

    areas: Floats
    normals: Floats
    turns: Floats
    centres: Floats
    spreads: Floats

    def of(self, chosen: Ints) -> Moments:
        """Of groups of regions: chosen (k, j), each j together."""
        return Moments(*(each[chosen].sum(axis=1) for each in self))


class Proxies(NamedTuple):
    """The circle of each of p regions.

    axes   (p, 3) of length 1; cosines (p,) of the circle's angle to them
    means  (p, 3) directions of the mean normals
    off    (p,) by how much the normals are off the circle [rad]
    """

    axes: Floats
    cosines: Floats
    means: Floats
    off: Floats


def moments(faces: Faces, labels: Ints, count: int) -> Moments:
    """Of the regions of triangles; labels (m,) 0 to count - 1."""
    sums: list[Any] = [np.bincount(labels, faces.areas, count)]
    for vectors in (faces.normals, faces.centres):
        outer = np.einsum("ij,ik->ijk", vectors, vectors).reshape(-1, 9)
        values = np.column_stack([vectors, outer]) * faces.areas[:, None]
        total = np.stack([np.bincount(labels, column, count) for column in values.T], axis=1)
        sums += [total[:, :3], total[:, 3:].reshape(-1, 3, 3)]
    return Moments(*sums)


def fit_proxies(regions: Moments) -> Proxies:
    """The best circle for the normals of each region."""
    areas = np.maximum(regions.areas, _EMPTY)
    mean = regions.normals / areas[:, None]
    second = regions.turns / areas[:, None, None]
    straight, cylinders = _least(regions, second)
    conical, cones = _least(regions, second - np.einsum("ij,ik->ijk", mean, mean))
    cosines = np.clip(np.einsum("ij,ij->i", cones, mean), -1.0, 1.0)
    # the angle to a small circle is the distance along its axis over the sine of its angle
    sines = 1.0 - cosines**2
    conical = conical / np.maximum(sines, _FLAT)
    # a cone whose point is inside the region cannot be laid flat: its normals go all round the axis
    around = np.einsum("ij,ij->i", mean, mean) - cosines**2 < _ARC**2 * sines
    better = (conical < straight - _EQUAL) & ~around & (sines > _FLAT)
    axes = np.where(better[:, None], cones, cylinders)
    # of panels that film can follow equally well those that bend less
    bent = _BENT * (2.0 - 2.0 * np.linalg.norm(mean, axis=1))
    off = np.sqrt(np.maximum(np.where(better, conical, straight) + bent, 0.0))
    return Proxies(axes, np.where(better, cosines, 0.0), unit(mean), off)


def _least(regions: Moments, matrices: Floats) -> tuple[Floats, Floats]:
    """The least value (p,) of x M x of each matrix (p, 3, 3), and the direction (p, 3) of it.

    Of directions that are equal, as on a plane, the one across which the region is narrow, and then one by
    its coordinates: the last bits decide nothing.
    """
    decided = matrices + _BY_WIDTH * spreads(regions) + _EQUAL * np.diag([0.0, 1.0, 2.0])
    directions = np.linalg.eigh(decided)[1][:, :, 0]
    return np.einsum("pi,pij,pj->p", directions, matrices, directions), directions


def spreads(regions: Moments) -> Floats:
    """How far the places of each region spread, (p, 3, 3)."""
    areas = np.maximum(regions.areas, _EMPTY)
    middle = regions.centres / areas[:, None]
    return np.asarray(regions.spreads / areas[:, None, None] - np.einsum("ij,ik->ijk", middle, middle))


def costs(faces: Faces, proxies: Proxies) -> Floats:
    """What each triangle costs in each region, (m, p)."""
    along = faces.normals @ proxies.axes.T - proxies.cosines
    circle = along**2 / np.maximum(1.0 - proxies.cosines**2, 1e-12)
    spread = 2.0 - 2.0 * faces.normals @ proxies.means.T
    return np.asarray(circle + _COMPACT * spread)


def distances(regions: Moments, proxies: Proxies) -> Floats:
    """How far film over each region stays away from it, times its area (p,), in parts of the body's size.

    A strip that is bent across by some angle is so far from a straight one as that angle times its width.
    """
    # along a line of the cone, which leans against its axis
    width = np.einsum("pi,pij,pj->p", proxies.axes, spreads(regions), proxies.axes) / (
        1.0 - proxies.cosines**2
    )
    return np.asarray(_BULGE * regions.areas * proxies.off * np.sqrt(np.maximum(width, 0.0)))

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The places of an even grid that triangles cover, and where each lies in its triangle."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.geometry.triangulation import signed_areas
from BalloonWorkbench.core.types import Floats, Ints

#: A hair wider than the triangles, so that nothing shows between neighbours.
_HAIR = 1e-9


class Cover(NamedTuple):
    """What a triangle covers of a grid: its number, rows (k,) and columns (k,) of the places that it covers,
    and their area coordinates (k, 3) in it."""

    number: int
    rows: NDArray[np.intp]
    columns: NDArray[np.intp]
    shares: Floats


def covered(points: Floats, triangles: Ints, x: Floats, y: Floats) -> Iterator[Cover]:
    """Triangles (m, 3) of points (n, 2), one after the other, over the grid of even columns x and rows y.

    Those without an area, and those beside the grid, are left out.
    """
    corners, areas = points[triangles], 2.0 * signed_areas(points, triangles)
    first, step = np.array([x[0], y[0]]), np.array([x[1] - x[0], y[1] - y[0]])
    low = np.ceil((corners.min(axis=1) - first) / step - 1e-6).astype(int).clip(0)
    high = np.floor((corners.max(axis=1) - first) / step + 1e-6).astype(int) + 1
    high = np.minimum(high, (len(x), len(y)))
    for number in np.flatnonzero((areas != 0.0) & (high > low).all(axis=1)).tolist():
        (left, bottom), (right, top), (a, b, c) = low[number], high[number], corners[number]
        (u0, u1), (v0, v1) = b - a, c - a
        across, along = x[left:right] - a[0], y[bottom:top, None] - a[1]
        second = (across * v1 - along * v0) / areas[number]
        third = (along * u0 - across * u1) / areas[number]
        inside = (second >= -_HAIR) & (third >= -_HAIR) & (second + third <= 1.0 + _HAIR)
        rows, columns = np.nonzero(inside)
        shares = np.empty((len(rows), 3))
        shares[:, 1], shares[:, 2] = second[rows, columns], third[rows, columns]
        shares[:, 0] = 1.0 - shares[:, 1] - shares[:, 2]
        yield Cover(number, rows + bottom, columns + left, shares)

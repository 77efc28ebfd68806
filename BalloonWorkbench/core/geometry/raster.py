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
_CHUNK = 300_000  # places looked at together


class Cover(NamedTuple):
    """What triangles cover of a grid: k times the number of a triangle (k,), row (k,) and column (k,) of a
    place that it covers, and the place's area coordinates (k, 3) in it."""

    number: NDArray[np.intp]
    rows: NDArray[np.intp]
    columns: NDArray[np.intp]
    shares: Floats


def covered(points: Floats, triangles: Ints, x: Floats, y: Floats) -> Iterator[Cover]:
    """Triangles (m, 3) of points (n, 2), some after the other, over the grid of even columns x and rows y.

    Those without an area, and those beside the grid, are left out.
    """
    corners, areas = points[triangles], 2.0 * signed_areas(points, triangles)
    first, step = np.array([x[0], y[0]]), np.array([x[1] - x[0], y[1] - y[0]])
    low = np.ceil((corners.min(axis=1) - first) / step - 1e-6).astype(int).clip(0)
    high = np.floor((corners.max(axis=1) - first) / step + 1e-6).astype(int) + 1
    high = np.minimum(high, (len(x), len(y)))
    inside = np.flatnonzero((areas != 0.0) & (high > low).all(axis=1))
    places = np.cumsum((high - low)[inside].prod(axis=1))
    for some in np.split(inside, np.flatnonzero(np.diff(places // _CHUNK)) + 1):
        if len(some):
            yield _covered_by(some, low[some], high[some] - low[some], corners[some], areas[some], (x, y))


def _covered_by(
    numbers: NDArray[np.intp],
    low: NDArray[np.intp],
    size: NDArray[np.intp],
    corners: Floats,
    areas: Floats,
    grid: tuple[Floats, Floats],
) -> Cover:
    """What some triangles cover, each looked for in its box of the grid."""
    count = size.prod(axis=1)
    which = np.repeat(np.arange(len(numbers)), count)
    row, column = np.divmod(np.arange(len(which)) - (np.cumsum(count) - count)[which], size[which, 0])
    columns, rows = column + low[which, 0], row + low[which, 1]
    a = corners[:, 0]
    (u0, u1), (v0, v1) = (corners[:, 1] - a).T / areas, (corners[:, 2] - a).T / areas
    across, along = grid[0][columns] - a[which, 0], grid[1][rows] - a[which, 1]
    second = across * v1[which] - along * v0[which]
    third = along * u0[which] - across * u1[which]
    held = np.flatnonzero((second >= -_HAIR) & (third >= -_HAIR) & (second + third <= 1.0 + _HAIR))
    second, third = second[held], third[held]
    shares = np.column_stack([1.0 - second - third, second, third])
    return Cover(numbers[which[held]], rows[held], columns[held], shares)


class NearestCover(NamedTuple):
    """Of each covered place (k,) of a grid: row, column, the triangle's number, area coordinates (k, 3)."""

    rows: NDArray[np.intp]
    columns: NDArray[np.intp]
    number: NDArray[np.intp]
    shares: Floats


def mixed(shares: Floats, values: Floats, corners: Ints) -> Floats:
    """Values (n,) of points at places (k,) with area coordinates (k, 3) in triangles of corners (k, 3)."""
    return np.asarray(sum(shares[:, side] * values[corners[:, side]] for side in range(3)))


def nearest_covers(points: Floats, height: Floats, triangles: Ints, x: Floats, y: Floats) -> NearestCover:
    """Of the triangles (m, 3) over each place of a grid the highest one; height (n,) of the points."""
    highest = np.full(len(x) * len(y), -np.inf)
    number, shares = np.zeros(len(highest), dtype=np.intp), np.zeros((len(highest), 3))
    for cover in covered(points, triangles, x, y):
        place = cover.rows * len(x) + cover.columns
        above = mixed(cover.shares, height, triangles[cover.number])
        order = np.argsort(above, kind="stable")  # of places that are there twice the last one counts
        order = order[above[order] > highest[place[order]]]
        number[place[order]], shares[place[order]] = cover.number[order], cover.shares[order]
        highest[place[order]] = above[order]
    seen = np.flatnonzero(highest > -np.inf)
    return NearestCover(*np.divmod(seen, len(x)), number[seen], shares[seen])

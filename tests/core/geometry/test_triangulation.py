# SPDX-License-Identifier: LGPL-2.1-or-later
"""Values in triangulations and on grids: linear fields come back exactly, whichever way is taken."""

import numpy as np
import pytest
import shapely
from scipy.spatial import Delaunay

from BalloonWorkbench.core.geometry.raster import covered
from BalloonWorkbench.core.geometry.triangulation import (
    Located,
    corner_angles,
    interpolated,
    side_lengths,
    signed_areas,
)

RANDOM = np.random.default_rng(2)
CORNERS = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
POINTS = np.concatenate([CORNERS, RANDOM.uniform(0.0, 1.0, (60, 2))])
TRIANGLES = Delaunay(POINTS).simplices.astype(np.int32)
PLACES = RANDOM.uniform(0.0, 1.0, (400, 2))


def field(points):
    """Linear in the plane, in three dimensions."""
    return points @ np.array([[1.0, -2.0, 0.5], [3.0, 0.1, -1.0]]) + (1.0, 2.0, 3.0)


def test_areas_sides_and_angles() -> None:
    areas = signed_areas(POINTS, TRIANGLES)
    assert np.abs(areas).sum() == pytest.approx(1.0)
    assert signed_areas(POINTS, TRIANGLES[:, ::-1]) == pytest.approx(-areas)
    assert np.abs(areas) == pytest.approx(shapely.area(shapely.polygons(POINTS[TRIANGLES])))
    a, b, c = side_lengths(POINTS, TRIANGLES).T
    half = 0.5 * (a + b + c)
    assert np.sqrt(half * (half - a) * (half - b) * (half - c)) == pytest.approx(np.abs(areas), rel=1e-6)
    assert corner_angles(POINTS, TRIANGLES).sum(axis=1) == pytest.approx(np.pi)


def test_linear_fields_come_back_exactly() -> None:
    for found in (
        Located(POINTS, TRIANGLES).values(field(POINTS), PLACES),
        interpolated(POINTS, field(POINTS), PLACES),
    ):
        assert found == pytest.approx(field(PLACES), abs=1e-12)


def test_outside_the_value_is_that_of_the_edge_or_of_the_nearest_point() -> None:
    beyond = np.array([[0.5, 1.4], [-0.2, -0.3], [1.3, 0.5]])
    at_edge = Located(CORNERS, np.array([[0, 1, 2], [0, 2, 3]], dtype=np.int32)).values(
        field(CORNERS), beyond
    )
    low, high = field(CORNERS).min(axis=0), field(CORNERS).max(axis=0)
    assert ((at_edge >= low - 1e-12) & (at_edge <= high + 1e-12)).all()
    nearest = np.argmin(np.linalg.norm(beyond[:, None] - POINTS, axis=2), axis=1)
    assert np.array_equal(interpolated(POINTS, field(POINTS), beyond), field(POINTS)[nearest])


@pytest.mark.parametrize("turned_over", [False, True])
def test_triangles_cover_each_place_of_a_grid_once(turned_over: bool) -> None:
    triangles = TRIANGLES[:, ::-1] if turned_over else TRIANGLES
    x, y = np.linspace(-0.2, 1.3, 41), np.linspace(-0.4, 1.1, 37)
    times, values = np.zeros((len(y), len(x)), dtype=int), np.full((len(y), len(x), 3), np.nan)
    for number, rows, columns, shares in covered(POINTS, triangles, x, y):
        times[rows, columns] += 1
        values[rows, columns] = (shares[..., None] * field(POINTS)[triangles[number]]).sum(axis=1)
    places = np.stack(np.meshgrid(x, y), axis=-1)
    inside = ((places > 0.0) & (places < 1.0)).all(axis=2)
    assert (times[inside] == 1).all()
    assert not times[((places < -1e-9) | (places > 1.0 + 1e-9)).any(axis=2)].any()
    assert values[inside] == pytest.approx(field(places[inside]), abs=1e-12)


@pytest.mark.parametrize(("columns", "rows"), [(9, 4), (3, 8)])
def test_triangles_that_reach_past_the_grid_cover_what_is_in_it(columns: int, rows: int) -> None:
    x, y = np.linspace(0.31, 0.42, columns), np.linspace(0.53, 0.61, rows)
    times = np.zeros((rows, columns), dtype=int)
    for _, row, column, _ in covered(POINTS, TRIANGLES, x, y):
        times[row, column] += 1
    assert (times == 1).all()


def test_triangles_without_an_area_or_beside_the_grid_cover_nothing() -> None:
    flat = np.array([[0.0, 0.0], [1.0, 1.0], [2.0, 2.0], [50.0, 50.0], [51.0, 50.0], [50.0, 51.0]])
    grid = np.arange(4.0)
    assert not list(covered(flat, np.array([[0, 1, 2], [3, 4, 5]], dtype=np.int32), grid, grid))

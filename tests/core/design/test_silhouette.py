# SPDX-License-Identifier: LGPL-2.1-or-later
"""The silhouette is the shadow of all triangles."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from drawn_shapes import NAMED

from BalloonWorkbench.core.design.silhouette import silhouette
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.solver.inflate import inflate


@pytest.mark.parametrize("name", ["star", "ring", "holes", "S"])
def test_silhouette_is_the_union_of_all_projected_triangles(name: str) -> None:
    inflation = inflate(triangulate(NAMED[name], 0.012), film("mylar"), 2000.0)
    shown = silhouette(inflation)
    assert len(shown.holes) == len(NAMED[name].holes)
    mine = shapely.Polygon(shown.outer, list(shown.holes))
    every = shapely.union_all(shapely.polygons(inflation.positions[inflation.panel.triangles][:, :, :2]))
    # slivers between folds of the rim are no holes of the silhouette
    assert mine.symmetric_difference(every).area < 1e-6 * every.area
    assert np.isclose(mine.area, every.area, rtol=1e-6)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first shape in space: the same with and without SciPy, closed and outside out."""

from pathlib import Path

import bodies
import numpy as np
import pytest
from absent import without

from BalloonWorkbench.core.panels.assembly import Assembly
from BalloonWorkbench.core.solver.element.kinematics import facet_volume
from BalloonWorkbench.core.solver.embedding import embedding


@pytest.mark.parametrize(
    "body",
    [bodies.box(1.0, 1.0, 1.0, 4), bodies.gored_sphere(6, 8, 2), bodies.thick_ring(0.7, 1.0, 0.3, 2, 24)],
    ids=["cube", "gores", "ring"],
)
def test_the_same_bits_without_scipy(body: Assembly, tmp_path: Path) -> None:
    surface = body.surface
    _, glued = np.unique(surface.first, return_inverse=True)
    given = surface.rest_positions[surface.triangles], glued.ravel()[surface.triangles].astype(np.int32)
    places = embedding(*given)
    with without("scipy", folder=tmp_path):
        assert np.array_equal(embedding(*given), places)
    assert facet_volume(places, given[1]) > 0.0

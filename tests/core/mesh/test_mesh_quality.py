# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures of triangles whose values are known."""

from __future__ import annotations

import numpy as np
import pytest

from BalloonWorkbench.core.geometry.triangulation import signed_areas
from BalloonWorkbench.core.mesh.quality import (
    delaunay_loss,
    flipped,
    interior_edges,
    locked,
    min_angles,
    worn,
)
from BalloonWorkbench.core.panels.panel import Panel


def one_triangle(*points: tuple[float, float]) -> Panel:
    return Panel(np.array(points), np.array([[0, 1, 2]], dtype=np.int32), (np.arange(3, dtype=np.int32),))


def test_right_triangle() -> None:
    panel = one_triangle((0.0, 0.0), (3.0, 0.0), (0.0, 4.0))
    assert min_angles(panel)[0] == pytest.approx(np.arctan2(3.0, 4.0), abs=1e-14)
    assert signed_areas(panel.rest_positions, panel.triangles)[0] == 6.0
    assert not flipped(panel)[0]
    assert locked(panel)[0]


def test_turned_over_and_degenerate() -> None:
    assert flipped(one_triangle((0.0, 0.0), (0.0, 1.0), (1.0, 0.0)))[0]
    flat = one_triangle((0.0, 0.0), (1.0, 0.0), (2.0, 0.0))
    assert flipped(flat)[0]
    assert worn(flat)[0]
    assert min_angles(flat)[0] == 0.0


@pytest.mark.parametrize(("height", "is_worn"), [(0.144, False), (0.143, True)])
def test_reuse_rule_is_fifteen_inscribed_radii(height: float, is_worn: bool) -> None:
    """Isosceles, base 1: R = h / (1 + sqrt(1 + 4 h^2)), L = 1, so 15 R = 1 at h = 0.1433."""
    assert 15.0 * 0.1433 / (1.0 + np.sqrt(1.0 + 4.0 * 0.1433**2)) < 1.06
    h = 2.0 * 15.0 / (15.0**2 - 4.0)  # from 15 h = 1 + sqrt(1 + 4 h^2)
    scale = h / 0.1435
    assert worn(one_triangle((0.0, 0.0), (1.0, 0.0), (0.5, height * scale)))[0] == is_worn


def test_edges_and_delaunay_loss() -> None:
    kite = np.array([[0.0, 0.0], [2.0, 0.0], [1.0, 0.3], [1.0, -0.3]])
    seam = (np.array([0, 3, 1, 2], dtype=np.int32),)
    across = Panel(kite, np.array([[0, 3, 1], [0, 1, 2]], dtype=np.int32), seam)
    along = Panel(kite, np.array([[0, 3, 2], [3, 1, 2]], dtype=np.int32), seam)
    edges, opposite = interior_edges(across.triangles)
    assert edges.tolist() == [[0, 1]]
    assert sorted(opposite[0].tolist()) == [2, 3]
    assert delaunay_loss(across) == 1.0
    assert delaunay_loss(along) == 0.0

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Boundary edges that a plain Delaunay triangulation lacks."""

from __future__ import annotations

import numpy as np
import pytest

from BalloonWorkbench.core.errors import MeshError
from BalloonWorkbench.core.geometry.polyline import signed_area
from BalloonWorkbench.core.geometry.triangulation import signed_areas
from BalloonWorkbench.core.mesh import delaunay
from BalloonWorkbench.core.mesh.delaunay import triangulate_points


@pytest.fixture(autouse=True)
def by_scipy(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(delaunay, "pythoncdt", None)


def comb(teeth: int) -> np.ndarray:
    """Long thin teeth with few points: most long sides are not Delaunay."""
    x = np.arange(teeth, dtype=float)
    up = np.stack(
        [np.repeat(x, 4) + np.tile([0.0, 0.02, 0.98, 1.0], teeth), np.tile([0.0, 9.0, 9.1, 0.0], teeth)],
        axis=1,
    )
    return np.concatenate([up[:, :] * [1.0, 1.0], [[teeth, -0.5], [0.0, -0.5]]])[::-1]


@pytest.mark.parametrize("teeth", [1, 3, 12])
def test_long_edges_between_close_points(teeth: int) -> None:
    rim = comb(teeth)
    # remove the points that neighbouring teeth share
    keep = np.linalg.norm(rim - np.roll(rim, 1, axis=0), axis=1) > 1e-9
    rim = rim[keep]
    rim = rim if signed_area(rim) > 0.0 else rim[::-1]
    random = np.random.default_rng(teeth)
    inner = np.stack([np.arange(teeth) + 0.5, random.uniform(1.0, 8.0, teeth)], axis=1)
    points = np.concatenate([rim, inner])
    loop = np.arange(len(rim))
    segments = np.stack([loop, np.roll(loop, -1)], axis=1)
    triangles = triangulate_points(points, (loop,))
    assert signed_areas(points, triangles).min() > 0.0
    assert signed_areas(points, triangles).sum() == pytest.approx(signed_area(rim), rel=1e-12)
    directed = {(int(t[k - 1]), int(t[k])) for t in triangles for k in range(3)}
    assert all((int(a), int(b)) in directed for a, b in segments)


def test_crossing_segments_are_refused() -> None:
    points = np.array([[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.1]])
    with pytest.raises(MeshError):
        triangulate_points(points, (np.arange(4),))


def test_coinciding_points_are_refused() -> None:
    points = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [1.0, 1.0]])
    with pytest.raises(MeshError):
        triangulate_points(points, (np.arange(4),))

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The closed balloon: a 2-manifold that holds the volume, and its STL file."""

from __future__ import annotations

import numpy as np
import pytest
from drawn_shapes import NAMED, generated
from inflated import lifted

from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.panels.assembly import Assembly
from BalloonWorkbench.core.results.stl import balloon_mesh, enclosed_volume, stl_bytes
from BalloonWorkbench.core.solver.inflation import Inflation

SHAPES = {**NAMED, **{f"generated {seed}": generated(seed) for seed in range(20)}}


@pytest.fixture(scope="module", params=SHAPES)
def inflation(request: pytest.FixtureRequest) -> Inflation:
    outline = SHAPES[request.param]
    return lifted(triangulate(outline, size_for(outline, 500)))


def test_closed_and_outward(inflation: Inflation) -> None:
    positions, triangles = balloon_mesh(inflation)
    assert triangles.dtype == np.int32
    starts, ends = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
    forth = np.sort(starts.astype(np.int64) * len(positions) + ends)
    back = np.sort(ends.astype(np.int64) * len(positions) + starts)
    assert (np.diff(forth) > 0).all()  # each direction of an edge once
    np.testing.assert_array_equal(forth, back)  # and its opposite too
    np.testing.assert_array_equal(np.unique(triangles), np.arange(len(positions)))
    # Two panels glued along loops: Euler characteristic 2 (1 - holes).
    euler = len(positions) - len(forth) // 2 + len(triangles)
    assert euler == 2 * (2 - len(inflation.panel.loops))
    assert inflation.volume > 0.0
    assert enclosed_volume(positions, triangles) == pytest.approx(inflation.volume, rel=1e-9)


def test_mirror_image() -> None:
    positions, _ = balloon_mesh(lifted(triangulate(NAMED["disc"], 0.02)))
    upper, lower = positions[positions[:, 2] > 0.0], positions[positions[:, 2] < 0.0]
    np.testing.assert_array_equal(upper, lower * [1.0, 1.0, -1.0])


def test_cone_by_hand() -> None:
    """Disc lifted to a cone: two cones on a polygon of n sides."""
    panel = triangulate(NAMED["disc"], 0.005)
    away = 0.15 - np.linalg.norm(panel.rest_positions, axis=1)
    away[panel.loops[0]] = 0.0
    flat = lifted(panel)
    cone = Inflation(Assembly.mirrored(panel), np.column_stack([panel.rest_positions, away]), *(
        getattr(flat, name) for name in ("directors", "tensions", "volume", "report")
    ))  # fmt: skip
    assert enclosed_volume(*balloon_mesh(cone)) == pytest.approx(2.0 * np.pi * 0.15**3 / 3.0, rel=2e-3)


def test_binary_file(inflation: Inflation) -> None:
    positions, triangles = balloon_mesh(inflation)
    content = stl_bytes([inflation])
    assert not content.startswith(b"solid")  # would be taken for a text file
    assert int.from_bytes(content[80:84], "little") == len(triangles)
    assert len(content) == 84 + 50 * len(triangles)
    facets = np.frombuffer(
        content[84:], dtype=[("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")]
    )
    np.testing.assert_allclose(facets["corners"], positions[triangles] * 1000.0, atol=2e-5)
    a, b, c = (facets["corners"][:, k].astype(float) for k in range(3))
    cross = np.cross(b - a, c - a)
    assert (np.einsum("ij,ij->i", cross, facets["normal"]) >= 0.0).all()
    lengths = np.linalg.norm(facets["normal"], axis=1)
    assert np.abs(lengths - 1.0).max() < 1e-5
    # Still closed after rounding to single precision: equal corners have equal bits.
    corners, index = np.unique(facets["corners"].reshape(-1, 3), axis=0, return_inverse=True)
    assert len(corners) == len(positions)
    assert enclosed_volume(corners.astype(float) / 1000.0, index.reshape(-1, 3)) == pytest.approx(
        inflation.volume, rel=1e-4
    )
    assert stl_bytes([inflation]) == content

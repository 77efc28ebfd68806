# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moving the rim of a mesh."""

from __future__ import annotations

import numpy as np
import pytest
from drawn_shapes import NAMED

from BalloonWorkbench.core.geometry.triangulation import signed_areas
from BalloonWorkbench.core.mesh.quality import min_angles
from BalloonWorkbench.core.mesh.reuse import move_rim
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.panels.panel import Panel


def rim_of(panel: Panel) -> list[np.ndarray]:
    return [panel.rest_positions[seam] for seam in panel.loops]


@pytest.mark.parametrize("name", ["disc", "ring", "heart"])
def test_an_affine_map_of_the_rim_is_followed_exactly(name: str) -> None:
    panel = triangulate(NAMED[name], 0.01)
    matrix, shift = np.array([[1.2, 0.1], [-0.05, 1.3]]), np.array([0.4, -0.2])
    moved = move_rim(panel, [seam @ matrix.T + shift for seam in rim_of(panel)])
    assert moved is not None
    np.testing.assert_allclose(moved.rest_positions, panel.rest_positions @ matrix.T + shift, atol=1e-13)
    assert moved.triangles is panel.triangles


def test_a_small_wave_of_the_rim() -> None:
    panel = triangulate(NAMED["ring"], 0.01)
    rim = [seam * (1.0 + 0.03 * np.cos(5.0 * np.arctan2(*seam.T)))[:, None] for seam in rim_of(panel)]
    moved = move_rim(panel, rim)
    assert moved is not None
    for seam, wanted in zip(moved.loops, rim):
        np.testing.assert_array_equal(moved.rest_positions[seam], wanted)
    assert signed_areas(moved.rest_positions, moved.triangles).min() > 0.0
    assert np.degrees(min_angles(moved)).min() > 15.0


def test_harmonic_displacement() -> None:
    """x^2 - y^2 is harmonic: its values on the rim determine the same values inside."""
    panel = triangulate(NAMED["disc"], 0.006)
    x, y = panel.rest_positions.T
    wave = 0.2 * (x**2 - y**2)
    moved = move_rim(
        panel,
        [
            seam + np.stack([wave[loop], 0.0 * wave[loop]], axis=1)
            for seam, loop in zip(rim_of(panel), panel.loops)
        ],
    )
    assert moved is not None
    error = moved.rest_positions - panel.rest_positions - np.stack([wave, 0.0 * wave], axis=1)
    assert np.abs(error).max() < 0.01 * np.abs(wave).max()


def test_a_crushed_mesh_is_refused() -> None:
    panel = triangulate(NAMED["disc"], 0.01)
    flat = [seam * np.array([1.0, 0.15]) for seam in rim_of(panel)]
    assert move_rim(panel, flat) is None
    wild = [seam * (1.0 + 0.4 * np.cos(9.0 * np.arctan2(*seam.T)))[:, None] for seam in rim_of(panel)]
    assert move_rim(panel, wild) is None


def test_a_rim_turned_inside_out_is_refused() -> None:
    panel = triangulate(NAMED["ring"], 0.015)
    outer, inner = rim_of(panel)
    assert move_rim(panel, [outer, inner * 2.4]) is None

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bags meshed to about 2 000 vertices and inflated, against volumes in closed form and of other programs.

Film without bending and without a sealed band.
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from bag_volumes import KNOWN, box
from solver_cases import PRESSURE, film, needs_native

from BalloonWorkbench.core.bags.bag import Bag
from BalloonWorkbench.core.bags.mesh_bag import default_size, mesh_bag
from BalloonWorkbench.core.solver.backend import available
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.solver.problem import NewtonSettings

#: The volume is then known to 0.03 %; what still moves are crumples.
ENOUGH = NewtonSettings(1e-4)
MOST_STEPS = 20
BACKEND = available()[0].name
#: A panel of each kind: rectangles, triangles, discs, a sector. All of them: benchmarks/validation/bags.py.
FEW = ("stiff cube", "tetrahedron", "low drum", "cone")


@cache
def known(name: str, backend: str) -> Inflation:
    return blown(KNOWN[name].bag(), KNOWN[name].k, backend)


def blown(bag: Bag, k: float, backend: str | None = None, size: float | None = None) -> Inflation:
    assembly = mesh_bag(bag, size or default_size(bag)).assembly
    result = inflate(
        assembly, film(k), PRESSURE, backend=backend, model=Model(bending=False), settings=ENOUGH
    )
    assert result.report.converged
    return result


@pytest.mark.parametrize(
    ("name", "backend"),
    [
        *(pytest.param(name, "native", marks=needs_native) for name in FEW),
        ("low drum", "numpy"),
    ],
)
def test_known_volumes(name: str, backend: str) -> None:
    result = known(name, backend)
    assert 1800 < len(result.positions) < 2200
    assert result.volume == pytest.approx(KNOWN[name].volume, rel=0.003)
    assert result.report.newton_steps <= MOST_STEPS


def test_a_long_prism_is_a_cylinder() -> None:
    """What a longer one has more, far from its ends: the area of a circle of the same perimeter."""
    longer, shorter = (blown(box(length, 1.0, 0.5), 1e3, size=0.11).volume for length in (6.0, 4.0))
    assert longer - shorter == pytest.approx(2.0 * 3.0**2 / (4.0 * np.pi), rel=0.003)


def test_a_cube_is_rounded_as_known() -> None:
    """Distances from its middle: of a corner, the middle of an edge, the middle of a face."""
    result = known("stiff cube", BACKEND)
    places = np.split(result.positions, result.assembly.offsets[1:-1])
    faces = [
        (panel.rest_positions - panel.rest_positions[panel.loops[0]].mean(axis=0), at)
        for panel, at in zip(result.assembly.panels, places)
    ]
    half = (-0.5, 0.5)
    middles, edges, corners = (
        np.array([at[np.argmin(np.linalg.norm(rest - spot, axis=1))] for rest, at in faces for spot in spots])
        for spots in (
            [(0.0, 0.0)],
            [*((x, 0.0) for x in half), *((0.0, y) for y in half)],
            [(x, y) for x in half for y in half],
        )
    )
    middle = corners.mean(axis=0)  # a vertex lies in each, and only near the middles
    for points, distance in ((middles, 0.6077), (edges, 0.4611 * 2.0**0.5), (corners, 0.4914 * 3.0**0.5)):
        away = np.linalg.norm(points - middle, axis=1)
        np.testing.assert_allclose(away, distance, rtol=0.03)  # crumples follow the mesh
        assert away.mean() == pytest.approx(distance, rel=0.005)


def test_a_cone_is_as_high_and_wide_as_known() -> None:
    """On a disc of radius 1, with a slant of 2: about its axis, which its tip and its disc give."""
    result = known("cone", BACKEND)
    sector, disc = np.split(result.positions, result.assembly.offsets[1:-1])
    rest = result.assembly.panels[0].rest_positions
    tip = sector[np.argmin(np.linalg.norm(rest, axis=1))]
    flat = result.assembly.panels[1]
    base = disc[np.argmin(np.linalg.norm(flat.rest_positions, axis=1))]
    axis = (tip - base) / np.linalg.norm(tip - base)
    heights = (result.positions - base) @ axis
    radii = np.linalg.norm(result.positions - base - heights[:, None] * axis, axis=1)
    assert np.ptp(heights) == pytest.approx(2.150988, rel=0.01)
    # crumples along the rim of the disc reach in and out of the widest circle
    widest = heights[np.argsort(radii)[-50:]]
    band = np.abs(heights - np.median(widest)) < 0.02
    assert radii[band].mean() == pytest.approx(0.872010, rel=0.01)

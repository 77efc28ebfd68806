# SPDX-License-Identifier: LGPL-2.1-or-later
"""Native and NumPy: the same model, the same balloon.

What one of them finds the other finds too: closed forms are compared with the native solver, which is quick.
"""

import numpy as np
import pytest
from drawn_shapes import NAMED
from solver_cases import PRESSURE, film, inflated, needs_native, panel

from BalloonWorkbench.core.film.library import films
from BalloonWorkbench.core.geometry.triangulation import signed_areas
from BalloonWorkbench.core.geometry.vectors import alignment
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.problem import NewtonSettings

pytestmark = needs_native


def membrane_energy(inflation: Inflation) -> float:
    """Of the stretched film, but for its stiffness: the squares of its tensions over its area."""
    return float(
        signed_areas(inflation.panel.rest_positions, inflation.panel.triangles)
        @ (inflation.tensions**2).sum(axis=1)
    )


def same(one: Inflation, other: Inflation) -> None:
    """Equal but for a motion in the plane, which no force holds: rounding decides where a balloon lies."""
    assert (one.report.backend, other.report.backend) == ("native", "numpy")
    assert one.report.converged == other.report.converged
    assert one.volume == pytest.approx(other.volume, rel=1e-6)
    assert one.report.bending_share == pytest.approx(other.report.bending_share, rel=1e-5)
    assert membrane_energy(one) == pytest.approx(membrane_energy(other), rel=1e-7)
    size = float(np.ptp(one.panel.rest_positions, axis=0).max())
    plan, goal = one.positions[:, :2], other.positions[:, :2]
    turn, shift = alignment(plan, goal, np.ones(len(plan)))
    assert np.abs(plan @ turn.T + shift - goal).max() < 1e-5 * size
    assert one.positions[:, 2] == pytest.approx(other.positions[:, 2], abs=1e-5 * size)
    assert np.linalg.norm(one.directors, axis=1) == pytest.approx(1.0)


@pytest.mark.parametrize(
    ("shape", "k", "seal_width"),
    [("disc", 100, 0.0), ("square", 1000, 0.0), ("rectangle", 10000, 0.0), ("ring", 1000, 0.1)],
)
def test_reference_shapes(shape: str, k: int, seal_width: float) -> None:
    one, other = (
        inflated(shape, k, backend, seal_width=seal_width, vertices=500) for backend in ("native", "numpy")
    )
    same(one, other)


@pytest.mark.parametrize("name", ["heart", "star", "S", "L", "holes"])
def test_real_shapes_and_film(name: str) -> None:
    outline = NAMED[name]
    mesh = triangulate(outline, size_for(outline, 500))
    exact = NewtonSettings(tolerance=1e-12)  # else crumples of the heart are still on their way
    one, other = (
        inflate(mesh, films()["mylar"], 2000.0, backend=name, settings=exact) for name in ("native", "numpy")
    )
    same(one, other)


def test_warm_starts() -> None:
    mesh = panel("disc", 400)
    first = inflate(mesh, film(100, seal_width=0.02), PRESSURE, backend="native")
    one, other = (
        inflate(mesh, film(150, seal_width=0.02), PRESSURE, start=first, backend=name)
        for name in ("native", "numpy")
    )
    same(one, other)

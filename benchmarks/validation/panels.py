# SPDX-License-Identifier: LGPL-2.1-or-later
"""Balloons of many panels against closed forms and another program."""

from __future__ import annotations

from collections.abc import Callable

import bodies
import numpy as np
from solver_cases import PRESSURE, film
from validation.report import Row, Section, section

from BalloonWorkbench.core.panels.assembly import Assembly
from BalloonWorkbench.core.solver.element.kinematics import facet_volume
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.solver.problem import NewtonSettings

A = 1.3110287771  # of the Mylar balloon
BALL = 4.0 * np.pi / 3.0

#: Volume / edge^3 from three nested meshes, confirmed by Surface Evolver; k = E t / (p L).
SOLIDS: dict[str, tuple[Callable[[int], Assembly], int, float, float]] = {
    "cube, k = 1000": (lambda cells: bodies.box(1.0, 1.0, 1.0, cells), 8, 1e3, 1.2629),
    "cube, k = 10000": (lambda cells: bodies.box(1.0, 1.0, 1.0, cells), 8, 1e4, 1.2608),
    "box 1 x 1 x 2": (lambda cells: bodies.box(1.0, 1.0, 2.0, cells), 6, 1e4, 2.532),
    "box 1 x 1 x 0.5": (lambda cells: bodies.box(1.0, 1.0, 0.5, cells), 8, 1e4, 0.6466),
    "tetrahedron, k = 1000": (bodies.tetrahedron, 12, 1e3, 0.17317),
    "tetrahedron, k = 10000": (bodies.tetrahedron, 12, 1e4, 0.17296),
    "octahedron, k = 1000": (bodies.octahedron, 10, 1e3, 0.5406),
    "octahedron, k = 10000": (bodies.octahedron, 10, 1e4, 0.5398),
}
#: Volume of a sphere of flat sinusoidal gores, in that of the sphere.
GORES = {4: 0.9405, 6: 0.9740, 8: 0.9858, 12: 0.9940, 24: 0.9987}


def panels() -> Section:
    """Polyhedra, drums and gored spheres."""
    rows = [
        Row(f"{name}: V / a^3", _volume(make, coarse, k), volume, 0.003)
        for name, (make, coarse, k, volume) in SOLIDS.items()
    ]
    for height in (0.25, 1.0, 2.0):
        found = _volume(lambda count, height=height: bodies.drum(height, count), 5, 1e4)  # type: ignore[misc]
        rows.append(Row(f"drum, H / R = {height:g}: V / R^3", found, _drum(height), 0.003))
    for count, share in GORES.items():
        columns = 2 if count > 12 else 4
        found = _volume(lambda n, count=count, columns=columns: _gores(n, count, columns), 1, 1e4)  # type: ignore[misc]
        rows.append(Row(f"sphere of {count} gores: V / (4 pi R^3 / 3)", found / BALL, share, 0.003, 4))
    cube = bodies.box(1.0, 1.0, 1.0, 8, both_diagonals=True)
    rows.append(
        Row(
            "cube of 6 x 8 x 8 crossed squares, on that very mesh", _between_facets(cube, 1e3), 1.256910, 1e-5
        )
    )
    return section(
        "Many panels",
        "Flat panels and their seams, without bending and without a sealed band; volumes between the facets,"
        " extrapolated from two meshes. References: for drums the film that cannot stretch, for the others"
        " three nested meshes and Surface Evolver.",
        rows,
    )


def _gores(fineness: int, count: int, columns: int) -> Assembly:
    return bodies.gored_sphere(count, 16 * fineness, columns * fineness)


def _volume(make: Callable[[int], Assembly], coarse: int, k: float) -> float:
    once, twice = (_between_facets(make(number), k) for number in (coarse, 2 * coarse))
    return twice + (twice - once) / 3.0


def _between_facets(body: Assembly, k: float) -> float:
    settings = NewtonSettings(1e-7)
    balloon = inflate(
        body, film(k), PRESSURE, backend="native", model=Model(bending=False), settings=settings
    )
    return facet_volume(balloon.positions, body.surface.triangles)


def _drum(height: float) -> float:
    """Of a film that cannot stretch, R = 1."""
    if height >= 2.0 * (A - 1.0):
        return float(np.pi * (height - 2.0 * (A - 1.0)) + 2.0 * np.pi / 3.0 * A)
    return float(2.0 * np.pi / 3.0 * A * ((1.0 + 0.5 * height) / A) ** 3)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bags as users make them, meshed by the program to about 2 000 vertices, against known volumes."""

from __future__ import annotations

import time

import numpy as np
from bag_volumes import KNOWN, KnownVolume, box, icosahedron
from solver_cases import PRESSURE, film
from validation.report import Row, Section, section, table

from BalloonWorkbench.core.bags.bag import Bag
from BalloonWorkbench.core.bags.mesh_bag import default_size, mesh_bag
from BalloonWorkbench.core.bodies.gores import gored_bag
from BalloonWorkbench.core.bodies.profile import Profile
from BalloonWorkbench.core.panels.assembly import Assembly
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.solver.problem import NewtonSettings

#: Volume of a sphere of flat sinusoidal gores in that of the sphere, and within what that is asked.
GORES = {4: (0.9405, 0.005), 6: (0.9740, 0.005), 8: (0.9858, 0.003), 12: (0.9940, 0.003), 24: (0.9987, 0.003)}
#: Where the solves end: the volumes are then known to 0.03 %.
TOLERANCE = NewtonSettings(1e-4)


def bags() -> Section:
    """Every known volume, with both solvers."""
    cases = dict(KNOWN)
    for count, (share, _) in GORES.items():
        volume = share * 4.0 * np.pi / 3.0
        cases[f"sphere of {count} gores"] = KnownVolume(lambda count=count: _sphere(count), 1e4, volume)
    rows, efforts = [], []
    for name, case in cases.items():
        balloons, effort = _both(name, case.bag(), case.k)
        efforts.append(effort)
        asked = GORES[int(name.split()[2])][1] if "gores" in name else 0.003
        for backend, balloon in balloons.items():
            rows.append(Row(f"{name}, k = {case.k:g}, {backend}: V", balloon.volume, case.volume, asked))
    efforts.append(_both("icosahedron, 20 panels", icosahedron(), 1e3, 3000)[1])
    longer, shorter = (_prism(length) for length in (6.0, 4.0))
    circle = 3.0**2 / (4.0 * np.pi)
    rows.append(Row("long prism: area of its section", 0.5 * (longer - shorter), circle, 0.003))
    return section(
        "Bags",
        "Panels meshed by the program, about 2 000 vertices in all; no bending, no sealed band;"
        " solves end at a relative decrement of 1e-4. References as above, and for cones a film that cannot"
        " stretch.",
        rows,
        table(("", "k", "vertices", "steps, native", "s", "steps, NumPy", "s"), efforts),
    )


def _both(name: str, bag: Bag, k: float, vertices: int = 2000) -> tuple[dict[str, Inflation], list[str]]:
    """The balloons of both solvers, and a line about what they took."""
    assembly = mesh_bag(bag, default_size(bag, vertices)).assembly
    effort, balloons = [name, f"{k:g}", str(len(assembly.surface.rest_positions))], {}
    for backend in ("native", "numpy"):
        began = time.process_time()
        balloons[backend] = _blown(assembly, k, backend)
        effort += [str(balloons[backend].report.newton_steps), f"{time.process_time() - began:.2f}"]
    return balloons, effort


def _blown(assembly: Assembly, k: float, backend: str) -> Inflation:
    model = Model(bending=False)
    return inflate(assembly, film(k), PRESSURE, backend=backend, model=model, settings=TOLERANCE)


def _prism(length: float) -> float:
    return _blown(mesh_bag(box(length, 1.0, 0.5), 0.09).assembly, 1e3, "native").volume


def _sphere(count: int) -> Bag:
    """Of radius 1."""
    angles = np.linspace(0.0, np.pi, 121)
    return gored_bag(Profile(np.column_stack([np.sin(angles), -np.cos(angles)])), count)

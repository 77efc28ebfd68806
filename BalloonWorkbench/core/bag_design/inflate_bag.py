# SPDX-License-Identifier: LGPL-2.1-or-later
"""The balloon of a bag as it is: its panels are the pattern, nothing is corrected."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from BalloonWorkbench.core.bag_design.bag_design import BagDesign
from BalloonWorkbench.core.bags.bag import Bag
from BalloonWorkbench.core.bags.mesh_bag import MeshedBag, default_size, mesh_bag
from BalloonWorkbench.core.correction.summary import NOT_AT_REST
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.geometry.polyline import extent
from BalloonWorkbench.core.geometry.rigid import turn_onto
from BalloonWorkbench.core.solver.element.kinematics import facet_volume
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.types import Floats, Progress, no_progress


def inflate_bag(
    bag: Bag,
    film: Film,
    pressure: float,
    *,
    places: Sequence[Floats] | None = None,
    mesh_size: float | None = None,
    backend: str | None = None,
    model: Model | None = None,
    progress: Progress = no_progress,
) -> BagDesign:
    """The balloon that the panels of a bag make under a pressure [Pa].

    places     (points, 3) m of each panel's points in space, near which the balloon comes to lie; None: the
               panels are closed up without knowing where they belong, and the first one faces up, its own x
               and y those of the balloon
    mesh_size  [m], None for the usual one
    Raises what mesh_bag and inflate raise.
    """
    began = time.perf_counter()
    meshed = mesh_bag(bag, mesh_size or default_size(bag))
    start = None if places is None else meshed.places(places)
    inflation = inflate(
        meshed.assembly,
        film,
        pressure,
        start=start,
        backend=backend,
        model=model,
        progress=progress,
    )
    inflation = _with_first_up(inflation) if places is None else inflation
    return BagDesign(
        bag,
        bag,
        meshed,
        within_open_ends(meshed, inflation),
        extent(inflation.positions),
        seconds=time.perf_counter() - began,
        warnings=(*bag.notes, *(() if inflation.report.converged else (NOT_AT_REST,))),
    )


def within_open_ends(meshed: MeshedBag, inflation: Inflation) -> Inflation:
    """The balloon with its volume up to its open ends: the solver's is that with what panels not cut hold."""
    assembly, beyond = meshed.assembly, 0.0
    for number, panel in enumerate(meshed.bag.panels):
        if not panel.cut:
            own = inflation.positions[assembly.offsets[number] : assembly.offsets[number + 1]]
            middle = own[assembly.panels[number].loops[0]].mean(axis=0)
            triangles = assembly.surface.triangles
            first, last = assembly.offsets[number], assembly.offsets[number + 1]
            sheet = triangles[((triangles >= first) & (triangles < last)).all(axis=1)] - first
            beyond += facet_volume(own - middle, sheet)
    return inflation if beyond == 0.0 else replace(inflation, volume=inflation.volume - float(beyond))


def _with_first_up(inflation: Inflation) -> Inflation:
    """The balloon turned so that its first panel comes nearest to how it lies flat."""
    flat = inflation.panel.rest_positions
    own = inflation.positions[: len(flat)]
    goals = np.column_stack([flat, np.zeros(len(flat))])
    turn = turn_onto(own, goals)
    middle = 0.5 * (inflation.positions.min(axis=0) + inflation.positions.max(axis=0))
    positions = (inflation.positions - middle) @ turn
    middle = 0.5 * (positions.min(axis=0) + positions.max(axis=0))
    return replace(inflation, positions=positions - middle, directors=inflation.directors @ turn)

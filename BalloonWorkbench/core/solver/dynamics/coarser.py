# SPDX-License-Identifier: LGPL-2.1-or-later
"""A balloon of many panels on fewer vertices, for what takes many solves of it."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from BalloonWorkbench.core.bags.bag import Bag
from BalloonWorkbench.core.bags.mesh_bag import default_size, mesh_bag
from BalloonWorkbench.core.panels.assembly import Assembly
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.lift import Lift
from BalloonWorkbench.core.types import Floats


@dataclass(frozen=True)
class Coarser:
    """Panels and where their balloon lies: places (n, 3) m near its vertices, and its lift."""

    assembly: Assembly
    places: Floats
    lift: Lift | None


def coarser(inflation: Inflation, bag: Bag, vertices: int) -> Coarser:
    """The balloon of a bag on about so many vertices; as it is where it has no more."""
    fine, lift = inflation.assembly, inflation.report.lift
    if len(inflation.positions) <= vertices:
        return Coarser(fine, inflation.positions, lift)
    coarse = mesh_bag(bag, default_size(bag, vertices)).assembly
    nearest, held = [], []
    for number, (panel, own) in enumerate(zip(coarse.panels, fine.panels, strict=True)):
        away = np.linalg.norm(panel.rest_positions[:, None] - own.rest_positions, axis=2)
        nearest.append(away.argmin(axis=1) + fine.offsets[number])
        if lift is not None:
            here = lift.held - fine.offsets[number]
            here = here[(here >= 0) & (here < len(own.rest_positions))]
            held.append(away.argmin(axis=0)[here] + coarse.offsets[number])
    if lift is not None:
        lift = replace(lift, held=np.unique(np.concatenate(held)).astype(np.int32))
    return Coarser(coarse, inflation.positions[np.concatenate(nearest)], lift)

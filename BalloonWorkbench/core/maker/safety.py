# SPDX-License-Identifier: LGPL-2.1-or-later
"""Up to which pressure film and weld hold, with a margin."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.solver.dkt import gradients
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.kinematics import deformation_gradients, green_strains
from BalloonWorkbench.core.solver.model import film_problem
from BalloonWorkbench.core.solver.strength import strength

FILM, WELD = "film", "weld"
#: Part of the weld's length that must hold. At the tip of a notch the load has no limit as the mesh gets
#: finer; there the film gives way a little, and the weld beside it takes over.
_HELD = 0.95
_MOST_TRIALS = 6
_NEAR = 0.01


@dataclass(frozen=True)
class Safety:
    """What holds a balloon together.

    film_load, weld_load    largest tension of the film and at the weld, at `pressure` [N/m, Pa]
    film_limit, weld_limit  what they bear [N/m], None where that is not known
    margin                  strength over load that is asked for
    safe_pressure           at which that margin is left [Pa], None where no strength is known
    weakest                 FILM or WELD, empty where no strength is known
    """

    film_load: float
    weld_load: float
    film_limit: float | None
    weld_limit: float | None
    pressure: float
    margin: float
    safe_pressure: float | None
    weakest: str


def weld_load(inflation: Inflation, film: Film) -> float:
    """Load [N/m] that 95 % of the outer and inner seams stay below: how hard each film pulls at the weld.

    From the forces of the film on the vertices of the seam, per length of flat film, each averaged with its
    neighbours': single triangles of a crumpled rim pull hard or not at all.
    """
    panel = inflation.panel
    problem = film_problem(panel, film, inflation.report.pressure, inflation.report.model)
    shape, areas = gradients(panel.rest_positions[panel.triangles])
    deformation = deformation_gradients(inflation.positions, panel.triangles, shape)
    xx, yy, xy = problem.membrane(green_strains(deformation)).stress.T
    stress = film.membrane_stiffness * np.stack([np.stack([xx, xy], -1), np.stack([xy, yy], -1)], axis=1)
    corners = areas[:, None, None] * np.einsum("mij,mjk,mck->mci", deformation, stress, shape)
    forces = np.zeros((len(inflation.positions), 3))
    np.add.at(forces, panel.triangles, corners)
    loads, lengths = [], []
    for seam in panel.seams:
        steps = np.hypot(*(np.roll(panel.rest_positions[seam], -1, axis=0) - panel.rest_positions[seam]).T)
        own = 0.5 * (steps + np.roll(steps, 1))
        pulled = np.linalg.norm(forces[seam], axis=1)
        near = [np.roll(own, k) for k in (-1, 0, 1)]
        loads.append(sum(np.roll(pulled, k) for k in (-1, 0, 1)) / sum(near))
        lengths.append(own)
    found = np.concatenate(loads)
    order = np.argsort(found)
    share = np.cumsum(np.concatenate(lengths)[order])
    return float(found[order][np.searchsorted(share, _HELD * share[-1])])


def safety(
    inflation: Inflation,
    film: Film,
    weld_limit: float | None,
    margin: float,
    at_pressure: Callable[[float], Inflation] | None = None,
) -> Safety:
    """The pressure at which film and weld still bear `margin` times their load.

    Tensions grow in proportion to the pressure while the film does not stretch, and less than that when it
    does: so the pressure found in proportion is safe where it is above that of the inflation. Where it is
    below, the balloon is inflated anew at lower pressures (at_pressure), until the margin is there.
    """
    found = _at(inflation, film, weld_limit, margin)
    for _ in range(_MOST_TRIALS):
        if at_pressure is None or found.safe_pressure is None:
            break
        if found.safe_pressure >= found.pressure * (1.0 - _NEAR):
            break
        found = _at(at_pressure(found.safe_pressure), film, weld_limit, margin)
    own = _at(inflation, film, weld_limit, margin)
    return Safety(
        own.film_load,
        own.weld_load,
        own.film_limit,
        weld_limit,
        own.pressure,
        margin,
        found.safe_pressure,
        found.weakest,
    )


def _at(inflation: Inflation, film: Film, weld_limit: float | None, margin: float) -> Safety:
    """The same, in proportion to the pressure."""
    tight, weld = strength(inflation, film), weld_load(inflation, film)
    reserves = {
        name: limit / load
        for name, limit, load in ((FILM, tight.limit, tight.tension), (WELD, weld_limit, weld))
        if limit is not None
    }
    weakest = min(reserves, key=lambda name: reserves[name]) if reserves else ""
    return Safety(
        tight.tension,
        weld,
        tight.limit,
        weld_limit,
        tight.pressure,
        margin,
        tight.pressure * reserves[weakest] / margin if weakest else None,
        weakest,
    )

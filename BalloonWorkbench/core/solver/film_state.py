# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the film does where: strains, tensions and wrinkles of each triangle, thickness of the balloon."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum

import numpy as np

from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.solver.dkt import gradients
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.kinematics import deformation_gradients, green_strains
from BalloonWorkbench.core.solver.membrane import principal_strains
from BalloonWorkbench.core.types import Floats, Ints


class State(IntEnum):
    """How a triangle carries the pressure."""

    SLACK = 0  # not at all
    WRINKLED = 1  # by tension along one direction
    TAUT = 2  # in all directions


@dataclass(frozen=True)
class FilmState:
    """Results for each of m triangles of the upper half.

    strains    (m, 2) larger and smaller principal Green strain
    tensions   (m, 2) N/m, principal membrane tensions
    state      (m,) of type State
    direction  (m, 3) unit vectors along the wrinkles, in space; zero where there are none
    intensity  (m,) part of the width across the wrinkles that they hide, 0 to 1
    """

    strains: Floats
    tensions: Floats
    state: Ints
    direction: Floats
    intensity: Floats


def film_state(inflation: Inflation, film: Film) -> FilmState:
    """The state of the film of an inflated balloon made of this film."""
    panel = inflation.panel
    shape, _ = gradients(panel.rest_positions[panel.triangles])
    deformation = deformation_gradients(inflation.positions, panel.triangles, shape)
    major, minor, axis = principal_strains(green_strains(deformation))
    tensions = inflation.tensions
    least = 1e-12 * film.membrane_stiffness
    state = np.where(
        tensions[:, 1] > least, State.TAUT, np.where(tensions[:, 0] > least, State.WRINKLED, State.SLACK)
    )
    folded = state != State.TAUT
    # a film under one tension would be this wide across it
    free = np.where(state == State.WRINKLED, -film.poisson_ratio * major, 0.0)
    hidden = 1.0 - np.sqrt(np.maximum(1.0 + 2.0 * minor, 0.0) / np.maximum(1.0 + 2.0 * free, 1e-12))
    along = np.einsum("mik,mk->mi", deformation, axis)
    direction = along / np.maximum(np.linalg.norm(along, axis=1), 1e-300)[:, None]
    return FilmState(
        np.column_stack([major, minor]),
        tensions,
        state.astype(np.int32),
        np.where((state == State.WRINKLED)[:, None], direction, 0.0),
        np.where(folded, np.clip(hidden, 0.0, 1.0), 0.0),
    )


def thickness(inflation: Inflation) -> Floats:
    """Thickness (n,) m of the balloon at each vertex of the panel, from the lower to the upper film."""
    return np.asarray(2.0 * inflation.positions[:, 2])

# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the film does where: strains, tensions and wrinkles of each triangle, thickness of the balloon."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum

import numpy as np

from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.solver.element.dkt import gradients
from BalloonWorkbench.core.solver.element.kinematics import deformation_gradients, green_strains
from BalloonWorkbench.core.solver.element.membrane import plane_stress, principal_strains, principal_stresses
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.model import film_problem
from BalloonWorkbench.core.solver.problem import FilmProblem
from BalloonWorkbench.core.types import Floats, Ints


class State(IntEnum):
    """How a triangle carries the pressure."""

    SLACK = 0  # not at all
    WRINKLED = 1  # by tension along one direction
    TAUT = 2  # in all directions


@dataclass(frozen=True)
class FilmState:
    """Results for each of m triangles, of the upper half where one panel stands for two.

    strains    (m, 2) larger and smaller principal Green strain
    tensions   (m, 2) N/m, principal membrane tensions
    direction  (m, 3) unit vectors along the larger tension, in space, which is along the wrinkles where there
               are any; zero where the film is slack
    state      (m,) of type State
    intensity  (m,) part of the width across the wrinkles that they hide, 0 to 1
    areas      (m,) m2, of the flat film
    """

    strains: Floats
    tensions: Floats
    direction: Floats
    state: Ints
    intensity: Floats
    areas: Floats

    def shares(self) -> dict[State, float]:
        """Part of the film's area in each state."""
        area = float(self.areas.sum())
        return {state: float(self.areas[self.state == state].sum()) / area for state in State}


def film_state(inflation: Inflation, film: Film) -> FilmState:
    """The state of the film of an inflated balloon made of this film.

    A plain shell is said to be wrinkled or slack where it is compressed instead.
    """
    surface = inflation.assembly.surface
    problem = film_problem(
        inflation.assembly, film, inflation.characteristic_pressure, inflation.report.model
    )
    shape, areas = gradients(surface.rest_positions[surface.triangles])
    deformation = deformation_gradients(inflation.positions, surface.triangles, shape)
    strains = green_strains(deformation)
    major, minor, longest = principal_strains(strains)
    stress = problem.membrane(strains).stress
    tensions = film.membrane_stiffness * principal_stresses(stress)
    least = 1e-12 * film.membrane_stiffness
    state = np.where(
        tensions[:, 1] > least, State.TAUT, np.where(tensions[:, 0] > least, State.WRINKLED, State.SLACK)
    )
    wrinkled, slack = state == State.WRINKLED, state == State.SLACK
    axis = np.where(slack[:, None], longest, principal_strains(stress * (1.0, 1.0, 2.0))[2])
    # a film under one tension would be this wide across it
    free = np.where(wrinkled, _contraction(problem, axis) * _normal(strains, axis), 0.0)
    across = _normal(strains, axis[:, ::-1] * (-1.0, 1.0))
    hidden = 1.0 - np.sqrt(np.maximum(1.0 + 2.0 * across, 0.0) / np.maximum(1.0 + 2.0 * free, 1e-12))
    along = np.einsum("mik,mk->mi", deformation, axis)
    along /= np.maximum(np.linalg.norm(along, axis=1), 1e-300)[:, None]
    return FilmState(
        np.column_stack([major, minor]),
        tensions,
        np.where(slack[:, None], 0.0, along),
        state.astype(np.int32),
        np.where(wrinkled | slack, np.clip(hidden, 0.0, 1.0), 0.0),
        areas,
    )


def thickness(inflation: Inflation) -> Floats:
    """Thickness (n,) m of the balloon at each vertex of the panel, from the lower to the upper film."""
    if inflation.lower is not None:
        return np.asarray(inflation.positions[:, 2] - inflation.lower[:, 2])
    return np.asarray(2.0 * inflation.positions[:, 2])


def _normal(strains: Floats, axis: Floats) -> Floats:
    """Normal strains (m,) along directions (m, 2)."""
    x, y = axis.T
    return np.asarray(x * x * strains[:, 0] + y * y * strains[:, 1] + x * y * strains[:, 2])


def _contraction(problem: FilmProblem, axis: Floats) -> Floats:
    """Strain (m,) across a single tension along directions (m, 2), relative to the one along it."""
    stiffness = plane_stress(problem.poisson_ratio)
    if problem.grain is not None:
        turn = problem.grain.turn
        stiffness = turn.T @ problem.grain.stiffness @ turn
    x, y = axis.T
    strains = np.column_stack([x * x, y * y, x * y]) @ np.linalg.inv(stiffness)
    return _normal(strains, axis[:, ::-1] * (-1.0, 1.0)) / _normal(strains, axis)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The forces of the film as its flat vertices move, against differences of the forces themselves."""

from dataclasses import replace

import numpy as np
import pytest
from test_solver_derivatives import problem, random_state

from BalloonWorkbench.core.solver.element import dkt
from BalloonWorkbench.core.solver.element.kinematics import green_strains
from BalloonWorkbench.core.solver.element.membrane import principal_strains, states
from BalloonWorkbench.core.solver.element.orthotropic import Grain
from BalloonWorkbench.core.solver.element.rest_derivatives import force_changes
from BalloonWorkbench.core.solver.element.scatter import times_fields
from BalloonWorkbench.core.solver.element.shell import Shell, tangent_frames
from BalloonWorkbench.core.solver.problem import FilmProblem
from BalloonWorkbench.core.types import Floats

STEP = 1e-7


def difference(one: FilmProblem, positions: Floats, directors: Floats, move: Floats) -> Floats:
    """Of the gradient (n, 5) in all unknowns, for a unit of move (n, 2)."""
    free = np.zeros_like(one.fixed)

    def gradient(step: float) -> Floats:
        moved = replace(one, rest_positions=one.rest_positions + step * move, fixed=free)
        forces, _ = Shell(moved).derivatives(positions, directors, tangent_frames(directors))
        return forces.reshape(-1, 5)

    return (gradient(STEP) - gradient(-STEP)) / (2.0 * STEP)


@pytest.mark.parametrize("grain", [None, Grain(0.4, 0.25, 0.3, 0.7)], ids=["alike", "grain"])
@pytest.mark.parametrize("tension_field", [True, False], ids=["film", "plain-shell"])
@pytest.mark.parametrize("part", ["all", "membrane", "bending", "band"])
def test_force_changes_are_differences_of_the_forces(
    part: str, tension_field: bool, grain: Grain | None
) -> None:
    one = replace(problem(), tension_field=tension_field, grain=grain)
    if part != "all":
        one = replace(
            one,
            membrane_stiffness=one.membrane_stiffness * (part == "membrane"),
            flexural_rigidity=one.flexural_rigidity * (part == "bending"),
            hinge_rigidities=one.hinge_rigidities * (part == "band"),
        )
    positions, directors = random_state(3, one, scatter=0.005)
    moves = np.random.default_rng(5).standard_normal((len(positions), 2, 3))
    shell = Shell(one)
    shell.exact = True
    changes = force_changes(shell, positions, directors, tangent_frames(directors), moves)
    assert changes.shape == (len(positions), 5, 3)
    for field in range(3):
        expected = difference(one, positions, directors, moves[:, :, field])
        for unknown in range(5):  # positions and turns by their own measure
            largest = np.abs(expected[:, unknown]).max()
            if largest == 0.0:  # turns without bending
                assert not changes[:, unknown, field].any()
            else:
                missed = np.abs(expected[:, unknown] - changes[:, unknown, field]).max()
                assert missed < 1e-6 * largest


def test_the_film_is_in_all_three_states() -> None:
    """Or the comparison above says nothing of one."""
    shell = Shell(problem())
    positions, directors = random_state(3, problem(), scatter=0.005)
    film = shell.elastic(positions, directors, tangent_frames(directors))
    major, minor, _ = principal_strains(green_strains(film.gradient))
    taut, wrinkled = states(major, minor, problem().poisson_ratio)
    assert min(taut.sum(), wrinkled.sum(), (~taut & ~wrinkled).sum()) > 50


def test_a_film_that_is_only_moved_and_turned_keeps_its_forces() -> None:
    """Of a film alike in all directions; one that is turned with its rotations measured in turned axes."""
    one = replace(problem(), flexural_rigidity=0.0)
    positions, directors = random_state(3, one, scatter=0.005)
    rest = one.rest_positions
    along, turn = np.tile([0.3, -0.2], (len(rest), 1)), np.column_stack([-rest[:, 1], rest[:, 0]])
    shell = Shell(one)
    shell.exact = True
    moves = np.stack([along, turn, rest], axis=2)
    changes = force_changes(shell, positions, directors, tangent_frames(directors), moves)
    moved, turned, grown = np.abs(changes).max(axis=(0, 1))
    assert max(moved, turned) < 1e-10 * grown


def test_complex_corners_give_the_derivative_of_the_bending_law() -> None:
    corners = np.array([[[0.0, 0.0], [1.0, 0.1], [0.2, 0.8]]])
    for coordinate in range(6):
        step = np.zeros(6)
        step[coordinate] = 1.0
        turned = dkt.rotation_stiffness(corners + 1e-30j * step.reshape(3, 2), 0.3).imag / 1e-30
        ahead, behind = (dkt.rotation_stiffness(corners + h * step.reshape(3, 2), 0.3) for h in (1e-6, -1e-6))
        assert turned == pytest.approx((ahead - behind) / 2e-6, abs=1e-8 * np.abs(turned).max())


def test_blocks_times_fields_are_those_of_the_whole_matrix() -> None:
    random = np.random.default_rng(2)
    rows, columns = random.integers(0, 6, (2, 40))
    blocks, fields = random.standard_normal((40, 5, 2)), random.standard_normal((6, 2, 3))
    whole = np.zeros((6, 5, 6, 2))
    for row, column, block in zip(rows, columns, blocks):
        whole[row, :, column] += block
    expected = np.einsum("iajb,jbk->iak", whole, fields)
    assert times_fields(rows.astype(np.int32), columns.astype(np.int32), blocks, fields) == pytest.approx(
        expected, abs=1e-12
    )

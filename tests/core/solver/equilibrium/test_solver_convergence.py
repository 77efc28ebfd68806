# SPDX-License-Identifier: LGPL-2.1-or-later
"""A solve ends when neither changes: outline and volume against those of a far longer solve."""

import numpy as np
import pytest
from drawn_shapes import NAMED
from solver_cases import needs_native

from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.mesh.reuse import move_rim
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.solver.equilibrium.convergence import Convergence
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.problem import Energies, NewtonSettings
from BalloonWorkbench.core.types import Floats

TOLERANCE = 1e-5
STIFFNESS = 20.0  # membrane, E t / (p L)
COUNT = 40
TURN = np.linspace(0.0, 2.0 * np.pi, COUNT, endpoint=False)
RIM = 0.5 * np.stack([np.cos(TURN), np.sin(TURN), np.zeros(COUNT)], axis=1)


def criterion(seam: bool = True) -> Convergence:
    fixed = np.zeros((COUNT, 5), dtype=bool)
    fixed[:, 2] = seam
    return Convergence(fixed, TOLERANCE, STIFFNESS)


def energy(volume: float) -> Energies:
    return Energies(0.1 * volume, 0.0, -volume, 0.0, 0.0)


def at_rest(
    steps: Convergence, move: Floats, *, length: float = 1.0, gain: float = 1e-4, held_back: bool = False
) -> bool:
    """A step of this movement whose volume changes by 5e-5, and whether the film is at rest."""
    before, after = energy(1.0), energy(1.0 + 5e-5 * length)
    return steps.at_rest(RIM, RIM + length * move, before, after, length, gain, held_back)


def wave(height: float) -> Floats:
    """Moves the rim in and out; root mean square of 1e-4 for a height of 1."""
    return 1e-4 * np.sqrt(2.0) * height * np.cos(5.0 * TURN)[:, None] * 2.0 * RIM


def test_two_still_steps_in_a_row() -> None:
    steps = criterion()
    assert [at_rest(steps, wave(h)) for h in (2.0, 4.0, 2.0, 3.0, 1.0)] == [False, False, False, True, True]


def test_what_moves_and_turns_as_a_whole_is_not_seen() -> None:
    turned = 0.01 * np.stack([-RIM[:, 1], RIM[:, 0], RIM[:, 2]], axis=1)
    steps = criterion()
    assert [at_rest(steps, wave(2.0) + turned + (0.1, -0.2, 0.0)) for _ in range(2)] == [False, True]


def test_a_short_step_counts_as_the_whole_one() -> None:
    steps = criterion()
    assert not any(at_rest(steps, wave(4.0), length=0.125) for _ in range(4))


def test_steps_that_say_nothing() -> None:
    assert not any(at_rest(steps, wave(0.0)) for steps in [criterion(seam=False)] for _ in range(3))
    assert not any(at_rest(steps, wave(0.0), held_back=True) for steps in [criterion()] for _ in range(3))
    assert not any(at_rest(steps, wave(0.0), gain=0.01) for steps in [criterion()] for _ in range(3))


def rim_distance(one: Floats, other: Floats) -> float:
    """Root mean square between two rims (n, 2) laid on each other."""
    one, other = one - one.mean(axis=0), other - other.mean(axis=0)
    cross = float(np.sum(one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0]))
    turn = np.arctan2(cross, float(np.sum(one * other)))
    matrix = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    return float(np.sqrt(np.mean(np.sum((one @ matrix.T - other) ** 2, axis=1))))


def pulled(panel: Panel, far: float) -> Panel:
    """The panel with one side of its rim pulled outward."""
    rim = panel.rest_positions[panel.loops[0]]
    near = np.exp(-np.sum((rim - rim[len(rim) // 3]) ** 2, axis=1) / (2.0 * 0.015**2))
    loops = [rim + far * near[:, None] * rim / np.linalg.norm(rim, axis=1)[:, None]]
    moved = move_rim(panel, loops + [panel.rest_positions[seam] for seam in panel.loops[1:]])
    assert moved is not None
    return moved


@pytest.mark.parametrize("name", ["disc", "star", "flower"])
@needs_native
def test_an_edit_ends_where_a_long_solve_does(name: str) -> None:
    """Volume within 0.02 %, outline within 0.1 % of the size, in far fewer steps."""
    panel = triangulate(NAMED[name], size_for(NAMED[name], 2000))
    first = inflate(panel, film("mylar"), 2000.0)
    edited = pulled(panel, 0.004)
    soon = inflate(edited, film("mylar"), 2000.0, start=first)
    late = inflate(edited, film("mylar"), 2000.0, start=first, settings=NewtonSettings(1e-9, 300))
    assert soon.report.converged
    assert late.report.converged
    assert soon.report.newton_steps < 0.7 * late.report.newton_steps
    assert soon.volume == pytest.approx(late.volume, rel=2e-4)
    size = float(np.ptp(panel.rest_positions, axis=0).max())
    rim = panel.loops[0]
    assert rim_distance(soon.positions[rim, :2], late.positions[rim, :2]) < 1e-3 * size

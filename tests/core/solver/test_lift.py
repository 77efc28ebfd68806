# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pressure that grows upwards: the natural shape of balloons, and what they pull at their foot."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import bodies
import numpy as np
import pytest
from solver_cases import film, needs_native, panel

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.panels.assembly import Assembly
from BalloonWorkbench.core.solver.backend import available
from BalloonWorkbench.core.solver.element.kinematics import facet_volume
from BalloonWorkbench.core.solver.element.shell import Shell, tangent_frames
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.lift import Lift, with_lift
from BalloonWorkbench.core.solver.model import Model, film_problem
from BalloonWorkbench.core.solver.problem import NewtonSettings
from BalloonWorkbench.core.solver.sensitivity import position_changes
from BalloonWorkbench.core.solver.split_along_welds import split_assembly
from BalloonWorkbench.core.types import Floats

BARE = Model(bending=False)
STEEPNESS = 100.0  # Pa/m, as film() has its pressure
GORES = 24
BACKEND = available()[0].name
NEARLY = NewtonSettings(1e-12, 300)
AT_REST = NewtonSettings(1e-7)


def natural_shape() -> Floats:
    """Length along the meridian, radius and height (n, 3) of a weightless balloon 1 m long, from below.

    With r T = const along meridians that carry all: d(angle) / ds = - c r z, from 50.15 degrees to -90.
    """

    def slope(state: Floats) -> Floats:
        r, z, angle = state
        return np.array([np.sin(angle), np.cos(angle), -r * z])

    step, state = 2e-4, np.array([0.0, 0.0, np.radians(50.14926)])
    rows = [state]
    while state[2] > -0.5 * np.pi:
        one = slope(state)
        state = state + step * slope(state + 0.5 * step * one)
        rows.append(state)
    shape = np.array(rows)[:, :2]
    along = step * np.arange(len(shape))
    return np.column_stack([along, shape]) / along[-1]


def envelope(rows: int = 32, columns: int = 4) -> tuple[Assembly, Floats]:
    """Gores as wide as the natural shape is round, and its places (n, 3) [m]."""
    sphere, shape = bodies.gored_sphere(GORES, rows, columns), natural_shape()
    gore = sphere.panels[0]
    x, latitude = gore.rest_positions.T
    along = latitude / np.pi + 0.5
    radius, height = (np.interp(along, shape[:, 0], part) for part in shape.T[1:])
    turn = x / np.maximum(np.cos(latitude), 1e-9) * (np.abs(latitude) < 1.57)  # of its share of the circle
    flat = replace(gore, rest_positions=np.column_stack([radius * turn, along]))
    places = [
        np.column_stack([radius * np.cos(turn + at), radius * np.sin(turn + at), height])
        for at in 2.0 * np.pi * np.arange(GORES) / GORES
    ]
    return replace(sphere, panels=(flat,) * GORES), np.concatenate(places)


@cache
def lifted(backend: str, pressure: float = 0.0) -> tuple[Inflation, Lift]:
    body, places = envelope()
    lift = Lift(STEEPNESS, np.array([int(np.argmin(places[:, 2]))], dtype=np.int32))
    # film of k = 1 000 at the pressure over the length of the balloon
    stiff = film(1000.0)
    result = inflate(
        body, stiff, pressure, start=places, backend=backend, settings=AT_REST, model=BARE, lift=lift
    )
    assert result.report.converged
    return result, lift


def test_natural_shape() -> None:
    """V / L^3 0.126055, largest radius 0.32701 L at 0.5531 L along the meridian."""
    result, _ = lifted(BACKEND)
    assert result.volume == pytest.approx(0.126055, rel=0.01)
    radius = np.hypot(*result.positions[:, :2].T)
    assert radius.max() == pytest.approx(0.32701, rel=0.015)
    flat = np.tile(result.panel.rest_positions[:, 1], GORES)
    assert flat[np.argmax(radius)] == pytest.approx(0.5531, abs=0.03)


def test_it_pulls_at_its_foot_with_gradient_times_volume() -> None:
    result, lift = lifted(BACKEND)
    body, size = result.assembly, result.assembly.size
    split = split_assembly(body)
    scale = result.characteristic_pressure
    places = result.positions / size
    problem = with_lift(film_problem(body, film(1000.0), scale, BARE), split, 0.0, lift, places)
    free = replace(problem, fixed=problem.fixed & [False, False, False, True, True])
    shell = Shell(free)
    gradient, _ = shell.derivatives(places, result.directors, tangent_frames(result.directors))
    forces = np.zeros((len(places), 3))
    number, own = shell.number[:, 2], np.arange(len(places)) == free.tied
    forces[own, 2] = gradient[number[own]] * scale * size**2
    held = lift.places(split)
    between = facet_volume(result.positions, body.surface.triangles)
    assert forces[held, 2].sum() == pytest.approx(-STEEPNESS * between, rel=1e-3)
    assert np.abs(np.delete(forces[:, 2], held)).max() < 1e-3 * STEEPNESS * between


@needs_native
def test_both_solvers_agree() -> None:
    (one, _), (other, _) = (lifted(name, 20.0) for name in ("native", "numpy"))
    assert one.volume == pytest.approx(other.volume, rel=1e-6)
    assert one.report.newton_steps == other.report.newton_steps
    np.testing.assert_allclose(one.positions, other.positions, atol=1e-5)


def test_a_body_stands_up_by_itself() -> None:
    """Without a start: what is held comes to lie below."""
    body = bodies.box(1.0, 1.0, 2.0, 4)
    lift = Lift(50.0, np.arange(len(body.panels[0].rest_positions), dtype=np.int32)[:1])
    result = inflate(body, film(1000.0), 100.0, lift=lift)
    assert result.report.converged
    corner = result.positions[0]
    assert corner[2] == pytest.approx(result.positions[:, 2].min(), abs=0.05)
    middle = result.positions.mean(axis=0) - corner
    assert np.hypot(*middle[:2]) < 0.1 * middle[2]


@needs_native
def test_changes_with_the_flat_film() -> None:
    """Of both solvers alike, and those of balloons inflated again."""
    body, places = envelope(16, 4)
    lift = Lift(STEEPNESS, np.array([int(np.argmin(places[:, 2]))], dtype=np.int32))
    stiff, gore = film(1000.0), body.panels[0]
    result = inflate(body, stiff, 50.0, start=places, lift=lift, settings=NEARLY)
    moves = np.concatenate([panel.rest_positions * (1.0, 0.0) for panel in body.panels])[:, :, None]
    one, other = (position_changes(result, stiff, moves, name).changes for name in ("native", "numpy"))
    np.testing.assert_allclose(one, other, atol=1e-5 * np.abs(other).max())
    step, again = 1e-4, []
    for part in (step, -step):
        wider = replace(
            body, panels=(replace(gore, rest_positions=gore.rest_positions * (1.0 + part, 1.0)),) * GORES
        )
        near = replace(result, assembly=wider)
        again.append(inflate(wider, stiff, 50.0, start=near, lift=lift, settings=NEARLY).positions)
    found = (again[0] - again[1]) / (2.0 * step)
    assert np.linalg.norm(found - one[:, :, 0]) < 1e-4 * np.linalg.norm(found)


@pytest.mark.parametrize(
    ("lift", "pressure", "text"),
    [
        (Lift(-1.0, np.array([0], dtype=np.int32)), 100.0, "gradient of 0 or more"),
        (Lift(1.0, np.array([], dtype=np.int32)), 100.0, "Give those of its lower end"),
        (Lift(1.0, np.array([10**6], dtype=np.int32)), 100.0, "Give those of its lower end"),
        (Lift(1.0, np.array([0], dtype=np.int32)), -0.5, "0 or more"),
    ],
)
def test_what_does_not_suit_is_refused(lift: Lift, pressure: float, text: str) -> None:
    with pytest.raises(InputError, match=text):
        inflate(bodies.box(1.0, 1.0, 1.0, 3), film(100.0), pressure, lift=lift)


def test_two_equal_panels_have_no_lower_end() -> None:
    with pytest.raises(InputError, match="lie flat"):
        inflate(panel("disc", 60), film(100.0), 100.0, lift=Lift(1.0, np.array([0], dtype=np.int32)))

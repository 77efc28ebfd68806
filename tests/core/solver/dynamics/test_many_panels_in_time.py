# SPDX-License-Identifier: LGPL-2.1-or-later
"""Balloons of many panels blown up in time: from pressed flat to the same rest as without time."""

from itertools import pairwise

import bodies
import numpy as np
import pytest

from BalloonWorkbench.core.errors import AssemblyError
from BalloonWorkbench.core.film.library import films
from BalloonWorkbench.core.panels.assembly import Assembly
from BalloonWorkbench.core.solver.dynamics.animation import Frame, inflate_in_time
from BalloonWorkbench.core.solver.element.kinematics import (
    deformation_gradients,
    facet_volume,
    green_strains,
)
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.lift import Lift
from BalloonWorkbench.core.types import Floats

MYLAR = films()["mylar"]
PRESSURE = 2000.0
ALONG = np.array([0.3, 0.1, 2.0])  # where the balloons lie: no axis of theirs is the origin's


def cube() -> Assembly:
    return bodies.box(0.2, 0.2, 0.2, 6)


def volume(assembly: Assembly, frame: Frame) -> float:
    return facet_volume(frame.positions, assembly.surface.triangles)


def largest_strain(assembly: Assembly, positions: Floats) -> float:
    """The larger principal Green strain, the mean of all triangles."""
    surface = assembly.surface
    corners = surface.rest_positions[surface.triangles]
    edges = corners[:, 1:] - corners[:, :1]
    inverse = np.linalg.inv(edges)  # rows: edges; so that columns are the gradients of corners 1 and 2
    shape = np.stack([-inverse.sum(axis=2), inverse[:, :, 0], inverse[:, :, 1]], axis=1)
    strains = green_strains(deformation_gradients(positions, surface.triangles, shape))
    e11, e22, e12 = strains[:, 0], strains[:, 1], 0.5 * strains[:, 2]
    return float((0.5 * (e11 + e22) + np.hypot(0.5 * (e11 - e22), e12)).max())


@pytest.fixture(scope="module")
def blown() -> tuple[Inflation, Inflation, tuple[Frame, ...]]:
    """A cube at rest, lying somewhere, and blown up in time."""
    still = inflate(cube(), MYLAR, PRESSURE)
    places = still.positions + ALONG
    return still, *inflate_in_time(still.assembly, MYLAR, PRESSURE, frames=20, start=places)


def test_it_comes_to_the_rest_that_is_known(blown: tuple[Inflation, Inflation, tuple[Frame, ...]]) -> None:
    still, balloon, frames = blown
    assert balloon.report.backend == "newmark"
    assert balloon.report.converged
    assert balloon.volume == pytest.approx(still.volume, rel=1e-3)
    assert balloon.positions == pytest.approx(still.positions + ALONG, abs=5e-4)
    assert np.array_equal(frames[-1].positions, balloon.positions)


def test_it_begins_flat_and_slack_and_does_not_jump(
    blown: tuple[Inflation, Inflation, tuple[Frame, ...]],
) -> None:
    _, balloon, frames = blown
    assembly = balloon.assembly
    volumes = np.array([volume(assembly, frame) for frame in frames])
    assert len(frames) == 20
    assert frames[0].time == frames[0].pressure == 0.0
    assert frames[-1].pressure == PRESSURE
    assert abs(volumes[0]) < 0.01 * volumes[-1]
    assert np.ptp(frames[0].positions, axis=0).min() < 0.01 * assembly.size
    # pressing together stretches nothing
    at_rest = largest_strain(assembly, balloon.positions)
    assert largest_strain(assembly, frames[0].positions) <= 1.01 * at_rest
    assert np.diff(volumes).min() > -0.02 * volumes[-1]
    strides = [np.abs(after.positions - before.positions).max() for before, after in pairwise(frames)]
    assert max(strides) < 3.0 * assembly.size / len(frames)


def test_seams_stay_closed(blown: tuple[Inflation, Inflation, tuple[Frame, ...]]) -> None:
    _, balloon, frames = blown
    assembly = balloon.assembly
    for seam in assembly.seams:
        one, other = (side.vertices + assembly.offsets[side.panel] for side in (seam.first, seam.second))
        assert frames[7].positions[one] == pytest.approx(frames[7].positions[other], abs=1e-12)


def test_a_start_is_found_where_none_is_known() -> None:
    assembly = cube()
    balloon, frames = inflate_in_time(assembly, MYLAR, PRESSURE, frames=3)
    assert balloon.report.converged
    assert volume(assembly, frames[0]) < 0.01 * balloon.volume


def test_what_holds_a_balloon_with_lift_stays() -> None:
    """Held by its pole it is pressed from the side."""
    assembly = bodies.gored_sphere(6, 12, 2)
    tips = [seam.first.vertices[0] + assembly.offsets[seam.first.panel] for seam in assembly.seams]
    lift = Lift(2000.0, np.array(tips[:1], dtype=np.int32))
    still = inflate(assembly, MYLAR, 200.0, lift=lift)
    balloon, frames = inflate_in_time(assembly, MYLAR, 200.0, frames=6, start=still.positions, lift=lift)
    assert balloon.report.converged
    assert balloon.volume == pytest.approx(still.volume, rel=3e-3)
    assert frames[-1].pressure == pytest.approx(still.largest_pressure, rel=1e-3)
    assert abs(volume(assembly, frames[0])) < 0.01 * still.volume
    for frame in frames:
        assert frame.positions[lift.held] == pytest.approx(still.positions[lift.held], abs=1e-9)


def test_two_bodies_are_refused() -> None:
    one = cube()
    both = Assembly(
        one.panels * 2,
        one.seams
        + tuple(
            type(seam)(
                type(seam.first)(seam.first.panel + 6, seam.first.vertices),
                type(seam.second)(seam.second.panel + 6, seam.second.vertices),
            )
            for seam in one.seams
        ),
    )
    with pytest.raises(AssemblyError, match="2 bodies"):
        inflate_in_time(both, MYLAR, PRESSURE)

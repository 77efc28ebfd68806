# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results of balloons of many panels: loads against closed forms and balances, each panel, files."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import bodies
import numpy as np
import pytest
from solver_cases import PRESSURE, film

from BalloonWorkbench.core.making.safety import FILM, WELD, safety_with
from BalloonWorkbench.core.results import colour_map
from BalloonWorkbench.core.results.film_state import film_state
from BalloonWorkbench.core.results.panel_states import panel_states
from BalloonWorkbench.core.results.result_files import results
from BalloonWorkbench.core.results.self_contact import self_contact
from BalloonWorkbench.core.results.single_panels import single_panels
from BalloonWorkbench.core.results.stl import balloon_mesh, enclosed_volume
from BalloonWorkbench.core.results.strength import loads, seam_forces
from BalloonWorkbench.core.solver.element.kinematics import facet_volume
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.lift import Lift

FOIL = film(1000.0, seal_width=0.02)
HEIGHT = 4.0


@cache
def tube(rows: int = 6) -> Inflation:
    """A drum of radius 1, 4 high: its band is a tube."""
    return inflate(bodies.drum(HEIGHT, rows), FOIL, PRESSURE)


@cache
def sphere() -> Inflation:
    return inflate(bodies.gored_sphere(16, 24, 4), FOIL, PRESSURE)


def test_hoop_of_a_tube() -> None:
    """p r round it, p r / 2 along it; its closing seam bears p r, too."""
    inflation = tube()
    band = single_panels(inflation)[2]
    middle = np.abs(band.panel.rest_positions[band.panel.triangles].mean(axis=1)[:, 1] - 0.5 * HEIGHT) < 0.5
    state, last = film_state(inflation, FOIL), slice(-len(middle), None)
    top, bottom = (part.positions.mean(axis=0) for part in single_panels(inflation)[:2])
    lengthwise = (state.direction[last][middle] @ (top - bottom) / np.linalg.norm(top - bottom)) ** 2
    larger, smaller = state.tensions[last][middle].T
    assert np.mean(larger * (1.0 - lengthwise) + smaller * lengthwise) == pytest.approx(PRESSURE, rel=0.02)
    assert np.mean(larger * lengthwise + smaller * (1.0 - lengthwise)) == pytest.approx(
        0.5 * PRESSURE, rel=0.02
    )
    ((rim, steps, forces),) = seam_forces(band, FOIL)
    flat = band.panel.rest_positions[rim]
    own = 0.5 * (steps + np.roll(steps, 1))
    for side in (flat[:, 0] < 1e-9, flat[:, 0] > flat[:, 0].max() - 1e-9):
        here = side & (np.abs(flat[:, 1] - 0.5 * HEIGHT) < 0.5)
        assert np.linalg.norm(forces[here].sum(axis=0)) / own[here].sum() == pytest.approx(PRESSURE, rel=0.05)
    found = loads(inflation, FOIL)
    assert found.weld.value > PRESSURE
    assert found.film.value >= found.weld.value


def test_a_sphere_is_in_balance_across_its_equator() -> None:
    """The forces of the northern halves of all gores hold p pi R^2, as much as the round section asks for."""
    inflation = sphere()
    state = film_state(inflation, FOIL)
    surface = inflation.assembly.surface
    corners = inflation.positions[surface.triangles]
    low, high = corners[:, :, 2].min(axis=1), corners[:, :, 2].max(axis=1)
    total, level = 0.0, 1e-4
    for triangle in np.flatnonzero((low < level) & (high > level)):
        places = corners[triangle]
        cut = []
        for one, other in ((0, 1), (1, 2), (2, 0)):
            a, b = places[one], places[other]
            if (a[2] - level) * (b[2] - level) < 0.0:
                cut.append(a + (level - a[2]) / (b[2] - a[2]) * (b - a))
        across = cut[1] - cut[0]
        first = state.direction[triangle]
        normal = np.cross(places[1] - places[0], places[2] - places[0])
        second = np.cross(normal / np.linalg.norm(normal), first)
        out = np.cross(across, normal / np.linalg.norm(normal))
        for axis, tension in zip((first, second), state.tensions[triangle]):
            total += tension * abs(axis @ out) * abs(axis[2])
    ring = inflation.positions[np.abs(inflation.positions[:, 2]) < 0.02]
    radius = np.hypot(*ring[:, :2].T).mean()
    assert total == pytest.approx(PRESSURE * np.pi * radius**2, rel=0.04)


def test_the_safe_pressure_does_not_depend_on_the_mesh() -> None:
    """And is no more than what a tube of this film bears: limit / (margin r)."""
    strong = replace(FOIL, max_stress=500.0 / FOIL.thickness)
    coarse, fine = (safety_with(tube(rows), strong, 300.0, 2.0) for rows in (6, 10))
    assert coarse.weakest in (FILM, WELD)
    assert coarse.safe_pressure is not None
    assert fine.safe_pressure is not None
    assert fine.safe_pressure == pytest.approx(coarse.safe_pressure, rel=0.12)
    assert fine.safe_pressure <= 300.0 / 2.0


def test_a_limit_that_is_passed_lowers_the_pressure() -> None:
    weak = safety_with(tube(), FOIL, 60.0, 2.0)
    assert weak.weakest == WELD
    assert weak.safe_pressure is not None
    assert weak.safe_pressure < 30.0


def test_pressure_that_grows_upwards_pulls_harder() -> None:
    body = bodies.drum(HEIGHT, 5)
    disc = body.panels[1].rest_positions
    lift = Lift(25.0, body.offsets[1:2] + np.argmin(np.hypot(*disc.T)))
    plain, grown = inflate(body, FOIL, PRESSURE), inflate(body, FOIL, PRESSURE, lift=lift)
    assert grown.largest_pressure == pytest.approx(PRESSURE + 25.0 * np.ptp(grown.positions[:, 2]), rel=0.05)
    assert loads(grown, FOIL).film.value > 1.2 * loads(plain, FOIL).film.value
    found = safety_with(grown, FOIL, 1e5, 2.0)
    assert found.pressure == grown.largest_pressure


def test_each_panel_has_its_state() -> None:
    states = panel_states(tube(), FOIL)
    panels = tube().assembly.panels
    assert len(states) == len(panels) == 3
    for state in states:
        assert state.taut + state.wrinkled + state.slack == pytest.approx(1.0)
    assert states[0].area == pytest.approx(np.pi, rel=0.02)
    assert states[2].area == pytest.approx(2.0 * np.pi * HEIGHT, rel=0.01)
    assert states[2].taut > 0.5 > states[0].taut
    assert states[2].largest_tension > PRESSURE


def test_a_panel_with_its_other_side_out_is_turned() -> None:
    body = bodies.box(1.0, 1.0, 1.0, 3)
    first = single_panels(inflate(body, FOIL, PRESSURE))
    for one in first:
        a, b, c = np.moveaxis(one.positions[one.panel.triangles], 1, 0)
        outward = np.einsum("ij,ij->i", a - inflate_middle(first), np.cross(b - a, c - a))
        assert (outward > 0.0).all()


def inflate_middle(parts: tuple[Inflation, ...]) -> np.ndarray:  # type: ignore[type-arg]
    return np.concatenate([part.positions for part in parts]).mean(axis=0)


def test_files_have_all_panels() -> None:
    inflation = tube()
    found = results(inflation, FOIL)
    assert np.bincount(found.of_triangles["panel"]).tolist() == [
        len(panel.triangles) for panel in inflation.assembly.panels
    ]
    assert len(found.positions) == inflation.assembly.offsets[-1]
    assert colour_map.THICKNESS not in colour_map.kinds_of(inflation)
    for kind in colour_map.kinds_of(inflation):
        assert colour_map.film_map(found, kind).shares.shape == (len(found.triangles), 3)


def test_its_mesh_is_closed() -> None:
    positions, triangles = balloon_mesh(tube())
    edges = np.sort(np.concatenate([triangles[:, [k, (k + 1) % 3]] for k in range(3)]), axis=1)
    assert (np.unique(edges, axis=0, return_counts=True)[1] == 2).all()
    facets = facet_volume(tube().positions, tube().assembly.surface.triangles)
    assert enclosed_volume(positions, triangles) == pytest.approx(facets, rel=1e-9)


@pytest.mark.parametrize("body", [tube, sphere])
def test_no_contact_where_there_is_none(body: object) -> None:
    assert callable(body)
    found = self_contact(body())
    assert not found.is_there
    assert found.place is None


def test_a_cap_pushed_through_the_other_side_is_found() -> None:
    inflation = sphere()
    places = inflation.positions.copy()
    places[places[:, 2] > 0.8, 2] -= 3.0
    found = self_contact(replace(inflation, positions=places))
    assert found.count > 20
    assert found.place is not None
    assert -1.1 < found.place[2] < 1.0

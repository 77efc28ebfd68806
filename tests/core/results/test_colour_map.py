# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colour maps: an even scale, round ticks, values where they belong; strength against a closed form."""

import numpy as np
import pytest
from eyes import EYES, lab

from BalloonWorkbench.core.design.compare import residual
from BalloonWorkbench.core.design.silhouette import silhouette
from BalloonWorkbench.core.design.visible_seam import trimmed
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.results import colour_map
from BalloonWorkbench.core.results.film_state import film_state, thickness
from BalloonWorkbench.core.results.result_files import results
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.problem import NewtonSettings

RADIUS, PRESSURE = 0.15, 2000.0


@pytest.fixture(scope="module")
def disc():
    """A round balloon 0.3 m wide when flat."""
    angle = np.linspace(0.0, 2.0 * np.pi, 120, endpoint=False)
    outline = Outline(RADIUS * np.column_stack([np.cos(angle), np.sin(angle)]))
    return inflate(triangulate(outline, 0.016), film("mylar"), PRESSURE, settings=NewtonSettings(1e-9))


def test_equal_steps_of_the_scale_look_equal():
    steps = np.diff(lab(colour_map.colours(np.linspace(0.0, 1.0, 10)) / 255.0)[:, 0])
    assert steps.min() > 0.75 * steps.mean()
    assert steps.max() < 1.25 * steps.mean()


@pytest.mark.parametrize("eye", EYES)
def test_more_is_lighter_to_every_eye(eye):
    light = lab(colour_map.colours(np.linspace(0.0, 1.0, 64)) / 255.0, eye)[:, 0]
    assert np.diff(light).min() > 0.0
    assert np.ptp(light) > 60.0


@pytest.mark.parametrize(
    ("top", "expected"),
    [(4.9, [0, 1, 2, 3, 4]), (10, [0, 2, 4, 6, 8, 10]), (333.0, [0, 100, 200, 300]), (0.05, None)],
)
def test_ticks_are_round(top, expected):
    found = colour_map.ticks(top)
    assert found == pytest.approx(expected if expected is not None else [0, 0.01, 0.02, 0.03, 0.04, 0.05])


def test_thickness_is_largest_in_the_middle(disc):
    found = results(disc, film("mylar"))
    shown = colour_map.film_map(found, colour_map.THICKNESS)
    assert shown.top == pytest.approx(1e3 * thickness(disc).max())
    corners = found.positions[found.triangles]
    thickest = corners[np.unravel_index(np.argmax(shown.shares), shown.shares.shape)]
    assert np.hypot(*thickest[:2]) < 12.0
    assert np.hypot(*shown.place[:2]) < 12.0
    at_rim = np.abs(corners[..., 2]) < 1e-6
    assert shown.shares[at_rim].max() < 1e-6


def test_tension_scale_leaves_out_only_a_few_triangles(disc):
    shown = colour_map.film_map(results(disc, film("mylar")), colour_map.TENSION)
    own = film_state(disc, film("mylar"))
    beyond = own.areas[own.tensions[:, 0] > shown.top].sum() / own.areas.sum()
    assert beyond <= 0.005
    assert shown.largest == pytest.approx(own.tensions.max())
    assert 0.0 <= shown.shares.min() <= shown.shares.max() <= 1.0


def test_states_have_three_colours(disc):
    shown = colour_map.film_map(results(disc, film("mylar")), colour_map.STATE)
    assert set(np.unique(shown.shares)) <= {0.0, 0.5, 1.0}
    assert len(np.unique(shown.shares)) >= 2


def test_distances_are_those_of_two_circles(disc):
    """The silhouette of a round balloon is nearly a circle; a drawing 4 mm larger is 4 mm away."""
    rim = np.linalg.norm(trimmed(disc).positions[disc.panel.loops[0], :2], axis=1).mean()
    angle = np.linspace(0.0, 2.0 * np.pi, 720, endpoint=False)
    drawing = Outline((rim + 0.004) * np.column_stack([np.cos(angle), np.sin(angle)]))
    found = colour_map.distances(disc, drawing)
    assert np.concatenate(found.distances).mean() == pytest.approx(4.0, abs=0.2)
    place, nearest, largest = found.largest
    assert 1e3 * np.linalg.norm(nearest - place) == pytest.approx(largest)


def test_the_largest_distance_is_that_of_the_residual(disc):
    """A square round the disc: its corners are farther from the silhouette than that is from it."""
    rim = np.linalg.norm(trimmed(disc).positions[disc.panel.loops[0], :2], axis=1).mean()
    square = Outline(rim * np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]))
    place, corner, largest = colour_map.distances(disc, square).largest
    assert largest == pytest.approx(1e3 * residual(square, silhouette(trimmed(disc))).max, rel=0.01)
    assert largest == pytest.approx(1e3 * rim * (np.sqrt(2.0) - 1.0), rel=0.02)
    assert np.abs(corner) == pytest.approx([rim, rim], rel=0.02)
    assert np.linalg.norm(place) == pytest.approx(rim, rel=0.02)


def test_tension_of_the_mylar_balloon(disc):
    """Along the meridians p a^2 / (2 s), with s the distance from the pole in the film.

    The parallels bear nothing, so the force across each of them is the same, and the equator with radius a
    carries p pi a^2 (W. Paulsen, "What is the shape of a Mylar balloon?", Am. Math. Monthly 101, 1994).
    """
    rim = np.linalg.norm(disc.positions[disc.panel.loops[0], :2], axis=1).mean()
    state = film_state(disc, film("mylar"))
    flat = np.linalg.norm(disc.panel.rest_positions[disc.panel.triangles].mean(axis=1), axis=1)
    ring = (flat > 0.6 * RADIUS) & (flat < 0.8 * RADIUS)
    told = PRESSURE * rim**2 / (2.0 * flat[ring])
    share = state.areas[ring] / state.areas[ring].sum()  # the crumpled film shares the load unevenly
    assert share @ (state.tensions[ring, 0] / told) == pytest.approx(1.0, abs=0.03)

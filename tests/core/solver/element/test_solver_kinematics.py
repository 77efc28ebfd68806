# SPDX-License-Identifier: LGPL-2.1-or-later
"""Geometry of the deformed film: strains, volumes, start shapes."""

import numpy as np
import pytest
from solver_cases import grid, panel, vertex_areas

from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.solver.element.dkt import gradients
from BalloonWorkbench.core.solver.element.kinematics import (
    deformation_gradients,
    facet_volume,
    film_volume,
    green_strains,
    sag_volume,
)
from BalloonWorkbench.core.solver.start import DOME, dome, vertex_normals
from BalloonWorkbench.core.types import Floats


def test_strains_of_a_uniform_stretch() -> None:
    points, triangles = grid(3, 2, 1.0, 1.0)
    stretch = np.array([[1.1, 0.2], [0.0, 0.9], [0.3, -0.1]])
    shape, areas = gradients(points[triangles])
    gradient = deformation_gradients(points @ stretch.T, triangles, shape)
    assert areas.sum() == pytest.approx(1.0)
    assert gradient == pytest.approx(np.broadcast_to(stretch, gradient.shape))
    green = 0.5 * (stretch.T @ stretch - np.eye(2))
    expected = [green[0, 0], green[1, 1], 2.0 * green[0, 1]]
    assert green_strains(gradient) == pytest.approx(np.broadcast_to(expected, (len(triangles), 3)))


def cap(disc: Panel) -> tuple[Floats, Floats]:
    """The disc wrapped onto a hemisphere of radius 1, with its normals."""
    rest = disc.rest_positions
    radius = np.linalg.norm(rest, axis=1)
    angle = 0.5 * np.pi * radius
    out = rest / np.maximum(radius, 1e-12)[:, None]
    points = np.column_stack([np.sin(angle)[:, None] * out, np.cos(angle)])
    return points, points


def test_facets_and_sag_make_up_a_hemisphere() -> None:
    """The facets lose what lies above them; the directors give it back."""
    disc = panel("disc", 400)
    points, normals = cap(disc)
    exact = 2.0 * np.pi / 3.0
    facets = facet_volume(points, disc.triangles)
    assert facets < 0.995 * exact
    assert facets + sag_volume(points, normals, disc.triangles) == pytest.approx(exact, rel=0.002)


def test_inextensible_fibres_keep_half_the_sag() -> None:
    """A tube of chords of the film's own length is too narrow by its perimeter: pi r^2 from half the sag."""
    chords = 24
    points, triangles = grid(1, chords, 1.0, np.pi)
    angle = np.pi - points[:, 1]
    normals = np.column_stack([np.zeros_like(angle), np.cos(angle), np.sin(angle)])
    radius = np.pi / chords / (2.0 * np.sin(0.5 * np.pi / chords))  # chords as long as the arcs
    tube = radius * normals + np.column_stack([points[:, 0], np.zeros_like(angle), np.zeros_like(angle)])
    # the facets end at x = 0 and 1: the volume under them is the area times the length
    area = facet_volume(tube, triangles) + _end(tube, points)
    assert area == pytest.approx(0.5 * np.pi * (1.0 - (np.pi / chords) ** 2 / 12.0), rel=1e-4)
    whole = film_volume(tube, normals, triangles) + _end(tube, points)
    assert whole == pytest.approx(0.5 * np.pi, rel=1e-5)


def _end(tube: Floats, rest: Floats) -> float:
    """Volume of the pyramid from the origin over the open end at x = 1, which facet_volume leaves out."""
    y, z = tube[rest[:, 0] == 1.0, 1:].T
    return float(abs(np.sum(y[:-1] * z[1:] - y[1:] * z[:-1]))) / 6.0


def test_dome_of_a_strip_is_as_high_as_its_tube() -> None:
    """u = w^2 / 8 in the middle of a long strip of width w: z = w / pi."""
    strip = panel("rectangle")
    start = dome(strip)
    middle = np.abs(strip.rest_positions[:, 0]) < 0.3
    assert start[middle, 2].max() == pytest.approx(1.0 / np.pi, rel=0.02)
    assert start[:, :2] == pytest.approx(strip.rest_positions)


def test_dome_of_a_disc() -> None:
    """u = (1 - r^2) / 4, the seams flat, all else above."""
    disc = panel("disc")
    start = dome(disc)
    exact = DOME * 0.5 * np.sqrt(np.maximum(1.0 - (disc.rest_positions**2).sum(axis=1), 0.0))
    assert start[:, 2] == pytest.approx(exact, abs=0.01)
    rim = disc.loops[0]
    assert not start[rim, 2].any()
    assert np.delete(start[:, 2], rim).min() > 0.0


def test_normals_of_a_sphere() -> None:
    disc = panel("disc")
    points, exact = cap(disc)
    normals = vertex_normals(points, disc)
    inner = np.setdiff1d(np.arange(len(points)), disc.loops[0])
    assert np.linalg.norm(normals, axis=1) == pytest.approx(1.0)
    assert np.einsum("ij,ij->i", normals, exact)[inner].min() > 0.999
    assert vertex_areas(disc.rest_positions, disc.triangles).sum() == pytest.approx(np.pi, rel=0.001)

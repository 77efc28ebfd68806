# SPDX-License-Identifier: LGPL-2.1-or-later
"""Distances of the film from the profile or the drawing, against those of plain geometry."""

import io
from dataclasses import replace

import numpy as np
import pytest
from solids import box

from BalloonWorkbench.core.bag_design.bag_design import BagDesign
from BalloonWorkbench.core.bag_design.gore_fit import inflate_gores
from BalloonWorkbench.core.bag_design.inflate_bag import inflate_bag
from BalloonWorkbench.core.bodies.banded import band_joints, band_places, banded_bag
from BalloonWorkbench.core.bodies.profile import DISC, OPEN, Profile
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.geometry.vectors import direction
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.results.colour_map import DISTANCE, distance_map, kinds_of
from BalloonWorkbench.core.results.off_target import off_target
from BalloonWorkbench.core.results.result_files import results, results_bytes
from BalloonWorkbench.core.segmentation.divide import divide
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.target_design.fit_target import inflate_target

RADIUS, HEIGHT = 0.2, 0.5


@pytest.fixture(scope="module")
def drum() -> BagDesign:
    """A disc below, open above."""
    profile = Profile(np.array([(RADIUS, 0.0), (RADIUS, HEIGHT)]), DISC, OPEN)
    return inflate_gores(profile, 6, film("mylar"), 1000.0, mesh_size=0.05)


def distances(design: BagDesign) -> np.ndarray:  # type: ignore[type-arg]
    found = off_target(design)
    assert found is not None and found.shape == (len(design.inflation.positions),)
    return found


def test_gores_of_a_cylinder_and_its_ends(drum: BagDesign) -> None:
    positions, offsets = drum.inflation.positions, drum.inflation.assembly.offsets
    gores = slice(0, offsets[6])
    radial = np.hypot(positions[gores, 0], positions[gores, 1]) - RADIUS
    between = (positions[gores, 2] > 0.0) & (positions[gores, 2] < HEIGHT)
    assert distances(drum)[gores][between] == pytest.approx(radial[between], abs=1e-12)
    lower = slice(offsets[6], offsets[7])
    assert distances(drum)[lower] == pytest.approx(-positions[lower, 2], abs=1e-12)
    assert not distances(drum)[offsets[7] :].any()  # nothing is cut there


def test_the_largest_and_the_mean_are_those_of_the_design(drum: BagDesign) -> None:
    assert drum.residual is not None
    gores = np.abs(distances(drum)[: drum.inflation.assembly.offsets[6]])
    assert gores.max() == pytest.approx(drum.residual.max, rel=1e-9)
    assert gores.mean() == pytest.approx(drum.residual.mean, rel=0.5)


def test_a_letter_by_its_silhouette() -> None:
    """A disc of film with a band round it has a round shadow, as far from the drawing all round."""
    count = 120
    drawing = Outline(0.1 * direction(2.0 * np.pi * np.arange(count) / count))
    joints = band_joints(drawing.loops)
    bag = banded_bag(drawing, 0.05, joints=joints)
    places = band_places(drawing.loops, joints, 0.05)
    made = replace(inflate_bag(bag, film("mylar"), 1000.0, places=places, mesh_size=0.02), source=drawing)
    middle = made.inflation.positions[:, :2].mean(axis=0)
    widest = np.hypot(*(made.inflation.positions[:, :2] - middle).T).max()
    assert np.abs(np.median(distances(made)) - (widest - 0.1)) < 3e-3
    smaller = replace(made, source=drawing.map(lambda loop: 0.5 * loop))
    larger = replace(made, source=drawing.map(lambda loop: 2.0 * loop))
    assert (distances(smaller) > 0.0).all() and (distances(larger) < 0.0).all()
    assert np.median(distances(larger)) == pytest.approx(widest - 0.2, abs=3e-3)


def test_a_bag_as_it_is_has_none(drum: BagDesign) -> None:
    assert off_target(replace(drum, source=drum.bag)) is None


def test_the_map_and_the_file(drum: BagDesign) -> None:
    found = results(drum.inflation, film("mylar"), distances(drum))
    assert found.of_vertices["distance_mm"] == pytest.approx(1e3 * distances(drum))
    assert drum.residual is not None
    shown = distance_map(found, drum.residual)
    assert shown.largest == pytest.approx(1e3 * drum.residual.max) and shown.unit == "mm"
    assert shown.shares.min() >= 0.0 and shown.shares.max() == 1.0
    assert shown.top == pytest.approx(2e3 * drum.residual.p95) or shown.top < 2e3 * drum.residual.p95
    assert distance_map(found, None).top == pytest.approx(np.abs(found.of_vertices["distance_mm"]).max())
    assert DISTANCE in kinds_of(drum.inflation, compared=True)
    assert DISTANCE not in kinds_of(drum.inflation)
    with np.load(io.BytesIO(results_bytes(drum.inflation, film("mylar"), "npz", distances(drum)))) as written:
        assert written["distance_mm"] == pytest.approx(1e3 * distances(drum))
    assert b'Name="distance_mm"' in results_bytes(drum.inflation, film("mylar"), "vtu", distances(drum))


def test_a_cube_bulges_over_its_faces() -> None:
    """Face centres are .1077 of the edge outside, corners inside (reference solution, stiff film)."""
    division = divide(box((1.0, 1.0, 1.0), 4), 6)
    design = inflate_target(division, film("mylar"), 5.0, mesh_size=0.09, model=Model(bending=False))
    away = distances(design)
    assert away.max() == pytest.approx(0.1077, rel=0.1)
    assert away.min() < 0.0
    assert b"distance_mm" in results_bytes(design.inflation, film("mylar"), "vtu", away)

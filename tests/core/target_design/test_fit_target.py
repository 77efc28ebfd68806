# SPDX-License-Identifier: LGPL-2.1-or-later
"""Divided targets: the corrected balloon lies on the body as nearly as laws and known answers say."""

from __future__ import annotations

import numpy as np
import pytest
from divided import box_faces, gored_ball, octants, torus_panels
from known_answers import answer, apart, random_bag

from BalloonWorkbench.core.bag_design.bag_design import BagDesign
from BalloonWorkbench.core.bag_pattern.copies import panel_copies
from BalloonWorkbench.core.bags.check_bag import check_bag
from BalloonWorkbench.core.bags.division import side_line
from BalloonWorkbench.core.film.library import film as film_named
from BalloonWorkbench.core.geometry.polyline import length, signed_area
from BalloonWorkbench.core.options.body import ENCLOSE, INSIDE
from BalloonWorkbench.core.results.body_figures import body_figures
from BalloonWorkbench.core.target_design.fit_target import TargetMode, fit_target, inflate_target
from BalloonWorkbench.core.units import length_text

POLYESTER = film_named("mylar")
PRESSURE = 1000.0


def mean_of(design: BagDesign) -> float:
    """Mean distance from the target, in parts of the diagonal."""
    assert design.residual is not None
    return design.residual.mean / design.size


def test_six_gores_come_as_near_to_a_ball_as_the_law_says() -> None:
    design = fit_target(gored_ball(6), POLYESTER, PRESSURE)
    assert mean_of(design) <= 0.16 / 6**2
    assert design.reached
    assert design.passes <= 8
    radii = np.linalg.norm(design.inflation.positions - design.inflation.positions.mean(axis=0), axis=1)
    assert radii.mean() == pytest.approx(1.0, abs=0.01)
    check_bag(design.bag, POLYESTER.seal_width, opening_needed=True)


def test_a_ring_is_twice_as_near_as_without_correction() -> None:
    division = torus_panels()
    plain, design = (make(division, POLYESTER, PRESSURE) for make in (inflate_target, fit_target))
    assert mean_of(design) <= 0.5 * mean_of(plain)
    for seam in design.bag.seams:
        one = length(side_line(design.bag, seam.a, against=False))
        assert length(side_line(design.bag, seam.b, against=True)) == pytest.approx(one, rel=1e-12)


def test_a_box_cannot_be_flat_and_says_so() -> None:
    design = fit_target(box_faces(), POLYESTER, PRESSURE, mesh_size=0.12)
    assert not design.reached
    assert "flat panels bulge between their seams. Take more than 6 panels." in design.warnings[0]
    assert "the film stays" in design.warnings[1]


def test_panels_of_an_inflated_bag_come_back() -> None:
    """The balloon of a bag is the target, divided along its seams: the bag is the answer.

    Lengths and areas within what edges of two meshes are shorter than the curves.
    """
    known = answer(octants((1.0, 1.3, 0.8)), POLYESTER, PRESSURE)
    found = fit_target(known.division, POLYESTER, PRESSURE)
    assert mean_of(found) < 3e-4
    differ = apart(known.bag, found.bag, found.size)
    assert differ.outlines < 6e-4
    assert differ.lengths < 2.5e-3
    assert differ.areas < 4e-3


@pytest.mark.slow
def test_the_balloon_of_a_random_bag_comes_back() -> None:
    """Its panels need not: where seams wrinkle, longer ones make the same balloon."""
    known = random_bag(2, POLYESTER, PRESSURE)
    found = fit_target(known.division, POLYESTER, PRESSURE)
    assert mean_of(found) < 1e-3
    assert found.inflation.volume == pytest.approx(known.division.target.volume, rel=5e-3)


def test_gores_of_a_ball_are_equal_and_their_own_images() -> None:
    found = fit_target(gored_ball(6), POLYESTER, PRESSURE, mesh_size=0.2)
    areas = np.array([signed_area(panel.outer) for panel in found.bag.panels])
    assert np.ptp(areas) < 1e-9 * areas[0]
    assert [copies.panels for copies in panel_copies(found.bag)] == [tuple(range(6))]


@pytest.mark.slow
@pytest.mark.parametrize(("kind", "sense"), [(ENCLOSE, 1.0), (INSIDE, -1.0)])
def test_a_balloon_encloses_its_target_or_lies_inside_with_a_margin(kind: str, sense: float) -> None:
    design = fit_target(octants(), POLYESTER, PRESSURE, mode=TargetMode(kind, 0.05), mesh_size=0.15)
    radii = np.linalg.norm(design.inflation.positions - design.inflation.positions.mean(axis=0), axis=1)
    outside = sense * (radii - 1.0)
    assert outside.min() > 0.05 - 0.004, "all of the film; its vertices alone tell where its middle is"
    assert outside.mean() < 0.12
    figures = body_figures(design, POLYESTER)
    assert figures is not None
    assert (figures.inmost if kind == ENCLOSE else -figures.outmost) >= 0.05 - 2.1e-4 * design.size
    assert design.reached


def test_a_cover_that_panels_cannot_be_says_how_far_it_is_off() -> None:
    """Flat faces bulge over a box, and its corners stay outside of them."""
    mode = TargetMode(ENCLOSE, 0.0)
    design = fit_target(box_faces(), POLYESTER, PRESSURE, mode=mode, mesh_size=0.2)
    figures = body_figures(design, POLYESTER)
    assert figures is not None
    assert design.reached == (figures.inmost >= -2.1e-4 * design.size)
    said = [warning for warning in design.warnings if "on the wrong side of the body" in warning]
    assert len(said) == (not design.reached)
    if said:
        assert length_text(-figures.inmost, 3) in said[0]

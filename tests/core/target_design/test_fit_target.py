# SPDX-License-Identifier: LGPL-2.1-or-later
"""Divided targets: the corrected balloon lies on the body as nearly as laws and known answers say."""

from __future__ import annotations

import numpy as np
import pytest
from divided import NO_CUTS, box_faces, gored_ball, octants, torus_panels

from BalloonWorkbench.core.bag_design.bag_design import BagDesign
from BalloonWorkbench.core.bags.bag import Bag
from BalloonWorkbench.core.bags.check_bag import check_bag
from BalloonWorkbench.core.bags.division import side_line
from BalloonWorkbench.core.bags.mesh_bag import default_size, mesh_bag
from BalloonWorkbench.core.film.library import film as film_named
from BalloonWorkbench.core.flattening.bag_of import bag_of
from BalloonWorkbench.core.flattening.flatten import flatten
from BalloonWorkbench.core.geometry.polyline import length, line_lengths, point_on
from BalloonWorkbench.core.geometry.vectors import alignment
from BalloonWorkbench.core.options.body import ENCLOSE, INSIDE
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.target_design.fit_target import TargetMode, fit_target, inflate_target
from BalloonWorkbench.core.targets.target import Division, Target
from BalloonWorkbench.core.types import Floats

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
    """The balloon of a bag is the target, divided along its seams: the bag is the answer."""
    wanted = bag_of(division := octants((1.0, 1.3, 0.8)), flatten(division))
    meshed = mesh_bag(wanted.bag, default_size(wanted.bag, 2500))
    balloon = inflate(meshed.assembly, POLYESTER, PRESSURE, start=wanted.on_target(meshed))
    surface = balloon.assembly.surface
    used, corners = np.unique(surface.first[surface.triangles], return_inverse=True)
    panels = np.repeat(np.arange(8, dtype=np.int32), [len(p.triangles) for p in meshed.assembly.panels])
    target = Target(balloon.positions[used], corners.reshape(-1, 3).astype(np.int32), "balloon")
    found = fit_target(Division(target, panels, division.names, NO_CUTS), POLYESTER, PRESSURE)
    assert mean_of(found) < 5e-4
    one, other = edges_of(wanted.bag), edges_of(found.bag)
    for panel in range(8):
        own = [key for key in one if key[0] == panel]
        before, after = (np.concatenate([edges[key] for key in own]) for edges in (one, other))
        turn, shift = alignment(before, after, np.ones(len(before)))
        assert np.linalg.norm(before @ turn.T + shift - after, axis=1).max() < 1e-3 * target.diagonal


def edges_of(bag: Bag) -> dict[tuple[int, int], Floats]:
    """Points along each side, by its panel and the one beside it, as the loop of the panel runs."""
    edges = {}
    for seam in bag.seams:
        edges[seam.a.panel, seam.b.panel] = _even(side_line(bag, seam.a, against=False))
        edges[seam.b.panel, seam.a.panel] = _even(side_line(bag, seam.b, against=True)[::-1])
    return edges


def _even(line: Floats) -> Floats:
    lengths = line_lengths(line)
    return point_on(line, lengths, np.linspace(0.0, lengths[-1], 30))


@pytest.mark.parametrize(("kind", "sense"), [(ENCLOSE, 1.0), (INSIDE, -1.0)])
def test_a_balloon_encloses_its_target_or_lies_inside_with_a_margin(kind: str, sense: float) -> None:
    design = fit_target(octants(), POLYESTER, PRESSURE, mode=TargetMode(kind, 0.05), mesh_size=0.15)
    radii = np.linalg.norm(design.inflation.positions - design.inflation.positions.mean(axis=0), axis=1)
    outside = sense * (radii - 1.0)
    assert np.quantile(outside, 0.02) > 0.05 - 0.006
    assert outside.mean() < 0.12

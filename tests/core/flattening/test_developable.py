# SPDX-License-Identifier: LGPL-2.1-or-later
"""Planes, cylinders, cones and extrusions laid flat exactly, whatever triangles they have."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from frustums import Z, frustum, turned

from BalloonWorkbench.core.bags.check_bag import check_bag
from BalloonWorkbench.core.flattening.bag_of import bag_of
from BalloonWorkbench.core.flattening.developable import (
    CYLINDER,
    EXTRUSION,
    Developable,
    face_flats,
)
from BalloonWorkbench.core.flattening.flatten import flatten
from BalloonWorkbench.core.flattening.unrolled import unrolled_panels
from BalloonWorkbench.core.geometry.polyline import line_lengths, signed_area


@pytest.mark.parametrize(("lower", "upper"), [(1.0, 1.0), (1.0, 0.0), (1.0, 0.4), (0.3, 1.0)])
def test_areas_and_seams_are_those_of_the_true_surface(lower: float, upper: float) -> None:
    height = 1.3
    division = frustum(lower, upper, height)
    slant = np.hypot(lower - upper, height)
    true = [np.pi * (lower + upper) * slant, np.pi * lower**2, np.pi * upper**2]
    assert abs(division.target.areas[division.panels == 1].sum() / true[1] - 1.0) > 0.01
    bag = bag_of(division, flatten(division), exact=True).bag
    check_bag(bag)
    for panel, area in zip(bag.panels, true):
        assert signed_area(panel.outer) == pytest.approx(area, rel=1e-6), panel.name
    for seam in bag.seams:
        sides = [
            bag.panels[side.panel].outer[side.points(bag.panels, against=side is seam.b)]
            for side in seam.sides
        ]
        one, other = (float(line_lengths(side)[-1]) for side in sides)
        assert one == pytest.approx(other, rel=1e-6)
    around = {"lower": 2.0 * np.pi * lower, "upper": 2.0 * np.pi * upper}
    for panel in bag.panels[1:]:
        ring = np.vstack([panel.outer, panel.outer[:1]])
        assert line_lengths(ring)[-1] == pytest.approx(around[panel.name], rel=1e-6)


def test_an_extrusion_unrolls_along_its_section() -> None:
    """A cylinder as an extrusion, whose section says how far along it points lie."""
    division = frustum(1.0, 1.0, 1.3)
    origin, axis = turned(np.zeros((1, 3)))[0], turned(Z[None])[0] - turned(np.zeros((1, 3)))[0]
    cylinder = Developable(CYLINDER, origin, axis, 1.0)
    same = Developable(EXTRUSION, origin, axis, 2.0 * np.pi, lambda at: cylinder.round_and_along(at)[0])
    plain = face_flats(division, [cylinder, None, None], np.zeros(0, dtype=np.intp), np.zeros((0, 3, 3)))
    made = face_flats(division, [same, None, None], np.zeros(0, dtype=np.intp), np.zeros((0, 3, 3)))
    np.testing.assert_allclose(made.corners, plain.corners, atol=1e-12)


def test_what_does_not_unroll_gets_the_lengths_of_what_does() -> None:
    """The side of a cylinder is given, its discs are not: they are flattened, and keep its lengths."""
    division = frustum(1.0, 1.0, 1.3)
    assert division.flats is not None
    corners = division.flats.corners.copy()
    corners[division.panels > 0] = np.nan
    kept = division.panels[division.flats.bent // 3] == 0
    flats = replace(
        division.flats, corners=corners, bent=division.flats.bent[kept], between=division.flats.between[kept]
    )
    partly = replace(division, flats=flats)
    assert list(unrolled_panels(partly)) == [0]
    bag = bag_of(partly, flatten(partly), exact=True).bag
    check_bag(bag)
    assert signed_area(bag.panels[0].outer) == pytest.approx(2.0 * np.pi * 1.3, rel=1e-6)
    assert signed_area(bag.panels[1].outer) == pytest.approx(np.pi, rel=2e-3)


def test_panels_that_were_merged_are_not_taken_for_unrolled() -> None:
    """A disc and the side of a cylinder as one panel: neither place is that of the panel."""
    division = frustum(1.0, 1.0, 1.3)
    merged = replace(
        division, panels=np.minimum(division.panels, 1) * 0 + (division.panels == 2), names=("a", "b")
    )
    assert list(unrolled_panels(merged)) == [1]


def test_a_larger_body_has_larger_flats() -> None:
    division = frustum(1.0, 0.4, 1.3).scaled(0.5)
    bag = bag_of(division, flatten(division), exact=True).bag
    assert signed_area(bag.panels[1].outer) == pytest.approx(0.25 * np.pi, rel=1e-6)

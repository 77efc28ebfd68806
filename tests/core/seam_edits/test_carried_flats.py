# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces that unroll stay exact when seams are drawn on them."""

from __future__ import annotations

import numpy as np
import pytest
from frustums import frustum

from BalloonWorkbench.core.bags.check_bag import check_bag
from BalloonWorkbench.core.flattening.bag_of import bag_of
from BalloonWorkbench.core.flattening.flatten import flatten
from BalloonWorkbench.core.flattening.unrolled import unrolled_panels
from BalloonWorkbench.core.geometry.polyline import signed_area
from BalloonWorkbench.core.seam_edits.imprint import edge_keys, split_division
from BalloonWorkbench.core.seam_edits.redivide import merged, redivided
from BalloonWorkbench.core.targets.half_edges import half_edges
from BalloonWorkbench.core.targets.refine import split_edges


@pytest.mark.parametrize(("lower", "upper"), [(1.0, 1.0), (1.0, 0.4)])
def test_triangles_that_are_split_change_no_area(lower: float, upper: float) -> None:
    """Every edge gets a point, not in its middle; then each face has the area of its formula."""
    division = frustum(lower, upper, 1.3)
    target = division.target
    low, high = np.sort(half_edges(target.triangles), axis=1).T
    places = target.points[low] + 0.3 * (target.points[high] - target.points[low])
    split = split_edges(target.points, target.triangles, np.ones(len(low), dtype=bool), places)
    finer = split_division(division, split)
    assert sorted(unrolled_panels(finer)) == [0, 1, 2]
    bag = bag_of(finer, flatten(finer), exact=True).bag
    check_bag(bag)
    true = [np.pi * (lower + upper) * np.hypot(lower - upper, 1.3), np.pi * lower**2, np.pi * upper**2]
    for panel, area in zip(bag.panels, true):
        assert signed_area(panel.outer) == pytest.approx(area, rel=1e-6)


def test_pieces_of_a_face_are_exact_and_merged_faces_are_flattened() -> None:
    division = frustum(1.0, 0.4, 1.3)
    around = np.unique(division.target.triangles[division.panels == 0])
    half = around[(around % 24) == 12]
    assert len(half) == 2
    there = edge_keys(half_edges(division.target.triangles), len(division.target.points))
    assert np.isin(edge_keys(half[None], len(division.target.points)), there).all()
    cut = redivided(division, half[None], slits=False)
    assert len(cut.names) == 4
    assert sorted(unrolled_panels(cut)) == [0, 1, 2, 3]
    bag = bag_of(cut, flatten(cut), exact=True).bag
    sides = [signed_area(bag.panels[number].outer) for number in (0, 3)]
    assert sides == pytest.approx([np.pi * 0.7 * np.hypot(0.6, 1.3)] * 2, rel=1e-6)
    one = merged(division, 0, 1, division.cuts)
    assert len(unrolled_panels(one)) == 1

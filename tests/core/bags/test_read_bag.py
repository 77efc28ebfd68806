# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bags written as JSON and read back; how they hang together."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from bag_volumes import box, octahedron

from BalloonWorkbench.core.bags.bag import Bag
from BalloonWorkbench.core.bags.read_bag import bag_json, read_bag
from BalloonWorkbench.core.bags.topology import Topology
from BalloonWorkbench.core.bodies.banded import banded_bag
from BalloonWorkbench.core.bodies.ready import READY, ready_bag
from BalloonWorkbench.core.outline.budget import Budget
from BalloonWorkbench.core.outline.outline import Outline

SQUARE = np.array([(0.0, 0.0), (3.0, 0.0), (3.0, 3.0), (0.0, 3.0)])
HOLE = np.array([(1.0, 1.0), (1.0, 2.0), (2.0, 2.0), (2.0, 1.0)])
RING = banded_bag(Outline(SQUARE, (HOLE,)), 0.5)


@pytest.mark.parametrize("bag", [*map(ready_bag, READY), RING], ids=[*READY, "ring"])
def test_round_trip(bag: Bag) -> None:
    bag = replace(bag, ease=0.01, panels=(replace(bag.panels[0], cut=False), *bag.panels[1:]))
    again = read_bag(bag_json(bag), Budget())
    assert (again.seams, again.opening, again.ease) == (bag.seams, bag.opening, bag.ease)
    for one, other in zip(bag.panels, again.panels, strict=True):
        assert (one.name, one.cut, len(one.holes)) == (other.name, other.cut, len(other.holes))
        for loop, same in zip(one.loops, other.loops, strict=True):
            np.testing.assert_allclose(loop, same, atol=1e-12)
    assert bag_json(again) == bag_json(read_bag(bag_json(again), Budget()))


def test_the_format_as_it_is_described() -> None:
    """Two squares face to face, in centimetres."""
    corners = "[[0, 0], [10, 0], [10, 10], [0, 10]]"
    pairs = ["0, 1] 0, 3", "1, 2] 3, 2", "2, 3] 2, 1", "3, 0] 1, 0"]
    seams = [f'{{"a": ["top", {a}], "b": ["down", {b}]}}' for a, b in (pair.split("] ") for pair in pairs)]
    panels = f'{{"name": "top", "outer": {corners}, "holes": []}}, {{"name": "down", "outer": {corners}}}'
    text = f"""{{"unit": "cm", "panels": [{panels}], "seams": [{", ".join(seams)}],
        "opening": {{"panel": "down", "at": 2}}}}"""
    bag = read_bag(text.encode(), Budget())
    np.testing.assert_allclose(bag.panels[1].outer[2], (0.1, 0.1))
    assert bag.opening is not None
    assert (bag.opening.panel, bag.opening.at) == (1, 2)
    assert Topology(bag).euler_number == 2
    assert not bag.notes
    assert "millimetres" in read_bag(text.replace('"unit": "cm", ', "").encode(), Budget()).notes[0]


@pytest.mark.parametrize(
    ("bag", "euler_number", "poles", "meeting"),
    [
        (box(1.0, 1.0, 1.0), 2, 8, 3),
        (octahedron(), 2, 6, 4),
        (ready_bag("cone"), 2, 1, 3),
        (ready_bag("beach-ball", gores=9), 2, 18, 3),
        (RING, 0, 4, 3),
    ],
    ids=["box", "octahedron", "cone", "ball", "ring"],
)
def test_topology(bag: Bag, euler_number: int, poles: int, meeting: int) -> None:
    topology = Topology(bag)
    assert topology.euler_number == euler_number
    assert topology.bodies == 1
    assert len(topology.poles) == poles
    assert all(len(corners) == meeting for corners in topology.poles)

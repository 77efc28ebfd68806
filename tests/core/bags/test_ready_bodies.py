# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ready bodies: their areas, panels and limits."""

from __future__ import annotations

import numpy as np
import pytest

from BalloonWorkbench.core.bags.bag import Bag
from BalloonWorkbench.core.bodies.ready import READY, ready_bag
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.polyline import signed_area


def area(bag: Bag) -> float:
    return sum(signed_area(loop) for panel in bag.panels for loop in panel.loops)


def names(bag: Bag) -> list[str]:
    return [panel.name for panel in bag.panels]


def test_boxes() -> None:
    bag = ready_bag("box", length=2.0, width=3.0, height=5.0)
    assert area(bag) == pytest.approx(2.0 * (6.0 + 10.0 + 15.0))
    assert bag.opening is not None
    top = bag.panels[bag.opening.panel]
    assert top.name == "top"
    np.testing.assert_array_equal(bag.panels[2].outer, bag.panels[3].outer)


def test_a_pillow_box() -> None:
    """What the ends of front and back are hollowed by, the flaps have."""
    bag = ready_bag("pillow-box", length=0.3, width=0.2, depth=0.08)
    assert area(bag) == pytest.approx(2.0 * 0.3 * 0.2)
    width, height = np.ptp(bag.panels[2].outer, axis=0)
    assert (width, height) == pytest.approx((0.2, 0.08), rel=1e-3)


def test_a_tetrahedron() -> None:
    assert area(ready_bag("tetrahedron", edge=2.0)) == pytest.approx(np.sqrt(3.0) * 4.0)


def test_a_cylinder() -> None:
    bag = ready_bag("cylinder", radius=1.0, height=3.0)
    assert area(bag) == pytest.approx(2.0 * np.pi * 3.0 + 2.0 * np.pi, rel=3e-4)


def test_a_cone() -> None:
    bag = ready_bag("cone", radius=1.0, slant=3.0)
    assert area(bag) == pytest.approx(np.pi * 3.0 + np.pi, rel=3e-4)


def test_a_pouch() -> None:
    bag = ready_bag("pouch", width=0.2, height=0.3, depth=0.1)
    assert area(bag) == pytest.approx(2.0 * 0.06 + 2.0 * 0.03 + 0.02)
    folds = [seam for seam in bag.seams if seam.a.panel == seam.b.panel]
    assert {names(bag)[seam.a.panel] for seam in folds} == {"left gusset", "right gusset"}
    assert any({names(bag)[side.panel] for side in seam.sides} == {"front", "back"} for seam in bag.seams)


def test_a_beach_ball() -> None:
    bag = ready_bag("beach-ball", diameter=1.0, gores=12, cap=0.2)
    assert len(bag.panels) == 14
    assert area(bag) == pytest.approx(np.pi, rel=0.01)
    np.testing.assert_array_equal(bag.panels[0].outer, bag.panels[11].outer)
    assert np.ptp(bag.panels[12].outer, axis=0) == pytest.approx((0.2, 0.2), rel=0.02)


@pytest.mark.parametrize("name", READY)
def test_numbers_have_names_and_usual_values(name: str) -> None:
    body = READY[name]
    sizes = {size.name: size.default for size in body.sizes}
    one, other = ready_bag(name), ready_bag(name, **sizes)
    assert one.seams == other.seams
    for size in body.sizes:
        assert area(ready_bag(name, **{size.name: size.default * 1.5})) != area(one)


@pytest.mark.parametrize(
    ("name", "sizes", "text"),
    [
        ("ball", {}, "no ready body 'ball'"),
        ("box", {"depth": 1.0}, "has no 'depth'"),
        ("box", {"length": 0.0}, "'length' .* out of range"),
        ("box", {"length": float("nan")}, "'length' .* out of range"),
        ("beach-ball", {"gores": 2}, "'gores' .* out of range"),
        ("beach-ball", {"cap": 0.39}, "too large"),
        ("cone", {"slant": 0.1}, "slant"),
        ("pillow-box", {"depth": 0.3}, "deeper"),
        ("pouch", {"depth": 0.7}, "deeper"),
    ],
)
def test_what_no_body_has(name: str, sizes: dict[str, float], text: str) -> None:
    with pytest.raises(InputError, match=text):
        ready_bag(name, **sizes)

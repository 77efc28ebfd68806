# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bags that cannot be made: one sentence each, which names the panel and the edge."""

from __future__ import annotations

import json
import time
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from bag_volumes import box

from BalloonWorkbench.core.bags.bag import Bag, BagPanel, BagSeam, Opening, Side
from BalloonWorkbench.core.bags.check_bag import check_bag
from BalloonWorkbench.core.bags.check_panel import check_thickness
from BalloonWorkbench.core.bags.mesh_bag import default_size, mesh_bag
from BalloonWorkbench.core.bags.read_bag import bag_json, read_bag
from BalloonWorkbench.core.bodies.gores import gored_bag
from BalloonWorkbench.core.bodies.profile import Profile
from BalloonWorkbench.core.bodies.ready import READY, ready_bag
from BalloonWorkbench.core.errors import AssemblyError, InputError
from BalloonWorkbench.core.outline.budget import Budget

Data = dict[str, Any]


def data_of(bag: Bag) -> Data:
    text: Data = json.loads(bag_json(bag))
    return text


def parsed(data: Any) -> Bag:
    return read_bag(json.dumps(data).encode(), Budget())


def seam_of(data: Data, panel: str, edge: int) -> tuple[Data, str]:
    """The seam and the side of an edge, counted from 0, of a box."""
    for seam in data["seams"]:
        for key in "ab":
            name, start, end = seam[key]
            if name == panel and (start if key == "a" else end) == edge:
                return seam, key
    raise AssertionError


def turned_round(data: Data) -> None:
    seam, key = seam_of(data, "front", 0)
    name, start, end = seam[key]
    seam[key] = [name, end, start]


def left_out(data: Data) -> None:
    data["seams"].remove(seam_of(data, "front", 1)[0])


def used_twice(data: Data) -> None:
    data["seams"].append(dict(seam_of(data, "front", 1)[0]))


def from_inside(data: Data) -> None:
    data["panels"][0]["outer"].reverse()


def longer(data: Data) -> None:
    data["panels"][0]["outer"][1][0] += 10.0
    data["panels"][0]["outer"][2][0] += 10.0


def folded(data: Data) -> None:
    outer = data["panels"][0]["outer"]
    outer[0], outer[1] = outer[1], outer[0]


def no_edge(data: Data) -> None:
    data["panels"][0]["outer"][1] = list(data["panels"][0]["outer"][0])


def no_seam(data: Data) -> None:
    seam, _ = seam_of(data, "front", 0)
    for key in "ab":
        seam[key][2] = seam[key][1]


def line(data: Data) -> None:
    data["panels"][0]["outer"] = [[0, 0], [1, 0], [2, 0], [3, 0]]


def two_bodies(data: Data) -> None:
    data["panels"] += [panel | {"name": f"other {panel['name']}"} for panel in data["panels"]]
    data["seams"] += [
        {key: [f"other {side[0]}", *side[1:]] for key, side in seam.items()} for seam in data["seams"]
    ]


def far_point(data: Data) -> None:
    data["panels"][0]["outer"][1][0] = 1e300


def hole_outside(data: Data) -> None:
    data["panels"][0]["holes"] = [[[2000, 0], [2000, 100], [2100, 100]]]


def hole_turned(data: Data) -> None:
    data["panels"][0]["holes"] = [[[300, 200], [310, 200], [310, 210]]]


def hole_unsealed(data: Data) -> None:
    data["panels"][0]["holes"] = [[[200, 200], [200, 300], [300, 300]]]


def hole_meant(data: Data) -> None:
    seam, key = seam_of(data, "front", 0)
    seam[key].append(1)


def point_beyond(data: Data) -> None:
    seam, key = seam_of(data, "front", 0)
    seam[key][1] = 4


def opening_beyond(data: Data) -> None:
    data["opening"]["at"] = 4


REFUSED: list[tuple[Callable[[Data], None], str]] = [
    (turned_round, r"seam \d+ runs the wrong way at edge \d of panel '.*Moebius.* Swap"),
    (left_out, r"Edge \d of panel '(front|right)' is in no seam"),
    (used_twice, r"Edge \d of panel '(front|right)' is in seams \d+ and 13"),
    (from_inside, r"Panel 'bottom' is seen from inside"),
    (
        longer,
        r"seam \d+ are not equally long: 1010 mm at edge 3 of panel 'bottom', 1000 mm at edge 1 of panel",
    ),
    (folded, r"Panel 'bottom' is folded over: edge \d of panel 'bottom' crosses"),
    (no_edge, r"Edge 1 of panel 'bottom' has no length"),
    (no_seam, r"Seam \d+ has no length: .* edge \d of panel"),
    (line, r"Panel 'bottom' has no area"),
    (two_bodies, r"2 bodies: panel 'other bottom' does not hang together with panel 'bottom'"),
    (far_point, r"Panel 'bottom' has a point"),
    (hole_outside, r"Hole 1 of panel 'bottom' lies outside"),
    (hole_turned, r"Hole 1 of panel 'bottom' runs counter-clockwise"),
    (hole_unsealed, r"Edge 1 of hole 1 of panel 'bottom' is in no seam"),
    (hole_meant, r"Seam \d+ is on hole 1 of panel 'front'"),
    (point_beyond, r"Seam \d+ is on point 4 of panel 'front', whose points there are 0 to 3"),
    (opening_beyond, r"opening is at point 4 of panel '"),
]


@pytest.mark.parametrize(("spoil", "text"), REFUSED, ids=lambda value: getattr(value, "__name__", ""))
def test_what_cannot_be_made(spoil: Callable[[Data], None], text: str) -> None:
    data = data_of(box(1.0, 1.0, 1.0))
    spoil(data)
    with pytest.raises(AssemblyError, match=text):
        check_bag(parsed(data))


def wrong(*path: Any) -> Callable[[Data], None]:
    """Puts the last of the arguments where the others lead."""

    def change(data: Data) -> None:
        place: Any = data
        for step in path[:-2]:
            place = place[step]
        place[path[-2]] = path[-1]

    return change


WRONG: list[tuple[Callable[[Data], None], str]] = [
    (wrong("panels", None), "no list of 'panels'"),
    (wrong("panels", []), "no list of 'panels'"),
    (wrong("panels", 1, 3), "Panel 2 of the JSON file"),
    (wrong("panels", 1, "name", 3), "Panel 2 of the JSON file has no name"),
    (wrong("panels", 1, "name", "bottom"), "Two panels .* 'bottom'"),
    (wrong("panels", 1, "outer", [[0, 0], [1, 0]]), "panel 'top' needs at least three points"),
    (wrong("panels", 1, "outer", 2, ["x", 0]), "Point 3 of the JSON file's panel 'top'"),
    (wrong("panels", 1, "outer", 2, [True, 0]), "Point 3 of the JSON file's panel 'top'"),
    (wrong("panels", 1, "outer", 2, [float("nan"), 0]), "NaN is not a coordinate"),
    (wrong("panels", 1, "holes", 3), "'holes' of panel 'top'"),
    (wrong("panels", 1, "holes", [[[1, 1]]]), "hole 1 of panel 'top' needs at least three points"),
    (wrong("panels", 1, "cut", 1), "'cut' of panel 'top'"),
    (wrong("unit", "yard"), "unknown unit"),
    (wrong("seams", {}), "no list of 'seams'"),
    (wrong("seams", 2, 0), "Seam 3 of the JSON file"),
    (wrong("seams", 2, {"a": ["top", 0, 1]}), "Seam 3 of the JSON file"),
    (wrong("seams", 2, "a", ["top", 0]), "Side 'a' of seam 3 is not"),
    (wrong("seams", 2, "a", ["top", 0, -1]), "Side 'a' of seam 3 is not"),
    (wrong("seams", 2, "a", ["top", 0, 1.5]), "Side 'a' of seam 3 is not"),
    (wrong("seams", 2, "a", ["top", 0, True]), "Side 'a' of seam 3 is not"),
    (wrong("seams", 2, "a", 0, ["top"]), "Side 'a' of seam 3 is not"),
    (wrong("seams", 2, "a", 0, "lid"), "Side 'a' of seam 3 is on a panel 'lid'"),
    (wrong("opening", 3), "'opening' of the JSON file"),
    (wrong("opening", "at", None), "'opening' of the JSON file"),
    (wrong("opening", "panel", "lid"), "opening is on a panel 'lid'"),
    (wrong("opening", "panel", []), "opening is on a panel"),
    (wrong("ease", "much"), "'ease' of the JSON file"),
    (wrong("ease", -1), "'ease' of the JSON file"),
]


@pytest.mark.parametrize(("spoil", "text"), WRONG)
def test_what_cannot_be_read(spoil: Callable[[Data], None], text: str) -> None:
    data = data_of(box(1.0, 1.0, 1.0))
    spoil(data)
    with pytest.raises(InputError, match=text):
        parsed(data)


@pytest.mark.parametrize("text", [b"", b"{", b"[]", b"3", b'{"panels": 1}', b"\xff\xfe", b"[" * 100_000])
def test_no_bag_at_all(text: bytes) -> None:
    with pytest.raises(InputError):
        read_bag(text, Budget())


def moebius() -> Bag:
    """A strip whose ends are sealed with half a turn, and a disc along its only rim."""
    strip = np.array([(0.0, 0.0), (4.0, 0.0), (4.0, 1.0), (0.0, 1.0)])
    angles = 2.0 * np.pi * np.arange(16) / 16
    disc = 0.5 / np.sin(np.pi / 16) * np.column_stack([np.cos(angles), np.sin(angles)])
    seams = (
        BagSeam(Side(0, 1, 2), Side(0, 3, 0)),
        BagSeam(Side(0, 0, 1), Side(1, 8, 0)),
        BagSeam(Side(0, 2, 3), Side(1, 0, 8)),
    )
    return Bag((BagPanel("strip", strip), BagPanel("disc", disc)), seams)


def test_a_moebius_strip() -> None:
    with pytest.raises(
        AssemblyError, match=r"seam 1 runs the wrong way at edge \d of panel 'strip'.*Moebius"
    ):
        check_bag(moebius())


def test_ease_is_asked_for() -> None:
    data = data_of(box(1.0, 1.0, 1.0))
    longer(data)
    data["ease"] = 0.02
    bag = parsed(data)
    check_bag(bag)
    assert mesh_bag(bag, 0.3).assembly.surface.bodies == 1


def test_a_bag_without_an_opening() -> None:
    data = data_of(box(1.0, 1.0, 1.0))
    del data["opening"]
    bag = parsed(data)
    check_bag(bag)
    with pytest.raises(AssemblyError, match="no opening"):
        check_bag(bag, opening_needed=True)


@pytest.mark.parametrize(("width", "fits"), [(0.021, True), (0.019, False), (0.002, False)])
def test_panels_thinner_than_their_welds(width: float, fits: bool) -> None:
    bag = box(0.5, 0.3, width)
    if fits:
        check_bag(bag, 0.01)
        return
    with pytest.raises(AssemblyError, match=r"Panel '(front|left)' is only .* wide at edge \d of panel"):
        check_bag(bag, 0.01)


@pytest.mark.parametrize(
    ("size", "seal_width", "said"), [((0.5, 0.002), 0.01, "2 mm"), ((0.2, 0.2), 0.12, "200 mm")]
)
def test_the_width_that_is_told_is_that_of_strip_or_square(
    size: tuple[float, float], seal_width: float, said: str
) -> None:
    corners = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]) * size
    with pytest.raises(AssemblyError, match=f"is only {said} wide"):
        check_thickness(BagPanel("top", corners), seal_width)


def test_tips_are_not_too_thin_for_welds() -> None:
    angles = np.linspace(0.0, np.pi, 61)
    ball = Profile(0.3 * np.column_stack([np.sin(angles), -np.cos(angles)]))
    assert check_bag(gored_bag(ball, 8), 0.01, opening_needed=True) is None


@pytest.mark.parametrize("name", READY)
def test_ready_bodies_can_be_made(name: str) -> None:
    assert check_bag(ready_bag(name), 0.01, opening_needed=True) is None


def test_many_panels_and_points() -> None:
    """A tube of 498 strips and two lids of 498 corners: checked and meshed within seconds."""
    count = 498
    strip = np.array([(0.0, 0.0), (0.01, 0.0), (0.01, 1.0), (0.0, 1.0)])
    angles = 2.0 * np.pi * np.arange(count) / count
    lid = 0.005 / np.sin(np.pi / count) * np.column_stack([np.cos(angles), np.sin(angles)])
    panels = [BagPanel(f"strip {k}", strip) for k in range(count)]
    panels += [BagPanel("lower", lid), BagPanel("upper", lid)]
    seams = [BagSeam(Side(k, 1, 2), Side((k + 1) % count, 0, 3)) for k in range(count)]
    seams += [BagSeam(Side(k, 0, 1), Side(count, -k % count, (-k - 1) % count)) for k in range(count)]
    seams += [BagSeam(Side(k, 2, 3), Side(count + 1, (k + 1) % count, k)) for k in range(count)]
    bag = Bag(tuple(panels), tuple(seams), Opening(0, 1))
    began = time.process_time()
    check_bag(bag, 0.004, opening_needed=True)
    surface = mesh_bag(bag, default_size(bag)).assembly.surface
    assert surface.euler_number == 2
    assert time.process_time() - began < 20.0


def test_ten_thousand_corners() -> None:
    count = 5000
    outward = np.where(np.arange(count) % 2, 1.0, 1.002)
    angles = 2.0 * np.pi * np.arange(count) / count
    saw = outward[:, None] * np.column_stack([np.cos(angles), np.sin(angles)])
    back = np.roll(saw[::-1], 1, axis=0) * (1.0, -1.0)
    half = count // 2
    seams = (
        BagSeam(Side(0, 0, half), Side(1, 0, half)),
        BagSeam(Side(0, half, 0), Side(1, half, 0)),
    )
    bag = Bag((BagPanel("front", saw), BagPanel("back", np.asarray(back))), seams)
    began = time.process_time()
    check_bag(bag)
    assert mesh_bag(bag, default_size(bag)).assembly.surface.bodies == 1
    assert time.process_time() - began < 20.0


@pytest.mark.parametrize(
    ("panels", "points", "text"), [(1001, 3, "1001 panels"), (2, 30_000, "60000 points")]
)
def test_too_much(panels: int, points: int, text: str) -> None:
    angles = 2.0 * np.pi * np.arange(points) / points
    loop = np.column_stack([np.cos(angles), np.sin(angles)])
    with pytest.raises(AssemblyError, match=text):
        check_bag(Bag(tuple(BagPanel(str(k), loop) for k in range(panels)), ()))


def test_nothing() -> None:
    with pytest.raises(AssemblyError, match="no panel"):
        check_bag(Bag((), ()))

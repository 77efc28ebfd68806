# SPDX-License-Identifier: LGPL-2.1-or-later
"""Letters with a side band: what is sealed to what, where the pieces meet, and the bodies of closed forms."""

from __future__ import annotations

from collections import Counter

import numpy as np
import pytest
from drawn_letters import letter_outline
from drawn_shapes import corners_of, ring

from BalloonWorkbench.core.bags.bag import Bag
from BalloonWorkbench.core.bags.mesh_bag import mesh_bag
from BalloonWorkbench.core.bodies.banded import band_joints, band_places, banded_bag, divided
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.geometry.polyline import perimeter, signed_area
from BalloonWorkbench.core.geometry.sampling import resample
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.types import Floats

BAR = corners_of((0.0, 0.0), (0.4, 0.0), (0.4, 0.1), (0.0, 0.1))
SHAPES: dict[str, Outline] = {"bar": BAR, "ring": ring(0.4), "E": letter_outline("sans bold", "E")}
A, B = 1.3110287771, 0.5990701174  # of the Mylar balloon


def sides_of(bag: Bag) -> list[tuple[Floats, Floats]]:
    return [
        tuple(
            bag.panels[side.panel].loops[side.loop][side.points(bag.panels, against=against)]
            for side, against in ((seam.a, False), (seam.b, True))
        )
        for seam in bag.seams
    ]  # type: ignore[return-value]


@pytest.mark.parametrize("piece", [0.0, 0.13])
@pytest.mark.parametrize("name", SHAPES)
def test_every_edge_is_in_one_seam_and_both_sides_are_equally_long(name: str, piece: float) -> None:
    bag = banded_bag(SHAPES[name], 0.03, piece)
    used = Counter(
        (side.panel, side.loop, first)
        for seam in bag.seams
        for side, against in ((seam.a, False), (seam.b, True))
        for first in (side.points(bag.panels, against=against)[slice(1, None) if against else slice(-1)])
    )
    edges = [
        (number, loop, k)
        for number, panel in enumerate(bag.panels)
        for loop, points in enumerate(panel.loops)
        for k in range(len(points))
    ]
    assert set(used) == set(edges)
    assert set(used.values()) == {1}
    for one, other in sides_of(bag):
        steps = [np.linalg.norm(np.diff(side, axis=0), axis=1) for side in (one, other)]
        assert np.allclose(*steps, atol=1e-12)


@pytest.mark.parametrize("name", SHAPES)
def test_both_sides_of_each_seam_lie_in_one_place(name: str) -> None:
    """In space, where front and back are parallel and the band stands upright."""
    outline = divided(SHAPES[name], 0.2)
    joints = band_joints(outline.loops, 0.2)
    bag, places = banded_bag(outline, 0.03, joints=joints), band_places(outline.loops, joints, 0.03)
    for seam in bag.seams:
        here = []
        for side, against in ((seam.a, False), (seam.b, True)):
            loops = bag.panels[side.panel].loops
            first = sum(map(len, loops[: side.loop]))
            here.append(places[side.panel][first + side.points(bag.panels, against=against)])
        assert np.allclose(*here, atol=1e-12)


@pytest.mark.parametrize(("holes", "euler"), [(0, 2), (1, 0), (2, -2)])
def test_each_hole_makes_a_handle(holes: int, euler: int) -> None:
    drawn = {0: "I", 1: "O", 2: "8"}[holes]
    meshed = mesh_bag(banded_bag(letter_outline("sans bold", drawn), 0.04, 0.5), 0.02)
    assert meshed.assembly.surface.euler_number == euler
    assert meshed.assembly.surface.bodies == 1


def test_panels_are_seen_from_outside() -> None:
    for panel in banded_bag(SHAPES["ring"], 0.03, 0.2).panels:
        assert signed_area(panel.outer) > 0.0
        assert all(signed_area(hole) < 0.0 for hole in panel.holes)


@pytest.mark.parametrize("piece", [0.09, 0.21, 0.26, 0.34, 0.9])
def test_pieces_are_no_longer_than_asked_and_make_up_the_loop(piece: float) -> None:
    for outline in SHAPES.values():
        bag = banded_bag(outline, 0.03, piece)
        lengths = [np.ptp(panel.outer[:, 0]) for panel in bag.panels[2:]]
        assert max(lengths) <= piece + 1e-9
        assert sum(lengths) == pytest.approx(sum(map(perimeter, outline.loops)))
        assert {float(np.ptp(panel.outer[:, 1])) for panel in bag.panels[2:]} == {0.03}


def test_pieces_meet_at_corners_where_there_are_some() -> None:
    bag = banded_bag(BAR, 0.03, 0.55)
    ends = {tuple(np.round(one[0], 9)) for one, _ in sides_of(bag)[::2][:2]}
    assert ends <= {tuple(corner) for corner in BAR.outer.tolist()}


def test_the_opening_is_below_and_away_from_the_ends_of_its_piece() -> None:
    bag = banded_bag(SHAPES["E"], 0.03, 0.4)
    assert bag.opening is not None
    panel = bag.panels[bag.opening.panel].outer
    begin, end = panel[bag.opening.at], panel[bag.opening.at + 1]
    assert begin[1] == end[1] == 0.0
    assert 0.1 < begin[0] / np.ptp(panel[:, 0]) < 0.9


@pytest.mark.parametrize(("height", "volume"), [(0.25, 1.734969), (1.0, 3.933153)])
def test_a_disc_with_a_band_is_the_drum(height: float, volume: float) -> None:
    turn = 2.0 * np.pi * np.arange(120) / 120
    disc = Outline(np.stack([np.cos(turn), np.sin(turn)], axis=1))
    balloon = blown(banded_bag(disc, height), 0.07)
    assert balloon.volume == pytest.approx(volume, rel=0.005)


def test_a_long_arm_is_a_cylinder_of_all_its_film() -> None:
    width, band = 0.1, 0.0571
    bar = corners_of((0.0, 0.0), (1.0, 0.0), (1.0, width), (0.0, width))
    balloon = blown(banded_bag(Outline(resample(bar.outer, 0.02)), band), 0.014)
    middle = balloon.positions[np.abs(balloon.positions[:, 0] - np.median(balloon.positions[:, 0])) < 0.1]
    for across in (1, 2):
        assert np.ptp(middle[:, across]) == pytest.approx(2.0 * (width + band) / np.pi, rel=0.02)


def blown(bag: Bag, size: float):  # type: ignore[no-untyped-def]
    film = Film("film", 1e9, 0.3, 1e-5, 0.0, seal_width=0.0)
    meshed = mesh_bag(bag, size)
    loops = bag.panels[0].loops
    joints = band_joints(loops)
    start = meshed.places(band_places(loops, joints, float(np.ptp(bag.panels[2].outer[:, 1]))))
    pressure = film.membrane_stiffness / (1000.0 * meshed.assembly.size)
    return inflate(meshed.assembly, film, pressure, start=start, model=Model(bending=False))


@pytest.mark.parametrize(
    ("outline", "band", "piece", "text"),
    [
        (Outline(BAR.outer, welds=(np.array([[0.1, 0.05], [0.3, 0.05]]),)), 0.03, 0.0, "no welds inside"),
        (Outline(BAR.outer, spots=(ring(0.3).holes[0],)), 0.03, 0.0, "no welds inside"),
        (BAR, 0.0, 0.0, "must be wider than 0"),
        (BAR, -0.02, 0.0, "must be wider than 0"),
        (BAR, float("nan"), 0.0, "must be wider than 0"),
        (BAR, 0.03, -1.0, "Give 0 or more"),
        (BAR, 0.03, 1e-3, "Allow longer ones"),
    ],
)
def test_what_cannot_be_made_is_refused_in_one_sentence(
    outline: Outline, band: float, piece: float, text: str
) -> None:
    with pytest.raises(InputError, match=text):
        banded_bag(outline, band, piece)

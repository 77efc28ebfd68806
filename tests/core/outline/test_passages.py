# SPDX-License-Identifier: LGPL-2.1-or-later
"""Chambers between welds, and the passages and intakes through which they fill."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import shapely
from drawn_shapes import corners_of, hole, polar

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.job import Settings, make_balloon
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.outline.chambers import chambers, linked
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.outline.validity import check
from BalloonWorkbench.core.pattern.build import build_pattern
from BalloonWorkbench.core.pattern.pattern import Pattern, Role
from BalloonWorkbench.core.solver.inflate import inflate

SEAL = 0.005
BOX = corners_of((0.0, 0.0), (0.3, 0.0), (0.3, 0.2), (0.0, 0.2)).outer


def upright(*places: float) -> Outline:
    """A box of 300 x 200 mm with welds from its lower to its upper edge."""
    return check(Outline(BOX, welds=tuple(np.array([[x, 0.0], [x, 0.2]]) for x in places)))


CROSSED = check(
    Outline(
        polar(0.15),
        (hole(0.03, 0.0, 0.0),),
        welds=tuple(
            np.concatenate([polar(radius, np.array([a])) for radius in (0.0301, 0.1499)])
            for a in np.radians([10.0, 130.0, 250.0])
        ),
    )
)


def gaps(outline: Outline) -> list[float]:
    """Distances between the facing ends of welds that were one [m]."""
    ends = [end for weld in outline.welds for end in weld[[0, -1]]]
    rim = shapely.Polygon(outline.outer, outline.holes).boundary
    free = [end for end in ends if rim.distance(shapely.Point(end)) > 0.01]
    return [min(float(np.hypot(*(end - other))) for other in free if other is not end) for end in free]


def test_chambers_by_hand() -> None:
    rooms = chambers(upright(0.1))
    assert [room.area for room in rooms] == pytest.approx([0.04, 0.02], rel=1e-4)
    assert [room.area for room in chambers(CROSSED)] == pytest.approx(
        [np.pi * (0.15**2 - 0.03**2) / 3.0] * 3, rel=1e-2
    )
    open_weld = check(Outline(BOX, welds=(np.array([[0.1, 0.0], [0.1, 0.15]]),)))
    assert len(chambers(open_weld)) == 1


@pytest.mark.parametrize("width", [0.006, 0.010, 0.025])
@pytest.mark.parametrize("outline", [upright(0.1), upright(0.1, 0.2), CROSSED], ids=["two", "three", "ring"])
def test_one_passage_for_each_chamber(outline: Outline, width: float) -> None:
    """As wide as it is wanted; nothing else of the welds goes; all is one chamber then."""
    count = len(chambers(outline))
    found = linked(outline, width)
    assert len(chambers(found)) == 1
    assert len(found.notes) == count - 1
    assert f"passage of {1000 * width:g} mm" in found.notes[0]
    assert gaps(found) == pytest.approx([width] * 2 * (count - 1), rel=1e-6)
    before, after = (shapely.MultiLineString(list(each.welds)).length for each in (outline, found))
    assert before - after == pytest.approx((count - 1) * width, rel=1e-6)


def test_passages_are_amid_their_welds() -> None:
    for weld in linked(upright(0.1), 0.01).welds:
        assert np.abs(weld[:, 1] - 0.1).min() == pytest.approx(0.005, abs=0.003)


def test_no_passage_where_none_is_wanted_or_fits() -> None:
    assert len(linked(upright(0.1), 0.0).welds) == 1
    drawn = check(
        Outline(BOX, welds=(np.array([[0.1, 0.0], [0.1, 0.09]]), np.array([[0.1, 0.11], [0.1, 0.2]])))
    )
    assert linked(drawn, 0.01).welds == drawn.welds  # a passage that was drawn
    assert len(chambers(linked(upright(0.1), 0.09))) == 2  # would take nearly all of the weld
    with pytest.raises(InputError, match="passages"):
        linked(upright(0.1), -1.0)


def open_seals(pattern: Pattern) -> list[shapely.LineString]:
    return [shapely.LineString(line.points) for line in pattern.of(Role.SEAL) if not line.closed]


@pytest.mark.parametrize("outline", [upright(0.1), upright(0.1, 0.2)], ids=["two", "three"])
def test_chambers_apart_have_an_intake_each(outline: Outline) -> None:
    """From each mouth a disc of the intake's width reaches its own chamber and no other."""
    pattern = build_pattern(outline, SEAL)
    rooms = chambers(outline)
    assert len(pattern.intakes) == len(open_seals(pattern)) == len(rooms)
    (cut,) = pattern.of(Role.CUT)
    walls = shapely.union_all(
        [*(seal.buffer(0.5 * SEAL, cap_style="flat") for seal in open_seals(pattern))]
        + [shapely.LineString(weld.points).buffer(1e-3, cap_style="square") for weld in pattern.of(Role.WELD)]
    )
    free = shapely.Polygon(cut.points).difference(walls).buffer(-0.00495)
    reached = []
    for intake in pattern.intakes:
        mouth = shapely.Point(
            intake.at + 0.5 * intake.length * np.array([np.cos(intake.angle), np.sin(intake.angle)])
        )
        (air,) = (part for part in shapely.get_parts(free) if part.distance(mouth) < 1e-3)
        inside = [
            k for k, room in enumerate(rooms) if air.intersection(room.buffer(-0.01)).area > 0.3 * room.area
        ]
        assert len(inside) == 1
        reached += inside
    assert sorted(reached) == list(range(len(rooms)))


def test_welds_at_the_rim_join_the_weld_round_it() -> None:
    """No slit is left between them, and none where a passage is."""
    for outline, ends in ((upright(0.1), 2), (linked(upright(0.1)), 2)):
        pattern = build_pattern(outline, SEAL)
        round_it = shapely.union_all(open_seals(pattern))
        points = [end for weld in pattern.of(Role.WELD) for end in weld.points[[0, -1]]]
        away = [round_it.distance(shapely.Point(point)) for point in points]
        assert sum(distance < 1e-5 for distance in away) == ends
        assert sorted(away)[ends:] == pytest.approx([0.0975] * (len(away) - ends), abs=1e-3)


def test_an_intake_that_is_placed_serves_its_chamber() -> None:
    pattern = build_pattern(upright(0.1), SEAL, PatternOptions(intake_angle=np.pi))
    assert pattern.intake is not None
    assert pattern.intake.at == pytest.approx([0.0, 0.1], abs=1e-6)
    assert pattern.more_intakes[0].at[0] > 0.1


def test_a_chamber_without_a_rim_cannot_be_filled() -> None:
    """A round weld is a spot, so this one runs round a hole, from hole to hole."""
    holes = (hole(0.02, -0.06, 0.0), hole(0.02, 0.06, 0.0))
    welds = tuple(
        np.array([[-0.0599, y], [-0.06, 2 * y], [0.06, 2 * y], [0.0599, y]]) for y in (0.0203, -0.0203)
    )
    outline = check(Outline(polar(0.15), holes, welds=welds))
    assert len(chambers(outline)) == 2
    with pytest.raises(InputError, match=r"has no rim .* leave a gap"):
        build_pattern(outline, SEAL)
    assert len(build_pattern(linked(outline), SEAL).intakes) == 1


def test_parted_and_linked_balloons_inflate_alike() -> None:
    """Both chambers have the same pressure; a narrow passage changes the volume little."""
    volumes = [
        inflate(triangulate(outline, 0.014), film("mylar"), 2000.0).volume
        for outline in (upright(0.1), linked(upright(0.1)))
    ]
    assert volumes[1] == pytest.approx(volumes[0], rel=0.02)
    # each chamber alone: the weld between them is held straight by both
    alone = inflate(triangulate(check(Outline(BOX)), 0.014), film("mylar"), 2000.0).volume
    assert volumes[0] < 0.8 * alone


def test_the_job_links_chambers(tmp_path: Path) -> None:
    drawing = {
        "unit": "mm",
        "outer": [[0, 0], [150, 0], [150, 100], [0, 100]],
        "welds": [[[50, 0], [50, 100]]],
    }
    path = tmp_path / "two.json"
    path.write_text(json.dumps(drawing), encoding="utf-8")
    settings = Settings(mesh_size=0.012, correct=False)
    balloon = make_balloon(path, settings)
    assert len(balloon.drawing.largest.welds) == 2
    assert len(balloon.patterns[0].intakes) == 1
    assert any("passage of 10 mm" in text for text in balloon.report["warnings"])
    apart = make_balloon(path, replace(settings, passage=0.0))
    assert len(apart.patterns[0].intakes) == 2

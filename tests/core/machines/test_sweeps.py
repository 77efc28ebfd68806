# SPDX-License-Identifier: LGPL-2.1-or-later
"""A laser's beam, a swivel knife and a hot wheel swept along what files say: what comes out of the machine is
the pattern.

Pictures, letters, holes with tips, a letter with a side band, gores; pieces of film by shapely alone.
BALLOON_CUTS sets how many patterns are tried (`make fuzz`: 300).
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
import shapely
import shapely.ops
from drawn_cuts import letter, made, sheets
from drawn_letters import letter_outline
from drawn_shapes import NAMED
from gcode_reader import HOT, KNIFE, LASER, WHEEL, Run, held, lines_of, run
from written_files import CUTS, written

from BalloonWorkbench.core.bag_pattern.make import bag_patterns
from BalloonWorkbench.core.bags.bag import Bag
from BalloonWorkbench.core.bodies.banded import banded_bag
from BalloonWorkbench.core.bodies.gores import gored_bag
from BalloonWorkbench.core.bodies.profile import Profile
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.geometry.areas import parts
from BalloonWorkbench.core.machines.machine import machine
from BalloonWorkbench.core.options.making import ToolOptions
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.pattern.intake.kinds import RIM, intake_kinds
from BalloonWorkbench.core.pattern.pattern import Pattern, Role

COUNT = int(os.environ.get("BALLOON_CUTS", "3"))
BEAM, WHEEL_WIDTH, OFFSET, OVERCUT = 0.2, 3.0, 0.25, 1.5  # mm
NEAR = 0.05
#: Beams of all kinds of files; those of G-code are read as their controller runs them.
FILES = ["gcode", "any-dxf", "lightburn-project", "glowforge"]


@cache
def pattern(name: str) -> Pattern:
    """One of those that are there whatever the count."""
    outline = letter("B", 0.22) if name == "B" else NAMED["heart"].map(lambda loop: 0.5 * loop)
    sheet = made((outline,), PatternOptions(mirror=name != "B"))
    assert sheet is not None
    return sheet


def of_panels(bag: Bag) -> Pattern:
    return bag_patterns(bag, film("bopp-foil"), PatternOptions(notches=2)).sheet


def ball() -> Bag:
    turn = np.linspace(-0.5 * np.pi, 0.5 * np.pi, 24)
    half = 0.08 * np.column_stack([np.cos(turn), np.sin(turn)])
    half[[0, -1], 0] = 0.0
    return gored_bag(Profile(half), 3)


@cache
def patterns() -> dict[str, Pattern]:
    banded = banded_bag(letter_outline("sans bold", "A").map(lambda loop: 0.5 * loop), 0.03)
    return {
        "heart": pattern("heart"),
        "B": pattern("B"),
        "ball": of_panels(ball()),
        "A with a band": of_panels(banded),
        **dict(sheets(COUNT, most_copies=1)),
    }


def film_of(sheet: Pattern) -> list[shapely.Polygon]:
    """The pieces of film, also those that lie in the holes of others [mm]."""
    film_area = shapely.Polygon()
    for each in lines_of(sheet, *CUTS):
        film_area = film_area.symmetric_difference(shapely.Polygon(each))
    return parts(film_area)


def swept(lines: list[shapely.Geometry], width: float) -> shapely.Geometry:
    return shapely.union_all([each.simplify(0.005).buffer(0.5 * width, quad_segs=8) for each in lines])


def strokes(read: Run) -> list[shapely.Geometry]:
    return [shapely.LineString(stroke.line) for stroke in read.strokes]


def cut_lines(sheet: Pattern, name: str, folder: Path) -> list[shapely.Geometry]:
    """What a beam of 0.2 mm goes along, where the pattern lies: cuts stay in the middle of those written."""
    if name == "gcode":
        return strokes(run(sheet, held("grbl", LASER, kerf=1e-3 * BEAM)))
    made_for = replace(machine(name), kerf=1e-3 * BEAM, bed=None)
    read = [(role, each) for role, each in written(sheet, made_for, folder) if role in (*CUTS, Role.NOTCH)]
    lines = shapely.MultiLineString([each for _, each in read])
    shift = offset([each for role, each in read if role in CUTS], lines_of(sheet, *CUTS))
    return [*shapely.transform(lines, lambda points: points + shift).geoms]


def offset(lines: list[shapely.Geometry], others: list[shapely.Geometry]) -> np.ndarray:
    """How far (2,) lines have to move to lie on others, or beside them by half a beam all round: from box on
    box by least squares."""
    shift = np.mean(np.reshape(shapely.total_bounds(others) - shapely.total_bounds(lines), (2, 2)), axis=0)
    goal = shapely.union_all(others)
    goal = shapely.union_all([goal.buffer(0.5 * BEAM).boundary, goal])
    points = np.concatenate([shapely.get_coordinates(each.segmentize(1.0)) for each in lines])
    for _ in range(3):
        ways = shapely.shortest_line(shapely.points(points + shift), goal)
        apart = np.diff(shapely.get_coordinates(ways).reshape(-1, 2, 2), axis=1)[:, 0]
        length = np.hypot(*apart.T)
        normals = apart[length > 1e-9] / length[length > 1e-9, None]
        shift = shift + np.linalg.lstsq(normals, length[length > 1e-9], rcond=None)[0]
    return shift


def reached(waste: shapely.Geometry) -> shapely.Geometry:
    """What of it a round beam takes that stays in it."""
    return waste.buffer(-0.5 * BEAM, quad_segs=16).buffer(0.5 * BEAM, quad_segs=16)


@pytest.mark.slow
@pytest.mark.parametrize("name", FILES)
def test_the_beam_leaves_the_pieces_of_the_pattern(name: str, tmp_path: Path) -> None:
    """Every contour closes: each piece falls out with its holes, as large as it was designed."""
    for title, sheet in patterns().items():
        cut = swept(cut_lines(sheet, name, tmp_path), BEAM)
        panels = film_of(sheet)
        frame = shapely.box(*(shapely.total_bounds(panels) + np.array([-5.0, -5.0, 5.0, 5.0])))
        left = shapely.get_parts(frame.difference(cut))
        kept = frame.difference(reached(frame.buffer(5.0).difference(shapely.union_all(panels))))
        notches = shapely.union_all(lines_of(sheet, Role.NOTCH)).buffer(0.5 * BEAM + NEAR)
        for panel in panels:
            inside = panel.buffer(-0.3)
            (piece,) = (each for each in left if each.intersects(inside.representative_point()))
            assert piece.difference(kept.buffer(NEAR)).area < 1e-6, (title, name)
            assert panel.buffer(-NEAR).difference(notches).difference(piece).area < 1e-3, (title, name)


def hold_seals(sheet: Pattern, cut: shapely.Geometry, slack: float, title: str) -> None:
    """Half of the weld stays beside each seal, but where a neck is open at the cut; no neck is slit."""
    for seal in lines_of(sheet, Role.SEAL, Role.WELD):
        end = 0.0 if seal.is_ring else 4.0
        inside = shapely.ops.substring(seal, end, seal.length - end)
        assert cut.distance(inside) > 0.5e3 * sheet.seal_width - slack - NEAR, title
    for neck in necks(sheet):
        assert cut.distance(shapely.ops.substring(neck, 0.0, neck.length - 0.5)) > 0.0, title


def necks(sheet: Pattern) -> Iterator[shapely.Geometry]:
    """Lines down the middle of the necks, from the seam to the mouth [mm]."""
    shift = shapely.get_coordinates(lines_of(sheet, Role.CUT)[0])[0] - 1e3 * sheet.of(Role.CUT)[0].points[0]
    for intake in sheet.intakes:
        if intake_kinds()[intake.kind].place != RIM:
            continue
        at = 1e3 * intake.at + shift
        along = np.array([np.cos(intake.angle), np.sin(intake.angle)])
        yield shapely.LineString([at, at + 1e3 * intake.length * along])


def test_no_cut_crosses_a_seal_and_no_neck_is_slit(tmp_path: Path) -> None:
    for title, sheet in patterns().items():
        hold_seals(sheet, swept(cut_lines(sheet, "gcode", tmp_path), BEAM), BEAM, title)


@pytest.mark.slow
def test_the_knife_cuts_the_pattern() -> None:
    """Its tip trails the axis and came down anywhere round it: all is cut, nothing else, and nothing twice
    but what runs past the start; near corners it is off by no more than its offset."""
    for title, sheet in patterns().items():
        read = run(sheet, held("grbl", KNIFE, knife_offset=1e-3 * OFFSET, overcut=1e-3 * OVERCUT))
        sides = np.random.default_rng(0).uniform(*np.radians([-170.0, 170.0]), len(read.strokes))
        courses = [drawn(stroke.line, side) for stroke, side in zip(read.strokes, sides, strict=True)]
        course = shapely.MultiLineString(courses)
        lines = lines_of(sheet, *CUTS, Role.NOTCH)
        nominal = shapely.union_all(lines)
        corners = shapely.MultiPoint([at for each in lines for at in turning(each)]).buffer(3.0 * OFFSET)
        starts = shapely.MultiPoint([each.coords[0] for each in courses]).buffer(4.0 * OFFSET)
        assert course.buffer(NEAR).covers(nominal.difference(corners.union(starts))), title
        assert nominal.buffer(NEAR).covers(course.difference(corners.union(starts))), title
        assert nominal.buffer(1.2 * OFFSET).covers(course), title
        rings = [each for each in lines if each.is_ring]
        assert course.buffer(NEAR).covers(shapely.union_all(rings).difference(corners)), title
        twice = course.length - nominal.length
        assert twice < OVERCUT * len(rings) + 0.5 * len(lines) + 4.0 * OFFSET * len(
            shapely.get_parts(corners)
        ), title
        hold_seals(sheet, course, 1.2 * OFFSET, title)


def drawn(axis: np.ndarray, side: float) -> shapely.LineString:
    """The way of a tip that trails an axis; turned by a side [rad] it came down behind."""
    way = shapely.get_coordinates(shapely.LineString(axis).segmentize(0.05))
    behind = np.arctan2(*(way[0] - way[1])[::-1]) + side
    tips = [way[0] + OFFSET * np.array([np.cos(behind), np.sin(behind)])]
    for at in way[1:]:
        away = tips[-1] - at
        tips.append(at + OFFSET * away / np.hypot(*away))
    return shapely.LineString(tips)


def turning(line: shapely.Geometry) -> np.ndarray:
    """Points (n, 2) at which a line turns by more than 15 degrees within the knife's offset."""
    points = shapely.get_coordinates(line.segmentize(0.5 * OFFSET))
    if line.is_ring:
        points = np.concatenate([points[:-1], points[:2]])
    steps = np.diff(points, axis=0)
    headings = np.unwrap(np.arctan2(steps[:, 1], steps[:, 0]))
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*steps.T))])[:-1]
    ahead = np.searchsorted(along, along + OFFSET, side="right") - 1
    turned = np.array(
        [np.ptp(headings[k : max(end, min(k + 1, len(headings) - 1)) + 1]) for k, end in enumerate(ahead)]
    )
    return points[1:-1] if len(points) < 3 else points[1:][turned > np.radians(15.0)]


def test_the_wheel_closes_what_the_pattern_closes() -> None:
    """It welds the seals and nothing of the air space; each panel's air reaches the cut nowhere but at a
    neck's mouth, there as widely as in the pattern."""
    for title, sheet in patterns().items():
        welded = swept(strokes(run(sheet, held("marlin", WHEEL))), WHEEL_WIDTH)
        seals = shapely.union_all(lines_of(sheet, Role.SEAL, Role.WELD))
        assert welded.buffer(NEAR).covers(seals.buffer(0.5 * WHEEL_WIDTH)), title
        wanted = seals.buffer(0.5 * WHEEL_WIDTH)
        for panel in film_of(sheet):
            airs = [
                max(parts(panel.difference(each)), key=lambda part: float(part.area))
                for each in (welded, wanted)
            ]
            mouths = [air.boundary.intersection(panel.boundary.buffer(1e-6)).length for air in airs]
            if mouths[1] > 0.5 * panel.length:  # the seal is round nothing: a nozzle's ring
                continue
            assert airs[0].symmetric_difference(airs[1]).buffer(-NEAR).area < 1e-3, title
            assert mouths[0] == pytest.approx(mouths[1], abs=2.0 * NEAR), title


def test_a_wheel_on_a_swivel_follows_the_weld() -> None:
    """Its axis goes 3 mm ahead; stepped along, the wheel stays on the weld but where it rounds a corner."""
    sheet = pattern("heart")
    read = run(sheet, held("marlin", replace(WHEEL), knife_offset=0.003))
    seals = shapely.union_all([*lines_of(sheet, Role.SEAL)])
    for stroke in read.strokes:
        way = shapely.get_coordinates(shapely.LineString(stroke.line).segmentize(0.1))
        ahead = (way[1] - way[0]) / np.hypot(*(way[1] - way[0]))
        wheel, off = way[0] - 3.0 * ahead, []
        for at in way:
            away = wheel - at
            wheel = at + 3.0 * away / np.hypot(*away)
            off.append(seals.distance(shapely.Point(wheel)))
        beside = np.array(off) > 0.3
        assert beside[20:-30].mean() < 0.02


@pytest.mark.slow
@pytest.mark.parametrize("arcs", [True, False])
@pytest.mark.parametrize("wishes", [WHEEL, KNIFE], ids=["wheel", "knife"])
def test_a_tool_that_an_axis_turns_points_along_the_path(wishes: ToolOptions, arcs: bool) -> None:
    """All along, arcs and corners too: the reader holds that it is lifted where it turns sharply."""
    for title, sheet in patterns().items():
        made_for = held("linuxcnc", wishes, arcs=arcs)
        made_for = replace(made_for, tool=replace(made_for.tool, turning_axis="C"))
        read = run(sheet, made_for)
        plain = run(sheet, held("linuxcnc", wishes, arcs=arcs))
        gone, wanted = (shapely.union_all(strokes(each)) for each in (read, plain))
        assert shapely.hausdorff_distance(gone, wanted) < NEAR, title
        for stroke in read.strokes:
            way = np.diff(stroke.line, axis=0)
            long = np.hypot(*way.T) > 0.02
            heading = np.degrees(np.arctan2(way[:, 1], way[:, 0]))
            middles = 0.5 * (np.array(stroke.angles[1:]) + stroke.angles[:-1])
            turned = np.abs(np.diff(stroke.angles))
            off = np.abs((middles - heading + 180.0) % 360.0 - 180.0) - 0.5 * turned
            assert off[long].max(initial=0.0) < 3.0, title
            assert np.abs(stroke.angles).max() < 180.0 + 360.0 * 1.6, title


def test_hot_tip_and_laser_lie_on_each_other() -> None:
    """What is welded is cut afterwards from the same corner: the seal keeps its distance all along."""
    sheet = pattern("heart")
    seal = shapely.union_all(strokes(run(sheet, held("marlin", HOT))))
    for line in lines_of(sheet, Role.SEAL):
        assert seal.buffer(0.01).covers(line.segmentize(0.5))

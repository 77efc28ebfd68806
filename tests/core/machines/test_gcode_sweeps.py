# SPDX-License-Identifier: LGPL-2.1-or-later
"""A laser's beam and a hot wheel swept along what files say: what comes out of the machine is the pattern.

Two panels, a letter with holes, a gored body; pieces of film by shapely alone.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import shapely
import shapely.ops
from drawn_cuts import letter, made
from drawn_shapes import NAMED
from gcode_reader import HOT, LASER, ROOM, WHEEL, Run, film_of, held, lines_of, run

from BalloonWorkbench.core.bag_pattern.make import bag_patterns
from BalloonWorkbench.core.bodies.gores import gored_bag
from BalloonWorkbench.core.bodies.profile import Profile
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.pattern.pattern import Pattern, Role

BEAM, WHEEL_WIDTH = 0.2, 3.0  # mm
NEAR = 0.05
SEAL = 0.006  # m, of drawn_cuts


@cache
def pattern(name: str) -> Pattern:
    if name == "ball":
        turn = np.linspace(-0.5 * np.pi, 0.5 * np.pi, 24)
        half = 0.08 * np.column_stack([np.cos(turn), np.sin(turn)])
        half[[0, -1], 0] = 0.0
        return bag_patterns(gored_bag(Profile(half), 3), film("bopp-foil"), PatternOptions(notches=2)).sheet
    outline = letter("B", 0.22) if name == "B" else NAMED["heart"].map(lambda loop: 0.5 * loop)
    sheet = made((outline,), PatternOptions(mirror=name != "B"))
    assert sheet is not None
    return sheet


def swept(read: Run, width: float) -> shapely.Geometry:
    ways = [shapely.LineString(stroke.line).simplify(0.002) for stroke in read.strokes]
    return shapely.union_all([way.buffer(0.5 * width, quad_segs=8) for way in ways])


@cache
def cut(name: str) -> shapely.Geometry:
    return swept(run(pattern(name), held("grbl", LASER, arcs=name != "B")), BEAM)


@cache
def welded(name: str) -> shapely.Geometry:
    return swept(run(pattern(name), held("marlin", WHEEL)), WHEEL_WIDTH)


NAMES = ["heart", "B", "ball"]


@pytest.mark.parametrize("name", NAMES)
def test_the_beam_leaves_the_pieces_of_the_pattern(name: str) -> None:
    """Every contour closes: each panel falls out without its holes, smaller by half a beam all round."""
    sheet = pattern(name)
    width, height = np.array(sheet.size) * 1e3 + 2.0 * ROOM
    left = shapely.get_parts(shapely.box(0.0, 0.0, width, height).difference(cut(name)))
    notches = shapely.union_all([*lines_of(sheet, Role.NOTCH)]).buffer(0.5 * BEAM + NEAR)
    panels = shapely.get_parts(film_of(sheet))
    for panel in panels:
        inside = panel.buffer(-0.5 * BEAM)
        (piece,) = (each for each in left if each.intersects(panel.representative_point()))
        assert piece.difference(inside.buffer(NEAR)).area < 1e-6
        assert inside.buffer(-NEAR).difference(notches).difference(piece).area < 1e-3
    assert len(panels) == {"heart": 2, "ball": 3}.get(name, len(panels))


@pytest.mark.parametrize("name", NAMES)
def test_no_cut_crosses_a_seal_and_no_neck_is_slit(name: str) -> None:
    sheet = pattern(name)
    for seal in lines_of(sheet, Role.SEAL, Role.WELD):
        end = 0.0 if seal.is_ring else 4.0  # a neck is open at the cut
        inside = shapely.ops.substring(seal, end, seal.length - end)
        assert cut(name).distance(inside) > 0.5e3 * SEAL - 0.5 * BEAM - NEAR
    for neck in necks(sheet):
        inside = shapely.ops.substring(neck, 0.0, neck.length - 0.5)
        assert cut(name).distance(inside) > 0.0
        assert welded(name).distance(neck) > 1.0  # nor is it sealed shut


def necks(sheet: Pattern) -> list[shapely.Geometry]:
    """Lines down the middle of the necks, from the seam to the mouth [mm]; a panel laid twice has it once."""
    lines = []
    for intake in sheet.intakes:
        at = (intake.at - sheet.bounds[0]) * 1e3 + ROOM
        along = np.array([np.cos(intake.angle), np.sin(intake.angle)])
        lines.append(shapely.LineString([at, at + 1e3 * intake.length * along]))
    return lines


@pytest.mark.parametrize("name", NAMES)
def test_the_wheel_closes_what_the_pattern_closes(name: str) -> None:
    """Of each panel, what lies inside its seal reaches the cut nowhere but at a neck's mouth, and there as
    widely as the neck is open between its welds."""
    sheet = pattern(name)
    mouth, mouths = 1e3 * (sheet.intakes[0].width + sheet.seal_width) - WHEEL_WIDTH, 0
    for panel in shapely.get_parts(film_of(sheet)):
        air = max(shapely.get_parts(panel.difference(welded(name))), key=lambda part: part.area)
        assert air.area > 0.5 * panel.area
        out = air.boundary.intersection(panel.boundary.buffer(1e-6))
        if out.length:
            assert out.length == pytest.approx(mouth, abs=NEAR)
            mouths += 1
    assert mouths == {"heart": 2, "B": 1, "ball": 2}[name]


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


def test_hot_tip_and_laser_lie_on_each_other() -> None:
    """What is welded is cut afterwards from the same corner: the seal keeps its distance all along."""
    sheet = pattern("heart")
    seal = shapely.union_all(
        [shapely.LineString(stroke.line) for stroke in run(sheet, held("marlin", HOT)).strokes]
    )
    for line in lines_of(sheet, Role.SEAL):
        assert seal.buffer(0.01).covers(line.segmentize(0.5))

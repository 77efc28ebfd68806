# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is cut, as it stands in the files: no line crosses itself or another, and none comes after the film
under it was cut free.

BALLOON_CUTS sets how many patterns are tried (`make fuzz`: 300).
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
import shapely
from drawn_cuts import HOLES, holed, laid_out, letter, made, sheets
from drawn_shapes import NAMED
from read_back import line
from written_files import CUTS, READERS, Read, written

from BalloonWorkbench.core.machines.machine import machine, machines
from BalloonWorkbench.core.machines.toolpaths import Path as Line
from BalloonWorkbench.core.machines.toolpaths import draw
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.pattern.make import make_pattern, sheet_of
from BalloonWorkbench.core.pattern.pattern import Pattern, Role
from BalloonWorkbench.core.units import from_mm

COUNT = int(os.environ.get("BALLOON_CUTS", "3"))
NOTCH = Role.NOTCH
#: A line that turns by more has gone back on itself [rad].
BACK = np.radians(179.9)


def hold_simple(read: Read, name: str) -> None:
    """Every line is simple and goes on; no two cuts touch."""
    for role, each in read:
        assert each.is_simple, (name, role, shapely.is_valid_reason(shapely.Polygon(each)))
        points = shapely.get_coordinates(each)
        steps = np.diff(np.concatenate([points, points[1:2]]) if each.is_ring else points, axis=0)
        steps = steps[np.hypot(*steps.T) > 1e-9]
        headings = np.arctan2(steps[:, 1], steps[:, 0])
        turns = np.abs((np.diff(headings) + np.pi) % (2.0 * np.pi) - np.pi)
        assert turns.max(initial=0.0) < BACK, (name, role, points[int(np.argmax(turns)) + 1])
    cuts = [each for role, each in read if role in CUTS]
    assert all(each.is_ring and shapely.Polygon(each).is_valid for each in cuts), name
    first, second = shapely.STRtree(cuts).query(cuts, predicate="intersects")
    assert (first == second).all(), (name, "cuts meet")


def hold_order(read: Read, name: str) -> None:
    """No line lies in an area that was cut free before it."""
    free: list[shapely.Polygon] = []
    for role, each in read:
        place = each if role in CUTS else each.interpolate(0.5, normalized=True)
        assert not any(area.contains(place) for area in free), (name, role, place)
        if role in CUTS:
            free.append(shapely.Polygon(each))


#: In a spot colour all cuts are alike: test_spot_colours reads them.
MACHINES = sorted(name for name, known in machines().items() if known.format in READERS and not known.spots)


@pytest.fixture(scope="module")
def patterns() -> dict[str, Pattern]:
    found = dict(sheets(COUNT))
    found["doughnut"] = made((holed("blunt lens", 1.5),), PatternOptions(intake_kind="nozzle", mirror=True))
    return found


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "kerf"), [("any-dxf", 0.0), ("lightburn", 0.0), ("lightburn", from_mm(0.3))]
)
def test_no_written_line_crosses_itself(
    patterns: dict[str, Pattern], name: str, kerf: float, tmp_path: Path
) -> None:
    made_for = replace(machine(name), kerf=kerf)
    for title, pattern in patterns.items():
        read = written(pattern, made_for, tmp_path)
        hold_simple(read, title)
        hold_order(read, title)


@pytest.mark.parametrize("name", MACHINES)
def test_every_machine(name: str, tmp_path: Path) -> None:
    """A hole with tips, notches and a second panel; every machine's own way of writing."""
    pattern = made((holed("lens"),), PatternOptions(intake_kind="nozzle", mirror=True, notches=5, label="8"))
    read = written(pattern, machine(name), tmp_path)
    if machine(name).overrun:  # welds overlap
        assert {role for role, _ in read} == {Role.SEAL}
        return
    hold_simple(read, name)
    hold_order(read, name)
    assert (
        sum(role in CUTS for role, _ in read) == 7
    )  # two panels, their holes, the nozzle's, a ring with its bore


@pytest.mark.parametrize("name", MACHINES)
def test_what_lies_in_a_hole_is_cut_first(name: str, tmp_path: Path) -> None:
    """Panels with holes and notches in the holes of others: the deepest first, in every format."""
    hold_order(written(laid_out(), machine(name), tmp_path), name)


def test_panel_by_panel(tmp_path: Path) -> None:
    """Between the first line of a panel and its cut nothing is done to another panel but in its holes."""
    read = written(laid_out(), machine("lightburn"), tmp_path)
    panels = [shapely.Polygon(each) for role, each in read if role is Role.CUT]
    outer = [
        panel for panel in panels if not any(other.contains(panel) for other in panels if other is not panel)
    ]
    lines = [each for role, each in read if role is not Role.REGISTRATION]
    which = [next(k for k, panel in enumerate(outer) if panel.buffer(0.05).contains(each)) for each in lines]
    assert len(outer) == 3
    assert sum(one != other for one, other in pairwise(which)) == len(outer) - 1


@pytest.mark.parametrize("name", list(HOLES))
def test_holes_keep_their_area(name: str) -> None:
    """The tips are taken off, nothing else: what is left of a hole is what a disc of 0.5 mm reaches in it."""
    pattern = made((holed(name),), PatternOptions(intake=False))
    hole = shapely.Polygon(holed(name).holes[0])
    room = hole.buffer(-0.008, join_style="mitre", mitre_limit=2.0)
    reached = room.buffer(-0.0005).buffer(0.0005)
    cut = shapely.union_all([shapely.Polygon(each.points) for each in pattern.of(Role.CUT_INNER)])
    assert reached.buffer(-5e-5).difference(cut).area < 1e-12
    assert cut.difference(room.buffer(5e-5)).area < 1e-12
    assert cut.area == pytest.approx(reached.area, abs=2e-5 * room.length)


@pytest.mark.parametrize("kind", ["A", "heart"])
def test_a_knife_starts_on_a_straight(kind: str) -> None:
    """Its tip, which trails the axis, goes over its start again and stays on the cut; 5 mm round the start
    there are no corners and no notches."""
    outline = letter("A") if kind == "A" else NAMED["heart"]
    pattern = made((outline,), PatternOptions(intake=False, notches=7, mirror=True))
    assert pattern.of(NOTCH)
    tool = replace(machine("hpgl-plotter"), knife_offset=from_mm(0.25))
    nominal = list(draw(pattern, replace(tool, overcut=0.0, knife_offset=0.0)).paths)
    marks = shapely.MultiPoint([path.curve.joints[0] for path in nominal if path.role is NOTCH])
    rings = {role: [line(p.curve.joints, True) for p in nominal if p.role is role] for role in CUTS}
    shift = _shift(draw(pattern, tool).paths, nominal)
    for role in CUTS:
        for path in draw(pattern, tool).of(role):
            axis = path.curve.flattened(1e-3) - shift
            start = shapely.Point(axis[0])
            ring = min(rings[role], key=start.distance)
            assert not path.curve.closed
            for mark in marks.geoms:
                assert start.distance(mark) > 4.7
            near = shapely.get_coordinates(shapely.line_merge(start.buffer(4.0).intersection(ring)))
            steps = np.diff(near, axis=0)
            turns = np.diff(np.unwrap(np.arctan2(steps[:, 1], steps[:, 0])))
            assert np.abs(turns).max(initial=0.0) < np.radians(25.0)
            # the tip comes down anywhere round the axis and is drawn along
            ahead = np.arctan2(*(axis[1] - axis[0])[::-1])
            for side in np.radians([-150.0, 0.0, 120.0]):
                behind = ahead + np.pi + side
                tip = axis[0] + 0.25 * np.array([np.cos(behind), np.sin(behind)])
                course = shapely.LineString(_drawn_along(axis, tip))
                assert course.buffer(0.06).covers(ring.segmentize(0.1))  # no gap is left


@pytest.mark.parametrize("kind", ["heart", "star", "ring"])
def test_a_start_leaves_no_piece_without_a_length(kind: str) -> None:
    """On a round hole the even places that are tried meet its points."""
    wanted = PatternOptions(intake_kind="nozzle", mirror=True, tie_tab=True)
    pattern = sheet_of(make_pattern(NAMED[kind], 0.005, wanted), wanted)
    for path in draw(pattern, machine("hpgl-plotter")).paths:
        assert path.curve.lengths.min() > 1e-3


def _drawn_along(axis: np.ndarray, tip: np.ndarray) -> np.ndarray:
    """The way of a tip that trails an axis by 0.25 mm."""
    way = shapely.get_coordinates(shapely.LineString(axis).segmentize(0.05))
    tips = [tip]
    for at in way[1:]:
        away = tips[-1] - at
        tips.append(at + 0.25 * away / np.hypot(*away))
    return np.array(tips)


def _shift(paths: tuple, others: list) -> np.ndarray:
    """How much farther from the origin the drawing of a knife lies: by its lowest notch, at which the axis is
    0.25 mm ahead."""
    knife, nominal = ([*each.curve.joints] for each in (_lowest_notch(paths), _lowest_notch(others)))
    along = nominal[1] - nominal[0]
    return knife[0] - nominal[0] - 0.25 * along / np.hypot(*along)


def _lowest_notch(paths: Sequence[Line]) -> Line:
    notches = [path for path in paths if path.role is NOTCH]
    return min(notches, key=lambda path: float(path.curve.joints[0] @ [0.1, 1.0]))

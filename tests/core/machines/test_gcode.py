# SPDX-License-Identifier: LGPL-2.1-or-later
"""G-code run by a controller of the tests' own: where the tool goes, how fast and hot, in what order."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from functools import cache
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
import shapely
import shapely.ops
from drawn_cuts import laid_out
from drawn_shapes import NAMED
from gcode_reader import HOT, KNIFE, LASER, ROOM, SPINDLE, Stroke, film_of, held, lines_of, run

from BalloonWorkbench.core.errors import ExportError, InputError
from BalloonWorkbench.core.machines.machine import FOLDER, machine, read_machine
from BalloonWorkbench.core.machines.machine_file import checked_files, machine_file
from BalloonWorkbench.core.machines.preflight import WARNING, preflight
from BalloonWorkbench.core.options.making import ToolOptions
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.pattern.make import make_pattern, sheet_of
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role
from BalloonWorkbench.core.units import from_mm

NEAR = 0.01  # mm
SQUARE = np.array([[0.0, 0.0], [0.1, 0.0], [0.1, 0.1], [0.0, 0.1]])


@cache
def heart() -> Pattern:
    """Both panels of a small one with notches and a neck, somewhere below and left of the origin."""
    wanted = PatternOptions(notches=3, mirror=True)
    small = NAMED["heart"].map(lambda loop: 0.4 * loop)
    return sheet_of(make_pattern(small, 0.005, wanted), wanted).moved(np.array([-1.7, -0.9]))


@cache
def ring() -> Pattern:
    small = NAMED["ring"].map(lambda loop: 0.8 * loop)
    return make_pattern(small, 0.005, PatternOptions(intake_kind="nozzle"))


def follows(stroke: Stroke, line: shapely.Geometry) -> bool:
    """All along, both ways, and not twice."""
    drawn = shapely.LineString(stroke.line)
    if np.abs(np.subtract(drawn.bounds, line.bounds)).max() > NEAR:
        return False
    apart = shapely.hausdorff_distance(drawn.segmentize(0.2), line.segmentize(0.2))
    return apart < NEAR and abs(drawn.length - line.length) < max(0.05, 1e-3 * line.length)


CUTS = (Role.NOTCH, Role.CUT_INNER, Role.CUT)


@pytest.mark.parametrize(
    ("controller", "wishes"),
    [("grbl", LASER), ("grbl", SPINDLE), ("marlin", LASER), ("linuxcnc", KNIFE), ("linuxcnc", LASER)],
)
def test_cuts_are_those_of_the_pattern(controller: str, wishes: ToolOptions) -> None:
    """Each line once, within 0.01 mm; the reader holds that the tool is up or off between them."""
    for pattern in (heart(), ring()) if controller == "grbl" else (heart(),):
        read = run(pattern, held(controller, wishes))
        lines = lines_of(pattern, *CUTS)
        assert len(read.strokes) == len(lines)
        for line in lines:
            (stroke,) = (each for each in read.strokes if follows(each, line))
            assert set(stroke.feeds) == {wishes.feed}
            if line.is_ring:
                assert stroke.points[0] == pytest.approx(stroke.points[-1], abs=1e-9)
        assert min(min(place) for place in read.places) >= 0.0
        assert read.places[-1] == (0.0, 0.0)
        full = {"grbl": 1000.0, "marlin": 255.0, "linuxcnc": 100.0}[controller]
        speed = {"laser": 0.4 * full, "spindle": 12000.0}.get(str(wishes.tool))
        assert set(read.speeds) == ({speed} if speed else set())
        assert {stroke.height for stroke in read.strokes} == (
            {None} if wishes.tool == "laser" else {-1e3 * wishes.depth}
        )


def test_beam_gets_weaker_where_a_grbl_machine_slows_down() -> None:
    """M4 of its laser mode; the others know it as a spindle that turns the other way."""
    codes = {name: set(run(ring(), held(name, LASER)).codes) for name in ("grbl", "marlin", "linuxcnc")}
    assert {name for name, known in codes.items() if "M4" in known} == {"grbl"}
    assert {name for name, known in codes.items() if "M3" in known} == {"marlin", "linuxcnc"}


def test_what_lies_inside_comes_first() -> None:
    """Panels in the holes of others: no stroke in an area that was cut free before."""
    free: list[shapely.Polygon] = []
    for stroke in run(laid_out(), held("linuxcnc", KNIFE, arcs=False)).strokes:
        way = shapely.LineString(stroke.line)
        place = way.interpolate(0.5, normalized=True)
        assert not any(area.contains(place) for area in free)
        if way.is_ring:
            free.append(shapely.Polygon(stroke.line))
    assert len(free) == 9


@pytest.mark.parametrize("pattern", [heart, ring], ids=["heart", "ring"])
@pytest.mark.parametrize("controller", ["grbl", "marlin"])
def test_welds_are_those_of_the_pattern(controller: str, pattern: object) -> None:
    """Each once from waste film, a closed one 10 mm past its start; open ones out to waste again."""
    sheet = pattern()  # type: ignore[operator]
    read = run(sheet, held(controller, HOT))
    welds, film = lines_of(sheet, Role.SEAL, Role.WELD), film_of(sheet)
    assert len(read.strokes) == len(welds) > 0
    for weld in welds:
        (stroke,) = (each for each in read.strokes if weld.distance(shapely.LineString(each.line)) < NEAR)
        drawn = shapely.LineString(stroke.line)
        assert drawn.buffer(NEAR).covers(weld.segmentize(0.2))
        beside = parts_of(drawn.difference(weld.buffer(NEAR)))
        assert len(beside) == (1 if weld.is_ring else 2)
        assert not film.contains(shapely.Point(stroke.line[0]))
        for way in beside:
            assert way.length < 30.0
            assert not any(other.buffer(0.1).intersects(way) for other in welds if other is not weld)
            assert not any(notch.intersects(way) for notch in lines_of(sheet, Role.NOTCH))
        ways = sum(way.length for way in beside)
        past = 10.0 if weld.is_ring else 0.0
        assert drawn.length == pytest.approx(weld.length + ways + past, abs=0.15)
        assert set(stroke.feeds) == {300.0}
    width, height = np.array(sheet.size) * 1e3 + 2.0 * ROOM
    low, high = np.min(read.places, axis=0), np.max(read.places, axis=0)
    assert (low >= 0.0).all()
    assert (high <= [width, height]).all()


def test_no_way_to_a_weld_crosses_another() -> None:
    """Of two welds round each other the inner one begins on itself; so does one that a notch goes round, and
    one whose piece has no outline that would tell where waste is."""
    cut, *inside = (SQUARE * (1.0 - 20.0 * by) + by for by in (0.0, 0.002, 0.004, 0.012))
    outline, fence = Contour(Role.CUT, cut, True), Contour(Role.NOTCH, inside[0], True)
    outer, inner = (Contour(Role.SEAL, points, True) for points in inside[1:])
    for contours, led in (
        ([outer, outline], 1),
        ([inner, outer, outline], 1),
        ([fence, outer, outline], 0),
        ([outer], 0),
    ):
        pattern = Pattern(tuple(contours), None, 0.005, 0.4)
        strokes = run(pattern, held("grbl", HOT)).strokes
        welds = shapely.union_all(lines_of(pattern, Role.SEAL))
        assert sum(welds.distance(shapely.Point(each.line[0])) > NEAR for each in strokes) == led


def parts_of(geometry: shapely.Geometry) -> list[shapely.Geometry]:
    return [part for part in shapely.get_parts(shapely.line_merge(geometry)) if part.length > 0.1]


def test_only_marlin_heats_a_tip_before_it_comes_down() -> None:
    """The others wait for the user. At the end it is up and cold."""
    read = run(ring(), held("marlin", HOT))
    assert read.heats == [("M104", 180.0, 0), ("M109", 180.0, 0), ("M104", 0.0, len(read.strokes))]
    assert read.heights[0] == read.heights[-1] == 5.0
    for name in ("grbl", "linuxcnc"):
        other = run(ring(), held(name, replace(HOT, tip_temperature=None)))
        assert other.codes.index("M0") < other.codes.index("G1")
        assert not other.heats


def test_corners_are_taken_slowly_and_the_film_warms_first() -> None:
    """Of a weld round a square: at half the feed within 3 mm of its corners only, and round a small spot."""
    weld = Contour(Role.SEAL, SQUARE * 0.5, True)
    turn = np.linspace(0.0, 2.0 * np.pi, 48, endpoint=False)
    spot = Contour(Role.WELD, 0.002 * np.column_stack([np.cos(turn), np.sin(turn)]) + 0.025, True)
    for arcs in (False, True):
        tool = held("marlin", HOT, arcs=arcs)
        slow = replace(tool, tool=replace(tool.tool, corner_feed=0.5, dwell=0.75))
        pattern = Pattern((weld, spot), None, 0.005, 0.2)
        square, round_spot = run(pattern, slow).strokes
        corners = shapely.MultiPoint(SQUARE * 500.0 + ROOM)
        for (start, end), feed in zip(pairwise(square.line), square.feeds, strict=True):
            near = corners.distance(shapely.Point(0.5 * (start + end))) < 3.0
            assert feed == (150.0 if near else 300.0)
        assert set(round_spot.feeds) == {150.0}
        assert square.dwell == round_spot.dwell == 0.75


def test_tip_of_a_swivel_knife_follows_the_cut() -> None:
    """Stepped along the axis' way; it goes 1 mm over its start, nowhere else twice. A corner whose sides are
    shorter than the knife's offset comes out within that offset."""
    step = np.array([[0.0, 0.0], [0.05, 0.0], [0.05, 0.03], [0.0501, 0.0301], [0.0, 0.03]])
    pattern = Pattern((Contour(Role.CUT, step, True),), None, 0.005, 0.2)
    read = run(pattern, held("grbl", KNIFE, knife_offset=from_mm(0.25), overcut=from_mm(1.0)))
    (stroke,), (line,) = read.strokes, lines_of(pattern, Role.CUT)
    way = shapely.get_coordinates(shapely.LineString(stroke.line).segmentize(0.02))
    tip, tips = way[0] - 0.25 * (way[1] - way[0]) / np.hypot(*(way[1] - way[0])), []
    for at in way:
        away = tip - at
        tip = at + 0.25 * away / np.hypot(*away)
        tips.append(tip)
    cut = shapely.LineString(tips)
    assert shapely.hausdorff_distance(cut, line.segmentize(0.2)) < 0.15
    straight = line.difference(shapely.Point(55.1, 35.1).buffer(1.0))
    assert cut.buffer(0.03).covers(straight)
    assert cut.length == pytest.approx(line.length + 1.0, abs=0.1)


def test_same_pattern_same_bytes_and_what_must_be_known_is_in_the_header() -> None:
    content = machine_file(ring(), held("grbl", LASER))
    assert content == machine_file(ring(), held("grbl", LASER))
    head = content.decode("ascii").split("\nG21")[0]
    for word in ("millimetres (G21)", "absolute (G90)", "$32=1", "$30=1000", "Feed 600", "Power 40 %"):
        assert word in head
    lines = [stroke.line for stroke in run(ring(), held("grbl", LASER)).strokes]
    along = sum(np.linalg.norm(np.diff(line, axis=0), axis=1).sum() for line in lines)
    between = sum(np.linalg.norm(after[0] - before[-1]) for before, after in pairwise(lines))
    told = re.search(r"([\d.]+) m along lines, ([\d.]+) m between them", head)
    assert told is not None
    assert [float(length) for length in told.groups()] == pytest.approx(
        [0.001 * along, 0.001 * between], rel=0.01
    )


def test_what_fits_only_turned_is_turned_and_what_does_not_fit_is_refused() -> None:
    long = Pattern((Contour(Role.CUT, SQUARE * [3.5, 1.0], True),), None, 0.005, 0.2)
    tall = held("grbl", LASER, bed=(0.2, 0.4))
    (finding,) = preflight(long, tall)
    assert finding.severity == WARNING
    assert "the file has it turned by 90 degrees" in finding.text
    read = run(long, tall)
    assert np.max(read.places, axis=0) == pytest.approx([105.0, 355.0])
    assert np.min(read.places, axis=0) == pytest.approx([0.0, 0.0])  # where it waits
    assert shapely.LinearRing(read.strokes[0].line[:-1]).is_ccw
    for bed in ((0.3, 0.3), (0.001, 0.001), (0.11, 0.3599)):
        with pytest.raises(ExportError, match="measures 360 x 110 mm"):
            checked_files(long, [held("grbl", LASER, bed=bed)])


@pytest.mark.parametrize(
    ("name", "wishes", "words"),
    [
        ("grbl", ToolOptions(), ("feed and power of your laser", "--feed", "My machines")),
        ("grbl", ToolOptions("spindle", feed=1.0), ("speed of the spindle and depth",)),
        ("marlin", ToolOptions(feed=300.0), ("temperature and depth of your hot tip",)),
        ("linuxcnc", ToolOptions("hot-wheel", feed=9.0), ("depth of your hot wheel",)),
    ],
)
def test_what_nobody_knows_is_asked_for(name: str, wishes: ToolOptions, words: tuple[str, ...]) -> None:
    """By the check and by the writer, in one sentence; nothing is assumed."""
    made_for = held(name, wishes)
    errors = [finding.text for finding in preflight(ring(), made_for) if finding.severity == "error"]
    assert len(errors) == 1
    with pytest.raises(ExportError) as caught:
        machine_file(ring(), made_for)
    assert str(caught.value) == errors[0]
    assert all(word in errors[0] for word in words), errors[0]


@pytest.mark.parametrize(
    ("name", "wishes", "text"),
    [
        ("grbl", {"feed": 0.0}, "feed of a laser must be from 1 mm/min to 100000 mm/min"),
        ("grbl", {"feed": -600.0}, "feed"),
        ("grbl", {"feed": float("nan")}, "feed"),
        ("grbl", {"feed": float("inf")}, "feed"),
        ("grbl", {"power": 101.0}, "power"),
        ("grbl", {"power": float("nan")}, "power"),
        ("grbl", {"tool": "spindle", "spindle_speed": 0.0}, "spindle"),
        ("marlin", {"tip_temperature": 900.0}, "temperature of a hot tip must be from 40C to 400C"),
        ("marlin", {"tip_temperature": 280.0}, "temperature"),
        ("marlin", {"depth": -0.006}, "is 6 mm above the film, and lifted 5 mm only"),
        ("marlin", {"depth": -1.0}, "depth"),
    ],
)
def test_senseless_settings_are_a_sentence(name: str, wishes: dict[str, object], text: str) -> None:
    with pytest.raises(InputError, match=text):
        held(name, ToolOptions(**wishes))  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("values", "text"),
    [
        ({"feed_mm_min": 0}, "feed"),
        ({"feed_mm_min": "quick"}, "feed_mm_min"),
        ({"feed_mm_min": True}, "feed_mm_min"),
        ({"temperature_C": 450}, "40C to 400C"),
        ({"temperature_C": -400}, "colder"),
        ({"corner_feed_percent": 0}, "corners"),
        ({"dwell_s": 60}, "dwell"),
        ({"kind": "axe"}, "axe"),
        ({"speed": 3}, "speed"),
        ({"turning_axis": "C"}, "No axis turns a hot tip"),
        ({"kind": "hot-wheel", "turning_axis": "U"}, "give A, B, C"),
    ],
)
def test_mistakes_in_a_machines_file_are_named(tmp_path: Path, values: dict[str, object], text: str) -> None:
    data = json.loads((FOLDER / "gcode-marlin.json").read_text(encoding="utf-8"))
    data["tool"] |= values
    path = tmp_path / "gcode-marlin.json"
    path.write_text(json.dumps(data), encoding="utf-8")
    with pytest.raises(InputError, match=text) as caught:
        read_machine(path)
    assert "gcode-marlin.json" in str(caught.value)


def test_what_an_axis_cannot_turn_is_refused(tmp_path: Path) -> None:
    """GRBL has no such axis, and what swivels is not turned."""
    for name, changes, text in (
        ("grbl", {}, "GRBL knows X, Y and Z only"),
        ("linuxcnc", {"knife_offset_mm": 0.5}, "set knife_offset_mm to 0"),
    ):
        data = json.loads((FOLDER / f"gcode-{name}.json").read_text(encoding="utf-8"))
        data["tool"] |= {"kind": "knife", "turning_axis": "C"}
        data["tool"].pop("power_percent", None)
        path = tmp_path / f"{name}.json"
        path.write_text(json.dumps({**data, "layers": {"CUT": {}}, **changes}), encoding="utf-8")
        with pytest.raises(InputError, match=text):
            read_machine(path)


def test_a_users_own_machine_needs_no_options(tmp_path: Path) -> None:
    """All in its file; fumes are warned of where PTFE decomposes."""
    data = json.loads((FOLDER / "gcode-marlin.json").read_text(encoding="utf-8"))
    data["tool"] |= {"feed_mm_min": 240, "temperature_C": 280, "depth_mm": 0.3}
    path = tmp_path / "mine.json"
    path.write_text(json.dumps({**data, "name": "mine"}), encoding="utf-8")
    files, doubts = checked_files(ring(), [replace(machine(str(path)), bed=None)])
    assert list(files) == ["pattern-mine.gcode"]
    assert ["PTFE" in doubt for doubt in doubts] == [True]
    del data["tool"]
    path.write_text(json.dumps({**data, "name": "mine"}), encoding="utf-8")
    with pytest.raises(InputError, match="tool"):
        read_machine(path)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Machines as data: what ships, what a user may change, and what is refused."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
import shapely
from drawn_shapes import NAMED

from BalloonWorkbench.core.arcs.curves import Curve, polyline
from BalloonWorkbench.core.arcs.fit_arcs import fit_curve
from BalloonWorkbench.core.errors import ExportError, InputError
from BalloonWorkbench.core.machines.contour.compensate import overrun, trailing_knife, without_kerf
from BalloonWorkbench.core.machines.machine import FOLDER, machine, machines, read_machine
from BalloonWorkbench.core.machines.machine_file import checked_files, machine_file
from BalloonWorkbench.core.machines.preflight import ERROR, WARNING, preflight
from BalloonWorkbench.core.machines.toolpaths import BAR, draw
from BalloonWorkbench.core.pattern.build import build_pattern
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role

SQUARE = np.array([[0.0, 0.0], [0.1, 0.0], [0.1, 0.1], [0.0, 0.1]])


def changed(folder: Path, **values: object) -> Path:
    data = json.loads((FOLDER / "lightburn.json").read_text(encoding="utf-8"))
    data.update(values)
    path = folder / f"{data['name']}.json"
    path.write_text(json.dumps(data), encoding="utf-8")
    return path


def pattern_of(*contours: Contour) -> Pattern:
    return Pattern(contours, None, 0.005, 0.4)


def test_every_wanted_machine_is_there() -> None:
    assert {"lightburn", "rdworks", "silhouette", "cricut", "glowforge", "inkscape", "cutting-shop",
            "hpgl-plotter", "paper", "heat-sealer"} <= set(machines())  # fmt: skip
    assert machine("glowforge").format == "svg"
    assert machine("Cutting Shop").version == "R12"
    for name, found in machines().items():
        assert found.kerf == found.knife_offset == 0.0, name


def test_a_copy_of_the_users_own_comes_first(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("BALLOON_MACHINES", str(tmp_path))
    changed(tmp_path, kerf_mm=0.2)
    changed(tmp_path, name="mine")
    assert machine("lightburn").kerf == pytest.approx(0.0002)
    assert "mine" in machines()
    assert machine(str(tmp_path / "mine.json")).name == "mine"


@pytest.mark.parametrize(
    ("values", "text"),
    [
        ({"format": "cdr"}, "cdr"),
        ({"version": "R14"}, "R14"),
        ({"unit": "cm"}, "cm"),
        ({"kerf_mm": -1}, "kerf_mm"),
        ({"kerf_mm": "wide"}, "kerf_mm"),
        ({"arcs": 1}, "arcs"),
        ({"bed_mm": [100]}, "bed_mm"),
        ({"layers": {}}, "layer"),
        ({"layers": {"SLICE": {}}}, "SLICE"),
        ({"layers": {"CUT": {"name": "cut here"}}}, "cut here"),
        ({"layers": {"CUT": {"rgb": "red"}}}, "red"),
        ({"layers": {"CUT": {"aci": 0}}}, "0"),
        ({"colour": "red"}, "colour"),
        ({"format": "hpgl", "version": ""}, "arcs"),
    ],
)
def test_mistakes_are_named(tmp_path: Path, values: dict[str, object], text: str) -> None:
    with pytest.raises(InputError, match=text) as caught:
        read_machine(changed(tmp_path, **values))
    assert "lightburn.json" in str(caught.value)


def test_missing_key_and_wrong_name(tmp_path: Path) -> None:
    path = changed(tmp_path)
    data = json.loads(path.read_text(encoding="utf-8"))
    del data["unit"]
    path.write_text(json.dumps(data), encoding="utf-8")
    with pytest.raises(InputError, match="lacks 'unit'"):
        read_machine(path)
    path.write_text("{", encoding="utf-8")
    with pytest.raises(InputError, match="no use"):
        read_machine(path)
    with pytest.raises(InputError, match="both the same name"):
        read_machine(changed(tmp_path).rename(tmp_path / "other.json"))
    with pytest.raises(InputError, match="lightburn"):
        machine("sharp stick")


def test_order_bar_and_no_duplicates() -> None:
    hole = Contour(Role.CUT_INNER, SQUARE[::-1] * 0.2 + 0.04, True)
    cut = Contour(Role.CUT, SQUARE, True)
    drawing = draw(pattern_of(cut, hole, hole, cut), machine("lightburn"))
    assert [path.role for path in drawing.paths] == [Role.REGISTRATION] * 3 + [Role.CUT_INNER, Role.CUT]
    bar = drawing.paths[0].curve
    assert bar.length == pytest.approx(BAR)
    low = np.min([path.curve.bounds[0] for path in drawing.paths], axis=0)
    assert low == pytest.approx([0.0, 0.0], abs=1e-9)
    assert drawing.of(Role.CUT)[0].curve.length == pytest.approx(400.0)


def test_nothing_for_the_machine() -> None:
    with pytest.raises(ExportError, match="SEAL"):
        draw(pattern_of(Contour(Role.CUT, SQUARE, True)), machine("heat-sealer"))
    with pytest.raises(ExportError, match="pages"):
        machine_file(pattern_of(Contour(Role.CUT, SQUARE, True)), machine("lightburn"), "A4")


def test_kerf_grows_the_outside_and_shrinks_holes() -> None:
    (outer,) = without_kerf(Contour(Role.CUT, SQUARE, True), 0.001)
    assert shapely.Polygon(outer).area == pytest.approx(0.101**2)
    (inner,) = without_kerf(Contour(Role.CUT_INNER, SQUARE[::-1], True), 0.001)
    assert shapely.Polygon(inner).area == pytest.approx(0.099**2)
    assert without_kerf(Contour(Role.CUT_INNER, SQUARE[::-1] * 0.001, True), 0.001) == ()


def test_knife_tip_follows_the_line() -> None:
    """A tip that trails the axis like a castor, stepped along the axis' way, stays on the curve."""
    curve = fit_curve(NAMED["heart"].outer * 0.2, True).moved(np.zeros(2), 1000.0)
    axis = trailing_knife(curve, 0.5).flattened(1e-3)
    way = np.concatenate([np.linspace(a, b, 12, endpoint=False) for a, b in pairwise(axis)])
    tip = curve.joints[0].copy()
    line = shapely.LinearRing(curve.flattened(1e-4))
    off = []
    for at in way:
        away = tip - at
        tip = at + 0.5 * away / np.hypot(*away)
        off.append(line.distance(shapely.Point(tip)))
    assert max(off) < 0.02


def test_knife_swings_at_corners() -> None:
    swung = trailing_knife(polyline(SQUARE * 1000.0, True), 1.0)
    assert len(swung) == 8
    assert swung.bounds[0] == pytest.approx([-1.0, -1.0])
    assert swung.bounds[1] == pytest.approx([101.0, 101.0])
    assert swung.radii[swung.bulges != 0.0] == pytest.approx(np.ones(4))


def test_weld_runs_past_its_start() -> None:
    seal = polyline(SQUARE * 1000.0, True)
    longer = overrun(seal, 150.0)
    assert not longer.closed
    assert longer.length == pytest.approx(550.0)
    assert longer.joints[-1] == pytest.approx([100.0, 50.0])
    circle = Curve(np.array([[0.0, 0.0], [2.0, 0.0]]), np.ones(2), True)
    assert overrun(circle, 0.5 * np.pi).joints[-1] == pytest.approx([1.0, -1.0])


def test_preflight_of_good_patterns() -> None:
    assert preflight(build_pattern(NAMED["heart"], 0.005), machine("lightburn")) == ()


def test_open_and_crossing_lines_are_errors() -> None:
    bow = np.array([[0.0, 0.0], [0.1, 0.1], [0.1, 0.0], [0.0, 0.1]])
    (finding,) = preflight(pattern_of(Contour(Role.CUT, bow, True)), machine("lightburn"))
    assert finding.severity == ERROR
    assert finding.place == pytest.approx([0.05, 0.05])
    assert "(50, 50) mm" in finding.text
    (finding,) = preflight(pattern_of(Contour(Role.CUT, SQUARE, False)), machine("lightburn"))
    assert finding.severity == ERROR
    assert "open" in finding.text
    hole = Contour(Role.CUT_INNER, SQUARE[::-1] + 0.05, True)
    findings = preflight(pattern_of(Contour(Role.CUT, SQUARE, True), hole), machine("lightburn"))
    assert "meet" in findings[0].text


def test_what_is_written_is_what_is_checked() -> None:
    """The fault that a file would have is named where it is: a crack in a tip, lines that kerf or arcs let
    cross."""
    turn = np.linspace(0.2, 2.0 * np.pi - 0.2, 90)
    drop = np.stack([0.01 * np.cos(turn), 0.01 * np.sin(turn)], axis=1)[::-1] + 0.05
    crack = np.concatenate([drop, [[0.0598, 0.05], [0.075, 0.05 + 1e-9], [0.0599, 0.05 + 1e-9]]])
    pattern = pattern_of(Contour(Role.CUT_INNER, crack, True), Contour(Role.CUT, SQUARE, True))
    for name in ("any-dxf", "lightburn"):
        errors = [each for each in preflight(pattern, machine(name)) if each.severity == ERROR]
        assert errors, name
        assert "itself" in errors[0].text
        assert errors[0].place == pytest.approx([0.067, 0.05], abs=0.009)
    near = Contour(Role.CUT, SQUARE + np.array([0.1004, 0.0]), True)
    two = pattern_of(Contour(Role.CUT, SQUARE, True), near)
    tool = replace(machine("any-dxf"), kerf=0.0003)
    assert preflight(two, tool) == ()
    (finding,) = preflight(two, replace(tool, kerf=0.0005))
    assert finding.severity == ERROR
    assert "CUT and CUT lines meet" in finding.text


def test_knives_run_past_their_start(tmp_path: Path) -> None:
    """As far as the file says; else as far as a knife takes to swing round. Nothing else does."""
    assert {name for name, known in machines().items() if known.overcut} == {"hpgl-plotter"}
    assert read_machine(changed(tmp_path, knife_offset_mm=0.25)).overcut == pytest.approx(0.0015)
    assert read_machine(changed(tmp_path, knife_offset_mm=0.25, overcut_mm=0)).overcut == 0.0
    knife = read_machine(changed(tmp_path, overcut_mm=2))
    pattern = pattern_of(Contour(Role.SEAL, SQUARE * 0.9 + 0.005, True), Contour(Role.CUT, SQUARE, True))
    (cut,), (seal,) = (draw(pattern, knife).of(role) for role in (Role.CUT, Role.SEAL))
    assert (cut.curve.closed, seal.curve.closed) == (False, True)
    assert cut.curve.length == pytest.approx(402.0)
    with pytest.raises(InputError, match="overcut_mm"):
        read_machine(changed(tmp_path, overcut_mm=-1))


def test_unsuitable_machines_are_left_out() -> None:
    """The others get their files; only where nothing is left it is an error."""
    pattern = pattern_of(Contour(Role.CUT, SQUARE * 7.0, True))
    chosen = [machine(name) for name in ("glowforge", "inkscape", "heat-sealer", "cutting-shop")]
    contents, remarks = checked_files(pattern, chosen)
    assert set(contents) == {"pattern-inkscape.svg", "pattern-cutting-shop_mm.dxf"}
    large, empty = remarks
    assert large.startswith("No file for Glowforge: The pattern measures 700 x 710 mm")
    assert empty.startswith("The pattern has no lines for Heat sealer on a plotter")
    with pytest.raises(ExportError, match=r"(?s)Glowforge.*Heat sealer"):
        checked_files(pattern, [chosen[0], chosen[2]])
    assert checked_files(pattern, []) == ({}, ())


def test_narrow_places_are_found() -> None:
    """A hole 0.6 mm from the edge, and a slit whose sides are 0.5 mm apart."""
    hole = Contour(Role.CUT_INNER, SQUARE[::-1] * 0.2 + [0.0006, 0.04], True)
    (finding,) = preflight(pattern_of(Contour(Role.CUT, SQUARE, True), hole), machine("lightburn"))
    assert finding.severity == WARNING
    assert "0.6 mm" in finding.text
    assert finding.place[0] == pytest.approx(0.0003, abs=1e-4)
    slit = np.array(
        [[0.0, 0.0], [0.1, 0.0], [0.1, 0.1], [0.0502, 0.1], [0.05, 0.02], [0.0497, 0.1], [0.0, 0.1]]
    )
    findings = preflight(pattern_of(Contour(Role.CUT, slit, True)), machine("lightburn"))
    assert any("stay between" in finding.text for finding in findings)


def test_smallest_radius() -> None:
    turn = np.linspace(0.0, 2.0 * np.pi, 60, endpoint=False)
    tiny = np.stack([np.cos(turn), np.sin(turn)], axis=1)[::-1] * 0.0002 + 0.05
    contours = Contour(Role.CUT, SQUARE, True), Contour(Role.CUT_INNER, tiny, True)
    findings = preflight(pattern_of(*contours), machine("lightburn"))
    assert any("radius is 0.2" in finding.text for finding in findings)


def test_a_slight_bend_has_no_radius_to_follow() -> None:
    """Two arcs that meet at 22 degrees: a tool that follows 0.5 mm passes those tips 0.007 mm beside."""
    turn = np.radians(np.linspace(-79.0, 79.0, 159))
    side = 0.01 * np.stack([np.cos(turn), np.sin(turn)], axis=1) - [0.01 * np.cos(turn[0]), 0.0]
    lens = np.concatenate([side[:-1], -side[:-1]])
    tool = replace(machine("inkscape"), least_radius=0.0005)
    assert preflight(pattern_of(Contour(Role.CUT, lens, True)), tool) == ()


def test_bed_in_both_units() -> None:
    tall = pattern_of(Contour(Role.CUT, SQUARE * [3.0, 5.5], True))
    (turned,) = preflight(tall, machine("lightburn"))
    assert turned.severity == WARNING
    assert "turn the pattern" in turned.text
    (large,) = preflight(pattern_of(Contour(Role.CUT, SQUARE * 7.0, True)), machine("lightburn"))
    assert large.severity == ERROR
    assert "700 x 710 mm (27.56 x 27.95 in)" in large.text  # with the control bar
    assert preflight(pattern_of(Contour(Role.CUT, SQUARE * 7.0, True)), machine("inkscape")) == ()


def header_of(content: bytes) -> dict[str, list[str]]:
    """The variables of a DXF header and the values of their groups, read line by line."""
    lines = [line.strip() for line in content.decode("cp1252").splitlines()]
    end = lines.index("ENDSEC")
    found: dict[str, list[str]] = {}
    for code, value in zip(lines[0:end:2], lines[1:end:2]):
        if code == "9":
            found[value] = []
        elif found:
            found[list(found)[-1]].append(value)
    return found


@pytest.mark.parametrize("name", [name for name, made_for in machines().items() if made_for.format == "dxf"])
def test_unit_of_a_dxf_is_that_of_its_coordinates(name: str) -> None:
    """AutoCAD's codes: 1 inches, 4 millimetres; R12 knows none. A square of 100 mm has that size in them."""
    made_for = machine(name)
    role = Role.CUT if Role.CUT in made_for.layers else Role.SEAL
    content = machine_file(
        pattern_of(Contour(role, SQUARE, True)), replace(made_for, control_bar=False, overrun=0.0)
    )
    header = header_of(content)
    side = {"mm": 100.0, "in": 100.0 / 25.4}[made_for.unit]
    assert [float(value) for value in header["$EXTMAX"]] == pytest.approx([side, side, 0.0], abs=1e-5)
    assert [float(value) for value in header["$LIMMAX"]] == pytest.approx([side, side], abs=1e-5)
    assert [float(value) for value in (*header["$EXTMIN"], *header["$LIMMIN"])] == [0.0] * 5
    assert header["$LUNITS"] == ["2"]
    if made_for.version == "R12":
        assert "$INSUNITS" not in header
    else:
        assert header["$INSUNITS"] == [{"mm": "4", "in": "1"}[made_for.unit]]
        assert header["$MEASUREMENT"] == [{"mm": "1", "in": "0"}[made_for.unit]]


def test_hpgl_repeats_no_point() -> None:
    """Points nearer than a plotter unit of 0.025 mm are one: else the tool dwells there and burns."""
    turns = np.linspace(0.0, 2.0 * np.pi, 4000, endpoint=False)
    circle = 0.005 * np.column_stack([np.cos(turns), np.sin(turns)])
    doubled = np.repeat(SQUARE, 3, axis=0) + 1e-7 * np.arange(12)[:, None]
    text = machine_file(
        pattern_of(Contour(Role.CUT, circle, True), Contour(Role.CUT, doubled + 0.01, True)),
        machine("hpgl-plotter"),
    ).decode("ascii")
    lines: list[list[tuple[int, int]]] = []
    for command in text.replace("\n", "").split(";"):
        numbers = [int(number) for number in command[2:].split(",")] if command[:2] in ("PU", "PD") else []
        points = list(zip(numbers[::2], numbers[1::2]))
        if command.startswith("PU"):
            lines.append(points)
        elif points:
            assert len(points) <= 50
            lines[-1] += points
    *drawn, home = lines
    assert home == [(0, 0)]
    assert all(a != b for points in drawn for a, b in pairwise(points))
    square, circle = sorted(map(len, (points for points in drawn if len(points) > 2)))
    assert 5 <= square <= 8  # once round, and a little further for the knife
    assert circle > 500  # still round


def numbers_of(content: bytes, format: str) -> np.ndarray:
    """All corners (n, 2) in a file of polylines, as it is written."""
    text = content.decode("latin-1")
    if format == "svg":
        words = re.findall(r"-?\d[\d.]*", " ".join(re.findall(r' d="([^"]*)"', text)))
    elif format == "hpgl":
        words = re.findall(r"-?\d+", " ".join(re.findall(r"P[UD]([-\d,]+);", text)[:-1]))
    else:
        lines = [line.strip() for line in text.splitlines()]
        start = lines.index("ENTITIES")
        lines = lines[: lines.index("ENDSEC", start)]
        pairs = list(zip(lines[start + 1 :: 2], lines[start + 2 :: 2]))
        began = [k for k, pair in enumerate(pairs) if pair in (("0", "LWPOLYLINE"), ("0", "VERTEX"))]
        words = [value for code, value in pairs[began[0] :] if code in ("10", "20")]
    return np.array(words, dtype=float).reshape(-1, 2)


@pytest.mark.parametrize("name", ["any-dxf", "any-svg", "rdworks", "hpgl-plotter"])
def test_sheet_begins_at_the_origin(name: str) -> None:
    """Wherever the pattern lies: a rectangle of 100 by 60 mm, which is not square, beside the origin."""
    rectangle = np.array([[0.0, 0.0], [0.1, 0.0], [0.1, 0.06], [0.0, 0.06]])
    rectangle += np.array([-0.23, 0.41])
    made_for = replace(machine(name), control_bar=False)
    drawing = draw(pattern_of(Contour(Role.CUT, rectangle, True)), made_for)
    assert (drawing.width, drawing.height) == pytest.approx((100.0, 60.0))
    content = machine_file(pattern_of(Contour(Role.CUT, rectangle, True)), made_for)
    points = numbers_of(content, made_for.format) / (40.0 if made_for.format == "hpgl" else 1.0)
    assert made_for.format == "hpgl" or len(points) == 5  # it begins amid an edge
    assert points.min(axis=0) == pytest.approx((0.0, 0.0), abs=1e-6)
    assert points.max(axis=0) == pytest.approx((100.0, 60.0), abs=0.013)


def test_control_bar_has_ticks_across_its_ends() -> None:
    drawing = draw(pattern_of(Contour(Role.CUT, SQUARE, True)), machine("rdworks"))
    line, *ticks = (path.curve.joints for path in drawing.of(Role.REGISTRATION))
    assert np.ptp(line, axis=0) == pytest.approx((100.0, 0.0))
    assert len(ticks) == 2
    for tick, end in zip(ticks, line):
        assert tick.mean(axis=0) == pytest.approx(end)
        assert np.ptp(tick, axis=0) == pytest.approx((0.0, 4.0))
    (square,) = (path.curve.joints for path in drawing.of(Role.CUT))
    assert square[:, 1].min() - line[:, 1].max() == pytest.approx(8.0)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kinds of intakes, where they sit, and the pieces they need: measured with polygons and distances."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
import shapely
from drawn_shapes import NAMED, corners_of, generated, polar

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.pattern.build import build_pattern
from BalloonWorkbench.core.pattern.intake.kinds import FOLDER, intake_kind, intake_kinds, measure, read_kind
from BalloonWorkbench.core.pattern.intake.rim import Rim
from BalloonWorkbench.core.pattern.make import make_pattern, sheet_of
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role

SEAL, ALLOWANCE = 0.005, 0.002
KINDS = ("straw", "film-valve", "one-way-tail", "nozzle")
NECKS = KINDS[:3]


def line(contour: Contour) -> shapely.Geometry:
    return (shapely.LinearRing if contour.closed else shapely.LineString)(contour.points)


def seals(pattern: Pattern) -> shapely.Geometry:
    return shapely.union_all([line(contour) for contour in pattern.of(Role.SEAL)])


def panel(name: str, kind: str, **more: object) -> Pattern:
    return make_pattern(NAMED[name], SEAL, PatternOptions(intake_kind=kind, **more))


def axis_of(pattern: Pattern) -> np.ndarray:
    assert pattern.intake is not None
    return np.array([np.cos(pattern.intake.angle), np.sin(pattern.intake.angle)])


def test_the_kinds_that_are_wanted_are_there() -> None:
    assert tuple(sorted(intake_kinds())) == tuple(sorted(KINDS))
    assert next(iter(intake_kinds())) == "straw"
    assert intake_kind("straw").width == 0.010
    for kind in intake_kinds().values():
        assert kind.note.endswith(".")
        assert len(kind.note) < 320
    with pytest.raises(InputError, match="straw, film-valve"):
        intake_kind("funnel")


@pytest.mark.parametrize("name", ["disc", "heart", "star", "ring"])
@pytest.mark.parametrize("kind", KINDS)
def test_every_kind_can_be_made(name: str, kind: str) -> None:
    """Cut and weld are simple, the weld is open at a mouth only, marks are on the film beside the weld."""
    pattern = panel(name, kind)
    (cut,) = pattern.of(Role.CUT)
    film = shapely.Polygon(cut.points)
    for contour in pattern.contours:
        assert line(contour).is_simple
    opened = [contour for contour in pattern.of(Role.SEAL) if not contour.closed]
    assert len(opened) == (kind in NECKS)
    assert line(cut).distance(seals(pattern)) == pytest.approx(0.0 if opened else 0.0045, abs=2e-5)
    for mark in (*pattern.of(Role.FOLD), *pattern.of(Role.PEN)):
        assert film.covers(line(mark))
        assert line(mark).distance(seals(pattern)) > 0.5 * SEAL - 2e-5


@pytest.mark.parametrize("kind", NECKS)
def test_air_passes_the_whole_neck(kind: str) -> None:
    """The way between the welds, measured across: full width at the root, the taper's at the mouth."""
    pattern, known = panel("disc", kind), intake_kind(kind)
    intake, axis = pattern.intake, axis_of(panel("disc", kind))
    assert intake is not None
    side = np.array([-axis[1], axis[0]])
    free = shapely.Polygon(pattern.of(Role.CUT)[0].points).difference(seals(pattern).buffer(0.5 * SEAL))
    for share in np.linspace(0.3, 0.95, 9):
        at = intake.at + share * intake.length * axis
        cut = free.intersection(shapely.LineString([at - 0.1 * side, at + 0.1 * side]))
        across = min(shapely.get_parts(cut), key=shapely.Point(at).distance)  # not the allowance beside it
        wanted = intake.width * (1.0 - (1.0 - known.taper) * share)
        assert across.length == pytest.approx(wanted, abs=1e-4)


def test_valve_strips_fit_the_neck() -> None:
    """Between their own welds 10 mm at the mouth, as wide as the neck with both its welds, 100 mm long."""
    wanted = PatternOptions(intake_kind="film-valve")
    sheet = sheet_of(make_pattern(NAMED["heart"], SEAL, wanted), wanted)
    strip = min(sheet.of(Role.CUT), key=lambda cut: (cut.stock == "", cut.points[0, 1]))
    width, height = np.ptp(strip.points, axis=0)
    assert (width, height) == pytest.approx((0.024 + 2 * SEAL, 0.100))
    inside = shapely.Polygon(strip.points).buffer(1e-9)
    first, second = (c.points for c in sheet.of(Role.SEAL) if inside.covers(line(c)))
    gap = np.abs(first[:, 0] - second[:, 0]) - SEAL
    assert gap == pytest.approx([0.010, 0.008], abs=1e-6)
    letters = [c for c in sheet.of(Role.ENGRAVE) if inside.covers(line(c))]
    assert len(letters) == 6  # V A L V E, the A with its counter
    assert sheet.contours[-1].role is Role.CUT
    whole = shapely.Polygon(sheet.of_stock("").of(Role.CUT)[-1].points)
    assert whole.distance(inside) > 0.0049


def test_only_the_front_panel_gets_the_hole_of_a_nozzle() -> None:
    wanted = PatternOptions(intake_kind="nozzle")
    pattern = make_pattern(NAMED["heart"], SEAL, wanted)
    (hole,) = pattern.of(Role.CUT_INNER)
    assert np.hypot(*(hole.points - pattern.intake.at).T) == pytest.approx(0.004)
    assert line(pattern.of(Role.PEN)[0]).distance(seals(pattern)) > 0.5 * SEAL + 0.0029
    sheet = sheet_of(pattern, wanted)
    sizes = sorted(shapely.Polygon(cut.points).area for cut in sheet.of(Role.CUT))
    assert len(sizes) == 3
    assert sizes[0] == pytest.approx(np.pi * 0.016**2, rel=2e-3)  # the ring
    assert sizes[1] == pytest.approx(sizes[2])
    panels = [shapely.Polygon(cut.points) for cut in sheet.of(Role.CUT)]
    holes = [sum(each.contains(line(inner)) for inner in sheet.of(Role.CUT_INNER)) for each in panels]
    assert sorted(holes) == [0, 1, 1]
    assert "Cut it once" in sheet.warnings[-1]


@pytest.mark.parametrize("degrees", [0.0, 30.0, 90.0, 215.0, 359.0])
def test_place_along_the_seam(degrees: float) -> None:
    """On a circle the arc length is the angle; the neck leaves square to the rim."""
    turn = np.radians(degrees)
    pattern = build_pattern(Outline(polar(0.15)), SEAL, PatternOptions(intake_along=0.15 * turn))
    assert pattern.intake is not None
    assert pattern.intake.at == pytest.approx([0.15 * np.cos(turn), 0.15 * np.sin(turn)], abs=1e-4)
    assert np.cos(pattern.intake.angle - turn) == pytest.approx(1.0, abs=1e-4)
    assert pattern.intake.along == pytest.approx(0.15 * turn, abs=1e-4)


def test_rim_by_hand() -> None:
    rim = Rim(corners_of((0.0, 0.0), (0.2, 0.0), (0.2, 0.1), (0.0, 0.1)).outer[::-1])
    assert rim.length == pytest.approx(0.6)
    assert rim.at(0.0) == pytest.approx([0.2, 0.0])
    assert rim.at(0.15) == pytest.approx([0.15, 0.1])
    assert rim.at(0.75) == pytest.approx([0.15, 0.1])
    assert np.degrees(rim.outward(0.2, 0.005)) == pytest.approx(90.0)
    assert rim.nearest(np.array([0.05, -0.3])) == pytest.approx(0.45)


def test_a_found_place_comes_back_as_it_was() -> None:
    """What a user sees as the automatic place can be typed."""
    for seed in range(6):
        found = build_pattern(generated(seed), SEAL).intake
        again = build_pattern(
            generated(seed), SEAL, PatternOptions(intake_along=found.along, intake_angle=found.angle)
        ).intake
        assert again.at == pytest.approx(found.at, abs=1e-6)
        assert again.angle == pytest.approx(found.angle)


@pytest.mark.parametrize("waist", [0.004, 0.007])
def test_a_narrow_way_is_told(waist: float) -> None:
    """A small head on a waist that is narrower than the intake."""
    body, head = shapely.Point(0.0, 0.0).buffer(0.08), shapely.Point(0.0, 0.12).buffer(0.02)
    shape = shapely.union_all([body, head, shapely.box(-0.5 * waist, 0.0, 0.5 * waist, 0.12)])
    seam = Outline(np.asarray(shape.exterior.coords)[:-1][::-1])
    (text,) = build_pattern(seam, 0.003, PatternOptions(intake_angle=0.5 * np.pi)).warnings
    found = float(text.split("narrows to ")[1].split(" mm")[0])
    assert found == pytest.approx(1000.0 * waist, abs=0.2)
    assert build_pattern(seam, 0.003, PatternOptions(intake_angle=-0.5 * np.pi)).warnings == ()


def test_no_room_for_a_flange() -> None:
    strip = corners_of((0.0, 0.0), (0.3, 0.0), (0.3, 0.03), (0.0, 0.03))
    with pytest.raises(InputError, match="no room for a flange of 26 mm"):
        build_pattern(strip, SEAL, PatternOptions(intake_kind="nozzle"))
    small = build_pattern(
        strip, SEAL, PatternOptions(intake_kind="nozzle", intake_width=0.004, intake_length=0.012)
    )
    assert small.intake.length == 0.012
    with pytest.raises(InputError, match="wider than its bore"):
        build_pattern(strip, SEAL, PatternOptions(intake_kind="nozzle", intake_length=0.006))


SIZES = {"L": 0.040, "W": 0.010, "S": 0.005, "A": 0.002}


@pytest.mark.parametrize(
    ("text", "value"),
    [("3", 3.0), ("-1.5", -1.5), ("L - 10", 30.0), ("0.5 W+S", 10.0), ("-5 - 0.5 S", -7.5), ("S + A", 7.0)],
)
def test_sums_by_hand(text: str, value: float) -> None:
    assert measure(text, SIZES) == pytest.approx(0.001 * value)


@pytest.mark.parametrize("text", ["", "L W", "2 * W", "X", "1 2", "W +"])
def test_other_sums_are_refused(text: str) -> None:
    with pytest.raises(InputError):
        measure(text, SIZES)


@pytest.mark.parametrize(
    ("change", "text"),
    [
        ({"place": "top"}, "neither rim nor film"),
        ({"taper": 2.0}, "taper"),
        ({"length": "long"}, "no sum"),
        ({"lines": [{"role": "SLICE", "points": []}]}, "SLICE"),
        ({"name": "other"}, "same name"),
        ({"pieces": [{"label": "A", "label_at": ["0", "0"],
                      "lines": [{"role": "PEN", "circle": ["0", "0"], "radius": "W"}]}]}, "its CUT"),
    ],
)  # fmt: skip
def test_mistakes_in_files_are_named(tmp_path: Path, change: dict[str, object], text: str) -> None:
    data = json.loads((FOLDER / "straw.json").read_text(encoding="utf-8"))
    path = tmp_path / "straw.json"
    path.write_text(json.dumps({**data, **change}), encoding="utf-8")
    with pytest.raises(InputError, match=text) as caught:
        read_kind(path)
    assert "straw.json" in str(caught.value)

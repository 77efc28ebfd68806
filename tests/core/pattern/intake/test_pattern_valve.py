# SPDX-License-Identifier: LGPL-2.1-or-later
"""The film valve: of a film of its own, on films that it welds to, with a channel that no weld closes."""

from __future__ import annotations

import io
import json
from dataclasses import replace
from pathlib import Path

import ezdxf
import numpy as np
import pytest
import shapely
from drawn_shapes import NAMED, corners_of, hole, polar

from BalloonWorkbench.cli import command_line
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.library import custom_film, film, films
from BalloonWorkbench.core.machines.machine import machines
from BalloonWorkbench.core.machines.machine_file import checked_files
from BalloonWorkbench.core.machines.tool import lacking
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.pattern.build import build_pattern
from BalloonWorkbench.core.pattern.make import make_pattern, pieces_remarks, sheet_of
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role
from BalloonWorkbench.core.products import by_stock, pieces_of

SEAL = 0.005
VALVE = PatternOptions(intake_kind="film-valve")


def outlines(pattern: Pattern) -> list[shapely.Geometry]:
    return [shapely.Polygon(cut.points) for cut in pattern.of(Role.CUT)]


@pytest.mark.parametrize(("mirror", "copies"), [(False, 1), (True, 1), (False, 3), (True, 2)])
def test_strips_are_not_on_the_foil(mirror: bool, copies: int) -> None:
    """Two strips for each balloon, on a stock of their own; foil has the panels and nothing else."""
    wanted = replace(VALVE, mirror=mirror, copies=copies)
    sheet = sheet_of(make_pattern(NAMED["heart"], SEAL, wanted), wanted)
    assert sheet.stocks == ("", "valve")
    plain = replace(wanted, intake_kind="straw")
    foil, valve = sheet.of_stock(""), sheet.of_stock("valve")
    assert len(foil.of(Role.CUT)) == copies * (2 if mirror else 1)
    assert len(foil.contours) + len(valve.contours) == len(sheet.contours)
    strips = outlines(valve)
    assert len(strips) == 2 * copies
    for strip in strips:
        width, height = np.ptp(np.asarray(strip.exterior.coords), axis=0)
        assert (width, height) == pytest.approx((0.024 + 2 * SEAL, 0.100))
    every = outlines(sheet)
    assert min(a.distance(b) for k, a in enumerate(every) for b in every[:k]) > 0.0029
    none = sheet_of(make_pattern(NAMED["heart"], SEAL, plain), plain)
    assert none.stocks == ("",)
    assert none.of_stock("") == none


def test_each_stock_has_a_file_of_its_own() -> None:
    """For every machine: the panels without the strips, and the strips in a file whose name says so."""
    wanted = replace(VALVE, mirror=True)
    sheet = sheet_of(make_pattern(NAMED["disc"].map(lambda loop: 0.5 * loop), SEAL, wanted), wanted)
    for machine in machines().values():
        if machine.tool and lacking(machine.tool, machine.version):
            continue  # what only the user knows
        contents, _ = checked_files(sheet, [machine])
        stem, _, ending = machine.file_name.rpartition(".")
        assert list(contents) == [machine.file_name, f"{stem}-valve.{ending}"]
    contents, _ = checked_files(sheet, [machines()["any-dxf"]], "A4")
    assert {"pattern-a4.pdf", "pattern-a4-valve.pdf"} <= set(contents)
    for name, sizes in (("pattern.dxf", [0.164, 0.164]), ("pattern-valve.dxf", [0.034, 0.034])):
        document = ezdxf.read(io.StringIO(contents[name].decode("cp1252")))
        cuts = [each for each in document.modelspace() if each.dxf.layer == "CUT"]
        widths = [1e-3 * float(np.ptp(np.array(list(each.vertices()))[:, 0])) for each in cuts]
        assert widths == pytest.approx(sizes, abs=1e-3)


def test_strips_are_nested_on_their_own_roll() -> None:
    panel = make_pattern(NAMED["heart"], SEAL, VALVE)
    one = sheet_of(panel, replace(VALVE, mirror=True))
    parted = by_stock(pieces_of(panel, one, 4, 0.0))
    assert list(parted) == ["", "valve"]
    (foil,) = parted[""]
    assert (foil.count, foil.backs) == (4, 4)
    assert sum(piece.count + piece.backs for piece in parted["valve"]) == 2 * 4
    assert all(piece.pattern.stocks == ("valve",) for piece in parted["valve"])


def test_valves_go_with_films_they_weld_to() -> None:
    """By the sealing side that each film file gives; unknown is not refused but said."""
    for name, known in films().items():
        assert known.sealing_side, name
        assert any("ealing side" in source for source in known.sources), name
        if known.sealing_side == "PE":
            assert pieces_remarks(VALVE, known) == ()
            continue
        with pytest.raises(InputError) as caught:
            pieces_remarks(VALVE, known)
        assert known.title in str(caught.value)
        assert all(films()[good].title in str(caught.value) for good in ("nylon-foil", "pe"))
        assert pieces_remarks(replace(VALVE, intake=False), known) == ()
        assert pieces_remarks(PatternOptions(), known) == ()
        assert pieces_remarks(PatternOptions(intake_kind="nozzle"), known) == ()
    assert {name for name, known in films().items() if known.sealing_side == "PE"} == {"nylon-foil", "pe"}
    (remark,) = pieces_remarks(VALVE, custom_film(3e9, 0.38, 30e-6))
    assert "scrap" in remark


@pytest.mark.parametrize("material", ["mylar", "nylon-foil"])
def test_the_command_line_refuses_and_parts(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], material: str
) -> None:
    drawing = tmp_path / "square.json"
    drawing.write_text(json.dumps({"unit": "mm", "outer": [[0, 0], [200, 0], [200, 200], [0, 200]]}))
    words = ["inflate", str(drawing), "--width", "200mm", "--mesh-size", "25mm", "--material", material]
    words += ["--intake", "film-valve", "--nest", "600mm", "--machine", "silhouette"]
    ended = command_line.main([*words, "--out", str(tmp_path / "out")])
    if material == "mylar":
        assert ended == 2
        assert "weld" in capsys.readouterr().err
        assert not (tmp_path / "out").exists()
        return
    assert ended == 0
    names = {path.name for path in (tmp_path / "out").iterdir()}
    assert {"pattern.dxf", "pattern-valve.dxf", "pattern-valve.svg"} <= names
    assert {"pattern-silhouette_mm-valve.dxf", "nested-pattern-silhouette_mm-valve.dxf"} <= names
    told = capsys.readouterr().out
    assert "thin PE film" in told
    assert "\nFilm 1: pieces 2," in told
    assert "\nValve film 1: pieces 2," in told
    report = json.loads((tmp_path / "out" / "report.json").read_text())
    drawn = (tmp_path / "out" / "pattern.svg").read_text().split('width="')[1].split("mm")[0]
    assert (
        report["sheet"]["width_mm"] == pytest.approx(float(drawn), abs=1e-3) == pytest.approx(248.7, abs=0.1)
    )


@pytest.mark.parametrize("name", ["disc", "heart", "star", "ring", "square", "flower"])
def test_usual_valves_have_room(name: str) -> None:
    assert make_pattern(NAMED[name], SEAL, VALVE).warnings == ()


@pytest.mark.parametrize("width", [0.010, 0.014, 0.0185])
def test_a_neck_too_narrow_for_the_channel_is_told(width: float) -> None:
    """Channel of 10 mm and two welds of 5 mm: 20 mm at the mouth. The figures are measured, not repeated."""
    pattern = make_pattern(NAMED["disc"], SEAL, replace(VALVE, intake_width=width))
    (text,) = pattern.warnings
    assert float(text.split("narrows to ")[1].split(" mm")[0]) == pytest.approx(1000.0 * width, abs=0.15)
    assert "20 mm" in text
    assert make_pattern(NAMED["disc"], SEAL, replace(VALVE, intake_width=0.0202)).warnings == ()


@pytest.mark.parametrize("waist", [0.008, 0.016])
def test_a_narrow_place_of_the_seam_on_the_channel_is_told(waist: float) -> None:
    """A head wide enough for the neck, then a waist that the strips reach into."""
    body = shapely.Point(0.0, 0.0).buffer(0.09)
    head = shapely.Point(0.0, 0.150).buffer(0.028)
    shape = shapely.union_all([body, head, shapely.box(-0.5 * waist, 0.0, 0.5 * waist, 0.15)])
    seam = Outline(np.asarray(shape.exterior.coords)[:-1][::-1])
    found = build_pattern(
        seam, SEAL, PatternOptions(intake_kind="film-valve", intake_angle=0.5 * np.pi)
    ).warnings
    (text,) = [text for text in found if "channel" in text]
    assert float(text.split("narrows to ")[1].split(" mm")[0]) == pytest.approx(1000.0 * waist, abs=0.3)
    wide = build_pattern(Outline(polar(0.15)), SEAL, PatternOptions(intake_kind="film-valve")).warnings
    assert wide == ()


def test_strips_longer_than_the_balloon_are_told() -> None:
    strip = corners_of((0.0, 0.0), (0.3, 0.0), (0.3, 0.045), (0.0, 0.045))
    found = build_pattern(
        strip, SEAL, PatternOptions(intake_kind="film-valve", intake_along=0.19, intake_length=0.040)
    )
    (text,) = [text for text in found.warnings if "valve" in text]
    assert "reaches 60 mm" in text
    across = build_pattern(strip, SEAL, PatternOptions(intake_kind="film-valve", intake_angle=0.0))
    assert not [text for text in across.warnings if "valve" in text]


def test_holes_and_welds_inside_close_a_channel_too() -> None:
    """The strips end 60 mm inside the neck's root: a hole or a weld at 70 mm is free of them, at 50 not."""
    for way, told in ((0.070, False), (0.050, True)):
        below = hole(0.03, 0.0, -0.15 + way + 0.03)
        line = np.array([[-0.05, -0.15 + way], [0.05, -0.15 + way]])
        for seam in (Outline(polar(0.15), (below,)), Outline(polar(0.15), welds=(line,))):
            made = build_pattern(
                seam, SEAL, PatternOptions(intake_kind="film-valve", intake_angle=-0.5 * np.pi)
            )
            assert any("past the weld" in text for text in made.warnings) is told


def test_the_weld_across_the_neck_is_kept_off_the_channel() -> None:
    """Where neck and strips are welded across, one strip has ink over the whole channel, past the weld."""
    pattern = make_pattern(NAMED["disc"], SEAL, VALVE)
    sheet = sheet_of(pattern, VALVE).of_stock("valve")
    inked = [line for line in sheet.of(Role.PEN) if line.closed]
    assert len(inked) == 1
    ink = shapely.Polygon(inked[0].points)
    (strip,) = [piece for piece in outlines(sheet) if piece.contains(ink)]
    (across,) = [_line(line) for line in sheet.of(Role.PEN) if not line.closed and strip.covers(_line(line))]
    welds = shapely.union_all(
        [_line(line) for line in sheet.of(Role.SEAL) if strip.buffer(1e-6).covers(_line(line))]
    )
    channel = strip.difference(welds.buffer(0.5 * SEAL, cap_style="flat"))
    middle = min(shapely.get_parts(channel), key=lambda part: part.distance(across.centroid))
    heat = across.buffer(0.5 * SEAL, cap_style="flat").intersection(middle)
    assert heat.area > 0.9 * SEAL * 0.010
    assert ink.buffer(1e-5).covers(heat)
    assert strip.distance(across.centroid) == 0.0
    # on the panel the line is as far from the mouth as on the strip
    intake = pattern.intake
    assert intake is not None
    (mark,) = pattern.of(Role.PEN)
    axis = np.array([np.cos(intake.angle), np.sin(intake.angle)])
    from_mouth = intake.length - float((mark.points.mean(axis=0) - intake.at) @ axis)
    ends = np.asarray(strip.exterior.coords)
    along = np.asarray(across.centroid.coords[0])[1]
    assert from_mouth == pytest.approx(min(along - ends[:, 1].min(), ends[:, 1].max() - along), abs=1e-6)


def _line(contour: Contour) -> shapely.Geometry:
    return (shapely.LinearRing if contour.closed else shapely.LineString)(contour.points)


def test_a_users_film_may_say_its_sealing_side(tmp_path: Path) -> None:
    from BalloonWorkbench.core.film.library import FOLDER, read_film

    data = json.loads((FOLDER / "mylar.json").read_text(encoding="utf-8"))
    del data["sealing_side"]
    path = tmp_path / "mine.json"
    path.write_text(json.dumps({**data, "name": "mine"}), encoding="utf-8")
    assert read_film(path).sealing_side is None
    path.write_text(json.dumps({**data, "name": "mine", "sealing_side": "PE"}), encoding="utf-8")
    assert pieces_remarks(VALVE, read_film(path)) == ()
    path.write_text(json.dumps({**data, "name": "mine", "sealing_side": ["PE"]}), encoding="utf-8")
    with pytest.raises(InputError, match="sealing side"):
        read_film(path)
    assert film("nylon-foil").sealing_side == "PE"

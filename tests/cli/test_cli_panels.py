# SPDX-License-Identifier: LGPL-2.1-or-later
"""Balloons of many panels from the command line: gores, a side band, bags; what goes wrong, in one line."""

from __future__ import annotations

import importlib.util
import json
import struct
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import ezdxf
import numpy as np
import pytest
from drawn_pictures import coloured, drawn, png, ring

from BalloonWorkbench.cli import main
from BalloonWorkbench.core.nesting import nest as nesting

ROOT = Path(__file__).parents[2]
BAGS, PROFILES = ROOT / "resources" / "examples" / "bags", ROOT / "resources" / "examples" / "profiles"
FILES = {"pattern.dxf", "pattern.svg", "balloon.stl", "preview.png", "report.json"}
SQUARE = {"unit": "mm", "outer": [[0, 0], [200, 0], [200, 200], [0, 200]]}
report_alone = pytest.mark.usefixtures("blank_sheets")


def run(command: str, source: Path | str, out: Path, *words: str) -> dict[str, Any]:
    assert main([command, str(source), "--out", str(out), "--language", "en", *words]) == 0
    assert {path.name for path in out.iterdir()} >= FILES
    data: dict[str, Any] = json.loads((out / "report.json").read_text(encoding="utf-8"))
    return data


def stl_volume(path: Path) -> float:
    """Enclosed by the facets [m3]."""
    data = path.read_bytes()
    facets = np.frombuffer(data[84:], dtype=np.dtype([("n", "<f4", 3), ("v", "<f4", (3, 3)), ("a", "<u2")]))
    assert len(facets) == struct.unpack("<I", data[80:84])[0]
    corners = 1e-3 * facets["v"].astype(float)
    return float(np.einsum("ij,ij->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2]))) / 6.0


@pytest.fixture(scope="module")
def cube(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, dict[str, Any]]:
    out = tmp_path_factory.mktemp("cube") / "out"
    words = ["--young", "4e9", "--poisson", "0.3", "--thickness", "1e-4", "--pressure", "200Pa"]
    return out, run("inflate", BAGS / "cube.json", out, *words, "--results", "npz")


def test_a_cube_is_as_large_as_another_program_says(cube: tuple[Path, dict[str, Any]]) -> None:
    """1.2608 of its cube, extrapolated and confirmed by Surface Evolver; the STL encloses the same."""
    out, report = cube
    assert report["inflated"]["volume_m3"] == pytest.approx(1.2608 * 0.2**3, rel=0.004)
    assert stl_volume(out / "balloon.stl") == pytest.approx(report["inflated"]["volume_m3"], rel=0.006)
    with np.load(out / "results.npz") as results:
        assert len(results["positions_mm"]) == report["mesh"]["vertices"]


def test_the_report_has_panels_seams_and_assembly(cube: tuple[Path, dict[str, Any]]) -> None:
    _, report = cube
    assert report["input"] == {"file": "cube.json", "kind": "bag"}
    assert report["target"] is None
    assert [panel["name"] for panel in report["panels"]] == [
        "bottom",
        "top",
        "front",
        "right",
        "back",
        "left",
    ]
    assert [panel["same_as"] for panel in report["panels"]] == [None, *["bottom"] * 5]
    for panel in report["panels"]:
        assert panel["area_m2"] == pytest.approx(0.04)
        assert sum(panel["area_shares"].values()) == pytest.approx(1.0)
    assert [seam["number"] for seam in report["seams"]] == [*range(1, 13)]
    for seam in report["seams"]:
        assert seam["length_a_mm"] == pytest.approx(200.0)
        assert seam["length_b_mm"] == pytest.approx(200.0)
        assert seam["flatness_rad"] == pytest.approx(0.0, abs=1e-9)
    assert sorted(step["seam"] for step in report["assembly"]) == [*range(1, 13)]
    assert [step["kind"] for step in report["assembly"]].count("join") == 5, "a tree of six panels"
    assert [step["opening"] for step in report["assembly"]] == [*[False] * 11, True]
    assert report["surface"]["bodies"] == 1
    assert report["surface"]["euler_number"] == 2
    assert len(report["surface"]["poles"]) == 8
    assert report["maker"]["seam_length_mm"] == pytest.approx(2400.0)


def test_the_pattern_has_each_panel_once(cube: tuple[Path, dict[str, Any]]) -> None:
    """Read back: six cuts and six welds that are closed, each with its weld inside its cut."""
    out, _ = cube
    lines = list(ezdxf.readfile(out / "pattern.dxf").modelspace())
    cuts = [line for line in lines if line.dxf.layer == "CUT"]
    sizes = []
    for cut in cuts:
        points = np.array([point[:2] for point in cut.get_points()])
        sizes.append(np.ptp(points, axis=0).min())
    assert sum(size > 200.0 for size in sizes) == 6


@report_alone
def test_gores_by_number(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The sphere of 6: mean distance 16 %/36 of the diagonal; equal panels; what is told."""
    out = tmp_path / "out"
    words = ["--gores", "6", "--pressure", "500Pa", "--mesh-size", "28mm"]
    report = run("design", PROFILES / "sphere.json", out, *words)
    assert report["design"]["relative_error"] <= 0.16 / 36
    assert report["design"]["apart_mm"] > 0.0
    assert report["target"]["kind"] == "profile"
    assert report["target"]["width_mm"] == pytest.approx(500.0, rel=1e-3)
    assert len(report["panels"]) == 6
    assert sum(panel["same_as"] is None for panel in report["panels"]) == 1
    assert report["inflated"]["volume_m3"] == pytest.approx(0.974 * 4.0 / 3.0 * np.pi * 0.25**3, rel=0.03)
    text = capsys.readouterr().out
    assert "Off the profile: " in text
    assert "Panels: 6, of different shapes: 1" in text


@report_alone
def test_gores_by_accuracy(tmp_path: Path) -> None:
    words = ["--accuracy", "0.02", "--pressure", "500Pa", "--mesh-size", "70mm"]
    report = run("design", PROFILES / "sphere.json", tmp_path / "out", *words)
    assert report["design"]["relative_error"] <= 0.02
    assert 3 <= len(report["panels"]) <= 4


@report_alone
def test_a_profile_as_wide_as_asked_for(tmp_path: Path) -> None:
    """Plain gores of a body whose width is given; a disc at its lower end; its size in the report."""
    words = ["--gores", "8", "--width", "260mm", "--mesh-size", "30mm"]
    report = run("inflate", PROFILES / "bell.json", tmp_path / "out", *words)
    assert report["target"]["width_mm"] == pytest.approx(260.0)
    assert report["target"]["lower"] == "disc"
    assert report["design"]["passes"] <= 1
    assert len(report["panels"]) == 9


@report_alone
def test_hydrostatic_pressure_makes_the_top_round(tmp_path: Path) -> None:
    """The envelope without weight, filled with warm air: about 0.126 of the cube of its gores' length."""
    report = run(
        "inflate", PROFILES / "envelope.json", tmp_path / "out", "--gores", "12", "--hydrostatic",
        "--pressure", "0.01Pa", "--gas", "warm-air", "--material", "pe", "--mesh-size", "250mm",
    )  # fmt: skip
    assert report["inflated"]["volume_m3"] == pytest.approx(0.126055 * 27.0, rel=0.03)


@report_alone
def test_a_picture_with_a_side_band(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    picture = tmp_path / "ring.png"
    picture.write_bytes(png(coloured(drawn(ring(100.0, 100.0, 90.0, 40.0), 200, 200))))
    report = run(
        "design", picture, tmp_path / "out", "--width", "200mm", "--band", "30mm", "--mesh-size", "16mm"
    )
    assert report["input"]["kind"] == "outline"
    assert report["design"]["relative_error"] <= 0.01
    assert report["target"]["holes"] == 1
    assert report["surface"]["euler_number"] == 0
    names = [panel["name"] for panel in report["panels"]]
    assert names[:2] == ["front", "back"]
    assert all(panel["height_mm"] == pytest.approx(30.0) for panel in report["panels"][2:])
    assert any(not seam["flat"] and seam["tabs"] for seam in report["seams"])
    assert "Off the drawing: " in capsys.readouterr().out


@report_alone
def test_each_shape_of_a_drawing_has_its_band(tmp_path: Path) -> None:
    two = {"unit": "mm", "parts": [SQUARE, {"outer": [[250, 0], [330, 0], [330, 80], [250, 80]]}]}
    path = tmp_path / "two.json"
    path.write_text(json.dumps(two))
    report = run("inflate", path, tmp_path / "out", "--band", "30mm", "--mesh-size", "15mm")
    assert [part["target"]["width_mm"] for part in report["parts"]] == pytest.approx([200.0, 80.0])
    assert (tmp_path / "out" / "preview-2.png").exists()


@pytest.mark.slow
def test_everything_that_is_made_of_a_bag(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Print, layout, assembly sheet and machine of the pouch."""
    monkeypatch.setattr(nesting, "PACKAGE", "no_such_package")  # rows: quick
    picture = tmp_path / "grey.png"
    picture.write_bytes(png(np.full((40, 40, 4), (99, 99, 99, 255), np.uint8)))
    out = tmp_path / "out"
    run(
        "inflate", BAGS / "pouch.json", out, "--artwork", str(picture), "--dpi", "40", "--nest", "500mm",
        "--balloons", "2", "--assembly", "A4", "--machine", "hpgl-plotter", "--mesh-size", "15mm",
    )  # fmt: skip
    names = {path.name for path in out.iterdir()}
    assert {"artwork.png", "artwork.pdf", "assembly.pdf", "nested-pattern-hpgl-plotter.plt"} <= names
    assert "print-pattern-hpgl-plotter.plt" in names
    text = capsys.readouterr().out
    assert "Film 1: pieces 6, on " in text
    assert "at 40 dpi, all panels" in text


def test_what_is_too_large_in_one_piece_is_laid_out_on_film(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Side by side the panels are larger than the bed: sheets are what is cut, refused where they are too."""
    monkeypatch.setattr(nesting, "PACKAGE", "no_such_package")  # rows: quick
    out = tmp_path / "out"
    asked = ["inflate", str(BAGS / "pouch.json"), "--out", str(out), "--machine", "lightburn"]
    asked += ["--mesh-size", "20mm", "--only", "report", "--bed", "330 x 330 mm"]
    assert main([*asked, "--nest", "320x320mm"]) == 0
    names = {path.name for path in out.glob("*lightburn*")}
    assert names == {"nested-pattern-lightburn_mm.dxf", "nested-2-pattern-lightburn_mm.dxf"}
    assert "Note: No file for LightBurn (laser): The pattern measures" in capsys.readouterr().out
    assert main([*asked, "--nest", "1mx1m"]) == 2
    assert "the bed of LightBurn (laser) is 330 x 330 mm" in capsys.readouterr().err


@pytest.mark.usefixtures("with_freecad")
def test_a_document_is_made(tmp_path: Path) -> None:
    """By FreeCAD, where it is installed; the panels' corners lie on half micrometres."""
    if importlib.util.find_spec("FreeCAD") is None:
        pytest.skip("FreeCAD is not there")
    run("inflate", BAGS / "pouch.json", tmp_path / "out", "--mesh-size", "20mm")
    with zipfile.ZipFile(tmp_path / "out" / "balloon.FCStd") as document:
        assert b"bottom" in document.read("Document.xml")


@report_alone
def test_a_volume_decides_the_size_of_a_body(tmp_path: Path) -> None:
    words = ["--gores", "6", "--target-volume", "20", "--mesh-size", "25mm", "--pressure", "500Pa"]
    report = run("inflate", PROFILES / "sphere.json", tmp_path / "out", *words)
    assert report["inflated"]["volume_m3"] == pytest.approx(0.020, rel=6e-3)


@report_alone
def test_a_volume_of_gas_decides_the_pressure_of_a_bag(tmp_path: Path) -> None:
    report = run(
        "inflate", BAGS / "cube.json", tmp_path / "out", "--gas-volume", "10.1l", "--mesh-size", "25mm"
    )
    assert report["inflated"]["volume_m3"] == pytest.approx(0.0101, rel=2e-3)
    assert report["load"]["kind"] == "volume"


def without_opening(bag: dict[str, Any]) -> None:
    del bag["opening"]


def moved_corner(bag: dict[str, Any]) -> None:
    bag["panels"][1]["outer"][2] = [230, 200]


def forgotten(bag: dict[str, Any]) -> None:
    del bag["seams"][3]


def twice(bag: dict[str, Any]) -> None:
    bag["seams"][3] = bag["seams"][2]


def unknown(bag: dict[str, Any]) -> None:
    bag["seams"][0]["a"][0] = "lid"


@pytest.mark.parametrize("wrong", [without_opening, moved_corner, forgotten, twice, unknown])
def test_a_wrong_bag_is_refused_in_one_line(
    wrong: Callable[[dict[str, Any]], None], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    bag = json.loads((BAGS / "cube.json").read_text())
    wrong(bag)
    path = tmp_path / "bag.json"
    path.write_text(json.dumps(bag))
    assert main(["inflate", str(path), "--out", str(tmp_path / "out"), "--language", "en"]) == 2
    line = capsys.readouterr().err
    assert line.startswith("balloon: ")
    assert line.count("\n") == 1
    assert not (tmp_path / "out").exists()


@report_alone
def test_a_bag_without_an_opening_is_made_when_that_is_said(tmp_path: Path) -> None:
    bag = json.loads((BAGS / "cube.json").read_text())
    without_opening(bag)
    path = tmp_path / "bag.json"
    path.write_text(json.dumps(bag))
    run("inflate", path, tmp_path / "out", "--intake", "none", "--mesh-size", "25mm")


@report_alone
def test_frames_of_a_cube(tmp_path: Path) -> None:
    out = tmp_path / "out"
    run("inflate", BAGS / "cube.json", out, "--mesh-size", "50mm", "--frames", "3")
    strip = (out / "inflation.pvd").read_text(encoding="utf-8")
    assert all(f"inflation-{number}.vtu" in strip for number in (1, 2, 3))
    assert {path.name for path in out.glob("inflation*")} == {
        "inflation.pvd",
        *(f"inflation-{number}.vtu" for number in (1, 2, 3)),
    }


CUBE, SPHERE, DRAWING = str(BAGS / "cube.json"), str(PROFILES / "sphere.json"), "square.json"


@pytest.mark.parametrize(
    ("words", "part"),
    [
        (["design", CUBE], "use inflate instead of design"),
        (["inflate", CUBE, "--gores", "6"], "has its own panels"),
        (["inflate", CUBE, "--band", "30mm"], "has its own panels"),
        (["inflate", CUBE, "--width", "300mm"], "has the size of its panels"),
        (["design", SPHERE, "--band", "30mm"], "has no side band"),
        (["design", SPHERE, "--gores", "6", "--band", "30mm"], "has no side band"),
        (["design", SPHERE, "--gores", "2"], "cannot be made of 2 gores"),
        (["design", SPHERE, "--accuracy", "-1"], "accuracy"),
        (
            ["design", SPHERE, "--lower-cap", "point", "--artwork", "a.png", "--artwork-back", "b.png"],
            "all round",
        ),
        (["design", DRAWING, "--band", "30mm", "--body-thickness", "90mm"], "give one of them"),
        (["design", DRAWING, "--band-piece", "300mm"], "has no width"),
        (["design", DRAWING, "--band=-3mm"], "side band"),
    ],
)
def test_what_makes_no_sense_is_one_sentence(
    words: list[str],
    part: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    (tmp_path / DRAWING).write_text(json.dumps(SQUARE))
    monkeypatch.chdir(tmp_path)
    assert main([*words, "--out", str(tmp_path / "out"), "--language", "en"]) == 2
    line = capsys.readouterr().err
    assert part in line
    assert line.count("\n") == 1


def test_the_same_bag_writes_the_same_bytes(tmp_path: Path) -> None:
    for name in ("one", "two"):
        run("inflate", BAGS / "pouch.json", tmp_path / name, "--mesh-size", "20mm")
    for file in FILES - {"report.json"}:  # which holds the seconds
        assert (tmp_path / "one" / file).read_bytes() == (tmp_path / "two" / file).read_bytes(), file


@report_alone
@pytest.mark.parametrize(
    "path", [BAGS / "pouch.json", PROFILES / "airship.json", PROFILES / "envelope.json"], ids=lambda p: p.stem
)
def test_examples_come_to_rest(path: Path, tmp_path: Path) -> None:
    """Those that no other test here inflates as they are."""
    size = {"airship": "80mm", "envelope": "250mm"}.get(path.stem, "20mm")
    words = [] if path.parent == BAGS else ["--gores", "6", "--pressure", "300Pa"]
    report = run("inflate", path, tmp_path / "out", *words, "--mesh-size", size)
    assert report["solve"]["converged"]
    assert report["solve"]["newton_steps"] <= 60


@report_alone
def test_a_body_is_as_high_as_its_profile(tmp_path: Path) -> None:
    """Width, height and depth: the height is that along the axis, as of the profile."""
    source = tmp_path / "airship.json"
    source.write_text('{"unit": "mm", "profile": [[0, 0], [90, 100], [100, 250], [90, 400], [0, 500]]}')
    report = run("inflate", source, tmp_path / "out", "--gores", "6", "--mesh-size", "40mm")
    inflated = report["inflated"]
    assert inflated["height_mm"] == pytest.approx(500.0, rel=0.1)
    assert inflated["width_mm"] == pytest.approx(inflated["thickness_mm"], rel=0.2)
    assert inflated["width_mm"] < 0.6 * inflated["height_mm"]


@pytest.mark.parametrize(
    ("broken", "example"),
    [
        ('{"unit": "mm", "panels": [{"name": "top", "outer": [[0, 0], [1, 0]', '"name": "top"'),
        ('{"unit": "mm", "profile": [[0, 0], [1, 0], ', '"profile": [[0, 0]'),
    ],
)
def test_a_broken_file_is_told_with_an_example_of_its_kind(
    broken: str, example: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    source = tmp_path / "broken.json"
    source.write_text(broken)
    assert main(["inflate", str(source), "--out", str(tmp_path / "out"), "--language", "en"]) != 0
    told = capsys.readouterr().err
    assert example in told.split("Write")[1]

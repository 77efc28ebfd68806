# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files for machines, asked for on the command line."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from BalloonWorkbench.cli import command_line, many_panels
from BalloonWorkbench.core.bag_job import make_bags
from BalloonWorkbench.core.bags.read_bag import read_bag
from BalloonWorkbench.core.job import Settings
from BalloonWorkbench.core.machines.machine import FOLDER, machine
from BalloonWorkbench.core.outline.budget import Budget

CUBE = str(Path(__file__).parents[2] / "resources" / "examples" / "bags" / "cube.json")


@pytest.fixture
def square(tmp_path: Path) -> Path:
    path = tmp_path / "square.json"
    path.write_text(json.dumps({"unit": "mm", "outer": [[0, 0], [200, 0], [200, 200], [0, 200]]}))
    return path


def run(square: Path, *more: str) -> int:
    out = str(square.parent / "out")
    return command_line.main(
        ["inflate", str(square), "--width", "200mm", "--mesh-size", "25mm", "--out", out, *more]
    )


def test_files_for_machines(square: Path, capsys: pytest.CaptureFixture[str]) -> None:
    chosen = [word for name in ("lightburn", "cutting-shop", "inkscape", "hpgl-plotter", "paper") for word in
              ("--machine", name)]  # fmt: skip
    assert run(square, *chosen, "--tiled", "A4") == 0
    made = {path.name for path in (square.parent / "out").iterdir()}
    machines = ("lightburn_mm.dxf", "cutting-shop_mm.dxf", "inkscape.svg", "hpgl-plotter.plt", "paper.pdf")
    assert made >= {"pattern.dxf", "pattern-a4.pdf", *(f"pattern-{name}" for name in machines)}
    told = capsys.readouterr().out
    assert "pattern-a4.pdf" in told
    assert "Silhouette" not in told
    for name in ("lightburn", "cutting-shop", "inkscape", "hpgl-plotter", "paper"):
        assert machine(name).note in told


def test_too_large_for_the_bed(square: Path, capsys: pytest.CaptureFixture[str]) -> None:
    own = square.parent / "small.json"
    data = json.loads((FOLDER / "lightburn.json").read_text(encoding="utf-8"))
    own.write_text(json.dumps({**data, "name": "small", "bed_mm": [150, 150]}))
    assert run(square, "--machine", str(own)) == 2
    text = capsys.readouterr().err
    assert "bed" in text
    assert "(5.906 x 5.906 in)" in text
    assert not (square.parent / "out").exists()


def test_one_unsuitable_machine_is_left_out(square: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The others get their files, and a line tells why that one did not."""
    own = square.parent / "small.json"
    data = json.loads((FOLDER / "lightburn.json").read_text(encoding="utf-8"))
    own.write_text(json.dumps({**data, "name": "small", "title": "Small laser", "bed_mm": [150, 150]}))
    assert run(square, "--machine", str(own), "--machine", "inkscape", "--machine", "cutting-shop") == 0
    made = {path.name for path in (square.parent / "out").iterdir()}
    assert made >= {"pattern-inkscape.svg", "pattern-cutting-shop_mm.dxf"}
    assert "pattern-small_mm.dxf" not in made
    assert "Note: No file for Small laser: The pattern measures" in capsys.readouterr().out


def test_gcode_with_the_tool_that_is_given(square: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A machine holds another tool than its file says; only Marlin heats it."""
    hot = ("--tool", "hot-tip", "--feed", "300", "--tip-temperature", "180C", "--depth", "0.2mm")
    assert run(square, "--machine", "gcode-linuxcnc", "--machine", "gcode-marlin", *hot, "--bed", "none") == 0
    text = (square.parent / "out" / "pattern-gcode-marlin.gcode").read_text("ascii")
    assert "M109 S180 ; wait until it is hot" in text
    assert "G1 Z-0.2 F300\n" in text
    assert "M109" not in (square.parent / "out" / "pattern-gcode-linuxcnc.ngc").read_text("ascii")
    assert machine("gcode-marlin").note in capsys.readouterr().out


@pytest.mark.parametrize(
    ("words", "text"),
    [
        ("--machine gcode-grbl", "give --feed 600 for 600 mm/min and --power 40 for 40 %"),
        ("--machine gcode-grbl --feed 0 --power 40", "from 1 mm/min"),
        ("--machine gcode-grbl --feed nan --power 40", "from 1 mm/min"),
        ("--machine gcode-grbl --feed 600 --power 40 --bed 1mmx1mm", "A bed is 10 mm to"),
        ("--machine lightburn --feed 600", "give --machine gcode-grbl"),
        ("--tool axe --machine gcode-grbl", "axe"),
        ("--machine gcode-marlin --feed 300 --tip-temperature 700C --depth 0", "40C to 400C"),
    ],
)
def test_gcode_that_cannot_be_is_told_in_a_line(
    square: Path, words: str, text: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(square, *words.split()) == 2
    told = capsys.readouterr().err.strip()
    assert text in told
    assert not (square.parent / "out").exists()


def test_tabs_are_left_in_what_a_machine_cuts(square: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The square of 212 mm has nine tabs; what cannot have any is a line before the work."""
    for words, told in (
        (("--tabs", "0.4mm"), "give --machine too"),
        (("--machine", "paper", "--tabs", "0.4mm"), "one that does"),
        (("--machine", "heat-sealer", "--tabs", "0.4mm"), "one that does"),
        (("--machine", "inkscape", "--tabs-below", "5cm"), "their width too"),
        (("--machine", "inkscape", "--tabs", "5cm"), "0.05 mm to 10 mm"),
    ):
        assert run(square, *words) == 2
        assert told in capsys.readouterr().err
    machines = ("--machine", "inkscape", "--machine", "paper")
    assert run(square, "--intake", "none", *machines, "--tabs", "0.4mm") == 0
    cut = (square.parent / "out" / "pattern-inkscape.svg").read_text()
    assert "CUT" in cut.partition('id="CUT"')[1]
    assert cut.partition('id="CUT"')[2].count("<path") == 9
    assert "two tabs" not in capsys.readouterr().out


def test_what_is_left_of_a_sheet_is_laid_out_on(square: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Two panels of 212 mm leave most of a sheet; the next balloon lies in what is left of it."""
    out, bare = square.parent / "out", ("--intake", "none", "--only", "report")
    assert run(square, *bare, "--nest", "500mmx900mm", "--keep-remnant") == 0
    told = capsys.readouterr().out
    assert "Film: remnants 1, " in told
    left = square.parent / "left.json"
    (out / "remnant.json").rename(left)
    assert run(square, *bare, "--on-remnant", str(left), "--grain-lies", "any", "--machine", "inkscape") == 0
    assert "Film 1: pieces 2, on a remnant of " in capsys.readouterr().out
    assert (out / "nested-pattern-inkscape.svg").exists()
    for words, sentence in (
        (("--keep-remnant",), "give --nest too"),
        (("--on-remnant", "none.json"), "The remnant none.json is of no use"),
        (("--on-remnant", str(left), "--balloons", "9"), "no room on the remnant"),
    ):
        assert run(square, *bare, *words) == 2
        assert sentence in capsys.readouterr().err


def test_unknown_machine_is_told_before_the_work(square: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(square, "--machine", "axe") == 2
    assert "lightburn" in capsys.readouterr().err


def test_the_pattern_is_made_as_it_is_told(square: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Every option of the pattern reaches files and report; the document has the same values."""
    options = {
        "--seal-width": "4mm", "--allowance": "3mm", "--corner-relief": "2mm", "--intake": "film-valve",
        "--intake-along": "250mm", "--notches": "12", "--notch-depth": "2mm", "--tie-tab": "0",
        "--label": "B1", "--label-height": "8mm", "--copies": "2",
    }  # fmt: skip
    options["--material"] = "nylon-foil"  # to which the valve welds
    assert run(square, *(word for pair in options.items() for word in pair), "--mirror") == 0
    told = json.loads((square.parent / "out" / "report.json").read_text())
    intake = told["pattern"]["intake"]
    assert (intake["kind"], intake["width_mm"]) == ("film-valve", pytest.approx(24.0))
    assert intake["along_mm"] == pytest.approx(250.0, abs=0.5)
    assert "strips" in intake["how_to_fill"]
    text = (square.parent / "out" / "pattern.svg").read_text()
    layers = {layer: part.count("<path") for layer, part in
              ((part.split('"')[0], part) for part in text.split('<g id="')[1:])}  # fmt: skip
    assert layers["CUT"] == 2 * 2
    assert layers["CUT_INNER"] == 2 * 2
    assert layers["NOTCH"] >= 2 * 2 * 8
    # the box of 200 mm, both welds and allowances, the tab beside it
    assert told["pattern"]["width_mm"] > 200 + 2 * (4 + 3)
    assert "Wrote" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("options", "text"),
    [
        (("--intake", "funnel"), "film-valve"),
        (("--copies", "0"), "copies"),
        (("--corner-relief", "60mm"), "relief"),
        (("--intake-angle", "0", "--intake-along", "3mm"), "not allowed"),
        (("--notches", "4", "--notch-depth", "5mm"), "weld"),
    ],
)
def test_senseless_patterns_are_told(
    square: Path, options: tuple[str, ...], text: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(square, *options) == 2
    assert text in capsys.readouterr().err
    assert not (square.parent / "out").exists()


def test_a_card_is_made_and_its_best_field_is_a_machine(
    square: Path, capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("BALLOON_MACHINES", str(square.parent / "machines"))
    card = square.parent / "card"
    made = [
        "--machine",
        "gcode-marlin",
        "--feed",
        "200, 300",
        "--tip-temperature",
        "140C,160C",
        "--depth",
        "0.2mm",
    ]
    assert command_line.main(["test-card", *made, "--out", str(card)]) == 0
    assert {path.name for path in card.iterdir()} == {"test-card.gcode", "test-card.svg", "test-card.json"}
    keep = ["test-card", str(card / "test-card.json"), "--keep", "B2", "--name", "tip-pe"]
    assert command_line.main(keep) == 0
    assert run(square, "--only", "report", "--machine", "tip-pe", "--bed", "300mmx300mm") == 0
    written = (square.parent / "out" / "pattern-tip-pe.gcode").read_text()
    assert "Feed 300 mm/min" in written
    assert "M109 S160" in written
    capfd.readouterr()
    for senseless, sentence in (
        (keep, "There is a machine tip-pe"),
        (["test-card", str(card / "test-card.json")], "--keep"),
        (["test-card", "--feed", "1,2"], "--machine"),
        (["test-card", *made[:2], "--feed", "a,b", "--out", str(card)], "--feed"),
        (["test-card", "--machine", "nothing", "--feed", "1,2", "--out", str(card)], "no machine"),
    ):
        assert command_line.main(senseless) == 2
        told = capfd.readouterr().err
        assert sentence in told
        assert told.count("\n") == 1


@pytest.mark.slow
def test_panels_are_scaled_until_they_fit_a_bed(tmp_path: Path) -> None:
    """The pattern fits, the document gets the panels at that size, and all are smaller by the same."""
    words = ("--machine", "inkscape", "--bed", "200x1200mm", "--oversize", "scale", "--mesh-size", "60mm")
    assert command_line.main(["inflate", CUBE, "--out", str(tmp_path / "out"), *words]) == 0
    report = json.loads((tmp_path / "out" / "report.json").read_text(encoding="utf-8"))
    sides = report["pattern"]["width_mm"], report["pattern"]["height_mm"]
    assert min(sides) <= 200.0
    made = make_bags(CUBE, Settings(mesh_size=0.06), scale=0.5)
    with many_panels.file_of(CUBE, made) as file:
        again = read_bag(Path(file).read_bytes(), Budget())
    before = read_bag(Path(CUBE).read_bytes(), Budget())
    for one, other in zip(again.panels, before.panels, strict=True):
        assert np.allclose(one.outer, 0.5 * other.outer, atol=1e-9)
    assert made.sheet.seal_width == Settings().film.seal_width

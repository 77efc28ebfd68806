# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prints, layouts and assembly sheets from the command line."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from matplotlib.image import imread

from BalloonWorkbench.cli import main
from BalloonWorkbench.core.artwork.files import png_bytes
from BalloonWorkbench.core.nesting import nest as nesting
from BalloonWorkbench.core.units import pressure_text

OUTLINE = {"unit": "mm", "parts": [
    {"outer": [[0, 0], [120, 0], [120, 70], [0, 70]]}, {"outer": [[150, 0], [220, 0], [220, 70], [150, 70]]}
]}  # fmt: skip
ONE = {"unit": "mm", "outer": OUTLINE["parts"][0]["outer"]}
BLUE, GREEN = (20, 40, 200, 255), (20, 180, 40, 255)


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Two rectangles, one, and pictures: blue left and green right, and grey."""
    monkeypatch.setattr(nesting, "PACKAGE", "no_such_package")  # rows: quick
    (tmp_path / "two.json").write_text(json.dumps(OUTLINE), encoding="utf-8")
    (tmp_path / "one.json").write_text(json.dumps(ONE), encoding="utf-8")
    pixels = np.full((80, 220, 4), BLUE, np.uint8)
    pixels[:, 135:] = GREEN
    (tmp_path / "colours.png").write_bytes(png_bytes(pixels, 100.0))
    (tmp_path / "grey.png").write_bytes(png_bytes(np.full((40, 40, 4), (99, 99, 99, 255), np.uint8), 100.0))
    return tmp_path


def run(folder: Path, drawing: str, *options: str) -> int:
    return main(
        ["inflate", str(folder / drawing), "--mesh-size", "12mm", "--out", str(folder / "out"), *options]
    )


def test_everything_at_once(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Two balloons: each gets its own part of the picture, the back another one; both are laid out twice."""
    made = run(
        folder, "two.json", "--artwork", str(folder / "colours.png"),
        "--artwork-back", str(folder / "grey.png"), "--dpi", "60", "--nest", "250mm x 300mm",
        "--balloons", "2", "--machine", "hpgl-plotter", "--intake", "film-valve",
        "--material", "nylon-foil",
    )  # fmt: skip
    told = capsys.readouterr().out
    assert made == 0
    out = folder / "out"
    front, back = (np.rint(imread(out / f"artwork-{side}.png") * 255) for side in ("front", "back"))
    assert front.shape == back.shape
    inked = front[..., 3] == 255
    blue, green = (inked & (np.abs(front - colour).max(axis=2) < 3) for colour in (BLUE, GREEN))
    assert blue.sum() > 1.3 * green.sum() > 1000
    # a neck may reach over into the part of its neighbour
    boxes = [np.percentile(np.argwhere(colour), (10, 90), axis=0) for colour in (blue, green)]
    assert (boxes[0][1] < boxes[1][0]).any() or (boxes[1][1] < boxes[0][0]).any()
    assert (np.abs(back[back[..., 3] == 255] - (99, 99, 99, 255)).max(axis=1) < 3).mean() > 0.9
    assert (out / "artwork.pdf").read_bytes().startswith(b"%PDF")
    for name in ("print-front", "print-back", "nested", "nested-2"):
        assert (out / f"{name}-pattern-hpgl-plotter.plt").stat().st_size > 500, name
    assert (out / "nested-pattern-hpgl-plotter-valve.plt").stat().st_size > 500
    assert "Valve film 1: pieces 8" in told  # two strips for each of two balloons of two shapes
    assert "at 60 dpi, front and back" in told
    assert "% used" in told
    assert "spyrrow" in told
    report = json.loads((out / "report.json").read_text(encoding="utf-8"))
    for part in report["parts"]:
        maker = part["maker"]
        assert maker["weight_g"]["valve"] > 0.1
        assert maker["weight_g"]["all"] == pytest.approx(part["lift"]["weight_g"])
        assert maker["floating"][0]["lift_g"] == pytest.approx(part["lift"]["lift_g"])
        assert f"Safe pressure: {pressure_text(maker['strength']['safe_pressure_Pa'])} (" in told
        assert maker["will_it_float"].startswith("Helium lifts")


def test_without_a_machine_the_cut_files_are_for_any_program(folder: Path) -> None:
    asked = ("--artwork", str(folder / "grey.png"), "--dpi", "40", "--nest", "300mm", "--assembly", "Letter")
    assert run(folder, "one.json", *asked) == 0
    names = {path.name for path in (folder / "out").iterdir()}
    assert {"print-front-pattern.dxf", "print-back-pattern.svg", "nested-pattern.dxf"} <= names
    assert "REGISTRATION" in (folder / "out" / "print-front-pattern.svg").read_text(encoding="utf-8")
    assert (folder / "out" / "assembly.pdf").read_bytes().startswith(b"%PDF")


def test_a_machine_has_its_marks(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Those of the first machine that looks for any; the others are told, also the one that does not fit."""
    grey = ("--artwork", str(folder / "grey.png"), "--dpi", "40")
    more = (word for name in ("lightburn", "silhouette-inkscape", "zuend") for word in ("--machine", name))
    assert run(folder, "one.json", *grey, "--machine", "print-and-cut-pdf", *more) == 0
    told = capsys.readouterr().out
    out = folder / "out"
    text = (out / "print-back-pattern-silhouette-inkscape.svg").read_text(encoding="utf-8")
    assert 'width="210mm" height="297mm"' in text
    assert 'id="Regmarks"' in text
    assert "The print has the marks of Silhouette from Inkscape, and Zünd Cut Center (flat bed) looks" in told
    assert "Print 210 x 297 mm at 40 dpi, front and back" in told
    assert b"/CutContour" in (out / "artwork-print-and-cut-pdf.pdf").read_bytes()
    assert not list(out.glob("print-*.pdf"))
    assert (out / "print-front-pattern-lightburn_mm.dxf").is_file()
    assert run(folder, "one.json", *grey, "--machine", "cricut", "--bleed", "50mm") == 0
    told = capsys.readouterr().out
    assert "Left out: The print measures" in told
    assert (out / "report.json").is_file()


@pytest.mark.parametrize(
    ("options", "text"),
    [
        (["--artwork-back", "grey.png"], "--artwork"),
        (["--artwork", "nowhere.png"], "nowhere.png"),
        (["--nest", "a x b x c"], "500mmx700mm"),
        (["--nest", "50mm"], "does not fit"),
        (["--artwork", "grey.png", "--dpi", "1"], "dots per inch"),
        (["--artwork", "grey.png", "--marks-for", "oracle"], "no machine"),
    ],
)
def test_mistakes_are_one_line(
    folder: Path, options: list[str], text: str, capsys: pytest.CaptureFixture[str]
) -> None:
    named = [str(folder / word) if word.endswith(".png") else word for word in options]
    assert run(folder, "one.json", *named) == 2
    told = capsys.readouterr().err
    assert text in told
    assert told.count("\n") == 1
    assert not (folder / "out").exists()

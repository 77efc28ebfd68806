# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pattern larger than the bed: what is said, what is written, and the balloon that fits."""

from __future__ import annotations

import ast
import json
import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import BalloonWorkbench
from BalloonWorkbench.cli import command_line
from BalloonWorkbench.core.advice.findings import Finding
from BalloonWorkbench.core.errors import ExportError, InputError
from BalloonWorkbench.core.machines import bed
from BalloonWorkbench.core.machines.machine import FOLDER, bed_text, machine, parse_bed
from BalloonWorkbench.core.machines.preflight import ERROR, WARNING, preflight
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.pattern.build import build_pattern
from BalloonWorkbench.core.pattern.layout import on_one_sheet
from BalloonWorkbench.core.pattern.pattern import Pattern, Role

ROUND = np.linspace(0.0, 2.0 * np.pi, 181)[:-1]
DISC = 0.1 * np.stack([np.cos(ROUND), np.sin(ROUND)], axis=1)


def disc(scale: float = 1.0, wide: float = 1.0) -> Pattern:
    """A disc of 200 mm, or an ellipse, with a weld of 5 mm and 2 mm outside."""
    return build_pattern(
        Outline(scale * DISC * (wide, 1.0)), 0.005, PatternOptions(allowance=0.002, intake=False)
    )


@pytest.mark.parametrize(
    ("text", "size"),
    [
        ("600x400mm", (0.6, 0.4)),
        ("60 x 40 cm", (0.6, 0.4)),
        ("600mm", (0.6, math.inf)),
        ("12in x 24in", (0.3048, 0.6096)),
        ("none", None),
        ("600 mm × 1.5 m", (0.6, 1.5)),
    ],
)
def test_beds_as_people_write_them(text: str, size: tuple[float, float] | None) -> None:
    wanted = None if size is None else pytest.approx(size)
    assert parse_bed(text) == wanted
    assert parse_bed(bed_text(parse_bed(text))) == wanted
    assert machine("lightburn", text).bed == parse_bed(text)


@pytest.mark.parametrize(
    "text",
    ["", "large", "600x400", "100x100", "20", "0mm", "-5mm x 3mm", "1x2x3mm", "nan mm", "1e9 mm", "1mm"],
)
def test_senseless_beds(text: str) -> None:
    """Also numbers without a unit, which would be metres."""
    with pytest.raises(InputError):
        parse_bed(text)


def size_findings(pattern: Pattern, name: str, size: str, oversize: str = bed.REFUSE) -> list[Finding]:
    found = preflight(pattern, machine(name, size), oversize)
    return [finding for finding in found if finding.oversize or "bed" in finding.text]


def test_what_is_said_of_a_bed() -> None:
    """214 mm with weld and allowance: 100 mm of bar and its room go with it."""
    side = 0.2 + 2 * (0.005 + 0.002)
    assert disc().size == pytest.approx((side, side), abs=2e-4)
    assert size_findings(disc(), "inkscape", "215mm") == []
    assert size_findings(disc(wide=1.5), "inkscape", "226mm x 400mm")[0].severity == WARNING
    assert "90 degrees" in size_findings(disc(wide=1.5), "inkscape", "226mm x 400mm")[0].text
    (finding,) = size_findings(disc(), "inkscape", "150 x 300 mm")
    assert (finding.severity, finding.oversize) == (ERROR, True)
    assert "anyway" in finding.text
    (finding,) = size_findings(disc(), "inkscape", "150 x 300 mm", bed.WRITE)
    assert finding.severity == WARNING
    two = on_one_sheet([disc(), disc()])
    assert "sheets" in size_findings(two, "inkscape", "250 x 250 mm")[0].text
    assert "sheets" not in size_findings(two, "inkscape", "150 x 250 mm")[0].text


def test_a_mistake_stays_one_with_write() -> None:
    """Only the bed can be overruled: a cut that crosses itself is no cut."""
    crossed = replace(disc(), contours=tuple(
        replace(each, points=each.points[[*range(90), *range(135, 180), *range(90, 135)]])
        if each.role is Role.CUT else each for each in disc().contours
    ))  # fmt: skip
    found = preflight(crossed, machine("inkscape", "150 x 300 mm"), bed.WRITE)
    assert any(finding.severity == ERROR and "cross" in finding.text for finding in found)


@pytest.mark.parametrize(
    ("wide", "size"), [(1.0, "150mm x 120mm"), (2.0, "150mm x 600mm"), (2.0, "100mm"), (0.4, "170mm x 60mm")]
)
def test_scaled_until_it_fits(wide: float, size: str) -> None:
    """Just so: within 0.2 % of what the bed leaves; weld and allowance are as wide as before."""
    chosen = replace(machine("inkscape", size), control_bar=False)
    made = []

    def make(scale: float) -> Pattern:
        made.append(disc(scale, wide))
        return made[-1]

    scale = bed.scale_to_fit(disc(1.0, wide), [chosen], make)
    fitted = made[-1]
    assert scale < 1.0
    assert bed.fits(fitted, chosen)
    assert not bed.fits(disc(1.002 * scale, wide), chosen)
    assert len(made) <= 3
    (cut,), (seal,) = fitted.of(Role.CUT), fitted.of(Role.SEAL)
    beside = 0.5 * (np.ptp(cut.points, axis=0) - np.ptp(seal.points, axis=0))
    assert beside == pytest.approx(np.full(2, 0.0045), abs=1e-4)


def test_many_pieces_are_scaled_until_they_fit() -> None:
    """Eight discs in rows: most of what lies between their welds does not shrink."""
    chosen = replace(machine("inkscape", "160mm x 110mm"), control_bar=False)
    made = []

    def make(scale: float) -> Pattern:
        made.append(on_one_sheet([disc(scale)] * 8))
        return made[-1]

    bed.scale_to_fit(on_one_sheet([disc()] * 8), [chosen], make)
    assert bed.fits(made[-1], chosen)
    assert len(made) <= 5


def test_what_fits_stays() -> None:
    def make(_scale: float) -> Pattern:
        raise AssertionError

    assert bed.scale_to_fit(disc(), [machine("lightburn"), machine("paper")], make) == 1.0
    assert bed.scale_to_fit(disc(), [], make) == 1.0


def test_a_bed_that_nothing_fits() -> None:
    with pytest.raises(ExportError, match="another machine"):
        bed.scale_to_fit(disc(), [machine("inkscape", "10mm")], disc)


def test_every_refusal_offers_a_way_on() -> None:
    """Each sentence with which an export ends tells what to do."""
    actions = (
        "choose", "close it", "simplify", "make the", "let the", "leave out", "repair that", "move the",
        "lay out",
    )  # fmt: skip
    package = Path(BalloonWorkbench.__file__).parent
    files = [
        *(package / "core" / "machines").glob("*.py"),
        package / "app" / "engine" / "export.py",
        *(package / "app" / "machines").glob("*.py"),
    ]
    assert all(path.is_file() for path in files)
    dead_ends = []
    for path in files:
        calls = [
            node
            for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
            if isinstance(node, ast.Call)
        ]
        for call in calls:
            severe = ast.unparse(call.func) == "ExportError" or ast.unparse(call).startswith(
                "PreflightFinding(ERROR"
            )
            sentence = "".join(
                str(each.value) for each in ast.walk(call) if isinstance(each, ast.Constant)
            ).lower()
            if severe and len(sentence.split()) > 4 and not any(action in sentence for action in actions):
                dead_ends.append(f"{path.name}:{call.lineno} {sentence}")
    assert not dead_ends


@pytest.fixture
def square(tmp_path: Path) -> Path:
    path = tmp_path / "square.json"
    path.write_text(json.dumps({"unit": "mm", "outer": [[0, 0], [200, 0], [200, 200], [0, 200]]}))
    return path


def run(square: Path, *more: str) -> tuple[int, Path]:
    out = square.parent / "out"
    words = ["inflate", str(square), "--width", "200mm", "--mesh-size", "25mm", "--machine", "inkscape"]
    code = command_line.main([*words, "--out", str(out), *more])
    return code, out


def test_command_line_refuses_and_tells_the_ways(square: Path, capsys: pytest.CaptureFixture[str]) -> None:
    code, out = run(square, "--bed", "150x150mm")
    assert code == 2
    told = capsys.readouterr().err
    assert "--oversize" in told
    assert "--bed" in told
    assert not out.exists()


def test_command_line_writes_when_asked(square: Path, capsys: pytest.CaptureFixture[str]) -> None:
    code, out = run(square, "--bed", "150x150mm", "--oversize", "write")
    assert code == 0
    assert (out / "pattern-inkscape.svg").exists()
    assert "written anyway" in capsys.readouterr().out
    assert json.loads((out / "report.json").read_text())["input"]["width_mm"] == pytest.approx(200.0)


def test_command_line_scales(square: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The pattern fits the bed and fills it; the weld is as wide as for the large one; the report agrees."""
    code, out = run(square, "--bed", "180x500mm", "--oversize", "scale", "--allowance", "3mm")
    assert code == 0
    report = json.loads((out / "report.json").read_text())
    across = min(report["pattern"]["width_mm"], report["pattern"]["height_mm"])
    assert 170.0 < across <= 180.0
    assert report["input"]["width_mm"] < 175.0
    assert f"{report['input']['width_mm']:.4g} mm wide instead of 200 mm" in capsys.readouterr().out
    assert "bed" not in (out / "pattern-inkscape.svg").read_text()


@pytest.mark.parametrize(
    ("options", "text"),
    [
        (("--bed", "huge"), "length"),
        (("--oversize", "scale", "--gas-volume", "1l"), "decides the size"),
    ],
)
def test_command_line_mistakes(
    square: Path, options: tuple[str, ...], text: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(square, *options)[0] == 2
    assert text in capsys.readouterr().err
    assert FOLDER.is_dir()


def test_a_bed_without_a_machine(square: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert command_line.main(["inflate", str(square), "--out", str(square.parent), "--bed", "300mm"]) == 2
    assert "--machine" in capsys.readouterr().err

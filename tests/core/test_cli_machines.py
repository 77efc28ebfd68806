# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files for machines, asked for on the command line."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from BalloonWorkbench import cli
from BalloonWorkbench.core.export.machine import FOLDER


@pytest.fixture
def square(tmp_path: Path) -> Path:
    path = tmp_path / "square.json"
    path.write_text(json.dumps({"unit": "mm", "outer": [[0, 0], [200, 0], [200, 200], [0, 200]]}))
    return path


def run(square: Path, *more: str) -> int:
    out = str(square.parent / "out")
    return cli.main(["inflate", str(square), "--width", "200mm", "--mesh-size", "25mm", "--out", out, *more])


def test_files_for_machines(square: Path, capsys: pytest.CaptureFixture[str]) -> None:
    chosen = [word for name in ("lightburn", "cutting-shop", "inkscape", "hpgl-plotter", "paper") for word in
              ("--machine", name)]  # fmt: skip
    assert run(square, *chosen, "--tiled", "A4") == 0
    made = {path.name for path in (square.parent / "out").iterdir()}
    machines = ("lightburn_mm.dxf", "cutting-shop_mm.dxf", "inkscape.svg", "hpgl-plotter.plt", "paper.pdf")
    assert made >= {"pattern.dxf", "pattern-a4.pdf", *(f"pattern-{name}" for name in machines)}
    assert "pattern-a4.pdf" in capsys.readouterr().out


def test_too_large_for_the_bed(square: Path, capsys: pytest.CaptureFixture[str]) -> None:
    own = square.parent / "small.json"
    data = json.loads((FOLDER / "lightburn.json").read_text(encoding="utf-8"))
    own.write_text(json.dumps({**data, "name": "small", "bed_mm": [150, 150]}))
    assert run(square, "--machine", str(own)) == 2
    text = capsys.readouterr().err
    assert "bed" in text
    assert "(5.91 x 5.91 in)" in text
    assert not (square.parent / "out").exists()


def test_unknown_machine_is_told_before_the_work(square: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(square, "--machine", "axe") == 2
    assert "lightburn" in capsys.readouterr().err

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Balloons of meshes from the command line: the whole way, and what does not go together."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from BalloonWorkbench.cli import main

SPOT = Path(__file__).parents[1] / "resources" / "meshes" / "spot.obj"


def test_a_mesh_becomes_panels_with_all_files(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Spot of 16 panels within .3 % of its size on average, in eight pairs of mirror images."""
    words = ["--width", "300mm", "--panels", "16", "--language", "en"]
    assert main(["design", str(SPOT), *words, "--out", str(tmp_path / "out")]) == 0
    names = {path.name for path in (tmp_path / "out").iterdir()}
    assert names >= {"pattern.dxf", "pattern.svg", "balloon.stl", "preview.png", "report.json"}
    report = json.loads((tmp_path / "out" / "report.json").read_text(encoding="utf-8"))
    assert report["input"]["kind"] == report["target"]["kind"] == "body"
    assert report["target"]["width_mm"] == pytest.approx(300.0, rel=0.02)  # its ears are not quite alike
    assert report["inflated"]["volume_m3"] == pytest.approx(report["target"]["volume_m3"], rel=0.03)
    assert report["design"]["relative_error"] < 3e-3
    assert len(report["panels"]) == 16
    assert sum(panel["same_as"] is None for panel in report["panels"]) == 8
    for seam in report["seams"]:
        assert seam["length_a_mm"] == pytest.approx(seam["length_b_mm"], rel=1e-3)
    assert "Off the body" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (["--gores", "8"], "is a body"),
        (["--band", "20mm"], "is a body"),
        (["--panels", "1"], "2 panels or more"),
        (["--width", "1000m"], "Give a width"),
    ],
)
def test_what_does_not_go_together(
    words: list[str], says: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["design", str(SPOT), "--out", str(tmp_path / "out"), "--language", "en", *words]) != 0
    said = capsys.readouterr().err
    assert says in said
    assert len(said.strip().splitlines()) == 1
    assert not (tmp_path / "out").exists()

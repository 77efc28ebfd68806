# SPDX-License-Identifier: LGPL-2.1-or-later
"""Balloons of meshes from the command line: the whole way, and what does not go together."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from mesh_writers import obj
from solids import ball

from BalloonWorkbench.cli import main


@pytest.fixture(scope="module")
def ellipsoid(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A file of few triangles; benchmarks/validation/targets.py has animals."""
    path = tmp_path_factory.mktemp("body") / "ellipsoid.obj"
    target = ball((1.0, 1.3, 0.8), 8)
    path.write_bytes(obj(1e3 * target.points, target.triangles))
    return path


@pytest.mark.slow
@pytest.mark.usefixtures("blank_sheets")
def test_a_mesh_becomes_panels_with_all_files(
    ellipsoid: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Of eight panels within .3 % of its size on average, in four pairs of mirror images."""
    words = ["--width", "300mm", "--panels", "8", "--language", "en"]
    words += ["--weld-speed", "2", "--weld-handling", "3", "--mesh-size", "36mm"]
    assert main(["design", str(ellipsoid), *words, "--out", str(tmp_path / "out")]) == 0
    names = {path.name for path in (tmp_path / "out").iterdir()}
    assert names >= {"pattern.dxf", "pattern.svg", "balloon.stl", "preview.png", "report.json"}
    report = json.loads((tmp_path / "out" / "report.json").read_text(encoding="utf-8"))
    assert report["input"]["kind"] == report["target"]["kind"] == "body"
    assert report["target"]["width_mm"] == pytest.approx(300.0)
    assert report["inflated"]["volume_m3"] == pytest.approx(report["target"]["volume_m3"], rel=0.03)
    assert report["design"]["relative_error"] < 3e-3
    assert len(report["panels"]) == 8
    body = report["body"]
    assert body["clearance_mm"]["least"] < 0.0 < body["clearance_mm"]["most"]
    assert max(map(abs, body["clearance_mm"].values())) == pytest.approx(body["distance_mm"]["max"], rel=0.05)
    assert body["distance_of_diagonal"]["mean"] == pytest.approx(report["design"]["relative_error"])
    ways = body["film_from_body_mm"], body["body_from_film_mm"]
    for name, value in body["distance_mm"].items():
        assert value == pytest.approx(max(way[name] for way in ways))
    assert ways[0]["mean"] < 3e-3 * body["diagonal_mm"]
    assert 0.0 < body["flattening_strain"]["mean"] < body["flattening_strain"]["largest"]
    welded = report["parts"][0]["maker"]["welding"]
    seams = sum(seam["made"] for seam in report["seams"])
    way = report["pattern"]["seam_length_mm"] / 1000.0
    assert welded["hours"] == pytest.approx((way / 2.0 + seams * 3.0) / 60.0)
    assert sum(panel["same_as"] is None for panel in report["panels"]) == 4
    for seam in report["seams"]:
        assert seam["length_a_mm"] == pytest.approx(seam["length_b_mm"], rel=1e-3)
    said = capsys.readouterr().out
    for told in ("Off the body", "Volume of the body", "outside of the body", "at 2 m/min and 3 min"):
        assert told in said


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (["--gores", "8"], "is a body"),
        (["--band", "20mm"], "is a body"),
        (["--panels", "1"], "2 panels or more"),
        (["--panels", "8", "--seams", "no.json"], "There is no file"),
        (["--width", "1000m"], "Give a width"),
        (["--panels", "16", "--accuracy", "0.003"], "give one of them"),
        (["--lies", "enclose", "--accuracy", "0.003"], "follows its body"),
    ],
)
def test_what_does_not_go_together(
    words: list[str], says: str, ellipsoid: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["design", str(ellipsoid), "--out", str(tmp_path / "out"), "--language", "en", *words]) != 0
    said = capsys.readouterr().err
    assert says in said
    assert len(said.strip().splitlines()) == 1
    assert not (tmp_path / "out").exists()


@pytest.mark.slow
@pytest.mark.usefixtures("blank_sheets")
def test_a_body_of_the_seams_that_are_drawn(
    ellipsoid: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """In quarters: its plane of symmetry, and a plane across, which is in the list twice."""
    across = {"do": "plane", "at": [[0, 0, 0]], "along": [0, 0, 1]}
    seams = {
        "unit": "mm",
        "seams": [{"do": "symmetry"}, across, across, {"do": "merge", "panels": ["8", "9"]}],
    }
    (tmp_path / "seams.json").write_text(json.dumps(seams), encoding="utf-8")
    words = [
        "--width",
        "300mm",
        "--panels",
        "1",
        "--seams",
        str(tmp_path / "seams.json"),
        "--mesh-size",
        "40mm",
    ]
    assert main(["inflate", str(ellipsoid), *words, "--language", "en", "--out", str(tmp_path / "out")]) == 0
    report = json.loads((tmp_path / "out" / "report.json").read_text(encoding="utf-8"))
    assert len(report["panels"]) >= 4
    assert "Seam edit 4 is left out. There is no seam between panels 8 and 9." in capsys.readouterr().out

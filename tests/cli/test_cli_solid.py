# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids on the command line: FreeCAD reads them in a process of its own."""

from __future__ import annotations

import json
import subprocess
import sys
from importlib.machinery import PathFinder
from pathlib import Path

import pytest

from BalloonWorkbench.cli import command_line, solid

WITH_FREECAD = pytest.mark.skipif(PathFinder.find_spec("FreeCAD") is None, reason="no FreeCAD here")


def made(path: Path, shape: str) -> Path:
    """A file that FreeCAD wrote, by the end of its name."""
    way = "exportStep" if path.suffix == ".step" else "exportBrep"
    program = f"import os, FreeCAD, Part; {shape}.{way}({str(path)!r}); os._exit(0)"
    subprocess.run([sys.executable, "-c", program], check=True, capture_output=True)
    return path


def run(command: str, path: Path, *options: str) -> tuple[int, Path]:
    out = path.parent / "out"
    return command_line.main([command, str(path), "--out", str(out), *options]), out


@pytest.mark.slow
@pytest.mark.usefixtures("with_freecad")
@WITH_FREECAD
def test_a_step_file_becomes_the_panels_of_its_faces(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = made(tmp_path / "Würfel.step", "Part.makeBox(100, 100, 100)")
    status, out = run("inflate", path, "--width", "50mm", "--mesh-size", "6mm")
    assert status == 0, capsys.readouterr().err
    report = json.loads((out / "report.json").read_text(encoding="utf-8"))
    assert "Panels: 6" in capsys.readouterr().out
    # inextensible film: 1.26 times the volume of the cube
    assert report["inflated"]["volume_m3"] == pytest.approx(1.26 * 125e-6, rel=0.02)
    assert {"balloon.FCStd", "pattern.dxf"} <= {each.name for each in out.iterdir()}


@pytest.mark.usefixtures("with_freecad")
@WITH_FREECAD
def test_the_panels_are_those_of_the_document(tmp_path: Path) -> None:
    """To the last bit: what is read twice is the same, whatever FreeCAD's process did before."""
    path = made(tmp_path / "cone.brep", "Part.makeCone(50, 20, 80)")
    read = solid.solid_reader()
    assert read is not None
    one, other = read(str(path), 0), read(str(path), 0)
    assert one.names == ("Face1", "Face2", "Face3")
    assert one.flats is not None
    assert other.flats is not None
    assert one.target.points.tobytes() == other.target.points.tobytes()
    assert one.flats.corners.tobytes() == other.flats.corners.tobytes()


@pytest.mark.usefixtures("with_freecad")
@WITH_FREECAD
@pytest.mark.parametrize(
    ("content", "words"), [(b"no step", "no solid that can be read"), (b"", "no solid that can be read")]
)
def test_what_is_no_solid_is_one_sentence(
    content: bytes, words: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "broken.step"
    path.write_bytes(content)
    status, out = run("inflate", path)
    assert status == 2
    assert words in capsys.readouterr().err
    assert not out.exists() or not list(out.iterdir())


def test_without_freecad_it_is_one_sentence(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(solid, "has_freecad", lambda: False)
    path = tmp_path / "box.step"
    path.write_bytes(b"ISO-10303-21;")
    status, _ = run("design", path)
    assert status == 2
    assert "is read by FreeCAD, which is not there" in capsys.readouterr().err


def test_a_file_that_is_not_there(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    status, _ = run("design", tmp_path / "no.step")
    assert status == 2
    assert "There is no file" in capsys.readouterr().err

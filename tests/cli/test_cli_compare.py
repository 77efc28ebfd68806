# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command compare: photographs and scans of what the command line itself has written."""

from __future__ import annotations

import json
from pathlib import Path

import ezdxf
import ezdxf.path
import numpy as np
import pytest
import shapely
import trimesh
from drawn_pictures import png
from photographs import photograph

from BalloonWorkbench.cli import command_line
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.readers.vector import read_outermost

FLAG = [[0, 0], [200, 0], [200, 60], [110, 70], [100, 140], [30, 140], [0, 60]]
PIXEL = 0.0004
#: 300 mm in pixels.
SCALE = f"0,0,0,{300e-3 / PIXEL},300mm"
OPTIONS = ("--mesh-size", "14mm", "--notches", "4", "--label", "8", "--mirror")


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the drawing, and what inflate has written of it."""
    folder = tmp_path_factory.mktemp("made")
    drawing = folder / "flag.json"
    drawing.write_text(json.dumps({"unit": "mm", "outer": FLAG}))
    chosen = ["--only", "balloon", "--only", "pattern", *OPTIONS]
    assert command_line.main(["inflate", str(drawing), "--out", str(folder / "out"), *chosen]) == 0
    return folder


@pytest.fixture(scope="module")
def photo(made: Path) -> str:
    """The shadow of balloon.stl with the weld round it, photographed."""
    mesh = trimesh.load(made / "out" / "balloon.stl")
    up = mesh.triangles[mesh.face_normals[:, 2] > 0.0][:, :, :2]
    shadow = shapely.union_all(shapely.polygons(up).tolist(), grid_size=1e-4)
    rim = 1000.0 * (film("mylar").seal_width + PatternOptions().allowance)
    loop = np.array(shadow.buffer(rim, join_style="mitre").exterior.coords)[:-1] / 1000.0
    path = made / "photo.png"
    path.write_bytes(png(photograph([loop], pixel=PIXEL, size=(700, 700), turn=50.0, noise=3.0)))
    return str(path)


def run(made: Path, photo: str, *more: str) -> int:
    return command_line.main(
        ["compare", photo, str(made / "flag.json"), "--out", str(made / "compared"), *more]
    )


def test_a_photograph_of_what_was_written(made: Path, photo: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(made, photo, "--scale", SCALE, "--uncorrected", "--fit", *OPTIONS) == 0
    data = json.loads((made / "compared" / "compare.json").read_text())
    assert data["difference"]["mean_mm"] < 0.25  # a silhouette of such coarse facets is drawn in by 0.15 mm
    assert data["placement"]["turn_deg"] == pytest.approx(-50.0, abs=0.1)
    assert not data["placement"]["mirrored"]
    assert data["film"]["stretch"] == pytest.approx(0.0, abs=3.0 * data["film"]["stretch_error"])
    assert {path.name for path in (made / "compared").iterdir()} == {
        "compare.png", "compare.json", "mylar-as-made.json",
    }  # fmt: skip
    lines = capsys.readouterr().out
    assert "Difference: " in lines
    assert "Stretch of the film: " in lines
    assert film(str(made / "compared" / "mylar-as-made.json")).title.endswith("(as made)")


def test_a_trimmed_weld_is_seen(made: Path, photo: str) -> None:
    """Without the rim that is in the photograph, all of it is larger by the rim."""
    assert run(made, photo, "--scale", SCALE, "--uncorrected", "--rim", "0mm", *OPTIONS) == 0
    data = json.loads((made / "compared" / "compare.json").read_text())
    assert data["offset_mm"] == pytest.approx(7.15, abs=0.15)
    assert data["film"] is None


@pytest.mark.parametrize("ending", ["dxf", "svg"])
def test_a_scanned_panel_beside_its_file(made: Path, ending: str) -> None:
    """The cut of one of both panels, with notches, label and weld in the file."""
    cuts = [
        np.array([(point.x, point.y) for point in ezdxf.path.make_path(entity).flattening(0.01)])[:-1]
        / 1000.0
        for entity in ezdxf.readfile(made / "out" / "pattern.dxf").modelspace()
        if entity.dxf.layer == "CUT"
    ]
    assert len(cuts) == 2
    scan = made / "scan.png"
    scan.write_bytes(
        png(photograph([cuts[0]], pixel=PIXEL, size=(750, 750), turn=-120.0, colour=(60, 60, 90)))
    )
    pattern = str(made / "out" / f"pattern.{ending}")
    arguments = ["compare", str(scan), pattern, "--flat", "--scale", SCALE, "--out", str(made / "flat")]
    assert command_line.main(arguments) == 0
    outer = [each.outer for each in read_outermost(pattern)]  # without welds and letters inside
    sizes = [sorted(np.ptp(loop, axis=0).tolist() for loop in loops) for loops in (outer, cuts)]
    assert np.allclose(*sizes, rtol=0.0, atol=1e-5)
    data = json.loads((made / "flat" / "compare.json").read_text())
    assert data["difference"]["mean_mm"] < 0.06
    assert not data["placement"]["mirrored"]


@pytest.mark.parametrize(
    ("more", "text"),
    [
        (["--scale", "5,5,5,5,300mm"], "has no length"),
        (["--scale", "three"], "cannot be used"),
        (["--scale", SCALE, "--flat", "--fit"], "leave out --fit"),
        (["--scale", SCALE, "--rim=-1mm"], "--rim is the width"),
        (["--scale", SCALE, "--gores", "8"], "two equal panels"),
        (["--scale", SCALE, "--fit", "--young=1e9", "--poisson=0.3", "--thickness=1e-5"], "--material"),
        (["--scale", "fit", "--uncorrected", "--fit", *OPTIONS], "tells nothing of the film"),
        (["--scale", "30,300mm", "--uncorrected", *OPTIONS], "check the scale"),
    ],
)  # fmt: skip
def test_what_cannot_be_compared_is_told_in_a_line(
    made: Path, photo: str, more: list[str], text: str, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    out = ["--out", str(tmp_path / "out")]
    assert command_line.main(["compare", photo, str(made / "flag.json"), *out, *more]) == 2
    complaint = capsys.readouterr().err
    assert text in complaint
    assert len(complaint.strip().splitlines()) == 1
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("name", ["missing.png", "flag.json"])
def test_what_is_no_picture(made: Path, name: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(made, str(made / name), "--scale", SCALE) == 2
    assert name in capsys.readouterr().err

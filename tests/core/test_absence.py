# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whatever is missing, the rest works, and what does not says what to install."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from absent import without

from BalloonWorkbench.cli import main
from BalloonWorkbench.core import packages
from BalloonWorkbench.core.errors import MissingPackageError
from BalloonWorkbench.core.job import Balloon, Settings, files, make_balloon
from BalloonWorkbench.core.machines.machine import machine
from BalloonWorkbench.core.machines.machine_file import machine_file
from BalloonWorkbench.core.pattern.label import with_label
from BalloonWorkbench.core.readers.read import read_drawing
from BalloonWorkbench.core.solver import backend
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.tracing import raster

PICTURES = Path("resources/examples/pictures")
OUTLINE = {"unit": "mm", "outer": [[0, 0], [120, 0], [120, 70], [0, 70]]}
COARSE = Settings(mesh_size=0.016, correct=False)


@pytest.fixture
def drawing(tmp_path: Path) -> Path:
    path = tmp_path / "box.json"
    path.write_text(json.dumps(OUTLINE), encoding="utf-8")
    return path


@pytest.fixture(scope="module")
def balloon(tmp_path_factory: pytest.TempPathFactory) -> Balloon:
    path = tmp_path_factory.mktemp("drawing") / "box.json"
    path.write_text(json.dumps(OUTLINE), encoding="utf-8")
    return make_balloon(path, COARSE)


def test_every_package_we_may_miss_is_told_about(tmp_path: Path) -> None:
    assert packages.missing() == []
    for name in packages.ABSENCES:
        with without(name, folder=tmp_path):
            (told,) = packages.missing()
        assert told.startswith(f"The Python package {name} is missing. ")
        assert "To get it: pip install " in told


def test_without_scipy_outlines_and_patterns_remain(drawing: Path, balloon: Balloon, tmp_path: Path) -> None:
    with without("scipy", folder=tmp_path):
        assert read_drawing(PICTURES / "star.png", 0.2)[1] == "picture"
        with pytest.raises(MissingPackageError, match="pip install scipy"):
            make_balloon(drawing, COARSE)
        assert set(files(balloon)) >= {"pattern.dxf", "pattern.svg", "balloon.stl", "preview.png"}


def test_without_scipy_a_mesh_still_inflates(balloon: Balloon, tmp_path: Path) -> None:
    """The native solver stands on its own."""
    with without("scipy", folder=tmp_path):
        again = inflate(balloon.design.inflation.panel, COARSE.film, COARSE.pressure)
    assert again.report.backend == "native"
    assert again.volume == balloon.design.inflation.volume


def test_without_opencv_pictures_need_another_reader(tmp_path: Path) -> None:
    with without("cv2", folder=tmp_path):
        assert raster.opencv() is None
        with pytest.raises(MissingPackageError, match="opencv-python-headless"):
            read_drawing(PICTURES / "star.png", 0.2)


def test_without_ezdxf_all_other_files_are_written(drawing: Path, balloon: Balloon, tmp_path: Path) -> None:
    (tmp_path / "a.dxf").write_text("0\nSECTION\n2\nENTITIES\n0\nENDSEC\n0\nEOF\n", encoding="ascii")
    with without("ezdxf", folder=tmp_path):
        written = files(balloon)
        with pytest.raises(MissingPackageError, match="pip install ezdxf"):
            read_drawing(tmp_path / "a.dxf")
    assert set(written) == {"pattern.svg", "balloon.stl", "preview.png", "report.json"}
    assert (
        "pattern.dxf was left out. Writing DXF needs ezdxf"
        in json.loads(written["report.json"])["warnings"][-1]
    )


def test_without_matplotlib_only_the_preview_is_left_out(balloon: Balloon, tmp_path: Path) -> None:
    with without("matplotlib", folder=tmp_path):
        written = files(balloon)
        pattern = balloon.patterns[0]
        assert with_label(pattern, "", 0.006) is pattern
        with pytest.raises(MissingPackageError, match="leave the label empty"):
            with_label(pattern, "7", 0.006)
    assert set(written) == {"pattern.dxf", "pattern.svg", "balloon.stl", "report.json"}


def test_the_command_line_tells_what_it_left_out(
    drawing: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    command = ["inflate", str(drawing), "--mesh-size", "16mm", "--out", str(tmp_path / "out")]
    with without("matplotlib", "ezdxf", "FreeCAD", folder=tmp_path):
        assert main(command) == 0
    told = capsys.readouterr().out
    assert "Note: pattern.dxf was left out." in told
    assert "Note: preview.png was left out." in told
    assert {path.name for path in (tmp_path / "out").iterdir()} == {
        "pattern.svg",
        "balloon.stl",
        "report.json",
    }


def test_without_shapely_outlines_are_read_and_inflated(
    drawing: Path, balloon: Balloon, tmp_path: Path
) -> None:
    with without("shapely", folder=tmp_path):
        assert read_drawing(drawing)[0].size == pytest.approx((0.12, 0.07))
        inflate(balloon.design.inflation.panel, COARSE.film, COARSE.pressure)
        with pytest.raises(MissingPackageError, match="pip install shapely"):
            make_balloon(drawing, COARSE)


def test_without_svgelements_other_drawings_are_read(drawing: Path, tmp_path: Path) -> None:
    (tmp_path / "a.svg").write_text('<svg xmlns="http://www.w3.org/2000/svg"/>', encoding="utf-8")
    with without("svgelements", folder=tmp_path):
        assert read_drawing(drawing)[1] == "json"
        with pytest.raises(MissingPackageError, match="pip install svgelements"):
            read_drawing(tmp_path / "a.svg")


def test_without_pythoncdt_scipy_meshes(drawing: Path, balloon: Balloon, tmp_path: Path) -> None:
    with without("pythoncdt", folder=tmp_path):
        other = make_balloon(drawing, COARSE)
    assert other.design.inflation.volume == pytest.approx(balloon.design.inflation.volume, rel=1e-3)


def test_without_matplotlib_other_machines_are_served(balloon: Balloon, tmp_path: Path) -> None:
    with without("matplotlib", folder=tmp_path):
        assert machine_file(balloon.patterns[0], machine("hpgl-plotter"))
        with pytest.raises(MissingPackageError, match="pip install matplotlib"):
            machine_file(balloon.patterns[0], machine("paper"))


def test_without_the_native_library_numpy_solves(drawing: Path, balloon: Balloon, tmp_path: Path) -> None:
    with without("native", folder=tmp_path):
        assert backend.active_backend() == "numpy"
        other = make_balloon(drawing, COARSE)
    assert other.report["backend"] == "numpy"
    assert other.design.inflation.volume == pytest.approx(balloon.design.inflation.volume, rel=1e-6)


def test_with_numpy_alone_it_still_says_what_to_do(
    drawing: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    others = [name for name in packages.ABSENCES if name != "numpy"]
    with without(*others, "native", "FreeCAD", "PySide", "PySide2", "PySide6", folder=tmp_path):
        assert main(["design", str(drawing), "--out", str(tmp_path / "out")]) == 2
        assert (
            main(["design", str(PICTURES / "star.png"), "--width", "9cm", "--out", str(tmp_path / "out")])
            == 2
        )
    mesh, picture = capsys.readouterr().err.replace("\r", "\n").strip().splitlines()[-2:]
    assert "pip install shapely" in mesh
    assert "python3-opencv" in picture
    assert not (tmp_path / "out").exists()

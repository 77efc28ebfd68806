# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line as a user meets it: its files, its report, and one clear line when something is wrong."""

from __future__ import annotations

import importlib.util
import json
import struct
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from drawn_pictures import any_of, coloured, disc, drawn, png, ring
from matplotlib.image import imread

from BalloonWorkbench.cli import command_line
from BalloonWorkbench.core import job
from BalloonWorkbench.core.pictures.preview import preview_png
from BalloonWorkbench.core.readers.read import read_outline

ROOT = Path(__file__).parents[2]
PICTURES = ROOT / "resources" / "examples" / "pictures"
FILES = {"pattern.dxf", "pattern.svg", "balloon.stl", "preview.png", "report.json"}
SQUARE = {"unit": "mm", "outer": [[0, 0], [200, 0], [200, 200], [0, 200]]}


@pytest.fixture(scope="module")
def heart(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("out") / "not yet there" / "Herz ♥"
    words = ["design", str(PICTURES / "heart.png"), "--width", "300mm", "--mesh-size", "12mm"]
    words += ["--out", str(folder)]
    with pytest.MonkeyPatch.context() as patch:
        patch.delitem(sys.modules, "FreeCAD")  # the one design here that is written with its document
        patch.setattr(job, "preview_png", preview_png)  # and with its picture
        assert command_line.main(words) == 0
    return folder


@pytest.fixture
def square(tmp_path: Path) -> Path:
    path = tmp_path / "square.json"
    path.write_text(json.dumps(SQUARE))
    return path


@pytest.mark.usefixtures("with_freecad")
def test_design_writes_all_its_files(heart: Path) -> None:
    document = {"balloon.FCStd"} if importlib.util.find_spec("FreeCAD") else set()
    assert {path.name for path in heart.iterdir()} == FILES | document
    assert min(imread(heart / "preview.png").shape[:2]) > 500


def test_report_holds_what_schema_2_promises(heart: Path) -> None:
    report = json.loads((heart / "report.json").read_text(encoding="utf-8"))
    wanted = {
        "input": "file kind width_mm height_mm holes welds shapes",
        "material": "name E_Pa nu thickness_m areal_density_kg_m2 weld_rigidity weld_rigidity_source",
        "mesh": "vertices triangles min_angle_deg",
        "solve": "newton_steps factorisations seconds converged stiffness_k",
        "design": "passes seconds silhouette_error_mm relative_error reached unreached weld_range",
        "inflated": "volume_m3 thickness_mm width_mm height_mm film_area_m2 max_tension_N_per_m",
        "pattern": "width_mm height_mm seam_length_mm intake more_intakes",
    }
    for group, names in wanted.items():
        assert set(report[group]) >= set(names.split()), group
    assert set(report["design"]["silhouette_error_mm"]) == {"mean", "p95", "max"}
    creased = {"silhouette_error_mm", "relative_error", "creases", "converged"}
    assert set(report["design"]["weld_range"]) == creased
    intake = {"kind", "how_to_fill", "width_mm", "length_mm", "angle_deg", "at_mm", "along_mm"}
    assert set(report["pattern"]["intake"]) == intake
    assert report["schema"] == 2
    assert report["pressure_Pa"] == 2000.0
    assert report["backend"] == "native"
    assert report["input"]["width_mm"] == pytest.approx(300.0)
    assert report["inflated"]["width_mm"] == pytest.approx(300.0, rel=0.01)
    assert report["design"]["reached"] is True
    assert isinstance(report["warnings"], list)


def test_mesh_of_the_balloon_is_closed_and_in_millimetres(heart: Path) -> None:
    data = (heart / "balloon.stl").read_bytes()
    count = struct.unpack("<I", data[80:84])[0]
    facets = np.frombuffer(data[84:], dtype=np.dtype([("n", "<f4", 3), ("v", "<f4", (3, 3)), ("a", "<u2")]))
    assert len(facets) == count
    corners = facets["v"].astype(float)
    volume = np.einsum("ij,ij->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6.0
    report = json.loads((heart / "report.json").read_text(encoding="utf-8"))
    assert volume * 1e-9 == pytest.approx(report["inflated"]["volume_m3"], rel=0.006)


def test_inflate_keeps_the_outline_as_the_pattern(square: Path, tmp_path: Path) -> None:
    assert (
        command_line.main(["inflate", str(square), "--out", str(tmp_path / "out"), "--mesh-size", "10mm"])
        == 0
    )
    report = json.loads((tmp_path / "out" / "report.json").read_text())
    assert report["design"]["passes"] == 0
    # teabag: 0.2027 of the cube of its side, for a film much stiffer than the pressure
    assert report["inflated"]["volume_m3"] == pytest.approx(0.2027 * 0.2**3, rel=0.02)


def test_options_reach_the_solver(square: Path, tmp_path: Path) -> None:
    words = ["inflate", str(square), "--out", str(tmp_path / "out"), "--mesh-size", "60mm", "--no-native"]
    words += [
        "--young",
        "3e9",
        "--poisson",
        "0.3",
        "--thickness",
        "25e-6",
        "--pressure",
        "1kPa",
        "--width",
        "100mm",
    ]
    assert command_line.main(words) == 2  # 60 mm is too coarse once the width is 100 mm
    words[words.index("60mm")] = "8mm"
    assert command_line.main(words) == 0
    report = json.loads((tmp_path / "out" / "report.json").read_text())
    assert report["backend"] == "numpy"
    assert report["material"]["E_Pa"] == 3e9
    assert report["solve"]["stiffness_k"] == pytest.approx(3e9 * 25e-6 / (1000.0 * 0.1), rel=1e-3)


def test_solvers_agree_through_the_command_line(square: Path, tmp_path: Path) -> None:
    volumes = []
    for extra in ([], ["--no-native"]):
        out = tmp_path / f"out{len(extra)}"
        assert (
            command_line.main(["inflate", str(square), "--out", str(out), "--mesh-size", "25mm", *extra]) == 0
        )
        volumes.append(json.loads((out / "report.json").read_text())["inflated"]["volume_m3"])
    assert volumes[0] == pytest.approx(volumes[1], rel=1e-6)


def test_same_input_writes_the_same_bytes(square: Path, tmp_path: Path) -> None:
    for name in ("one", "two"):
        assert (
            command_line.main(["inflate", str(square), "--out", str(tmp_path / name), "--mesh-size", "30mm"])
            == 0
        )
    for file in FILES - {"report.json"}:  # which holds the seconds
        assert (tmp_path / "one" / file).read_bytes() == (tmp_path / "two" / file).read_bytes(), file


@pytest.fixture(scope="module")
def pair(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A square beside a smaller one, inflated as they are, with welds that hardly stiffen them."""
    folder = tmp_path_factory.mktemp("pair")
    small = (0.5 * np.array(SQUARE["outer"]) + [260, 50]).tolist()
    text = {"unit": "mm", "parts": [{"outer": small}, {"outer": SQUARE["outer"]}]}
    (folder / "pair.json").write_text(json.dumps(text))
    words = ["inflate", str(folder / "pair.json"), "--out", str(folder / "out"), "--mesh-size", "10mm"]
    words += ["--weld-rigidity", "0.001"]
    assert command_line.main(words) == 0
    return folder / "out"


def test_two_shapes_are_two_balloons_in_one_report(pair: Path) -> None:
    report = json.loads((pair / "report.json").read_text())
    assert report["input"]["shapes"] == 2
    assert report["input"]["width_mm"] == pytest.approx(360.0)
    large, small = report["parts"]
    assert [part["outline"]["at_mm"] for part in (large, small)] == [[0.0, 0.0], [260.0, 50.0]]
    for part, side in ((large, 0.2), (small, 0.1)):
        assert part["inflated"]["volume_m3"] == pytest.approx(0.2027 * side**3, rel=0.03)  # teabag
    for group in ("mesh", "solve", "design", "inflated", "pattern"):
        assert report[group] == large[group]


def test_two_shapes_are_two_closed_meshes_in_their_places(pair: Path) -> None:
    data = (pair / "balloon.stl").read_bytes()
    facets = np.frombuffer(data[84:], dtype=np.dtype([("n", "<f4", 3), ("v", "<f4", (3, 3)), ("a", "<u2")]))
    corners = facets["v"].astype(float)
    right = corners[:, :, 0].mean(axis=1) > 230.0
    report = json.loads((pair / "report.json").read_text())
    for mine, part in ((~right, report["parts"][0]), (right, report["parts"][1])):
        volume = np.einsum("ij,ij->", corners[mine, 0], np.cross(corners[mine, 1], corners[mine, 2])) / 6.0
        assert volume * 1e-9 == pytest.approx(part["inflated"]["volume_m3"], rel=0.02)


def test_two_shapes_are_two_patterns_on_one_sheet(pair: Path) -> None:
    import ezdxf

    report = json.loads((pair / "report.json").read_text())
    space = ezdxf.readfile(pair / "pattern.dxf").modelspace()
    cuts = [np.array(list(line.get_points("xy"))) for line in space.query('LWPOLYLINE[layer=="CUT"]')]
    assert len(cuts) == 2
    for points, part in zip(cuts, report["parts"], strict=True):
        size = (part["pattern"]["width_mm"], part["pattern"]["height_mm"])
        assert np.ptp(points, axis=0) == pytest.approx(size, abs=1e-3)
    boxes = sorted((points.min(axis=0).tolist(), points.max(axis=0).tolist()) for points in cuts)
    (_, (left, _)), ((right, _), _) = boxes
    assert right > left + 5.0
    svg = (pair / "pattern.svg").read_text()
    assert svg.count('id="CUT"') == 1


def test_pattern_reads_back_as_an_outline(heart: Path) -> None:
    outline, kind = read_outline(heart / "pattern.dxf")
    report = json.loads((heart / "report.json").read_text(encoding="utf-8"))
    assert kind == "dxf"
    assert outline.size[0] == pytest.approx(report["pattern"]["width_mm"] * 1e-3, abs=1e-5)


def picture(path: Path, pixels: np.ndarray) -> str:
    cv2 = pytest.importorskip("cv2")
    assert cv2.imwrite(str(path), pixels)
    return str(path)


def bad_inputs(folder: Path) -> dict[str, tuple[list[str], str]]:
    """Arguments after the command, and what the complaint must name."""

    def text(name: str, content: str) -> str:
        (folder / name).write_text(content)
        return str(folder / name)

    def loop(name: str, points: object) -> str:
        return text(name, json.dumps({"unit": "mm", "outer": points}))

    good = loop("good.json", SQUARE["outer"])
    fish = str(PICTURES / "fish.png")
    return {
        "no such file": ([str(folder / "none.png"), "--width", "300mm"], "no file"),
        "not a picture": ([text("text.png", "hello"), "--width", "300mm"], "text.png"),
        "empty picture": (
            [picture(folder / "e.png", np.full((64, 64, 3), 255, np.uint8)), "--width", "1m"],
            "shape",
        ),
        "nan": ([text("nan.json", '{"unit": "mm", "outer": [[0, 0], [NaN, 0], [9, 9]]}')], "NaN"),
        "crossing": ([loop("x.json", [[0, 0], [100, 100], [100, 0], [0, 100]])], "crosses"),
        "no area": ([loop("flat.json", [[0, 0], [100, 0], [50, 0]])], "area"),
        "one point": ([loop("points.json", [[5, 5], [5, 5], [5, 5], [5, 5]])], "three"),
        "thinner than the mesh": (
            [loop("thin.json", [[0, 0], [300, 0], [300, 2], [0, 2]]), "--mesh-size", "20mm"],
            "thin",
        ),
        "width 0": ([fish, "--width", "0"], "width"),
        "negative width": ([fish, "--width=-5mm"], "width"),
        "100 km": ([fish, "--width", "100km"], ""),
        "no width": ([fish], "width"),
        "width in words": ([fish, "--width", "wide"], "wide"),
        "pressure 0": ([good, "--pressure", "0"], "pressure"),
        "negative pressure": ([good, "--pressure=-1kPa"], "pressure"),
        "material": ([good, "--material", "unobtainium"], "unobtainium"),
        "half a material": ([good, "--young", "3e9"], "--thickness"),
        "not an option": ([good, "--colour", "red"], "--colour"),
    }


BAD = [
    "no such file", "not a picture", "empty picture", "nan", "crossing", "no area", "one point",
    "thinner than the mesh", "width 0", "negative width", "100 km", "no width", "width in words",
    "pressure 0", "negative pressure", "material", "half a material", "not an option",
]  # fmt: skip


@pytest.mark.parametrize("command", ["design", "inflate"])
@pytest.mark.parametrize("case", BAD)
def test_bad_input_gives_one_line_and_no_file(
    case: str, command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    cases = bad_inputs(tmp_path)
    assert sorted(cases) == sorted(BAD)
    words, named = cases[case]
    assert command_line.main([command, *words, "--out", str(tmp_path / "out")]) == 2
    complaint = capsys.readouterr().err
    assert complaint.count("\n") == 1
    assert named in complaint
    assert "Traceback" not in complaint
    assert not (tmp_path / "out").exists()


def test_a_folder_that_cannot_be_written_leaves_nothing(
    square: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    blocked = tmp_path / "file"
    blocked.write_text("in the way")
    words = ["inflate", str(square), "--mesh-size", "25mm", "--out", str(blocked / "out")]
    assert command_line.main(words) == 2
    assert capsys.readouterr().err.count("\n") == 1
    assert blocked.read_text() == "in the way"


def test_the_module_runs_as_a_program_and_exits_with_2(tmp_path: Path) -> None:
    program = [
        sys.executable,
        "-m",
        "BalloonWorkbench",
        "design",
        "nothing.png",
        "--width",
        "1m",
        "--out",
        str(tmp_path),
    ]
    result = subprocess.run(program, cwd=ROOT, capture_output=True, text=True, check=False)
    assert result.returncode == 2
    assert result.stderr.count("\n") == 1
    assert result.stdout == ""


def test_without_opencv_a_picture_still_becomes_a_balloon(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(command_line, "opencv", lambda: None)
    words = [
        "inflate",
        str(PICTURES / "star.png"),
        "--width",
        "200mm",
        "--mesh-size",
        "20mm",
        "--out",
        str(tmp_path),
    ]
    assert command_line.main(words) == 0
    assert (tmp_path / "pattern.dxf").stat().st_size > 0


def test_hole_of_a_thin_handle_is_told_and_had_back_and_the_intake_is_low(tmp_path: Path) -> None:
    """A mug lying on its side, 300 px wide: its handle is a ring with a band of 16 px."""
    mug = any_of(disc(140, 200, 100), ring(270, 200, 65, 49))
    picture = tmp_path / "mug.png"
    picture.write_bytes(png(coloured(drawn(mug, 400, 400, fine=2))[..., :3]))
    reports = {}
    shape = ["--drawn-as", "shape", "--intake-place", "low"]
    for name, edge, options in (("auto", "30mm", []), ("shape", "14mm", shape)):
        target = tmp_path / name
        size = ["--width", "300mm", "--mesh-size", edge, "--out", str(target)]
        assert command_line.main(["inflate", str(picture), *size, *options]) == 0
        reports[name] = json.loads((target / "report.json").read_text(encoding="utf-8"))
    assert [reports[name]["input"]["holes"] for name in ("auto", "shape")] == [0, 1]
    told = {name: [text for text in reports[name]["warnings"] if "filled" in text] for name in reports}
    assert len(told["auto"]) == 1
    assert "filled shape" in told["auto"][0]
    assert told["shape"] == []
    assert reports["shape"]["pattern"]["intake"]["angle_deg"] == pytest.approx(-90.0, abs=20.0)
    assert reports["shape"]["pattern"]["intake"]["at_mm"][1] == pytest.approx(0.0, abs=6.0)  # 2 % of the size

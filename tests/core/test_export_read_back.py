# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files for machines, read by programs of other people and compared with the pattern within 0.05 mm."""

from __future__ import annotations

import io
import os
import re
import shutil
import subprocess
from pathlib import Path

import ezdxf
import ezdxf.path
import numpy as np
import pytest
import shapely
from drawn_shapes import NAMED
from matplotlib.image import imread

from BalloonWorkbench.core.export.drawing import BAR, draw
from BalloonWorkbench.core.export.fabricate import drawing_file, machine_file
from BalloonWorkbench.core.export.machine import Machine, machine
from BalloonWorkbench.core.export.machine_pdf import PAPERS
from BalloonWorkbench.core.pattern.build import build_pattern
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role

NEAR = 0.05  # mm
DPI = 300
PATTERNS = {name: build_pattern(NAMED[name], 0.005) for name in ("heart", "holes")}
SMALL = build_pattern(NAMED["heart"].map(lambda loop: 0.5 * loop), 0.005)  # fits on A3 with the control bar
DXF = ["lightburn", "rdworks", "silhouette", "cutting-shop", "cutting-shop-inch", "heat-sealer"]


def run(*command: str | Path, **values: str) -> str:
    """What a program prints; the test is skipped where it is not installed."""
    if shutil.which(str(command[0])) is None:
        pytest.skip(f"{command[0]} is not installed")
    done = subprocess.run(
        command, capture_output=True, text=True, timeout=120, check=False, env={**os.environ, **values}
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout + done.stderr


def wanted(pattern: Pattern, made_for: Machine) -> list[tuple[str, shapely.Geometry]]:
    """The contours in mm with their layer, moved as the drawing is: straight from the pattern's points."""
    roles = [role for role in Role if role in made_for.layers]
    contours = [contour for role in roles for contour in pattern.of(role)]
    low = np.min([contour.points.min(axis=0) for contour in contours], axis=0) * 1000.0
    if made_for.control_bar:
        low = low - [0.0, 10.0]
    return [
        (made_for.layers[contour.role].name, line(contour.points * 1000.0 - low, contour.closed))
        for contour in contours
    ]


def line(points: np.ndarray, closed: bool) -> shapely.Geometry:
    return (shapely.LinearRing if closed else shapely.LineString)(points)


def same(read: shapely.Geometry, contour: shapely.Geometry) -> bool:
    """Close all along, both ways; and of the same length."""
    return (
        shapely.hausdorff_distance(read.segmentize(0.5), contour.segmentize(0.5)) < NEAR
        and abs(read.length / contour.length - 1.0) < 2e-3
    )


def compare(read: list[tuple[str, shapely.Geometry]], pattern: Pattern, made_for: Machine) -> None:
    """Each contour is there once, on its layer; besides only the control bar."""
    rest = list(read)
    for layer, contour in wanted(pattern, made_for):
        if layer == "SEAL" and contour.is_ring and made_for.overrun:
            found = [one for one in rest if one[0] == layer and one[1].length > contour.length + 5.0]
            found = [one for one in found if contour.buffer(NEAR).covers(one[1])]
        else:
            found = [one for one in rest if one[0] == layer and same(one[1], contour)]
        assert len(found) == 1, f"{layer}: {len(found)}"
        rest.remove(found[0])
    assert len(rest) == (3 if made_for.control_bar else 0)
    if rest:
        assert max(one.length for _, one in rest) == pytest.approx(BAR, abs=1e-3)


@pytest.fixture(scope="module", params=PATTERNS)
def pattern(request: pytest.FixtureRequest) -> Pattern:
    return PATTERNS[request.param]


@pytest.fixture(scope="module")
def bytes_of() -> dict[tuple[int, str], bytes]:
    return {}


def content(cache: dict[tuple[int, str], bytes], pattern: Pattern, name: str) -> bytes:
    key = id(pattern), name
    if key not in cache:
        cache[key] = machine_file(pattern, machine(name))
    return cache[key]


@pytest.mark.parametrize("name", DXF)
def test_dxf_by_ezdxf(pattern: Pattern, name: str, bytes_of: dict) -> None:
    made_for = machine(name)
    document = ezdxf.read(io.StringIO(content(bytes_of, pattern, name).decode("cp1252")))
    auditor = document.audit()
    assert not auditor.errors
    assert not auditor.fixes
    scale = 25.4 if made_for.unit == "in" else 1.0
    r12 = made_for.version == "R12"
    assert document.dxfversion == ("AC1009" if r12 else "AC1015")
    if not r12:
        assert document.header["$INSUNITS"] == (1 if made_for.unit == "in" else 4)
        assert document.header["$MEASUREMENT"] == (0 if made_for.unit == "in" else 1)
    entities = list(document.modelspace())
    assert {entity.dxftype() for entity in entities} == {"POLYLINE" if r12 else "LWPOLYLINE"}
    read = []
    for entity in entities:
        points = [(p.x * scale, p.y * scale) for p in ezdxf.path.make_path(entity).flattening(0.002 / scale)]
        closed = entity.is_closed if r12 else entity.closed
        look = made_for.layers[
            next(role for role in made_for.layers if made_for.layers[role].name == entity.dxf.layer)
        ]
        assert entity.dxf.color == look.aci == document.layers.get(entity.dxf.layer).color
        read.append((entity.dxf.layer, line(np.array(points), closed)))
        assert (entity.has_arc if not made_for.arcs else False) is False
    compare(read, pattern, made_for)
    high = np.max([np.max(one.coords, axis=0) for _, one in read], axis=0) / scale
    assert document.header["$EXTMAX"][:2] == pytest.approx(high, abs=0.02)
    cuts = [entity.dxf.layer for entity in entities]
    assert cuts == sorted(
        cuts, key=[made_for.layers[role].name for role in Role if role in made_for.layers].index
    )


@pytest.mark.parametrize("name", DXF)
def test_dxf_by_gdal(pattern: Pattern, name: str, bytes_of: dict, tmp_path: Path) -> None:
    """GDAL draws the bulges itself."""
    made_for = machine(name)
    file = tmp_path / "pattern.dxf"
    file.write_bytes(content(bytes_of, pattern, name))
    text = run("ogrinfo", "-al", file, OGR_ARC_STEPSIZE="0.5")
    assert "ERROR" not in text
    layers = re.findall(r"Layer \(String\) = (\w+)", text)
    lines = re.findall(r"LINESTRING(?: Z)? \(([^)]*)\)", text)
    scale = 25.4 if made_for.unit == "in" else 1.0
    read = []
    for layer, course in zip(layers, lines, strict=True):
        points = (
            np.array([[float(value) for value in pair.split()[:2]] for pair in course.split(",")]) * scale
        )
        closed = len(points) > 2 and np.abs(points[0] - points[-1]).max() < 1e-4
        read.append((layer, line(points, closed)))
    compare(read, pattern, made_for)


@pytest.mark.parametrize("name", DXF)
def test_dxf_by_dime(pattern: Pattern, name: str, bytes_of: dict, tmp_path: Path) -> None:
    """A strict reader, which ends with an error at the first odd group; it draws arcs as their chords."""
    made_for = machine(name)
    file = tmp_path / "pattern.dxf"
    file.write_bytes(content(bytes_of, pattern, name))
    text = run("dxf2vrml", file)
    points = np.array(re.findall(r"^\s*(-?[\d.]+)\s+(-?[\d.]+)\s+0\b", text, re.MULTILINE), dtype=float)
    if not made_for.arcs:
        everything = shapely.union_all([contour for _, contour in wanted(pattern, made_for)])
        assert points.max(axis=0) == pytest.approx(everything.bounds[2:], abs=NEAR)
    assert len(points) >= len(pattern.contours)


@pytest.mark.parametrize(
    ("name", "dpi"), [("lightburn", 150), ("cutting-shop", 150), ("cutting-shop-inch", 15)]
)
def test_dxf_by_librecad(name: str, dpi: int, tmp_path: Path) -> None:
    """LibreCAD prints it at 1:1, the size is the pattern's. An inch drawing gets a page of many inches."""
    (tmp_path / "run").mkdir(mode=0o700)
    file = tmp_path / "pattern.dxf"
    drawing = draw(SMALL, machine(name))
    file.write_bytes(drawing_file(drawing, machine(name)))
    run(
        "librecad", "dxf2pdf", "-c", "-m", "-s", "1", file,
        QT_QPA_PLATFORM="offscreen", HOME=str(tmp_path), XDG_RUNTIME_DIR=str(tmp_path / "run"),
    )  # fmt: skip
    ink = page_ink(tmp_path / "pattern.pdf", 1, tmp_path, dpi)
    for axis, size in ((1, drawing.width), (0, drawing.height)):
        assert extent(ink, axis, dpi) == pytest.approx(size, abs=0.5 + 2 * 25.4 / dpi)


def page_ink(file: Path, page: int, folder: Path, dpi: int = DPI) -> np.ndarray:
    """Where a page is not white, by poppler: rows from the top."""
    run(
        "pdftoppm",
        "-r",
        str(dpi),
        "-f",
        str(page),
        "-l",
        str(page),
        "-singlefile",
        "-png",
        file,
        folder / "page",
    )
    return imread(str(folder / "page.png"))[..., :3].min(axis=2) < 0.9


def extent(ink: np.ndarray, axis: int, dpi: int = DPI) -> float:
    """From the first to the last inked column (axis 1) or row (axis 0) [mm]."""
    at = np.flatnonzero(ink.any(axis=1 - axis))
    return (at[-1] - at[0]) * 25.4 / dpi


def test_pdf_has_the_real_size(tmp_path: Path) -> None:
    pattern = SMALL
    drawing = draw(pattern, machine("paper"))
    file = tmp_path / "pattern.pdf"
    file.write_bytes(drawing_file(drawing, machine("paper")))
    size = re.search(r"Page size:\s+([\d.]+) x ([\d.]+) pts", run("pdfinfo", file))
    assert [float(value) * 25.4 / 72.0 for value in size.groups()] == pytest.approx(
        [drawing.width + 24.0, drawing.height + 24.0], abs=0.01
    )
    ink = page_ink(file, 1, tmp_path)
    pixel = 25.4 / DPI
    assert extent(ink, 1) == pytest.approx(drawing.width, abs=0.25 + 2 * pixel)
    assert extent(ink, 0) == pytest.approx(drawing.height, abs=0.25 + 2 * pixel)
    colour = imread(str(tmp_path / "page.png"))[..., :3]
    cyan = (colour[..., 0] < 0.5) & (colour[..., 1] > 0.9) & (colour[..., 2] > 0.9)
    assert extent(cyan, 1) == pytest.approx(BAR, abs=0.25 + 2 * pixel)
    red = (colour[..., 0] > 0.9) & (colour[..., 1] < 0.4) & (colour[..., 2] < 0.4)
    (cut,) = pattern.of(Role.CUT)
    width, height = np.ptp(cut.points, axis=0) * 1000.0
    assert extent(red, 1) == pytest.approx(width, abs=0.25 + 2 * pixel)
    assert extent(red, 0) == pytest.approx(height, abs=0.25 + 2 * pixel)


@pytest.mark.parametrize("paper", ["A4", "Letter"])
def test_tiles_glued_together_are_the_pattern(paper: str, tmp_path: Path) -> None:
    """Pages laid out by their overlap show what the large page shows."""
    pattern, dpi = PATTERNS["heart"], 100
    made_for = machine("paper")
    drawing = draw(pattern, made_for)
    file, whole = tmp_path / "tiles.pdf", tmp_path / "whole.pdf"
    file.write_bytes(drawing_file(drawing, made_for, paper))
    whole.write_bytes(drawing_file(drawing, made_for))
    text = run("pdfinfo", file)
    count = int(re.search(r"Pages:\s+(\d+)", text)[1])
    size = [float(value) * 25.4 / 72.0 for value in re.search(r"([\d.]+) x ([\d.]+) pts", text).groups()]
    assert sorted(size) == pytest.approx(sorted(PAPERS[paper.upper()]), abs=0.05)
    usable = np.array(size) - 24.0
    step = usable - 10.0
    red = red_places(page_pixels(whole, 1, tmp_path, dpi), dpi)
    red = red - [12.0, 12.0]  # the large page's margin
    found = []
    for page in range(2, count + 1):
        words = run("pdftotext", "-f", str(page), "-l", str(page), file, "-")
        column, row = (int(value) for value in re.search(r"column (\d+), row (\d+)", words).groups())
        rows = int(np.ceil((drawing.height - 10.0) / step[1]))
        places = red_places(page_pixels(file, page, tmp_path, dpi), dpi) - [12.0, 12.0]
        found.append(places + step * [column - 1, rows - row])
    glued = shapely.MultiPoint(np.concatenate(found))
    one = shapely.MultiPoint(red)
    assert shapely.hausdorff_distance(one, glued) < 3 * 25.4 / dpi


def test_crop_marks_are_an_overlap_apart(tmp_path: Path) -> None:
    """Four crosses on each page; the right and the upper ones are the neighbours' left and lower ones."""
    made_for, dpi = machine("paper"), 300
    file = tmp_path / "tiles.pdf"
    file.write_bytes(machine_file(PATTERNS["heart"], made_for, "A4"))
    size = [
        float(v) * 25.4 / 72.0 for v in re.search(r"([\d.]+) x ([\d.]+) pts", run("pdfinfo", file)).groups()
    ]
    for page in (2, 3):
        colour = page_pixels(file, page, tmp_path, dpi)
        dark = np.argwhere(colour.max(axis=2) < 0.6)
        at = np.stack([dark[:, 1] + 0.5, colour.shape[0] - dark[:, 0] - 0.5], axis=1) * 25.4 / dpi
        for x in (12.0, size[0] - 12.0 - 10.0):
            for y in (12.0, size[1] - 12.0 - 10.0):
                arms = at[(np.abs(at - [x, y]) < 5.5).all(axis=1) & (np.abs(at - [x, y]).min(axis=1) < 0.3)]
                assert arms.min(axis=0) == pytest.approx([x - 5.0, y - 5.0], abs=0.2)
                assert arms.max(axis=0) == pytest.approx([x + 5.0, y + 5.0], abs=0.2)


def page_pixels(file: Path, page: int, folder: Path, dpi: int) -> np.ndarray:
    page_ink(file, page, folder, dpi)
    return imread(str(folder / "page.png"))[..., :3]


def red_places(colour: np.ndarray, dpi: int) -> np.ndarray:
    """Places of red ink from the lower left of the page [mm]."""
    rows, columns = np.nonzero((colour[..., 0] > 0.9) & (colour[..., 1] < 0.6) & (colour[..., 2] < 0.6))
    return np.stack([columns + 0.5, colour.shape[0] - rows - 0.5], axis=1) * 25.4 / dpi


@pytest.mark.parametrize("name", ["inkscape", "glowforge", "cricut"])
def test_svg_by_svgelements(pattern: Pattern, name: str, bytes_of: dict) -> None:
    """An SVG library that knows units and arcs."""
    svgelements = pytest.importorskip("svgelements")
    made_for = machine(name)
    text = content(bytes_of, pattern, name).decode()
    picture = svgelements.SVG.parse(io.StringIO(text), ppi=25.4)  # one pixel is a millimetre
    read = []
    for path in picture.elements(lambda element: isinstance(element, svgelements.Path)):
        points = [
            (float(at.x), picture.height - float(at.y))
            for segment in path
            if not isinstance(segment, svgelements.Move)
            for at in (segment.point(share) for share in np.linspace(0.0, 1.0, 60))
        ]
        (layer,) = (look.name for look in made_for.layers.values() if look.rgb == path.stroke.hex)
        read.append((layer, line(np.array(points), isinstance(path[-1], svgelements.Close))))
    compare(read, pattern, made_for)


def test_svg_by_librsvg(tmp_path: Path) -> None:
    """A renderer draws it at its real size."""
    drawing = draw(PATTERNS["heart"], machine("cricut"))
    file = tmp_path / "pattern.svg"
    file.write_bytes(drawing_file(drawing, machine("cricut")).replace(b'stroke-width="', b'stroke-width="0'))
    run("rsvg-convert", "-f", "pdf", "-o", tmp_path / "pattern.pdf", file)
    size = re.search(r"Page size:\s+([\d.]+) x ([\d.]+) pts", run("pdfinfo", tmp_path / "pattern.pdf"))
    assert [float(value) * 25.4 / 72.0 for value in size.groups()] == pytest.approx(
        [drawing.width, drawing.height], abs=0.3
    )


def test_hpgl_by_hp2xx(pattern: Pattern, bytes_of: dict, tmp_path: Path) -> None:
    """hp2xx turns it into SVG of its own scale; the control bar tells which."""
    file = tmp_path / "pattern.plt"
    file.write_bytes(content(bytes_of, pattern, "hpgl-plotter"))
    run("hp2xx", "-q", "-m", "svg", "-h", "2000", "-w", "2000", "-f", tmp_path / "out.svg", file)
    paths = re.findall(r'<path d="([^"]*)"', (tmp_path / "out.svg").read_text())
    lines = [np.array(re.findall(r"(-?[\d.]+), (-?[\d.]+)", path), dtype=float) for path in paths]
    joined = lines[:1]
    for points in lines[1:]:
        if np.array_equal(joined[-1][-1], points[0]) and len(joined) > 3:
            joined[-1] = np.concatenate([joined[-1], points[1:]])
        else:
            joined.append(points)
    lines = [points for points in joined if len(points) > 1]
    bar = lines[0]
    scale = BAR / np.linalg.norm(bar[1] - bar[0])
    bottom = max(points[:, 1].max() for points in lines)
    read = [np.stack([points[:, 0], bottom - points[:, 1]], axis=1) * scale for points in lines]
    for _, contour in wanted(pattern, machine("hpgl-plotter")):
        assert any(
            np.abs(points[0] - points[-1]).max() < NEAR and same(line(points[:-1], True), contour)
            for points in read
            if len(points) > 3
        )


def test_hpgl_by_hand() -> None:
    """A square of 100 mm: 4000 plotter units, pen 3, closed."""
    square = np.array([[0.0, 0.0], [0.1, 0.0], [0.1, 0.1], [0.0, 0.1]])
    text = machine_file(
        Pattern((Contour(Role.CUT, square, True),), None, 0.005, 0.4), machine("hpgl-plotter")
    )
    assert text.startswith(b"IN;\nPA;\nSP1;\n")
    assert b"SP3;\nPU0,400;\nPD4000,400,4000,4400,0,4400,0,400;\n" in text
    assert text.endswith(b"PU0,0;\nSP0;\n")


@pytest.mark.parametrize("name", ["lightburn", "cutting-shop", "inkscape", "hpgl-plotter", "paper"])
def test_same_pattern_same_bytes(name: str) -> None:
    made_for = machine(name)
    for tiled in (None, "A4") if name == "paper" else (None,):
        first, second = (machine_file(SMALL, made_for, tiled) for _ in range(2))
        assert first == second


def test_many_times_fewer_segments_than_points() -> None:
    for pattern in PATTERNS.values():
        arcs, lines = (
            sum(len(path.curve) for path in draw(pattern, machine(name)).of(Role.CUT))
            for name in ("lightburn", "rdworks")
        )
        assert arcs <= lines
    heart, fine = (
        sum(len(path.curve) for path in draw(PATTERNS["heart"], machine(name)).of(Role.CUT))
        for name in ("lightburn", "rdworks")
    )
    assert 10 * heart <= len(NAMED["heart"].outer)
    assert heart < 0.2 * fine

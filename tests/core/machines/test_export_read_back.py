# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files for machines, read by programs of other people and compared with the pattern within 0.05 mm."""

from __future__ import annotations

import io
import re
from pathlib import Path

import ezdxf
import ezdxf.path
import numpy as np
import pytest
import shapely
from drawn_shapes import NAMED
from read_back import (
    NEAR,
    Lines,
    apart,
    compare,
    line,
    once_round,
    page_lines,
    pages_of,
    run,
    same,
    svg_lines,
    wanted,
)

from BalloonWorkbench.core.machines.machine import machine
from BalloonWorkbench.core.machines.machine_file import drawing_file, machine_file
from BalloonWorkbench.core.machines.toolpaths import BAR, draw
from BalloonWorkbench.core.pattern.build import build_pattern
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role
from BalloonWorkbench.core.units import to_mm

PATTERNS = {name: build_pattern(NAMED[name], 0.005) for name in ("heart", "holes")}
SMALL = build_pattern(NAMED["heart"].map(lambda loop: 0.5 * loop), 0.005)  # fits on A3 with the control bar
DXF = ["lightburn", "rdworks", "silhouette", "cutting-shop", "cutting-shop-inch", "heat-sealer"]


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
        points = [
            (p.x * scale, p.y * scale)
            for p in ezdxf.path.make_path(entity, segments=8).flattening(0.002 / scale)
        ]
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


def bar(there: bool) -> Lines:
    """The control bar where the drawing begins."""
    lines = [[(0, 2), (BAR, 2)], [(0, 0), (0, 4)], [(BAR, 0), (BAR, 4)]] if there else []
    return [("REGISTRATION", shapely.LineString(points)) for points in lines]


def same_together(read: Lines, given: Lines) -> None:
    """All lines together are the same ones, in pieces perhaps and somewhere else."""
    both = []
    for lines in (read, given):
        together = shapely.union_all([each for _, each in lines])
        middle = shapely.box(*together.bounds).centroid.coords[0]
        both.append(shapely.transform(together, lambda at, middle=middle: at - middle))
    assert apart(*both) < NEAR


@pytest.mark.parametrize("name", ["lightburn", "cutting-shop", "cutting-shop-inch"])
def test_dxf_by_librecad(name: str, tmp_path: Path) -> None:
    """LibreCAD's converter prints it at 1:1; the lines of its page are the pattern's. It knows the inches."""
    (tmp_path / "run").mkdir(mode=0o700)
    file, made_for = tmp_path / "pattern.dxf", machine(name)
    file.write_bytes(machine_file(SMALL, made_for))
    run(
        "librecad", "dxf2pdf", "-c", "-s", "1", file,
        QT_QPA_PLATFORM="offscreen", HOME=str(tmp_path), XDG_RUNTIME_DIR=str(tmp_path / "run"),
    )  # fmt: skip
    page = file.with_suffix(".pdf")
    read, _ = page_lines(page, 1, tmp_path)
    # it stretches the page, and all that is on it, to whole points
    width = pages_of(page)[1][0]
    read = [(rgb, shapely.transform(each, lambda at: at * round(width) / width)) for rgb, each in read]
    same_together(read, wanted(SMALL, made_for) + bar(made_for.control_bar))


@pytest.mark.parametrize("name", ["lightburn", "cutting-shop", "silhouette"])
def test_dxf_by_inkscape(name: str, tmp_path: Path) -> None:
    """Inkscape's importer, which makes an SVG of it: each line on its layer's colour, arcs as arcs."""
    file, made_for = tmp_path / "pattern.dxf", machine(name)
    file.write_bytes(machine_file(SMALL, made_for))
    importer = Path("/usr/share/inkscape/extensions/dxf_input.py")
    if not importer.exists():
        pytest.skip("Inkscape is not installed")
    run("/usr/bin/python3", importer, f"--output={tmp_path / 'read.svg'}", file)
    read, _ = svg_lines((tmp_path / "read.svg").read_text(encoding="utf-8"))
    layers = {look.rgb: look.name for look in made_for.layers.values()}
    compare([(layers[rgb], each) for rgb, each in read], SMALL, made_for)


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
    _, size = pages_of(tmp_path / "pattern.pdf")
    assert size == pytest.approx([drawing.width, drawing.height], abs=0.3)


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
    overcut = to_mm(machine("hpgl-plotter").overcut)
    for _, contour in wanted(pattern, machine("hpgl-plotter")):
        assert any(same(once_round(points, overcut), contour) for points in read if len(points) > 3)


def test_hpgl_by_hand() -> None:
    """A square of 100 mm: 4000 plotter units, pen 3, begun amid an edge, 1 mm past its start."""
    square = np.array([[0.0, 0.0], [0.1, 0.0], [0.1, 0.1], [0.0, 0.1]])
    text = machine_file(
        Pattern((Contour(Role.CUT, square, True),), None, 0.005, 0.4), machine("hpgl-plotter")
    )
    assert text.startswith(b"IN;\nPA;\nSP1;\n")
    assert b"SP3;\nPU1610,400;\nPD4000,400,4000,4400,0,4400,0,400,1610,400,1650,400;\n" in text
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

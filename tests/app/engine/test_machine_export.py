# SPDX-License-Identifier: LGPL-2.1-or-later
"""Patterns as FreeCAD geometry with true arcs, and files for machines that FreeCAD itself reads again."""

import json

import FreeCAD as App
import numpy as np
import Part
import pytest
import shapely
import sketches

import BalloonWorkbench
from BalloonWorkbench.app import film_sheet
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.engine.export import check_for, export_for
from BalloonWorkbench.app.machines.bed import hindrance, scale_to_bed
from BalloonWorkbench.app.pattern import build
from BalloonWorkbench.core.errors import ExportError, InputError
from BalloonWorkbench.core.machines.machine import FOLDER, machine
from BalloonWorkbench.core.options.film import DEFAULT_FILM
from BalloonWorkbench.core.pattern.pattern import Role


@pytest.fixture(scope="module")
def pattern():
    """The pattern of a ring with an intake, without a correction of the pattern."""
    document = App.newDocument("Machines")
    name = document.Name
    made = create.balloon_from_sketch(document, sketches.ring(document), mesh_size=12, correct=False)
    yield made.pattern
    App.closeDocument(name)


def test_shape_has_true_arcs(pattern):
    """Few edges, lines and circles only; within 0.02 mm of the pattern's points, and nothing open."""
    wanted = [
        contour for role in (Role.CUT, Role.CUT_INNER, Role.SEAL) for contour in build(pattern).of(role)
    ]
    edges = pattern.Shape.Edges
    assert {type(edge.Curve) for edge in edges} <= {Part.Line, Part.Circle}
    assert any(isinstance(edge.Curve, Part.Circle) for edge in edges)
    assert len(edges) < 0.2 * sum(len(contour.points) for contour in wanted)
    for wire, contour in zip(pattern.Shape.Wires, wanted, strict=True):
        assert wire.isClosed() == contour.closed
        for point in contour.points[::7]:
            corner = Part.Vertex(pattern.Placement.multVec(App.Vector(*(1000.0 * point), 0.0)))
            assert wire.distToShape(corner)[0] < 0.021
    assert pattern.Shape.Faces[0].isValid()


def test_polylines_where_they_are_wanted(pattern):
    pattern.Arcs = False
    pattern.Document.recompute()
    assert {type(edge.Curve) for edge in pattern.Shape.Edges} == {Part.Line}
    pattern.Arcs = True
    pattern.Document.recompute()
    assert any(isinstance(edge.Curve, Part.Circle) for edge in pattern.Shape.Edges)


#: FreeCAD leaves out the closing segment of a POLYLINE since 1.0; 0.20 and all other readers have it.
R12 = pytest.param(
    "cutting-shop",
    marks=pytest.mark.xfail(
        App.Version()[0] != "0", reason="the importer of FreeCAD 1.0 and 1.1", strict=True
    ),
)


@pytest.mark.parametrize("name", ["lightburn", R12])
def test_freecads_importer_reads_the_dxf(pattern, tmp_path, name):
    """The C++ importer: every line within 0.05 mm of the pattern's points, and they of it; arcs as arcs."""
    import Import

    made_for = machine(name)
    file = export_for(pattern, name, tmp_path)
    document = App.newDocument("Imported")
    try:
        Import.readDXF(str(file), document.Name, False)
        document.recompute()
        edges = [edge for obj in document.Objects if hasattr(obj, "Shape") for edge in obj.Shape.Edges]
        assert Part.Circle in {type(edge.Curve) for edge in edges}
        drawn = [[(point.x, point.y) for point in edge.discretize(Deflection=0.001)] for edge in edges]
    finally:
        App.closeDocument(document.Name)
    contours = [each for each in build(pattern).contours if each.role in made_for.layers]
    lines = [np.concatenate([each.points, each.points[: each.closed]]) * 1000.0 for each in contours]
    low = np.min([line.min(axis=0) for line in lines], axis=0) - [0.0, 10.0 * made_for.control_bar]
    lines = [line - low for line in lines]
    if made_for.control_bar:
        lines += [[(0, 2), (100, 2)], [(0, 0), (0, 4)], [(100, 0), (100, 4)]]
    read, wanted = shapely.MultiLineString(drawn), shapely.MultiLineString(lines)
    assert shapely.hausdorff_distance(read.segmentize(0.5), wanted.segmentize(0.5)) < 0.05


def test_every_machine_writes(pattern, tmp_path):
    for path in sorted(FOLDER.glob("*.json")):
        if machine(path.stem).tool:
            continue
        written = export_for(pattern, path.stem, tmp_path)
        assert written.stat().st_size > 200
    assert export_for(pattern, "paper", tmp_path / "pages.pdf", "A4").read_bytes().startswith(b"%PDF")


def test_gcode_takes_what_only_the_user_knows_from_an_own_file(pattern, tmp_path, monkeypatch):
    """Without it the check says what to give, and nothing is written."""
    data = json.loads((FOLDER / "gcode-grbl.json").read_text(encoding="utf-8"))
    data["tool"] |= {"feed_mm_min": 600, "power_percent": 40}
    (tmp_path / "foil.json").write_text(json.dumps({**data, "name": "foil", "bed_mm": None}))
    monkeypatch.setenv("BALLOON_MACHINES", str(tmp_path))
    content = export_for(pattern, "foil", tmp_path).read_text("ascii")
    assert "M4 S400" in content
    (finding,) = (each for each in check_for(pattern, "gcode-grbl") if each.severity == "error")
    assert "fill in My machines" in finding.text
    with pytest.raises(ExportError, match="feed and power of your laser"):
        export_for(pattern, "gcode-grbl", tmp_path)
    assert len(list(tmp_path.iterdir())) == 2


def test_too_large_is_refused_and_nothing_written(pattern, tmp_path, monkeypatch):
    data = json.loads((FOLDER / "lightburn.json").read_text(encoding="utf-8"))
    (tmp_path / "tiny.json").write_text(json.dumps({**data, "name": "tiny", "bed_mm": [50, 50]}))
    monkeypatch.setenv("BALLOON_MACHINES", str(tmp_path))
    (finding,) = check_for(pattern, "tiny")
    assert "bed" in finding.text
    with pytest.raises(ExportError, match="bed"):
        export_for(pattern, "tiny", tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["tiny.json"]
    assert np.all([check.severity == "warning" for check in check_for(pattern, "lightburn")])


@pytest.fixture
def square(doc, tmp_path):
    """Two shapes of one drawing, the larger 200 mm wide, which is no sketch."""
    path = tmp_path / "squares.svg"
    path.write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" width="300mm" height="150mm" viewBox="0 0 300 150">'
        '<path d="M0 0H200V150H0Z"/><path d="M220 0H300V80H220Z"/></svg>'
    )
    return create.balloon_from_picture(doc, path, "300 mm", mesh_size=25, correct=False, intake=False)


def test_tabs_hold_the_pieces(pattern, tmp_path):
    """FreeCAD's importer finds outline and hole in pieces; larger ones stay whole where that is wished."""
    import Import

    file = export_for(pattern, "lightburn", tmp_path / "tabs.dxf", tabs="0.5 mm")
    document = App.newDocument("Tabs")
    try:
        Import.readDXF(str(file), document.Name, False)
        wires = [obj.Shape for obj in document.Objects if hasattr(obj, "Shape") and obj.Shape.Edges]
        wires = [wire for wire in wires if wire.Length > 15.0]
        assert len([wire for wire in wires if not wire.isClosed()]) > 2 * 2
    finally:
        App.closeDocument(document.Name)
    whole = export_for(pattern, "lightburn", tmp_path / "whole.dxf", tabs="0.5 mm", tabs_below="20 mm")
    assert whole.read_bytes() == export_for(pattern, "lightburn", tmp_path / "none.dxf").read_bytes()
    with pytest.raises(InputError, match="A tab must be"):
        check_for(pattern, "lightburn", tabs="60 mm")


@pytest.mark.parametrize("live", [True, False])
def test_scaled_until_it_fits(square, tmp_path, live):
    """Both balloons of the drawing become smaller, also where they wait for Inflate; the weld stays."""
    for parts in (square, *create.companions(square)):
        parts.balloon.Live = live
    volumes = [parts.balloon.Volume.Value for parts in (square, *create.companions(square))]
    assert len(volumes) == 2
    scale = scale_to_bed(square.pattern, "lightburn", "170 x 130 mm")
    assert scale < 0.95
    assert square.outline.Width.Value == pytest.approx(300 * scale)
    for parts, before in zip((square, *create.companions(square)), volumes, strict=True):
        assert parts.pattern.Status == status.READY
        assert parts.balloon.Volume.Value < 0.9 * before
    (cut,), (seal,) = build(square.pattern).of(Role.CUT), build(square.pattern).of(Role.SEAL)
    beside = 500.0 * (np.ptp(cut.points, axis=0) - np.ptp(seal.points, axis=0))
    weld = build(square.pattern).seal_width * 1000.0
    assert beside == pytest.approx(np.full(2, 0.5 * weld + square.pattern.Allowance.Value), abs=0.1)
    assert not any(finding.oversize for finding in check_for(square.pattern, "lightburn", "170 x 130 mm"))
    assert export_for(square.pattern, "lightburn", tmp_path, bed="170 x 130 mm").exists()


def test_what_is_larger_is_written_or_scaled_when_asked(square, tmp_path):
    width = square.outline.Width.Value
    with pytest.raises(ExportError, match="write the file anyway"):
        BalloonWorkbench.export(square.pattern, tmp_path / "a.dxf", "lightburn", bed="150 mm")
    BalloonWorkbench.export(square.pattern, tmp_path / "b.dxf", "lightburn", bed="150 mm", oversize="write")
    assert square.outline.Width.Value == width
    BalloonWorkbench.export(square.pattern, tmp_path / "c.dxf", "lightburn", bed="150 mm", oversize="scale")
    assert square.outline.Width.Value < width
    assert {path.name for path in tmp_path.glob("*.dxf")} == {"b.dxf", "c.dxf"}
    with pytest.raises(InputError, match="refuse"):
        BalloonWorkbench.export(square.pattern, tmp_path / "d.dxf", "lightburn", oversize="squeeze")


def test_nothing_changes_where_no_size_fits(square):
    with pytest.raises(ExportError, match="another machine"):
        scale_to_bed(square.pattern, "inkscape", "10 mm")
    assert square.outline.Width.Value == pytest.approx(300)
    assert square.pattern.Status == status.READY


def test_what_else_decides_the_size_is_told(square, pattern):
    """A sketch, an expression, a goal: none of them is overruled."""
    assert hindrance(square.pattern) == ""
    assert "Ring" in hindrance(pattern)
    square.balloon.SizeGoal = "Volume"
    assert "volume" in hindrance(square.pattern)
    square.balloon.SizeGoal = "Width"
    sheet = square.outline.Document.addObject("Spreadsheet::Sheet", "Sheet")
    sheet.set("A1", "=250 mm")
    square.outline.setExpression("Width", "Sheet.A1")
    assert "expression" in hindrance(square.pattern)
    with pytest.raises(ExportError, match="expression"):
        scale_to_bed(square.pattern, "lightburn", "100 mm")
    layout = film_sheet.make(square.outline.Document, [square.pattern])
    assert "film" in hindrance(layout)


def test_notches_and_tab_are_in_shape_and_files(pattern, tmp_path):
    pattern.Notches, pattern.TieTab = 8, True
    pattern.Document.recompute()
    assert pattern.Roles.count("NOTCH") == 7  # none at the mouth of the intake
    assert pattern.Roles.count("CUT_INNER") == 2
    marks = [wire for wire, role in zip(pattern.Shape.Wires, pattern.Roles, strict=True) if role == "NOTCH"]
    assert all(abs(mark.Length - 1.5) < 1e-6 for mark in marks)
    assert export_for(pattern, "inkscape", tmp_path).read_bytes().count(b"<path") == 3 + 7 + 2 + 2 + 1
    pattern.NotchDepth = 3
    pattern.Document.recompute()
    assert "weld" in pattern.Status
    pattern.Notches, pattern.TieTab, pattern.NotchDepth, pattern.LabelText = 0, False, 1.5, "L1"
    pattern.Document.recompute()
    assert pattern.Roles.count("ENGRAVE") == 2
    assert pattern.Shape.Faces[0].isValid()
    pattern.LabelText = ""
    pattern.Document.recompute()
    assert "NOTCH" not in pattern.Roles


def test_film_that_no_laser_may_cut(pattern, tmp_path):
    """The panel lists it as not possible, and no file is written; for any way to the pattern."""
    balloon, document = pattern.Balloon, pattern.Document
    balloon.Film = "Custom"
    balloon.Laser, balloon.Joining = "Never", "Glue"
    document.recompute()
    try:
        for obj in (pattern, pattern.getParentGroup()):
            first = check_for(obj, "lightburn")[0]
            assert first.severity == "error"
            assert "laser" in first.text
            with pytest.raises(ExportError, match="laser"):
                export_for(obj, "lightburn", tmp_path)
        assert not list(tmp_path.iterdir())
        assert not any("laser" in finding.text for finding in check_for(pattern, "silhouette"))
        assert any("joined by heat" in finding.text for finding in check_for(pattern, "heat-sealer"))
    finally:
        balloon.Film = DEFAULT_FILM
        document.recompute()
    assert balloon.Laser == "Unknown"
    assert balloon.Joining == "Heat"

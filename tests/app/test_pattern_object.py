# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Pattern object: wires with roles, its own values, exact files."""

import math

import FreeCAD as App
import Mesh
import numpy as np
import pytest
import sketches

from BalloonWorkbench.app import create, status
from BalloonWorkbench.app.export import export_pattern
from BalloonWorkbench.app.pattern import build
from BalloonWorkbench.app.solve import Request
from BalloonWorkbench.core.errors import ExportError


@pytest.fixture(scope="module")
def solved():
    """A balloon from a ring."""
    document = App.newDocument("Ring")
    document.UndoMode = 1
    name = document.Name
    yield create.balloon_from_sketch(document, sketches.ring(document), mesh_size=12, intake=False)
    App.closeDocument(name)


@pytest.fixture
def pattern(solved, monkeypatch):
    """Its pattern; nothing that is done to it needs the solver."""

    def solve(self, progress=None):
        raise AssertionError("a pattern needs no solver")

    monkeypatch.setattr(Request, "solve", solve)
    document = solved.pattern.Document
    document.openTransaction("test")
    yield solved.pattern
    document.abortTransaction()
    document.recompute()
    assert solved.pattern.Status == status.READY


def lengths(pattern, role):
    return [wire.Length for wire, own in zip(pattern.Shape.Wires, pattern.Roles, strict=True) if own == role]


def test_wires_have_roles(pattern):
    assert pattern.Status == status.READY
    assert pattern.Roles == ["CUT", "CUT_INNER", "SEAL", "SEAL"]
    assert all(wire.isClosed() for wire in pattern.Shape.Wires)
    sheet = pattern.Shape.Faces[0]
    assert sheet.isValid()
    assert len(sheet.Wires) == 2


def test_sheet_is_a_ring_of_the_right_width(pattern):
    """The film reaches a weld and an allowance past the seam, on both sides."""
    inner, outer = (
        lengths(pattern, "CUT_INNER")[0] / (2 * math.pi),
        lengths(pattern, "CUT")[0] / (2 * math.pi),
    )
    counts = pattern.Balloon.SeamCounts
    points = np.array([tuple(point)[:2] for point in pattern.Balloon.SeamPoints])
    radii = [np.linalg.norm(loop, axis=1).mean() for loop in np.split(points, [counts[0]])]
    assert outer == pytest.approx(radii[0] + 7, rel=2e-3)
    assert inner == pytest.approx(radii[1] - 7, rel=1e-2)


def test_zero_seal_width_takes_the_films(pattern):
    width = pattern.PatternWidth.Value
    assert pattern.Balloon.SealWidth.Value == 5
    pattern.SealWidth = 5
    pattern.Document.recompute()
    assert pattern.PatternWidth.Value == pytest.approx(width, abs=1e-6)
    pattern.SealWidth = 8
    pattern.Document.recompute()
    assert pattern.PatternWidth.Value == pytest.approx(width + 6, abs=0.01)


def test_allowance(pattern):
    width = pattern.PatternWidth.Value
    pattern.Allowance = 10
    pattern.Document.recompute()
    assert pattern.PatternWidth.Value == pytest.approx(width + 16, abs=0.01)


def test_intake_opens_the_weld(pattern):
    pattern.Intake = True
    pattern.Document.recompute()
    welds = [wire for wire, role in zip(pattern.Shape.Wires, pattern.Roles, strict=True) if role == "SEAL"]
    assert sorted(wire.isClosed() for wire in welds) == [False, True]
    assert pattern.Shape.Faces[0].isValid()


def test_intake_points_where_it_is_told(pattern):
    pattern.Intake, pattern.IntakeAuto, pattern.IntakeAngle = True, False, 90
    pattern.IntakeLength = 60
    pattern.Document.recompute()
    box = pattern.Shape.BoundBox
    assert box.YMax == pytest.approx(-box.YMin + 60 - 7, abs=2)
    assert box.XLength == pytest.approx(-2 * box.YMin, rel=0.02)  # the pattern of a ring is a little oval


def test_automatic_direction_is_shown(pattern):
    pattern.Intake = True
    pattern.IntakeAngle = 271
    pattern.Document.recompute()
    assert pattern.IntakeAngle.Value == pytest.approx(math.degrees(build(pattern).intake.angle))
    assert pattern.getEditorMode("IntakeAngle") == ["ReadOnly"]


def test_senseless_intake_keeps_the_last_pattern(pattern):
    shape, roles = pattern.Shape.Length, pattern.Roles
    pattern.Intake, pattern.IntakeWidth = True, 0
    pattern.Document.recompute()
    assert pattern.Status.startswith(status.STALE)
    assert pattern.Shape.Length == shape
    assert pattern.Roles == roles


def test_dxf_has_the_contours_exactly(pattern, tmp_path):
    import ezdxf

    pattern.Intake = True
    pattern.Document.recompute()
    wanted = build(pattern)
    corner = wanted.bounds[0]
    lines = ezdxf.readfile(export_pattern(pattern, tmp_path / "ring.dxf")).modelspace().query("LWPOLYLINE")
    assert len(lines) == len(wanted.contours)
    for contour in wanted.contours:
        points = (contour.points - corner) * 1000
        assert any(
            line.dxf.layer == contour.role.value
            and line.closed == contour.closed
            and len(line) == len(points)
            and np.abs(np.array(list(line.get_points("xy"))) - points).max() < 1e-3
            for line in lines
        )


def test_file_does_not_depend_on_the_mesh_of_the_object(pattern, tmp_path):
    """The mesh kernel has single precision; the file comes from the stored seam."""
    first = export_pattern(pattern, tmp_path / "a.svg").read_bytes()
    pattern.Balloon.Mesh = Mesh.createBox(1, 1, 1)
    assert export_pattern(pattern, tmp_path / "b.svg").read_bytes() == first


def test_folder_gets_a_dxf(pattern, tmp_path):
    assert export_pattern(pattern, tmp_path) == tmp_path / "pattern.dxf"
    assert (tmp_path / "pattern.dxf").stat().st_size > 1000


def test_other_ending_is_refused(pattern, tmp_path):
    with pytest.raises(ExportError, match=r"\.dxf or \.svg"):
        export_pattern(pattern, tmp_path / "pattern.pdf")
    assert not list(tmp_path.iterdir())


def test_place_that_cannot_be_written(pattern, tmp_path):
    (tmp_path / "file").write_text("no folder")
    with pytest.raises(ExportError, match="writ"):
        export_pattern(pattern, tmp_path / "file" / "pattern.dxf")


def test_stale_pattern_is_not_exported(pattern, tmp_path):
    pattern.Balloon.Film, pattern.Balloon.Thickness = "Custom", 0
    pattern.Document.recompute()
    with pytest.raises(ExportError, match=r"not up to date.*thickness"):
        export_pattern(pattern, tmp_path / "pattern.dxf")
    assert not list(tmp_path.iterdir())


def test_weld_inside_reaches_the_file(doc, tmp_path):
    """A sketch with an inner open line, and what is cut from it."""
    import ezdxf
    import sketches

    from BalloonWorkbench.app import create

    box = sketches.polygon((0, 0), (120, 0), (120, 80), (0, 80))
    sketch = sketches.sketch(doc, *box, sketches.line((30, 40), (90, 40)))
    welded = create.balloon_from_sketch(doc, sketch, mesh_size=9)
    plain = create.balloon_from_sketch(doc, sketches.rectangle(doc, 120, 80), mesh_size=9)
    assert welded.pattern.Roles.count("WELD") == 1
    assert 0.4 < welded.balloon.Volume.Value / plain.balloon.Volume.Value < 0.8
    lines = ezdxf.readfile(export_pattern(welded.pattern, tmp_path / "a.dxf")).modelspace()
    (line,) = lines.query('LWPOLYLINE[layer=="WELD"]')
    assert not line.closed
    points = np.array(list(line.get_points("xy")))
    assert np.linalg.norm(points[-1] - points[0]) == pytest.approx(60, rel=0.3)
    # moving it makes another balloon of the same objects
    before = welded.balloon.Volume.Value
    sketch.movePoint(4, 1, sketches.vector(80, 40), 0)
    doc.recompute()
    assert welded.balloon.Status == status.READY
    assert welded.balloon.Volume.Value > 1.05 * before

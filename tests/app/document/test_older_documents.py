# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents of every release, written by every FreeCAD, open in this one; without the workbench too."""

import json
import os
import subprocess
from pathlib import Path

import FreeCAD as App
import pytest

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import migrate

KEPT = sorted(Path("tests/resources/documents").glob("*.FCStd"))
PARTS = ("Outline", "Balloon", "Pattern")


@pytest.fixture(params=KEPT, ids=lambda path: path.stem)
def older(request):
    document = App.openDocument(str(request.param.resolve()))
    name = document.Name
    yield document
    App.closeDocument(name)


def test_there_are_documents_of_each_freecad():
    names = " ".join(path.name for path in KEPT)
    assert all(f"0.1.0-freecad-{version}" in names for version in ("0.20", "1.0", "1.1"))


def test_older_document_is_brought_up_to_date(older):
    parts = [older.getObject(name) for name in PARTS]
    for obj in parts:
        assert obj.Proxy is not None
        assert obj.SchemaVersion == migrate.SCHEMA
        assert obj.Status == status.READY
    assert older.Balloon.Pressure.Value == pytest.approx(3)
    assert older.Pattern.Allowance.Value == pytest.approx(3)
    assert older.Outline.Shape.Area == pytest.approx(120 * 80)
    assert older.Balloon.Mesh.CountFacets > 100
    volume = older.Balloon.Volume.Value
    for obj in parts:
        obj.touch()
    older.recompute()
    assert [obj.Status for obj in parts] == [status.READY] * 3
    assert older.Balloon.Volume.Value == pytest.approx(volume, rel=0.05)


def test_older_document_can_be_edited(older):
    older.Pattern.Notches = 2
    older.Rectangle.setDatum("Width", App.Units.Quantity("100 mm"))
    older.recompute()
    assert older.Balloon.InflatedWidth.Value == pytest.approx(100, rel=0.03)
    assert older.Pattern.Status == status.READY


@pytest.mark.parametrize("path", KEPT[-2:], ids=lambda path: path.stem)
def test_nothing_is_lost_where_the_workbench_is_not_installed(path, tmp_path):
    """A FreeCAD without it opens the document, and saves it; with it the balloon follows its sketch again."""
    (tmp_path / "user").mkdir()
    program = f"""
import json, FreeCAD as App
document = App.openDocument({str(path.resolve())!r})
document.recompute()
held = [document.Outline.Shape.Area, document.Balloon.Mesh.CountFacets, len(document.Pattern.Shape.Edges)]
document.saveAs({str(tmp_path / "again.FCStd")!r})
told = [held, document.Balloon.SolvedFor != "", document.Outline.Proxy is None]
print("HELD", json.dumps(told), flush=True)
App.closeDocument(document.Name)  # FreeCAD 1.1 crashes when it closes a mesh at its own end
"""
    ended = subprocess.run(
        ["freecadcmd", "-c", program],
        env={**os.environ, "FREECAD_USER_HOME": str(tmp_path / "user")},
        capture_output=True,
        text=True,
        check=False,
        timeout=600,
        stdin=subprocess.DEVNULL,
        cwd=tmp_path,
    )
    lines = [line for line in ended.stdout.splitlines() if "HELD" in line]
    assert lines, ended.stdout + ended.stderr
    line = lines[0]
    (area, facets, edges), solved, without = json.loads(line.partition("HELD ")[2])
    assert without
    assert solved
    assert area == pytest.approx(120 * 80)
    assert facets > 100
    assert edges > 8
    document = App.openDocument(str(tmp_path / "again.FCStd"))
    try:
        parts = [document.getObject(name) for name in ("BalloonGroup", *PARTS)]
        assert [type(obj.Proxy).__name__ for obj in parts] == [f"{name}Proxy" for name in ("Group", *PARTS)]
        document.Rectangle.setDatum("Width", App.Units.Quantity("100 mm"))
        document.Pattern.Notches = 2
        document.recompute()
        assert [obj.Status for obj in parts[1:]] == [status.READY] * 3
        assert document.Outline.Shape.Area == pytest.approx(100 * 80)
        assert document.Balloon.InflatedWidth.Value == pytest.approx(100, rel=0.03)
    finally:
        App.closeDocument(document.Name)


def test_marks_of_the_first_schema_are_parted(older):
    """Lines that all were MARK: those that begin on the cut are notches, all others are drawn."""
    pattern = older.Pattern
    pattern.Notches, pattern.Allowance = 8, 4
    pattern.IntakeKind = "One-way tail"
    older.recompute()
    roles = list(pattern.Roles)
    assert {"NOTCH", "FOLD", "PEN"} <= set(roles)
    pattern.Roles = ["MARK" if role in ("NOTCH", "FOLD", "PEN") else role for role in roles]
    pattern.SchemaVersion = 1
    pattern.Proxy.onDocumentRestored(pattern)
    assert list(pattern.Roles) == ["PEN" if role == "FOLD" else role for role in roles]
    assert pattern.SchemaVersion == migrate.SCHEMA

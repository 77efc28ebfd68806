# SPDX-License-Identifier: LGPL-2.1-or-later
"""Saving and reopening: nothing is lost, everything stays alive, older objects are completed."""

from pathlib import Path

import FreeCAD as App
import numpy as np
import pytest
import sketches

from BalloonWorkbench.app.border import hooks, status
from BalloonWorkbench.app.document import create, migrate
from BalloonWorkbench.app.document.fcstd import save_fcstd
from BalloonWorkbench.app.engine.solve import Request
from BalloonWorkbench.core.errors import ExportError
from BalloonWorkbench.core.job import Settings, make_balloon

HEART = Path("resources/examples/pictures/heart.png")
PROXIES = {"Outline": "OutlineProxy", "Balloon": "BalloonProxy", "Pattern": "PatternProxy"}


@pytest.fixture(scope="module")
def saved(tmp_path_factory):
    """A saved balloon from a rectangle, and what its objects held."""
    path = tmp_path_factory.mktemp("saved") / "box.FCStd"
    document = App.newDocument("Box")
    create.balloon_from_sketch(document, sketches.rectangle(document), mesh_size=12)
    document.saveAs(str(path))
    held = state(document)
    App.closeDocument(document.Name)
    return path, held


@pytest.fixture
def reopened(saved):
    document = App.openDocument(str(saved[0]))
    name = document.Name
    yield document
    App.closeDocument(name)


# FreeCAD 1.x writes these anew when it reads a document
FREECADS_OWN = ("Proxy", "_ElementMapVersion", "AttacherEngine", "ShapeMaterial")


def state(document):
    """All values of the three objects, shapes and meshes as numbers."""
    held = {}
    for name in PROXIES:
        obj = document.getObject(name)
        for own in obj.PropertiesList:
            if own in FREECADS_OWN:
                continue
            value = getattr(obj, own)
            if own == "Shape":
                value = (len(value.Wires), len(value.Edges), round(value.Length, 6), round(value.Area, 4))
            elif own == "Mesh":
                value = np.array([(point.x, point.y, point.z) for point in value.Points]).tobytes()
            elif own in ("Drawing", "Source", "Outline", "Balloon"):
                value = value is not None
            elif isinstance(getattr(value, "Value", value), float):
                value = float(f"{getattr(value, 'Value', value):.12g}")  # a file may lose the last digit
            held[f"{name}.{own}"] = value
    return held


@pytest.fixture
def no_solver(monkeypatch):
    def solve(self, progress=None):
        raise AssertionError("solved although nothing changed")

    monkeypatch.setattr(Request, "solve", solve)


def test_nothing_is_lost(saved, reopened):
    now = state(reopened)
    assert {key for key in now if now[key] != saved[1][key]} == set()


def test_objects_are_alive(reopened):
    assert {name: type(reopened.getObject(name).Proxy).__name__ for name in PROXIES} == PROXIES
    assert type(reopened.Balloon.Proxy).__module__ == "BalloonWorkbench.app.balloon"


def test_opening_solves_nothing(reopened, no_solver):
    for name in PROXIES:
        reopened.getObject(name).touch()
    reopened.recompute()
    assert [reopened.getObject(name).Status for name in PROXIES] == [status.READY] * 3


def test_editing_goes_on(reopened):
    reopened.Rectangle.setDatum("Width", App.Units.Quantity("100 mm"))
    reopened.recompute()
    assert reopened.Balloon.Status == status.READY
    assert reopened.Balloon.InflatedWidth.Value == pytest.approx(100, rel=0.03)


def test_editor_modes_are_restored(reopened):
    assert reopened.Balloon.getEditorMode("Thickness") == ["ReadOnly"]
    assert reopened.Pattern.getEditorMode("IntakeAngle") == ["ReadOnly"]
    assert reopened.Outline.getEditorMode("Drawing") == ["Hidden"]
    assert reopened.Balloon.getEditorMode("Volume") == ["ReadOnly"]


def test_view_providers_are_asked_for(saved, monkeypatch):
    """A window dresses objects that a screenless FreeCAD has saved."""
    dressed = []
    monkeypatch.setattr(hooks, "attach_view", lambda obj: dressed.append(obj.Name))
    document = App.openDocument(str(saved[0]))
    App.closeDocument(document.Name)
    assert sorted(dressed) == sorted([*PROXIES, "BalloonGroup"])


def test_missing_properties_are_added(reopened):
    """What a later release adds, an older file does not have."""
    reopened.Pattern.removeProperty("Allowance")
    reopened.Balloon.removeProperty("SolvedFor")
    for name in PROXIES:
        reopened.getObject(name).Proxy.onDocumentRestored(reopened.getObject(name))
    assert reopened.Pattern.Allowance.Value == 2
    assert reopened.Balloon.SolvedFor == ""


def test_steps_of_migration_run_in_order(reopened, monkeypatch):
    taken = []
    monkeypatch.setattr(migrate, "STEPS", (lambda obj: taken.append(2), lambda obj: taken.append(3)))
    monkeypatch.setattr(migrate, "SCHEMA", 3)
    reopened.Pattern.SchemaVersion = 1
    reopened.Pattern.Proxy.onDocumentRestored(reopened.Pattern)
    assert taken == [2, 3]
    assert reopened.Pattern.SchemaVersion == 3
    reopened.Pattern.Proxy.onDocumentRestored(reopened.Pattern)
    assert taken == [2, 3]


def test_object_of_a_newer_release_is_left_alone(reopened):
    reopened.Pattern.SchemaVersion = 99
    reopened.Pattern.removeProperty("Allowance")
    reopened.Pattern.Proxy.onDocumentRestored(reopened.Pattern)
    assert reopened.Pattern.SchemaVersion == 99
    assert "Allowance" not in reopened.Pattern.PropertiesList


@pytest.fixture(scope="module")
def job():
    """What the command line has at hand when it writes a document."""
    settings = Settings(mesh_size=0.014)
    return settings, make_balloon(HEART, settings, width=0.12).designs


def test_command_line_result_becomes_a_document(job, tmp_path, no_solver):
    settings, designs = job
    path = tmp_path / "balloon.FCStd"
    save_fcstd(path, HEART, settings, designs, width=0.12)
    assert [entry.name for entry in tmp_path.iterdir()] == ["balloon.FCStd"]
    document = App.openDocument(str(path))
    try:
        assert document.Label == "balloon"
        assert document.Balloon.Volume.Value == pytest.approx(designs[0].inflation.volume * 1e9)
        assert [document.getObject(name).Status for name in PROXIES] == [status.READY] * 3
        for name in PROXIES:
            document.getObject(name).touch()
        document.recompute()
        assert [document.getObject(name).Status for name in PROXIES] == [status.READY] * 3
    finally:
        App.closeDocument(document.Name)


def test_document_that_cannot_be_written(job, tmp_path):
    settings, designs = job
    before = list(App.listDocuments())
    (tmp_path / "file").write_text("no folder")
    with pytest.raises(ExportError, match="write"):
        save_fcstd(tmp_path / "file" / "balloon.FCStd", HEART, settings, designs, width=0.12)
    assert list(App.listDocuments()) == before

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Options of the simulation as properties: each changes the balloon, is saved, and is the job's own."""

import math
from dataclasses import replace

import FreeCAD as App
import numpy as np
import pytest
import sketches

from BalloonWorkbench.app.balloon import request
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import create, migrate
from BalloonWorkbench.app.document.fcstd import write_settings
from BalloonWorkbench.app.engine.export import export_results
from BalloonWorkbench.app.engine.solve import Request
from BalloonWorkbench.core.errors import ExportError, InputError
from BalloonWorkbench.core.film.library import film, with_grain, with_weld
from BalloonWorkbench.core.job import Settings
from BalloonWorkbench.core.solver.model import Model

OPTIONS = {
    "Model": "Plain shell",
    "Bending": False,
    "BendingFloor": 50.0,
    "TwoPanels": True,
    "Backend": "Newmark",
    "GrainAngle": 30,
    "YoungModulusAcross": "0.2 GPa",
    "WeldRigidity": 0.2,
    "Weld": "Crumpled",
    "TargetVolume": "0.15 l",
}
NEW = [*OPTIONS, "Load", "ActivePressure", "MaxStrain", "WrinkledShare", "SlackShare"]


@pytest.fixture(scope="module")
def solved():
    """An inflated rectangle of 100 x 80 mm on a coarse mesh."""
    document = App.newDocument("Options")
    document.UndoMode = 1
    name = document.Name
    film_with_grain = with_grain(replace(film("pe"), name="mine"), 0.6 * film("pe").young_modulus)
    yield create.balloon_from_sketch(
        document, sketches.rectangle(document, 100, 80), mesh_size=14, correct=False, material=film_with_grain
    )
    App.closeDocument(name)


@pytest.fixture
def balloon(solved):
    """The same, and as it was after each test."""
    doc = solved.balloon.Document
    doc.openTransaction("test")
    yield solved.balloon
    doc.abortTransaction()
    doc.recompute()
    assert solved.balloon.Status == status.READY


def points(balloon):
    return np.array([(point.x, point.y, point.z) for point in balloon.Mesh.Points])


@pytest.mark.parametrize(
    "name",
    ["Model", "BendingFloor", "TwoPanels", "GrainAngle", "YoungModulusAcross", "WeldRigidity", "Weld"],
)
def test_option_changes_the_mesh(balloon, name):
    before, label = points(balloon), balloon.SolvedFor
    setattr(balloon, name, OPTIONS[name])
    if name == "TwoPanels":
        balloon.GrainAngle = 90  # aslant, both panels are no mirror images
    balloon.Document.recompute()
    assert balloon.Status == status.READY
    assert balloon.SolvedFor != label
    after = points(balloon)
    assert after.shape != before.shape or np.abs(after - before).max() > 1e-3
    assert balloon.Mesh.isSolid()


def test_a_plain_shell_holds_less(balloon):
    volume = balloon.Volume.Value
    balloon.Model = "Plain shell"
    balloon.Document.recompute()
    assert balloon.Volume.Value < 0.99 * volume


def test_newmark_finds_the_same_balloon(balloon):
    volume = balloon.Volume.Value
    balloon.Backend = "Newmark"
    balloon.Document.recompute()
    assert balloon.ActiveBackend == "newmark"
    assert balloon.Volume.Value == pytest.approx(volume, rel=1e-3)


def test_volume_as_the_load(balloon):
    assert balloon.getEditorMode("TargetVolume") == ["Hidden"]
    assert balloon.ActivePressure.Value == pytest.approx(balloon.Pressure.Value)
    volume = balloon.Volume.Value
    balloon.Load = "Volume"
    assert balloon.TargetVolume.Value == volume
    assert balloon.getEditorMode("TargetVolume") == []
    assert balloon.getEditorMode("Pressure") == ["Hidden"]
    balloon.TargetVolume = 1.04 * volume
    balloon.Document.recompute()
    assert balloon.Status == status.READY
    assert balloon.Volume.Value == pytest.approx(1.04 * volume, rel=1e-3)
    assert balloon.ActivePressure.Value > 1.5 * balloon.Pressure.Value
    balloon.TargetVolume = 20 * volume
    balloon.Document.recompute()
    assert balloon.Status.startswith(status.STALE)
    assert "holds less than" in balloon.Status


def test_undo_shows_the_pressure_again(solved):
    doc, balloon = solved.balloon.Document, solved.balloon
    doc.openTransaction("load")
    balloon.Load = "Volume"
    doc.commitTransaction()
    doc.undo()
    assert balloon.getEditorMode("Pressure") == []
    assert balloon.getEditorMode("TargetVolume") == ["Hidden"]


def test_both_panels_with_a_grain_aslant_are_refused(balloon):
    balloon.TwoPanels, balloon.GrainAngle = True, 30
    balloon.Document.recompute()
    assert balloon.Status.startswith(status.STALE)
    assert "grain" in balloon.Status


def test_state_of_the_film_is_told(balloon):
    assert 0.0 < balloon.WrinkledShare < 1.0
    assert 0.0 <= balloon.SlackShare < 1.0 - balloon.WrinkledShare
    assert 0.0 < balloon.MaxStrain < 0.5


def test_usual_options_leave_the_label_of_older_files(balloon):
    """A balloon saved before there were options must not be solved again."""
    wanted = request(balloon)
    plain = replace(wanted, settings=replace(wanted.settings, film=film("pe")))
    same = replace(plain, settings=replace(plain.settings, model=Model(), volume=None))
    assert plain.key() == same.key()
    assert plain._unusual() == []
    options = [
        {"model": Model(tension_field=False)},
        {"model": Model(bending=False)},
        {"model": Model(bending_floor=1e-5)},
        {"model": Model(two_panels=True)},
        {"model": Model(weld="crumpled")},
        {"volume": 1e-3},
        {"film": with_grain(film("pe"), 1e8)},
        {"film": with_grain(film("pe"), 1e8, 0.1)},
        {"film": with_weld(film("pe"), 0.5)},
    ]
    keys = {Request(plain.source, replace(plain.settings, **option)).key() for option in options}
    assert len(keys | {plain.key()}) == len(options) + 1


def test_options_are_saved(tmp_path, doc):
    parts = create.make(doc)
    parts.balloon.Film = "Custom"
    for name, value in OPTIONS.items():
        setattr(parts.balloon, name, value)
    parts.balloon.Load = "Volume"
    held = {name: str(getattr(parts.balloon, name)) for name in NEW}
    doc.saveAs(str(tmp_path / "options.FCStd"))
    again = App.openDocument(str(tmp_path / "options.FCStd"))
    try:
        assert {name: str(getattr(again.Balloon, name)) for name in NEW} == held
        assert again.Balloon.getEditorMode("Pressure") == ["Hidden"]
        assert again.Balloon.getEditorMode("TargetVolume") == []
    finally:
        App.closeDocument(again.Name)


def test_older_object_gets_the_options_and_keeps_its_choices(doc):
    old = create.make(doc).balloon
    for name in NEW:
        if name != "Backend":
            old.removeProperty(name)
    old.Backend = ["Automatic", "Native", "NumPy"]
    old.Backend = "NumPy"
    old.Proxy.onDocumentRestored(old)
    assert set(NEW) <= set(old.PropertiesList)
    assert old.Backend == "NumPy"
    assert "Newmark" in old.getEnumerationsOfProperty("Backend")
    assert (old.Load, old.Model, old.Bending, old.TwoPanels) == ("Pressure", "Tension field", True, False)
    assert (old.WeldRigidity, old.Weld) == (1.0, "Elastic")
    assert old.SchemaVersion == migrate.SCHEMA


def test_options_of_a_job_go_into_the_object(doc):
    parts = create.make(doc)
    parts.outline.Source = sketches.rectangle(doc)
    parts.outline.recompute()
    wanted = Settings(
        film=with_grain(with_weld(film("pe"), 0.4), 1e8, 0.5),
        backend="newmark",
        volume=2e-3,
        model=Model(tension_field=False, bending=False, bending_floor=1e-4, two_panels=True, weld="crumpled"),
    )
    write_settings(parts, wanted)
    found = request(parts.balloon).settings
    assert found.film.young_modulus_across == pytest.approx(1e8)
    assert found.film.grain_angle == pytest.approx(0.5)
    assert (found.film.weld_rigidity, found.film.weld_rigidity_source) == (0.4, "given by the user")
    assert found.backend == "newmark"
    assert found.volume == pytest.approx(2e-3)
    assert found.model.bending_floor == pytest.approx(1e-4)
    assert replace(found.model, bending_floor=1e-4) == wanted.model


def test_volume_may_be_a_text(doc):
    parts = create.make(doc)
    create.configure(parts, target_volume="2.5 l")
    assert parts.balloon.TargetVolume.Value == pytest.approx(2.5e6)
    with pytest.raises(InputError, match="volume"):
        create.configure(parts, target_volume="much")


def test_results_are_written(balloon, tmp_path):
    path = export_results(balloon, tmp_path / "results.npz")
    with np.load(path) as found:
        assert np.ptp(found["positions_mm"][:, 2]) == pytest.approx(balloon.InflatedThickness.Value)
        share = (found["state"] == 1).mean()
    assert share == pytest.approx(balloon.WrinkledShare, abs=0.1)


def test_vtk_itself_reads_the_results(balloon, tmp_path):
    fem = pytest.importorskip("Fem")  # FreeCAD's module that has VTK
    mesh = fem.read(str(export_results(balloon, tmp_path / "results.vtu")))
    nodes = np.array([(node.x, node.y, node.z) for node in mesh.Nodes.values()])
    assert mesh.TriangleCount >= balloon.Mesh.CountFacets
    box = balloon.Mesh.BoundBox
    ends = [box.XMin, box.YMin, box.ZMin], [box.XMax, box.YMax, box.ZMax]
    assert np.allclose([nodes.min(axis=0), nodes.max(axis=0)], ends, atol=1e-3)


def test_results_of_nothing_are_refused(balloon, tmp_path):
    with pytest.raises(ExportError, match="vtu"):
        export_results(balloon, tmp_path / "results.obj")
    balloon.Pressure = -1
    balloon.Document.recompute()
    with pytest.raises(ExportError, match="up to date"):
        export_results(balloon, tmp_path / "results.vtu")
    assert list(tmp_path.iterdir()) == []
    assert math.isfinite(balloon.Volume.Value)

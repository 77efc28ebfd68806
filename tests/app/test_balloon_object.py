# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Balloon object: a closed mesh that follows its values, and survives values that make no sense."""

import json
from dataclasses import replace

import FreeCAD as App
import pytest
import sketches

from BalloonWorkbench.app.border import hooks, status
from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.engine.solve import Request
from BalloonWorkbench.core.errors import SolverError

COARSE = 12.0  # mm


@pytest.fixture(scope="module")
def solved():
    """A balloon from a rectangle of 120 x 80 mm; its document remembers undo steps."""
    document = App.newDocument("Solved")
    document.UndoMode = 1
    name = document.Name
    yield create.balloon_from_sketch(document, sketches.rectangle(document), mesh_size=COARSE)
    App.closeDocument(name)


@pytest.fixture
def no_solver(monkeypatch):
    """Fail when the engine is asked."""

    def solve(self, progress=None):
        raise AssertionError("solved although nothing changed")

    monkeypatch.setattr(Request, "solve", solve)


def measures(balloon):
    names = [name for name in balloon.PropertiesList if balloon.getGroupOfProperty(name) == "Result"]
    return {name: getattr(balloon, name) for name in names if name != "Status"}, balloon.Mesh.CountFacets


def test_mesh_is_closed_and_has_the_volume(parts):
    balloon = parts.balloon
    mesh = balloon.Mesh
    assert mesh.isSolid()
    assert not mesh.hasSelfIntersections()
    # flat triangles on a coarse mesh lie inside the curved film
    assert 0.97 * balloon.Volume.Value < mesh.Volume < balloon.Volume.Value
    assert mesh.BoundBox.ZMax == pytest.approx(-mesh.BoundBox.ZMin, rel=1e-6)
    assert mesh.BoundBox.ZLength == pytest.approx(balloon.InflatedThickness.Value, rel=1e-4)


def test_balloon_looks_like_the_drawing(parts):
    balloon = parts.balloon
    assert (balloon.InflatedWidth.Value, balloon.InflatedHeight.Value) == pytest.approx((120, 80), rel=0.03)
    assert balloon.ResidualMean.Value < 0.01 * 120
    assert balloon.ResidualMean.Value <= balloon.ResidualP95.Value <= balloon.ResidualMax.Value
    assert balloon.Converged


def test_what_a_creased_weld_does_is_there_and_in_the_report(parts):
    balloon = parts.balloon
    creased = json.loads(balloon.Report)["design"]["weld_range"]
    error = creased["silhouette_error_mm"]
    shown = [getattr(balloon, name).Value for name in ("CreasedMean", "CreasedP95", "CreasedMax")]
    assert shown == pytest.approx([error["mean"], error["p95"], error["max"]])
    assert 0.0 < shown[0] < shown[1] < shown[2] < 0.2 * 120
    assert shown[2] > balloon.ResidualMax.Value
    assert [tuple(place)[:2] for place in balloon.Creases] == [
        pytest.approx(place["at_mm"]) for place in creased["creases"]
    ]
    assert balloon.getEditorMode("CreasedMax") == ["ReadOnly"]


def test_seam_is_larger_than_the_drawing(parts):
    """Film that does not stretch draws in: the pattern is larger than what is seen."""
    xs = [point.x for point in parts.balloon.SeamPoints]
    assert max(xs) - min(xs) > 1.1 * 120
    assert parts.balloon.FilmArea.Value > 2 * 1.2 * 120 * 80


def test_inflated_as_drawn_it_is_smaller(parts):
    balloon = parts.balloon
    balloon.Mode = "Inflate as drawn"
    balloon.Document.recompute()
    assert balloon.Status == status.READY
    assert balloon.InflatedWidth.Value < 0.95 * 120
    assert balloon.FilmArea.Value == pytest.approx(2 * 120 * 80, rel=1e-6)
    assert balloon.Passes == 0
    assert (balloon.CreasedMax.Value, balloon.Creases) == (0, [])


def test_sketch_edit_changes_everything(parts):
    volume, seam = parts.balloon.Volume.Value, parts.pattern.SeamLength.Value
    parts.outline.Source[0].setDatum("Height", App.Units.Quantity("110 mm"))
    parts.balloon.Document.recompute()
    assert [obj.Status for obj in parts] == [status.READY] * 3
    assert parts.balloon.InflatedHeight.Value == pytest.approx(110, rel=0.03)
    assert parts.balloon.Volume.Value > 1.3 * volume
    assert parts.pattern.SeamLength.Value > seam + 50


def test_nothing_is_solved_twice(parts, no_solver):
    for obj in parts:
        obj.touch()
    parts.balloon.Document.recompute()
    assert [obj.Status for obj in parts] == [status.READY] * 3


def test_moving_the_sketch_moves_the_balloon(parts, no_solver):
    parts.outline.Source[0].Placement = App.Placement(
        App.Vector(5, 6, 7), App.Rotation(App.Vector(1, 0, 0), 90)
    )
    parts.balloon.Document.recompute()
    assert parts.balloon.Placement == parts.outline.Placement
    box = parts.balloon.Mesh.BoundBox
    assert box.YLength == pytest.approx(parts.balloon.InflatedThickness.Value, rel=1e-3)
    assert (box.YMin + box.YMax) / 2 == pytest.approx(6, abs=1e-3)


def test_other_film_brings_its_values(parts):
    from BalloonWorkbench.core.film.library import film

    balloon, label = parts.balloon, parts.balloon.SolvedFor
    balloon.Film = "pe"
    assert balloon.YoungModulus.getValueAs("Pa").Value == pytest.approx(film("pe").young_modulus)
    assert balloon.Thickness.getValueAs("m").Value == pytest.approx(film("pe").thickness)
    balloon.Document.recompute()
    assert balloon.Status == status.READY
    assert balloon.SolvedFor != label


def test_library_film_is_protected_and_custom_is_not(parts):
    balloon = parts.balloon
    assert balloon.getEditorMode("YoungModulus") == ["ReadOnly"]
    young = balloon.YoungModulus.Value
    balloon.Film = "Custom"
    assert balloon.getEditorMode("YoungModulus") == []
    assert balloon.YoungModulus.Value == young
    balloon.YoungModulus = "1 GPa"
    assert balloon.YoungModulus.getValueAs("Pa").Value == pytest.approx(1e9)


def test_pressure_follows_a_spreadsheet(parts):
    doc = parts.balloon.Document
    sheet = doc.addObject("Spreadsheet::Sheet", "Sheet")
    sheet.set("A1", "=3 kPa")
    sheet.setAlias("A1", "pressure")
    doc.recompute()
    parts.balloon.setExpression("Pressure", "Sheet.pressure")
    label = parts.balloon.SolvedFor
    doc.recompute()
    assert parts.balloon.Pressure.Value == pytest.approx(3.0)
    assert parts.balloon.SolvedFor != label
    assert parts.balloon.Status == status.READY


def refused(parts, *words):
    assert parts.balloon.Status.startswith(status.STALE), parts.balloon.Status
    assert all(word in parts.balloon.Status for word in words), parts.balloon.Status
    assert not status.is_ready(parts.pattern)


@pytest.mark.parametrize(
    ("name", "value", "word"),
    [
        ("Pressure", 0, "pressure"),
        ("Pressure", -2, "pressure"),
        ("Thickness", 0, "thickness"),
        ("YoungModulus", -1, "modulus"),
        ("MeshSize", 500, "mesh"),
    ],
)
def test_senseless_value_keeps_the_last_mesh(parts, name, value, word):
    before = measures(parts.balloon)
    parts.balloon.Film = "Custom"
    setattr(parts.balloon, name, value)
    parts.balloon.Document.recompute()
    refused(parts, word)
    assert measures(parts.balloon) == before
    assert parts.balloon.Mesh.isSolid()


def test_back_to_good_values_needs_no_solver(parts, no_solver):
    parts.balloon.Film, film = "Custom", parts.balloon.Film
    parts.balloon.Thickness = 0
    parts.balloon.Document.recompute()
    refused(parts, "thickness")
    parts.balloon.Film = film
    parts.balloon.Document.recompute()
    assert [obj.Status for obj in parts] == [status.READY] * 3


def test_broken_sketch_is_told_once_down_the_line(parts):
    before = measures(parts.balloon)
    parts.outline.Source[0].delGeometry(0)
    parts.balloon.Document.recompute()
    refused(parts, "Outline is not ready", "open")
    assert parts.pattern.Status.count("is not ready") == 1
    assert measures(parts.balloon) == before


def test_failed_solve_keeps_the_last_mesh(parts, monkeypatch):
    def solve(self, progress=None):
        raise SolverError("The film folds. Use a finer mesh.")

    before = measures(parts.balloon)
    monkeypatch.setattr(Request, "solve", solve)
    parts.balloon.Pressure = 3
    parts.balloon.Document.recompute()
    refused(parts, "The film folds")
    assert measures(parts.balloon) == before


def test_unconverged_solve_is_shown_and_marked(parts, monkeypatch):
    solve = Request.design

    def stop_early(self, progress=None):
        design = solve(self)
        report = replace(design.inflation.report, converged=False)
        return replace(design, inflation=replace(design.inflation, report=report))

    monkeypatch.setattr(Request, "design", stop_early)
    parts.balloon.Pressure = 3
    parts.balloon.Document.recompute()
    assert parts.balloon.Status.startswith(status.UNSURE)
    assert not parts.balloon.Converged
    assert parts.balloon.Mesh.isSolid()
    assert parts.pattern.Status == status.READY


def test_stopped_solve_keeps_the_last_mesh(parts, monkeypatch):
    def impatient(title, job):
        return job(lambda fraction, text: False)

    before = measures(parts.balloon)
    monkeypatch.setattr(hooks, "run_blocking", impatient)
    parts.balloon.Pressure = 3
    parts.balloon.Document.recompute()
    refused(parts)
    assert measures(parts.balloon) == before


def test_undo_takes_values_and_mesh_back_together(parts, monkeypatch):
    doc = parts.balloon.Document
    doc.commitTransaction()
    before, label = measures(parts.balloon), parts.balloon.SolvedFor
    doc.openTransaction("thicker")
    parts.balloon.Pressure = 4
    doc.recompute()
    doc.commitTransaction()
    after = measures(parts.balloon)
    assert after != before
    doc.undo()
    assert measures(parts.balloon) == before
    assert parts.balloon.SolvedFor == label
    doc.redo()
    assert measures(parts.balloon) == after
    doc.undo()
    doc.recompute()


def test_balloon_without_outline_says_so(doc):
    parts = create.make(doc)
    parts.balloon.Outline = None
    doc.recompute()
    assert parts.balloon.Status == status.EMPTY + "Choose the outline to inflate."
    assert parts.pattern.Status.startswith(status.EMPTY)


def test_solver_that_is_not_there(parts, monkeypatch):
    from BalloonWorkbench.core.solver import backend

    numpy_alone = backend.available()[-1:]
    monkeypatch.setattr(backend, "available", lambda: numpy_alone)
    parts.balloon.Backend = "Native"
    parts.balloon.Document.recompute()
    refused(parts, "native")


def test_solver_is_named(parts):
    parts.balloon.Backend = "NumPy"
    parts.balloon.Document.recompute()
    assert parts.balloon.Status == status.READY
    assert parts.balloon.ActiveBackend == "numpy"

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Variants of a balloon in a document: their spreadsheet, and what processes beside FreeCAD make of it."""

import json
from pathlib import Path

import FreeCAD as App
import pytest
import sketches

import BalloonWorkbench
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.document.parts import parts_of
from BalloonWorkbench.app.studies import study as studies
from BalloonWorkbench.app.studies import study_table
from BalloonWorkbench.core.errors import Cancelled, InputError
from BalloonWorkbench.core.studies.run import run_study

ROUND = {"unit": "mm", "outer": [[0, 0], [200, 0], [200, 160], [0, 160]]}


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """A small balloon, inflated as it is."""
    document = App.newDocument("Studied")
    drawing = tmp_path_factory.mktemp("drawing") / "pillow.json"
    drawing.write_text(json.dumps(ROUND))
    yield BalloonWorkbench.from_picture(document, drawing, mesh_size="20 mm", mode="Inflate as drawn")
    App.closeDocument(document.Name)


@pytest.fixture
def parts(made):
    """The same for each test, which leaves nothing behind."""
    document = made.balloon.Document
    before = {obj.Name for obj in document.Objects}
    yield made
    for name in [obj.Name for obj in document.Objects if obj.Name not in before][::-1]:
        document.removeObject(name)


def study_of(parts, columns, folder):
    obj = studies.make(parts.balloon.Document, parts, variants=columns)
    obj.Folder = str(folder)
    parts.balloon.Document.recompute()
    return obj


def work_out(obj):
    """All rows; what is known of them by the number of their row."""
    table = studies.read(obj)
    study = studies.core_study(obj, table)
    outcome = run_study(study, studies.folder(obj), studies.runner(obj))
    found = studies.known(table, studies.jobs_of(table, study), studies.folder(obj))
    studies.keep_results(obj, table, found)
    obj.Document.recompute()
    return outcome, found


@pytest.mark.slow
def test_rows_are_the_balloons_of_the_document(parts, tmp_path):
    """Each is what the document itself gives with these values, and a second run makes nothing."""
    obj = study_of(parts, {"Width": ["200 mm", "300 mm"], "pressure": ["1 kPa", "3000 Pa"]}, tmp_path)
    assert (obj.Rows, obj.Status) == (4, status.READY)
    outcome, found = work_out(obj)
    assert (outcome.made, outcome.failures) == (4, {})
    assert (obj.Finished, obj.Failed) == (4, 0)
    assert [found[row]["pressure_Pa"] for row in (2, 3, 4, 5)] == [1000.0, 3000.0] * 2
    sheet = obj.Table
    volumes = [sheet.get(f"C{row}") for row in (2, 3, 4, 5)]
    assert [float(f"{found[row]['volume_m3']:.6g}") for row in (2, 3, 4, 5)] == pytest.approx(volumes)
    document = parts.balloon.Document
    width, pressure = parts.outline.Width, parts.balloon.Pressure
    studies.take_row(obj, studies.read(obj), 5)
    document.recompute()
    assert parts.balloon.Volume.Value * 1e-9 == pytest.approx(volumes[3], rel=1e-5)
    parts.outline.Width, parts.balloon.Pressure = width, pressure
    document.recompute()
    again, _ = work_out(obj)
    assert again.made == 0
    assert volumes[2] / volumes[0] == pytest.approx(1.5**3, rel=0.05), "film hardly stretches"


def test_the_same_rows_have_the_same_bytes(parts, tmp_path):
    kept = []
    for place in (tmp_path / "one", tmp_path / "two"):
        work_out(study_of(parts, {"Width": ["210 mm"]}, place))
        kept.append({path.name: path.read_bytes() for path in place.glob("balloons/*/*/*")})
    assert kept[0] == kept[1]
    assert set(kept[0]) == {"report.json", "balloon.stl"}


@pytest.mark.parametrize(
    ("heading", "cell", "sentence"),
    [
        ("Width", "12 kPa", "another unit"),
        ("Width", "=12 mm * 3 mm", "another unit"),
        ("Pressure", "2", "needs a unit"),
        ("Pressure", "50 mm", "another unit"),
        ("Width", "wide", "no value for Width"),
        ("WeldRigidity", "3 mm", "without a unit"),
        ("Copies", "1.5", "no whole number"),
        ("Material", "steel", "no Material"),
        ("Intake", "perhaps", "neither yes nor no"),
    ],
)
def test_a_row_that_makes_no_sense_is_told(parts, tmp_path, heading, cell, sentence):
    """The others are worked out all the same."""
    obj = study_of(parts, {heading: [cell], "MeshSize": ["25 mm"]}, tmp_path)
    table = studies.read(obj)
    assert sentence in table.rows[2]
    with pytest.raises(InputError, match="makes sense"):
        studies.core_study(obj, table)


@pytest.mark.parametrize(
    ("columns", "sentence"),
    [
        ({"Widh": ["1 mm"]}, "the nearest are"),
        ({"Volume": ["1 l"]}, "nothing that is called"),
        ({"Width": ["1 mm"], "width": ["2 mm"]}, "two columns"),
        ({"Drawing": ["a.png"]}, "cannot be varied"),
    ],
)
def test_headings_that_mean_nothing(parts, tmp_path, columns, sentence):
    obj = study_of(parts, columns, tmp_path)
    assert sentence in obj.Status
    with pytest.raises(InputError, match=sentence):
        studies.read(obj)


def test_a_failure_is_a_row_with_its_sentence(parts, tmp_path):
    obj = study_of(parts, {"Width": ["0.01 mm", "200 mm"], "Height": ["0 mm"]}, tmp_path)
    obj.Table.set("J1", "failure")
    outcome, found = work_out(obj)
    assert len(outcome.failures) == 1
    assert found[2]["failure"]
    assert found[3]["volume_m3"] > 0.0
    assert (obj.Finished, obj.Failed) == (2, 1)


@pytest.mark.parametrize(
    ("heading", "value"), [("Width", "-200 mm"), ("WeldRigidity", "1e9"), ("Copies", "-3")]
)
def test_what_freecad_would_change_silently_is_told(parts, tmp_path, heading, value):
    """It makes 0, which is the usual size, of a negative length."""
    obj = study_of(parts, {heading: [value]}, tmp_path)
    _, known = work_out(obj)
    assert known[2]["failure"], known


def test_errors_of_cells_are_one_line(parts, tmp_path):
    obj = study_of(parts, {"Width": ["=1/0", "200 mm"]}, tmp_path)
    table = studies.read(obj)
    assert "division by zero" in table.rows[2]
    assert "\n" not in table.rows[2]


def test_named_cells_drive_a_sketch(parts, tmp_path):
    """What an expression follows cannot be varied itself; the named cell that it is made of can."""
    document = parts.balloon.Document
    sheet = document.addObject("Spreadsheet::Sheet", "Sizes")
    sheet.set("A1", "=180 mm")
    sheet.setAlias("A1", "wide")
    document.recompute()
    parts.outline.setExpression("Width", "Sizes.wide")
    document.recompute()
    try:
        obj = study_of(parts, {"Width": ["1 mm"]}, tmp_path)
        assert "follows the expression" in obj.Status
        obj = study_of(parts, {"Sizes.wide": ["=200 mm", "=240 mm"]}, tmp_path)
        _, found = work_out(obj)
        assert found[3]["volume_m3"] / found[2]["volume_m3"] == pytest.approx(1.2**3, rel=0.02)
    finally:
        parts.outline.setExpression("Width", None)
        parts.outline.Width = 0
        document.recompute()


def test_variables_are_columns(parts, tmp_path):
    document = parts.balloon.Document
    try:
        variables = document.addObject("App::VarSet", "Variables")
    except TypeError:
        pytest.skip("this FreeCAD has no VarSet")
    variables.addProperty("App::PropertyLength", "wide")
    variables.wide = "190 mm"
    parts.outline.setExpression("Width", "Variables.wide")
    document.recompute()
    try:
        obj = studies.make(document, parts, variables=variables)
        obj.Folder = str(tmp_path)
        study_table.cross(obj.Table, studies.read(obj), "A", ["200 mm", "220 mm"])
        obj.Table.recompute()
        _, found = work_out(obj)
        assert found[3]["volume_m3"] > found[2]["volume_m3"] > 0.0
    finally:
        parts.outline.setExpression("Width", None)
        parts.outline.Width = 0
        document.recompute()


def test_a_new_table_offers_what_has_an_effect(parts):
    """A sketch has its own width."""
    document = parts.balloon.Document
    obj = studies.make(document, parts)
    assert [each.heading for each in studies.read(obj).inputs.values()] == ["Width", "Pressure"]
    drawn = create.balloon_from_sketch(
        document, sketches.rectangle(document, 120, 80), mesh_size=20, correct=False
    )
    obj = studies.make(document, drawn)
    assert [each.heading for each in studies.read(obj).inputs.values()] == ["Pressure"]


def test_labels_of_any_script_are_told_apart(parts, tmp_path):
    """Of two spreadsheets with Japanese labels the one that is named is varied."""
    document, made = parts.balloon.Document, []
    for label, alias in (("寸法", "w"), ("圧力", "w")):
        sheet = document.addObject("Spreadsheet::Sheet", "Named")
        sheet.Label = label
        sheet.set("A1", "=180 mm")
        sheet.setAlias("A1", alias)
        made.append(sheet)
    document.recompute()
    obj = study_of(parts, {"圧力.w": ["=200 mm"]}, tmp_path)
    assert [each.obj for each in studies.read(obj).inputs.values()] == made[1:]
    obj = study_of(parts, {"幅": ["200 mm"]}, tmp_path)
    assert "nothing that is called" in obj.Status


def test_another_document_is_another_balloon(parts, tmp_path):
    """Rows are those of the document as it is; what a row gives itself, and results, do not count."""
    obj = study_of(parts, {"Width": ["200 mm"]}, tmp_path)

    def key():
        table = studies.read(obj)
        return studies.jobs_of(table, studies.core_study(obj, table))[2].key

    first = key()
    assert key() == first
    parts.outline.Width = 205
    parts.balloon.Document.recompute()
    assert key() == first
    parts.balloon.Pressure = 1.7
    parts.balloon.Document.recompute()
    assert key() != first
    other = key()
    for width in range(10):
        parts.balloon.Pressure = 2 + 0.1 * width
        last = key()
    copies = list(tmp_path.rglob("*.FCStd"))
    assert len(copies) == 8, "copies of documents that are no more are removed"
    parts.balloon.Pressure = 1.7
    parts.balloon.Document.recompute()
    parts.balloon.Document.Comment = "its copy is written anew and has other bytes"
    assert key() == other != last


def test_a_study_is_stopped_within_a_second(parts, tmp_path):
    obj = study_of(parts, {"Width": ["200 mm"], "MeshSize": ["1.2 mm"]}, tmp_path)
    study = studies.core_study(obj, studies.read(obj))
    with pytest.raises(Cancelled):
        run_study(study, tmp_path, studies.runner(obj, lambda: True))
    assert not list(Path(tmp_path).glob("balloons/*/*/report.json"))


def test_it_is_saved_with_the_document(parts, tmp_path):
    obj = study_of(parts, {"Width": ["200 mm"]}, tmp_path)
    name = obj.Name
    path = tmp_path / "saved.FCStd"
    parts.balloon.Document.saveCopy(str(path))
    opened = App.openDocument(str(path), True)
    try:
        again = opened.getObject(name)
        assert type(again.Proxy) is studies.StudyProxy
        assert again.Rows == 1
        assert parts_of(again.Balloon) is not None
    finally:
        App.closeDocument(opened.Name)


def test_rows_are_known_when_the_document_is_opened_again(tmp_path):
    """That of a sketch, too: what FreeCAD sees to in it while opening makes no other balloon of it."""
    doc = App.newDocument("Kept")
    made = create.balloon_from_sketch(doc, sketches.rectangle(doc), mesh_size=20, correct=False)
    obj = study_of(made, {"Pressure": ["2 kPa"]}, tmp_path / "rows")
    work_out(obj)
    path, name = str(tmp_path / "kept.FCStd"), obj.Name
    doc.saveAs(path)
    App.closeDocument(doc.Name)
    opened = App.openDocument(path, True)
    try:
        again = opened.getObject(name)
        table = studies.read(again)
        jobs = studies.jobs_of(table, studies.core_study(again, table))
        assert all(studies.known(table, jobs, tmp_path / "rows").values())
    finally:
        App.closeDocument(opened.Name)


@pytest.mark.slow
def test_from_a_macro(parts):
    obj = BalloonWorkbench.study(parts, {"Width": ["200 mm"], "MeshSize": ["30 mm"]}, jobs=1)
    assert (obj.Finished, obj.Failed) == (1, 0)
    assert obj.Table.get("C2") > 0.0
    rows = [{"Width": "200 mm", "MeshSize": "30 mm"}, {"MeshSize": "25 mm"}]
    again = BalloonWorkbench.study(parts, rows)
    assert (again.Finished, again.Failed, again.Table.get("C2")) == (2, 0, obj.Table.get("C2"))
    made_of = studies.variants_of(again, studies.read(again))
    assert [list(values) for values in made_of] == [["Width", "MeshSize"], ["MeshSize"]]

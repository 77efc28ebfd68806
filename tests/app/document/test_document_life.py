# SPDX-License-Identifier: LGPL-2.1-or-later
"""What users do to documents: save elsewhere, copy, delete what is linked, open two, undo all of it."""

import shutil
from pathlib import Path

import FreeCAD as App
import pytest
import sketches

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.engine.export import export_pattern
from BalloonWorkbench.core.errors import ExportError

KEPT = Path("tests/resources/documents/0.1.0-freecad-0.20.FCStd")
PARTS = ("Outline", "Balloon", "Pattern")
ODD = "Größe & Maß, 風船 ☺"


@pytest.fixture
def kept(tmp_path):
    """A document of its own for each test: nothing is solved to have it."""
    path = tmp_path / "kept.FCStd"
    shutil.copy(KEPT, path)
    document = App.openDocument(str(path))
    document.UndoMode = 1
    name = document.Name
    yield document
    if name in App.listDocuments():
        App.closeDocument(name)


def parts(document):
    return [document.getObject(name) for name in PARTS]


def statuses(document):
    return [obj.Status for obj in parts(document)]


def test_letters_of_all_kinds_and_spaces_in_paths(kept, tmp_path):
    folder = tmp_path / ODD / "mein Ballon"
    folder.mkdir(parents=True)
    kept.saveAs(str(folder / f"{ODD}.FCStd"))
    App.closeDocument(kept.Name)
    document = App.openDocument(str(folder / f"{ODD}.FCStd"))
    try:
        assert document.Label == ODD
        assert statuses(document) == [status.READY] * 3
        written = export_pattern(document.Pattern, str(folder / f"{ODD}.svg"))
        assert Path(written).stat().st_size > 500
    finally:
        App.closeDocument(document.Name)


def test_drawing_from_an_odd_path_travels_with_a_copy_of_the_document(doc, tmp_path):
    folder = tmp_path / ODD
    folder.mkdir()
    shutil.copy("resources/examples/pictures/heart.png", folder / f"{ODD}.png")
    made = create.balloon_from_picture(
        doc, str(folder / f"{ODD}.png"), width=90, mesh_size=15, correct=False, pressure="1 kPa"
    )
    for name in ("first.FCStd", "second.FCStd"):
        doc.saveAs(str(tmp_path / name))
    shutil.rmtree(folder)
    (tmp_path / "first.FCStd").unlink()
    made.outline.Width = 100
    doc.recompute()
    assert made.outline.SizeX.Value == pytest.approx(100, abs=1)
    assert [obj.Status for obj in made] == [status.READY] * 3


def test_copy_is_alive_and_on_its_own(kept):
    copies = kept.copyObject(parts(kept), True)
    outline, balloon, pattern = (
        next(obj for obj in copies if type(getattr(obj, "Proxy", None)).__name__ == f"{name}Proxy")
        for name in PARTS
    )
    assert balloon.Outline == outline
    assert pattern.Balloon == balloon
    kept.recompute()
    before = kept.Pattern.PatternWidth.Value
    pattern.Allowance = 9
    kept.recompute()
    assert [obj.Status for obj in (outline, balloon, pattern)] == [status.READY] * 3
    assert before + 6 < pattern.PatternWidth.Value < before + 13
    assert kept.Pattern.PatternWidth.Value == before


def test_copy_into_another_document(kept, doc):
    doc.copyObject(parts(kept), True)
    App.closeDocument(kept.Name)
    doc.recompute()
    assert statuses(doc) == [status.READY] * 3
    doc.Pattern.Allowance = 9
    doc.recompute()
    assert doc.Pattern.Status == status.READY


def test_two_open_documents_do_not_meet(kept, tmp_path):
    shutil.copy(KEPT, tmp_path / "other.FCStd")
    other = App.openDocument(str(tmp_path / "other.FCStd"))
    other.recompute()  # FreeCAD 1.0 does so anyway, and an older pattern changes a little
    before = other.Pattern.PatternWidth.Value
    kept.Pattern.Allowance = 9
    kept.recompute()
    other.recompute()
    assert other.Pattern.PatternWidth.Value == pytest.approx(before)
    App.closeDocument(kept.Name)
    other.Pattern.Allowance = 4
    other.recompute()
    assert statuses(other) == [status.READY] * 3
    App.closeDocument(other.Name)


class Watch:
    """Remembers what FreeCAD has computed."""

    def __init__(self):
        self.order = []

    def slotRecomputedObject(self, obj):  # noqa: N802
        self.order.append(obj.Name)


def test_objects_are_computed_in_their_order_and_once(kept):
    watch = Watch()
    App.addDocumentObserver(watch)
    try:
        kept.Rectangle.setDatum("Width", App.Units.Quantity("110 mm"))
        kept.recompute()
    finally:
        App.removeDocumentObserver(watch)
    assert [name for name in watch.order if name in PARTS] == list(PARTS)


def test_deleted_sketch_is_told_and_what_is_there_stays(kept):
    area = kept.Outline.Shape.Area
    kept.openTransaction("delete")
    kept.removeObject("Rectangle")
    kept.commitTransaction()
    kept.recompute()
    assert kept.Outline.Status == "stale: Choose a picture or a sketch."
    assert kept.Balloon.Status.endswith("Choose a picture or a sketch.")
    assert kept.Pattern.Status.endswith("Choose a picture or a sketch.")
    assert kept.Outline.Shape.Area == area
    kept.undo()
    kept.recompute()
    assert statuses(kept) == [status.READY] * 3
    kept.removeObject("Rectangle")
    kept.Outline.Source = (sketches.rectangle(kept, 100, 70), [])
    kept.recompute()
    assert statuses(kept) == [status.READY] * 3


@pytest.mark.parametrize(
    ("gone", "left", "advice"),
    [("Outline", "Balloon", "Choose the outline"), ("Balloon", "Pattern", "Choose the balloon")],
)
def test_broken_link_is_told(kept, gone, left, advice):
    kept.removeObject(gone)
    kept.getObject(left).touch()
    kept.recompute()
    assert advice in kept.getObject(left).Status
    assert kept.Pattern.Shape.Length > 100


def test_document_in_a_folder_that_cannot_be_written(kept, tmp_path):
    """It opens and is computed; writing beside it says what to do."""
    kept.Pattern.Allowance = 9
    kept.recompute()
    assert statuses(kept) == [status.READY] * 3
    blocked = tmp_path / "file"
    blocked.write_text("no folder")
    for folder in (blocked, Path("/proc/self/fdinfo")):
        with pytest.raises(ExportError) as told:
            export_pattern(kept.Pattern, str(folder / "pattern.svg"))
        assert len(str(told.value)) > 30


def test_undo_takes_back_everything_and_redo_brings_it_again(doc):
    sketch = sketches.rectangle(doc, 90, 60)
    doc.clearUndos()
    steps = []

    def step(name, work):
        doc.openTransaction(name)
        work()
        doc.recompute()
        doc.commitTransaction()
        steps.append(name)

    step("make", lambda: create.balloon_from_sketch(doc, sketch, mesh_size=14, correct=False))
    step("pressure", lambda: setattr(doc.Balloon, "Pressure", 1.0))
    step("notches", lambda: setattr(doc.Pattern, "Notches", 4))
    step("sketch", lambda: sketch.setDatum("Width", App.Units.Quantity("80 mm")))
    step(
        "delete",
        lambda: [doc.removeObject(name) for name in ("Pattern", "Balloon", "Outline", "BalloonGroup")],
    )
    assert doc.UndoNames == list(reversed(steps))
    for _ in steps:
        doc.undo()
        doc.recompute()
    assert [obj.Name for obj in doc.Objects] == ["Rectangle"]
    for _ in steps[:-1]:
        doc.redo()
        doc.recompute()
    assert statuses(doc) == [status.READY] * 3
    assert doc.Outline.SizeX.Value == pytest.approx(80)
    assert doc.Pattern.Notches == 4
    doc.redo()
    assert [obj.Name for obj in doc.Objects] == ["Rectangle"]

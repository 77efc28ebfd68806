# SPDX-License-Identifier: LGPL-2.1-or-later
"""Artwork, sheets of film, the maker's numbers and the assembly sheet of balloons in a document."""

import json
from pathlib import Path

import FreeCAD as App
import numpy as np
import pytest
import sketches

import BalloonWorkbench
from BalloonWorkbench.app import artwork, film_sheet
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import create, kinds
from BalloonWorkbench.app.engine import maker
from BalloonWorkbench.app.engine.export import check_for, export_for
from BalloonWorkbench.app.properties import film as film_values
from BalloonWorkbench.core.errors import ExportError, InputError
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.machines.own.keep import machine_data
from BalloonWorkbench.core.nesting import nest as nesting

HEART = Path("resources/examples/pictures/heart.png").resolve()


@pytest.fixture(scope="module")
def solved():
    """A balloon from a sketch, uncorrected: quick."""
    document = App.newDocument("Making")
    name = document.Name
    document.UndoMode = 1
    yield create.balloon_from_sketch(
        document, sketches.rectangle(document, 120, 80), mesh_size=12, correct=False
    )
    App.closeDocument(name)


@pytest.fixture
def rows(monkeypatch):
    """Laid out in rows: quick, and the same wherever the tests run."""
    monkeypatch.setattr(nesting, "PACKAGE", "no_such_package")


def test_artwork_needs_a_picture(parts, picture, tmp_path):
    """A sketch has none of its own; a chosen one is kept in the document and reads right on both sides."""
    doc = parts.balloon.Document
    art = artwork.make(parts.pattern)
    doc.recompute()
    assert "no picture" in art.Status
    with pytest.raises(ExportError, match="no picture"):
        artwork.write(art, tmp_path)
    art.Picture, art.Resolution = str(picture), 50.0
    doc.recompute()
    assert art.Status == status.READY
    assert {"CUT", "PRINT", "REGISTRATION"} <= set(art.Roles)
    assert art in parts.pattern.getParentGroup().Group
    front, back = artwork.sheets(art)
    blue = front.pixels[..., 2] > 150
    red = front.pixels[..., 0] > 150
    assert np.argwhere(blue)[:, 1].mean() < np.argwhere(red)[:, 1].mean()
    assert np.array_equal(back.pixels, front.pixels[:, ::-1])
    written = artwork.write(art, tmp_path / "prints", ["cutting-shop", "inkscape"])
    assert {path.name for path in written} - {"artwork.pdf"} == {
        "artwork-front.png", "artwork-back.png",
        "print-front-pattern-cutting-shop_mm.dxf", "print-back-pattern-cutting-shop_mm.dxf",
        "print-front-pattern-inkscape.svg", "print-back-pattern-inkscape.svg",
    }  # fmt: skip
    assert artwork.of_balloon(parts.balloon) == art


def test_artwork_follows_its_pattern_and_has_a_side(parts, picture, tmp_path):
    doc = parts.balloon.Document
    art = artwork.make(parts.pattern, picture, picture)
    doc.recompute()
    for allowance, bleed in ((2.0, 3.0), (5.0, 8.0)):
        parts.pattern.Allowance, art.Bleed = allowance, bleed
        doc.recompute()
        marks = 2.0 * (bleed + 8.0 + 5.0)  # bleed, room, half a cross on both sides
        assert art.PatternWidth.Value == pytest.approx(parts.pattern.PatternWidth.Value + marks, abs=0.02)
    front = export_for(art, "any-svg", tmp_path / "front.svg").read_text(encoding="utf-8")
    low = art.Shape.BoundBox.XMin
    art.Side = artwork.BACK
    doc.recompute()
    assert export_for(art, "any-svg", tmp_path / "back.svg").read_text(encoding="utf-8") != front
    assert art.Shape.BoundBox.XMin != pytest.approx(low)
    front, back = artwork.sheets(art, 30.0)
    assert not np.array_equal(back.pixels, front.pixels[:, ::-1])  # the back has its own picture
    art.Bleed = 80.0
    doc.recompute()
    assert "bleed" in art.Status


def test_artwork_has_the_marks_of_the_chosen_machine(parts, picture, tmp_path):
    """On paper of its size, on both sides, in the cut file on its layer; another machine is told; one that is
    none, and a print that is too large, are a sentence each."""
    doc = parts.balloon.Document
    art = artwork.make(parts.pattern, picture)
    art.Resolution, art.MarksFor = 50.0, "silhouette-inkscape"
    doc.recompute()
    assert art.Status == status.READY
    assert art.Roles.count("REGISTRATION") == 3
    front, back = artwork.sheets(art)
    for sheet in (front, back):
        height, width = sheet.pixels.shape[:2]
        assert (width, height) == pytest.approx((210 * 50 / 25.4, 297 * 50 / 25.4), abs=1)
        square = sheet.pixels[round(11 * 50 / 25.4) : round(14 * 50 / 25.4), round(11 * 50 / 25.4) : 27]
        assert (square == (0, 0, 0, 255)).all()
    written = {path.name: path for path in artwork.write(art, tmp_path / "prints")}
    assert "print-front-pattern-silhouette-inkscape.svg" in written
    text = written["print-back-pattern-silhouette-inkscape.svg"].read_text(encoding="utf-8")
    assert 'width="210mm" height="297mm"' in text
    assert 'id="Regmarks"' in text
    assert export_for(art, "silhouette-inkscape", tmp_path).read_text(encoding="utf-8").count("<path") > 3
    assert not [each for each in check_for(art, "silhouette-inkscape") if "looks for others" in each.text]
    (told,) = [each for each in check_for(art, "roland") if "looks for others" in each.text]
    assert told.text.startswith("The print has the marks of Silhouette from Inkscape, and Roland")
    art.MarksFor = "print-and-cut-pdf"
    doc.recompute()
    names = {path.name for path in artwork.write(art, tmp_path / "shop")}
    assert {"artwork-print-and-cut-pdf.pdf"} <= names
    assert not {name for name in names if name.startswith("print-") and name.endswith(".pdf")}
    art.MarksFor = "oracle"
    doc.recompute()
    assert "no machine" in art.Status
    art.Bleed, art.MarksFor = 50.0, "cricut"
    doc.recompute()
    assert "takes at most 171 x 235 mm" in art.Status
    art.MarksFor = ""
    doc.recompute()
    assert art.Status == status.READY
    assert art.Roles.count("REGISTRATION") == 9


def test_a_traced_picture_is_its_own_artwork(doc):
    """No picture chosen: what was drawn is printed, in its place, without the paper around it."""
    parts = create.balloon_from_picture(doc, HEART, width=100, mesh_size=12, correct=False)
    art = artwork.make(parts.pattern)
    doc.recompute()
    assert art.Status == status.READY
    front, _ = artwork.sheets(art, 40.0)
    inked = front.pixels[front.pixels[..., 3] == 255]
    red = (inked[:, 0] > 120) & (inked[:, 2] < 120)
    assert red.mean() > 0.9


def test_film_sheet(parts, rows, tmp_path):
    """Roll and sheets; used part, pieces and lines; every machine may have it; the layout is kept."""
    doc = parts.balloon.Document
    sheet = film_sheet.make(doc, [parts.pattern])
    sheet.Balloons, sheet.FilmWidth = 3, 300.0
    doc.recompute()
    assert sheet.Status == status.READY
    assert sheet.Pieces == 6
    assert sheet.Roles.count("CUT") == 6
    assert "spyrrow" in sheet.Warnings[0]
    area = 6.0 * parts.pattern.Shape.Faces[0].Area
    assert sheet.Used == pytest.approx(100.0 * area / (300.0 * sheet.UsedLength.Value), rel=1e-3)
    box = sheet.Shape.BoundBox
    assert (box.XLength, box.YLength) == pytest.approx((sheet.UsedLength.Value, 300.0), abs=1e-4)
    assert {finding.severity for finding in check_for(sheet, "hpgl-plotter")} <= {"warning"}
    assert export_for(sheet, "any-dxf", tmp_path).stat().st_size > 1000
    sheet.FilmLength = 1.5 * parts.pattern.PatternWidth.Value
    doc.recompute()
    assert sheet.Sheets > 1
    assert sheet.UsedLength.Value == pytest.approx(sheet.FilmLength.Value)
    first = sheet.Pieces
    sheet.Shown = sheet.Sheets
    doc.recompute()
    assert sheet.Status == status.READY
    assert first * (sheet.Sheets - 1) + sheet.Pieces >= 6
    sheet.Shown = 40
    doc.recompute()
    assert "no sheet 40" in sheet.Status
    sheet.Shown, sheet.FilmWidth = 1, 60.0
    doc.recompute()
    assert "does not fit" in sheet.Status


def test_layout_is_kept_and_made_anew_only_for_a_reason(parts, rows, monkeypatch):
    doc = parts.balloon.Document
    sheet = film_sheet.make(doc, [parts.pattern])
    doc.recompute()
    kept = sheet.Layouts
    monkeypatch.setattr(nesting, "nest", lambda *values: pytest.fail("laid out again"))
    sheet.touch()
    doc.recompute()
    assert sheet.Layouts == kept
    monkeypatch.undo()
    monkeypatch.setattr(nesting, "PACKAGE", "no_such_package")
    parts.pattern.Allowance = 4.0
    doc.recompute()
    assert sheet.Status == status.READY
    assert sheet.Layouts != kept


def test_numbers(parts):
    """The same weight and lift as the balloon's own properties, which know of no valve."""
    found = maker.numbers(parts)
    assert 1e3 * found.weight == pytest.approx(parts.balloon.Weight, rel=1e-6)
    assert 1e3 * found.floating[0].left == pytest.approx(parts.balloon.Lift, rel=1e-6)
    assert found.floating[0].from_width == pytest.approx(
        1e-3 * parts.balloon.FloatsFrom.Value * 120.0 / parts.balloon.InflatedWidth.Value, rel=0.02
    )
    assert maker.numbers(parts) is found
    parts.balloon.Film = "nylon-foil"
    parts.pattern.IntakeKind = "Self-sealing film valve"
    parts.balloon.Document.recompute()
    assert maker.numbers(parts).valve > 0.0
    parts.balloon.Gas = "Hydrogen"
    assert maker.numbers(parts).floating[0].gas == "hydrogen"


def test_assembly_sheet(parts, tmp_path):
    written = maker.write_assembly(parts, tmp_path)
    assert written.name == "assembly.pdf"
    assert written.read_bytes().startswith(b"%PDF")
    parts.pattern.Allowance, parts.pattern.TieTab = 0.1, True
    parts.pattern.Notches = 900
    parts.balloon.Document.recompute()
    with pytest.raises(ExportError, match="not up to date"):
        maker.write_assembly(parts, tmp_path)


def test_assembly_sheet_has_the_settings_of_the_machine(parts, tmp_path, monkeypatch):
    """Those of a machine of the user's own; of others, and without one, nothing is told."""
    from BalloonWorkbench.core.assembly_sheet import page

    told = []

    def heard(subject, *_given):
        told.append(subject.settings)
        return b"%PDF"

    monkeypatch.setattr(page, "assembly_pdf", heard)
    own = {**machine_data("gcode-marlin"), "name": "tip-pe", "title": "Tip"}
    own["tool"] = {**own["tool"], "feed_mm_min": 200, "temperature_C": 250, "depth_mm": 0.2}
    (tmp_path / "tip-pe.json").write_text(json.dumps(own), encoding="utf-8")
    monkeypatch.setenv("BALLOON_MACHINES", str(tmp_path))
    assert [maker.told_of(name) for name in ("tip-pe", "gcode-marlin", "any-dxf")] == ["tip-pe", None, None]
    for name in ("tip-pe", None):
        maker.write_assembly(parts, tmp_path / "sheet.pdf", machine=name)
    assert [each.weld for each in told] == ["feed 200 mm/min, temperature 250C, depth 0.2 mm", ""]
    with pytest.raises(InputError, match='There is no machine "gone"'):
        maker.write_assembly(parts, tmp_path / "sheet.pdf", machine="gone")


def test_film_of_the_library_keeps_its_start_values(parts):
    """With the object's own numbers, and not among what a result is saved with."""
    parts.balloon.Film = "pe"
    assert film_values.read(parts.balloon).start_values == film("pe").start_values
    assert "start_values" not in parts.balloon.SolvedWith
    parts.balloon.Film = film_values.CUSTOM
    assert not film_values.read(parts.balloon).start_values.is_known


def test_saved_and_opened(parts, rows, picture, tmp_path):
    """All of it comes back as it was, and follows again."""
    doc = parts.balloon.Document
    artwork.make(parts.pattern, picture)
    film_sheet.make(doc, [parts.pattern])
    doc.recompute()
    doc.saveCopy(str(tmp_path / "making.FCStd"))
    again = App.openDocument(str(tmp_path / "making.FCStd"))
    try:
        art = next(obj for obj in again.Objects if kinds.is_artwork(obj))
        sheet = next(obj for obj in again.Objects if kinds.is_film_sheet(obj))
        assert Path(art.Picture).read_bytes() == picture.read_bytes()
        assert json.loads(sheet.Layouts)
        art.Pattern.Allowance = 3.0
        again.recompute()
        assert art.Status == sheet.Status == status.READY
    finally:
        App.closeDocument(again.Name)


def test_a_file_is_taken_away_again(parts, picture):
    """FreeCAD itself keeps a file where an empty path is set."""
    art = BalloonWorkbench.artwork(parts.pattern, back_picture=str(picture))
    assert art.BackPicture.endswith(picture.name)
    BalloonWorkbench.artwork(parts.pattern, back_picture="")
    assert art.BackPicture == ""
    assert "BackPicture" in art.PropertiesList


def test_what_is_left_is_film_again(parts, rows, tmp_path):
    """A sheet's remnant takes the next balloon, with its edge in the shape; saved with the document."""
    first = BalloonWorkbench.nest([parts.pattern], film_width="800 mm", film_length="900 mm")
    kept = BalloonWorkbench.keep_remnant(first, tmp_path)
    sheet = BalloonWorkbench.nest([parts.pattern], film_width="800 mm", remnant=kept)
    assert (sheet.Status, sheet.Sheets, sheet.Pieces) == (status.READY, 1, 2)
    kept.unlink()  # the document has it
    assert sheet.UsedLength.Value <= 900.0
    assert sheet.Shape.BoundBox.YLength <= 800.0 + 1e-6
    assert sheet.Roles.count("") >= 1
    assert export_for(sheet, "any-dxf", tmp_path).stat().st_size > 1000
    sheet = BalloonWorkbench.nest([parts.pattern], sheet, remnant="")
    assert (sheet.Remnant, sheet.Status) == ("", status.READY)
    assert sheet.Shape.BoundBox.YLength == pytest.approx(800.0)


def test_the_valve_is_on_another_film(parts, rows, tmp_path):
    """Panels on one sheet of film, strips on another; two files for a pattern, one for each sheet."""
    parts.balloon.Film = "nylon-foil"
    parts.pattern.IntakeKind = "Self-sealing film valve"
    doc = parts.balloon.Document
    foil, valve = film_sheet.make(doc, [parts.pattern]), film_sheet.make(doc, [parts.pattern])
    valve.Film = "Valve film"
    foil.Balloons = valve.Balloons = 2
    doc.recompute()
    assert (foil.Status, valve.Status) == (status.READY, status.READY)
    assert (foil.Pieces, valve.Pieces) == (4, 4)
    assert any("Valve film" in text for text in foil.Warnings)
    assert not any("Valve film" in text for text in valve.Warnings)
    (tmp_path / "one").mkdir()
    export_for(parts.pattern, "any-dxf", tmp_path / "one" / "fish.dxf")
    assert sorted(path.name for path in (tmp_path / "one").iterdir()) == ["fish-valve.dxf", "fish.dxf"]
    (tmp_path / "two").mkdir()
    for sheet in (foil, valve):
        export_for(sheet, "silhouette", tmp_path / "two" / f"{sheet.Name}.dxf")
    assert len(list((tmp_path / "two").iterdir())) == 2
    parts.pattern.IntakeKind = "Straw neck"
    doc.recompute()
    assert "pieces of" in valve.Status
    assert foil.Status == status.READY
    assert not any("Valve film" in text for text in foil.Warnings)


def test_balloons_of_foil_and_of_paper_never_share_a_sheet(doc, rows, tmp_path):
    """One job of several films: each has sheets of its own, one after the other; how the film lies and how
    wide its weld is make no other film."""
    made = [
        create.balloon_from_sketch(doc, sketches.rectangle(doc, 120, 80), mesh_size=12, correct=False)
        for _ in range(4)
    ]
    foil, paper, turned, thick = (each.balloon for each in made)
    paper.Film = "kraft-paper"
    foil.Film = turned.Film = "bopp-foil"
    turned.GrainAngle = 90
    thick.Film = "Custom"
    thick.Thickness = 2.0 * foil.Thickness.Value
    doc.recompute()
    sheet = film_sheet.make(doc, [each.pattern for each in made])
    sheet.FilmWidth, sheet.FilmLength = 500, 500
    doc.recompute()
    assert sheet.Status == status.READY
    assert sheet.Sheets == 3
    pieces = []
    for sheet.Shown in (1, 2, 3):
        doc.recompute()
        pieces.append(sheet.Pieces)
    assert pieces == [4, 2, 2]
    told = [text for text in sheet.Warnings if text.startswith("Of ")]
    assert [text.split(": ")[-1] for text in told] == ["sheet 1.", "sheet 2.", "sheet 3."]
    assert "paper" in told[1].lower()
    before = sheet.LaidOutFor
    paper.Film = "tracing-paper"
    doc.recompute()
    assert sheet.LaidOutFor != before
    left = tmp_path / "remnant.json"
    film_sheet.keep_remnant(sheet, left)
    sheet.Remnant = str(left)
    doc.recompute()
    assert "one film" in sheet.Status


def test_a_layout_of_an_older_release_is_not_cut(parts, rows, tmp_path):
    """Strips once lay among the panels: such a layout is made anew before it is written."""
    doc = parts.balloon.Document
    sheet = film_sheet.make(doc, [parts.pattern])
    doc.recompute()
    sheet.LaidOutFor = "that of another list of pieces"
    with pytest.raises(InputError, match="recompute"):
        export_for(sheet, "any-dxf", tmp_path)

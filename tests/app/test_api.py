# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Python API gives what the objects' properties say, and refuses what they do not know."""

from inspect import signature
from pathlib import Path

import FreeCAD as App
import pytest
import sketches

import BalloonWorkbench
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.properties import preferences, values
from BalloonWorkbench.core.errors import BalloonError, ExportError, InputError

ROOT = Path(__file__).resolve().parents[2]
HEART = ROOT / "resources/examples/pictures/heart.png"


@pytest.fixture(scope="module")
def solved():
    doc = App.newDocument("Api")
    doc.UndoMode = 1
    plate = sketches.rectangle(doc, 90, 60)
    yield BalloonWorkbench.from_sketch(
        doc,
        plate,
        mesh_size="15 mm",
        mode="Inflate as drawn",
        film="pe",
        seal_width="4 mm",
        pressure="30 mbar",
    )
    App.closeDocument(doc.Name)


def test_values_reach_their_objects(parts):
    assert parts.balloon.MeshSize.Value == pytest.approx(15.0)
    assert parts.balloon.Film == "pe"
    assert parts.balloon.Pressure.Value == pytest.approx(3.0)
    assert parts.pattern.SealWidth.Value == pytest.approx(4.0)
    assert parts.balloon.SealWidth.Value == pytest.approx(5.0)  # the film's own


def test_change_recomputes(parts):
    before = parts.pattern.PatternWidth.Value
    BalloonWorkbench.change(parts, allowance="6 mm", intake=False)
    assert parts.pattern.PatternWidth.Value == pytest.approx(90 + 2 * (4 + 6), abs=0.5) != before


def test_any_object_leads_to_its_balloon(parts):
    for obj in (*parts, parts.balloon.getParentGroup()):
        assert BalloonWorkbench.parts(obj) == parts


def test_foreign_object_is_refused(parts):
    with pytest.raises(InputError, match="belongs to no balloon"):
        BalloonWorkbench.parts(parts.outline.Source[0])


#: Functions that work on a balloon, and how many words they need besides.
OF_PARTS = [
    (
        name,
        sum(
            each.default is each.empty and each.kind is not each.VAR_KEYWORD
            for each in taken.parameters.values()
        )
        - 1,
    )
    for name, taken in ((name, signature(getattr(BalloonWorkbench, name))) for name in BalloonWorkbench._API)
    if next(iter(taken.parameters.values())).annotation == "Parts"
]


@pytest.mark.parametrize(("name", "words"), OF_PARTS)
def test_what_works_on_a_balloon_takes_any_object_of_it(parts, name, words):
    """And refuses all else in a sentence: that is no fault of the program."""
    for wrong in (None, "fish", 3, parts.outline.Source[0], App.ActiveDocument):
        with pytest.raises(InputError, match="belongs to no balloon"):
            getattr(BalloonWorkbench, name)(wrong, *[""] * words)


def test_an_object_stands_for_its_balloon(parts, tmp_path):
    assert len(OF_PARTS) >= 9
    assert BalloonWorkbench.findings(parts.balloon) == BalloonWorkbench.findings(parts)
    assert BalloonWorkbench.share(parts.pattern, tmp_path / "it.glb").stat().st_size > 1000
    assert BalloonWorkbench.share(made=parts.balloon, path=tmp_path / "so.glb").read_bytes() == (
        BalloonWorkbench.share(parts.outline, tmp_path / "it.glb").read_bytes()
    )


@pytest.mark.parametrize("wanted", [{"colour": 1}, {"Pressure": 1}, {"volume": "1 l"}])
def test_unknown_value_is_refused(parts, wanted):
    with pytest.raises(InputError, match="it has"):
        BalloonWorkbench.change(parts, **wanted)


@pytest.mark.parametrize(
    "wanted", [{"film": "cheese"}, {"pressure": "three"}, {"mode": "Pop"}, {"drawing": "no.png"}]
)
def test_impossible_value_is_refused(parts, wanted):
    with pytest.raises(BalloonError, match=r"cheese|three|Pop|no\.png"):
        BalloonWorkbench.change(parts, **wanted)


def test_failed_balloon_leaves_nothing(doc):
    plate = sketches.rectangle(doc, 90, 60)
    names = [obj.Name for obj in doc.Objects]
    with pytest.raises(InputError):
        BalloonWorkbench.from_sketch(doc, plate, film="cheese")
    assert [obj.Name for obj in doc.Objects] == names


def test_export_by_object(parts, tmp_path):
    for name, machine in (("a.dxf", None), ("a.svg", None), ("b.dxf", "cutting-shop")):
        assert BalloonWorkbench.export(parts.pattern, tmp_path / name, machine=machine) == tmp_path / name
        assert (tmp_path / name).stat().st_size > 500


def test_repair_takes_the_nearest_finding(doc):
    """A plate with a slender arm: the coach wants it wider, and the arm grows."""
    outline = [(0, 0), (120, 0), (120, 45), (220, 45), (220, 53), (120, 53), (120, 100), (0, 100)]
    plate = _polygon(doc, outline)
    made = BalloonWorkbench.from_sketch(doc, plate, mesh_size=14, mode="Inflate as drawn", intake=False)
    arms = [found for found in BalloonWorkbench.findings(made) if found.rule == "thin_arm"]
    assert arms
    area = made.balloon.FilmArea.Value
    BalloonWorkbench.repair(made, "thin_arm", near=(170, 49))
    assert made.balloon.FilmArea.Value > area + 2 * 100 * 2
    assert made.balloon.Status == status.READY
    with pytest.raises(InputError, match="no_such_rule"):
        BalloonWorkbench.repair(made, "no_such_rule")


def _polygon(doc, corners):
    import Part

    wire = doc.addObject("Part::Feature", "Plate")
    wire.Shape = Part.makePolygon([App.Vector(x, y) for x, y in (*corners, corners[0])])
    return wire


def test_texts_of_values_give_the_same_values(doc):
    """What the window records, the API reads: each value once through text."""
    first = BalloonWorkbench.app.document.create.make(doc)
    first.balloon.Film = "pvc"
    first.balloon.Pressure = "3.3 kPa"
    first.balloon.SizeGoal = "Volume"
    first.balloon.GoalVolume = "2.5 l"
    first.outline.Width = "123.4 mm"
    first.pattern.LabelText = 'A "heart"'
    first.pattern.IntakeAuto = False
    first.pattern.IntakeAngle = 33
    texts = values.texts(first)
    second = BalloonWorkbench.app.document.create.make(doc)
    told = {name: eval(text) for name, text in texts.items() if text not in ("None", '""')}
    told.pop("drawing", None)
    values.assign(second, told)
    assert values.texts(second) == texts
    assert "young_modulus" not in texts  # the film's
    assert texts["label_text"] == '"A \\"heart\\""'


def test_every_value_of_the_objects_has_a_name():
    """Two objects may have the same property; both must be reached."""
    from BalloonWorkbench.app import balloon, outline, pattern

    wanted = [
        item.name
        for module in (outline, balloon, pattern)
        for item in module.PROPERTIES
        if not item.result and item.type != "Link"
    ]
    assert len(values.places()) == len(wanted) + 1  # and the material card


def test_documented_functions_are_there():
    text = (ROOT / "docs/api.md").read_text(encoding="utf-8")
    for name in BalloonWorkbench._API:
        assert callable(getattr(BalloonWorkbench, name))
        assert f"| `{name}(" in text
    with pytest.raises(AttributeError):
        _ = BalloonWorkbench.no_such_function


def test_preferences_play_no_part(doc):
    """A script gives the same balloon on every machine."""
    try:
        preferences.put("Film", "pvc")
        preferences.put("Allowance", 9.0)
        made = BalloonWorkbench.from_picture(
            doc, HEART, width="100 mm", mesh_size="20 mm", mode="Inflate as drawn"
        )
        assert made.balloon.Film == "mylar"
        assert made.pattern.Allowance.Value == pytest.approx(2.0)
    finally:
        for key, item in preferences.items().items():
            preferences.put(key, item.default)


def test_pieces_are_printed_with_their_own_artwork_alone(parts, tmp_path):
    print_ = BalloonWorkbench.artwork(parts.pattern, picture=str(HEART), resolution=50)
    page = BalloonWorkbench.print_pieces(parts.pattern, tmp_path / "pieces.pdf", "A3", print_)
    assert b"/Subtype /Image" in page.read_bytes()
    sheet = BalloonWorkbench.nest([parts.pattern], film_width="400 mm")
    with pytest.raises(ExportError, match="not printed on"):
        BalloonWorkbench.print_pieces(sheet, tmp_path / "other.pdf", artwork=print_)
    assert not (tmp_path / "other.pdf").exists()


@pytest.mark.slow
def test_artwork_layout_and_page(parts, tmp_path):
    """What follows the pattern; each by one call."""
    print_ = BalloonWorkbench.artwork(parts.pattern, picture=str(HEART), bleed="4 mm", resolution=50)
    assert print_.Bleed.Value == pytest.approx(4)
    assert BalloonWorkbench.artwork(parts.pattern, bleed="2 mm") == print_
    BalloonWorkbench.export(print_, tmp_path / "prints")
    assert list((tmp_path / "prints").glob("*.png"))
    with pytest.raises(InputError, match="it has"):
        BalloonWorkbench.artwork(parts.pattern, colour=1)
    page = BalloonWorkbench.assembly_sheet(parts, tmp_path / "page.pdf")
    assert page.read_bytes().startswith(b"%PDF")
    sheet = BalloonWorkbench.nest([parts.pattern], film_width="200 mm", spacing="5 mm")
    assert sheet.FilmWidth.Value == pytest.approx(200)
    assert sheet.Pieces == 2
    assert BalloonWorkbench.nest([parts.pattern], sheet=sheet, balloons=2) == sheet
    assert sheet.Pieces == 4

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Balloons, patterns, prints and sheets of film lie beside each other, and stay where the user puts them.

BALLOON_ARRANGE_STORIES makes the random stories more: `make fuzz`.
"""

import json
import math
import os
import random
from itertools import combinations
from pathlib import Path

import FreeCAD as App
import Part
import pytest
import sketches

from BalloonWorkbench.app import artwork, film_sheet
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.document.examples import EXAMPLES, open_copy
from BalloonWorkbench.app.document.kinds import is_panel, is_source, leader
from BalloonWorkbench.core.nesting import nest as nesting

HEART = Path("resources/examples/pictures/heart.png").resolve()
OLDER = Path("tests/resources/documents/0.1.0-freecad-0.20.FCStd").resolve()
STORIES = int(os.environ.get("BALLOON_ARRANGE_STORIES", "1"))
QUICK = {"correct": False, "mesh_size": 14, "intake": False}


@pytest.fixture(autouse=True)
def rows(monkeypatch):
    """Film is laid out in rows: quick."""
    monkeypatch.setattr(nesting, "PACKAGE", "no_such_package")


def boxes(doc):
    """What each thing takes of the document, by the name of an object: outline and balloon are one."""
    found = {}
    for obj in doc.Objects:
        if is_source(obj):
            found[obj.Name] = App.BoundBox(obj.Shape.BoundBox)
        elif "Roles" in obj.PropertiesList and not is_panel(obj):  # panels lie on their pattern
            found[obj.Name] = obj.Shape.BoundBox
    for obj in doc.Objects:
        if "SolvedFor" in obj.PropertiesList:
            found[obj.Outline.Name].add(obj.Mesh.BoundBox)
    return found


def meetings(doc):
    """Pairs of things that lie on each other; patterns of a drawing may lie in each other's bays."""
    found = [{one, other} for (one, a), (other, b) in combinations(boxes(doc).items(), 2) if a.intersect(b)]
    return [met for met in found if not lie_apart(*map(doc.getObject, met))]


def lie_apart(one, other):
    """Two patterns of a drawing, whose films do not touch."""
    drawn = [obj.Balloon.Outline for obj in (one, other) if "Balloon" in obj.PropertiesList]
    alike = len(drawn) == 2 and len({leader(outline).Name for outline in drawn}) == 1
    return alike and one.Shape.distToShape(other.Shape)[0] > 1.0


def heart(doc, width=80):
    return create.balloon_from_picture(doc, HEART, width=width, **QUICK)


def grid(doc):
    """A rectangle of a spreadsheet's size, and its balloon."""
    sheet = doc.addObject("Spreadsheet::Sheet", "Sizes")
    sheet.set("A1", "=60 mm")
    sheet.setAlias("A1", "side")
    doc.recompute()
    sketch = sketches.rectangle(doc, 60, 60)
    for name in ("Width", "Height"):
        sketch.setExpression(f"Constraints.{name}", "Sizes.side")
    doc.recompute()
    return create.balloon_from_sketch(doc, sketch, **QUICK), sheet


@pytest.fixture(scope="module")
def made_once():
    """Two balloons, a print of the second and a sheet with both; the first follows a spreadsheet."""
    doc = App.newDocument("Everything")
    doc.UndoMode = 1
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(nesting, "PACKAGE", "no_such_package")
        first, sheet = grid(doc)
        second = heart(doc)
        made = artwork.make(second.pattern), film_sheet.make(doc, [first.pattern, second.pattern])
        doc.recompute()
    assert [obj.Status for obj in (*first, *second, *made)] == [status.READY] * 8
    yield first, second, sheet
    App.closeDocument(doc.Name)


@pytest.fixture
def everything(made_once):
    """The document with all of them, as it was after each test."""
    doc = made_once[-1].Document
    before = places(doc)
    yield made_once
    while doc.UndoCount:
        doc.undo()
    doc.clearUndos()
    doc.recompute()
    assert same(before, places(doc))
    assert not meetings(doc)


def places(doc, *names):
    return {
        obj.Name: obj.Placement for obj in doc.Objects if (obj.Name in names if names else has_place(obj))
    }


def has_place(obj):
    return "PlacedAt" in obj.PropertiesList


def same(before, after):
    return all((before[name].Base - after[name].Base).Length < 1e-6 for name in before)


def test_all_lie_beside_each_other_and_stay(everything):
    doc = everything[-1].Document
    assert not meetings(doc)
    assert not [obj.Name for obj in doc.Objects if "Touched" in obj.State]
    before = places(doc)
    for obj in doc.Objects:
        obj.touch()
    doc.recompute()
    assert same(before, places(doc))


@pytest.mark.parametrize("times", [3, 0.4])
def test_what_grows_moves_the_others_aside(everything, times):
    first, second, sheet = everything
    doc = sheet.Document
    doc.openTransaction("Grow")
    before = places(doc)
    sheet.set("A1", f"={60 * times} mm")
    doc.recompute()
    assert first.outline.SizeX.Value == pytest.approx(60 * times)
    assert not meetings(doc)
    assert not [obj.Name for obj in doc.Objects if "Touched" in obj.State]
    assert second.balloon.Placement.Base == second.outline.Placement.Base
    assert same(before, places(doc)) == (times < 1)  # nobody moves where nothing is in the way
    # one more recompute has nothing to do
    before = places(doc)
    doc.recompute()
    assert same(before, places(doc))


def test_what_the_user_has_moved_stays(everything):
    _, second, sheet = everything
    doc = sheet.Document
    doc.openTransaction("Move")
    far, turned = App.Vector(40, -900, 5), App.Rotation(App.Vector(0, 0, 1), 30)
    second.outline.Placement.Base = far
    second.pattern.Placement = App.Placement(second.pattern.Placement.Base, turned)
    doc.recompute()
    before = places(doc, second.outline.Name, second.pattern.Name)
    sheet.set("A1", "=400 mm")
    doc.recompute()
    assert second.balloon.Placement.Base == far
    assert same(before, places(doc))
    assert second.pattern.Placement.Rotation.isSame(turned, 1e-9)
    assert {"Outline", "Pattern"} not in meetings(doc)


def test_put_somewhere_before_it_has_a_shape(doc):
    heart(doc)
    other = create.make(doc)
    other.outline.Placement.Base = place = App.Vector(3, 4, 5)
    create.set_drawing(other.outline, HEART)
    other.outline.Width = 90
    create.configure(other, **QUICK)
    create.compute(other)
    doc.recompute()
    assert other.outline.Placement.Base == place


def two_shapes(path, gap=8):
    """A disc, and a square close beside it."""
    disc = [[60 * math.cos(a), 60 * math.sin(a)] for a in (k * math.pi / 20 for k in range(40))]
    left = 60 + gap
    square = [[left, -40], [left + 80, -40], [left + 80, 40], [left, 40]]
    path.write_text(json.dumps({"unit": "mm", "parts": [{"outer": disc}, {"outer": square}]}))
    return path


def test_shapes_of_a_drawing_move_together(doc, tmp_path):
    heart(doc)
    parts = create.balloon_from_picture(doc, two_shapes(tmp_path / "two.json"), **QUICK)
    (other,) = create.companions(parts)
    assert parts.outline.Placement == other.outline.Placement == other.balloon.Placement
    assert not meetings(doc)
    assert min(box.XMin for box in (parts.outline.Shape.BoundBox, other.outline.Shape.BoundBox)) > 80
    for width in (600, 150):
        parts.outline.Width = width
        doc.recompute()
        assert parts.outline.Placement == other.outline.Placement == other.balloon.Placement
        assert not meetings(doc)


def test_two_drawings_with_two_shapes_each(doc, tmp_path):
    drawing = two_shapes(tmp_path / "two.json")
    made = [create.balloon_from_picture(doc, drawing, **QUICK) for _ in range(2)]
    assert not meetings(doc)
    made[0].outline.Width = 500
    doc.recompute()
    assert not meetings(doc)


def test_a_balloon_larger_than_its_drawing(doc):
    """Its size is that of a volume, and its mesh beyond the outline."""
    parts = heart(doc)
    heart(doc)
    parts.balloon.SizeGoal, parts.balloon.GoalVolume = "Volume", "0.4 l"
    doc.recompute()
    assert parts.balloon.Mesh.BoundBox.XMax > parts.outline.Shape.BoundBox.XMax + 50
    assert not meetings(doc)


def test_what_else_is_in_the_document(doc):
    """A new balloon has its place beside it; later it may be moved into it."""
    box = doc.addObject("Part::Feature", "Stand")
    box.Shape = Part.makeBox(400, 300, 20, App.Vector(-50, -50, 0))
    plane = doc.addObject("Part::Feature", "Endless")
    plane.Shape = Part.Plane().toShape()
    doc.recompute()
    parts = heart(doc)
    assert 350 < parts.outline.Shape.BoundBox.XMin < 500
    assert not any(bound.intersect(box.Shape.BoundBox) for bound in boxes(doc).values())
    before = places(doc)
    box.Placement.Base = App.Vector(300, 0, 0)
    parts.pattern.Notches = 3
    doc.recompute()
    assert same(before, places(doc))


def test_in_a_leaning_plane(doc):
    """The pattern lies beside the outline in its plane, whichever that is."""
    for turn in (App.Rotation(App.Vector(1, 0, 0), 90), App.Rotation(App.Vector(1, 2, 3), 50)):
        sketch = sketches.rectangle(doc, 70, 50)
        sketch.Placement = place = App.Placement(App.Vector(10, 20, 300), turn)
        parts = create.balloon_from_sketch(doc, sketch, **QUICK)
        back = place.inverse()
        low = [min((back * edge.firstVertex().Point).x for edge in parts.pattern.Shape.Edges)]
        low.append(max(abs((back * edge.firstVertex().Point).z) for edge in parts.pattern.Shape.Edges))
        assert 70 < low[0] < 100
        assert low[1] < 1e-6
        for obj in (*reversed(parts), sketch):
            doc.removeObject(obj.Name)


def test_undone_and_done_again(everything):
    sheet = everything[-1]
    doc = sheet.Document
    before = places(doc)
    doc.openTransaction("Grow")
    sheet.set("A1", "=200 mm")
    doc.recompute()
    doc.commitTransaction()
    after = places(doc)
    assert not same(before, after)
    doc.undo()
    assert same(before, places(doc))
    assert not meetings(doc)
    doc.redo()
    assert same(after, places(doc))
    doc.recompute()
    assert same(after, places(doc))
    assert not meetings(doc)


def test_saved_and_opened(everything, tmp_path):
    _, second, sheet = everything
    doc = sheet.Document
    doc.openTransaction("Move")
    second.pattern.Placement.Base += App.Vector(0, 700, 0)
    before = places(doc)
    doc.commitTransaction()
    doc.saveCopy(str(tmp_path / "all.FCStd"))
    again = App.openDocument(str(tmp_path / "all.FCStd"))
    assert same(before, places(again))
    again.Sizes.set("A1", "=300 mm")
    again.recompute()
    assert not meetings(again)
    stays = again.getObject("Pattern001")
    assert (stays.Placement.Base - before["Pattern001"].Base).Length < 1e-6
    App.closeDocument(again.Name)


def test_a_copy_lies_beside_what_it_was_copied_from(doc):
    parts = heart(doc)
    doc.copyObject([parts.balloon.getParentGroup(), *parts], False)
    doc.recompute()
    assert len(boxes(doc)) == 4
    assert not meetings(doc)


@pytest.mark.slow
@pytest.mark.parametrize("name", [example.name for example in EXAMPLES])
def test_an_example_lies_well_and_makes_room(name):
    doc = open_copy(next(example for example in EXAMPLES if example.name == name))
    before = places(doc)
    doc.recompute()
    assert not meetings(doc)
    assert same(before, places(doc))
    doc.Balloon.MeshSize, doc.Balloon.Mode = 40, "Inflate as drawn"
    if name == "parametric-heart":
        other = heart(doc)
        doc.Sizes.set("width", "=750 mm")
        doc.Sizes.set("height", "=690 mm")
        doc.recompute()
        assert other.outline.Shape.BoundBox.XMin > 1100
    elif name == "painted-fish":
        doc.Outline.Width = 600
        doc.recompute()
        assert doc.Pattern.Shape.BoundBox.XMin > 600
    assert not meetings(doc)
    App.closeDocument(doc.Name)


def test_an_older_document_keeps_its_places():
    doc = App.openDocument(str(OLDER))
    before = places(doc, "Outline", "Balloon", "Pattern")
    doc.Rectangle.setDatum("Width", App.Units.Quantity("400 mm"))
    doc.recompute()
    assert same(before, places(doc, "Outline", "Balloon", "Pattern"))
    other = heart(doc)
    doc.recompute()
    assert not [met for met in meetings(doc) if other.outline.Name in met or other.pattern.Name in met]
    App.closeDocument(doc.Name)


class _Story:
    """What users do, in any order."""

    def __init__(self, doc, seed, folder):
        self.doc, self.folder, self.chance, self.made = doc, folder, random.Random(seed), []

    def sketch(self):
        obj = sketches.rectangle(self.doc, self.chance.uniform(60, 90), self.chance.uniform(60, 90))
        self.made.append(create.balloon_from_sketch(self.doc, obj, **QUICK))

    def picture(self):
        self.made.append(heart(self.doc, self.chance.uniform(70, 120)))

    def shapes(self):
        drawing = two_shapes(self.folder / "s.json")
        self.made.append(create.balloon_from_picture(self.doc, drawing, **QUICK))

    def grow(self):
        outline = self.chance.choice(self.made).outline
        if outline.Source:
            outline.Source[0].setDatum("Height", self.chance.uniform(60, 300))
        else:
            outline.Width = self.chance.uniform(150, 400)

    def pattern(self):
        obj = self.chance.choice(self.made).pattern
        obj.Mirror, obj.Allowance = self.chance.random() < 0.5, self.chance.uniform(2, 20)

    def printed(self):
        painted = [each for each in self.made if not each.outline.Source]
        artwork.make(self.chance.choice(painted or self.made).pattern)

    def film(self):
        film_sheet.make(self.doc, [each.pattern for each in self.made])

    def remove(self):
        if len(self.made) > 2:
            create.discard(self.made.pop(self.chance.randrange(len(self.made))))
            for obj in list(self.doc.Objects):
                if getattr(obj, "Pattern", self.doc) is None or getattr(obj, "Patterns", None) == []:
                    self.doc.removeObject(obj.Name)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(STORIES))
def test_a_story(doc, seed, tmp_path):
    """After each step all lie beside each other."""
    story, steps = _Story(doc, seed, tmp_path), []
    do = ["sketch", "picture", "shapes", "grow", "grow", "grow", "pattern", "printed", "film", "remove"]
    story.picture()
    for _ in range(6):
        steps.append(story.chance.choice(do))
        getattr(story, steps[-1])()
        doc.recompute()
        assert not meetings(doc), f"story {seed}: {steps}"

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bags and bodies of gores used hard: what they follow goes away, changes or makes no sense."""

import json
import math

import FreeCAD as App
import Part
import pytest
import sketches

import BalloonWorkbench
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.document.fcstd import write_settings
from BalloonWorkbench.app.document.parts import panels_of, parts_of
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.job import Settings
from BalloonWorkbench.core.options.body import ACCURACY, BodyOptions

SEAMS = [f"Rectangle.Edge{k}=Rectangle001.Edge{p}" for k, p in ((1, 1), (2, 4), (3, 3), (4, 2))]


@pytest.fixture
def pouch(doc):
    """Two squares of sketches, sealed all round, and their sketches."""
    drawn = [sketches.rectangle(doc, 80, 80) for _ in range(2)]
    made = BalloonWorkbench.from_panels(doc, drawn, SEAMS, mesh_size=20, opening_at="Rectangle.Edge1")
    return made, drawn


def bag_of(doc, panels, seams, opening=""):
    """The Bag object alone: nothing is inflated."""
    made = create.make(doc, "Bag", "Bag")
    made.outline.Panels = [(panel, ("",)) for panel in panels]
    made.outline.Seams, made.outline.OpeningAt = seams, opening
    made.outline.recompute()
    return made.outline


def test_a_sketch_that_is_deleted(pouch):
    made, drawn = pouch
    doc, volume = made.balloon.Document, made.balloon.Volume.Value
    doc.openTransaction("delete")
    doc.removeObject(drawn[1].Name)
    doc.recompute()
    doc.commitTransaction()
    assert made.outline.Status.startswith(status.STALE)
    assert "Rectangle001" in made.outline.Status
    assert made.balloon.Volume.Value == volume
    assert len(panels_of(made.pattern)) == 2
    doc.undo()
    doc.recompute()
    assert [obj.Status for obj in made] == [status.READY] * 3


def test_all_sketches_deleted(pouch):
    made, drawn = pouch
    for sketch in drawn:
        made.balloon.Document.removeObject(sketch.Name)
    made.balloon.Document.recompute()
    assert made.outline.Status.startswith(status.STALE)
    assert "Choose sketches" in made.outline.Status


@pytest.mark.parametrize(
    "twice",
    [SEAMS[0], "Rectangle001.Edge1=Rectangle.Edge1", "Rectangle.Edge1=Rectangle.Edge2", " "],
    ids=["same", "turned round", "another partner", "empty"],
)
def test_a_seam_given_twice(doc, twice):
    drawn = [sketches.rectangle(doc, 80, 80) for _ in range(2)]
    bag = bag_of(doc, drawn, [*SEAMS, twice])
    assert not status.is_ready(bag)
    assert "Edge1" in bag.Status or "no two edges" in bag.Status


def test_an_edge_sealed_to_itself(doc):
    drawn = [sketches.rectangle(doc, 80, 80) for _ in range(2)]
    bag = bag_of(doc, drawn, ["Rectangle.Edge1=Rectangle.Edge1", *SEAMS[1:]])
    assert "Rectangle.Edge1" in bag.Status
    assert not status.is_ready(bag)


def test_the_edge_of_a_hole(doc):
    """Two rings sealed along their rims and their holes: a tyre; the opening is not in the hole."""
    drawn = []
    for name in ("Ring", "Other"):
        sketch = doc.addObject("Sketcher::SketchObject", name)
        for radius in (100, 40):
            sketch.addGeometry([Part.Circle(App.Vector(), App.Vector(0, 0, 1), radius)], False)
        drawn.append(sketch)
    doc.recompute()
    bag = bag_of(doc, drawn, ["Ring.Edge1=Other.Edge1"])
    assert "Ring.Edge2 is in no seam" in bag.Status
    bag.Seams = ["Ring.Edge1=Other.Edge2", "Ring.Edge2=Other.Edge1"]
    bag.recompute()
    assert "Ring.Edge1 is 628" in bag.Status
    bag.Seams = ["Ring.Edge1=Other.Edge1", "Ring.Edge2=Other.Edge2"]
    bag.recompute()
    assert bag.Status == status.READY
    bag.OpeningAt = "Ring.Edge2"
    bag.recompute()
    assert not status.is_ready(bag)
    assert "Ring.Edge2" in bag.Status


def test_a_panel_that_gets_another_edge(pouch):
    """The seams keep to the numbers of edges: what that means is told, and comes back with the shape."""
    made, drawn = pouch
    doc = made.balloon.Document
    doc.openTransaction("fifth edge")
    drawn[1].delGeometry(3)
    drawn[1].addGeometry([sketches.line((0, 80), (-30, 40)), sketches.line((-30, 40), (0, 0))], False)
    doc.recompute()
    assert made.outline.Status.startswith(status.STALE)
    assert "Rectangle001.Edge" in made.outline.Status
    assert made.balloon.Volume.Value > 0
    doc.abortTransaction()
    doc.recompute()
    assert [obj.Status for obj in made] == [status.READY] * 3


def test_a_panel_that_loses_an_edge(pouch):
    made, drawn = pouch
    drawn[1].delGeometry(3)
    made.balloon.Document.recompute()
    assert made.outline.Status.startswith(status.STALE)
    assert "Rectangle001" in made.outline.Status


@pytest.mark.parametrize(
    ("name", "expression"),
    [("Edge", "0 mm"), ("Edge", "-10 mm"), ("Edge", "1e-9 mm"), ("Edge", "1e9 mm")],
)
def test_a_size_from_an_expression_that_makes_no_sense(doc, name, expression):
    made = create.make(doc, "Tetra", "Bag")
    made.outline.Ready = "Tetrahedron"
    made.outline.recompute()
    assert made.outline.Status == status.READY
    made.outline.setExpression(name, expression)
    made.outline.recompute()
    made.outline.touch()
    made.outline.recompute()
    assert not status.is_ready(made.outline)


def test_an_expression_of_another_unit_leaves_the_body(doc):
    made = create.make(doc, "Tetra", "Bag")
    made.outline.Ready = "Tetrahedron"
    made.outline.recompute()
    before = made.outline.Edge.Value
    try:
        made.outline.setExpression("Edge", "20 mm * 30 mm")
        made.outline.recompute()
    except (RuntimeError, App.Base.FreeCADError):
        pass  # FreeCAD itself refuses it
    assert made.outline.Edge.Value in (before, 600)


@pytest.mark.slow
def test_gores_from_an_expression_of_zero(doc):
    """0 asks for as many as the accuracy needs; the panels follow."""
    made = BalloonWorkbench.from_profile(doc, gore_length=1000, gores=5, accuracy=0.05, mesh_size=150)
    made.outline.setExpression("Gores", "3 - 3")
    doc.recompute()
    assert made.outline.Gores == 0
    assert [obj.Status for obj in made] == [status.READY] * 3
    assert len(panels_of(made.pattern)) == len(made.pattern.PanelNames)


def test_a_copy_of_a_body_with_its_balloon(doc):
    arc = Part.ArcOfCircle(Part.Circle(App.Vector(), App.Vector(0, 0, 1), 150), -0.5 * math.pi, 0.5 * math.pi)
    half = sketches.sketch(doc, arc, name="Half")
    made = BalloonWorkbench.from_profile(doc, half, gores=4, mesh_size=60)
    other = App.newDocument("Other")
    try:
        copied = parts_of(other.copyObject(made.pattern, True))
        other.recompute()
        assert copied.outline.Source[0].Document == other
        assert [obj.Status for obj in copied] == [status.READY] * 3
        assert len(panels_of(copied.pattern)) == len(panels_of(made.pattern))
        made.outline.Gores = 6
        doc.recompute()
        assert copied.balloon.PanelCount == 4
    finally:
        App.closeDocument(other.Name)


def test_a_body_copied_alone_into_another_document(doc):
    """The body has lost its sketch there, and says so."""
    arc = Part.ArcOfCircle(Part.Circle(App.Vector(), App.Vector(0, 0, 1), 150), -0.5 * math.pi, 0.5 * math.pi)
    half = sketches.sketch(doc, arc, name="Half")
    made = create.make(doc, "Half", "GoredBody")
    made.outline.Source = (half, [""])
    made.outline.recompute()
    other = App.newDocument("Other")
    try:
        alone = other.copyObject(made.outline, False)
        alone.touch()
        other.recompute()
        assert not status.is_ready(alone)
        assert alone.Status
    finally:
        App.closeDocument(other.Name)


def test_the_accuracy_where_gores_are_given(doc):
    """A number of gores says nothing of an accuracy: without the number the usual one holds, and not the
    least that can be typed, which takes a hundred gores."""
    made = create.make(doc, "Body", "GoredBody")
    write_settings(made, Settings(body=BodyOptions(gores=5)))
    assert made.outline.Gores == 5
    assert made.outline.Accuracy == pytest.approx(ACCURACY)
    write_settings(made, Settings(body=BodyOptions(accuracy=0.03)))
    assert made.outline.Gores == 0
    assert made.outline.Accuracy == pytest.approx(0.03)


def test_a_file_that_is_no_bag(doc, tmp_path):
    path = tmp_path / "outline.json"
    path.write_text(json.dumps({"unit": "mm", "outer": [[0, 0], [1, 0], [0, 1]]}))
    with pytest.raises(InputError, match='"name": "top"'):
        BalloonWorkbench.from_panels(doc, str(path))
    assert doc.Objects == []


def test_what_is_in_another_document(doc):
    """Nothing here can follow it, and nothing is left of the attempt."""
    other = App.newDocument("Other")
    try:
        box = other.addObject("Part::Box", "Box")
        drawn = sketches.rectangle(other, 80, 80)
        other.recompute()
        for make, source in (
            (BalloonWorkbench.from_body, box),
            (BalloonWorkbench.from_sketch, drawn),
            (BalloonWorkbench.from_profile, drawn),
            (BalloonWorkbench.from_panels, [drawn, (box, ["Face1"])]),
        ):
            with pytest.raises(InputError, match=r"is in the document Other\w*: copy it"):
                make(doc, source)
        assert doc.Objects == []
    finally:
        App.closeDocument(other.Name)

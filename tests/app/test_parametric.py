# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parametric: other values re-design the same objects, and what comes out depends on the values alone."""

from pathlib import Path

import FreeCAD as App
import pytest
import sketches

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.pattern import sheet

PICTURES = Path(__file__).parents[2] / "resources" / "examples" / "pictures"


def result(parts):
    """Everything that a design leaves behind, to the last digit; seconds are in the report alone."""
    outline, balloon, pattern = parts
    points = [point for facet in balloon.Mesh.Facets for point in facet.Points]
    lengths = (
        "InflatedWidth InflatedHeight InflatedThickness Volume FilmArea ResidualMean ResidualMax CreasedMax"
        " FloatsFrom"
    )
    numbers = "MaxTension MaxStrain WrinkledShare SlackShare Weight Lift Passes NewtonSteps SolvedFor"
    return (
        [tuple(point) for point in outline.LoopPoints],
        [tuple(point) for point in balloon.SeamPoints],
        points,
        [getattr(balloon, name).Value for name in lengths.split()],
        [getattr(balloon, name) for name in numbers.split()],
        [contour.points.tolist() for contour in sheet(pattern).contours],
        [round(edge.Length, 6) for edge in pattern.Shape.Edges],  # where it lies: test_arrange.py
        pattern.SeamLength.Value,
    )


def identity(parts):
    """What must not change: names, links, places in the tree."""
    outline, balloon, pattern = parts
    group = balloon.getParentGroup()
    assert (balloon.Outline, pattern.Balloon) == (outline, balloon)
    return [obj.Name for obj in parts], [obj.ID for obj in parts], [obj.Name for obj in group.Group]


def recomputed(parts):
    parts.balloon.Document.recompute()
    assert [obj.Status for obj in parts] == [status.READY] * 3
    return result(parts)


@pytest.fixture(scope="module")
def from_sketch():
    document = App.newDocument("Parametric")
    name = document.Name
    yield create.balloon_from_sketch(document, sketches.rectangle(document), mesh_size=15)
    App.closeDocument(name)


@pytest.fixture(scope="module")
def from_picture():
    document = App.newDocument("ParametricPicture")
    name = document.Name
    yield create.balloon_from_picture(document, PICTURES / "star.png", width=200, mesh_size=14)
    App.closeDocument(name)


def set_height(parts, height):
    parts.outline.Source[0].setDatum("Height", App.Units.Quantity(f"{height} mm"))


def set_width(parts, width):
    parts.outline.Width = width


def set_film(parts, name):
    parts.balloon.Film = name


def set_pressure(parts, pressure):
    parts.balloon.Pressure = pressure


@pytest.mark.parametrize(
    ("change", "there", "back"),
    [(set_height, 100, 80), (set_film, "pe", "mylar"), (set_pressure, 4, 2)],
)
def test_a_change_redesigns_the_same_objects_and_the_way_back_leads_back(from_sketch, change, there, back):
    before, who = result(from_sketch), identity(from_sketch)
    change(from_sketch, there)
    after = recomputed(from_sketch)
    assert after[1] != before[1]
    assert identity(from_sketch) == who
    change(from_sketch, back)
    assert recomputed(from_sketch) == before
    assert identity(from_sketch) == who


def test_width_of_a_picture_redesigns_the_same_objects(from_picture):
    before, who = result(from_picture), identity(from_picture)
    set_width(from_picture, 260)
    after = recomputed(from_picture)
    assert after[3][0] == pytest.approx(260, rel=0.01)
    assert identity(from_picture) == who
    set_width(from_picture, 200)
    assert recomputed(from_picture) == before


@pytest.mark.slow
def test_the_order_of_the_changes_does_not_matter(from_sketch):
    steps = [(set_height, 95), (set_film, "pe"), (set_pressure, 3)]
    results = []
    for order in (steps, steps[::-1]):
        for change, value in order:
            change(from_sketch, value)
            recomputed(from_sketch)
        results.append(result(from_sketch))
        for change, value in ((set_height, 80), (set_film, "mylar"), (set_pressure, 2)):
            change(from_sketch, value)
        recomputed(from_sketch)
    assert results[0] == results[1]


def test_a_new_document_gives_the_same_as_the_changed_one(from_sketch):
    set_height(from_sketch, 90)
    set_pressure(from_sketch, 1.5)
    changed = recomputed(from_sketch)
    document = App.newDocument("Fresh")
    try:
        sketch = sketches.rectangle(document, 120, 90)
        fresh = create.balloon_from_sketch(document, sketch, mesh_size=15, pressure=1.5)
        assert result(fresh)[1:5] == changed[1:5]
    finally:
        App.closeDocument(document.Name)
        set_height(from_sketch, 80)
        set_pressure(from_sketch, 2)
        recomputed(from_sketch)


def test_a_difference_in_the_last_digits_is_none(from_sketch):
    """Of the pressure: neither is the balloon computed anew, nor would it come out otherwise."""
    from BalloonWorkbench.app.balloon import request

    balloon = from_sketch.balloon
    before = request(balloon)
    balloon.Pressure = 2.0 * (1.0 + 1e-12)
    after = request(balloon)
    balloon.Pressure = 2.0
    assert before.settings.pressure != after.settings.pressure
    assert before.key() == after.key()
    one, other = (each.design() for each in (before, after))
    assert one.pattern.outer.tobytes() == other.pattern.outer.tobytes()
    assert one.inflation.positions.tobytes() == other.inflation.positions.tobytes()
    balloon.Document.recompute()

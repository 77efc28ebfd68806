# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies of gores: from a sketch, a wire, a file, or the natural shape; where they stand, and their ends."""

import itertools
import json
import math

import FreeCAD as App
import numpy as np
import Part
import pytest
import sketches

import BalloonWorkbench
from BalloonWorkbench.app import gored_body
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.engine.export import export_results
from BalloonWorkbench.core.errors import InputError

QUICK = {"gores": 6, "mesh_size": 40}


def half_circle(doc, radius=150.0, side=1.0):
    arc = Part.ArcOfCircle(
        Part.Circle(App.Vector(), App.Vector(0, 0, 1), radius),
        *((-0.5 * math.pi, 0.5 * math.pi) if side > 0 else (0.5 * math.pi, 1.5 * math.pi)),
    )
    return sketches.sketch(doc, arc, name="Half")


def body(doc, source):
    """The object alone: nothing is inflated."""
    parts = create.make(doc, "Body", "GoredBody")
    parts.outline.Source = (source, [""])
    parts.outline.recompute()
    return parts.outline


@pytest.fixture(scope="module")
def sphere():
    document = App.newDocument("Sphere")
    document.UndoMode = 1
    yield BalloonWorkbench.from_profile(document, half_circle(document), **QUICK)
    App.closeDocument(document.Name)


def test_results_tell_how_far_it_is_from_its_profile(sphere, tmp_path):
    """The film of six gores of a sphere is within some percent of its radius, the mean as the object says."""
    path = export_results(sphere.balloon, tmp_path / "results.npz")
    with np.load(path) as found:
        away, places = found["distance_mm"], found["positions_mm"]
    assert away == pytest.approx(np.linalg.norm(places, axis=1) - 150.0, abs=0.1)
    assert np.abs(away).max() == pytest.approx(sphere.balloon.ResidualMax.Value, rel=0.02)


def test_a_sphere_of_gores(sphere):
    assert [obj.Status for obj in sphere] == [status.READY] * 3
    assert sphere.outline.BodyDiameter.Value == pytest.approx(300, rel=1e-4)
    assert sphere.outline.MeridianLength.Value == pytest.approx(150 * math.pi, rel=1e-4)
    assert sphere.outline.ProfileEnds == ["point", "point"]
    assert sphere.balloon.PanelCount == 6
    # the law: 16 % by the square of the number of gores, of the diagonal; a coarse mesh adds its own
    diagonal = 300 * math.sqrt(2)
    assert sphere.balloon.ResidualMean.Value < 1.5 * 0.16 / 36 * diagonal
    assert sphere.balloon.Apart.Value > 0
    assert sphere.balloon.Volume.getValueAs("l").Value == pytest.approx(4 / 3 * math.pi * 1.5**3, rel=0.04)
    assert sphere.pattern.Pieces[0].startswith("6 x gore 1")


def test_it_stands_along_the_axis_of_the_sketch(sphere):
    """A sketch in the xy plane has its axis along y."""
    assert sphere.balloon.Mesh.BoundBox.YLength == pytest.approx(300, rel=0.01)
    assert sphere.outline.Shape.BoundBox.ZLength < 1e-6
    assert sphere.outline.Shape.BoundBox.YLength == pytest.approx(300, rel=1e-4)
    assert sphere.balloon.Placement == sphere.outline.Placement


def test_the_gores_lie_beside_it_in_the_plane_of_the_sketch(sphere):
    """Who has drawn the profile looks at that plane."""
    pattern, body = sphere.pattern.Shape.BoundBox, sphere.balloon.Mesh.BoundBox
    assert pattern.ZLength < 1e-6
    assert pattern.ZMin == pytest.approx(0, abs=1e-6)
    assert pattern.YLength > 100
    assert pattern.XMin > body.XMax


def test_more_gores_are_nearer_to_the_profile(sphere):
    doc, before = sphere.balloon.Document, sphere.balloon.ResidualMean.Value
    doc.openTransaction("more")
    BalloonWorkbench.change(sphere, gores=12)
    assert sphere.balloon.PanelCount == 12
    assert sphere.balloon.ResidualMean.Value < 0.6 * before
    doc.abortTransaction()
    doc.recompute()
    assert sphere.balloon.PanelCount == 6


@pytest.mark.slow
def test_a_profile_on_the_left_of_its_axis_is_the_same(doc):
    right, left = (body(doc, half_circle(doc, side=side)) for side in (1.0, -1.0))
    assert left.BodyDiameter.Value == pytest.approx(right.BodyDiameter.Value)
    assert left.Status == status.READY


def test_a_construction_line_is_the_axis(doc):
    sketch = sketches.sketch(doc, *sketches.polygon((50, 0), (150, 0), (150, 200), (50, 200)), name="Tin")
    sketch.addGeometry([Part.LineSegment(App.Vector(20, -10), App.Vector(20, 300))], True)
    sketch.delGeometry(3)  # the side along the axis
    doc.recompute()
    made = body(doc, sketch)
    assert made.Status == status.READY
    assert made.BodyDiameter.Value == pytest.approx(260)
    assert made.Placement.Base.x == pytest.approx(20)


def test_a_closed_half_has_its_axis_on_the_left(doc):
    """Level lines to the axis are discs."""
    sketch = sketches.sketch(doc, *sketches.polygon((0, 0), (100, 0), (120, 200), (0, 200)), name="Bucket")
    made = body(doc, sketch)
    assert made.Status == status.READY
    assert made.ProfileEnds == ["disc", "disc"]
    assert made.BodyDiameter.Value == pytest.approx(240)
    made.UpperCap = "Open"
    made.recompute()
    assert made.ProfileEnds == ["disc", "open"]


def test_a_wire_in_the_xz_plane_stands_upright(doc):
    points = [App.Vector(0, 0, 0), App.Vector(80, 0, 100), App.Vector(0, 0, 250)]
    wire = doc.addObject("Part::Feature", "Kite")
    wire.Shape = Part.makePolygon(points)
    made = body(doc, wire)
    assert made.Status == status.READY
    assert made.Shape.BoundBox.ZLength == pytest.approx(250)
    assert made.Placement.Rotation.Angle == pytest.approx(0)


@pytest.mark.parametrize(
    ("points", "told"),
    [
        (((-50, 0), (50, 100), (0, 200)), "both sides of its axis"),
        (((0, 0), (50, 50), (0, 100), (50, 150), (0, 200)), "touches its axis"),
    ],
)
def test_a_profile_that_is_none(doc, points, told):
    lines = [Part.LineSegment(App.Vector(*a, 0), App.Vector(*b, 0)) for a, b in itertools.pairwise(points)]
    before = len(doc.Objects) + 1
    with pytest.raises(InputError, match=told):
        BalloonWorkbench.from_profile(doc, sketches.sketch(doc, *lines, name="Wrong"), **QUICK)
    assert len(doc.Objects) == before


def test_a_file_at_a_size(doc, tmp_path):
    path = tmp_path / "pear.json"
    path.write_text(json.dumps({"unit": "mm", "profile": [[0, 0], [100, 80], [60, 200], [0, 260]]}))
    parts = create.make(doc, "Pear", "GoredBody")
    gored_body.set_profile(parts.outline, path)
    parts.outline.Height = 520
    parts.outline.recompute()
    assert parts.outline.Status == status.READY
    assert parts.outline.BodyDiameter.Value == pytest.approx(400)
    assert parts.outline.ProfileFile.endswith("pear.json")


def test_the_natural_shape(doc):
    parts = create.make(doc, "Natural", "GoredBody")
    parts.outline.ProfileFrom = gored_body.NATURAL_SHAPE
    parts.outline.GoreLength = 1000
    parts.outline.recompute()
    assert parts.outline.Status == status.READY
    assert parts.outline.BodyHeight.Value == pytest.approx(643.9, rel=1e-3)
    assert parts.outline.BodyDiameter.Value == pytest.approx(2 * 327.01, rel=1e-3)


def test_the_number_of_gores_that_an_accuracy_needs_is_foretold(doc):
    made = body(doc, half_circle(doc))
    made.Accuracy = 0.001
    made.recompute()
    many = made.GoresNeeded
    made.Accuracy = 0.01
    made.recompute()
    assert 3 <= made.GoresNeeded < many
    assert made.GoresNeeded == pytest.approx(math.sqrt(16), abs=2)

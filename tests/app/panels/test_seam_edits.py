# SPDX-License-Identifier: LGPL-2.1-or-later
"""Seams of a body that the user changes or draws: kept as data, saved, copied, undone."""

import math

import FreeCAD as App
import Mesh
import Part
import pytest

from BalloonWorkbench.app import target
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.properties import values
from BalloonWorkbench.core.flattening.bag_of import bag_of
from BalloonWorkbench.core.flattening.flatten import flatten
from BalloonWorkbench.core.geometry.polyline import signed_area

MERGE = '{"do": "merge", "panels": ["Face1", "Face3"]}'
CUT = '{"do": "cut", "at": [[0, -50, 50], [0, 50, 50]], "mirrored": false}'


def divided(doc, source, **named):
    """The object alone: nothing is inflated."""
    parts = create.make(doc, "Body", "Target")
    parts.outline.Solid, parts.balloon.Live = source, False
    values.assign(parts, named)
    parts.outline.recompute()
    return parts.outline


@pytest.fixture
def box(doc):
    solid = doc.addObject("Part::Box", "Box")
    solid.Length = solid.Width = solid.Height = 100
    doc.recompute()
    return solid


def line(doc, *points, name="Line"):
    obj = doc.addObject("Part::Feature", name)
    obj.Shape = Part.makePolygon([App.Vector(*each) for each in points])
    return obj


def test_faces_are_merged_and_cut(doc, box):
    made = divided(doc, box, seam_edits=[MERGE, CUT])
    assert made.Status == status.READY
    assert not made.Notes
    assert made.PanelNames == ["Face1", "Face2", "Face4", "Face5", "Face6", "Face6b"]
    # twelve edges of a cube, one gone, one more in the middle of the top
    assert made.SeamLength.Value == pytest.approx(1200, rel=1e-6)


def test_an_edit_follows_the_size_of_the_body(doc, box):
    cut = '{"do": "cut", "at": [[25, -50, 50], [25, 50, 50]], "size": [100, 100, 100], "mirrored": false}'
    made = divided(doc, box, seam_edits=[cut])
    box.Length = 200
    doc.recompute()
    assert made.PanelNames[-1] == "Face6b"
    across = [point for point in made.TargetPoints if abs(point.x - 50) < 1e-3]
    assert len(across) > 1, "a quarter of the length from the middle"


def test_an_edit_whose_panels_are_gone_is_told_and_the_others_stay(doc, box):
    made = divided(doc, box, seam_edits=[MERGE, MERGE, CUT])
    assert made.Status == status.READY
    assert made.PanelNames[-1] == "Face6b"
    assert [note for note in made.Notes if note.startswith("Seam edit 2 is left out.")]


def test_what_is_no_edit_is_told(doc, box):
    assert "none of merge, cut" in divided(doc, box, seam_edits=['{"do": "glue"}']).Status
    assert "cannot be read" in divided(doc, box, seam_edits=["cut it"]).Status


def test_sketches_are_projected_onto_the_solid(doc, box):
    """A line over the top cuts top, bottom and two sides; the near side alone is the top."""
    sketch = line(doc, (30, -20, 150), (30, 120, 150))
    made = divided(doc, box, seam_sketches=[sketch])
    assert made.Status == status.READY
    assert made.PanelCount == 10
    assert made.SeamLength.Value == pytest.approx(1600, rel=1e-3)
    made.NearSide = True
    doc.recompute()
    assert made.PanelNames[-1] == "Face6b"
    assert made.SeamLength.Value == pytest.approx(1300, rel=1e-3)
    sketch.Shape = Part.makePolygon([App.Vector(300, -20, 150), App.Vector(300, 120, 150)])
    doc.recompute()
    assert made.PanelCount == 6
    assert [note for note in made.Notes if note.startswith("Line is left out.") and "misses" in note]


def test_only_seams_that_are_drawn(doc):
    """A ball cut by two planes through its middle, seen as lines from above."""
    ball = doc.addObject("Part::Sphere", "Ball")
    ball.Radius = 80
    ball.Placement.Base = App.Vector(10, 20, 30)
    doc.recompute()
    lines = [line(doc, (-90, 20, 200), (110, 20, 200)), line(doc, (10, -80, 200), (10, 120, 200))]
    made = divided(doc, ball, panels=1)
    assert "no seam" in made.Status
    assert made.TargetPoints, "it is shown for the first seam"
    values.assign_to(made, made.Proxy.properties, {"seam_sketches": lines})
    made.recompute()
    assert made.Status == status.READY
    assert made.PanelCount == 4
    assert made.SeamLength.Value == pytest.approx(2 * math.tau * 80, rel=5e-3)


def test_sketches_of_a_mesh_that_was_moved(doc):
    obj = doc.addObject("Mesh::Feature", "Crate")
    obj.Mesh = Mesh.createBox(100.0, 100.0, 100.0)
    obj.Placement.Base = App.Vector(500, 0, 0)
    doc.recompute()
    made = divided(doc, obj, panels=6, seam_sketches=[line(doc, (480, -200, 150), (480, 200, 150))])
    assert made.Status == status.READY
    assert not [note for note in made.Notes if "left out" in note]
    assert made.PanelCount == 10


def test_they_are_saved_copied_and_undone(doc, box, tmp_path):
    made = divided(doc, box, seam_edits=[MERGE])
    doc.UndoMode = 1
    doc.openTransaction("Cut")
    made.SeamEdits = [MERGE, CUT]
    doc.recompute()
    doc.commitTransaction()
    assert made.PanelCount == 6
    copied = doc.copyObject(made)
    assert copied.SeamEdits == [MERGE, CUT]
    doc.undo()
    doc.recompute()
    assert (made.SeamEdits, made.PanelCount) == ([MERGE], 5)
    doc.saveAs(str(tmp_path / "box.FCStd"))
    again = App.openDocument(str(tmp_path / "box.FCStd"))
    try:
        assert again.getObject(made.Name).SeamEdits == [MERGE]
        assert again.getObject(made.Name).PanelCount == 5
    finally:
        App.closeDocument(again.Name)


def test_a_cylinder_that_is_cut_keeps_its_exact_faces(doc):
    """Its side in two halves: each as wide as the circle is long, as high as half of it."""
    tube = doc.addObject("Part::Cylinder", "Tube")
    tube.Radius, tube.Height = 50, 100
    doc.recompute()
    made = divided(doc, tube, seam_edits=['{"do": "plane", "at": [[0, 0, 10]], "along": [0, 0, 1]}'])
    assert made.Status == status.READY
    assert made.PanelCount == 4
    division = target.division(made)
    flats = flatten(division)
    bag = bag_of(division, flats, exact=True).bag
    areas = {panel.name: signed_area(panel.outer) * 1e6 for panel in bag.panels}
    round_it = 2 * math.pi * 50
    sides = sorted(areas[name] for name in areas if name.startswith("Face1"))
    assert sides == pytest.approx([round_it * 40, round_it * 60], rel=1e-5)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Balloons that fill a closed body: a solid of the document, a mesh, a file."""

import math

import FreeCAD as App
import Mesh
import Part
import pytest

import BalloonWorkbench
from BalloonWorkbench.app import target
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import arrange, create
from BalloonWorkbench.core.errors import InputError


def solid(doc, shape, name="Solid"):
    obj = doc.addObject("Part::Feature", name)
    obj.Shape = shape
    return obj


def divided(doc, source, panels=0):
    """The object alone: nothing is inflated."""
    parts = create.make(doc, "Body", "Target")
    parts.outline.Solid = source
    parts.outline.Panels = panels
    parts.outline.recompute()
    return parts.outline


@pytest.fixture(scope="module")
def cube():
    document = App.newDocument("Cube")
    document.UndoMode = 1
    box = document.addObject("Part::Box", "Box")
    box.Length = box.Width = box.Height = 100
    document.recompute()
    yield BalloonWorkbench.from_body(document, box, mesh_size=8, mode="Inflate as drawn")
    App.closeDocument(document.Name)


def test_a_cube_is_made_of_its_faces(cube):
    assert [obj.Status for obj in cube] == [status.READY] * 3
    assert cube.outline.PanelNames == [f"Face{number}" for number in range(1, 7)]
    assert cube.outline.SeamLength.Value == pytest.approx(1200)
    assert cube.outline.BodyVolume.getValueAs("l").Value == pytest.approx(1.0)
    # inextensible film: 1.26 times the volume of the cube
    assert cube.balloon.Volume.getValueAs("l").Value == pytest.approx(1.26, rel=0.02)
    assert len(BalloonWorkbench.panels(cube)) == 6


def test_it_follows_the_solid(cube):
    box = cube.outline.Solid
    box.Height = 200
    box.Document.recompute()
    assert cube.outline.BodyVolume.getValueAs("l").Value == pytest.approx(2.0)
    assert cube.balloon.Volume.getValueAs("l").Value == pytest.approx(2.532, rel=0.02)
    box.Height = 100
    box.Document.recompute()


def test_a_lost_solid_is_told(doc):
    box = doc.addObject("Part::Box", "Box")
    doc.recompute()
    made = divided(doc, box)
    assert made.Status == status.READY
    doc.removeObject(box.Name)
    doc.recompute()
    assert "Choose a solid" in made.Status


@pytest.mark.parametrize(
    ("shape", "faces", "seams"),
    [
        # the side is cut open along the cylinder: its own seam, and the rims of both discs
        (lambda: Part.makeCylinder(50, 100), 3, 100 + 2 * math.pi * 100),
        (lambda: Part.makeCone(50, 0, 100), 2, math.hypot(50, 100) + math.pi * 100),
        (lambda: Part.makeCone(50, 20, 100), 3, math.hypot(30, 100) + math.pi * 140),
    ],
    ids=["cylinder", "cone", "frustum"],
)
def test_developable_faces_keep_their_edges(doc, shape, faces, seams):
    made = divided(doc, solid(doc, shape()))
    assert made.Status == status.READY
    assert made.PanelCount == faces
    assert made.SeamLength.Value == pytest.approx(seams, rel=1e-3)


def test_a_solid_in_so_many_panels(doc):
    made = divided(doc, solid(doc, Part.makeSphere(100)), 8)
    assert made.Status == status.READY
    assert made.PanelCount == 8


def test_a_face_that_is_curved_both_ways_is_told(doc):
    assert "Give a number of panels" in divided(doc, solid(doc, Part.makeSphere(100))).Notes[0]
    assert not divided(doc, solid(doc, Part.makeCylinder(50, 100))).Notes


@pytest.mark.parametrize(
    ("shape", "words"),
    [
        (
            lambda: Part.Compound([Part.makeBox(1, 1, 1), Part.makeBox(1, 1, 1, App.Vector(5, 0, 0))]),
            "2 bodies",
        ),
        (lambda: Part.Shell(Part.makeBox(9, 9, 9).Faces[:5]), "not closed"),
        (lambda: Part.makePlane(9, 9), "not closed"),
        (lambda: Part.makeBox(90, 90, 90).cut(Part.makeSphere(20, App.Vector(45, 45, 45))), "hollow"),
    ],
    ids=["two", "open", "flat", "hollow"],
)
def test_no_closed_body_is_told(doc, shape, words):
    assert words in divided(doc, solid(doc, shape())).Status


def test_a_mesh_of_the_document(doc):
    obj = doc.addObject("Mesh::Feature", "Ball")
    obj.Mesh = Mesh.createSphere(80.0, 24)
    made = divided(doc, obj, 6)
    assert made.Status == status.READY
    assert (made.Kind, made.PanelCount) == ("mesh", 6)


def test_files(doc, tmp_path):
    Part.makeBox(100, 80, 60).exportStep(str(tmp_path / "box.step"))
    Mesh.createBox(100.0, 80.0, 60.0).write(str(tmp_path / "box.stl"))
    for name, panels in (("box.step", 0), ("box.stl", 6)):
        parts = create.make(doc, name, "Target")
        target.set_body(parts.outline, tmp_path / name)
        parts.outline.Panels = panels
        parts.outline.recompute()
        assert parts.outline.Status == status.READY, name
        assert parts.outline.BodyVolume.getValueAs("ml").Value == pytest.approx(480, rel=1e-6)
        assert parts.outline.PanelCount == 6


def test_what_is_no_file(doc, tmp_path):
    with pytest.raises(InputError, match="There is no file"):
        BalloonWorkbench.from_body(doc, tmp_path / "no.stl")
    (tmp_path / "broken.step").write_text("no step", encoding="utf-8")
    with pytest.raises(InputError, match="no solid"):
        BalloonWorkbench.from_body(doc, tmp_path / "broken.step")
    assert not doc.Objects


def box_of(obj):
    """In the document."""
    (box,) = arrange.boxes([obj], App.Placement())
    return box


@pytest.mark.parametrize("panels", [0, 12])
def test_it_lies_beside_its_solid(doc, panels):
    """Also while its only seam is half a circle; at the solid's height, and still where that has grown."""
    ball = doc.addObject("Part::Sphere", "Ball")
    ball.Radius, ball.Placement.Base = 80, App.Vector(30, 40, 250)
    doc.recompute()
    made = divided(doc, ball, panels)
    doc.recompute()
    at = made.Placement.Base
    assert tuple(at - ball.Placement.Base)[1:] == pytest.approx((0, 0), abs=0.5)
    assert box_of(made).XMin > box_of(ball).XMax
    ball.Radius = 160
    doc.recompute()
    assert made.Placement.Base.x > at.x
    assert box_of(made).XMin > box_of(ball).XMax


def test_its_balloon_and_pattern_lie_beside_it(cube):
    solid, target, balloon, pattern = (cube.outline.Solid, *cube)
    assert (balloon.Placement.Base - target.Placement.Base).Length < 1e-9
    assert target.Placement.Base.z == pytest.approx(50)
    assert balloon.Mesh.BoundBox.XMin > solid.Shape.BoundBox.XMax
    assert pattern.Shape.BoundBox.XMin > balloon.Mesh.BoundBox.XMax
    assert pattern.Shape.BoundBox.ZMin == pytest.approx(0), "on the plane on which the solid stands"


def test_its_panels_lie_level(cube):
    """A square of 100 mm between its weld and what is left outside takes no more film than it needs."""
    for panel in BalloonWorkbench.panels(cube):
        sizes = panel.Shape.BoundBox.XLength, panel.Shape.BoundBox.YLength
        assert min(sizes) < 125, "on its corner it would be 141"

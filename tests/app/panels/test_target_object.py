# SPDX-License-Identifier: LGPL-2.1-or-later
"""Balloons that fill a closed body: a solid of the document, a mesh, a file."""

import math

import FreeCAD as App
import Mesh
import numpy as np
import Part
import pytest

import BalloonWorkbench
from BalloonWorkbench.app import target
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import arrange, create
from BalloonWorkbench.app.drawings.solid import division_of
from BalloonWorkbench.core.bags.check_bag import check_bag
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.flattening.bag_of import bag_of
from BalloonWorkbench.core.flattening.flatten import flatten
from BalloonWorkbench.core.geometry.polyline import signed_area
from BalloonWorkbench.core.seam_edits.redivide import panels_not_discs


def solid(doc, shape, name="Solid"):
    obj = doc.addObject("Part::Feature", name)
    obj.Shape = shape
    return obj


def divided(doc, source, panels=0):
    """The object alone: nothing is inflated."""
    parts = create.make(doc, "Body", "Target")
    parts.outline.Solid, parts.balloon.Live = source, False
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
    yield BalloonWorkbench.from_body(document, box, mesh_size=14, mode="Inflate as drawn")
    App.closeDocument(document.Name)


def test_a_cube_is_made_of_its_faces(cube):
    assert [obj.Status for obj in cube] == [status.READY] * 3
    assert cube.outline.PanelNames == [f"Face{number}" for number in range(1, 7)]
    assert cube.outline.SeamLength.Value == pytest.approx(1200)
    assert cube.outline.BodyVolume.getValueAs("l").Value == pytest.approx(1.0)
    # inextensible film: 1.26 times the volume of the cube
    assert cube.balloon.Volume.getValueAs("l").Value == pytest.approx(1.26, rel=0.04)
    assert len(BalloonWorkbench.panels(cube)) == 6


def test_it_follows_the_solid(cube):
    box = cube.outline.Solid
    box.Height = 200
    box.Document.recompute()
    assert cube.outline.BodyVolume.getValueAs("l").Value == pytest.approx(2.0)
    assert cube.balloon.Volume.getValueAs("l").Value == pytest.approx(2.532, rel=0.04)
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


@pytest.mark.slow
@pytest.mark.parametrize(
    ("shape", "strips"),
    [
        (lambda: Part.makeSphere(100), 8),  # from pole to pole
        (lambda: Part.makeTorus(100, 40), 5),  # round the ring
        (lambda: Part.makeSphere(100).toNurbs(), 8),
    ],
    ids=["sphere", "torus", "spline"],
)
def test_a_face_that_is_curved_both_ways_is_cut_into_strips(doc, shape, strips):
    made = divided(doc, solid(doc, shape()))
    assert made.Status == status.READY
    assert made.PanelNames == [f"Face1.{number + 1}" for number in range(strips)]
    assert f"cut into {strips} strips" in made.Notes[0]
    division = target.division(made)
    areas = np.bincount(division.panels, division.target.areas)
    assert areas.min() > 0.4 * areas.max()
    assert not len(panels_not_discs(division))


def test_a_fillet_between_two_faces_stays_one_strip(doc):
    box = Part.makeBox(100, 80, 60)
    made = divided(doc, solid(doc, box.makeFillet(10, box.Edges)))
    assert made.Status == status.READY
    assert (made.PanelCount, made.Notes) == (26, [])


def filleted():
    box = Part.makeBox(100, 80, 60)
    return box.makeFillet(10, [edge for edge in box.Edges if abs(edge.tangentAt(0).z) > 0.5])


def drilled():
    return Part.makeBox(100, 80, 60).cut(Part.makeCylinder(15, 100, App.Vector(50, 40, -10)))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("shape", "areas"),
    [
        (lambda: Part.makeBox(10, 20, 30), [600, 600, 300, 300, 200, 200]),
        (lambda: Part.makeCylinder(50, 80), [math.pi * 8000, math.pi * 2500, math.pi * 2500]),
        (lambda: Part.makeCylinder(50, 80).toNurbs(), [math.pi * 8000, math.pi * 2500, math.pi * 2500]),
        (lambda: Part.makeCone(50, 0, 100), [math.pi * 50 * math.hypot(50, 100), math.pi * 2500]),
        (
            lambda: Part.makeCone(50, 20, 100),
            [math.pi * 70 * math.hypot(30, 100), math.pi * 400, math.pi * 2500],
        ),
        (
            filleted,
            [*[4800, 4800, 3600, 3600], *[math.pi * 300] * 4, *[8000 - 100 * (4 - math.pi)] * 2],
        ),
        (
            drilled,
            [4800, 4800, 6000, 6000, *[8000 - math.pi * 225] * 2, math.pi * 30 * 60],
        ),
        (
            lambda: Part.makeCylinder(50, 200).cut(
                Part.makeBox(400, 400, 400, App.Vector(-200, -200, 100), App.Vector(0.3, 0, 1))
            ),
            [math.pi * 2500, math.pi * 2500 * math.hypot(1, 0.3), None],
        ),
    ],
    ids=["box", "cylinder", "spline", "cone", "frustum", "filleted", "drilled", "slanted"],
)
def test_faces_that_unroll_have_their_true_areas(doc, shape, areas):
    """Not those of the triangles: by formulas, also in another place, and after they were saved."""
    body = shape()
    body.Placement = App.Placement(App.Vector(700, -300, 77), App.Rotation(App.Vector(1, 2, 3), 50))
    division = target.division(divided(doc, solid(doc, body)))
    bag = bag_of(division, flatten(division), exact=True).bag
    check_bag(bag)
    made = sorted(sum(signed_area(loop) for loop in panel.loops) * 1e6 for panel in bag.panels)
    known = [area for area in areas if area is not None]
    for area in known:
        nearest = min(made, key=lambda each: abs(each - area))
        assert nearest == pytest.approx(area, rel=1e-6)
        made.remove(nearest)
    assert len(made) == len(areas) - len(known)


@pytest.mark.slow
def test_a_cone_inflates_to_its_closed_form(doc):
    """Inextensible film: 1.733304 R^3 for a cone of slant sqrt 2 R (panels sealed all round)."""
    cone = doc.addObject("Part::Cone", "Cone")
    cone.Radius1, cone.Radius2, cone.Height = 100, 0, 100
    doc.recompute()
    parts = BalloonWorkbench.from_body(doc, cone, mesh_size=20, mode="Inflate as drawn")
    assert parts.balloon.Volume.getValueAs("l").Value == pytest.approx(1.733304, rel=0.03)


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


@pytest.mark.slow
def test_a_mesh_of_the_document(doc):
    obj = doc.addObject("Mesh::Feature", "Ball")
    obj.Mesh = Mesh.createSphere(80.0, 24)
    made = divided(doc, obj, 6)
    assert made.Status == status.READY
    assert (made.Kind, made.PanelCount) == ("mesh", 6)


@pytest.mark.slow
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


@pytest.mark.slow
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


def test_a_solid_with_an_error_is_told(doc):
    box = doc.addObject("Part::Box", "Box")
    fillet = doc.addObject("Part::Fillet", "Fillet")
    fillet.Base, fillet.Edges = box, [(1, 90, 90), (2, 90, 90), (3, 90, 90)]
    doc.recompute()
    assert "Invalid" in fillet.State
    with pytest.raises(InputError, match="Fillet has an error"):
        BalloonWorkbench.from_body(doc, fillet)
    fillet.Edges = [(1, 1, 1)]
    doc.recompute()
    made = create.make(doc, "Body", "Target")
    made.outline.Solid, made.balloon.Live = fillet, False
    doc.recompute()
    assert made.outline.Status == status.READY
    fillet.Edges = [(1, 90, 90), (2, 90, 90), (3, 90, 90)]
    doc.recompute()
    assert made.outline.Status == status.STALE + "Fillet has an error: repair it."
    assert "Fillet has an error" in made.balloon.Status
    fillet.Edges = [(1, 2, 2)]
    doc.recompute()
    assert made.outline.Status == status.READY


def test_its_own_balloon_is_no_body(cube):
    box = cube.outline.Solid
    for own in (cube.balloon, cube.pattern):
        cube.outline.Solid = own
        cube.outline.recompute()
        assert "follows itself" in cube.outline.Status
    cube.outline.Solid = box
    box.Document.recompute()
    assert [obj.Status for obj in cube] == [status.READY] * 3


@pytest.mark.parametrize(
    ("source", "panels", "words"),
    [
        (None, 0, "None is no body"),
        (5, 0, "5 is no body"),
        ("Box", 201, "2 to 200 panels"),
        ("Box", -3, "2 to 200"),
    ],
)
def test_what_is_asked_for_makes_no_sense(doc, source, panels, words):
    doc.addObject("Part::Box", "Box")
    doc.recompute()
    with pytest.raises(InputError, match=words):
        BalloonWorkbench.from_body(doc, doc.Box if source == "Box" else source, panels=panels)
    assert [obj.Name for obj in doc.Objects] == ["Box"]


def test_text_for_a_number_is_told_in_a_sentence(doc):
    doc.addObject("Part::Box", "Box")
    doc.recompute()
    with pytest.raises(InputError, match=r'^panels cannot be "many": type must be int, not str$'):
        BalloonWorkbench.from_body(doc, doc.Box, panels="many")


@pytest.mark.slow
def test_how_it_lies_is_inflated_anew(doc):
    """A change of Lies, or of the margin, makes another balloon."""
    box = solid(doc, Part.makeBox(100, 100, 100))
    made = BalloonWorkbench.from_body(doc, box, mesh_size=25, lies="Encloses it")
    keys = [made.balloon.SolvedFor]

    def sizes():
        """Half the balloon along each axis."""
        return [max(abs(point[axis]) for point in made.balloon.FilmPoints) for axis in range(3)]

    assert min(sizes()) > 49.0
    for name, value, fits in (
        ("Margin", 10, lambda: min(sizes()) > 58.0),
        ("Lies", "Lines it inside", lambda: max(sizes()) < 50.0),
    ):
        setattr(made.outline, name, value)
        doc.recompute()
        assert [obj.Status for obj in made] == [status.READY] * 3
        assert fits(), f"{name} {value}: {sizes()}"
        keys.append(made.balloon.SolvedFor)
    assert len(set(keys)) == 3


@pytest.mark.slow
def test_what_was_shown_of_a_solid_changes_nothing(doc):
    """The window leaves its triangles in the shape."""
    drum = doc.addObject("Part::Cylinder", "Drum")
    drum.Radius, drum.Height = 50, 100
    doc.recompute()
    hidden = division_of(drum, 8)
    drum.Shape.tessellate(0.001)
    shown = division_of(drum, 8)
    assert shown.target.points.tobytes() == hidden.target.points.tobytes()
    assert shown.panels.tobytes() == hidden.panels.tobytes()

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sketches, wires and faces become outlines in their own plane."""

import math

import FreeCAD as App
import numpy as np
import Part
import pytest
import sketches

from BalloonWorkbench.app.drawings.sketch import drawing_of
from BalloonWorkbench.core.errors import OutlineError
from BalloonWorkbench.core.geometry.polyline import signed_area


def loops_of(source, elements=()):
    """Loops in mm and the plane."""
    drawing, placement = drawing_of(source, elements)
    return [loop * 1000 for loop in drawing.largest.loops], placement


def areas(loops):
    return [abs(signed_area(loop)) for loop in loops]


def test_rectangle_keeps_its_corners(doc):
    loops, placement = loops_of(sketches.rectangle(doc, 120, 80))
    assert placement.isIdentity()
    assert len(loops) == 1
    assert {tuple(np.round(corner, 9)) for corner in loops[0]} == {(0, 0), (120, 0), (120, 80), (0, 80)}


def test_arcs_follow_the_curve(doc):
    loops, _ = loops_of(sketches.rounded_l(doc))
    assert areas(loops) == pytest.approx([sketches.rounded_l_area()], rel=2e-4)


def test_ring_has_two_loops(doc):
    loops, _ = loops_of(sketches.ring(doc, 35, 70))
    assert areas(loops) == pytest.approx([math.pi * 70**2, math.pi * 35**2], rel=2e-4)


def test_separate_loops_are_separate_shapes(doc):
    circles = [Part.Circle(sketches.vector(x, 0), App.Vector(0, 0, 1), r) for x, r in ((0, 20), (90, 30))]
    drawing, _ = drawing_of(sketches.sketch(doc, *circles), ())
    found = [(part.area * 1e6, *part.outer.mean(axis=0) * 1000) for part in drawing.parts]
    assert found[0] == pytest.approx((math.pi * 900, 90, 0), rel=2e-3, abs=0.1)
    assert found[1] == pytest.approx((math.pi * 400, 0, 0), rel=2e-3, abs=0.1)


def test_letter_s(doc):
    loops, _ = loops_of(sketches.letter_s(doc, 40, 30))
    exact = 1.5 * math.pi * (55**2 - 25**2) + math.pi * 15**2
    assert areas(loops) == pytest.approx([exact], rel=2e-4)


def test_closed_spline(doc):
    spline = Part.BSplineCurve()
    spline.interpolate(
        Points=[sketches.vector(50 * math.cos(a), 30 * math.sin(a)) for a in np.arange(12) * math.pi / 6],
        PeriodicFlag=True,
    )
    feature = doc.addObject("Part::Feature", "Spline")
    feature.Shape = spline.toShape()
    loops, _ = loops_of(feature)
    assert areas(loops) == pytest.approx([math.pi * 50 * 30], rel=2e-3)


def test_lines_in_any_order_and_direction(doc):
    corners = [(0, 0), (40, 0), (60, 30), (20, 50)]
    lines = sketches.polygon(*corners)
    lines[1] = sketches.line(corners[2], corners[1])
    obj = sketches.sketch(doc, lines[2], lines[0], lines[3], lines[1])
    loops, _ = loops_of(obj)
    x, y = np.array(corners).T
    assert areas(loops) == pytest.approx([0.5 * abs(x @ np.roll(y, -1) - y @ np.roll(x, -1))])


def test_construction_lines_do_not_count(doc):
    obj = sketches.sketch(doc, *sketches.polygon((0, 0), (40, 0), (0, 40)))
    obj.addGeometry(sketches.line((5, 5), (100, 90)), True)
    doc.recompute()
    assert len(loops_of(obj)[0]) == 1


def test_the_plane_of_the_sketch_is_kept(doc):
    obj = sketches.rectangle(doc)
    obj.Placement = App.Placement(App.Vector(10, 20, 30), App.Rotation(App.Vector(1, 0, 0), 90))
    doc.recompute()
    loops, placement = loops_of(obj)
    assert np.ptp(loops[0], axis=0) == pytest.approx((120, 80))
    assert placement.multVec(App.Vector(120, 80, 0)).isEqual(App.Vector(130, 20, 110), 1e-6)


def test_a_body_that_was_moved_takes_its_sketch_along(doc):
    part = doc.addObject("App::Part", "Part")
    obj = sketches.rectangle(doc)
    part.addObject(obj)
    part.Placement.Base = App.Vector(0, 0, 50)
    doc.recompute()
    assert loops_of(obj)[1].Base.isEqual(App.Vector(0, 0, 50), 1e-9)


def test_wire_in_space(doc):
    corners = [App.Vector(0, 0, 0), App.Vector(30, 0, 30), App.Vector(30, 40, 30), App.Vector(0, 40, 0)]
    feature = doc.addObject("Part::Feature", "Wire")
    feature.Shape = Part.makePolygon([*corners, corners[0]])
    loops, placement = loops_of(feature)
    assert areas(loops) == pytest.approx([40 * math.hypot(30, 30)])
    back = [placement.multVec(App.Vector(x, y, 0)) for x, y in loops[0]]
    assert all(any(point.isEqual(corner, 1e-6) for point in back) for corner in corners)


def test_draft_wire(doc):
    import Draft

    wire = Draft.make_wire([sketches.vector(*p) for p in ((0, 0), (50, 0), (50, 20), (0, 20))], closed=True)
    doc.recompute()
    assert areas(loops_of(wire)[0]) == pytest.approx([1000])


@pytest.mark.parametrize("name", [f"Face{i}" for i in range(1, 7)])
def test_face_of_a_solid(doc, name):
    box = doc.addObject("Part::Box", "Box")
    box.Length, box.Width, box.Height = 10, 20, 30
    doc.recompute()
    face = box.Shape.getElement(name)
    loops, placement = loops_of(box, (name,))
    assert areas(loops) == pytest.approx([face.Area])
    outward = placement.Rotation.multVec(App.Vector(0, 0, 1))
    assert outward.isEqual(face.normalAt(0, 0), 1e-9)
    centre = placement.multVec(App.Vector(*loops[0].mean(axis=0), 0))
    assert centre.isEqual(face.CenterOfMass, 1e-6)


def refused(source, text, elements=()):
    with pytest.raises(OutlineError, match=text):
        loops_of(source, elements)


def test_open_sketch_tells_where(doc):
    obj = sketches.sketch(doc, sketches.line((5, 0), (40, 0)), sketches.line((40, 0), (40, 60)))
    refused(obj, r"open.*\(5, 0\) mm.*\(40, 60\) mm")


def test_self_crossing_sketch_tells_where(doc):
    obj = sketches.sketch(doc, *sketches.polygon((0, 0), (60, 60), (60, 0), (0, 60)))
    refused(obj, r"crosses.*\(30, 30\) mm")


def test_sketch_without_area(doc):
    refused(sketches.sketch(doc, *sketches.polygon((0, 0), (60, 0), (20, 0))), "Draw|closed")


def test_empty_sketch(doc):
    refused(doc.addObject("Sketcher::SketchObject", "Sketch"), "Sketch is empty|Sketch has no shape")


def test_solid_needs_one_face(doc):
    box = doc.addObject("Part::Box", "Box")
    doc.recompute()
    refused(box, "several faces")


def test_bent_wire_is_refused(doc):
    feature = doc.addObject("Part::Feature", "Bent")
    corners = [App.Vector(0, 0, 0), App.Vector(30, 0, 0), App.Vector(30, 40, 9), App.Vector(0, 40, 0)]
    feature.Shape = Part.makePolygon([*corners, corners[0]])
    refused(feature, "Bent is not flat")


def test_group_has_no_shape(doc):
    refused(doc.addObject("App::DocumentObjectGroup", "Group"), "Group has no shape")

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sketch of a pattern, and its splines: they solve, hold together, and are the pattern."""

import FreeCAD as App
import numpy as np
import Part
import pytest
import shapely
import sketches

from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.pattern import build
from BalloonWorkbench.app.shapes.pattern_sketch import make_sketch
from BalloonWorkbench.core.arcs.fit_arcs import fit_curve
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.pattern.pattern import Role

NEAR = 0.02  # mm


@pytest.fixture(scope="module")
def pattern():
    """The corrected pattern of a ring with an intake and notches."""
    document = App.newDocument("Sketch")
    name = document.Name
    made = create.balloon_from_sketch(document, sketches.ring(document), mesh_size=16)
    made.pattern.Notches = 6
    document.recompute()
    yield made.pattern
    App.closeDocument(name)


def off(wire, placement, contour) -> float:
    """The largest distance between a wire and the points of a contour, both ways [mm]."""
    back = placement.inverse()
    pieces = [[back.multVec(point) for point in edge.discretize(Deflection=0.001)] for edge in wire.Edges]
    drawn = shapely.MultiLineString([[(point.x, point.y) for point in piece] for piece in pieces])
    line = (shapely.LinearRing if contour.closed else shapely.LineString)(1000.0 * contour.points)
    return max(
        shapely.distance(shapely.points(shapely.get_coordinates(a)), b).max()
        for a, b in ((drawn, line), (line, drawn))
    )


def meshed_area(face) -> float:
    """The area of a flat face from fine triangles: FreeCAD's integral plays no part in it [mm²]."""
    points, triangles = face.tessellate(0.001)
    corners = np.array([(point.x, point.y) for point in points])[np.array(triangles)]
    return float(shapely.area(shapely.polygons(corners)).sum())


def test_sketch_solves_and_is_the_pattern(pattern):
    sketch = make_sketch(pattern)
    try:
        pattern.Document.recompute()
        assert sketch.solve() == 0
        assert sketch.getParentGroup() == pattern.getParentGroup()
        cuts = [contour for role in (Role.CUT, Role.CUT_INNER) for contour in build(pattern).of(role)]
        curves = [fit_curve(contour.points, True) for contour in cuts]
        beside = [contour for role in (Role.SEAL, Role.NOTCH) for contour in build(pattern).of(role)]
        lines = [fit_curve(contour.points, contour.closed) for contour in beside]
        assert sketch.GeometryCount == sum(map(len, curves)) + sum(map(len, lines))
        construction = [sketch.getConstruction(k) for k in range(sketch.GeometryCount)]
        assert construction == [k >= sum(map(len, curves)) for k in range(sketch.GeometryCount)]
        # one constraint at each joint, of two kinds; the rest is free
        assert sketch.ConstraintCount == sum(map(len, curves))
        assert {constraint.Type for constraint in sketch.Constraints} == {"Coincident", "Tangent"}
        assert {type(line) for line in sketch.Geometry} == {Part.LineSegment, Part.ArcOfCircle}
        wires = sketch.Shape.Wires
        assert len(wires) == len(cuts)
        assert all(wire.isClosed() for wire in wires)
        for contour in cuts:
            assert min(off(wire, pattern.Placement, contour) for wire in wires) < NEAR + 0.003  # chords
        # it can be gone on with
        assert Part.makeFace(wires, "Part::FaceMakerBullseye").isValid()
    finally:
        pattern.Document.removeObject(sketch.Name)


def test_sketch_can_be_pulled_and_holds_together(pattern):
    sketch = make_sketch(pattern)
    try:
        arc = next(k for k, line in enumerate(sketch.Geometry) if isinstance(line, Part.ArcOfCircle))
        start = sketch.getPoint(arc, 1)
        sketches.move_point(sketch, arc, 1, start + App.Vector(0.5, 0.5, 0.0))
        pattern.Document.recompute()
        assert (sketch.getPoint(arc, 1) - start).Length > 0.1
        assert all(wire.isClosed() for wire in sketch.Shape.Wires)
    finally:
        pattern.Document.removeObject(sketch.Name)


def test_a_stale_pattern_has_no_sketch(pattern):
    pattern.IntakeWidth = 0
    pattern.Document.recompute()
    with pytest.raises(InputError, match="not up to date"):
        make_sketch(pattern)
    pattern.IntakeWidth = 10
    pattern.Document.recompute()


def test_splines_are_the_pattern(pattern):
    """A few splines and lines, smooth between corners, within 0.02 mm of the points; the face is whole."""
    arcs = len(pattern.Shape.Edges)
    area = pattern.Shape.Faces[0].Area
    pattern.Splines = True
    pattern.Document.recompute()
    try:
        assert {type(edge.Curve) for edge in pattern.Shape.Edges} == {Part.Line, Part.BSplineCurve}
        assert len(pattern.Shape.Edges) < arcs  # a ring's are full circles, of few arcs
        wanted = [c for role in (Role.CUT, Role.CUT_INNER, Role.SEAL) for c in build(pattern).of(role)]
        for wire, contour in zip(pattern.Shape.Wires, wanted):
            assert wire.isClosed() == contour.closed
            assert off(wire, pattern.Placement, contour) < NEAR + 0.003
        face = pattern.Shape.Faces[0]
        assert face.isValid()
        assert meshed_area(face) == pytest.approx(area, rel=1e-5)
        assert face.Area == pytest.approx(area, rel=3e-4)  # FreeCAD integrates roughly beside splines
        for edge in pattern.Shape.Edges:
            if isinstance(edge.Curve, Part.BSplineCurve):
                assert edge.Curve.Continuity in ("C1", "C2", "C3", "CN")
    finally:
        pattern.Splines = False
        pattern.Document.recompute()

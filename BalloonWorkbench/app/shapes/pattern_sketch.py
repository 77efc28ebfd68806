# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pattern as a Sketcher sketch, to go on with in FreeCAD.

The arcs and lines of the cuts hold together by one constraint at each joint, tangent or coincident; nothing
else is fixed. Welds and marks are construction geometry without constraints, to measure from and to snap to:
sketches with many constraints are slow, of 250 arcs each change takes seconds. Letters and copies stay out;
the shape of the pattern has them.
"""

from __future__ import annotations

import math

import FreeCAD as App
import Part
import Sketcher

from BalloonWorkbench.app import pattern
from BalloonWorkbench.app.border import status
from BalloonWorkbench.core.arcs.curves import Curve
from BalloonWorkbench.core.arcs.fit_arcs import fit_curve
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.pattern.pattern import Role
from BalloonWorkbench.core.units import MILLIMETRE

#: What lies beside the cuts as construction geometry.
_BESIDE = (Role.SEAL, Role.WELD, Role.NOTCH, Role.FOLD, Role.PEN)


def make_sketch(obj):
    """A new sketch of one panel of a pattern object, in its place and beside it in the tree.

    Raises InputError while the pattern is not up to date.
    """
    if not status.is_ready(obj):
        raise InputError(f"{obj.Label} is not up to date. {status.problem(obj)}")
    made = pattern.build(obj)
    sketch = obj.Document.addObject("Sketcher::SketchObject", f"{obj.Name}Sketch")
    sketch.Label = f"{obj.Label} sketch"
    sketch.Placement = obj.Placement
    group = obj.getParentGroup()
    if group is not None:
        group.addObject(sketch)
    for contour in (*made.of(Role.CUT), *made.of(Role.CUT_INNER)):
        _add(sketch, fit_curve(contour.points, True))
    for role in _BESIDE:
        for contour in made.of(role):
            sketch.addGeometry(_lines(fit_curve(contour.points, contour.closed)), True)
    sketch.solve()
    return sketch


def _add(sketch, curve: Curve) -> None:
    """One closed contour: its segments, and a constraint at each joint."""
    numbers = list(sketch.addGeometry(_lines(curve), False))
    # Sketcher's arcs run counter-clockwise: one that turns right begins at its point 2
    begins = [2 if segment.bulge < 0.0 else 1 for segment in curve.segments]
    corners = curve.corners
    sketch.addConstraint(
        [
            Sketcher.Constraint(
                "Coincident" if corners[k] else "Tangent",
                numbers[k - 1],
                3 - begins[k - 1],
                numbers[k],
                begins[k],
            )
            for k in range(len(numbers))
        ]
    )


def _lines(curve: Curve) -> list:
    """The segments of a curve as FreeCAD's lines and arcs [mm]."""
    scaled = curve.moved(0.0 * curve.joints[0], 1.0 / MILLIMETRE)
    return [_geometry(segment) for segment in scaled.segments]


def _geometry(segment):
    """A line, or an arc about the z axis [mm]."""
    (x, y), (u, v), bulge = segment.start.tolist(), segment.end.tolist(), segment.bulge
    if bulge == 0.0:
        return Part.LineSegment(App.Vector(x, y, 0.0), App.Vector(u, v, 0.0))
    # the centre is beside the middle of the chord, by the chord times (1 - b^2) / 4 b
    off = (1.0 - bulge * bulge) / (4.0 * bulge)
    centre = App.Vector(0.5 * (x + u) - off * (v - y), 0.5 * (y + v) + off * (u - x), 0.0)
    radius = math.hypot(x - centre.x, y - centre.y)
    first, last = (math.atan2(b - centre.y, a - centre.x) for a, b in ((x, y), (u, v)))
    if bulge < 0.0:
        first, last = last, first
    circle = Part.Circle(centre, App.Vector(0.0, 0.0, 1.0), radius)
    return Part.ArcOfCircle(circle, first, last if last > first else last + 2.0 * math.pi)

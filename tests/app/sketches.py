# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sketches to make balloons from; lengths in mm."""

import math

import FreeCAD as App
import Part


def vector(x, y):
    return App.Vector(x, y, 0)


def line(a, b):
    return Part.LineSegment(vector(*a), vector(*b))


def arc(centre, radius, start, end):
    """Counter-clockwise between two angles in degrees."""
    circle = Part.Circle(vector(*centre), App.Vector(0, 0, 1), radius)
    return Part.ArcOfCircle(circle, math.radians(start), math.radians(end))


def polygon(*corners):
    return [line(a, b) for a, b in zip(corners, (*corners[1:], corners[0]), strict=True)]


def sketch(doc, *geometry, name="Sketch"):
    obj = doc.addObject("Sketcher::SketchObject", name)
    obj.addGeometry(list(geometry), False)
    doc.recompute()
    return obj


def rectangle(doc, width=120.0, height=80.0):
    """Constrained: its dimensions are the constraints Width and Height."""
    import Sketcher

    obj = sketch(doc, *polygon((0, 0), (width, 0), (width, height), (0, height)), name="Rectangle")
    for i in range(4):
        obj.addConstraint(Sketcher.Constraint("Coincident", i, 2, (i + 1) % 4, 1))
    for i, kind in enumerate(("Horizontal", "Vertical", "Horizontal", "Vertical")):
        obj.addConstraint(Sketcher.Constraint(kind, i))
    obj.addConstraint(Sketcher.Constraint("Coincident", 0, 1, -1, 1))
    for edge, name, value in ((0, "Width", width), (1, "Height", height)):
        number = obj.addConstraint(Sketcher.Constraint("Distance", edge, value))
        obj.renameConstraint(number, name)
    doc.recompute()
    return obj


def rounded_l(doc, long=120.0, wide=50.0, radius=10.0):
    """Two equal arms of an L, all six corners rounded, the inner one outward."""
    r, far, near = radius, long - radius, wide - radius
    parts = [
        arc((r, r), r, 180, 270),
        line((r, 0), (far, 0)),
        arc((far, r), r, 270, 360),
        line((long, r), (long, near)),
        arc((far, near), r, 0, 90),
        line((far, wide), (wide + r, wide)),
        arc((wide + r, wide + r), r, 180, 270),
        line((wide, wide + r), (wide, far)),
        arc((near, far), r, 0, 90),
        line((near, long), (r, long)),
        arc((r, far), r, 90, 180),
        line((0, far), (0, r)),
    ]
    return sketch(doc, *parts, name="RoundedL")


def rounded_l_area(long=120.0, wide=50.0, radius=10.0):
    """Exact: five corners lose (1 - pi/4) r^2, the inner one gains it."""
    return 2 * long * wide - wide**2 - 4 * (1 - math.pi / 4) * radius**2


def ring(doc, inner=35.0, outer=70.0):
    circles = [Part.Circle(App.Vector(0, 0, 0), App.Vector(0, 0, 1), radius) for radius in (outer, inner)]
    return sketch(doc, *circles, name="Ring")


def letter_s(doc, radius=40.0, width=30.0):
    """Two half-rings, open to opposite sides, with round ends."""
    large, small, end = radius + width / 2, radius - width / 2, width / 2
    up, down = (0, radius), (0, -radius)
    parts = [
        arc(up, large, 0, 270),
        arc(up, small, 0, 270),
        arc((radius, radius), end, 180, 360),
        arc(down, small, 180, 450),
        arc(down, large, 180, 450),
        arc((-radius, -radius), end, 0, 180),
    ]
    # the S: the upper half-ring ends where the lower one begins
    return sketch(doc, *parts, name="LetterS")


def move_point(sketch, geometry, position, target):
    """Pull a point of a sketch to a place; FreeCAD 1.1 has another name for it."""
    move = sketch.movePoint if hasattr(sketch, "movePoint") else sketch.moveGeometry
    move(geometry, position, target, 0)

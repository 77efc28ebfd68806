# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pattern as the shape and the results of a Pattern object."""

from __future__ import annotations

#: What may tell where an intake is.
DIRECTION, PLACE = "Direction", "Place on the seam"
#: Where it is found unless it is told.


def show(obj, pattern, curves, how_to_fill: str) -> list:
    """Write a pattern into the object: the sheets to cut out first, then welds and marks.

    curves  that are drawn for its contours
    Returns the contours in the order of the shape's wires.
    """
    import math

    import Part

    from BalloonWorkbench.app.shapes import part_shapes
    from BalloonWorkbench.core.pattern.pattern import Role
    from BalloonWorkbench.core.units import to_mm

    cuts = _nested(pattern.of(Role.CUT), pattern.of(Role.CUT_INNER))
    beside = (Role.SEAL, Role.WELD, Role.NOTCH, Role.FOLD, Role.PEN, Role.ENGRAVE)
    lines = [contour for role in beside for contour in pattern.of(role)]
    wire = part_shapes.spline_wire if obj.Arcs and obj.Splines else part_shapes.curve_wire
    drawn = {id(contour): wire(curve) for contour, curve in zip(pattern.contours, curves, strict=True)}
    faces = [Part.Face([drawn[id(each)] for each in sheet]) for sheet in cuts]
    obj.Shape = Part.Compound([*faces, *(drawn[id(line)] for line in lines)])
    shown = [*(each for sheet in cuts for each in sheet), *lines]
    obj.Roles = [contour.role.value for contour in shown]
    obj.SeamLength = to_mm(pattern.seam_length)
    obj.PatternWidth, obj.PatternHeight = (to_mm(length) for length in pattern.of_stock("").size)
    obj.Warnings = list(pattern.warnings)
    obj.HowToFill = how_to_fill
    if pattern.intake is not None and (obj.IntakeAuto or obj.IntakeBy == PLACE):
        obj.IntakeAngle = math.degrees(pattern.intake.angle)
    if pattern.intake is not None and (obj.IntakeAuto or obj.IntakeBy == DIRECTION):
        obj.IntakeAlong = to_mm(pattern.intake.along)
    return shown


def _nested(outer, inner) -> list:
    """Each outer cut with the inner ones that lie in it and in no smaller one."""
    from BalloonWorkbench.core.geometry.crossings import contains
    from BalloonWorkbench.core.geometry.polyline import signed_area

    smallest_first = sorted(outer, key=lambda cut: abs(signed_area(cut.points)))
    holes = {id(cut): [] for cut in outer}
    for hole in inner:
        around = [cut for cut in smallest_first if contains(cut.points, hole.points[:1])[0]]
        holes[id(around[0])].append(hole)
    return [[cut, *holes[id(cut)]] for cut in outer]

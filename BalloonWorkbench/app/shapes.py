# SPDX-License-Identifier: LGPL-2.1-or-later
"""Between the engine's loops (arrays, m) and FreeCAD's wires, faces and point lists (mm)."""

from __future__ import annotations

import FreeCAD as App
import numpy as np
import Part

from BalloonWorkbench.core.outline.drawing import sealed
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.pattern.curves import Curve
from BalloonWorkbench.core.units import from_mm, to_mm


def vectors(points) -> list:
    """Points (n, 2) in m as vectors in mm."""
    return [App.Vector(x, y, 0.0) for x, y in to_mm(np.asarray(points, dtype=float)).tolist()]


def wire(points, closed: bool = True):
    """A wire of straight edges through points (n, 2) in m."""
    corners = vectors(points)
    return Part.makePolygon(corners + corners[:1] if closed else corners)


def curve_wire(curve: Curve):
    """A wire of straight edges and true arcs."""
    edges = []
    for segment in curve.segments:
        chord = segment.end - segment.start
        if segment.bulge == 0.0:
            edges.append(Part.LineSegment(*vectors([segment.start, segment.end])).toShape())
            continue
        middle = 0.5 * (segment.start + segment.end + segment.bulge * np.array([chord[1], -chord[0]]))
        edges.append(Part.Arc(*vectors([segment.start, middle, segment.end])).toShape())
    return Part.Wire(edges)


def spline_wire(curve: Curve, tolerance: float = from_mm(0.005)):
    """A wire of straight edges and splines: smooth stretches between them are one each, near to it [m]."""
    turned = curve.begun_at(int(np.flatnonzero(curve.corners)[0])) if _cornered(curve) else curve
    corners, straight = turned.corners, turned.bulges == 0.0
    edges, run = [], []
    for k in range(len(turned)):
        run.append(k)
        after = (k + 1) % len(turned)
        ends = k + 1 == len(turned) or corners[after] or straight[k] or straight[after]
        if not ends:
            continue
        ends_at = (turned.starts[run[0]], turned.ends[run[-1]])
        if straight[k]:
            edges.append(Part.LineSegment(*vectors(ends_at)).toShape())
        else:
            part = Curve(
                np.concatenate([turned.starts[run], turned.ends[run[-1:]]]), turned.bulges[run], False
            )
            edges.append(_spline(part, tolerance).toShape())
        run = []
    return Part.Wire(edges)


def _cornered(curve: Curve) -> bool:
    return curve.closed and bool(curve.corners.any())


def _spline(curve: Curve, tolerance: float):
    """A smooth spline through the ends, near to arcs, with their directions at the ends."""
    points = curve.flattened(0.1 * tolerance)
    spline = Part.BSplineCurve()
    spline.approximate(
        Points=vectors(points), DegMin=3, DegMax=3, Continuity="C2", Tolerance=to_mm(0.5 * tolerance)
    )
    return spline


def face(outline: Outline):
    """The flat face between the outer loop and the holes, its wires in the order of the loops; then welds."""
    sheet = Part.Face([wire(loop) for loop in (outline.outer, *outline.holes)])
    welds = [wire(weld, False) for weld in outline.welds] + [wire(spot) for spot in outline.spots]
    return Part.makeCompound([sheet, *welds]) if welds else sheet


def store(obj, prefix: str, outline: Outline) -> None:
    """Keep the lines exactly: <prefix>Points and <prefix>Counts have the outer loop and the holes,
    <prefix>WeldPoints and -Counts the welds, spots with their first point repeated at the end.

    Shapes lose the last digits in files.
    """
    spots = [np.concatenate([spot, spot[:1]]) for spot in outline.spots]
    for name, lines in (("", (outline.outer, *outline.holes)), ("Weld", (*outline.welds, *spots))):
        setattr(obj, f"{prefix}{name}Points", [vector for line in lines for vector in vectors(line)])
        setattr(obj, f"{prefix}{name}Counts", [len(line) for line in lines])


def stored(obj, prefix: str) -> Outline:
    """The outline kept by `store`."""
    outer, *holes = _lines(obj, prefix)
    return sealed(Outline(outer, tuple(holes)), _lines(obj, prefix + "Weld"))


def _lines(obj, prefix: str) -> list:
    points = np.array([(vector.x, vector.y) for vector in getattr(obj, prefix + "Points")]).reshape(-1, 2)
    counts = getattr(obj, prefix + "Counts")
    return np.split(from_mm(points), np.cumsum(counts)[:-1]) if counts else []

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Between the engine's loops (arrays, m) and FreeCAD's wires, faces and point lists (mm)."""

from __future__ import annotations

import math

import FreeCAD as App
import numpy as np
import Part

from BalloonWorkbench.core.arcs.curves import Curve
from BalloonWorkbench.core.geometry.nearest import nearest_on_line
from BalloonWorkbench.core.geometry.polyline import ring
from BalloonWorkbench.core.outline.drawing import sealed
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.rounded import rounded_outline
from BalloonWorkbench.core.units import from_mm, to_mm

#: How far a spline may be from the arcs [m], how far it turns [rad], and how often it gets more points.
_CHORD = from_mm(0.001)
_QUARTER = 1.6
_TRIALS = 4


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
        if segment.bulge == 0.0:
            edges.append(Part.LineSegment(*vectors([segment.start, segment.end])).toShape())
            continue
        edges.append(Part.Arc(*vectors([segment.start, segment.middle, segment.end])).toShape())
    return Part.Wire(edges)


def spline_wire(curve: Curve):
    """A wire of straight edges and splines, which meet smoothly except in corners.

    A spline runs on for about a quarter of a turn: FreeCAD measures areas beside long ones badly.
    """
    if curve.closed and curve.corners.any():
        curve = curve.begun_at(int(np.flatnonzero(curve.corners)[0]))
    corners, straight = curve.corners, curve.bulges == 0.0
    edges, run, turned = [], [], 0.0
    for k in range(len(curve)):
        run.append(k)
        turned += abs(float(curve.turns[k]))
        after = (k + 1) % len(curve)
        ends = k + 1 == len(curve) or corners[after] or straight[k] or straight[after]
        if not ends and turned + abs(curve.turns[after]) <= _QUARTER:
            continue
        joints = np.concatenate([curve.starts[run], curve.ends[run[-1:]]])
        if straight[k]:
            edges.append(Part.LineSegment(*vectors(joints)).toShape())
        else:
            edges.append(_spline(Curve(joints, curve.bulges[run], False)).toShape())
        run, turned = [], 0.0
    return Part.Wire(edges)


def _spline(curve: Curve):
    """A spline through points of smooth arcs, with their directions at its ends; as many as keep it near."""
    first, last = curve.headings
    starts, ends = (App.Vector(math.cos(turn), math.sin(turn), 0.0) for turn in (first[0], last[-1]))
    line = curve.flattened(0.1 * _CHORD)
    spline, chord = Part.BSplineCurve(), _CHORD
    for _ in range(_TRIALS):
        points = curve.flattened(chord)
        spline.interpolate(Points=vectors(points), InitialTangent=starts, FinalTangent=ends)
        drawn = [(at.x, at.y) for at in spline.discretize(4 * len(points))]
        if nearest_on_line(line, from_mm(np.array(drawn))).distance.max() < _CHORD:
            break
        chord *= 0.25
    return spline


def face(outline: Outline):
    """The flat face between the outer loop and the holes, its wires in the order of the loops; then welds."""
    sheet = Part.Face([wire(loop) for loop in (outline.outer, *outline.holes)])
    welds = [wire(weld, False) for weld in outline.welds] + [wire(spot) for spot in outline.spots]
    return Part.Compound([sheet, *welds]) if welds else sheet


def store(obj, prefix: str, outline: Outline) -> None:
    """Keep the lines exactly: <prefix>Points and <prefix>Counts have the outer loop and the holes,
    <prefix>WeldPoints and -Counts the welds, spots with their first point repeated at the end.

    Shapes lose the last digits in files.
    """
    spots = [ring(spot) for spot in outline.spots]
    for name, lines in (("", (outline.outer, *outline.holes)), ("Weld", (*outline.welds, *spots))):
        setattr(obj, f"{prefix}{name}Points", [vector for line in lines for vector in vectors(line)])
        setattr(obj, f"{prefix}{name}Counts", [len(line) for line in lines])


def stored(obj, prefix: str) -> Outline:
    """The outline kept by `store`, on the grid of the engine."""
    outer, *holes = _lines(obj, prefix)
    return rounded_outline(sealed(Outline(outer, tuple(holes)), _lines(obj, prefix + "Weld")))


def _lines(obj, prefix: str) -> list:
    points = np.array([(vector.x, vector.y) for vector in getattr(obj, prefix + "Points")]).reshape(-1, 2)
    counts = getattr(obj, prefix + "Counts")
    return np.split(from_mm(points), np.cumsum(counts)[:-1]) if counts else []

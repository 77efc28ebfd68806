# SPDX-License-Identifier: LGPL-2.1-or-later
"""Between the engine's loops (arrays, m) and FreeCAD's wires, faces and point lists (mm)."""

from __future__ import annotations

import FreeCAD as App
import numpy as np
import Part

from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.units import from_mm, to_mm


def vectors(points) -> list:
    """Points (n, 2) in m as vectors in mm."""
    return [App.Vector(x, y, 0.0) for x, y in to_mm(np.asarray(points, dtype=float)).tolist()]


def wire(points, closed: bool = True):
    """A wire of straight edges through points (n, 2) in m."""
    corners = vectors(points)
    return Part.makePolygon(corners + corners[:1] if closed else corners)


def face(outline: Outline):
    """The flat face between the outer loop and the holes, its wires in the order of the loops."""
    return Part.Face([wire(loop) for loop in outline.loops])


def store(obj, prefix: str, outline: Outline) -> None:
    """Keep the loops exactly, in <prefix>Points and <prefix>Counts; shapes lose the last digits in files."""
    setattr(obj, prefix + "Points", [vector for loop in outline.loops for vector in vectors(loop)])
    setattr(obj, prefix + "Counts", [len(loop) for loop in outline.loops])


def stored(obj, prefix: str) -> Outline:
    """The outline kept by `store`."""
    points = np.array([(vector.x, vector.y) for vector in getattr(obj, prefix + "Points")])
    ends = np.cumsum(getattr(obj, prefix + "Counts"))
    outer, *holes = np.split(from_mm(points), ends[:-1])
    return Outline(outer, tuple(holes))

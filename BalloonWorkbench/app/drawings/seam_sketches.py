# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sketches that are projected onto a body as its seams, along the normal of their plane."""

from __future__ import annotations

import FreeCAD as App
import numpy as np
import Part

from BalloonWorkbench.app.drawings.sketch import frame_of, joined, polyline, shape_of
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.seam_edits.edit import BOTH, LINE, NEAR, SeamEdit
from BalloonWorkbench.core.units import from_mm

_DEFLECTION = 1e-3  # of a polyline from its curve, relative to the size of the sketch


def sketch_edits(target) -> list[SeamEdit]:
    """The lines of a target's sketches in the body's own frame, an edit for each line that hangs together.

    InputError, or OutlineError, for a sketch without a line, or one that is not flat.
    """
    to_body = _to_body(target)
    side = NEAR if target.NearSide else BOTH
    edits = []
    for source in target.SeamSketches:
        shape = shape_of(source, ())
        size = shape.BoundBox.DiagonalLength if shape.Edges else 0.0
        if not size > 0.0:
            raise InputError(f"{source.Label} is empty: draw a line in it.")
        groups = [
            joined([polyline(edge, size, _DEFLECTION) for edge in group])
            for group in Part.sortEdges(shape.Edges)
        ]
        frame = frame_of(shape, np.concatenate(groups), size, source.Label)
        place = to_body * source.getGlobalPlacement()
        normal = (place.Rotation * frame.Rotation).multVec(App.Vector(0, 0, 1))
        turn = np.array(place.Matrix.A).reshape(4, 4)
        for line in groups:
            points = from_mm(line @ turn[:3, :3].T + turn[:3, 3])
            edits.append(SeamEdit(LINE, points, np.array(tuple(normal)), side=side, source=source.Label))
    return edits


def _to_body(target) -> App.Placement:
    """From the document to the body's own frame: that of the object that sketches are drawn on."""
    if not target.Solid:
        return target.Placement.inverse()
    mesh = getattr(target.Solid, "Mesh", None)
    box = mesh.BoundBox if mesh is not None else Part.getShape(target.Solid).optimalBoundingBox(False)
    return App.Placement(-box.Center, App.Rotation())

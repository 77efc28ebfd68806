# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a sketch, wire or face to a drawing: curves become polylines in the plane they lie in."""

from __future__ import annotations

import FreeCAD as App
import numpy as np

from BalloonWorkbench.core.errors import OutlineError
from BalloonWorkbench.core.outline.budget import Budget
from BalloonWorkbench.core.outline.drawing import Drawing, checked
from BalloonWorkbench.core.readers.chains import drawing_from
from BalloonWorkbench.core.units import from_mm

_DEFLECTION = 2e-5  # of a polyline from its curve, relative to the size of the shape: 6 um on 300 mm
_FLAT = 1e-5  # height over a plane that counts as none, relative to the size of the shape
_NO_SIZE = 1e-4  # mm


def drawing_of(source, elements: tuple[str, ...] = ()) -> tuple[Drawing, App.Placement]:
    """The closed lines of a source in their plane, and where that plane lies.

    source    a document object with a shape: a sketch, a Draft or Part wire, a face
    elements  names of parts of it, such as ("Face6",); none means the whole

    Raises OutlineError when the shape is empty, not flat, open, or crosses itself.
    """
    shape = shape_of(source, elements)
    size = shape.BoundBox.DiagonalLength if shape.Edges else 0.0
    if size <= _NO_SIZE:
        raise OutlineError(f"{source.Label} is empty: draw a closed line in it.")
    if len(shape.Faces) > 1:
        raise OutlineError(f"{source.Label} has several faces: select one of them.")
    budget = Budget()
    lines = []
    for edge in shape.Edges:
        lines.append(polyline(edge, size))
        budget.spend_points(len(lines[-1]))
    frame = frame_of(shape, np.concatenate(lines), size, source.Label)
    back = np.array(frame.inverse().Matrix.A).reshape(4, 4)
    flat = [from_mm(line @ back[:2, :3].T + back[:2, 3]) for line in lines]
    drawing = checked(drawing_from(flat, open_are_welds=True, budget=budget), budget)
    return drawing, source.getGlobalPlacement() * frame


def shape_of(source, elements: tuple[str, ...]):
    """The shape in the source's own coordinates."""
    import Part

    if getattr(source, "Shape", None) is None or source.Shape.isNull():
        raise OutlineError(f"{source.Label} has no shape: select a sketch, a wire or a face.")
    parts = [source.Shape.getElement(name) for name in elements if name]
    shape = Part.Compound(parts) if len(parts) > 1 else (parts[0] if parts else source.Shape).copy()
    shape.Placement = source.Placement.inverse() * shape.Placement
    return shape


def polyline(edge, size: float, deflection: float = _DEFLECTION) -> np.ndarray:
    """Points (n, 3) along an edge; deflection: from it, relative to the size."""
    return np.array([tuple(point) for point in edge.discretize(Deflection=deflection * size)])


def joined(lines: list[np.ndarray]) -> np.ndarray:
    """Lines (n, d) that follow each other as one, each turned so that it begins where the last one ends."""
    lines = list(lines)
    if len(lines) > 1 and _gap(lines[0][-1], lines[1]) > _gap(lines[0][0], lines[1]):
        lines[0] = lines[0][::-1]
    for k in range(1, len(lines)):
        here = lines[k - 1][-1]
        if np.linalg.norm(lines[k][0] - here) > np.linalg.norm(lines[k][-1] - here):
            lines[k] = lines[k][::-1]
    return np.concatenate([lines[0], *(line[1:] for line in lines[1:])])


def _gap(point: np.ndarray, line: np.ndarray) -> float:
    """How far a point is from the nearer end of a line."""
    return float(min(np.linalg.norm(line[end] - point) for end in (0, -1)))


def frame_of(shape, points: np.ndarray, size: float, label: str) -> App.Placement:
    """The plane of the points: parallel to xy where they allow it, else turned the shortest way."""
    if np.ptp(points[:, 2]) <= _FLAT * size:
        facing_down = len(shape.Faces) == 1 and shape.Faces[0].normalAt(0, 0).z < 0
        turn = App.Rotation(App.Vector(1, 0, 0), 180) if facing_down else App.Rotation()
        return App.Placement(App.Vector(0, 0, points[:, 2].mean()), turn)
    plane = shape.findPlane()
    if plane is None:
        raise OutlineError(f"{label} is not flat: a balloon is cut from flat film, so draw it in one plane.")
    normal = shape.Faces[0].normalAt(0, 0) if shape.Faces else plane.Axis
    return App.Placement(plane.Position, App.Rotation(App.Vector(0, 0, 1), normal))

# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a sketch, wire or face to closed loops: curves become polylines in the plane they lie in."""

from __future__ import annotations

import FreeCAD as App
import numpy as np

from BalloonWorkbench.core.errors import OutlineError

_DEFLECTION = 2e-5  # of a polyline from its curve, relative to the size of the shape: 6 um on 300 mm
_GAP = 1e-5  # distance between ends that counts as touching, relative to the size of the shape
_LEAST_GAP = 1e-4  # mm


def loops_of(source, elements: tuple[str, ...] = ()) -> tuple[list[np.ndarray], App.Placement]:
    """Closed loops (n, 2) in mm in the plane of the source, and where that plane lies.

    source    a document object with a shape: a sketch, a Draft or Part wire, a face
    elements  names of parts of it, such as ("Face6",); none means the whole

    Raises OutlineError when the shape is empty, not flat, open or branching.
    """
    shape = _shape(source, elements)
    if not shape.Edges:
        raise OutlineError(f"{source.Label} is empty: draw a closed line in it.")
    if len(shape.Faces) > 1:
        raise OutlineError(f"{source.Label} has several faces: select one of them.")
    size = shape.BoundBox.DiagonalLength
    if size <= _LEAST_GAP:
        raise OutlineError(f"{source.Label} has no extent: draw a closed line in it.")
    polylines = [_polyline(edge, size) for edge in shape.Edges]
    frame = _frame(shape, np.concatenate(polylines), size, source.Label)
    back = np.array(frame.inverse().Matrix.A).reshape(4, 4)
    flat = [line @ back[:2, :3].T + back[:2, 3] for line in polylines]
    return _chain(flat, max(_GAP * size, _LEAST_GAP), source.Label), source.getGlobalPlacement() * frame


def _shape(source, elements: tuple[str, ...]):
    """The shape in the source's own coordinates."""
    import Part

    if getattr(source, "Shape", None) is None or source.Shape.isNull():
        raise OutlineError(f"{source.Label} has no shape: select a sketch, a wire or a face.")
    parts = [source.Shape.getElement(name) for name in elements if name]
    shape = Part.makeCompound(parts) if len(parts) > 1 else (parts[0] if parts else source.Shape).copy()
    shape.Placement = source.Placement.inverse() * shape.Placement
    return shape


def _polyline(edge, size: float) -> np.ndarray:
    """Points (n, 3) along an edge."""
    return np.array([tuple(point) for point in edge.discretize(Deflection=_DEFLECTION * size)])


def _frame(shape, points: np.ndarray, size: float, label: str) -> App.Placement:
    """The plane of the points: parallel to xy where they allow it, else turned the shortest way."""
    if np.ptp(points[:, 2]) <= _GAP * size:
        facing_down = len(shape.Faces) == 1 and shape.Faces[0].normalAt(0, 0).z < 0
        turn = App.Rotation(App.Vector(1, 0, 0), 180) if facing_down else App.Rotation()
        return App.Placement(App.Vector(0, 0, points[:, 2].mean()), turn)
    plane = shape.findPlane()
    if plane is None:
        raise OutlineError(f"{label} is not flat: a balloon is cut from flat film, so draw it in one plane.")
    normal = shape.Faces[0].normalAt(0, 0) if shape.Faces else plane.Axis
    return App.Placement(plane.Position, App.Rotation(App.Vector(0, 0, 1), normal))


def _chain(lines: list[np.ndarray], gap: float, label: str) -> list[np.ndarray]:
    """Join polylines end to end into closed loops."""
    closed = [line for line in lines if len(line) > 2 and np.linalg.norm(line[0] - line[-1]) <= gap]
    open_lines = [line for line in lines if np.linalg.norm(line[0] - line[-1]) > gap]
    loops = [line[:-1] for line in closed]
    ends = _meeting_points(open_lines, gap, label)
    unused = set(range(len(open_lines)))
    while unused:
        index = min(unused)
        at_start, node = ends[index]
        first, pieces = at_start, []
        forward = True
        while True:
            unused.discard(index)
            pieces.append(open_lines[index][:-1] if forward else open_lines[index][:0:-1])
            if node == first:
                break
            index = next(i for i in unused if node in ends[i])
            forward = ends[index][0] == node
            node = ends[index][1] if forward else ends[index][0]
        loops.append(np.concatenate(pieces))
    return loops


def _meeting_points(lines: list[np.ndarray], gap: float, label: str) -> list[tuple[int, int]]:
    """Number the points where lines meet; exactly two must meet in each."""
    nodes: list[np.ndarray] = []
    counts: list[int] = []

    def node(point: np.ndarray) -> int:
        for number, place in enumerate(nodes):
            if np.linalg.norm(place - point) <= gap:
                counts[number] += 1
                return number
        nodes.append(point)
        counts.append(1)
        return len(nodes) - 1

    ends = [(node(line[0]), node(line[-1])) for line in lines]
    for place, count in zip(nodes, counts, strict=True):
        where = f"({place[0]:.4g}, {place[1]:.4g}) mm"
        if count == 1:
            raise OutlineError(
                f"{label} is open at {where}: close the line there, for example by a coincidence."
            )
        if count > 2:
            raise OutlineError(f"{count} lines of {label} meet at {where}: leave two of them.")
    return ends

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The triangles of a solid, face by face, and the pieces of curves that their edges stand for."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import Any, NamedTuple

import FreeCAD as App
import MeshPart
import numpy as np
import Part

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.nearest import kd_tree
from BalloonWorkbench.core.targets.half_edges import Indices, connected_parts, half_edges, twins
from BalloonWorkbench.core.types import Floats, Ints
from BalloonWorkbench.core.units import from_mm, to_mm

#: What differs by less, as a part of the body's diagonal, is the same.
_SAME = 1e-6
#: Where three places lie on a piece of a curve.
_QUARTERS = np.array([0.25, 0.5, 0.75])


@dataclass(frozen=True)
class SolidMesh:
    """A solid about its middle, and its triangles.

    body       the solid, moved so that its box lies about the origin
    points     (n, 3) m
    triangles  (m, 3) counter-clockwise seen from outside
    owners     (m,) number of the face of each triangle
    near       points so near to an edge [mm] lie on it: a mesh has single precision
    """

    body: Any
    points: Floats
    triangles: Ints
    owners: Ints
    near: float


def mesh_of(shape, label: str, near: float, turn: float) -> SolidMesh:
    """The triangles of a closed body.

    near, turn  how far they may be from a curved face, of the diagonal, and turned from each other [rad]

    Raises InputError where they cannot be told from each other, face by face.
    """
    body = shape.copy()
    body.translate(-shape.BoundBox.Center)
    diagonal = body.BoundBox.DiagonalLength
    mesh = MeshPart.meshFromShape(
        Shape=body, LinearDeflection=near * diagonal, AngularDeflection=turn, Relative=False, Segments=True
    )
    points, triangles = mesh.Topology
    owners = np.zeros(len(triangles), dtype=np.int32)
    for number in range(mesh.countSegments()):
        owners[list(mesh.getSegment(number))] = number
    places, corners = _welded(
        np.array([tuple(at) for at in points], dtype=float).reshape(-1, 3),
        np.array(triangles, dtype=np.int32).reshape(-1, 3),
        _SAME * diagonal,
    )
    sound = (corners != np.roll(corners, 1, axis=1)).all(axis=1)
    corners, owners = corners[sound], owners[sound]
    twin = twins(corners)
    if (
        (twin < 0).any()
        or (twin[twin] != np.arange(len(twin))).any()
        or mesh.countSegments() > len(body.Faces)
    ):
        raise InputError(
            f"The faces of {label} cannot be told from each other in a mesh."
            " Repair the solid, or give a mesh of it."
        )
    return SolidMesh(body, from_mm(places), corners, owners, _SAME * diagonal)


def _welded(places: Floats, triangles: Ints, near: float) -> tuple[Floats, Ints]:
    """Points (n, 3) that differ by their rounding alone made one: those left, and the triangles in them."""
    pairs = kd_tree(places).query_pairs(near, output_type="ndarray")
    parts = connected_parts(len(places), pairs[:, 0], pairs[:, 1])
    _, first, number = np.unique(parts, return_index=True, return_inverse=True)
    order = np.argsort(first)
    rank = np.empty_like(order)
    rank[order] = np.arange(len(order))
    return places[first[order]], rank[number.ravel()][triangles].astype(np.int32)


class EdgeLines(NamedTuple):
    """Where the edges of a solid lie in its mesh.

    points   (n, 3) m of the mesh, those on edges moved onto them
    cuts     (k, 2) points of edges at which a face that goes round the body meets itself
    bent     (h,) half-edges that stand for pieces of curves
    between  (h, 3, 3) m places at the quarters of these
    """

    points: Floats
    cuts: Ints
    bent: Indices
    between: Floats


def edge_lines(mesh: SolidMesh) -> EdgeLines:
    """Where the edges of the solid lie."""
    body, triangles, owners = mesh.body, mesh.triangles, mesh.owners
    places = to_mm(mesh.points)
    numbers = {tuple(ends): number for number, ends in enumerate(half_edges(triangles).tolist())}
    at_face = [np.unique(triangles[owners == number]) for number in range(len(body.Faces))]
    cuts, bent, between = [], [], []
    for edge, faces, is_own in edges_with_faces(body):
        vertices = at_face[faces[0]]
        for face in faces[1:]:
            vertices = np.intersect1d(vertices, at_face[face])
        line = _nodes(edge, places, vertices, mesh.near)
        for (start, one), (end, other) in pairwise(line):
            if (one, other) not in numbers:
                continue
            if is_own:
                cuts.append((one, other))
            if not isinstance(edge.Curve, Part.Line):
                middle = np.array([tuple(edge.valueAt(at)) for at in start + _QUARTERS * (end - start)])
                bent += [numbers[one, other], numbers[other, one]]
                between += [middle, middle[::-1]]
    order = np.argsort(bent, kind="stable")
    return EdgeLines(
        from_mm(places),
        np.array(sorted(set(cuts)), dtype=np.int32).reshape(-1, 2),
        np.array(bent, dtype=np.intp)[order],
        from_mm(np.array(between, dtype=float).reshape(-1, 3, 3)[order]),
    )


def edges_with_faces(body):
    """Each edge of a body with the numbers of its faces, and whether a face meets itself there."""
    known: dict[int, list[list]] = {}
    for number, face in enumerate(body.Faces):
        for edge in face.Edges:
            if edge.Degenerated:
                continue
            same = known.setdefault(edge.hashCode(), [])
            entry = next((each for each in same if each[0].isSame(edge)), None)
            if entry is None:
                entry = [edge, [], False]
                same.append(entry)
            entry[1].append(number)
            entry[2] = entry[2] or edge.isSeam(face)
    return [(edge, sorted(set(faces)), own) for same in known.values() for edge, faces, own in same]


def _nodes(edge, places: Floats, vertices: Ints, near: float) -> list[tuple[float, int]]:
    """The vertices on an edge with their parameters, in order, moved onto it; of a ring the first again."""
    first, last = edge.ParameterRange
    box = edge.BoundBox
    low = np.array([box.XMin, box.YMin, box.ZMin]) - near
    high = np.array([box.XMax, box.YMax, box.ZMax]) + near
    inside = ((places[vertices] >= low) & (places[vertices] <= high)).all(axis=1)
    closed, start = edge.isClosed(), edge.valueAt(first)
    turn = edge.Curve.period() if edge.Curve.isPeriodic() else 0.0
    line: list[tuple[float, int]] = []
    for vertex in vertices[inside].tolist():
        point = App.Vector(*places[vertex].tolist())
        at = edge.Curve.parameter(point)
        if turn:
            at -= turn * np.floor((at - 0.5 * (first + last - turn)) / turn)
        at = min(max(float(at), first), last)
        on_edge = edge.valueAt(at)
        if on_edge.distanceToPoint(point) >= near:
            continue
        places[vertex] = tuple(on_edge)
        if closed and point.distanceToPoint(start) < near:
            line += [(first, vertex), (last, vertex)]
        else:
            line.append((at, vertex))
    return sorted(line)

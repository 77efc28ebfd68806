# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids and meshes of a document, and solids in STEP files, as targets that are divided into panels."""

from __future__ import annotations

from itertools import pairwise

import MeshPart
import numpy as np
import Part

from BalloonWorkbench.core.bag_design.source import division_of_size
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.options.body import PANELS, TargetOptions
from BalloonWorkbench.core.segmentation.divide import divide
from BalloonWorkbench.core.segmentation.faces import divide_at_faces
from BalloonWorkbench.core.targets.mesh_files import RawMesh
from BalloonWorkbench.core.targets.read_target import target_of
from BalloonWorkbench.core.targets.target import Division, Target
from BalloonWorkbench.core.units import from_mm

#: Files with solids, by the ends of their names; meshes are read by the core.
SOLIDS = ("step", "stp", "brep", "brp", "iges", "igs")
#: Triangles stay so near to a curved face: of the diagonal, and turned from each other [rad].
_NEAR, _TURN = 1e-3, 0.1
#: The same of a body that is divided anew, whose triangles are then made small enough.
_NEAR_DIVIDED, _TURN_DIVIDED = 4e-3, 0.25
_SAME = 1e-6  # of an edge: points so near lie on it


def division_of(source, panels: int, width: float | None = None, height: float | None = None) -> Division:
    """The panels of a document object with a shape or a mesh, or of a file.

    source         a document object or a path
    panels         how many; 0: the faces of a solid, and as many as usual of a mesh
    width, height  m, of a mesh in a file

    Raises InputError for what is no closed body.
    """
    if isinstance(source, str):
        ending = source.rpartition(".")[2].lower()
        if ending not in SOLIDS:
            return division_of_size(source, TargetOptions(panels), width, height)
        return _of_shape(_read(source), "the file", panels)
    mesh = getattr(source, "Mesh", None)
    if mesh is not None:
        points, triangles = mesh.Topology
        raw = RawMesh(_array(points), np.array(triangles, dtype=np.int32).reshape(-1, 3), from_mm(1.0))
        return divide(target_of(raw, source.Label), panels or PANELS)
    return _of_shape(_global_shape(source), source.Label, panels)


def _global_shape(source):
    """The shape of an object as it is seen, also through links and inside bodies."""
    shape = Part.getShape(source)
    if shape.isNull():
        raise InputError(f"{source.Label} has no shape. Choose a solid or a mesh.")
    return shape


def _read(path: str):
    shape = Part.Shape()
    try:
        shape.read(path)
    except (OSError, Part.OCCError):
        raise InputError("The file has no solid that can be read. Save it once more as STEP.") from None
    return shape


def _of_shape(shape, label: str, panels: int) -> Division:
    """The panels of a closed body: its faces, or so many."""
    body = _closed(shape, label)
    faces = body.Faces
    mesh = MeshPart.meshFromShape(
        Shape=body,
        LinearDeflection=(_NEAR_DIVIDED if panels else _NEAR) * body.BoundBox.DiagonalLength,
        AngularDeflection=_TURN_DIVIDED if panels else _TURN,
        Relative=False,
        Segments=True,
    )
    if not mesh.isSolid() or mesh.countSegments() > len(faces):
        raise InputError(
            f"The faces of {label} cannot be told from each other in a mesh."
            " Repair the solid, or give a mesh of it."
        )
    points, triangles = mesh.Topology
    places = from_mm(_array(points))
    middle = 0.5 * (places.min(axis=0) + places.max(axis=0))
    corners = np.array(triangles, dtype=np.int32)
    owners = np.zeros(len(corners), dtype=np.int32)
    for number in range(mesh.countSegments()):
        owners[list(mesh.getSegment(number))] = number
    target = Target(places - middle, corners, label)
    if panels:
        return divide(target, panels)
    cuts = [
        _own_seams(face, np.unique(corners[owners == number]), points) for number, face in enumerate(faces)
    ]
    cut = np.concatenate([np.zeros((0, 2), dtype=np.int32), *cuts])
    names = [f"Face{number + 1}" for number in range(len(faces))]
    return divide_at_faces(target, owners, names, cut)


def _own_seams(face, vertices: np.ndarray, points) -> np.ndarray:
    """Edges (k, 2) of the mesh along the edges at which a face that goes round meets itself.

    vertices  of the face's triangles, among the points of the mesh
    """
    cuts = []
    for edge in face.Edges:
        if edge.Degenerated or not edge.isSeam(face):
            continue
        first, last = edge.ParameterRange
        near = _SAME * edge.Length
        on_edge = []
        for vertex in vertices.tolist():
            at = min(max(edge.Curve.parameter(points[vertex]), first), last)
            if edge.valueAt(at).distanceToPoint(points[vertex]) < near:
                on_edge.append((at, vertex))
        line = [vertex for _, vertex in sorted(on_edge)]
        line += line[:1] if edge.isClosed() else []
        cuts += pairwise(line)
    return np.array(sorted(set(cuts)), dtype=np.int32).reshape(-1, 2)


def _closed(shape, label: str):
    """The one closed body of a shape. InputError where there is none, or more."""
    bodies = shape.Solids or [shell for shell in shape.Shells if shell.isClosed()]
    if not bodies:
        raise InputError(f"{label} is not closed: film can only be filled where it is. Choose a solid.")
    if len(bodies) > 1:
        raise InputError(f"{label} has {len(bodies)} bodies: choose one of them.")
    if len(bodies[0].Shells) > 1:
        raise InputError(f"{label} is hollow: choose a solid without a space inside.")
    return bodies[0]


def _array(points) -> np.ndarray:
    return np.array([(at.x, at.y, at.z) for at in points], dtype=float).reshape(-1, 3)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids and meshes of a document, and solids in STEP files, as targets that are divided into panels."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import Part

from BalloonWorkbench.app.drawings.face_strips import MOST_STRIPS, in_strips
from BalloonWorkbench.app.drawings.face_surfaces import developable_of
from BalloonWorkbench.app.drawings.solid_mesh import SolidMesh, edge_lines, mesh_of
from BalloonWorkbench.core.bag_design.source import of_size, target_of_size
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.flattening.developable import face_flats
from BalloonWorkbench.core.flattening.divide_flat import check_flat, divide_flat
from BalloonWorkbench.core.options.body import PANELS
from BalloonWorkbench.core.segmentation.discs import pieces_apart
from BalloonWorkbench.core.targets.form import SOLIDS
from BalloonWorkbench.core.targets.half_edges import twins
from BalloonWorkbench.core.targets.mesh_files import RawMesh
from BalloonWorkbench.core.targets.read_target import LARGEST, SMALLEST, read_target, target_of
from BalloonWorkbench.core.targets.target import Division, Target
from BalloonWorkbench.core.types import Ints
from BalloonWorkbench.core.units import from_mm, length_text

#: Triangles stay so near to a curved face: of the diagonal, and turned from each other [rad].
_NEAR, _TURN = 1e-3, 0.15
#: The same of a body that is divided anew, whose triangles are then made small enough.
_NEAR_DIVIDED, _TURN_DIVIDED = 4e-3, 0.25


def division_of(source, panels: int, width: float | None = None, height: float | None = None) -> Division:
    """The panels of a document object with a shape or a mesh, or of a file.

    source         a document object or a path
    panels         how many; 0: the faces of a solid, and as many as usual of a mesh
    width, height  m, of a body in a file

    Raises InputError for what is no closed body.
    """
    if not panels and _has_faces(source):
        made = _at_faces(*_shape_of(source))
        return of_size(made, width, height) if isinstance(source, str) else made
    return divide_flat(body_of(source, width, height), panels or PANELS)


def body_of(source, width: float | None = None, height: float | None = None) -> Target:
    """The same body as a whole, in the triangles that are divided where its faces are not asked for."""
    if _has_faces(source):
        shape, label = _shape_of(source)
        mesh = mesh_of(_closed(shape, label), label, _NEAR_DIVIDED, _TURN_DIVIDED)
        target = Target(mesh.points, mesh.triangles, label)
        return target_of_size(target, width, height) if isinstance(source, str) else target
    if isinstance(source, str):
        return read_target(source, width, height)
    points, triangles = source.Mesh.Topology
    raw = RawMesh(_array(points), np.array(triangles, dtype=np.int32).reshape(-1, 3), from_mm(1.0))
    return target_of(raw, source.Label)


def _has_faces(source) -> bool:
    """It is a solid, not a mesh."""
    if isinstance(source, str):
        return source.rpartition(".")[2].lower() in SOLIDS
    return getattr(source, "Mesh", None) is None


def _shape_of(source):
    """The shape of an object or a file, and what that is called."""
    return (_read(source), "the file") if isinstance(source, str) else (_global_shape(source), source.Label)


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


def _at_faces(shape, label: str) -> Division:
    """The panels of a closed body: its faces."""
    mesh, strips = in_strips(mesh_of(_closed(shape, label), label, _NEAR, _TURN), label)
    lines = edge_lines(mesh)
    panels_of, faces = _in_pieces(mesh, strips)
    names, notes = _names(faces)
    target = Target(lines.points, mesh.triangles, label, notes)
    division = Division(target, panels_of, names, lines.cuts)
    surfaces = [developable_of(mesh.body.Faces[number]) for number in faces]
    division = replace(division, flats=face_flats(division, surfaces, lines.bent, lines.between)).rounded()
    check_flat(division, "Give a number of panels, into which the body is divided.")
    return division


def _in_pieces(mesh: SolidMesh, strips: Ints) -> tuple[Ints, list[int]]:
    """The panel (m,) of each triangle, which hangs together, and the number of the face of each panel.

    strips  (m,) of the triangles in their faces
    """
    labels = mesh.owners * np.int32(MOST_STRIPS) + strips
    pieces = pieces_apart(labels, twins(mesh.triangles).reshape(-1, 3) // 3)
    _, first = np.unique(pieces, return_index=True)
    order = np.argsort(labels[first], kind="stable")
    rank = np.empty(len(order), dtype=np.int32)
    rank[order] = np.arange(len(order))
    return rank[pieces], (labels[first[order]] // MOST_STRIPS).tolist()


def _names(faces: list[int]) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Names of the panels with these numbers of faces, and what is told about faces in strips."""
    names, notes = [], []
    for at, number in enumerate(faces):
        count, name = faces.count(number), f"Face{number + 1}"
        names.append(name if count == 1 else f"{name}.{at - faces.index(number) + 1}")
        if names[-1] == f"{name}.1":
            notes.append(f"{name} is curved both ways: it is cut into {count} strips.")
    return tuple(names), tuple(notes)


def _closed(shape, label: str):
    """The one closed body of a shape. InputError where there is none, or more."""
    bodies = shape.Solids or [shell for shell in shape.Shells if shell.isClosed()]
    if not bodies:
        raise InputError(f"{label} is not closed: film can only be filled where it is. Choose a solid.")
    if len(bodies) > 1:
        raise InputError(f"{label} has {len(bodies)} bodies: choose one of them.")
    if len(bodies[0].Shells) > 1:
        raise InputError(f"{label} is hollow: choose a solid without a space inside.")
    box = bodies[0].BoundBox
    size = from_mm(max(box.XLength, box.YLength, box.ZLength))
    if not SMALLEST <= size <= LARGEST:
        raise InputError(
            f"{label} is {length_text(size)} long. Scale it, so that it is between {length_text(SMALLEST)}"
            f" and {length_text(LARGEST)}."
        )
    return bodies[0].cleaned()  # what the window has shown of it has no part in its mesh


def _array(points) -> np.ndarray:
    return np.array([(at.x, at.y, at.z) for at in points], dtype=float).reshape(-1, 3)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces that are curved both ways, cut along their own parameter lines into strips that can be laid flat.

A strip of width w on a surface of Gaussian curvature K is strained by about K w^2 / 8 as it is laid flat, and
film that is taut across it stays about sqrt(K) w^2 / 8 away from the surface.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import FreeCAD as App
import numpy as np

from BalloonWorkbench.app.drawings.face_surfaces import developable_of
from BalloonWorkbench.app.drawings.solid_mesh import SolidMesh, edges_with_faces
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.nearest import kd_tree
from BalloonWorkbench.core.geometry.polyline import length
from BalloonWorkbench.core.targets.refine import cut_where_zero
from BalloonWorkbench.core.types import Floats, Ints
from BalloonWorkbench.core.units import from_mm, to_mm

#: The largest strain of a strip, and the largest distance from the surface, of the body's diagonal.
STRAIN, AWAY = 0.14, 0.011
#: Parameter lines that are measured each way, and points on each.
_LINES, _POINTS = 5, 33
#: So many points of a face are asked for its curvature, and so much of it has less.
_SAMPLES, _MOST = 200, 0.9
#: More strips are surely no balloon.
MOST_STRIPS = 60


@dataclass(frozen=True)
class _Strips:
    """How a face is cut into so many strips: along lines of its first or second parameter (axis)."""

    axis: int
    count: int
    first: float
    step: float

    def lines(self) -> Floats:
        """The parameters at which strips meet."""
        return self.first + self.step * np.arange(1, self.count)


def in_strips(mesh: SolidMesh, label: str) -> tuple[SolidMesh, Ints]:
    """The mesh, cut where strips meet, and the number (m,) of the strip of each triangle in its face.

    Raises InputError for a face that is curved too much.
    """
    pieces = np.zeros(len(mesh.triangles), dtype=np.int32)
    for number, face in enumerate(mesh.body.Faces):
        if developable_of(face) is not None:
            continue
        known = _parameters(mesh, number)
        strips = _strips_of(face, known, mesh)
        if strips.count > MOST_STRIPS:
            raise InputError(
                f"Face{number + 1} of {label} is curved so much that it would take {strips.count} strips of"
                " film. Give a number of panels, or leave such details out of the solid."
            )
        for line in strips.lines().tolist():
            mesh, pieces, known = _cut(mesh, number, strips.axis, line, pieces, known)
        if strips.count > 1:
            pieces[mesh.owners == number] = _numbers(mesh, number, strips, known)
    return mesh, pieces


def _parameters(mesh: SolidMesh, number: int) -> Floats:
    """Both parameters (n, 2) on a face of the points on it; NaN of the others, and at poles."""
    face = mesh.body.Faces[number]
    known = np.full((len(mesh.points), 2), np.nan)
    nodes = np.array(face.getUVNodes()).reshape(-1, 2)
    places = np.array([tuple(face.Surface.value(*node)) for node in nodes.tolist()])
    vertices = np.unique(mesh.triangles[mesh.owners == number])
    own = to_mm(mesh.points[vertices])
    known[vertices] = nodes[kd_tree(places).query(own)[1]]
    for edge in face.Edges:
        if edge.Degenerated:
            away = np.linalg.norm(own - tuple(edge.Vertexes[0].Point), axis=1)
            known[vertices[away < mesh.near]] = np.nan
    return known


def _strips_of(face, known: Floats, mesh: SolidMesh) -> _Strips:
    """The fewest strips of a face that lie flat; from pole to pole where it has poles.

    known  parameters (n, 2) of the points on it
    """
    low, high, left, right = face.ParameterRange
    surface = face.Surface
    lines = np.linspace(low, high, _LINES), np.linspace(left, right, _LINES)
    across = np.linspace(low, high, _POINTS), np.linspace(left, right, _POINTS)
    along = (
        max(length(_places(surface, across[0], v)) for v in lines[1]),
        max(length(_places(surface, u, across[1])) for u in lines[0]),
    )
    curvature = _curvature(face, known[np.isfinite(known).all(axis=1)])
    limit = np.inf
    if curvature > 0.0:
        diagonal = mesh.body.BoundBox.DiagonalLength
        limit = min(np.sqrt(8.0 * STRAIN) / curvature, np.sqrt(8.0 * AWAY * diagonal / curvature))
    counts = [max(1, int(np.ceil(face.Area / max(each, 1e-9) / limit))) for each in along[::-1]]
    poles = any(edge.Degenerated for edge in face.Edges)
    axis = 0 if poles or counts[0] <= counts[1] else 1
    first, last = ((low, high), (left, right))[axis]
    return _Strips(axis, counts[axis], first, (last - first) / counts[axis])


def _places(surface, first: Floats | float, second: Floats | float) -> Floats:
    """Places (k, 3) mm along a parameter line."""
    both = np.broadcast_arrays(first, second)
    return np.array([tuple(surface.value(u, v)) for u, v in zip(*(each.tolist() for each in both))])


def _curvature(face, known: Floats) -> float:
    """The root of the Gaussian curvature of a face without its sign [1/mm]: most of the face has less.

    known  parameters (k, 2) of points all over it
    """
    every = max(1, len(known) // _SAMPLES)
    both = np.array([face.curvatureAt(*at) for at in known[::every].tolist()]).reshape(-1, 2)
    return float(np.sqrt(np.quantile(np.abs(both.prod(axis=1)), _MOST))) if len(both) else 0.0


def _turn(face, axis: int) -> float:
    """After how much a parameter comes round again."""
    surface = face.Surface
    low, high = face.ParameterRange[2 * axis : 2 * axis + 2]
    if surface.isUPeriodic() if axis == 0 else surface.isVPeriodic():
        return float(surface.UPeriod() if axis == 0 else surface.VPeriod())
    closed = surface.isUClosed() if axis == 0 else surface.isVClosed()
    return float(high - low) if closed else np.inf


def _cut(
    mesh: SolidMesh, number: int, axis: int, line: float, pieces: Ints, known: Floats
) -> tuple[SolidMesh, Ints, Floats]:
    """The mesh with edges along a parameter line of a face, and all that goes with its parts."""
    face = mesh.body.Faces[number]
    turn, other = (_turn(face, each) for each in (axis, 1 - axis))
    values = np.where(np.isnan(known[:, axis]), 0.0, known[:, axis] - line)
    if np.isfinite(turn):
        values -= turn * np.rint(values / turn)
    # what comes round is carried as a point of a circle, so that it is right between both of its ends, too
    phase = 2.0 * np.pi * known[:, 1 - axis] / other if np.isfinite(other) else 0.0 * known[:, 0]
    carried = np.column_stack([mesh.points, known[:, 1 - axis], np.cos(phase), np.sin(phase)])
    own = mesh.owners == number
    split = cut_where_zero(carried, mesh.triangles, values, own, turn)
    fresh = split.points[len(values) :]
    along = fresh[:, 3]
    if np.isfinite(other):
        along = np.arctan2(fresh[:, 5], fresh[:, 4]) * other / (2.0 * np.pi)
    new = np.empty((len(fresh), 2))
    new[:, axis], new[:, 1 - axis] = line, along
    mesh = replace(
        mesh, points=split.points[:, :3].copy(), triangles=split.triangles, owners=mesh.owners[split.origin]
    )
    _onto_surface(mesh, number, new)
    return mesh, pieces[split.origin], np.concatenate([known, new])


def _onto_surface(mesh: SolidMesh, number: int, new: Floats) -> None:
    """Move the last points onto their face, with parameters (k, 2), or onto the edge at which they lie."""
    surface, first = mesh.body.Faces[number].Surface, len(mesh.points) - len(new)
    for vertex, at in enumerate(new.tolist(), start=first):
        faces = np.unique(mesh.owners[(mesh.triangles == vertex).any(axis=1)]).tolist()
        there = surface.value(*at)
        if faces != [number]:
            here = App.Vector(*to_mm(mesh.points[vertex]).tolist())
            edges = [edge for edge, beside, _ in edges_with_faces(mesh.body) if beside == faces]
            places = [edge.valueAt(edge.Curve.parameter(here)) for edge in edges]
            there = min(places, key=here.distanceToPoint, default=there)
        mesh.points[vertex] = from_mm(np.array(tuple(there)))


def _numbers(mesh: SolidMesh, number: int, strips: _Strips, known: Floats) -> Ints:
    """The strip of each triangle of a face, by its corners that are no poles."""
    values = known[mesh.triangles[mesh.owners == number], strips.axis]
    turn = _turn(mesh.body.Faces[number], strips.axis)
    start = np.nanmin(values, axis=1, keepdims=True)
    if np.isfinite(turn):
        start = np.where(np.nanmax(values, axis=1, keepdims=True) - start > 0.5 * turn, turn + start, start)
        values = values + turn * (start - values > 0.5 * turn)
    away = np.nanmean(values, axis=1) - strips.first
    if np.isfinite(turn):
        away %= turn
    return np.clip(away / strips.step, 0, strips.count - 1).astype(np.int32)

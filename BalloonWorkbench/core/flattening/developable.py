# SPDX-License-Identifier: LGPL-2.1-or-later
"""Planes, cylinders, cones and other surfaces that unroll: where their points lie on the flat film, exactly.

A place on such a surface is known by how far round it lies and how far along its rulings. On a closed surface
the first is known up to whole turns, which follow from the triangles: none of them goes half way round.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.flattening.conformal import signed_areas_of
from BalloonWorkbench.core.flattening.factor import sparse
from BalloonWorkbench.core.geometry.vectors import unit
from BalloonWorkbench.core.targets.half_edges import Indices, ahead, half_edges
from BalloonWorkbench.core.targets.target import Division, FaceFlats
from BalloonWorkbench.core.types import Floats, Ints

PLANE, CYLINDER, CONE, EXTRUSION = "plane", "cylinder", "cone", "extrusion"
#: A point so near to the apex of a cone, as a part of the cone's extent, is the apex.
_APEX = 1e-9


@dataclass(frozen=True)
class Developable:
    """A surface that unrolls.

    kind     PLANE, CYLINDER, CONE, or EXTRUSION: a curve moved along the axis
    origin   (3,) m, a point of the plane or of the axis; the apex of a cone
    axis     (3,) of length 1: normal of a plane, direction of the rulings of a cylinder or an extrusion
    size     radius [m] of a cylinder, angle [rad] between a cone's axis and its rulings; of an extrusion the
             length [m] of its section if that is closed, or 0
    section  of an extrusion: how far along its section, square to the axis, places (k, 3) m lie: (k,) m
    """

    kind: str
    origin: Floats
    axis: Floats
    size: float = 0.0
    section: Callable[[Floats], Floats] | None = None

    @property
    def turn(self) -> float:
        """By how much `round` grows all round: m, of a cone rad; 0 where it does not come round."""
        whole = {
            CYLINDER: 2.0 * np.pi * self.size,
            CONE: 2.0 * np.pi * np.sin(self.size),
            EXTRUSION: self.size,
        }
        return float(whole.get(self.kind, 0.0))

    def round_and_along(self, points: Floats) -> tuple[Floats, Floats]:
        """How far round (k,), m, of a cone rad, up to whole turns, and how far along (k,) m points lie."""
        away = points - self.origin
        first, second = _square_to(self.axis)
        along = away @ self.axis
        if self.kind == EXTRUSION:
            assert self.section is not None
            return self.section(points), along
        if self.kind == PLANE:
            return away @ first, away @ second
        angles = np.arctan2(away @ second, away @ first)
        if self.kind == CYLINDER:
            return self.size * angles, along
        return np.sin(self.size) * angles, np.linalg.norm(away, axis=1)

    def flat(self, around: Floats, along: Floats) -> Floats:
        """The places (k, 2) m on the flat film."""
        if self.kind == CONE:
            return np.stack([along * np.cos(around), along * np.sin(around)], axis=-1)
        return np.stack([around, along], axis=-1)


def _square_to(axis: Floats) -> tuple[Floats, Floats]:
    """Two directions (3,), square to an axis and to each other."""
    first = unit(np.cross(axis, np.eye(3)[int(np.argmin(np.abs(axis)))]))
    return first, np.cross(axis, first)


def face_flats(
    division: Division, surfaces: Sequence[Developable | None], bent: Indices, between: Floats
) -> FaceFlats:
    """The panels of a division that lie each on a surface that unrolls, laid flat.

    surfaces  of each panel; None for one that does not unroll
    bent      (h,) half-edges that stand for pieces of curves
    between   (h, 3, 3) m three places on each of these
    """
    corners = np.full((*division.target.triangles.shape, 2), np.nan)
    curves = np.full((len(bent), 3, 2), np.nan)
    for number, surface in enumerate(surfaces):
        if surface is not None:
            own, piece = division.panels == number, division.panels[bent // 3] == number
            corners[own], curves[piece] = _unrolled(division, own, surface, bent[piece], between[piece])
    known = np.isfinite(curves).all(axis=(1, 2))
    return FaceFlats(corners, bent[known], curves[known])


def _unrolled(
    division: Division, own: Floats, surface: Developable, bent: Indices, between: Floats
) -> tuple[Floats, Floats]:
    """Corners of a panel's triangles, and places between the ends of its bent half-edges, laid flat."""
    opened = division.opened
    used, number = np.unique(opened.triangles[own], return_inverse=True)
    triangles = number.reshape(-1, 3).astype(np.int32)
    around, along = surface.round_and_along(division.target.points[opened.vertices[used]])
    if surface.turn:
        pole = (
            along < _APEX * np.abs(along).max() if surface.kind == CONE else np.zeros(len(along), dtype=bool)
        )
        around = _continued(around, surface.turn, triangles, np.flatnonzero(pole))
    flat = surface.flat(around, along)
    starts = np.searchsorted(used, opened.triangles.ravel()[np.stack([bent, ahead(bent)])])
    before = np.where(
        np.isin(starts[0], np.flatnonzero(pole)) if surface.turn else False, starts[1], starts[0]
    )
    curve, rise = surface.round_and_along(between.reshape(-1, 3))
    curve = curve.reshape(-1, 3)
    if surface.turn:
        curve = around[before][:, None] + _nearest_turn(curve - around[before][:, None], surface.turn)
    curves = surface.flat(curve, rise.reshape(-1, 3))
    if signed_areas_of(flat[:, 0] + 1j * flat[:, 1], triangles).sum() < 0.0:
        flat, curves = flat * (1.0, -1.0), curves * (1.0, -1.0)
    return flat[triangles], curves


def _continued(around: Floats, turn: float, triangles: Ints, poles: Indices) -> Floats:
    """Values (k,) that are known up to whole turns, the same all over triangles that hang together."""
    package, count = sparse(), len(around)
    from scipy.sparse import csgraph

    edges = half_edges(triangles)
    edges = edges[~np.isin(edges, poles).any(axis=1)]
    ends = np.concatenate([edges, edges[:, ::-1]])
    graph = package.csr_matrix((np.ones(len(ends)), (ends[:, 0], ends[:, 1])), shape=(count, count))
    first = int(np.setdiff1d(np.arange(count), poles)[0])
    order, before = csgraph.breadth_first_order(graph, first)
    values = around.copy()
    for vertex in order[1:].tolist():
        start = values[before[vertex]]
        values[vertex] = start + _nearest_turn(around[vertex] - start, turn)
    return values


def _nearest_turn(difference: Floats, turn: float) -> Floats:
    """Differences without whole turns."""
    return np.asarray(difference - turn * np.rint(difference / turn))
